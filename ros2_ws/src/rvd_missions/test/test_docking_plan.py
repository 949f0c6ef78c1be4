"""
The ground's plans in the mission docking: optimum, packets, replanning, flights, refusals.
"""

from pathlib import Path

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, parse
from rvd_missions.docking import planning
from rvd_missions.docking.planning import KNOTS, Memory, packets, PACKET

ROOT = Path(__file__).resolve().parents[4]
GUIDANCE, TRUTH, PLAN = '/onboard/guidance', '/truth/spacecraft', '/onboard/plan'
J, TF = 0.0201371647, 80.37307707               # of the specification, section 6


def scenario(planner='pseudospectral', sections=None, **shared):
    made = load(ROOT / 'scenarios' / 'docking.yaml').with_values('/**', planner=planner, **shared)
    for section, values in (sections or {}).items():
        made = made.with_values(section, **values)
    return made


def preparation(planner='pseudospectral', **shared):
    return scenario(planner, **shared).part('preparation')


def test_the_missions_optimum_is_that_of_the_specification():
    found = preparation().nominal
    assert found.duration_s == pytest.approx(TF, abs=1e-7)
    assert found.cost == pytest.approx(J, abs=1e-10)
    other = preparation('polynomial').nominal
    assert J < other.cost < 1.001*J


def test_a_plan_is_made_once_for_a_process(monkeypatch):
    """However many blocks, rows and scenarios ask for it."""
    first = preparation().nominal
    monkeypatch.setattr(planning, 'maker', None)        # nobody may plan from here on
    assert preparation().nominal is first
    assert preparation(seed=7, timeout_s=200.0).nominal is first


def test_a_plan_from_elsewhere_begins_from_the_nominal_one():
    """1 cm/s and 3 cm off: fewer iterations than from a straight line, and the same optimum."""
    made = preparation()
    state = np.array([-5.97, 0.17, -0.15, 0.01, 0.0, -0.01])
    warm = made.anew(state)
    cold = made.maker.plan(planning.Ends(state, planning.goal(made.aim)))
    assert warm.cost == pytest.approx(cold.cost, rel=1e-7)
    assert warm.plan.iterations < cold.plan.iterations
    assert_allclose(warm.at(0.0)[0], state, atol=1e-12)


# -- packets ---------------------------------------------------------------------------------------

def received(order, sent, rows=1):
    memory = Memory(rows)
    for i in order:
        memory.take(np.tile(sent[i], (rows, 1)), np.ones(rows, dtype=bool))
    return memory


@pytest.mark.parametrize('planner', ['polynomial', 'pseudospectral'])
def test_the_cubics_on_board_are_the_plan(planner):
    plan = preparation(planner).nominal
    memory = received(range(KNOTS), packets(plan, 5.0, 1))
    for t in np.linspace(0.0, plan.duration_s, 301):
        place, speed = memory.at(5.0 + t)
        state, _ = plan.at(t)
        assert_allclose(place[0], state[:3], atol=1e-6)
        assert_allclose(speed[0], state[3:], atol=1e-6)
    for t in (0.0, 500.0):                              # before it begins, after it ends
        place, speed = memory.at(t)
        assert_allclose(place[0], plan.at(0.0 if t < 5.0 else plan.duration_s)[0][:3], atol=1e-9)
        assert_allclose(speed, 0.0, atol=1e-9)


@given(st.permutations(range(KNOTS)), st.sets(st.integers(0, KNOTS - 1), max_size=20))
def test_packets_may_be_lost_and_come_in_any_order(order, lost):
    rng = np.random.default_rng(1)
    sent = np.column_stack([np.ones(KNOTS), np.arange(KNOTS), np.linspace(0, 9, KNOTS),
                            rng.normal(size=(KNOTS, 6))])
    memory = received([i for i in order if i not in lost], sent)
    assert np.isnan(memory.at(4.0)[0]).all() == bool(lost)
    for i in lost:
        memory.take(sent[i][None], np.array([True]))
    whole = received(range(KNOTS), sent)
    assert np.array_equal(memory.at(4.0), whole.at(4.0))


def test_a_newer_plan_counts_once_it_is_whole_and_an_older_one_never_again():
    old, new = (np.full((KNOTS, PACKET), float(n)) for n in (1, 2))
    for sent in (old, new):
        sent[:, 1], sent[:, 2] = np.arange(KNOTS), np.linspace(0.0, 9.0, KNOTS)
        sent[:, 6:] = 0.0
    memory = received([*range(KNOTS)], old)
    yes = np.array([True])
    for i in range(KNOTS - 1):
        memory.take(new[i][None], yes)
        memory.take(old[i][None], yes)
    assert memory.at(3.0)[0][0, 0] == 1.0
    memory.take(new[-1][None], yes)
    assert memory.at(3.0)[0][0, 0] == 2.0
    memory.take(new[0][None], np.array([False]))
    assert memory.at(3.0)[0][0, 0] == 2.0


# -- flights ---------------------------------------------------------------------------------------

def test_the_plan_comes_up_through_delay_and_loss_and_is_followed():
    """1 s each way and a fifth of the frames lost; the craft stays until the plan is whole."""
    flown = fly(scenario(timeout_s=4.0, limits__from_s=1.0, forward_delay_s=1.0, back_delay_s=1.0,
                         sections={'link_forward': {'loss_fraction': 0.2}}), range(2),
                record=[GUIDANCE, TRUTH, PLAN])
    guided, came = flown.history[GUIDANCE], flown.history[PLAN].received
    known = np.isfinite(guided.reference[..., 0])
    for row in range(2):
        first = int(np.flatnonzero(known[:, row])[0])
        assert first > 100 + KNOTS                      # more than a round, as some were lost
        there = [{(k - 100) % KNOTS for k in np.flatnonzero(came[:end, row])}
                 for end in (first - 1, first)]         # a packet is read a step after it came
        assert len(there[0]) == KNOTS - 1 and len(there[1]) == KNOTS
        assert not flown.history[TRUTH].thrust[:first + 1, row, 1:13].any()        # those of J2
        assert known[first:, row].all()
    place, _ = preparation().nominal.at(3.9)
    assert_allclose(guided.reference[390], [place[:3]]*2, atol=1e-6)


def test_planning_anew_begins_where_each_craft_is_and_alone_or_together_is_the_same():
    made = scenario(timeout_s=2.5, limits__from_s=1.0, closing__replan_s=1.0,
                    start__position_sigma_m=0.05, seeing__camera='simple')
    together = fly(made, [0, 3], record=[GUIDANCE, TRUTH])
    guided, truth = together.history[GUIDANCE], together.history[TRUTH]
    before, after = (np.abs(guided.reference[k] - truth.position[k]).max() for k in (90, 200))
    assert before > 0.03 > 0.02 > after
    alone = fly(made, [3], record=[GUIDANCE])
    assert np.array_equal(alone.history[GUIDANCE].reference[:, 0], guided.reference[:, 1],
                          equal_nan=True)


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('planner', ['polynomial', 'pseudospectral'])
def test_a_flight_along_a_plan_of_the_ground_hovers(planner):
    flown = fly(scenario(planner, timeout_s=95.0, seeing__camera='simple'), range(1))
    v = flown.verdict.values
    assert flown.verdict.success.all(), (flown.verdict.reason, v)
    assert np.all(v['settled_s'] < 80.0) and np.all(flown.columns['safety_state'] == 0)
    assert np.all(np.abs(v['closing_speed_m_s'] - 0.0547) < 0.003)       # the plan's, section 6
    assert np.all(v['propellant_kg'] < 0.16)


# -- refusals --------------------------------------------------------------------------------------

@pytest.mark.parametrize('planner, limits, words', [
    ('pseudospectral', {'max_speed_m_s': 0.02}, 'speed must be at most 0.02 m/s'),
    ('polynomial', {'view_half_angle_deg': 4.0}, 'cone of view'),
    ('polynomial', {'keep_out_radius_m': 3.2}, 'keep-out breaks its limit of 3.2'),
    ('polynomial', {'duration_s': [90.0, 120.0]}, 'aim.nominal_s must be between 90 and 120')])
def test_a_plan_that_cannot_be_names_the_constraint_in_one_line(planner, limits, words):
    with pytest.raises(BadInput, match=words) as refused:
        fly(scenario(planner, timeout_s=6.0, limits__from_s=1.0,
                     **{f'closing__{name}': value for name, value in limits.items()}), range(1))
    assert '\n' not in str(refused.value)


def test_the_default_has_no_ground():
    names = {block.name for block in parse(
        '/**: {ros__parameters: {mission: docking}}', 'x').diagram.blocks}
    assert 'closing_planner' not in names and 'link_forward' not in names
