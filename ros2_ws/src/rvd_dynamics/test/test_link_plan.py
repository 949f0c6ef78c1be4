"""The plan of a link: what is drawn, what stays put, and what a campaign reads from it."""

from dataclasses import dataclass, replace

from event_queue import fly, sendings_of
from hypothesis import given, strategies as st
import numpy as np
import pytest
from rvd_dynamics.diagram import streams
from rvd_dynamics.link.channel import damaged
from rvd_dynamics.link.models import Constant, Empirical, Gamma, LinkParams, Uniform
from rvd_dynamics.link.plan import draw_plan, intact_of_runs, LinkPlan

STEP_NS = 500_000_000
HOLD = 10                       # [steps]
STEPS = 401
ARRAYS = ('transit_ns', 'lost', 'damaged', 'damage', 'duplicated', 'outage')
FAULTS = {                      # setting: (value, the one array it may change)
    'loss_fraction': (0.3, 'lost'),
    'duplicate_fraction': (0.3, 'duplicated'),
    'corrupt_fraction': (0.3, 'damaged'),
    'reorder_fraction': (0.3, 'transit_ns'),
    'outage_windows_s': ((10.0, 20.0), 'outage'),
}
ALL_FAULTS = LinkParams(loss_fraction=0.1, duplicate_fraction=0.4, corrupt_fraction=0.2,
                        reorder_fraction=0.2, reorder_delay_s=0.7,
                        outage_windows_s=(10.0, 20.0, 90.0, 91.3))


def draw(params=LinkParams(), seed=1, steps=STEPS, step_ns=STEP_NS, hold=HOLD):
    return draw_plan(params, np.random.default_rng(seed), steps, step_ns, hold)


# nothing moves that need not

@pytest.mark.parametrize('fault', FAULTS)
def test_a_fault_switched_on_moves_no_other_draw(fault):
    value, changed = FAULTS[fault]
    nominal, faulty = draw(), draw(replace(LinkParams(), **{fault: value}))
    assert not np.array_equal(getattr(nominal, changed), getattr(faulty, changed))
    for name in ARRAYS:
        if name not in (changed, 'damage'):     # which damage has no meaning where there is none
            assert np.array_equal(getattr(nominal, name), getattr(faulty, name)), name


@pytest.mark.parametrize('fault', FAULTS)
def test_a_fault_switched_off_among_others_leaves_them_alone(fault):
    _, changed = FAULTS[fault]
    off = draw(replace(ALL_FAULTS, **{fault: getattr(LinkParams(), fault)}))
    full = draw(ALL_FAULTS)
    for name in ARRAYS:
        same = np.array_equal(getattr(off, name), getattr(full, name))
        assert same == (name != changed), name


def test_a_fault_of_zero_strength_is_the_nominal_run():     # P37: the injector is inert
    inert = LinkParams(reorder_fraction=1.0, reorder_delay_s=0.0, outage_windows_s=(7.0, 7.0))
    for name in set(ARRAYS) - {'damage'}:
        assert np.array_equal(getattr(draw(), name), getattr(draw(inert), name)), name
    assert not draw().damaged.any() and not draw(inert).damaged.any()


@pytest.mark.parametrize('model', [
    Constant(), Uniform(), Gamma(), Gamma(shape=0.5)], ids=lambda m: type(m).__name__)
def test_a_longer_run_begins_with_the_shorter_one(model):
    params = replace(ALL_FAULTS, model=type(model).__name__.lower(),
                     **{type(model).__name__.lower(): model})
    long, short = draw(params, steps=900), draw(params, steps=STEPS)
    for name in ARRAYS:
        assert np.array_equal(getattr(long, name)[:STEPS], getattr(short, name)), name


def test_the_model_moves_only_the_transits():
    gamma, uniform = draw(ALL_FAULTS), draw(replace(ALL_FAULTS, model='uniform'))
    assert not np.array_equal(gamma.transit_ns, uniform.transit_ns)
    for name in ARRAYS[1:]:
        assert np.array_equal(getattr(gamma, name), getattr(uniform, name)), name


def test_the_seed_decides_everything():
    one, again, other = draw(ALL_FAULTS, 5), draw(ALL_FAULTS, 5), draw(ALL_FAULTS, 6)
    for name in ARRAYS:
        assert np.array_equal(getattr(one, name), getattr(again, name)), name
    for name in ('transit_ns', 'lost', 'damaged', 'damage', 'duplicated'):
        assert not np.array_equal(getattr(one, name), getattr(other, name)), name


# the draws are what the settings say

def test_faults_happen_as_often_as_asked_and_independently():
    steps, asked = 40_000, np.array([0.1, 0.1, 0.2, 0.2, 0.2, 0.2, 0.4])
    nominal = draw(steps=steps)
    plan = draw(replace(ALL_FAULTS, outage_windows_s=(0.0, 0.0)), steps=steps)
    held_up = plan.transit_ns - nominal.transit_ns == 700_000_000
    events = np.column_stack([plan.lost, plan.damaged, held_up, plan.duplicated])
    bound = 4.5 / np.sqrt(steps)                                # 4.5 standard errors
    assert np.all(np.abs(events.mean(axis=0) - asked) < bound * np.sqrt(asked * (1 - asked)))
    correlation = np.corrcoef(np.column_stack([events, plan.damage, nominal.transit_ns]).T)
    assert np.abs(correlation - np.eye(11)).max() < bound


def test_transits_of_the_two_copies_are_independent_and_each_gamma():
    transit = draw(steps=40_000).transit_ns * 1e-9
    np.testing.assert_allclose(transit.mean(axis=0), 4.3, atol=4.5 * 0.2475 / 200)
    np.testing.assert_allclose(transit.std(axis=0), 0.2475, rtol=0.03)
    assert abs(np.corrcoef(transit.T)[0, 1]) < 4.5 / 200


def test_one_frame_in_a_hundred_is_erased_by_default():
    erased = 1 - draw(steps=200_000).intact_in_time.mean()
    assert erased == pytest.approx(0.010, abs=1e-3)


@given(start=st.integers(0, 60), length=st.integers(0, 60), step_ns=st.integers(1, 20),
       hold=st.integers(0, 3))
def test_an_outage_begins_with_its_start_and_is_over_at_its_end(start, length, step_ns, hold):
    window = (start * 1e-9, (start + length) * 1e-9)
    plan = draw(LinkParams(outage_windows_s=window), steps=30, step_ns=step_ns, hold=hold)
    instants = [k * step_ns for k in range(30)]
    assert list(plan.outage) == [start <= t < start + length for t in instants]


def test_several_outages_may_overlap_and_reach_beyond_the_run():
    plan = draw(LinkParams(outage_windows_s=(195.0, 300.0, 2.0, 4.0, 3.0, 5.0)))
    assert list(np.flatnonzero(plan.outage)) == list(range(4, 10)) + list(range(390, 401))
    assert not plan.intact_in_time[plan.outage].any()


@dataclass(frozen=True)
class Lossy:
    """A model that loses frames itself."""

    def delays(self, rng, size, hold_s):
        return np.where(rng.random(size) < 0.5, np.nan, 0.3 * hold_s)


def test_a_model_may_lose_frames_itself():
    class Params(LinkParams):
        delay_model = Lossy()
    plan = draw(Params())
    assert 100 < plan.lost[:, 0].sum() < 300
    assert np.array_equal(plan.intact_in_time, ~plan.lost[:, 0])


# the edge: transit = nT is in time, one nanosecond more is not (P6, L1)

@given(step_ns=st.integers(1, 1_000_000_000), hold=st.integers(0, 3600))
def test_a_transit_of_exactly_the_play_out_delay_is_in_time(step_ns, hold):
    params = LinkParams(model='constant', constant=Constant(transit_fraction=1.0),
                        reorder_delay_s=1e-9)
    on_the_edge = draw(params, steps=3, step_ns=step_ns, hold=hold)
    assert np.all(on_the_edge.transit_ns == hold * step_ns)
    assert on_the_edge.intact_in_time.all()
    beyond = draw(replace(params, reorder_fraction=1.0), steps=3, step_ns=step_ns, hold=hold)
    assert np.all(beyond.transit_ns == hold * step_ns + 1)
    assert not beyond.intact_in_time.any()


def test_measured_transits_meet_the_same_edge(tmp_path):
    path = tmp_path / 'edge.csv'
    for text, in_time in (('5.0', True), ('5.000000001', False), ('4.999999999', True)):
        path.write_text(text)
        params = LinkParams(model='empirical', empirical=Empirical(file=str(path)))
        assert draw(params).intact_in_time.all() == in_time


def test_measured_transits_are_kept_to_the_nanosecond(tmp_path):
    transits = np.random.default_rng(2).integers(0, 10**10, 300)
    path = tmp_path / 'ns.csv'
    path.write_text('\n'.join(f'{ns // 10**9}.{ns % 10**9:09d}' for ns in transits))
    drawn = draw(LinkParams(model='empirical', empirical=Empirical(file=str(path))), steps=5000)
    assert set(drawn.transit_ns.ravel()) == set(transits)


def test_a_direct_link_delivers_everything():
    assert draw(hold=0).intact_in_time.all()


# what a campaign reads: against an event queue

@pytest.mark.parametrize('hold', [0, 1, 4, 10])
@pytest.mark.parametrize('seed', range(6))
def test_erasures_are_those_of_an_event_queue(seed, hold):
    params = replace(ALL_FAULTS, gamma=Gamma(offset_fraction=0.3, scale_fraction=0.08))
    plan = draw(params, seed, steps=500, hold=hold)
    flight = fly(sendings_of(plan, [True] * 500, [False] * 500), hold, STEP_NS)
    intact = np.zeros(500, dtype=bool)
    for k, out in enumerate(flight.released):
        if out is not None:
            assert out[0] == k - hold                   # P1: exactly n steps after sending
            intact[out[0]] = not plan.damaged[out]
    known = 500 - hold                                  # the rest is not due before the end
    assert np.array_equal(plan.intact_in_time[:known], intact[:known])
    assert 0.3 < intact.mean() < 0.9                    # neither answer is the trivial one


def plan_of_one(transits, damaged_copies, duplicated=True):
    return LinkPlan(hold_ns=100, transit_ns=np.array([transits]), lost=np.zeros((1, 2), bool),
                    damaged=np.array([damaged_copies]), damage=np.zeros((1, 2)),
                    duplicated=np.array([duplicated]), outage=np.array([False]))


@pytest.mark.parametrize(('transits', 'damaged_copies', 'intact'), [
    ((60, 70), (True, False), False),       # the damaged one came first: the intact is dropped
    ((70, 60), (True, False), True),        # the intact one came first
    ((60, 60), (True, False), False),       # at one instant: the original counts
    ((60, 60), (False, True), True),
    ((60, 50), (False, True), False),
    ((101, 100), (True, False), True),      # the original is late, the copy is just in time
    ((101, 101), (False, False), False)])
def test_the_copy_that_comes_first_decides(transits, damaged_copies, intact):
    assert plan_of_one(transits, damaged_copies).intact_in_time[0] == intact


def test_a_copy_that_was_not_made_decides_nothing():
    assert plan_of_one((60, 50), (False, True), duplicated=False).intact_in_time[0]
    assert not plan_of_one((101, 50), (False, False), duplicated=False).intact_in_time[0]


# impossible input

@pytest.mark.parametrize(('name', 'value'), [
    ('mission_steps', 0), ('step_ns', 0), ('hold_steps', -1)])
def test_impossible_grids_are_refused_by_name(name, value):
    grid = {'mission_steps': 3, 'step_ns': 1, 'hold_steps': 1, name: value}
    with pytest.raises(ValueError, match=f'{name}.*{value}'):
        draw_plan(LinkParams(), np.random.default_rng(1), **grid)


# damage

@given(payload=st.binary(min_size=1, max_size=100), which=st.floats(0, 1, exclude_max=True))
def test_damage_is_a_short_burst_or_a_truncation(payload, which):
    result = damaged(payload, which)
    if len(result) < len(payload):
        assert payload.startswith(result)
        return
    assert len(result) == len(payload)
    flips = [i for i in range(8 * len(payload))
             if (payload[i // 8] ^ result[i // 8]) >> (i % 8) & 1]
    assert flips and flips[-1] - flips[0] < 32


def test_damage_has_both_kinds_and_reaches_every_byte():
    payload, uniforms = bytes(89), np.random.default_rng(1).random(4000)
    results = [damaged(payload, u) for u in uniforms]
    cut = [len(r) for r in results if len(r) < 89]
    assert 1800 < len(cut) < 2200 and set(cut) == set(range(89))
    touched = {i for r in results if len(r) == 89 for i, byte in enumerate(r) if byte}
    assert touched == set(range(89))


def test_nothing_cannot_be_damaged():
    assert damaged(b'', 0.7) == b''


def test_what_is_always_damaged_is_never_intact():
    assert not draw(LinkParams(corrupt_fraction=1.0)).intact_in_time.any()


@pytest.mark.parametrize('params', [LinkParams(), ALL_FAULTS, replace(LinkParams(),
                         outage_windows_s=(3.0, 9.0)), replace(LinkParams(), model='constant')])
def test_plans_of_many_runs_are_those_of_each_run(params):
    runs = [4, 0, 9]
    many = intact_of_runs(params, streams.generators(3, runs, 'link_back'), 3, 120, 500_000_000,
                          10)
    for ours, run in zip(many, runs):
        alone = draw_plan(params, streams.generator(3, run, 'link_back'), 120, 500_000_000, 10)
        assert np.array_equal(ours, alone.intact_in_time)
