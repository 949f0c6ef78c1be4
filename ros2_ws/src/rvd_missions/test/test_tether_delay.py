"""
The gripper behind a link: orders take effect late, plans come up in pieces, HOLD stands still.

One approach of 20 s is flown for many facts: from 40 m, HOLD ordered at 32 m, 2 s each way.
"""

from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import load
from rvd_missions.tether_delay import signals
from rvd_missions.tether_delay.commands import OrderForm
from rvd_missions.tether_delay.ground import FlightDirector
from rvd_missions.tether_delay.onboard import Store
from rvd_missions.tether_delay.settings import DirectorParams
from rvd_missions.tether_delay.signals import (
    ABORTED, ARRIVED, BRAKING, CRAFT, FLYING, GO, HOLD, LATCHED, SITUATION, STANDING, TRACKING,
    TRUTH, WAIT)

ROOT = Path(__file__).resolve().parents[4]
STEP = 0.1
SHORT = {'step_s': STEP, 'timeout_s': 80.0, 'approach__duration_s': [30.0, 30.0],
         'approach__baseline_m': 41.0, 'planner__nodes': 12, 'ground__solve_s': 1.0,
         'ground__lead_s': 1.0, 'ground__least_s': 20.0, 'forward_delay_s': 2.0,
         'back_delay_s': 2.0}
DIRECTOR = {'hold_range_m': 34.0, 'look_s': 2.0}
NOISE = {'encoder_sigma_m': 0.005, 'bearing_sigma_rad': 5e-4, 'attitude_sigma_rad': 5e-4}
KEPT = [TRUTH.name, CRAFT.name, SITUATION.name, TRACKING.name]


def flown(runs=(0,), schedule=(), shared=None, record=KEPT, **sections):
    scenario = load(ROOT / 'scenarios' / 'tether_delay.yaml').with_values(
        '/**', **{**SHORT, **(shared or {})})
    for section, values in {'flight_director': DIRECTOR, **sections}.items():
        scenario = scenario.with_values(section, **values)
    return fly(scenario, runs=runs, schedule=schedule, record=record)


@lru_cache(maxsize=None)
def approach():
    """Three runs with noise, HOLD and a new plan."""
    return flown(range(3), gripper_sensors=NOISE)


def first(history, what, row=0):
    """Return the first step in which a gripper does something."""
    return int(np.flatnonzero(history[CRAFT.name].doing[:, row] == what)[0])


# -- a flight --------------------------------------------------------------------------------------

def test_each_run_is_released_held_planned_anew_and_arrives():
    batch = approach()
    assert (batch.verdict.reason == 'arrived').all() and (batch.columns['plans'] == 2).all()
    assert batch.columns['miss_m'].max() < 0.05
    for row in range(3):
        doing = batch.history[CRAFT.name].doing[:, row]
        order = doing[np.flatnonzero(np.diff(doing, prepend=255))]
        assert order.tolist() == [LATCHED, FLYING, BRAKING, STANDING, FLYING, ARRIVED]


def test_an_order_acts_after_both_legs_and_the_reaction():
    """HOLD is seen at 34 m, acts a back leg, a reaction and a forward leg later, at plan speed."""
    batch = approach()
    truth, shown = batch.history[TRUTH.name], batch.history[SITUATION.name]
    for row in range(3):
        seen = int(np.flatnonzero(shown.range[:, row] <= 34.0)[0])
        acts = first(batch.history, BRAKING, row)
        far = np.linalg.norm(truth.target[:, row], axis=-1)
        assert far[seen - 20] == pytest.approx(34.0, abs=0.15)              # 2 s before it is seen
        assert 2.1 <= (acts - seen)*STEP <= 2.1 + 2.0           # up, and a median reaction of 0.5
        assert batch.columns['told_range_m'][row] == far[acts]
    assert np.ptp([first(batch.history, BRAKING, row) for row in range(3)]) > 0   # reactions differ


def test_a_gripper_on_hold_stands_on_a_taut_tether():
    batch = approach()
    truth, doing = batch.history[TRUTH.name], batch.history[CRAFT.name].doing
    for row in range(3):
        standing = np.flatnonzero(doing[:, row] == STANDING)
        speed = np.linalg.norm(truth.state[standing, row, 3:6], axis=-1)
        assert speed[20:].max() < 0.06 and speed[20:].mean() < 0.03
        assert np.ptp(truth.target[standing[20:], row, 0]) < 0.15
        assert truth.tension[standing, row].min() >= 0.02
    assert (batch.verdict.values['tension_N'] >= 0.02).all()


def test_it_is_pulled_back_by_nothing_but_the_least_tension_that_its_thrusters_answer():
    truth, doing = (approach().history[s.name] for s in (TRUTH, CRAFT))
    standing = np.flatnonzero(doing.doing[:, 0] == STANDING)[1:]
    assert_allclose(truth.applied[standing, 0, 0], 0.02, atol=1e-12)
    assert truth.applied[standing, 0, 1].mean() == pytest.approx(0.02, abs=0.05)


def test_a_run_is_the_same_alone_and_in_a_batch():
    alone = flown([2], gripper_sensors=NOISE)
    for signal, part in ((TRUTH, 'state'), (TRACKING, 'planned')):
        there = getattr(approach().history[signal.name], part)[:, 2]
        assert_array_equal(there, getattr(alone.history[signal.name], part)[:, 0])


def test_on_the_latch_the_gripper_turns_with_the_baseline():
    truth = approach().history[TRUTH.name]
    held = np.arange(first(approach().history, FLYING))
    place, target = truth.state[held, 0, :3], truth.target[held, 0] + truth.state[held, 0, :3]
    assert_allclose(np.cross(place, target), 0.0, atol=1e-9)
    assert_allclose(np.linalg.norm(place, axis=-1), 1.0, atol=1e-12)
    assert_allclose(np.gradient(place, STEP, axis=0)[1:-1], truth.state[held[1:-1], 0, 3:6],
                    atol=1e-9)


def test_what_is_said_to_lie_ahead_is_where_an_order_would_act():
    batch = approach()
    shown, truth = batch.history[SITUATION.name], batch.history[TRUTH.name]
    at = first(batch.history, FLYING) + 30
    far = np.linalg.norm(truth.target[at + 20, 0])                  # forward leg: 2 s
    assert shown.ahead[at, 0] == pytest.approx(far, abs=0.1)
    assert shown.range[at, 0] > far + 2.0


# -- what may go wrong -----------------------------------------------------------------------------

def test_an_abort_stands_for_good_and_one_before_the_release_keeps_the_latch_closed():
    under_way = flown(schedule=[Change(150, abort=True)])
    doing, truth = (under_way.history[s.name] for s in (CRAFT, TRUTH))
    acts = first(under_way.history, ABORTED)
    assert 150 < acts <= 150 + 21                   # expedited: no later than its play-out
    assert (doing.doing[acts:, 0] == ABORTED).all()
    assert np.linalg.norm(truth.state[acts + 200:, 0, 3:6], axis=-1).max() < 0.02
    assert (truth.tension[:, 0] >= 0.02).all()
    before = flown(schedule=[Change(20, abort=True)], shared={'timeout_s': 30.0})
    assert (before.history[CRAFT.name].doing == LATCHED).all()


def test_a_person_who_holds_keeps_the_latch_closed_until_go():
    batch = flown(schedule=[Change(0, mode='hold'), Change(100, mode='go')],
                  shared={'timeout_s': 40.0})
    assert batch.columns['released_s'][0] > 10.0 + 2.0 + 1.0
    assert batch.columns['released_s'][0] % 1.0 == pytest.approx(0.0, abs=1e-9)


def test_a_plan_comes_up_whole_over_a_link_that_loses_a_fifth():
    lossy = {'loss_fraction': 0.2}
    batch = flown(range(2), shared={'timeout_s': 90.0}, link_forward=lossy, link_back=lossy)
    assert (batch.columns['plans'] == 2).all() and (batch.verdict.reason == 'arrived').all()


def test_where_no_plan_can_be_made_the_gripper_stays_on_hold(monkeypatch):
    from rvd_missions.tether_delay import planning

    def none(*_):
        raise BadInput('plan infeasible')
    monkeypatch.setattr(planning.Preparation, 'onward', none)
    batch = flown(shared={'timeout_s': 50.0})
    assert batch.history[SITUATION.name].refused[-1, 0] > 0
    assert batch.history[CRAFT.name].doing[-1, 0] == STANDING


# -- a new plan in flight ------------------------------------------------------------------------

ANEW = {'ground__replan_m': 0.3, 'ground__least_s': 16.0, 'ground__solve_s': 0.5,
        'ground__lead_s': 0.3, 'timeout_s': 45.0}
FAST = {'velocity_error_m_s': [0.5, 0.03, -0.03]}       # of the release
NO_HOLD = {'hold_range_m': 0.0}


def anew(runs=(0,), **sections):
    return flown(runs, shared=ANEW, **{
        'gripper_dynamics': FAST, 'flight_director': NO_HOLD, **sections})


def test_one_that_has_strayed_joins_a_new_plan_in_flight_and_saves_thrust():
    """Two legs of 2 s: where the gripper will be when the plan begins is known to 3 cm."""
    flown_on = flown(shared={**ANEW, 'ground__replan_m': 0.0}, gripper_dynamics=FAST,
                     flight_director=NO_HOLD)
    batch = anew()
    doing = batch.history[CRAFT.name].doing[:, 0]
    order = doing[np.flatnonzero(np.diff(doing, prepend=255))]
    assert order.tolist() == [LATCHED, FLYING, ARRIVED]         # it never stopped
    assert batch.columns['plans'][0] == 2 and flown_on.columns['plans'][0] == 1
    assert batch.verdict.reason[0] == 'arrived' and batch.columns['miss_m'][0] < 0.05
    assert batch.verdict.values['fuel_N_s'][0] < 0.8*flown_on.verdict.values['fuel_N_s'][0]
    assert (batch.verdict.values['tension_N'] >= 0.02).all()
    # where it is against where the new plan begins, by truth and tracking
    plan = batch.history[CRAFT.name].plan[:, 0]
    at = int(np.flatnonzero(plan == 2)[0])
    told, truth = batch.history[TRACKING.name], batch.history[TRUTH.name]
    seen = truth.target[at, 0]
    assert told.range[at, 0] == pytest.approx(np.linalg.norm(seen), abs=0.03)
    assert_allclose(told.planned[at, 0, 1:3], [np.arctan2(seen[1], seen[0]), np.arctan2(
        seen[2], np.hypot(seen[0], seen[1]))], atol=1e-3)
    assert batch.columns['joined_m'][0] < 0.03
    # the plan before would have had it somewhere else
    old = flown_on.history[TRACKING.name].range[at, 0]
    assert abs(old - told.range[at, 0]) > 0.5


def test_with_noise_a_new_plan_in_flight_is_the_same_alone_and_in_a_batch():
    batch, alone = anew(range(2), gripper_sensors=NOISE), anew([1], gripper_sensors=NOISE)
    assert (batch.columns['plans'] >= 2).all() and (batch.verdict.reason == 'arrived').all()
    assert np.nanmax(batch.columns['joined_m']) < 0.2
    assert_array_equal(batch.history[TRUTH.name].state[:, 1], alone.history[TRUTH.name].state[:, 0])


def test_where_there_is_no_plan_in_flight_the_one_before_is_flown_on(monkeypatch):
    from rvd_missions.tether_delay import planning

    def none(*_):
        raise BadInput('plan infeasible')
    monkeypatch.setattr(planning.Preparation, 'in_flight', none)
    batch = anew()
    assert batch.history[SITUATION.name].refused[-1, 0] > 0
    assert batch.columns['plans'][0] == 1 and batch.verdict.reason[0] == 'arrived'


def prepared():
    return load(ROOT / 'scenarios' / 'tether_delay.yaml').with_values('/**', **SHORT).part(
        'preparation')


def test_a_plan_in_flight_begins_within_the_bounds_of_its_angles():
    """0.1 rad each; the target is 40 m on along x."""
    start = np.array([1.0, 0.0, 0.0, *np.zeros(9)])
    assert prepared().within(start, 0.0)
    for at, least, most in ((7, 0.09, 0.097), (8, -0.09, -0.097), (1, 3.6, 3.95), (2, -3.6, -3.95)):
        inside, outside = start.copy(), start.copy()
        inside[at], outside[at] = least, most
        assert prepared().within(inside, 0.0) and not prepared().within(outside, 0.0)


def test_a_plan_in_flight_that_rolls_out_of_the_reach_of_the_law_is_refused(monkeypatch):
    from rvd_missions.tether_delay import planning
    states, asked = np.zeros((14, 12)), []
    states[:, 0] = np.linspace(1.0, 21.0, 14)
    before = planning.Plan(5.0, 35.0, states, np.full((12, 7), 0.5))
    rolls = planning.Plan(12.0, 35.0, states.copy(), before.controls)

    def solve(*given, guess):
        asked.append((*given, guess))
        return rolls
    monkeypatch.setattr(planning.optimum, 'solver', lambda *_: SimpleNamespace(solve=solve))
    assert prepared().in_flight(before.state_at(12.0), 12.0, before) is rolls
    rolls.states[6, 6] = 0.6
    with pytest.raises(BadInput, match='roll by at most 0.5 rad, and rolls by 0.6'):
        prepared().in_flight(before.state_at(12.0), 12.0, before)
    _, _, duration, begin, guess = asked[0]
    assert duration == (23.0, 23.0) and begin == 12.0           # to the end of the plan before
    assert_allclose(guess.states, before.state_at(guess.state_s), atol=1e-12)   # what is left of it


def test_a_hold_after_a_new_plan_in_flight_still_stands_and_is_planned_on_from():
    batch = flown(shared={**ANEW, 'timeout_s': 90.0}, gripper_dynamics=FAST,
                  flight_director={**DIRECTOR, 'hold_range_m': 28.0})
    doing = batch.history[CRAFT.name].doing[:, 0]
    order = doing[np.flatnonzero(np.diff(doing, prepend=255))]
    assert order.tolist() == [LATCHED, FLYING, BRAKING, STANDING, FLYING, ARRIVED]
    assert batch.columns['plans'][0] == 3 and batch.verdict.reason[0] == 'arrived'


# -- pieces ----------------------------------------------------------------------------------------

@settings(max_examples=50)
@given(st.permutations(range(2, 9)), st.lists(st.booleans(), min_size=40, max_size=40))
def test_a_plan_is_complete_when_each_point_has_come_in_any_order(order, lost):
    store, rng = Store(1, 7), np.random.default_rng(0)
    points = rng.normal(size=(9, 24))
    points[:, 0], points[:, 1], points[:, 2], points[:, 3], points[:, 4] = GO, 1, range(9), 5., 9.
    sent = [*order, 0, 1]
    had = set()
    for i in range(40):
        at = sent[i % 9]
        done = store.take(np.array([not lost[i]]), points[at][np.newaxis])
        new = not lost[i] and at not in had
        had |= set() if lost[i] else {at}
        assert (len(done) == 1) == (new and len(had) == 9)
    if len(had) == 9:
        plan = store.plan(0)
        assert (plan.begin_s, plan.end_s) == (5.0, 9.0)
        assert_array_equal(plan.states, points[:, 5:17])
        assert_array_equal(plan.controls, points[1:-1, 17:])
        newer = points.copy()
        newer[:, 1] = 2
        came = np.array([True])
        done = [len(store.take(came, newer[[i]])) for i in range(9)]
        assert done == [0]*8 + [1]                                # not one of the old points counts
        assert not len(store.take(came, points[[4]])) and store.number[0] == 2


def test_the_director_orders_in_turn_after_its_reaction():
    director = FlightDirector(DirectorParams(go_s=1.0, hold_range_m=50.0, look_s=2.0,
                                             reaction_s=0.5, abort_range_m=30.0),
                              Run(step_s=0.1, timeout_s=100.0), np.zeros((1, 4)), (1,))

    def told(k, far, doing):
        said = SimpleNamespace(range=np.array([far]), ahead=np.array([far - 20.0]),
                               doing=np.array([doing], dtype=np.uint8))
        made = director.step(k, said)['decision']
        return int(made.order[0]), bool(made.abort[0])
    assert [told(k, 99.0, LATCHED)[0] for k in (0, 10, 14, 15)] == [WAIT, WAIT, WAIT, GO]
    assert [told(k, 50.0, FLYING)[0] for k in (20, 24, 25)] == [GO, GO, HOLD]
    assert [told(k, 48.0, STANDING)[0] for k in (30, 54, 55)] == [HOLD, HOLD, GO]
    assert [told(k, 29.0, FLYING) for k in (60, 64, 65)] == [(GO, False), (GO, False), (GO, True)]


@pytest.mark.parametrize('numbers, legal', [
    ([GO, 1, 3], True), ([WAIT, 0, 0], True), ([HOLD + 1, 1, 0], False), ([GO, -1, 0], False),
    ([GO, 1, 0.5], False), ([np.nan, 0, 0], False)])
def test_an_order_from_the_wire_is_one_of_the_three(numbers, legal):
    sent = [*map(float, numbers), *[0.0]*(signals.ORDER_WIDTH - 3)]
    form = OrderForm()
    assert form.legal(sent) == legal
    assert form.wire.unpack(form.wire.pack(*sent))[1:3] == tuple(sent[1:3])


def test_an_abort_that_brakes_less_than_a_hold_is_refused():
    with pytest.raises(BadInput, match='hold.abort_m_s2 must not be below .* 0.05, got 0.01'):
        flown(shared={'hold__abort_m_s2': 0.01})
