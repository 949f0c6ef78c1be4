"""
The mission in standard messages: odometry, inertial unit and frames, for RViz and Foxglove.

    /chaser/odometry, /chaser/odometry/estimate     nav_msgs/Odometry, true and believed
    /chaser/imu                                     sensor_msgs/Imu
    /tf, /tf_static                                 tf2_msgs/TFMessage; the latter once, latched

Frames   the run's frame (target_lvlh) -> target_base; -> chaser_base -> chaser_camera ->
         chaser_camera_optical; -> chaser_base_estimate. Body axes are those of the mission: x
         forward, y to the right, z down; the optical frame is that of REP 103: z forward, x to
         the right, y down. The camera's are still.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.block import Block, now, WATCH
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.diagram.time_grid import whole_steps
from rvd_dynamics.geometry.pinhole import CameraParams
from rvd_dynamics.motion import attitude
from rvd_missions.docking import HERE
from rvd_missions.docking.settings import OrbitParams
from rvd_missions.docking.signals import ESTIMATE, INERTIAL, TRUTH

CODECS = 'rvd_dynamics.diagram.ros.standard_codecs'
NAME = 'standard_messages'
OPTICAL = np.array([0.5, 0.5, 0.5, 0.5])        # z of the optical frame is x of the body, x is y

_motion = (Part('position', (3,), 'm'), Part('attitude', (4,)), Part('linear', (3,), 'm/s'),
           Part('angular', (3,), 'rad/s'))
ODOMETRY = Signal('/chaser/odometry', _motion, 'nav_msgs/msg/Odometry', f'{CODECS}:Odometry')
BELIEVED = Signal('/chaser/odometry/estimate', _motion, 'nav_msgs/msg/Odometry',
                  f'{CODECS}:EstimatedOdometry')
IMU = Signal('/chaser/imu', (Part('rate', (3,), 'rad/s'), Part('force', (3,), 'm/s^2')),
             'sensor_msgs/msg/Imu', f'{CODECS}:Imu')
MOVING, STILL = 3, 2                            # frames
TF = Signal('/tf', (Part('place', (MOVING, 3), 'm'), Part('turn', (MOVING, 4))),
            'tf2_msgs/msg/TFMessage', f'{CODECS}:Transforms')
TF_STATIC = Signal('/tf_static', (Part('place', (STILL, 3), 'm'), Part('turn', (STILL, 4))),
                   'tf2_msgs/msg/TFMessage', f'{CODECS}:StillTransforms', still=True)


@settings
class StandardParams:
    """Standard messages beside ours."""

    active: bool = param(False, 'Whether they are published.')
    period_s: float = param(0.1, 'Time between two of each [s].', above=0.0, high=10.0)


def frames(run: Run) -> tuple[tuple[str, str], ...]:
    """Return parent and child of each transform of /tf."""
    return ((run.frame_id, 'target_base'), (run.frame_id, 'chaser_base'),
            (run.frame_id, 'chaser_base_estimate'))


def still_frames() -> tuple[tuple[str, str], ...]:
    """Return parent and child of each transform of /tf_static."""
    return (('chaser_base', 'chaser_camera'), ('chaser_camera', 'chaser_camera_optical'))


def blocks(scenario: Scenario) -> tuple[Block, ...]:
    """Return the block that publishes them, if it is to."""
    section = scenario.settings(NAME)
    if not section.active:
        return ()
    period = whole_steps(f'{NAME}: period_s', section.period_s, scenario.run.step_s)
    return (Block(NAME, f'{HERE}.standard:Standard', WATCH, package='rvd_missions', period=period,
                  reads={'truth': now(TRUTH), 'estimate': now(ESTIMATE), 'inertial': now(INERTIAL)},
                  writes={'odometry': ODOMETRY, 'believed': BELIEVED, 'imu': IMU, 'tf': TF,
                          'tf_static': TF_STATIC},
                  settings=scenario.mission.sections[NAME]),)


class Standard:
    """Says the same in standard messages."""

    def __init__(self, orbit: OrbitParams, camera: CameraParams, batch: tuple) -> None:
        self._n = orbit.mean_motion
        self._still = still(camera, batch)

    def step(self, k: int, truth: Any, estimate: Any, inertial: Any) -> dict[str, Any]:
        """Return the messages of step k."""
        return {'odometry': ODOMETRY(**motion(truth, self._n)),
                'believed': BELIEVED(**motion(estimate, self._n)),
                'imu': IMU(rate=inertial.rate, force=inertial.force),
                'tf': moving(truth, estimate), 'tf_static': self._still}


def motion(of: Any, n: float) -> dict[str, NDArray]:
    """
    Return pose and twist of an odometry: the twist in body axes, relative to the turning frame.

    `of` has position, velocity, attitude and inertial rate; `n` is the orbital rate [rad/s].
    """
    return {'position': of.position, 'attitude': of.attitude,
            'linear': attitude.rotate_back(of.attitude, of.velocity),
            'angular': of.rate + n*attitude.matrix(of.attitude)[..., 1, :]}


def moving(truth: Any, estimate: Any) -> Any:
    """Return place and rotation of each of `frames` in its parent, as a value of TF."""
    return TF(place=np.stack(np.broadcast_arrays(np.zeros(3), truth.position, estimate.position),
                             axis=-2),
              turn=np.stack(np.broadcast_arrays(truth.target_attitude, truth.attitude,
                                                estimate.attitude), axis=-2))


def still(camera: CameraParams, batch: tuple) -> Any:
    """Return place and rotation of each of `still_frames`, as a value of TF_STATIC."""
    place = np.array([camera.place_m, np.zeros(3)], dtype=float)
    turn = np.array([[0.0, 0.0, 0.0, 1.0], OPTICAL])
    return TF_STATIC(place=np.broadcast_to(place, (*batch, STILL, 3)),
                     turn=np.broadcast_to(turn, (*batch, STILL, 4)))
