"""What a page is shown: signals, what is derived of them, and never the truth."""

from types import SimpleNamespace

import numpy as np
import pytest

from rvd_dynamics.diagram.display import DERIVED, TRUTH
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.geometry.cone import control_boundary, signed_distance
from rvd_dynamics.motion.cw import propagate
from rvd_groundstation.console.decode import Heard, Lost, Sample
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.protocol import encode
from rvd_groundstation.console.provider import display_of, facts_of, on_ground
from rvd_missions.lunar_approach import campaign_figures, figures
from rvd_missions.lunar_approach.display import LunarDisplay

SCENARIO = parse('/**: {ros__parameters: {operator: console}}', 'test')
FACTS, CONE = facts_of(SCENARIO), SCENARIO.part('cone')
LUNAR = display_of(SCENARIO)
PREDICTION, ESTIMATE = '/ground/prediction', '/ground/estimate'


def outlook(*state):
    return LUNAR.outlook(np.array(state))


def sample(step, t, position, velocity=(0.25, 0.0, 0.0), sigma=0.01):
    return Sample(step, t, True, {'position': list(position), 'velocity': list(velocity),
                                  'sigma': [sigma] * 6})


def command(step, value=(0, 0, 0), kind=0):
    return Sample(step, step * FACTS.step_s, True, {
        'value': list(value), 'kind': kind, 'by': 3, 'weight': 0.7, 'reason': 0,
        'sequence': step + 1})


def fed(steps=30):
    """Return a feed into which telemetry, estimate, prediction and commands have come."""
    feed = Feed(LUNAR)
    for k in range(steps + 1):
        t = k * FACTS.step_s
        if k >= 10:
            feed.telemetry(Heard(
                Sample(k, t - 5.0, True, {'position': [-30.0 + 0.25*(t - 5.0), 0.1, 0.0],
                                          'velocity': [0.25, 0.0, 0.0]}, t, 4.0),
                round((t - 5.0) * 1e9), max(k - 20, 0), 0))
            feed.signal(ESTIMATE, sample(k, t - 5.0, [-30.0 + 0.25*(t - 5.0), 0.1, 0.0]))
            feed.signal(PREDICTION, sample(k, t + 5.0, [-30.0 + 0.25*(t + 5.0), 0.1, 0.2]))
        feed.command(command(k))
    return feed


def test_the_mission_names_its_display():
    assert isinstance(LUNAR, LunarDisplay)
    assert (FACTS.forward_s, FACTS.back_s, FACTS.mode, FACTS.operator) == (
        5.0, 5.0, 'shared', 'console')
    assert FACTS.acknowledged


def test_the_console_hears_no_topic_that_carries_the_truth():
    for heard in (SCENARIO.diagram.externals[0].reads, on_ground(SCENARIO.diagram)):
        assert not [topic for topic in heard if topic.startswith(('/truth', '/onboard'))]


def test_what_is_displayed_is_what_the_console_hears():
    heard = {*SCENARIO.diagram.externals[0].reads, '/joy', DERIVED}
    assert set(LUNAR.display.parts()) - {TRUTH} <= heard


def test_the_reference_drift_leaves_the_corridor_where_the_paper_s_does():
    made = outlook(-30.0, 0.0, 0.0, 0.25, 0.0, 0.0)
    assert made['leave'] == pytest.approx(68.9, abs=0.1)
    assert made['plane'] == pytest.approx(120.0, abs=2.0)


@pytest.mark.parametrize('state', [
    [-20.0, 0.3, -0.2, 0.25, 0.01, -0.005], [-5.0, -0.2, 0.1, 0.24, 0.02, 0.03],
    [-12.0, 0.0, 0.5, 0.26, -0.03, 0.0]])
def test_the_time_left_is_where_the_drift_meets_the_wall(state):
    state = np.array(state)
    made = LUNAR.outlook(state)
    times = np.linspace(0.0, 240.0, 24001)
    path = propagate(state, SCENARIO.part('orbit').mean_motion, times)
    outside = times[signed_distance(path[:, :3], CONE) < 0.0]
    plane = times[path[:, 0] >= 0.0][0]
    assert made['plane'] == pytest.approx(plane, abs=0.05)
    if outside.size and outside[0] <= plane:
        assert made['leave'] == pytest.approx(outside[0], abs=0.1)
    else:
        assert made['leave'] is None


def test_who_is_outside_is_told_so():
    made = outlook(-10.0, 2.0, 0.0, 0.25, 0.0, 0.0)
    assert made['margin'] < 0.0 and made['leave'] == 0.0
    derived = LUNAR.derive({PREDICTION: sample(0, 0.0, [-10.0, 2.0, 0.0])})
    assert derived['leave'] == ['OUTSIDE', True] and derived['margin_predicted'] < 0.0


def test_the_surfaces_of_a_run_are_the_shared_mathematics():
    corridor, boundary = LUNAR.display.surfaces
    assert dict(corridor.rings)[-30.0] == pytest.approx(1.872, abs=1e-3)
    assert dict(boundary.rings)[-30.0] == pytest.approx(1.364, abs=1e-3)
    assert corridor.stations_m[-1] == boundary.stations_m[-1] == 0.0
    assert corridor.radii_m[-1] == boundary.radii_m[-1] == pytest.approx(0.3)
    at = dict(zip(np.round(boundary.stations_m, 6), boundary.radii_m))
    assert at[-30.0] == pytest.approx(1.364, abs=1e-3)


def test_a_frame_carries_its_three_clocks():
    frame = fed().frame()
    measured, predicted = (frame['signals'][name] for name in ('/ground/telemetry', PREDICTION))
    assert (measured['t'], measured['received'], predicted['t']) == (10.0, 15.0, 20.0)
    assert measured['transit'] == 4.0 and frame['t'] == 15.0
    assert TRUTH not in encode(frame)
    assert frame['signals'][DERIVED]['parts']['margin_predicted'] > 0


def test_what_is_derived_agrees_with_itself():
    derived = fed().derived()
    assert derived['aim'] == pytest.approx([0.0, 0.0, -0.2])
    assert derived['spread_prediction'] == pytest.approx(0.02)
    assert derived['section_note'] == ['at x = −25.0 m', False]
    slope = np.tan(np.radians(CONE.half_angle_deg))
    assert derived['section_wall'] == pytest.approx(0.3 + 25.0*slope)
    assert derived['wall_measured'] == pytest.approx(0.3 + 27.5*slope)
    assert derived['margin_measured'] == pytest.approx(
        (derived['wall_measured'] - 0.1) * np.cos(np.radians(CONE.half_angle_deg)))


def test_before_anything_is_known_every_derived_part_is_there_and_says_nothing():
    parts = Feed(LUNAR).derived()
    assert LUNAR.display.parts()[DERIVED] <= set(parts)
    always = {name for name in parts if name.startswith('section_')}      # where the run begins
    assert {name for name in parts if parts[name] is not None} == always


def test_an_invalid_prediction_is_not_derived_from():
    feed = fed()
    feed.signal(PREDICTION, Sample(31, 20.5, False, {'position': [np.nan]*3,
                                                     'velocity': [np.nan]*3}))
    assert feed.derived()['drift'] is None and feed.derived()['margin_measured'] is not None


def test_a_late_page_gets_the_trails_and_one_that_was_there_the_changes():
    feed = fed(60)
    rows = feed.trails['ahead']
    assert len(rows) == 51 and all(len(row) == 2 + 3 + 1 for row in rows)
    t, stamp, x, y, z, spread = rows[-1]
    assert (t, stamp) == (30.0, 35.0) and (x, y, z) == (-30.0 + 0.25*35.0, 0.1, 0.2)
    assert spread == pytest.approx(0.02)
    assert feed.trails['true_path'] == []
    version = feed.ladder.version
    feed.command(command(61, (1, -2, 3)))
    assert [row[-3:] for row in feed.frame(version)['ladder']
            if row[1] == 61] == [[1, -2, 3]]


def test_a_step_without_telemetry_is_a_gap_and_leaves_what_was_known():
    feed = fed()
    feed.telemetry(Lost(31, 'CHECKSUM'))
    frame = feed.frame()
    assert frame['gap'] == {'k': 31, 'why': 'CHECKSUM'}
    assert frame['signals']['/ground/telemetry']['t'] == 10.0


def test_nothing_due_is_a_gap_only_once_something_can_have_come_down():
    feed = Feed(LUNAR)
    feed.telemetry(Lost(FACTS.back_steps, 'EMPTY'))
    assert 'gap' not in feed.frame()
    feed.telemetry(Lost(FACTS.back_steps + 1, 'EMPTY'))
    assert feed.frame()['gap']['k'] == FACTS.back_steps + 1


def test_a_frame_holds_the_displayed_parts_and_no_other():
    frame = fed().frame()
    assert set(frame['signals'][ESTIMATE]['parts']) == {'position'}
    wanted = LUNAR.display.parts()
    for name, signal in frame['signals'].items():
        if name != DERIVED:
            assert set(signal['parts']) <= wanted[name], name
    assert len(encode(frame)) < 6000            # [bytes], with the whole ladder of 31 rungs


# -- the closing rate for which the control boundary is drawn ----------------------------------

@pytest.mark.parametrize('text, rate', [
    ('auto_controller: {ros__parameters: {corridor_apf: {closing_rate_m_s: 0.4}}}', 0.4),
    ('auto_controller: {ros__parameters: {law: damped_apf, damped_apf: {closing_rate_m_s: 0.1}}}',
     0.1),
    ('/**: {ros__parameters: {start: {velocity_m_s: [0.15, 0.0, 0.0]}}}\n'
     'auto_controller: {ros__parameters: {law: barrier}}', 0.15),
    ('/**: {ros__parameters: {start: {velocity_m_s: [0.0, 0.0, 0.0]}}}\n'
     'auto_controller: {ros__parameters: {law: none}}\n'
     'operator_model: {ros__parameters: {closing_rate_m_s: 0.2}}', 0.2),
    ('/**: {ros__parameters: {}}', 0.25)])
def test_page_figures_and_markers_draw_the_boundary_of_the_laws_own_rate(text, rate):
    scenario, x = parse(text, 'test'), np.linspace(-30.0, 0.0, 31)
    cone, orbit = scenario.part('cone'), scenario.part('orbit')
    right = control_boundary(x, cone, orbit.mean_motion, rate, scenario.part('leg_params').loop_s)
    assert scenario.part('approach_rate_m_s') == rate
    np.testing.assert_array_equal(display_of(scenario)._boundary(x), right)
    np.testing.assert_array_equal(figures._boundary(SimpleNamespace(scenario=scenario), x), right)
    np.testing.assert_array_equal(campaign_figures._boundary(scenario, x), right)


def test_markers_take_the_rate_of_the_scenario_unless_told_another():
    assert parse('/**: {ros__parameters: {}}', 'test').settings('markers').boundary_rate_m_s == 0.0
    with pytest.raises(ValueError, match='boundary_rate_m_s must be 0 or at least 0.01, got 0.005'):
        parse('markers: {ros__parameters: {boundary_rate_m_s: 0.005}}', 'test')
