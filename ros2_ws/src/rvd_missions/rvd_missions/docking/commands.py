"""
The command form: which valves are open.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.thruster_set import ThrusterSet
from rvd_missions.docking.thruster_layout import layout

COUNT = len(layout())
BRAKE_N = 60.0                          # [N] the thrusters of J4 that brake


@dataclass(frozen=True)
class ValveForm:
    """A command is one number for each valve, (..., T) of uint8: 1 is open; see `commands.form`."""

    thrusters: ThrusterSet = field(default_factory=layout)

    neutral = np.zeros(COUNT, dtype=np.uint8)
    wire = Struct(f'<{COUNT}B')

    @property
    def retreat(self) -> NDArray[np.uint8]:
        """What an ABORT commands: the four thrusters of J4 that push away from the target."""
        brake = self.thrusters.of('J4') & (self.thrusters.force == BRAKE_N)
        return brake.astype(np.uint8)

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the nominal wrench (..., 6) [N, N m] of commands; many have the same."""
        total = np.zeros((*np.shape(command)[:-1], 6))
        for t, column in enumerate(self.thrusters.nominal.T):       # a sum in a fixed order
            total = total + np.asarray(command, dtype=float)[..., t:t + 1]*column
        return total

    def legal(self, command: Sequence) -> bool:
        """Say whether numbers, as they came over the wire, are a command."""
        return len(command) == COUNT and set(command) <= {0, 1}


def by_run(runs: Sequence[int], count: int) -> NDArray[np.int64]:
    """Return the thruster (N,) of each run where every run has another one."""
    return np.asarray(runs, dtype=np.int64) % count


def form() -> ValveForm:
    """Return the command form of a scenario."""
    return ValveForm()
