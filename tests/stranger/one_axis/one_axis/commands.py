"""
The command form: an acceleration along the axis in whole steps, up to a largest one.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class ThrusterParams:
    """What the thruster can do."""

    step_m_s2: float = param(
        0.001, 'Difference between neighbouring accelerations [m/s^2].', above=0.0)
    steps: int = param(100, 'Number of accelerations in either direction.', low=1, high=10_000)


@dataclass(frozen=True)
class AccelerationForm:
    """A command is an acceleration [m/s^2], shape (..., 1) of float64; see `commands.form`."""

    thruster: ThrusterParams = ThrusterParams()

    neutral = np.zeros(1)
    wire = Struct('<d')

    @property
    def retreat(self) -> NDArray[np.float64]:
        """What an ABORT commands: full thrust away from the berth."""
        return np.array([-self.thruster.steps * self.thruster.step_m_s2])

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the nominal acceleration (..., 1) [m/s^2]: a command says it itself."""
        return np.asarray(command, dtype=float)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.float64]:
        """Return the command nearest to an acceleration; neutral where it is not finite."""
        step, most = self.thruster.step_m_s2, self.thruster.steps
        count = np.rint(np.asarray(wanted, dtype=float) / step)
        return np.where(np.isfinite(count), np.clip(count, -most, most), 0.0) * step

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return list(command) == self.quantise(command).tolist()


def form(thruster: ThrusterParams) -> AccelerationForm:
    """Return the command form of a scenario."""
    return AccelerationForm(thruster)
