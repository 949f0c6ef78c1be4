"""
Sensors: what the chaser measures of its true relative state.

Each is a frozen dataclass with `measure(state, normals)`; to add one, write it and list it
in SENSORS.

Frame, state as `orbit.cw`; unknown is NaN.
"""

from typing import Protocol

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


SENSORS = {'multiplicative': Multiplicative}
