"""
The guard's gate: the last word about each command frame, on bytes; a graph only.

Checks a frame in this order and stops at the first check that fails: length, checksum, order
(newer than the last accepted), age (neither older than the play-out delay nor from the
future), range (kind known, a command of the form). What is refused is refused whole. There is
no upper bound on how far a sequence number may jump, because an outage skips thousands. ABORT
is accepted at any age, since it is the harmless side; after it nothing else is.

In one process nothing reaches the gate that it would refuse, except frames that were damaged:
there the mask of the leg stands in its place.

State   last accepted sequence, whether an ABORT was accepted, counts. No clock: the step is
        given. No arithmetic on floats: what is not finite cannot get this far.
"""

from dataclasses import dataclass

from rvd_dynamics.commands.codes import (
    KIND_ABORT, KIND_THRUST, REASON_ABORT, REASON_EMPTY, REASON_NONE)
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.link.frame import Command, Refusal, unpack_command

OBEYED = (KIND_THRUST, KIND_ABORT)      # the others are reserved: refused as out of range
AGELESS = (KIND_ABORT,)


@dataclass(frozen=True, slots=True)
class Passed:
    """What the gate made of one step's frame."""

    command: tuple              # numbers of the command form; neutral when nothing was accepted
    kind: int                   # of the accepted frame, else THRUST
    received: bool              # a frame was accepted
    reason: int                 # why not: a REASON code
    sequence: int               # of the accepted frame, 0 when none
    counts: dict                # frames so far: accepted, empty, ignored, and each refusal


class Gate:
    """
    Checks one payload per step.

    `accepted_sequence` and `refusal` (0 when none) are what the downlink tells the ground.
    """

    def __init__(self, form: CommandForm, hold_ns: int, step_ns: int) -> None:
        self.accepted_sequence = 0
        self.refusal = 0
        self._form = form
        self._neutral = tuple(form.neutral.tolist())
        self._step_ns, self._hold_ns = step_ns, hold_ns
        self._aborted = False
        self._counts = {'accepted': 0, 'empty': 0, 'ignored': 0}
        self._counts.update((refusal.name.lower(), 0) for refusal in Refusal)

    def advance(self, step: int, payload: bytes | None) -> Passed:
        """Check the payload that is due in `step`; None: the link had nothing due."""
        if payload is None:
            return self._nothing('empty', REASON_EMPTY)
        command = unpack_command(payload, self._form)
        refusal = self._refusal(step, command) if isinstance(command, Command) else command
        if refusal is not None:
            self.refusal = int(refusal)
            return self._nothing(refusal.name.lower(), int(refusal))
        if self._aborted and command.kind != KIND_ABORT:
            self.refusal = REASON_ABORT
            return self._nothing('ignored', REASON_ABORT)
        self._aborted |= command.kind == KIND_ABORT
        self._counts['accepted'] += 1
        self.accepted_sequence = command.sequence
        return Passed(command.command, command.kind, True, REASON_NONE, command.sequence,
                      dict(self._counts))

    def _nothing(self, count: str, reason: int) -> Passed:
        self._counts[count] += 1
        return Passed(self._neutral, KIND_THRUST, False, reason, 0, dict(self._counts))

    def _refusal(self, step: int, command: Command) -> Refusal | None:
        if command.sequence <= self.accepted_sequence:
            return Refusal.ORDER
        age_ns = step * self._step_ns - command.generated_ns
        if command.kind not in AGELESS and not 0 <= age_ns <= self._hold_ns:
            return Refusal.AGE
        if command.kind not in OBEYED or not self._form.legal(command.command):
            return Refusal.RANGE
        return None
