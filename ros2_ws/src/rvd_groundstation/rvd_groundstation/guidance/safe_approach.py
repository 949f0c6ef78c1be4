"""
The law `safe_apf` along a docking axis: its attraction and speed corridor.

Among keep-out spheres `keep_out.among` adds its repulsion by obstacles.

Frame   target orbital, docking plane at x = 0, the chaser comes from x < 0.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Source  Xu, Zhang, Chinese J. Theor. Appl. Mech. 52(6), as in `safe_apf`: a = (v_g + v_m - v) / T.
        As published the law stops at the target, with T one step. Ours: the aim point and the
        least closing speed (`aim`), and a response T of its own, without which the levels of the
        thrusters chatter.
Limits  the defaults are tuned for the lunar approach, not published: docs/laws.md. The law knows
        no corridor wall; that it stays inside follows from heading for the axis.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.speed_corridor import SpeedCorridor
from rvd_groundstation.guidance.aim import AimParams
from rvd_groundstation.guidance.safe_apf import ALWAYS_S, ObstacleField, TargetField

Array = NDArray[np.float64]


@settings
class ApproachAim(AimParams):
    """The point that `safe_apf` heads for, and the speed it keeps."""

    beyond_m: float = param(
        3.37, 'Distance beyond the docking plane of the point that the law heads for [m].', low=0.0,
        high=1000.0)


@settings
class ApproachCorridor(SpeedCorridor):
    """Limit of the speed over the distance to the point that the law heads for."""

    form: str = param(
        'linear', 'Limit that is kept: none, a linear one, or the parabola of constant braking.',
        choices=('none', 'linear', 'parabola'))
    contact_speed_m_s: float = param(
        0.245, 'Speed allowed at contact [m/s].', above=0.0, high=100.0)
    slope_per_s: float = param(
        1.5e-4, 'Speed per metre of distance in the linear form [1/s].', above=0.0, high=100.0)


@settings
class ApproachObstacles(ObstacleField):
    """Repulsion by keep-out spheres on the approach."""

    braking_m_s2: float = param(
        0.02, 'Deceleration of the braking distance, a_max [m/s^2].', above=0.0, high=1000.0)
    alarm: str = param(
        'distance', 'What puts the repulsion by an obstacle on: its distance, the collision '
        'probability, or nothing.', choices=('distance', 'probability', 'none'))


@settings
class SafeApproach(TargetField):
    """Potential field of the target with a corridor of the approach speed, past the plane."""

    run: Run = wiring()
    max_speed_m_s: float = param(
        0.25, 'Speed far from the target, v_max [m/s].', above=0.0, high=100.0)
    slowing_per_m: float = param(
        1.0, 'Rate b_g at which the speed dies away near the target [1/m].', above=0.0, high=10.0)
    speed_corridor: SpeedCorridor = param(ApproachCorridor, 'Corridor of the approach speed.')
    contact_m: float = param(
        0.0, 'Distance L from the aim point at which the law stops [m].', low=0.0, high=1000.0)
    response_s: float = param(
        0.666, 'Time T in which an error of velocity is removed, where 0 means one step [s].',
        low=0.0, high=1000.0)
    aim: AimParams = param(ApproachAim, 'Where the law heads.')
    obstacles: ObstacleField = param(ApproachObstacles, 'Repulsion by keep-out spheres.')

    @property
    def time_s(self) -> float:
        """T, the time in which an error of velocity is removed [s]."""
        return self.response_s or self.run.step_s

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None = None) -> Array:
        """Return the acceleration (..., 3) [m/s^2] wanted; see `Law.wanted`."""
        state = self.aim.seen(prediction)
        rate = 1.0 / self.time_s
        wish = self.approach(state, ALWAYS_S)
        result = np.empty((3, *state.shape[:-1]))
        for i in range(3):
            result[i] = (wish[i] - state[..., 3 + i]) * rate
        return result.transpose(*range(1, result.ndim), 0)

    def speed(self, r: Array, t_s: float) -> Array:
        """Return the speed (...) [m/s] at distances (...) [m]: never below the least one."""
        return np.maximum(super().speed(r, t_s), self.aim.least_closing_m_s)
