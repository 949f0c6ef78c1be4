"""
The onboard guard: the only writer of thrust, and the last word about each command frame.

Checks a frame in this order and stops at the first that fails: length, checksum, order
(newer than the last accepted), age (neither older than the play-out delay nor from the
future), range (kind known, levels -3..3). What is refused is refused whole: levels 0 for that
step. There is no upper bound on how far a sequence number may jump, because an outage skips
thousands. ABORT is obeyed at any age, since it is the harmless side, and holds for the rest
of the run: brake and back away along -x, then coast.

State   last accepted sequence, the step an ABORT was accepted in, counts. No clock: the step
        is given. No arithmetic on floats: what is not finite cannot get this far.
"""

from dataclasses import dataclass

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST, REASON_ABORT, REASON_EMPTY, REASON_NONE
from rvd_dynamics.link.frame import Command, LEVELS, levels_in_range, Refusal, unpack_command
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import param, settings

NEUTRAL = (0, 0, 0)
BACK_AWAY = (LEVELS[0], 0, 0)
OBEYED = (KIND_THRUST, KIND_ABORT)      # the others are reserved: refused as out of range
AGELESS = (KIND_ABORT,)


@settings
class GuardParams:
    """Settings of the guard."""

    abort_burn_s: float = param(
        16.0, 'Duration of the burn along -x at level 3 that follows an ABORT [s].',
        low=0.0, high=3600.0)


@dataclass(frozen=True, slots=True)
class Decision:
    """The thruster command of one step."""

    levels: tuple               # three ints in [-3..3] along x, y, z
    kind: int                   # THRUST, or ABORT once one is in force
    reason: int                 # why the levels are what they are: a REASON code
    valid: bool                 # the levels come from an accepted frame or from an ABORT
    sequence: int               # of the frame accepted in this step, 0 when none
    counts: dict                # frames so far: accepted, empty, ignored, and each refusal


class Guard:
    """
    Checks one payload per step and says what the thrusters do in it.

    `accepted_sequence` and `refusal` (0 when none) are what the downlink tells the ground.
    """

    def __init__(self, mission: Mission, params: GuardParams = GuardParams()) -> None:
        self.accepted_sequence = 0
        self.refusal = 0
        self._step_ns = mission.step_ns
        self._hold_ns = mission.forward_steps * mission.step_ns
        self._burn_ns = round(params.abort_burn_s * 1e9)
        self._abort_step: int | None = None
        self._counts = {'accepted': 0, 'empty': 0, 'ignored': 0}
        self._counts.update((refusal.name.lower(), 0) for refusal in Refusal)

    def advance(self, step: int, payload: bytes | None) -> Decision:
        """Return what the thrusters do in `step`; `payload` None: the link had nothing due."""
        levels, reason, sequence = self._judge(step, payload)
        if self._abort_step is None:
            return Decision(levels, KIND_THRUST, reason, reason == REASON_NONE, sequence,
                            dict(self._counts))
        burning = (step - self._abort_step) * self._step_ns < self._burn_ns
        return Decision(BACK_AWAY if burning else NEUTRAL, KIND_ABORT, REASON_ABORT, True,
                        sequence, dict(self._counts))

    def _judge(self, step: int, payload: bytes | None) -> tuple[tuple, int, int]:
        """Accept, ignore or refuse, and count it; return levels, reason, accepted sequence."""
        if payload is None:
            self._counts['empty'] += 1
            return NEUTRAL, REASON_EMPTY, 0
        command = unpack_command(payload)
        refusal = self._refusal(step, command) if isinstance(command, Command) else command
        if refusal is not None:
            self._counts[refusal.name.lower()] += 1
            self.refusal = int(refusal)
            return NEUTRAL, int(refusal), 0
        if self._abort_step is not None and command.kind != KIND_ABORT:
            self._counts['ignored'] += 1
            self.refusal = REASON_ABORT
            return NEUTRAL, REASON_ABORT, 0
        if self._abort_step is None and command.kind == KIND_ABORT:
            self._abort_step = step
        self._counts['accepted'] += 1
        self.accepted_sequence = command.sequence
        return command.levels, REASON_NONE, command.sequence

    def _refusal(self, step: int, command: Command) -> Refusal | None:
        if command.sequence <= self.accepted_sequence:
            return Refusal.ORDER
        age_ns = step * self._step_ns - command.generated_ns
        if command.kind not in AGELESS and not 0 <= age_ns <= self._hold_ns:
            return Refusal.AGE
        if command.kind not in OBEYED or not levels_in_range(command.levels):
            return Refusal.RANGE
        return None
