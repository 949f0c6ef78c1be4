"""
The command ladder: where each command is on its way, as far as the ground can know.

The ground knows what it sent, when a command is due on board (the play-out buffer makes that
a constant), and what the downlink says: the last accepted sequence number, and why the command
of the step before was refused, if it was. Nothing here looks at the link or the craft directly.

    SENT       on the link; due on board `forward_steps` after it was sent
    DUE        should be at the craft; no telemetry of that instant has come down yet
    EXECUTED   telemetry of the step after it acted says that it was accepted
    SEEN       and telemetry of `EFFECT_S` later has come down too: the motion shows the effect
    REFUSED    telemetry of the step after it was due says that it was refused, and why
    MISSED     it was not accepted: it did not arrive in time, or the telemetry that tells of a
               refusal was lost
    UNKNOWN    the telemetry that could have told was lost, or this craft's never tells

A downlink generated in step g tells of commands that acted up to step g - 1.
"""

from collections import deque
from dataclasses import dataclass, field

from rvd_dynamics.commands.codes import KIND_ABORT, REASON_ABORT, REASON_NONE
from rvd_dynamics.link.frame import Refusal

SENT, DUE, EXECUTED, SEEN, REFUSED, MISSED, UNKNOWN = range(7)
STATES = ('SENT', 'DUE', 'EXECUTED', 'SEEN', 'REFUSED', 'MISSED', 'UNKNOWN')
EFFECT_S = 1.0                  # [s] simulation time
REFUSALS = {int(refusal) for refusal in Refusal}


@dataclass(slots=True)
class Rung:
    """One command on its way."""

    sequence: int
    step: int                   # step in which it was sent
    due: int                    # step in which it acts
    value: tuple[float, ...]    # one number for each axis of a command
    kind: int
    state: int = SENT
    refusal: int = REASON_NONE
    told: int = -1              # step in which the ground learned its fate
    version: int = 0            # of the ladder when this rung last changed


@dataclass
class Ladder:
    """Follows commands by what was sent and what telemetry says."""

    forward_steps: int
    step_s: float
    keep: int = 600             # rungs remembered
    archive: list[Rung] | None = None       # takes the others, where all are wanted
    rungs: deque = field(default_factory=deque)
    round_trip_steps: int | None = None
    version: int = 0            # rises with every change

    def sent(self, step: int, sequence: int, value: tuple[float, ...], kind: int) -> None:
        """Note a command that left the ground in `step`."""
        self.version += 1
        rung = Rung(sequence, step, step + self.forward_steps, value, kind,
                    version=self.version)
        self.rungs.append(rung)
        if len(self.rungs) > self.keep:
            gone = self.rungs.popleft()
            if self.archive is not None:
                self.archive.append(gone)

    def tick(self, step: int) -> None:
        """Let the ground's time advance to `step`."""
        for rung in reversed(self.rungs):
            if rung.state == SENT and rung.due <= step:
                self._set(rung, DUE)
            elif rung.state > DUE:
                break

    def heard(self, step: int, generated: int, accepted: int | None, refusal: int) -> None:
        """
        Take in telemetry that came down in `step` and was generated in `generated`.

        `accepted` is None where telemetry does not say which commands were accepted; `refusal`
        is of the command that was due in the step before `generated`, 0 when none was refused.
        """
        tells = generated - 1
        effect = round(EFFECT_S / self.step_s)
        abort = None if accepted is None else self._abort_in_force(accepted)
        for rung in self.rungs:
            if abort is not None and rung.state in (SENT, DUE) and rung.sequence <= accepted:
                rung.told = step                # an ABORT overtakes all that is on the way
                rung.refusal = REASON_NONE if rung.kind == KIND_ABORT else REASON_ABORT
                self._set(rung, EXECUTED if rung.kind == KIND_ABORT else REFUSED)
            elif rung.state in (SENT, DUE) and rung.due <= tells:
                self._judge(rung, step, tells, accepted, refusal)
            elif rung.state == EXECUTED and rung.due + effect <= tells:
                self._set(rung, SEEN)

    def _abort_in_force(self, accepted: int) -> int | None:
        """Return the sequence of the first ABORT if the craft has accepted one."""
        first = next((r.sequence for r in self.rungs if r.kind == KIND_ABORT), None)
        return first if first is not None and accepted >= first else None

    def _judge(self, rung: Rung, step: int, tells: int, accepted: int | None, refusal: int
               ) -> None:
        rung.told = step
        if accepted is None:
            self._set(rung, UNKNOWN)
        elif accepted == rung.sequence and rung.due <= tells:
            self._set(rung, EXECUTED)
            self.round_trip_steps = step - rung.step
        elif accepted < rung.sequence:
            refused = rung.due == tells and _refuses(refusal, rung.kind)
            rung.refusal = refusal if refused else REASON_NONE
            self._set(rung, REFUSED if refused else MISSED)
        else:                                   # a later one was accepted: this one may have been
            self._set(rung, UNKNOWN)

    def _set(self, rung: Rung, state: int) -> None:
        self.version += 1
        rung.state, rung.version = state, self.version

    def changes(self, since: int = 0) -> list[list[float]]:
        """Return a row for each rung that changed after version `since`; 0 gives all."""
        return [row(rung) for rung in self.rungs if rung.version > since]

    def whole(self) -> list[list[float]]:
        """Return a row for each rung of the run, as far as there is an archive."""
        return [row(rung) for rung in (*(self.archive or ()), *self.rungs)]

    def counts(self) -> dict[str, int]:
        """Return how many remembered rungs are in each state."""
        made = dict.fromkeys(STATES, 0)
        for rung in self.rungs:
            made[STATES[rung.state]] += 1
        return made


def _refuses(refusal: int, kind: int) -> bool:
    """
    Say whether a code of the guard means that a command of `kind` came and was refused.

    ABORT in force is the guard's reason in every step from then on, and refuses no ABORT.
    """
    return refusal in REFUSALS or (refusal == REASON_ABORT and kind != KIND_ABORT)


def row(rung: Rung) -> list[float]:
    """Return sequence, sent step, due step, kind, state, refusal, told step, and the command."""
    return [rung.sequence, rung.step, rung.due, rung.kind, rung.state, rung.refusal, rung.told,
            *rung.value]
