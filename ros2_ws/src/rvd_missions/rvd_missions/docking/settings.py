"""
Settings that belong to no single block: the craft, the start, the aim, and what counts as hovering.

All numbers are assumed, but for the orbit, 3 m, 7 cm +- 4 cm and 80 s: the paper prints no others.
"""

from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run as AnyRun
from rvd_dynamics.diagram.time_grid import whole_steps
from rvd_dynamics.motion.orbit import OrbitParams as Orbit
from rvd_missions.docking.markers import CHASER_PORT, TARGET_PORT

Array = NDArray[np.float64]
LATEST_S = 86400.0


@settings
class Run(AnyRun):
    """Time grid, random seed and pace of a run: steps of 10 ms."""

    step_s: float = param(0.01, 'Base step of the diagram [s].', low=0.001, high=10.0)
    timeout_s: float = param(
        300.0, 'Simulated time after which the run ends at the latest [s].', above=0.0,
        high=86400.0)


@settings
class OrbitParams(Orbit):
    """Circular orbit of the target, 210 km above the Moon."""

    radius_m: float = param(1947.4e3, 'Radius of the circular target orbit [m].', above=0.0)


@settings
class Chaser:
    """What the chaser really is."""

    mass_kg: float = param(2000.0, 'Mass of the whole craft [kg].', above=0.0, high=1e6)
    inertia_kg_m2: tuple = param(
        (2200.0, 3000.0, 2800.0), 'Moments of inertia of the whole craft [kg m^2].', low=-1e9,
        high=1e9, length=3)
    products_kg_m2: tuple = param(
        (0.0, 0.0, 0.0), 'Elements xy, xz and yz of the inertia tensor [kg m^2].', low=-1e9,
        high=1e9, length=3)
    centre_m: tuple = param(
        (0.0, 0.0, 0.0), 'Centre of mass in the drawing, where the craft takes it to be at the '
        'origin [m].', low=-1.0, high=1.0, length=3)
    target_inertia_kg_m2: tuple = param(
        (900.0, 1100.0, 1100.0), 'Moments of inertia of the target [kg m^2].', low=-1e9, high=1e9,
        length=3)
    thrust_scale: float = param(
        1.0, 'True thrust as a fraction of the nominal one.', above=0.0, high=10.0)

    @cached_property
    def inertia(self) -> Array:
        """Inertia tensor (3, 3) [kg m^2]."""
        xy, xz, yz = self.products_kg_m2
        return np.diag(self.inertia_kg_m2) + np.array([[0, xy, xz], [xy, 0, yz], [xz, yz, 0.0]])


@settings
class Panels:
    """Two panels along +y and -y."""

    flexible: bool = param(True, 'Whether they bend; else they are part of a rigid craft.')
    mass_kg: float = param(18.0, 'Mass of each [kg].', above=0.0, high=1e5)
    length_m: float = param(4.0, 'Length of each [m].', above=0.0, high=100.0)
    root_m: float = param(0.9, 'Distance of their roots from the axis of the craft [m].', low=0.0,
                          high=100.0)
    frequency_hz: float = param(
        0.25, 'First frequency when clamped [Hz].', above=0.0, high=5.0)
    damping: float = param(0.005, 'Damping ratio of each mode.', low=0.0, below=1.0)
    modes: int = param(5, 'Number of modes of each.', low=1, high=8)


@settings
class Tanks:
    """A tank of hydrogen and one of oxygen, on the axis of the craft."""

    sloshing: bool = param(True, 'Whether the liquids move; else they are part of a rigid craft.')
    mass_kg: tuple = param((60.0, 140.0), 'Liquid that moves in each [kg].', above=0.0, high=1e5,
                           length=2)
    place_m: tuple = param((-1.0, 0.3), 'Place of each along x [m].', low=-100.0, high=100.0,
                           length=2)
    frequency_rad_s: tuple = param(
        (0.25, 0.35), 'Angular frequency of each [rad/s].', above=0.0, high=100.0, length=2)
    damping: float = param(0.01, 'Damping ratio of each.', low=0.0, below=1.0)
    axes: int = param(1, 'Axes along which each swings: the hydrogen y, then z, the oxygen z, '
                      'then y.', low=1, high=2)


@settings
class Start:
    """Where a run begins."""

    position_m: tuple = param(
        (-6.0, 0.20, -0.15), 'Place of the chaser\'s centre from the target\'s, in LVLH axes [m].',
        low=-1e4, high=1e4, length=3)
    attitude_deg: tuple = param(
        (1.0, -1.5, 1.0), 'Roll, pitch and yaw from LVLH [deg].', low=-60.0, high=60.0, length=3)
    position_sigma_m: float = param(
        0.0, 'Standard deviation of each coordinate of the place [m].', low=0.0, high=100.0)
    attitude_sigma_deg: float = param(
        0.0, 'Standard deviation of each angle [deg].', low=0.0, high=60.0)
    rate_sigma_deg_s: float = param(
        0.0, 'Standard deviation of each relative rate [deg/s].', low=0.0, high=10.0)

    def __post_init__(self) -> None:
        require(self.position_m[0] < 0.0, 'position_m', 'begin with x < 0', self.position_m[0])


@settings
class Aim:
    """Where the chaser is to hover, and when it is to be there."""

    distance_m: float = param(0.07, 'Distance of the docking faces [m].', above=0.0, high=100.0)
    nominal_s: float = param(80.0, 'Nominal time of the approach [s].', above=0.0, high=LATEST_S)


@settings
class Limits:
    """What counts as hovering."""

    band_m: float = param(0.04, 'Greatest departure from the distance [m].', above=0.0, high=10.0)
    from_s: float = param(90.0, 'Instant from which it must hover [s].', low=0.0, high=LATEST_S)
    lateral_m: float = param(
        0.035, 'Greatest offset of the port in y or z [m].', above=0.0, high=10.0)
    attitude_deg: float = param(
        0.35, 'Greatest error of an attitude angle [deg].', above=0.0, high=90.0)


def faces(position: ArrayLike, q: ArrayLike, target: ArrayLike, centre: ArrayLike = 0.0
          ) -> tuple[Array, Array]:
    """
    Return the chaser's port from the target's in target axes, and the relative attitude.

    Parameters
    ----------
    position : array_like, shape (..., 3)
        Chaser's centre of mass from the target's, LVLH [m].
    q, target : array_like, shape (..., 4)
        Attitudes of chaser and target relative to LVLH.
    centre : array_like, shape (3,)
        The chaser's centre of mass in its drawing [m].

    Returns
    -------
    port : ndarray, shape (..., 3)
        The docking faces are -x apart.
    turn : ndarray, shape (..., 4)
        Chaser relative to target.
    """
    position = np.asarray(position, dtype=float)
    batch = position.shape[:-1]
    arm = np.broadcast_to(CHASER_PORT - centre, position.shape)
    port, turn = compiled().faces(rows(position, 3), rows(q, 4), rows(target, 4), rows(arm, 3),
                                  TARGET_PORT)
    return port.reshape((*batch, 3)), turn.reshape((*batch, 4))


def rows(value: ArrayLike, width: int) -> Array:
    """Return (..., width) as rows (N, width) for compiled loops, a copy: never read-only."""
    return np.array(value, dtype=float, order='C').reshape(-1, width)


@lru_cache(maxsize=1)
def compiled() -> Any:
    """Return the compiled loops of the mission."""
    from rvd_missions.docking import rows_compiled          # numba
    return rows_compiled


def ended(k: int, port: Array, last_step: int) -> NDArray[np.bool_]:
    """Return which runs end with step k: out of time, faces in touch, or no longer finite."""
    return ~(port[..., 0] < 0.0) | (k >= last_step)


def timed(limits: Limits, aim: Aim, run: Run) -> Limits:
    """Return the limits, or refuse ones that the run cannot meet; BadInput names the key."""
    require(limits.from_s < run.timeout_s, 'limits.from_s',
            f'be below timeout_s, {run.timeout_s:g}', limits.from_s)
    require(limits.band_m < aim.distance_m, 'limits.band_m',
            f'be below aim.distance_m, {aim.distance_m:g}', limits.band_m)
    return limits


@settings
class Seeing:
    """Which camera there is, and when it sees."""

    camera: str = param('pinhole', 'Camera: pinhole gives markers in the image, simple a pose, '
                        'stereo markers in two images, rendered two images that are searched.',
                        choices=('pinhole', 'simple', 'stereo', 'rendered'))
    period_s: float = param(0.1, 'Time between two views [s].', above=0.0, high=10.0)
    latency_s: float = param(0.05, 'Time from a view to what comes of it [s].', low=0.0, high=10.0)


def period(seeing: Seeing, run: Run) -> int:
    """Return the steps between two views; BadInput off the grid."""
    return whole_steps('seeing.period_s', seeing.period_s, run.step_s)


def late(seeing: Seeing, run: Run) -> int:
    """Return the steps by which a view is late; BadInput off the grid."""
    return whole_steps('seeing.latency_s', seeing.latency_s, run.step_s)
