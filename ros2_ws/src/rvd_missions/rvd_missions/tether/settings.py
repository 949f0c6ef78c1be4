"""
Settings that belong to no single block: orbit, gripper, tether, and what an approach is.

Frame   I: axes fixed at the start, along the target orbital frame of that instant: +x from the
        platform to the target, along the transverse, +y to nadir, +z along the orbit normal.
Marks   [S] stated by the paper, [A] assumed in its place: Table 1 of the paper is lost.
"""

from math import pi

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.constants import RADIUS_EARTH
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import LegParams as Delays
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.motion.kepler import EllipseParams

GEO_M = 42_164e3                        # [m] orbit radius [A]
LONGEST_STEP_S = 0.5


@settings
class LegParams(Delays):
    """Delays of the two legs of the link."""

    forward_delay_s: float = param(
        0.0, 'Constant delay of the forward link [s].', low=0.0, high=3600.0)
    back_delay_s: float = param(
        0.0, 'Constant delay of the back link [s].', low=0.0, high=3600.0)


def legs(leg_params: LegParams, run: Run) -> Legs:
    """Return the delays of the link in steps, as a part of the mission."""
    return leg_params.on(run)


@settings
class OrbitParams(EllipseParams):
    """Orbit of the target; geostationary unless said otherwise."""

    eccentricity: float = param(0.0, 'Eccentricity of the target orbit.')
    perigee_altitude_m: float = param(
        GEO_M - RADIUS_EARTH, 'Altitude of the perigee above the body radius [m].')


@settings
class GripperParams:
    """The gripper and its actuators [S]."""

    mass_kg: float = param(36.0, 'Mass [kg].', above=0.0)
    inertia_kg_m2: tuple = param(
        (0.6, 2.1, 2.2), 'Principal moments of inertia about body x, y, z [kg m^2].', length=3,
        above=0.0)
    attachment_m: float = param(
        0.25, 'Distance of the tether\'s attachment behind the centre of mass, on the boresight '
        '[m].', low=0.0)
    max_force_n: float = param(
        2.0, 'Greatest thruster force along each axis of the tether frame [N].', above=0.0)
    max_torque_n_m: float = param(
        0.1, 'Greatest control torque about each body axis [N m].', above=0.0)

    def __post_init__(self) -> None:
        a, b, c = sorted(self.inertia_kg_m2)
        require(a + b >= c, 'inertia_kg_m2', 'be moments of a body, none above the sum of the '
                'other two', list(self.inertia_kg_m2))


@settings
class TetherParams:
    """The tether and the tension that its reel may hold."""

    least_n: float = param(
        0.02, 'Least tension that is commanded, above zero so that the tether stays taut [N].')
    most_n: float = param(10.0, 'Greatest tension that is commanded [N].', above=0.0)
    abort_n: float = param(
        2.25, 'Tension of an ABORT, which brakes a release of 1 m/s in 16 s [N].', above=0.0)
    modulus_pa: float = param(130e9, 'Modulus of elasticity [Pa].', above=0.0)
    radius_m: float = param(0.5e-3, 'Radius of the tether [m].', above=0.0)

    def __post_init__(self) -> None:
        require(self.least_n > 0.0, 'least_n', 'be above 0: the tether could go slack',
                self.least_n)
        require(self.least_n < self.most_n, 'least_n', f'be below most_n, {self.most_n:g}',
                self.least_n)
        require(self.least_n <= self.abort_n <= self.most_n, 'abort_n', 'be between least_n and '
                f'most_n, {self.least_n:g} and {self.most_n:g}', self.abort_n)

    @property
    def stiffness_n(self) -> float:
        """Force per unit of strain EA [N]."""
        return self.modulus_pa*pi*self.radius_m*self.radius_m


@settings
class ApproachParams:
    """From where to where, and in which time; start IC-B of the specification [A]."""

    baseline_m: float = param(
        101.0, 'Distance from the platform to the target at the start [m].', above=0.0)
    released_m: float = param(1.0, 'Length of tether that is out at the start [m].', above=0.0)
    speed_m_s: float = param(1.0, 'Speed of the release, along x [m/s].', low=0.0, high=10.0)
    lateral_m_s: tuple = param(
        (0.08, -0.08), 'Speed of the release along y and z, without the part that the turning of '
        'the baseline asks for [m/s].', length=2)
    attitude_rad: tuple = param(
        (0.05, 0.05, -0.05), 'Roll, pitch and yaw of the gripper at the start [rad].', length=3,
        low=-1.0, high=1.0)
    rate_rad_s: tuple = param(
        (0.002, -0.006, 0.006), 'Angular rate of the gripper at the start, body axes [rad/s].',
        length=3, low=-1.0, high=1.0)
    final_range_m: float = param(
        20.0, 'Distance to the target at which the approach ends, at rest [m].', above=0.0)
    duration_s: tuple = param(
        (100.0, 100.0), 'Least and greatest duration; equal: it is fixed [s].', length=2, above=0.0)
    view_rad: float = param(
        0.4, 'Greatest angle zeta between boresight and line of sight at which the camera sees the '
        'target [rad].', above=0.0, below=1.5)
    margin: float = param(
        0.25, 'Part of it that each of alpha0, beta0, pitch and yaw may have in the plan.',
        above=0.0, high=1.0)

    def __post_init__(self) -> None:
        require(self.duration_s[0] <= self.duration_s[1], 'duration_s', 'not fall',
                list(self.duration_s))
        require(self.baseline_m > self.released_m + self.final_range_m, 'baseline_m',
                f'be above released_m and final_range_m together, '
                f'{self.released_m + self.final_range_m:g}: the tether would be shorter than the '
                'geometry', self.baseline_m)

    @property
    def angle_limit(self) -> float:
        """Bound of alpha0, beta0, pitch and yaw in the plan [rad]."""
        return self.margin*self.view_rad

    def initial(self, rate: float) -> NDArray[np.float64]:
        """
        Return the planned start (12,): position, velocity, Euler angles, angular rate.

        `rate` is that of the baseline, nu' at the start [rad/s].
        """
        y, z = self.lateral_m_s
        return np.array([self.released_m, 0.0, 0.0,
                         self.speed_m_s, y + rate*self.released_m, z,
                         *self.attitude_rad, *self.rate_rad_s])


@settings
class ArrivalParams:
    """What counts as arrived, and when a gripper is lost."""

    range_tolerance_m: float = param(
        0.1, 'Greatest error of the final distance to the target [m].', above=0.0)
    cross_tolerance_m: float = param(
        0.05, 'Greatest offset from the planned place across the line of sight [m].', above=0.0)
    attitude_tolerance_rad: float = param(
        0.02, 'Greatest error of roll, pitch and yaw at the end [rad].', above=0.0)
    collision_m: float = param(
        1.0, 'Distance to the target within which the gripper collides with it [m].', above=0.0)
    lost_factor: float = param(
        2.0, 'Multiple of the baseline at which the gripper counts as lost.', above=1.0)


def checked(run: Run, approach: ApproachParams) -> None:
    """Refuse a start at which the camera does not see the target, and too coarse a step."""
    _, pitch, yaw = approach.attitude_rad
    off = float(np.arccos(np.cos(pitch)*np.cos(yaw)))
    require(off <= approach.view_rad, 'approach.attitude_rad', 'have the target in the field of '
            f'view at the start, {approach.view_rad:g} rad from the boresight', f'{off:.4g} rad')
    require(run.step_s <= LONGEST_STEP_S, 'step_s', f'be at most {LONGEST_STEP_S:g}: the gripper '
            'swings at up to 1.1 rad/s', run.step_s)
    require(run.timeout_s >= approach.duration_s[1], 'timeout_s', 'be at least the approach takes, '
            f'{approach.duration_s[1]:g} s', run.timeout_s)
