"""
The command form: a torque about the axis in whole steps, up to a largest one.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_missions.attitude_hold.settings import Craft

MOST_STEPS = 1e9                        # a count of them is exact in a float64


@settings
class TorqueParams:
    """What the actuator can do."""

    max_n_m: float = param(2.0, 'Largest torque, in either direction [N m].', above=0.0, high=1e6)
    step_n_m: float = param(
        0.0001, 'Difference between neighbouring torques [N m].', above=0.0, high=1e6)

    def __post_init__(self) -> None:
        require(self.step_n_m <= self.max_n_m <= MOST_STEPS*self.step_n_m, 'step_n_m',
                f'be between a {MOST_STEPS:.0e}th of max_n_m and max_n_m, {self.max_n_m:g}',
                self.step_n_m)


@dataclass(frozen=True)
class TorqueForm:
    """A command is a torque [N m], shape (..., 1) of float64; see `commands.form`."""

    torque: TorqueParams = TorqueParams()
    craft: Craft = Craft()

    neutral = np.zeros(1)
    retreat = np.zeros(1)               # ABORT: no torque, the axis coasts
    wire = Struct('<d')

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the nominal angular acceleration (..., 1) [rad/s^2]."""
        return np.asarray(command, dtype=float) / self.craft.inertia_kg_m2

    def quantise(self, wanted: ArrayLike) -> NDArray[np.float64]:
        """Return the torque nearest to an angular acceleration; none where it is not finite."""
        wanted = np.asarray(wanted, dtype=float) * self.craft.inertia_kg_m2
        return self._nearest(wanted)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return list(command) == self._nearest(np.asarray(command, dtype=float)).tolist()

    def _nearest(self, torque: NDArray) -> NDArray[np.float64]:
        step = self.torque.step_n_m
        most = np.floor(self.torque.max_n_m/step + 1e-9)
        count = np.rint(np.clip(torque, -most*step, most*step) / step)      # 1e308/step overflows
        return np.where(np.isfinite(torque), count, 0.0) * step


def form(torque: TorqueParams, craft: Craft) -> TorqueForm:
    """Return the command form of a scenario."""
    return TorqueForm(torque, craft)
