"""The onboard guard: what it accepts, what it refuses and why, and that it never locks out."""

from pathlib import Path
import struct
from types import SimpleNamespace
from typing import NamedTuple
from zlib import crc32

from hypothesis import given, settings, strategies as st
from hypothesis.stateful import invariant, precondition, rule, RuleBasedStateMachine
import numpy as np
import pytest
from rvd_dynamics.commands.codes import (
    BY_GUARD, BY_NOBODY, KIND_ABORT, KIND_HOLD, KIND_RESUME, KIND_RETREAT, KIND_THRUST,
    REASON_ABORT, REASON_EMPTY, REASON_NONE)
from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.block import Block, ONBOARD
from rvd_dynamics.diagram.params import build, flatten
from rvd_dynamics.diagram.run import LegParams, Run
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link.frame import Refusal
from rvd_dynamics.onboard.guard import gate as gate_module
from rvd_dynamics.onboard.guard.block import Guard as GuardBlock
from rvd_dynamics.onboard.guard.gate import Gate
from rvd_dynamics.onboard.guard.modes import GuardParams, Modes

T = 500_000_000                 # [ns] default step
N = 10                          # default forward delay [steps]
LEVELS = (2, -1, 3)
BACK_AWAY = (-3, 0, 0)
FORM = LevelForm()
THRUST = Signal('/thrust', (
    Part('command', (3,), 'levels', 'i1'), Part('kind', (), '', 'u1'), Part('valid', (), '', '?'),
    Part('reason', (), '', 'u1'), Part('sequence', (), '', 'i8'),
    Part('decided_by', (), '', 'u1')))
DECLARED = Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
                 writes={'thrust': THRUST})


class Decision(NamedTuple):
    """What the craft does in one step, and what the gate has counted so far."""

    levels: tuple
    valid: bool
    kind: int
    reason: int
    sequence: int
    decided_by: int
    counts: dict


class Guard:
    """The gate and, behind it, the block with the modes, as the onboard node runs them."""

    def __init__(self, params=GuardParams(), forward_delay_s=5.0, step_s=0.5):
        run = Run(step_s=step_s)
        hold = LegParams(forward_delay_s=forward_delay_s).on(run).forward
        self.gate = Gate(FORM, hold * run.step_ns, run.step_ns)
        self.block = GuardBlock(params, FORM, run, DECLARED, ())

    def advance(self, step, data):
        """Return the decision of `step` on what the link released, None: nothing."""
        passed = self.gate.advance(step, data)
        thrust = self.block.step(step, SimpleNamespace(
            command=np.array(passed.command, dtype=np.int8), kind=np.uint8(passed.kind),
            received=np.bool_(passed.received), reason=np.uint8(passed.reason),
            sequence=passed.sequence))['thrust']
        assert THRUST.complaint(thrust, ()) == ''
        return Decision(tuple(thrust.command.tolist()), bool(thrust.valid), int(thrust.kind),
                        int(thrust.reason), thrust.sequence, int(thrust.decided_by),
                        passed.counts)

    @property
    def accepted_sequence(self):
        return self.gate.accepted_sequence

    @property
    def refusal(self):
        return self.gate.refusal


def payload(sequence, made, levels=LEVELS, kind=KIND_THRUST, version=1, key=0, session=0,
            late_ns=0):
    """Pack a command by hand, so that wrong ones can be made; `made` is a step."""
    body = struct.pack('<BHQQqB3b', version, key, session, sequence, made * T - late_ns, kind,
                       *levels)
    return body + struct.pack('<I', crc32(body))


def flown(*payloads, guard=None, first=100):
    """Give the payloads to a guard, one per step, and return the last decision."""
    guard = guard or Guard()
    return [guard.advance(first + i, p) for i, p in enumerate(payloads)][-1]


def counted(decision):
    return {name: n for name, n in decision.counts.items() if n}


# accepted

@given(levels=st.tuples(*3 * [st.integers(-3, 3)]), age=st.integers(0, N),
       sequence=st.integers(1, 2**64 - 1))
def test_a_fresh_command_is_obeyed(levels, age, sequence):
    decision = flown(payload(sequence, 100 - age, levels))
    assert decision.levels == levels and decision.valid
    assert (decision.kind, decision.reason) == (KIND_THRUST, REASON_NONE)
    assert decision.decided_by == BY_NOBODY
    assert decision.sequence == sequence and counted(decision) == {'accepted': 1}


def test_a_step_without_a_frame_is_no_refusal():
    guard = Guard()
    decision = flown(None, guard=guard)
    assert (decision.levels, decision.valid, decision.reason) == ((0, 0, 0), False, REASON_EMPTY)
    assert decision.sequence == 0 and counted(decision) == {'empty': 1} and guard.refusal == 0


def test_a_decision_keeps_the_counts_of_its_step():
    guard = Guard()
    first, second = guard.advance(0, None), guard.advance(1, None)
    aborted, later = guard.advance(2, abort(1, 2)), guard.advance(3, None)
    assert [d.counts['empty'] for d in (first, second, aborted, later)] == [1, 2, 2, 3]


# refused: each reason, and its twin just inside the limit

@pytest.mark.parametrize(('refusal', 'bad', 'good'), [
    (Refusal.LENGTH, payload(5, 100)[:-1], payload(5, 100)),
    (Refusal.LENGTH, payload(5, 100) + b'\0', payload(5, 100)),
    (Refusal.LENGTH, b'', payload(5, 100)),
    (Refusal.CHECKSUM, bytes(35), payload(5, 100)),
    (Refusal.AGE, payload(5, 89), payload(5, 90)),                      # P32
    (Refusal.AGE, payload(5, 90, late_ns=1), payload(5, 90)),           # one ns beyond nT
    (Refusal.AGE, payload(5, 101), payload(5, 100)),                    # from the future
    (Refusal.AGE, payload(5, 100, late_ns=-1), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, (4, 0, 0)), payload(5, 100, (3, 0, 0))),
    (Refusal.RANGE, payload(5, 100, (0, -4, 0)), payload(5, 100, (0, -3, 0))),
    (Refusal.RANGE, payload(5, 100, (0, 0, -128)), payload(5, 100, (0, 0, 3))),
    (Refusal.RANGE, payload(5, 100, kind=5), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, kind=255), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, kind=KIND_HOLD), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, kind=KIND_RETREAT), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, kind=KIND_RESUME), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, (4, 0, 0), KIND_ABORT), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, version=2), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, key=1), payload(5, 100)),
    (Refusal.RANGE, payload(5, 100, session=1), payload(5, 100))])
def test_each_refusal_has_its_reason_its_count_and_no_thrust(refusal, bad, good):
    guard = Guard()
    decision = flown(bad, guard=guard)
    assert (decision.levels, decision.valid, decision.sequence) == ((0, 0, 0), False, 0)
    assert decision.reason == refusal == guard.refusal
    assert counted(decision) == {refusal.name.lower(): 1}
    assert guard.accepted_sequence == 0                 # refused whole: nothing remembered
    assert guard.advance(100, good).valid               # and the next good one is obeyed


@given(flip=st.integers(0, 8 * 35 - 1))
def test_any_flipped_bit_is_refused(flip):              # P30, L6
    damaged = bytearray(payload(5, 100))
    damaged[flip // 8] ^= 1 << flip % 8
    assert flown(bytes(damaged)).reason == Refusal.CHECKSUM


@settings(max_examples=300)
@given(st.lists(st.binary(max_size=60), min_size=1, max_size=5))
def test_arbitrary_bytes_never_move_a_thruster(history):        # P29
    guard = Guard()
    for step, data in enumerate(history):
        decision = guard.advance(step, data)
        assert decision.levels == (0, 0, 0) and not decision.valid


def test_checks_come_in_order():                        # P34
    everything_wrong = payload(1, 500, (9, 9, 9), kind=9)
    guard = Guard()
    guard.advance(99, payload(1, 99))
    reasons = [guard.advance(100, p).reason for p in (
        everything_wrong[:-1], everything_wrong[:-1] + b'\x99', everything_wrong,
        payload(2, 500, (9, 9, 9), kind=9), payload(2, 100, (9, 9, 9), kind=9))]
    assert reasons == [Refusal.LENGTH, Refusal.CHECKSUM, Refusal.ORDER, Refusal.AGE, Refusal.RANGE]


# order: P31, X3, L4, L5

def test_replays_are_refused():
    first, second = payload(7, 100), payload(8, 101)
    guard = Guard()
    assert flown(first, second, guard=guard).valid
    for replay, after, reason in ((second, 102, Refusal.ORDER),         # at once
                                  (first, 103, Refusal.ORDER),          # the one before
                                  (second, 7302, Refusal.ORDER)):       # after an hour
        decision = guard.advance(after, replay)
        assert decision.reason == reason and decision.levels == (0, 0, 0)


def test_a_frame_held_back_while_nothing_came_is_too_old():
    assert flown(payload(7, 100), None, payload(8, 80)).reason == Refusal.AGE


def test_a_hundred_copies_are_executed_once():
    decision = flown(*100 * [payload(7, 100)])
    assert counted(decision) == {'accepted': 1, 'order': 99}


def test_an_overtaken_frame_is_refused():
    assert flown(payload(8, 99), payload(7, 98)).reason == Refusal.ORDER


@pytest.mark.parametrize('jump', [1, 2, 27_000, 2**40, 2**64 - 2])     # P33: no upper window
def test_the_next_fresh_frame_is_obeyed_however_far_ahead(jump):
    assert flown(payload(1, 100), None, payload(1 + jump, 102)).valid


def test_the_last_sequence_number_ends_the_session():
    assert flown(payload(2**64 - 1, 100), payload(2**64 - 1, 101)).reason == Refusal.ORDER


# other delays and steps

@pytest.mark.parametrize(('delay_s', 'step_s', 'oldest'), [(0.0, 0.5, 0), (5.0, 0.1, 50),
                                                           (3.0, 1.0, 3)])
def test_the_age_limit_is_the_play_out_delay(delay_s, step_s, oldest):
    step_ns = round(step_s * 1e9)
    for age, reason in ((oldest, REASON_NONE), (oldest + 1, Refusal.AGE)):
        body = struct.pack('<BHQQqB3b', 1, 0, 0, 1, (200 - age) * step_ns, 0, 1, 0, 0)
        frame = body + struct.pack('<I', crc32(body))
        guard = Guard(forward_delay_s=delay_s, step_s=step_s)
        assert guard.advance(200, frame).reason == reason


# ABORT: P20

def abort(sequence, made):
    return payload(sequence, made, (0, 0, 0), KIND_ABORT)


def test_an_abort_backs_away_for_its_time_and_then_coasts():
    guard = Guard()
    guard.advance(99, payload(1, 99))
    decisions = [guard.advance(100, abort(2, 95))]
    decisions += [guard.advance(k, None) for k in range(101, 300)]
    assert [d.levels for d in decisions] == 32 * [BACK_AWAY] + 168 * [(0, 0, 0)]    # 16 s
    assert all((d.kind, d.reason, d.valid, d.decided_by)
               == (KIND_ABORT, REASON_ABORT, True, BY_GUARD) for d in decisions)


@pytest.mark.parametrize(('burn_s', 'steps'), [(0.0, 0), (0.4, 1), (0.5, 1), (0.6, 2)])
def test_the_burn_covers_the_time_asked_for(burn_s, steps):
    guard = Guard(GuardParams(abort_burn_s=burn_s))
    levels = [guard.advance(k, abort(1, 0) if k == 0 else None).levels for k in range(5)]
    assert levels == steps * [BACK_AWAY] + (5 - steps) * [(0, 0, 0)]


@pytest.mark.parametrize('made', [-10**6, 0, 89, 100, 101, 10**6])
def test_an_abort_is_obeyed_at_any_age(made):           # X3: the harmless side
    assert flown(abort(5, made)).levels == BACK_AWAY


def test_an_abort_is_not_exempt_from_checksum_and_order():
    damaged = bytearray(abort(9, 100))
    damaged[12] ^= 1
    guard = Guard()
    guard.advance(99, payload(8, 99))
    for bad, reason in ((bytes(damaged), Refusal.CHECKSUM), (abort(8, 100), Refusal.ORDER),
                        (abort(9, 100)[:-1], Refusal.LENGTH)):
        decision = guard.advance(100, bad)
        assert (decision.reason, decision.kind) == (reason, KIND_THRUST)
        assert decision.levels == (0, 0, 0)


def test_nothing_that_comes_later_cancels_an_abort():
    guard = Guard()
    guard.advance(100, abort(5, 100))
    later = [payload(6, 101), payload(7, 101, (3, 3, 3), KIND_RESUME), b'noise', abort(5, 100),
             payload(8, 105)]
    for k, p in enumerate(later):
        decision = guard.advance(101 + k, p)
        assert (decision.levels, decision.reason) == (BACK_AWAY, REASON_ABORT)
        assert decision.sequence == 0
    assert counted(decision) == {'accepted': 1, 'ignored': 2, 'range': 1, 'length': 1, 'order': 1}
    assert guard.accepted_sequence == 5 and guard.refusal == REASON_ABORT


def test_a_second_abort_does_not_prolong_the_burn():
    guard = Guard()
    levels = [guard.advance(k, abort(k + 1, k)).levels for k in range(60)]
    assert levels == 32 * [BACK_AWAY] + 28 * [(0, 0, 0)]
    assert guard.accepted_sequence == 60


# settings

@pytest.mark.parametrize('value', [-1.0, float('nan'), 3601.0])
def test_impossible_burns_are_refused(value):
    with pytest.raises(ValueError, match='abort_burn_s'):
        build(GuardParams, {'abort_burn_s': value})
    assert build(GuardParams, flatten(GuardParams())) == GuardParams()


def test_the_gate_does_no_arithmetic_that_could_meet_nan():
    source = Path(gate_module.__file__).read_text()
    assert 'numpy' not in source and 'float(' not in source and 'clip' not in source


# the modes on a batch: each row by itself

def test_rows_of_the_modes_are_single_runs():
    """What each row does is what it does alone, whichever rows abort beside it."""
    rng, rows, steps = np.random.default_rng(4), 30, 80
    command = rng.integers(-3, 4, (steps, rows, 3), dtype=np.int8)
    received = rng.random((steps, rows)) < 0.8
    kind = np.where(rng.random((steps, rows)) < 0.01, KIND_ABORT, KIND_THRUST).astype(np.uint8)
    whole = Modes(GuardParams(), FORM, T, (rows,))
    alone = [Modes(GuardParams(), FORM, T) for _ in range(rows)]
    aborted = np.zeros(rows, dtype=bool)
    for k in range(steps):
        done = whole.advance(k, command[k], kind[k], received[k])
        for row, one in enumerate(alone):
            single = one.advance(k, command[k, row], kind[k, row], received[k, row])
            assert done.command[row].tolist() == single.command.tolist()
            assert np.broadcast_to(done.kind, (rows,))[row] == single.kind
            assert done.valid[row] == single.valid
            aborted[row] |= single.kind == KIND_ABORT
        assert done.command.dtype == np.int8
    assert 5 < aborted.sum() < rows                     # both ways are well tried


def test_an_abort_that_was_not_received_is_none():
    modes = Modes(GuardParams(), FORM, T)
    done = modes.advance(0, np.int8([1, 2, 3]), np.uint8(KIND_ABORT), np.bool_(False))
    assert (done.command.tolist(), int(done.kind), bool(done.valid)) == ([0, 0, 0], KIND_THRUST,
                                                                         False)


# as a state machine: any history of frames

class GuardMachine(RuleBasedStateMachine):
    """P31-P33 and the census: whatever came before, the next fresh valid frame is accepted."""

    def __init__(self):
        super().__init__()
        self.guard, self.step, self.sequence, self.aborted = Guard(), 0, 0, None
        self.old, self.given, self.decision = [], 0, None

    def give(self, data):
        self.given += 1
        self.decision, self.decided = self.guard.advance(self.step, data), self.step
        self.step += 1
        return self.decision

    def quiet(self, decision):
        assert decision.levels == (0, 0, 0) or self.aborted is not None
        assert decision.sequence == 0

    @rule(skip=st.integers(1, 10**6), age=st.integers(0, N), levels=st.tuples(
        *3 * [st.integers(-3, 3)]))
    def fresh(self, skip, age, levels):                 # P33
        self.sequence += skip
        made = max(self.step - age, 0)
        data = payload(self.sequence, made, levels)
        decision = self.give(data)
        self.old.append(data)
        if self.aborted is None:
            assert decision.valid and decision.levels == levels
            assert decision.sequence == self.sequence == self.guard.accepted_sequence

    @rule(steps=st.integers(1, 50))
    def silence(self, steps):
        for _ in range(steps):
            self.quiet(self.give(None))

    @rule(seconds=st.integers(1, 3600))
    def long_outage(self, seconds):
        self.step += 2 * seconds

    @precondition(lambda self: self.old and self.aborted is None)
    @rule(data=st.data())
    def replay(self, data):                             # P31
        decision = self.give(data.draw(st.sampled_from(self.old)))
        assert decision.reason == Refusal.ORDER
        self.quiet(decision)

    @rule(beyond=st.integers(1, 10**6), future=st.booleans())
    def stale_or_early(self, beyond, future):           # P32
        made = self.step + beyond if future else self.step - N - beyond
        decision = self.give(payload(self.sequence + 1, made))
        assert self.aborted is not None or decision.reason == Refusal.AGE
        self.quiet(decision)

    @rule(data=st.data())
    def damage(self, data):
        good = payload(self.sequence + 1, self.step)
        bit = data.draw(st.integers(0, 8 * len(good) - 1))
        bad = (int.from_bytes(good, 'little') ^ 1 << bit).to_bytes(len(good), 'little')
        self.quiet(self.give(bad if data.draw(st.booleans()) else good[:bit // 8]))

    @rule(data=st.binary(max_size=100))
    def noise(self, data):
        self.quiet(self.give(data))

    @rule(axis=st.integers(0, 2), level=st.sampled_from([-128, -4, 4, 127]))
    def out_of_range(self, axis, level):
        levels = [0, 0, 0]
        levels[axis] = level
        self.quiet(self.give(payload(self.sequence + 1, self.step, levels)))

    @rule(made=st.integers(-100, 10**7), chance=st.integers(0, 9))
    def abort(self, made, chance):
        if chance:                                      # rarely, or all runs would be aborts
            return
        self.sequence += 1
        self.aborted = self.step if self.aborted is None else self.aborted
        self.give(abort(self.sequence, made))

    @invariant()
    def thrust_is_always_a_whole_level(self):
        if self.decision is None:
            return
        assert all(type(level) is int and -3 <= level <= 3 for level in self.decision.levels)
        assert FORM.legal(self.decision.levels)
        if self.aborted is not None:
            burning = (self.decided - self.aborted) * T < 16_000_000_000
            assert self.decision.levels == (BACK_AWAY if burning else (0, 0, 0))

    @invariant()
    def every_step_is_counted_once(self):
        if self.decision is not None:
            assert sum(self.decision.counts.values()) == self.given


TestGuardMachine = GuardMachine.TestCase
TestGuardMachine.settings = settings(max_examples=100, stateful_step_count=40, deadline=None)
