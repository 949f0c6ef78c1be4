"""
The target on an elliptic orbit: where it is and how its orbital frame turns, at any time.

Frame   target orbital: +x along the transverse, +y radially outward, +z opposite to the orbit
        normal. It turns about -z at the rate nu', nu the true anomaly.
Valid   point-mass central body, no thrust of the target.
Source  R. H. Battin, An Introduction to the Mathematics and Methods of Astrodynamics, 1999,
        chapters 3 to 5: Kepler's equation M = E - e sin E, solved by Newton's method between
        bounds; nu = E + 2 atan2(b sin E, 1 - b cos E) with b = e / (1 + sqrt(1 - e^2)), which
        counts orbits on; r = p / c, nu' = sqrt(mu / p^3) c^2, nu'' = -2 nu'^2 e sin nu / c,
        c = 1 + e cos nu.
"""

from functools import cached_property
from math import atan2, cos, floor, pi, radians, sin, sqrt
from typing import NamedTuple

from rvd_dynamics.constants import MU_EARTH, RADIUS_EARTH
from rvd_dynamics.diagram.params import param, require, settings


class Motion(NamedTuple):
    """The target's motion at one instant."""

    anomaly: float                      # nu, counted on over orbits [rad]
    radius: float                       # r [m]
    rate: float                         # nu' [rad/s]
    acceleration: float                 # nu'' [rad/s^2]


@settings
class EllipseParams:
    """Elliptic orbit of the target, and where on it the run begins."""

    eccentricity: float = param(0.1, 'Eccentricity of the target orbit.')
    perigee_altitude_m: float = param(
        300e3, 'Altitude of the perigee above the body radius [m].')
    body_radius_m: float = param(
        RADIUS_EARTH, 'Radius of the central body [m].', above=0.0)
    gravitational_parameter_m3_s2: float = param(
        MU_EARTH, 'Gravitational parameter of the central body [m^3/s^2].', above=0.0)
    start_anomaly_deg: float = param(
        0.0, 'True anomaly of the target at the start [deg].', low=-360.0, high=360.0)

    def __post_init__(self) -> None:
        require(self.eccentricity >= 0.0, 'eccentricity', 'not be negative', self.eccentricity)
        require(self.eccentricity < 1.0, 'eccentricity',
                'be below 1: an orbit of eccentricity 1 or more never returns', self.eccentricity)
        require(self.perigee_altitude_m > 0.0, 'perigee_altitude_m',
                'be positive: the orbit hits the body', self.perigee_altitude_m)

    @cached_property
    def parameter(self) -> float:
        """Semi-latus rectum p [m]."""
        return (self.body_radius_m + self.perigee_altitude_m)*(1.0 + self.eccentricity)

    @cached_property
    def mean_motion(self) -> float:
        """Mean motion [rad/s]."""
        major = self.parameter/(1.0 - self.eccentricity*self.eccentricity)
        return sqrt(self.gravitational_parameter_m3_s2/major)/major

    @property
    def period(self) -> float:
        """Time of one orbit [s]."""
        return 2.0*pi/self.mean_motion

    @cached_property
    def _start_mean_anomaly(self) -> float:
        return mean_anomaly(radians(self.start_anomaly_deg), self.eccentricity)

    def time_of(self, anomaly: float) -> float:
        """Return when the target is at a true anomaly [rad], counted on over orbits [s]."""
        found = mean_anomaly(anomaly, self.eccentricity)
        return (found - self._start_mean_anomaly)/self.mean_motion

    def at(self, time_s: float) -> Motion:
        """Return the motion of the target so many seconds after the start."""
        anomaly = true_anomaly(self._start_mean_anomaly + self.mean_motion*time_s,
                               self.eccentricity)
        return self.motion(anomaly)

    def motion(self, anomaly: float) -> Motion:
        """Return the motion of the target at a true anomaly [rad]."""
        c, s = 1.0 + self.eccentricity*cos(anomaly), self.eccentricity*sin(anomaly)
        p = self.parameter
        rate = sqrt(self.gravitational_parameter_m3_s2/p)/p*c*c
        return Motion(anomaly, p/c, rate, -2.0*rate*rate*s/c)


def true_anomaly(mean: float, e: float) -> float:
    """Return the true anomaly at a mean anomaly, both counted on over orbits [rad]."""
    turns = floor(mean/(2.0*pi) + 0.5)
    m = mean - 2.0*pi*turns
    low, high = -pi, pi                 # E - e sin E rises with E
    eccentric = m + e*sin(m)
    for _ in range(60):
        off = eccentric - e*sin(eccentric) - m
        low, high = (low, eccentric) if off > 0.0 else (eccentric, high)
        nearer = eccentric - off/(1.0 - e*cos(eccentric))
        nearer = nearer if low <= nearer <= high else (low + high)/2.0
        if abs(nearer - eccentric) < 1e-15*max(1.0, abs(eccentric)):
            break
        eccentric = nearer
    b = e/(1.0 + sqrt(1.0 - e*e))
    return 2.0*pi*turns + nearer + 2.0*atan2(b*sin(nearer), 1.0 - b*cos(nearer))


def mean_anomaly(anomaly: float, e: float) -> float:
    """Return the mean anomaly at a true anomaly, both counted on over orbits [rad]."""
    b = e/(1.0 + sqrt(1.0 - e*e))
    eccentric = anomaly - 2.0*atan2(b*sin(anomaly), 1.0 + b*cos(anomaly))
    return eccentric - e*sin(eccentric)
