"""
Sensors: what the chaser measures of its true relative state.

Each is a frozen dataclass with `measure(state, normals)`; to add one, write it and list it
in SENSORS.

Frame, state as `orbit.cw`; unknown is NaN.
"""

from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings


class Sensor(Protocol):
    """What the world asks of a sensor."""

    def measure(self, state: ArrayLike, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the measurement (..., 6) of `state` (..., 6); NaN where it is blind."""


@settings
class Multiplicative:
    """
    Every component with an error proportional to itself, and without a floor.

    Source  Zhang, Li, Tang 2014, section 3.2: measured = X (1 + 0.01 N(0, 1)). A component
            that passes through zero is therefore measured exactly there: no real sensor does
            that, and a filter must not believe it.
    """

    noise_fraction: float = param(
        0.01, 'Standard deviation of the error of a component, as a fraction of its value.',
        low=0.0, below=1.0)

    def measure(self, state: ArrayLike, normals: ArrayLike) -> NDArray[np.float64]:
        """Return `state` (..., 6) with noise from standard normal draws (..., 6)."""
        noise = self.noise_fraction * np.asarray(normals, dtype=float)
        return np.asarray(state, dtype=float) * (1.0 + noise)


@settings
class Additive:
    """
    Errors that do not vanish with what is measured: noise of a size of its own, and a bias.

    measured = X (1 + noise_fraction N) + sigma N' + bias N'', where N and N' are drawn for each
    sample and N'' once for the run, each component apart.

    Source  ours: what the paper's sensor lacks (see `Multiplicative`).
    """

    adds: ClassVar[bool] = True         # asks for the draws `added` and `bias`

    noise_fraction: float = param(
        0.01, 'Standard deviation of the error of a component, as a fraction of its value.',
        low=0.0, below=1.0)
    position_sigma_m: tuple = param(
        (0.01, 0.01, 0.01), 'Standard deviations of the noise added to the position [m].',
        low=0.0, length=3)
    velocity_sigma_m_s: tuple = param(
        (0.001, 0.001, 0.001), 'Standard deviations of the noise added to the velocity [m/s].',
        low=0.0, length=3)
    position_bias_m: tuple = param(
        (0.0, 0.0, 0.0), 'Standard deviations of the bias of the position, which lasts for the '
        'run [m].', low=0.0, length=3)
    velocity_bias_m_s: tuple = param(
        (0.0, 0.0, 0.0), 'Standard deviations of the bias of the velocity, which lasts for the '
        'run [m/s].', low=0.0, length=3)

    def measure(self, state: ArrayLike, normals: ArrayLike, added: ArrayLike = 0.0,
                bias: ArrayLike = 0.0) -> NDArray[np.float64]:
        """Return `state` (..., 6) with errors from standard normal draws (..., 6) each."""
        noise = self.noise_fraction * np.asarray(normals, dtype=float)
        sigma = np.array(self.position_sigma_m + self.velocity_sigma_m_s)
        lasting = np.array(self.position_bias_m + self.velocity_bias_m_s)
        return (np.asarray(state, dtype=float) * (1.0 + noise)
                + sigma*np.asarray(added, dtype=float) + lasting*np.asarray(bias, dtype=float))


SENSORS = {'multiplicative': Multiplicative, 'additive': Additive}
