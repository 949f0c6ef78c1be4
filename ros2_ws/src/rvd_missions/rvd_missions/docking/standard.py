"""
The mission in standard messages: odometry, inertial unit and frames, for RViz and Foxglove.

    /chaser/odometry, /chaser/odometry/estimate     nav_msgs/Odometry, true and believed
    /chaser/imu                                     sensor_msgs/Imu
    /tf                                             tf2_msgs/TFMessage, where tf2_msgs is installed

Frames   the run's frame (target_lvlh) -> target_base; -> chaser_base -> chaser_camera ->
         chaser_camera_optical; -> chaser_base_estimate. Body axes are those of the mission: x
         forward, y to the right, z down; the optical frame is that of REP 103: z forward, x to
         the right, y down.

    ./rvd shell python -m rvd_missions.docking.standard RUN

writes RUN/transforms, a bag of /tf for a run that was flown where tf2_msgs is not installed.
"""

from importlib.util import find_spec
from pathlib import Path
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
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
FRAMES = 5
TF = Signal('/tf', (Part('place', (FRAMES, 3), 'm'), Part('turn', (FRAMES, 4))),
            'tf2_msgs/msg/TFMessage', f'{CODECS}:Transforms')


@settings
class StandardParams:
    """Standard messages beside ours."""

    active: bool = param(False, 'Whether they are published.')
    period_s: float = param(0.1, 'Time between two of each [s].', above=0.0, high=10.0)


def frames(run: Run) -> tuple[tuple[str, str], ...]:
    """Return parent and child of each transform."""
    return ((run.frame_id, 'target_base'), (run.frame_id, 'chaser_base'),
            (run.frame_id, 'chaser_base_estimate'), ('chaser_base', 'chaser_camera'),
            ('chaser_camera', 'chaser_camera_optical'))


def blocks(scenario: Scenario) -> tuple[Block, ...]:
    """Return the block that publishes them, if it is to."""
    section = scenario.settings(NAME)
    if not section.active:
        return ()
    period = whole_steps(f'{NAME}: period_s', section.period_s, scenario.run.step_s)
    tf = {'tf': TF} if find_spec('tf2_msgs') else {}
    return (Block(NAME, f'{HERE}.standard:Standard', WATCH, package='rvd_missions', period=period,
                  reads={'truth': now(TRUTH), 'estimate': now(ESTIMATE), 'inertial': now(INERTIAL)},
                  writes={'odometry': ODOMETRY, 'believed': BELIEVED, 'imu': IMU, **tf},
                  settings=scenario.mission.sections[NAME]),)


class Standard:
    """Says the same in standard messages."""

    def __init__(self, orbit: OrbitParams, camera: CameraParams, batch: tuple, block: Block
                 ) -> None:
        self._n, self._camera, self._batch = orbit.mean_motion, camera, batch
        self._tf = 'tf' in block.writes

    def step(self, k: int, truth: Any, estimate: Any, inertial: Any) -> dict[str, Any]:
        """Return the messages of step k."""
        made = {'odometry': ODOMETRY(**motion(truth, self._n)),
                'believed': BELIEVED(**motion(estimate, self._n)),
                'imu': IMU(rate=inertial.rate, force=inertial.force)}
        if self._tf:
            place, turn = transforms(truth, estimate, self._camera)
            made['tf'] = TF(place=np.broadcast_to(place, (*self._batch, FRAMES, 3)),
                            turn=np.broadcast_to(turn, (*self._batch, FRAMES, 4)))
        return made


def motion(of: Any, n: float) -> dict[str, NDArray]:
    """
    Return pose and twist of an odometry: the twist in body axes, relative to the turning frame.

    `of` has position, velocity, attitude and inertial rate; `n` is the orbital rate [rad/s].
    """
    return {'position': of.position, 'attitude': of.attitude,
            'linear': attitude.rotate_back(of.attitude, of.velocity),
            'angular': of.rate + n*attitude.matrix(of.attitude)[..., 1, :]}


def transforms(truth: Any, estimate: Any, camera: CameraParams) -> tuple[NDArray, NDArray]:
    """Return place (..., 5, 3) and rotation (..., 5, 4) of each of `frames` in its parent."""
    still, zero = np.array([0.0, 0.0, 0.0, 1.0]), np.zeros(3)
    shape = np.shape(truth.position)[:-1]

    def stacked(parts: tuple, size: int) -> NDArray:
        return np.stack([np.broadcast_to(part, (*shape, size)) for part in parts], axis=-2)
    return (stacked((zero, truth.position, estimate.position, np.array(camera.place_m), zero), 3),
            stacked((truth.target_attitude, truth.attitude, estimate.attitude, still, OPTICAL), 4))


# -- a bag of transforms --------------------------------------------------------------------------

def write(run: Path) -> Path:
    """
    Write the transforms of a recorded run beside its bag, every 0.1 s; return the new bag.

    Raises
    ------
    BadInput
        If the run has no bag of this mission, or there is one of transforms already.
    """
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import get_typestore, Stores

    from rvd_dynamics.recording.reader import read
    recorded = read(run)
    if recorded.scenario is None or recorded.scenario.mission.name != 'docking':
        raise BadInput(f'{run}: no recorded run of the mission docking')
    out = run/'transforms'
    if out.exists():
        raise BadInput(f'{out} is there already: remove it first')
    scenario, store = recorded.scenario, get_typestore(Stores.ROS2_JAZZY)
    truth, believed = recorded.of(TRUTH), recorded.of(ESTIMATE)
    names, camera = frames(scenario.run), scenario.part('camera')
    every = whole_steps(f'{NAME}: period_s', scenario.settings(NAME).period_s, scenario.run.step_s)
    kind = store.types['tf2_msgs/msg/TFMessage'].__msgtype__
    with Writer(out, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = writer.add_connection('/tf', kind, typestore=store)
        for i in range(0, min(len(truth.t), len(believed.t)), every):
            row = _Row(truth, i), _Row(believed, i)
            ns = int(truth.step[i])*scenario.run.step_ns
            message = _message(store, names, *transforms(*row, camera), ns)
            writer.write(connection, ns, store.serialize_cdr(message, kind))
    return out


class _Row:
    """Row i of a recorded series, by attribute."""

    def __init__(self, series: Any, i: int) -> None:
        self._series, self._i = series, i

    def __getattr__(self, name: str) -> NDArray:
        return np.asarray(self._series[name][self._i])


def _message(store: Any, names: tuple, places: NDArray, turns: NDArray, ns: int) -> Any:
    """Return a TFMessage without the frames that are not known yet."""
    t = store.types
    header = {'stamp': t['builtin_interfaces/msg/Time'](*divmod(ns, NS_PER_S))}
    return t['tf2_msgs/msg/TFMessage'](transforms=[
        t['geometry_msgs/msg/TransformStamped'](
            header=t['std_msgs/msg/Header'](**header, frame_id=parent), child_frame_id=child,
            transform=t['geometry_msgs/msg/Transform'](
                translation=t['geometry_msgs/msg/Vector3'](*map(float, place)),
                rotation=t['geometry_msgs/msg/Quaternion'](*map(float, turn))))
        for (parent, child), place, turn in zip(names, places, turns)
        if np.isfinite(place).all() and np.isfinite(turn).all()])


def main(arguments: list[str]) -> int:
    """Write the transforms of the run that is named; return the exit code."""
    try:
        if len(arguments) != 1:
            raise BadInput('usage: python -m rvd_missions.docking.standard RUN')
        print(write(Path(arguments[0])))
    except BadInput as error:
        print(f'standard: {error}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
