"""
The command form: an acceleration along the axes of the target orbital frame, within limits.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class EngineParams:
    """What the chaser's engines can do."""

    limit_m_s2: float = param(
        0.6, 'Greatest acceleration along each axis [m/s^2].', above=0.0)


@dataclass(frozen=True)
class AccelerationForm:
    """A command is an acceleration [m/s^2], shape (..., 3) of float64; see `commands.form`."""

    engine: EngineParams = EngineParams()

    neutral = np.zeros(3)
    retreat = np.zeros(3)               # an ABORT coasts: away is another way on every side
    wire = Struct('<3d')

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the acceleration (..., 3) [m/s^2]: a command says it itself."""
        return np.asarray(command, dtype=float)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.float64]:
        """Return the command nearest to an acceleration; neutral where it is not finite."""
        wanted = np.asarray(wanted, dtype=float)
        most = self.engine.limit_m_s2
        known = np.isfinite(wanted).all(axis=-1, keepdims=True)
        return np.where(known, np.clip(wanted, -most, most), 0.0)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return bool(np.all(np.abs(command) <= self.engine.limit_m_s2))      # false for NaN


def form(engine: EngineParams) -> AccelerationForm:
    """Return the command form of a scenario."""
    return AccelerationForm(engine)
