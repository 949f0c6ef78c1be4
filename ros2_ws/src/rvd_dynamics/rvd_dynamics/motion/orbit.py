"""
The target's orbit, and the start of an approach: as it is planned, and its scatter.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, Tables 1 and 2.
"""

from functools import cached_property
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.constants import MU_MOON
from rvd_dynamics.diagram.params import param, require, settings


@settings
class OrbitParams:
    """Circular orbit of the target about the Moon."""

    radius_m: float = param(1938e3, 'Radius of the circular target orbit [m].', above=0.0)
    gravitational_parameter_m3_s2: float = param(
        MU_MOON, 'Gravitational parameter of the central body [m^3/s^2].', above=0.0)

    @cached_property
    def mean_motion(self) -> float:
        """Orbital rate of the target [rad/s]."""
        return sqrt(self.gravitational_parameter_m3_s2 / self.radius_m) / self.radius_m


@settings
class StartParams:
    """Nominal start: the state that the approach is planned from."""

    position_m: tuple = param(
        (-30.0, 0.0, 0.0), 'Nominal start position x, y, z, with x behind the target [m].',
        length=3)
    velocity_m_s: tuple = param(
        (0.25, 0.0, 0.0), 'Nominal start velocity x, y, z [m/s].', length=3)

    def __post_init__(self) -> None:
        require(self.position_m[0] < 0.0, 'position_m', 'begin with x < 0', self.position_m[0])

    @property
    def state(self) -> NDArray[np.float64]:
        """Position and velocity, shape (6,) [m, m/s]."""
        return np.array(self.position_m + self.velocity_m_s)


@settings
class ScatterParams:
    """Standard deviations of the start about its nominal state; zero means no scatter."""

    sigma_position_m: tuple = param(
        (0.0, 0.5, 0.5), 'Standard deviations of the start position along x, y and z [m].',
        low=0.0, length=3)
    sigma_velocity_m_s: tuple = param(
        (0.0, 0.01, 0.01), 'Standard deviations of the start velocity along x, y and z [m/s].',
        low=0.0, length=3)

    @property
    def sigma(self) -> NDArray[np.float64]:
        """Both (6,) [m, m/s]."""
        return np.array(self.sigma_position_m + self.sigma_velocity_m_s)
