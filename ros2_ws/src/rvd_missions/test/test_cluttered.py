"""The lunar approach among keep-out spheres: judged, flown, counted, drawn, refused."""

from pathlib import Path
import re

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.roster import MARKERS, Roster
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.geometry.cone import Cone
from rvd_dynamics.geometry.keep_out import Stop
from rvd_groundstation.console.provider import display_of
from rvd_missions.lunar_approach.cluttered import COLUMNS, interval, outcomes
from rvd_missions.lunar_approach.judge import Judge
from rvd_missions.lunar_approach.scene import scene
from rvd_missions.lunar_approach.settings import DockingParams, Obstacles

SCENARIOS = Path(__file__).parents[4] / 'scenarios'
TWO = load(SCENARIOS / 'cluttered.yaml')
ALONE = TWO.with_values('/**', operator='none')
PAPER = load(SCENARIOS / 'paper.yaml')
STOP = Stop(np.array([0.0185, 0.009, 0.009]), 2, np.zeros(3), 4.0, np.zeros(3), 10.0, 11.0)
ONE = Obstacles(number=1, radius_m=(0.4,), position_m=(-2.0, 0.0, 0.0))
TRUTH, PREDICTION = '/truth/relative_state', '/ground/prediction'


def judged(states, obstacles=ONE, timeout_s=200.0):
    """Judge states (steps, 6) of one run, half a second apart."""
    judge = Judge(Run(timeout_s=timeout_s), Cone(), DockingParams(), obstacles=obstacles, stop=STOP)
    states = np.asarray(states, dtype=float)
    judge.start(states[0])
    for k, state in enumerate(states[1:], 1):
        judge.advance(k, state, np.zeros(3))
    return judge.verdict()


def straight(start, velocity, steps):
    t = 0.5*np.arange(steps)[:, None]
    return np.hstack([np.array(start) + t*np.array(velocity),
                      np.broadcast_to(velocity, (steps, 3))])


# -- judged ----------------------------------------------------------------------------------------

def test_clearance_is_the_least_distance_from_the_surface_also_between_samples():
    v = judged(straight([-2.9, 0.45, 0.0], [0.25, 0.0, 0.0], 14))
    assert v.values['clearance_m'] == pytest.approx(0.05, abs=1e-9) and v.reason == ''
    # half a metre a step: the nearest point lies between two samples
    v = judged(straight([-2.75, 0.45, 0.0], [1.0, 0.0, 0.0], 4))
    assert v.values['clearance_m'] == pytest.approx(0.05, abs=1e-9)


def test_contact_ends_a_run_and_is_its_reason_whatever_came_before():
    v = judged(straight([-2.9, 0.3, 0.0], [0.25, 0.0, 0.0], 30))
    assert v.reason == 'contact' and not v.success and v.duration < 6.0
    outside = judged(straight([-2.9, 3.0, 0.0], [0.0, -0.5, 0.0], 5)[:, :])
    assert outside.reason == ''
    track = straight([-2.0, 3.0, 0.0], [0.0, -0.5, 0.0], 14)        # from outside the corridor
    assert judged(track).reason == 'contact'


def test_time_up_before_the_far_side_of_an_obstacle_is_a_deadlock_and_after_it_a_timeout():
    before = judged(straight([-2.7, 0.0, 0.0], [0.001, 0.0, 0.0], 21), timeout_s=10.0)
    after = judged(straight([-1.5, 0.0, 0.0], [0.001, 0.0, 0.0], 21), timeout_s=10.0)
    assert (before.reason, after.reason) == ('deadlock', 'timeout')


def test_without_obstacles_nothing_of_them_is_measured():
    judge = Judge(Run(), Cone(), DockingParams())
    assert not {'clearance_m', 'start_room_m'} & {m.name for m in judge.measures}
    assert 'contact' not in judge.reasons
    assert PAPER.part('stop') is None and scene(PAPER) is None


# -- where they are --------------------------------------------------------------------------------

def test_places_are_drawn_for_each_run_and_do_not_depend_on_what_else_flies():
    obstacles = TWO.part('obstacles')
    some, all_of = obstacles.places(7, [3, 8], (2,)), obstacles.places(7, range(10), (10,))
    assert_array_equal(some, all_of[[3, 8]])
    assert_array_equal(obstacles.places(7, [8], ()), some[1])
    more = TWO.with_values('/**', obstacles__number=4).part('obstacles')
    assert_array_equal(more.places(7, [3, 8], (2,))[:, :2], some)       # paired across the fields
    many = obstacles.places(1, range(4000), (4000,)) - obstacles.nominal
    np.testing.assert_allclose(many.std(axis=(0, 1)), [1.5, 0.25, 0.25], rtol=0.05)
    assert abs(many.mean()) < 0.03


def test_plant_judge_and_law_have_one_map():
    """
    The least clearance of a recorded flight, worked out from its track and the map.

    The judge looks between the samples, too: there it can be less by the sag of half a step.
    """
    flown = fly(TWO, [4, 11], record=[TRUTH])
    places = TWO.part('obstacles').places(TWO.run.seed, [4, 11], (2,))
    for row in range(2):
        track = flown.history[TRUTH].state[:flown.end_step[row] + 1, row, :3]
        gap = np.linalg.norm(track[:, None] - places[row], axis=-1) - TWO.part('obstacles').radii
        half = 0.5*np.linalg.norm(np.diff(track, axis=0), axis=-1).max()
        sag = half*half / (2.0*(TWO.part('obstacles').radii.min() + gap.min()))
        assert gap.min() - sag <= flown.verdict.values['clearance_m'][row] <= gap.min()


def test_a_row_of_a_batch_is_the_run_alone_to_the_bit():
    together = fly(TWO, range(4), record=[TRUTH])
    alone = fly(TWO, [2], record=[TRUTH])
    steps = int(alone.end_step[0]) + 1
    assert together.end_step[2] == alone.end_step[0] > 100
    assert_array_equal(together.history[TRUTH].state[:steps, 2], alone.history[TRUTH].state[:, 0])
    for name, values in alone.verdict.values.items():
        assert_array_equal(values[0], together.verdict.values[name][2], err_msg=name)


# -- flown -----------------------------------------------------------------------------------------

@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('operator', ['none', 'model'])
def test_predictions_are_off_by_less_than_the_box_that_the_stop_allows_for(operator):
    """
    Whether it is 4 sigma of an honest covariance and one lost command, or luck: without room for
    the command, predictions are off by more in one step of a hundred, and more.
    """
    scenario = TWO.with_values('/**', operator=operator).with_values(
        'auto_controller', barrier__around_m_s=0.0)
    flown = fly(scenario, range(40), record=[TRUTH, PREDICTION, f'{PREDICTION}.covariance'])
    made, ahead = flown.history[PREDICTION], scenario.part('legs').forward
    sigma = np.sqrt(np.diagonal(made.covariance, axis1=-2, axis2=-1))[:-ahead]
    state = made.state[:-ahead]
    live = (np.arange(len(state))[:, None] + ahead <= flown.end_step) & np.isfinite(sigma).all(-1)
    error = np.abs(state - flown.history[TRUTH].state[ahead:])
    sigma, state, error = (np.moveaxis(part[live], -1, 0) for part in (sigma, state, error))
    stop = scenario.part('stop')
    # where the stop ends is off by the error of the place, and of the rate for as long as it takes
    off = error[:3] + error[3:]*np.abs(state[3:])/stop.decelerations[:, None]
    assert (off < stop.box(sigma, state[3:])).all()
    no_losses = stop._replace(lost_m_s=np.zeros(3)).box(sigma, state[3:])
    assert (off > no_losses).mean() > 0.003


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('number', [2, 4])
@pytest.mark.parametrize('operator', ['none', 'model'])
def test_behind_the_delay_the_barrier_touches_nothing_from_feasible_starts(operator, number):
    """Noise, late and lost frames, scattered starts and maps as they come."""
    flown = fly(TWO.with_values('/**', operator=operator, obstacles__number=number), range(40))
    feasible = flown.verdict.values['start_room_m'] >= 0.0
    assert feasible.sum() > 15
    assert np.all(flown.verdict.values['clearance_m'][feasible] > 0.0)
    assert np.all(flown.verdict.reason[feasible] != 'contact')
    assert flown.verdict.success[feasible].mean() > 0.9


@pytest.mark.slow
@pytest.mark.patient
def test_without_the_barrier_most_pilots_touch_something():
    flown = fly(TWO.with_values('/**', mode='manual'), range(40))
    assert (flown.verdict.reason == 'contact').mean() > 0.4


# -- counted ---------------------------------------------------------------------------------------

def test_outcomes_are_those_of_feasible_starts_and_infeasible_ones_stand_apart():
    table = dict(zip(COLUMNS, (
        np.array([True, False, False, False, False, False]),
        np.array(['docked', 'contact', 'deadlock', 'timeout', 'left_corridor', 'contact']),
        np.array([1.0, 0.0, 2.0, 3.0, 0.1, -0.1]), np.array([0.3, -0.01, 0.2, 0.1, 0.4, -0.2]),
        np.array([0.5, 9.0, 9.0, 9.0, 9.0, 9.0]))))
    o = outcomes(table)
    assert (o.runs, o.infeasible, o.infeasible_contacts, o.feasible) == (6, 1, 1, 5)
    assert (o.docked, o.contacts, o.deadlocks, o.others) == (1, 1, 2, 1)
    assert o.delta_v_m_s == 0.5 and o.clearance_m == (-0.01, 0.2)


def test_intervals_are_those_of_wilson():
    from scipy.stats import binomtest
    for count, of in ((0, 300), (7, 90), (300, 300)):
        expected = binomtest(count, of).proportion_ci(method='wilson')
        assert interval(count, of) == pytest.approx((expected.low, expected.high), abs=1e-12)


# -- drawn -----------------------------------------------------------------------------------------

def test_console_and_markers_draw_the_spheres_of_the_run():
    scenario = TWO.with_values('/**', run=5)
    places = scenario.part('obstacles').places(scenario.run.seed, [5], ())
    spheres = scene(scenario).still
    assert_array_equal([s.place for s in spheres], places)
    assert [s.radius_m for s in spheres] == [0.4, 0.3]
    shown = display_of(scenario).display
    assert set(spheres) < set(shown.surfaces)
    assert 'clearance' in [i.label for i in shown.instruments.rows]
    assert as_data(shown)
    assert MARKERS in Roster(scenario).watchers


# -- refused ---------------------------------------------------------------------------------------

@pytest.mark.parametrize('section, values, words', [
    ('/**', {'obstacles__radius_m': [0.4, -0.3, 0.4, 0.3]},
     'obstacles.radius_m[1] must be above 0 and at most 1000, got -0.3'),
    ('/**', {'obstacles__position_m': [-0.2, 0.3, 0.0] + [-9.0, 0.0, 0.0]*3},
     'obstacles.position_m of obstacle 1 must be more than 0.7 m from the docking port, which it '
     'would overlap, got [-0.2, 0.3, 0.0]'),
    ('/**', {'obstacles__position_m': [-9.0, 0.0, 0.0, -30.1, 0.2, 0.0] + [-9.0, 0.0, 0.0]*2},
     'obstacles.position_m of obstacle 2 must be more than 0.3 m from the start, where the chaser '
     'is, got [-30.1, 0.2, 0.0]'),
    ('/**', {'obstacles__position_m': [-9.0, 0.0]},
     'must be 12 numbers, three for each of obstacles.radius_m'),
    ('/**', {'obstacles__number': 5},
     'obstacles.number must be at most the 4 that obstacles.radius_m lists, got 5'),
    ('/**', {'obstacles__scatter_m': [0.1, -0.1, 0.1]}, 'scatter_m[1] must not be negative'),
    ('/**', {'thrust__lateral_m_s2': [1e-4, 4e-4, 0.02]}, 'brake_level must give more than'),
    ('state_predictor', {'filter': 'scheduled'},
     'state_predictor: filter must be learned or adaptive'),
])
def test_what_cannot_be_flown_is_refused_in_one_line(section, values, words):
    with pytest.raises(BadInput, match=re.escape(words)) as refused:
        TWO.with_values(section, **values)
    assert '\n' not in str(refused.value)
