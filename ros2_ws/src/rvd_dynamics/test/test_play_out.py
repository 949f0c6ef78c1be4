"""The play-out buffer: against the shift register of the paper, and as a state machine."""

from hypothesis import given, settings, strategies as st
from hypothesis.stateful import initialize, invariant, precondition, rule, RuleBasedStateMachine
import numpy as np
import pytest
from rvd_dynamics.link.play_out import Frame, Outcome, PlayOut

T = 100                         # [ns] sampling period of these tests


def frame(step, transit, period=T):
    return Frame(sequence=step + 1, sent_ns=step * period, arrived_ns=step * period + transit)


class ShiftRegister:
    """Section 1.3 of the paper, word by word; n >= 1 positions, one copy per frame."""

    def __init__(self, n):
        self.positions = [None] * n                     # position 1 first

    def tick(self, arrivals):
        """Move everything on by one, then let in (frame, l) of the last period; give the end."""
        self.positions = [None] + self.positions[:-1]
        for item, whole_periods in arrivals:
            if whole_periods + 1 <= len(self.positions):
                self.positions[whole_periods] = item    # position l + 1
        return self.positions[-1]


@pytest.mark.parametrize('n', [1, 2, 10])
@pytest.mark.parametrize('seed', range(4))
def test_slots_release_what_the_shift_register_releases(n, seed):
    rng = np.random.default_rng(seed)
    transits = rng.integers(0, (n + 2) * T, 500)
    transits[::7] = rng.integers(0, n + 2, 72) * T      # many exactly on the grid
    # lT < transit <= (l + 1)T, and transit 0 counts as l = 0
    whole = [max(-(-int(d) // T) - 1, 0) for d in transits]
    buffer, register = PlayOut(n, T), ShiftRegister(n)
    for tick in range(500 + n + 2):
        arrived = [k for k in range(max(0, tick - n - 2), min(tick + 1, 500))
                   if (tick - 1) * T < k * T + transits[k] <= tick * T]
        for k in arrived:
            buffer.insert(frame(k, int(transits[k])))
        # the register lets a frame with transit 0 in at the end of its period
        let_in = [(k, whole[k]) for k in range(min(tick, 500)) if k + whole[k] + 1 == tick]
        expected, released = register.tick(let_in), buffer.pop(tick)
        assert (None if released is None else released.sequence - 1) == expected


@pytest.mark.parametrize('n', [0, 1, 10])
def test_both_sides_of_the_edge(n):                     # P6, L1
    buffer = PlayOut(n, T)
    assert buffer.insert(frame(5, n * T + 1)) is Outcome.LATE
    assert len(buffer) == 0
    assert buffer.insert(frame(5, n * T)) is Outcome.QUEUED
    assert buffer.pop(5 + n).sequence == 6


def test_a_hundred_copies_are_released_once():          # L5
    buffer = PlayOut(10, T)
    outcomes = [buffer.insert(frame(0, d)) for d in range(0, 1000, 10)]
    assert outcomes == [Outcome.QUEUED] + 99 * [Outcome.DUPLICATE]
    released = [buffer.pop(k) for k in range(30)]
    assert released[10].arrived_ns == 0                 # the copy that came first
    assert released[:10] + released[11:] == 29 * [None]


def test_frames_that_come_in_reverse_order_leave_in_order():        # L4
    buffer = PlayOut(10, T)
    for k in reversed(range(10)):
        buffer.insert(frame(k, (10 - k) * T))
    assert [buffer.pop(k + 10).sequence for k in range(10)] == list(range(1, 11))


@given(shift=st.integers(0, 10**6), n=st.integers(0, 6),
       transits=st.lists(st.integers(0, 8 * T), min_size=1, max_size=30))
def test_shifting_all_stamps_shifts_all_releases(shift, n, transits):      # P7
    def run(first):
        buffer, released, waiting = PlayOut(n, T), [], []
        for k in range(len(transits) + n + 1):
            if k < len(transits):
                waiting.append(frame(first + k, transits[k]))
            for f in sorted((f for f in waiting if f.arrived_ns <= (first + k) * T),
                            key=lambda f: f.arrived_ns):
                waiting.remove(f)
                buffer.insert(f)
            out = buffer.pop(first + k)
            released.append(out and (out.sequence - first, out.arrived_ns - first * T))
        return released
    assert run(shift) == run(0)


def test_impossible_settings_are_refused():
    with pytest.raises(ValueError, match='hold_steps.*-1'):
        PlayOut(-1, T)
    with pytest.raises(ValueError, match='step_ns.*0'):
        PlayOut(1, 0)


class PlayOutMachine(RuleBasedStateMachine):
    """P1-P5: whatever is sent, lost, copied, delayed and whenever the buffer is killed."""

    @initialize(n=st.integers(0, 5))
    def begin(self, n):
        self.n, self.step = n, 0
        self.buffer = PlayOut(n, T)
        self.way = []                                   # (arrival, number, frame): in flight
        self.sent = self.made = self.lost = 0
        self.seen = {outcome: 0 for outcome in Outcome}
        self.delivered, self.dead = [], 0
        self.copies = 0

    def send(self, transits):
        self.sent += bool(transits)
        self.made += max(len(transits) - 1, 0)
        for transit in transits:
            self.way.append((self.step * T + transit, self.copies, frame(self.step, transit)))
            self.copies += 1

    def tick(self):
        now = self.step * T
        due = sorted(copy for copy in self.way if copy[0] <= now)
        self.way = [copy for copy in self.way if copy[0] > now]
        for _, _, arrived in due:
            self.seen[self.buffer.insert(arrived)] += 1
        released = self.buffer.pop(self.step)
        if released is not None:
            assert released.sent_ns == (self.step - self.n) * T                     # P1
            assert released.arrived_ns <= now
            assert not self.delivered or released.sequence > self.delivered[-1]     # P2
            self.delivered.append(released.sequence)
        self.step += 1

    @rule(transits=st.lists(st.integers(0, 8 * T), min_size=1, max_size=4))
    def send_and_tick(self, transits):
        self.send(transits)
        self.tick()

    @rule(steps=st.lists(st.integers(0, 8), min_size=1, max_size=3))
    def send_on_the_grid_and_tick(self, steps):
        self.send([s * T for s in steps])
        self.tick()

    @rule()
    def lose_and_tick(self):
        self.sent += 1
        self.lost += 1
        self.tick()

    @rule()
    def only_tick(self):
        self.tick()

    @precondition(lambda self: self.copies > 0)
    @rule()
    def crash(self):
        self.dead += len(self.buffer)
        self.buffer = PlayOut(self.n, T)

    @rule(transit=st.integers(0, 5 * T))
    def faults_stop(self, transit):
        """P5: the next fresh sample comes out n steps later."""
        fresh, transit = self.step, min(transit, self.n * T)
        self.send([transit])
        for _ in range(self.n + 1):
            self.tick()
        assert self.delivered[-1] == fresh + 1

    @invariant()
    def every_copy_is_somewhere(self):                  # P3
        if not hasattr(self, 'n'):
            return
        assert self.sent + self.made == (
            self.lost + len(self.way) + len(self.buffer) + self.dead + len(self.delivered)
            + self.seen[Outcome.LATE] + self.seen[Outcome.DUPLICATE])

    @invariant()
    def the_queue_is_bounded(self):                     # P4
        if hasattr(self, 'n'):
            assert len(self.buffer) <= self.n + 1


TestPlayOutMachine = PlayOutMachine.TestCase
TestPlayOutMachine.settings = settings(max_examples=100, stateful_step_count=40, deadline=None)
