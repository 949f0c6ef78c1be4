"""
Sensors: what the chaser measures of its true relative state.

Each is a frozen dataclass with `measure(state, normals)`; to add one, write it and list it
in SENSORS.

Frame, state as `orbit.cw`; unknown is NaN.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require


class Sensor(Protocol):
    """What the world asks of a sensor."""

    def measure(self, state: ArrayLike, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the measurement (..., 6) of `state` (..., 6); NaN where it is blind."""


@dataclass(frozen=True)
class Multiplicative:
    """
    Every component with an error proportional to itself, and without a floor.

    Source  Zhang, Li, Tang 2014, section 3.2: measured = X (1 + 0.01 N(0, 1)). A component
            that passes through zero is therefore measured exactly there: no real sensor does
            that, and a filter must not believe it.
    """

    noise_fraction: float = param(0.01, 'Deviation of the error as a fraction of the value.')

    def __post_init__(self) -> None:
        require(0.0 <= self.noise_fraction < 1.0, 'noise_fraction', 'be 0 up to 1',
                self.noise_fraction)

    def measure(self, state: ArrayLike, normals: ArrayLike) -> NDArray[np.float64]:
        """Return `state` (..., 6) with noise from standard normal draws (..., 6)."""
        noise = self.noise_fraction * np.asarray(normals, dtype=float)
        return np.asarray(state, dtype=float) * (1.0 + noise)


SENSORS = {'multiplicative': Multiplicative}
