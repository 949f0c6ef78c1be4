"""
The guard as a block: reads what the forward leg hands over, writes the thrust command.
"""

from typing import Any

import numpy as np

from rvd_dynamics.commands import codes
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.onboard.guard.modes import GuardParams, Modes


class Guard:
    """
    The last word about thrust; see `modes`.

    Reads       arrival     command (..., n), kind, received; in a graph also reason and sequence
    Writes      thrust      command (..., n); kind, valid, reason, sequence, decided_by
    """

    def __init__(self, settings: GuardParams, form: CommandForm, run: Run, block: Block,
                 batch: tuple) -> None:
        self._modes = Modes(settings, form, run.step_ns, batch)
        self._thrust = block.writes['thrust']

    def step(self, k: int, arrival: Any) -> dict[str, Any]:
        """Return what the thrusters do in step k."""
        done = self._modes.advance(k, arrival.command, arrival.kind, arrival.received)
        told = {}
        if arrival.reason is not None:          # nobody asks in a batch
            aborted = done.kind == codes.KIND_ABORT
            told = {'reason': np.where(aborted, codes.REASON_ABORT, arrival.reason),
                    'sequence': arrival.sequence,
                    'decided_by': np.where(aborted, codes.BY_GUARD, codes.BY_NOBODY)}
        return {'thrust': self._thrust(command=done.command, kind=done.kind, valid=done.valid,
                                       **told)}
