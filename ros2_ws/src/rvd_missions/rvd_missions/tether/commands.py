"""
The command form: tension, thruster force along the tether frame, torque about body axes.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_missions.tether.inputs import InputParams, limits
from rvd_missions.tether.settings import GripperParams, TetherParams


@dataclass(frozen=True)
class TetherForm:
    """
    A command is (T, F_l, F_a, F_b, tau_x, tau_y, tau_z) [N, N m], (..., 7); see `commands.form`.

    Without a command the reel keeps the least tension: a tether that is let go is no safe state,
    since the gripper then coasts on towards the target.
    """

    gripper: GripperParams = GripperParams()
    tether: TetherParams = TetherParams()
    inputs: InputParams = InputParams()

    wire = Struct('<7d')

    @property
    def neutral(self) -> NDArray[np.float64]:
        """The least tension, and nothing else."""
        return np.array([self.tether.least_n, *np.zeros(6)])

    @property
    def retreat(self) -> NDArray[np.float64]:
        """What an ABORT commands: the tether brakes."""
        return np.array([self.tether.abort_n, *np.zeros(6)])

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return forces and torques (..., 7) [N, N m]: a command says them itself."""
        return np.asarray(command, dtype=float)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.float64]:
        """Return what is wanted, within the limits; neutral where it is not finite."""
        wanted = np.asarray(wanted, dtype=float)
        known = np.isfinite(wanted).all(axis=-1, keepdims=True)
        if self.inputs.limited:
            wanted = np.clip(wanted, *limits(self.gripper, self.tether))
        return np.where(known, wanted, self.neutral)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return list(command) == self.quantise(command).tolist()


def form(gripper: GripperParams, tether: TetherParams, inputs: InputParams) -> TetherForm:
    """Return the command form of a scenario."""
    return TetherForm(gripper, tether, inputs)
