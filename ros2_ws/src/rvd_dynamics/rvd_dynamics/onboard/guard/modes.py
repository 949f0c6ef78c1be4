"""
The guard's modes: what the thrusters do with what got through; on arrays.

nominal     the command that was received, neutral where none was
abort       from the first ABORT received, for the rest of the run: brake and back away for a
            while, then coast

It is the only writer of thrust. Shapes: commands (..., n), masks and codes (...).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.abort import GuardParams
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.constants import NS_PER_S


class Thrust(NamedTuple):
    """What the thrusters do in one step."""

    command: NDArray            # (..., n)
    kind: NDArray               # (...)   THRUST, or ABORT once one is in force
    valid: NDArray              # (...)   the command was received, or an ABORT is in force


class Modes:
    """Called once per step, in order."""

    def __init__(self, params: GuardParams, form: CommandForm, step_ns: int,
                 batch: tuple = ()) -> None:
        self._form, self._step_ns = form, step_ns
        self._burn_ns = round(params.abort_burn_s * NS_PER_S)
        self._abort_step = np.full(batch, -1, dtype=np.int64)
        self._aborted = False                   # in any row

    def advance(self, step: int, command: NDArray, kind: NDArray, received: NDArray) -> Thrust:
        """Return what the thrusters do in `step`; `kind` may be one for all rows."""
        command = np.where(received[..., np.newaxis], command, self._form.neutral)
        asked = kind == KIND_ABORT
        if np.count_nonzero(asked):
            new = received & asked & (self._abort_step < 0)
            self._aborted = self._aborted or bool(new.any())
            self._abort_step = np.where(new, step, self._abort_step)
        if not self._aborted:
            return Thrust(command, np.uint8(KIND_THRUST), received)
        aborted = self._abort_step >= 0
        burning = (step - self._abort_step) * self._step_ns < self._burn_ns
        away = np.where(burning[..., np.newaxis], self._form.retreat, self._form.neutral)
        return Thrust(np.where(aborted[..., np.newaxis], away, command),
                      np.where(aborted, np.uint8(KIND_ABORT), np.uint8(KIND_THRUST)),
                      received | aborted)
