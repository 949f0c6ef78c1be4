"""
Safe corridor: the inside of a cone about the approach axis, and its control boundary.

Frame   target orbital; positions (x, y, z) [m] on the last axis, leading axes are batch axes.
Shape   wall radius R(x) = d - x tan(alpha): d at the docking plane x = 0, wider towards -x,
        apex at x = d / tan(alpha) behind the plane. rho is the distance from the x axis.
Source  Zhang, Li, Tang 2014, eq. 12-24, corrected: see docs/models/corridor.md. The
        printed forms are available by keyword, for study only.
"""

from functools import cached_property
from math import cos, inf, pi, radians, sin, tan

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings

Array = NDArray[np.float64]

SLOWEST_RATE = 0.01                     # [m/s] slower, the drift of eq. 18 is not an approach


@settings
class Cone:
    """Approach cone: its half angle, and its radius at the docking plane."""

    half_angle_deg: float = param(
        3.0, 'Half angle of the corridor cone [deg].', above=0.0, below=90.0)
    docking_radius_m: float = param(
        0.3, 'Radius of the corridor at the docking plane x = 0 [m].', above=0.0)

    @cached_property
    def alpha(self) -> float:
        """Half angle [rad]."""
        return self.half_angle_deg * pi / 180.0

    @cached_property
    def tan_alpha(self) -> float:
        """Slope of the wall."""
        return tan(radians(self.half_angle_deg))


def radius(x: ArrayLike, corridor: Cone) -> Array:
    """Return the wall radius R(x) [m] at stations `x` [m] (eq. 12)."""
    return corridor.docking_radius_m - np.asarray(x, dtype=float) * corridor.tan_alpha


def signed_distance(position: ArrayLike, corridor: Cone) -> Array:
    """
    Return the distance to the wall [m], positive inside (eq. 13 with its sign).

    `position` is (..., 3), the result (...). The cone extends past the docking plane to its
    apex. In the shadow of the apex, which no run reaches, the result is a lower bound.
    """
    x, y, z = _components(position)
    return distance_at(x, np.sqrt(y*y + z*z), corridor)


def distance_at(x: ArrayLike, rho: ArrayLike, corridor: Cone) -> Array:
    """Return `signed_distance` from stations x [m] and distances rho from the axis [m]."""
    c = cos(corridor.alpha)
    return (corridor.docking_radius_m*c - sin(corridor.alpha)*x) - c*rho


def unsigned_distance(position: ArrayLike, corridor: Cone) -> Array:
    """Return eq. 13 as printed: the absolute value, which hides an exit. For study only."""
    return np.abs(signed_distance(position, corridor))


def outward_normal(position: ArrayLike, corridor: Cone) -> Array:
    """
    Return the outward unit normal (..., 3) of the wall point nearest to `position` (..., 3).

    On the axis (rho = 0) that point could be anywhere on a circle; the lateral part is then zero.
    """
    x, y, z = _components(position)
    rho = np.sqrt(y*y + z*z)
    unknown = 0.0 * (x + rho)               # 0, or NaN: an unknown position has no normal
    lateral = cos(corridor.alpha) * _reciprocal(rho) + unknown
    return np.moveaxis(np.stack([sin(corridor.alpha) + unknown, lateral*y, lateral*z]), 0, -1)


def nearest_point(position: ArrayLike, corridor: Cone) -> Array:
    """
    Return the point q (..., 3) of the wall nearest to `position` (..., 3): q = p + D n.

    Near the docking plane q may lie up to d sin(alpha) cos(alpha) past it. On the axis it
    is the station of the nearest circle, x + D sin(alpha), with no lateral part.
    """
    position = np.asarray(position, dtype=float)
    distance = signed_distance(position, corridor)
    return position + distance[..., np.newaxis] * outward_normal(position, corridor)


def ray_nearest_point(position: ArrayLike, corridor: Cone,
                      printed: bool = False) -> Array:
    """
    Return q (..., 3) as `nearest_point`, from the ray through the apex (eq. 14-16, corrected).

    With `printed` eq. 14 and 15 are taken as they stand, with the distance where x_p is
    meant and without the factor j of the first term: wrong by metres, for study only.
    """
    x, y, z = _components(position)
    apex = corridor.docking_radius_m / corridor.tan_alpha
    rho = np.sqrt(y*y + z*z)
    wall = np.abs(x*corridor.tan_alpha - corridor.docking_radius_m)     # j rho
    j = wall * _reciprocal(rho)
    if printed:
        along = unsigned_distance(position, corridor) - apex
        projection = rho*rho - along*apex + x*along
    else:
        along = x - apex
        projection = along*along + wall*rho
    k = projection / (along*along + wall*wall)
    return np.stack([apex + along*k, j*y*k, j*z*k], axis=-1)


def drift_rate(offset: ArrayLike, n: float, rate: float = 0.25) -> Array:
    """
    Return the lateral rate [m/s] of a free drift at `offset` [m] from the axis (eq. 20).

    The drift starts on the axis with closing rate `rate` [m/s] in an orbit of rate `n`
    [rad/s]. It never gets beyond 4 rate / n; there, and at the axis, the rate is 0.
    """
    u = np.clip(n / (2.0*rate) * np.asarray(offset, dtype=float), 0.0, 2.0)
    return 2.0*rate * np.sqrt(u*(2.0 - u))          # 1 - (1 - u)^2 without cancellation


def control_boundary(x: ArrayLike, corridor: Cone, n: float, rate: float = 0.25,
                     delay: float = 10.0, at_arrival: bool = True,
                     clamp: bool = True) -> Array:
    """
    Return the radius [m] of the control boundary at stations `x` [m] (eq. 21-24, corrected).

    A chaser that drifts outside it can reach the wall before a command sent now acts.

    Parameters
    ----------
    x : array_like, shape (...)
        Stations [m]; past the docking plane there is no time left, the result is R(x).
    corridor : Cone
        The cone.
    n : float
        Orbital rate [rad/s].
    rate : float
        Nominal closing rate [m/s].
    delay : float
        Delay of the whole loop [s].
    at_arrival, clamp : bool
        False gives the printed variants, for study only: the drift rate taken at x instead of
        at the station reached after the delay (the boundary then jumps at x = -rate delay),
        and no limit at 0 (a long delay then gives negative radii).

    Raises
    ------
    ValueError
        If `rate` is below 0.01 m/s, or `delay` or `n` is impossible.
    """
    require(SLOWEST_RATE <= rate < inf, 'rate', f'be at least {SLOWEST_RATE}', rate)
    require(0.0 <= delay < inf, 'delay', 'be finite and not negative', delay)
    require(n > 0.0, 'n', 'be positive', n)
    x = np.asarray(x, dtype=float)
    wall = radius(x, corridor)
    lead = np.minimum(np.maximum(-x, 0.0) / rate, delay)    # time until the command or docking
    arrival = x + rate*lead
    beyond = lead < delay                                   # docks before the command acts
    station = arrival if at_arrival else np.where(beyond, arrival, x)
    shrink = lead * (rate*corridor.tan_alpha
                     + drift_rate(radius(station, corridor), n, rate))
    return np.maximum(wall - shrink, 0.0) if clamp else wall - shrink


def _components(position: ArrayLike) -> tuple[Array, Array, Array]:
    position = np.asarray(position, dtype=float)
    return position[..., 0], position[..., 1], position[..., 2]


def _reciprocal(rho: Array) -> Array:
    """Return 1 / rho, and 0 on the axis; NaN stays NaN."""
    rho = np.asarray(rho)
    return np.divide(1.0, rho, out=np.zeros_like(rho), where=rho != 0.0)
