"""The link event by event: against an event queue, against the gate, and as a state machine."""

from collections import Counter
from dataclasses import asdict, replace

from event_queue import fly, sendings_of
from hypothesis import given, settings, strategies as st
from hypothesis.stateful import initialize, invariant, rule, RuleBasedStateMachine
import numpy as np
import pytest
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.link.channel import Channel, damaged, LinkCounts
from rvd_dynamics.link.frame import Downlink, pack_command, pack_downlink, unpack_downlink
from rvd_dynamics.link.leg import sources
from rvd_dynamics.link.models import Constant, Gamma, LinkParams
from rvd_dynamics.link.plan import draw_plan, LinkPlan
from rvd_dynamics.link.play_out import Frame
from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.run import LegParams, Run
from rvd_dynamics.onboard.guard.gate import Gate

STEP_NS = 500_000_000
PLACES = ('delivered', 'late', 'lost', 'outage', 'duplicate_dropped', 'in_flight', 'queued')
WILD = LinkParams(gamma=Gamma(offset_fraction=0.2, scale_fraction=0.085), loss_fraction=0.1,
                  duplicate_fraction=0.4, corrupt_fraction=0.25, reorder_fraction=0.2,
                  reorder_delay_s=1.2, outage_windows_s=(20.0, 32.0, 90.0, 90.6))


def balanced(counts):
    """Every copy is somewhere."""
    return counts.sent + counts.duplicated == sum(getattr(counts, place) for place in PLACES)


def frame(step, payload=b'payload', expedited=False, step_ns=STEP_NS):
    return Frame(sequence=step + 1, sent_ns=step * step_ns, payload=payload, expedited=expedited)


def draw(params=LinkParams(), seed=1, steps=401, hold=10, step_ns=STEP_NS):
    return draw_plan(params, np.random.default_rng(seed), steps, step_ns, hold)


def plan_of(transits, hold, step_ns, lost=(), damage_of=(), duplicated=(), outage=()):
    """Make a plan by hand: `transits` (steps, 2); the rest are the steps or copies struck."""
    steps = len(transits)

    def mark(struck, shape):
        marked = np.zeros(shape, dtype=bool)
        for place in struck:
            marked[place] = True
        return marked
    return LinkPlan(
        hold_ns=hold * step_ns, transit_ns=np.array(transits, dtype=np.int64),
        lost=mark(lost, (steps, 2)), damaged=mark(damage_of, (steps, 2)),
        damage=np.full((steps, 2), 0.3), duplicated=mark(duplicated, steps),
        outage=mark(outage, steps))


# against the event queue

@pytest.mark.parametrize('hold', [0, 1, 10])
@pytest.mark.parametrize('seed', range(5))
def test_releases_and_counts_are_those_of_an_event_queue(seed, hold):
    steps, rng = 600, np.random.default_rng(100 + seed)
    params = WILD if hold else replace(WILD, reorder_delay_s=0.3)
    plan = draw(params, seed, steps, hold)
    sent, expedited = rng.random(steps) < 0.9, rng.random(steps) < (0.05 if seed else 0.0)
    flight = fly(sendings_of(plan, sent, expedited), hold, STEP_NS)
    channel, corrupted = Channel(plan, hold, STEP_NS), 0
    for k in range(steps):
        given = frame(k, bytes([k % 256] * 20), expedited[k]) if sent[k] else None
        out = channel.advance(k, given)
        if flight.released[k] is None:
            assert out is None
        else:
            source, copy = flight.released[k]
            payload = bytes([source % 256] * 20)
            if plan.damaged[source, copy]:
                payload, corrupted = damaged(payload, plan.damage[source, copy]), corrupted + 1
            assert out == Frame(
                sequence=source + 1, sent_ns=source * STEP_NS,
                arrived_ns=source * STEP_NS + int(plan.transit_ns[source, copy]),
                released_ns=k * STEP_NS, expedited=bool(expedited[source]), payload=payload)
        counts = asdict(channel.counts)
        assert {name: counts[name] for name in PLACES} == {
            name: flight.census[k][name] for name in PLACES}
        assert balanced(channel.counts)                                     # P3
    assert counts['sent'] == sent.sum()
    assert counts['duplicated'] == (sent & plan.duplicated).sum()
    assert counts['reordered'] == flight.overtaken
    assert counts['corrupted'] >= corrupted
    if hold == 10:                              # a copy has been in every place
        assert all(max(census[name] for census in flight.census) > 0 for name in PLACES)
        assert corrupted > 20 and flight.overtaken > 100


@given(data=st.data(), hold=st.integers(0, 4), steps=st.integers(1, 25))
@settings(deadline=None)
def test_any_plan_on_a_coarse_grid_agrees_with_the_event_queue(data, hold, steps):
    transit = st.integers(0, 4 * (hold + 2)).map(lambda q: q * 5)           # ties abound: T = 20
    pairs, bits = st.tuples(transit, transit), st.booleans()

    def column(item):
        return data.draw(st.lists(item, min_size=steps, max_size=steps))
    plan = plan_of(column(pairs), hold, 20)
    plan = replace(plan, duplicated=np.array(column(bits)), outage=np.array(column(bits)),
                   lost=np.array(column(st.tuples(bits, bits))))
    sent, expedited = column(bits), column(bits)
    flight = fly(sendings_of(plan, sent, expedited), hold, 20)
    channel = Channel(plan, hold, 20)
    for k in range(steps):
        out = channel.advance(k, frame(k, b'', expedited[k], 20) if sent[k] else None)
        expected = flight.released[k]
        assert (out is None) == (expected is None)
        assert out is None or (out.sequence, out.arrived_ns) == (
            expected[0] + 1, expected[0] * 20 + plan.transit_ns[expected])
        assert all(getattr(channel.counts, name) == flight.census[k][name] for name in PLACES)
    assert channel.counts.reordered == flight.overtaken


# node and campaign agree: channel and gate against the mask of the plan

@pytest.mark.parametrize('forward_delay_s', [0.0, 0.5, 5.0])
@pytest.mark.parametrize('params', [WILD, LinkParams(), replace(WILD, reorder_delay_s=0.2)],
                         ids=['wild', 'default', 'mild'])
def test_the_gate_accepts_exactly_what_the_plan_calls_intact_in_time(params, forward_delay_s):
    hold = LegParams(forward_delay_s=forward_delay_s).on(Run()).forward
    for seed in range(40):
        plan = draw(params, seed, hold=hold)
        channel = Channel(plan, hold, STEP_NS)
        gate = Gate(LevelForm(), hold * STEP_NS, STEP_NS)
        accepted = np.zeros(401, dtype=bool)
        for k in range(401):
            levels = (k % 7 - 3, -(k % 5 - 2), (k + 1) % 4)
            out = channel.advance(k, frame(k, pack_command(k + 1, k * STEP_NS, levels)))
            passed = gate.advance(k, None if out is None else out.payload)
            if passed.received:
                source = passed.sequence - 1
                assert k == source + hold
                assert passed.command == (source % 7 - 3, -(source % 5 - 2), (source + 1) % 4)
                accepted[source] = True
            else:
                assert passed.command == (0, 0, 0)
        known = 401 - hold
        assert np.array_equal(accepted[:known], plan.intact_in_time[:known])
        assert not accepted[known:].any()


@pytest.mark.parametrize('abort_step', [0, 1, 60, 200, 395])
@pytest.mark.parametrize('hold', [0, 1, 10])
def test_with_an_abort_the_gate_accepts_exactly_what_the_leg_calls_received(abort_step, hold):
    """Expedited frames skip the buffer: twice, overtaken and damaged ones among them."""
    plans = [draw(WILD, seed, hold=hold) for seed in range(15)]
    expected = sources(plans, hold, STEP_NS, abort_step)
    for row, plan in zip(expected, plans):
        channel, gate = Channel(plan, hold, STEP_NS), Gate(LevelForm(), hold * STEP_NS, STEP_NS)
        for k in range(401):
            aborting = k >= abort_step
            out = channel.advance(k, frame(k, pack_command(
                k + 1, k * STEP_NS, (0, 0, 0), KIND_ABORT if aborting else KIND_THRUST), aborting))
            passed = gate.advance(k, None if out is None else out.payload)
            assert passed.received == (row[k] >= 0)
            assert passed.sequence == row[k] + 1
    until = min(abort_step, 401)
    assert (expected[:, :until] == np.where(expected[:, :until] >= 0, np.arange(until) - hold,
                                            -1)).all()


def test_the_ground_reads_exactly_the_telemetry_that_is_intact_in_time():
    for seed in range(8):
        plan = draw(WILD, seed)
        channel, read = Channel(plan, 10, STEP_NS), np.zeros(401, dtype=bool)
        for k in range(401):
            out = channel.advance(k, frame(k, pack_downlink(k + 1, k * STEP_NS, [k * 0.1] * 6)))
            downlink = unpack_downlink(out.payload) if out else None
            if isinstance(downlink, Downlink):
                assert downlink.state == ((k - 10) * 0.1,) * 6
                read[k - 10] = True
        assert np.array_equal(read[:391], plan.intact_in_time[:391])


def test_an_intact_second_copy_does_not_help_a_damaged_first_one():
    plan = plan_of([[30, 60]] * 3, 1, 100, duplicated=[0], damage_of=[(0, 0)])
    channel = Channel(plan, 1, 100)
    payload = pack_command(1, 0, (1, 0, 0))
    released = [channel.advance(k, frame(0, payload, step_ns=100) if k == 0 else None)
                for k in range(3)]
    assert released[1].payload != payload and released[1].arrived_ns == 30
    assert channel.counts.duplicate_dropped == 1
    assert not plan.intact_in_time[0]


# edges and counts

@pytest.mark.parametrize(('transit', 'released'), [(0, True), (999, True), (1000, True),
                                                   (1001, False), (3000, False)])
def test_in_time_up_to_and_with_the_play_out_delay(transit, released):      # P6, L1
    channel = Channel(plan_of([[transit, 0]] + [[0, 0]] * 49, 10, 100), 10, 100)
    outs = [channel.advance(k, frame(0, step_ns=100) if k == 0 else None) for k in range(50)]
    assert [k for k, out in enumerate(outs) if out] == ([10] if released else [])
    assert channel.counts.late == (not released)


def test_what_is_on_its_way_at_the_end_stays_on_its_way():
    channel = Channel(plan_of([[250, 0]] * 10, 5, 100), 5, 100)
    for k in range(10):
        channel.advance(k, frame(k, step_ns=100))
    c = channel.counts
    assert (c.sent, c.delivered, c.queued, c.in_flight) == (10, 5, 2, 3) and balanced(c)


def test_steps_without_a_frame_count_nothing():
    channel = Channel(draw(WILD), 10, STEP_NS)
    assert [channel.advance(k, None) for k in range(401)] == [None] * 401
    assert channel.counts == LinkCounts()


def test_an_outage_swallows_both_copies():                                  # L7
    channel = Channel(plan_of([[0, 0]] * 4, 1, 100, duplicated=[0, 1, 2], outage=[1, 2]), 1, 100)
    outs = [channel.advance(k, frame(k, step_ns=100)) for k in range(4)]
    assert [out and out.sequence for out in outs] == [None, 1, None, None]
    assert channel.counts.outage == 4 and channel.counts.duplicate_dropped == 1


def test_after_an_outage_only_fresh_frames_come_out():                      # L7, L10, P5
    plan = draw(LinkParams(outage_windows_s=(50.0, 95.0)))
    channel = Channel(plan, 10, STEP_NS)
    outs = [channel.advance(k, frame(k)) for k in range(401)]
    assert not any(outs[110:200])
    assert [out.sequence - 1 for out in outs[200:] if out] == [
        k for k in range(190, 391) if plan.intact_in_time[k]]


def test_attributes_count_copies_that_arrived():
    plan = plan_of([[500, 0], [100, 0], [100, 50], [100, 0]] + [[0, 0]] * 6, 10, 100,
                   damage_of=[(1, 0), (2, 1), (3, 0)], duplicated=[2], lost=[(3, 0)])
    channel = Channel(plan, 10, 100)
    for k in range(10):
        channel.advance(k, frame(k, step_ns=100) if k < 4 else None)
    assert channel.counts.corrupted == 2        # of 1 and of 2's copy; 3 was lost on the way
    assert channel.counts.reordered == 1        # frame 0 came after 1 and 2


def test_the_payload_is_opaque():
    rng = np.random.default_rng(3)
    plan = draw(replace(WILD, corrupt_fraction=0.0))
    payloads = [rng.bytes(int(rng.integers(0, 200))) for _ in range(401)]
    one, other = Channel(plan, 10, STEP_NS), Channel(plan, 10, STEP_NS)
    for k in range(401):
        out, plain = one.advance(k, frame(k, payloads[k])), other.advance(k, frame(k, b''))
        assert (out is None) == (plain is None)
        if out is not None:
            assert out.payload == payloads[k - 10]
            assert out._replace(payload=b'') == plain
    assert one.counts == other.counts


def test_delay_percentiles_are_nearest_ranks_of_all_transits_that_arrived():
    plan = draw(LinkParams(duplicate_fraction=0.5, loss_fraction=0.2))
    channel, arrived = Channel(plan, 10, STEP_NS), []
    assert all(np.isnan(channel.delay_s(p)) for p in (50, 99, 100))
    for k in range(401):
        channel.advance(k, frame(k))
        arrived = [plan.transit_ns[j, c] for j in range(k + 1) for c in (0, 1)
                   if (c == 0 or plan.duplicated[j]) and not plan.lost[j, c]
                   and j * STEP_NS + plan.transit_ns[j, c] <= k * STEP_NS]
        for p in (50, 99, 100):
            ns = np.percentile(arrived, p, method='inverted_cdf') if arrived else np.nan
            np.testing.assert_equal(channel.delay_s(p), ns / 1e9)
    assert len(arrived) > 400


@pytest.mark.parametrize('shift', [1, 250])
def test_shifting_everything_in_time_shifts_everything_that_comes_out(shift):      # P7
    plan = draw(replace(WILD, outage_windows_s=(0.0, 0.0)), steps=150)
    shifted = LinkPlan(plan.hold_ns, *(np.roll(
        np.concatenate([getattr(plan, name), np.zeros_like(getattr(plan, name), shape=(
            shift, *getattr(plan, name).shape[1:]))]), shift, axis=0) for name in (
        'transit_ns', 'lost', 'damaged', 'damage', 'duplicated', 'outage')))
    one, other, by = Channel(plan, 10, STEP_NS), Channel(shifted, 10, STEP_NS), shift * STEP_NS
    for k in range(150):
        out, later = one.advance(k, frame(k)), other.advance(k + shift, frame(k + shift))
        assert later == (out and Frame(out.sequence + shift, out.sent_ns + by,
                                       out.arrived_ns + by, out.released_ns + by, False,
                                       out.payload))
    assert one.counts == other.counts


# expedited frames

def run_expedited(transits, expedited, hold=10, steps=30, **kinds):
    plan = plan_of(transits + [[0, 0]] * (steps - len(transits)), hold, 100, **kinds)
    channel = Channel(plan, hold, 100)
    outs = [channel.advance(k, frame(k, step_ns=100, expedited=k in expedited)
                            if k < len(transits) else None) for k in range(steps)]
    assert balanced(channel.counts)
    return [out and out.sequence - 1 for out in outs], channel.counts


@pytest.mark.parametrize(('transit', 'step'), [(0, 3), (1, 4), (100, 4), (101, 5), (1500, 18)])
def test_expedited_frames_leave_at_the_first_step_after_their_arrival(transit, step):     # P20
    outs, _ = run_expedited([[0, 0]] * 3 + [[transit, 0]], expedited={3}, hold=20)
    assert outs.index(3) == step


def test_an_expedited_frame_takes_the_place_of_the_one_due():
    outs, counts = run_expedited([[0, 0]] * 8, expedited={5}, hold=4)
    assert outs[:12] == [None, None, None, None, 0, 5, 2, 3, 4, None, 6, 7]
    assert counts.late == 1 and counts.delivered == 7


def test_two_expedited_frames_of_one_instant_leave_one_after_the_other():
    outs, counts = run_expedited([[250, 0], [150, 0], [50, 0]], expedited={0, 1, 2}, hold=5)
    assert outs[:7] == [None, None, None, 0, 1, 2, None]
    assert counts.delivered == 3


def test_both_copies_of_an_expedited_frame_are_handed_on():
    outs, counts = run_expedited([[50, 60]], expedited={0}, duplicated=[0], damage_of=[(0, 0)])
    assert outs[:4] == [None, 0, 0, None] and counts.duplicate_dropped == 0


def test_expedited_frames_do_not_escape_loss_and_outage():
    outs, counts = run_expedited([[0, 0]] * 2, expedited={0, 1}, lost=[(0, 0)], outage=[1])
    assert not any(out is not None for out in outs)
    assert counts.lost == counts.outage == 1


# misuse

def test_misuse_is_refused():
    plan = draw()
    with pytest.raises(ValueError, match='5000000000 ns of the plan'):
        Channel(plan, 9, STEP_NS)
    channel = Channel(plan, 10, STEP_NS)
    channel.advance(0, None)
    for step in (0, 2):
        with pytest.raises(ValueError, match='step must be 1'):
            channel.advance(step, None)
    with pytest.raises(ValueError, match='sent must be'):
        channel.advance(1, frame(0))
    with pytest.raises(ValueError, match='plan of 401 steps'):
        Channel(plan, 10, STEP_NS).advance(401, None)


# as a state machine

class ChannelMachine(RuleBasedStateMachine):
    """P1-P5 on the whole link: any plan, any pattern of frames; the tail of the plan is calm."""

    STEPS = 60

    @initialize(hold=st.integers(0, 4), seed=st.integers(0, 2**32))
    def begin(self, hold, seed):
        params = replace(WILD, gamma=Gamma(offset_fraction=0.0, shape=1.0, scale_fraction=0.5),
                         outage_windows_s=(10.0, 12.0))
        faulty = draw(params, seed, self.STEPS + 30, hold)
        calm = draw(LinkParams(model='constant', constant=Constant(1.0)), 1, self.STEPS + 30, hold)
        names = ('transit_ns', 'lost', 'damaged', 'damage', 'duplicated', 'outage')
        self.plan = LinkPlan(faulty.hold_ns, *(np.concatenate([
            getattr(faulty, n)[:self.STEPS], getattr(calm, n)[self.STEPS:]]) for n in names))
        self.hold, self.step, self.last = hold, 0, 0
        self.channel, self.sent = Channel(self.plan, hold, STEP_NS), Counter()

    def advance(self, send):
        self.sent[self.step] = send
        out = self.channel.advance(self.step, frame(self.step) if send else None)
        source = self.step - self.hold
        promised = self.sent[source] and self.plan.in_time[source].any()
        assert (out is not None) == bool(promised)
        if out is not None:
            assert out.sequence - 1 == source                                   # P1
            assert out.sequence > self.last                                     # P2
            assert out.arrived_ns <= out.released_ns == self.step * STEP_NS
            self.last = out.sequence
        self.step += 1

    @rule(send=st.lists(st.booleans(), min_size=1, max_size=8))
    def some_steps(self, send):
        for s in send[:max(self.STEPS - self.step, 0)]:
            self.advance(s)

    @invariant()
    def counts_balance_and_the_queue_is_bounded(self):                          # P3, P4
        if hasattr(self, 'channel'):
            assert balanced(self.channel.counts)
            assert self.channel.counts.queued <= self.hold + 1

    def teardown(self):                                                         # P5
        if not hasattr(self, 'channel'):
            return
        while self.step < self.STEPS:
            self.advance(True)
        for _ in range(self.hold + 1):
            self.advance(True)
        assert self.last == self.STEPS + 1


TestChannelMachine = ChannelMachine.TestCase
TestChannelMachine.settings = settings(max_examples=60, stateful_step_count=15, deadline=None)
