"""What the console tells a pilot: alarms of each mission, gates, and the section about a craft."""

import json

import numpy as np
import pytest

from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.geometry.cone import control_boundary, radius
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import display_of

MISSIONS = {
    'lunar_approach': 'operator: console', 'docking': 'mission: docking',
    'by hand': 'mission: docking, steering: remote, operator: console', 'tether': 'mission: tether',
    'tether_delay': 'mission: tether_delay', 'obstacle_field': 'mission: obstacle_field'}
ALARMED = {
    'lunar_approach': ['OUTSIDE THE CORRIDOR', 'LEAVING THE CORRIDOR', 'TOO FAST',
                       'TOO FAST SIDEWAYS', 'DRIFTING OUT WITHIN THE DELAY', 'NEAR THE WALL'],
    'docking': ['THE CRAFT HAS STOPPED THE APPROACH', 'OUTSIDE THE CONE', 'TOO FAST'],
    'by hand': ['THE CRAFT HAS STOPPED THE APPROACH', 'OUTSIDE THE CONE', 'TOO FAST'],
    'tether': ['TARGET OUT OF VIEW'], 'tether_delay': ['TARGET OUT OF VIEW'],
    'obstacle_field': ['AT AN OBSTACLE', 'HEADING FOR AN OBSTACLE']}
TELEMETRY, PREDICTION = '/ground/telemetry', '/ground/prediction'


def shown(name: str):
    return display_of(parse(f'/**: {{ros__parameters: {{{MISSIONS[name]}}}}}', 'test'))


@pytest.mark.parametrize('name', MISSIONS)
def test_a_mission_says_which_readings_are_alarms(name):
    display = shown(name).display
    assert [alarm.words for alarm in display.alarms][:len(ALARMED[name])] == ALARMED[name]
    json.dumps(as_data(display), allow_nan=False)


def derived(lunar, measured, predicted):
    def sample(state):
        return Sample(1, 0.0, True, {'position': list(state[:3]), 'velocity': list(state[3:])})
    return lunar.derive({TELEMETRY: sample(measured), PREDICTION: sample(predicted)})


def test_the_numbers_behind_the_alarms_of_the_lunar_approach():
    scenario = parse('/**: {ros__parameters: {operator: console}}', 'test')
    lunar, cone = display_of(scenario), scenario.part('cone')
    still = (-12.0, 0.1, 0.0, 0.25, 0.0, 0.0)
    made = derived(lunar, still, (-10.0, 0.5, 0.0, 0.25, 0.0, 0.0))
    boundary = float(control_boundary(-10.0, cone, scenario.part('orbit').mean_motion,
                                      scenario.part('approach_rate_m_s'), 10.0))
    assert made['room'] == pytest.approx(boundary - 0.5)
    assert made['leave_s'] > 0.0
    out = derived(lunar, still, (-10.0, 0.5, 0.0, 0.25, 0.2, 0.0))
    assert out['leave_s'] < made['leave_s'] and out['leave_s'] < 10.0


@pytest.mark.parametrize('offset, reach', [(0.1, 1.12), (1.5, 1.5*1.12), (40.0, 2.5)])
def test_the_section_reaches_to_a_craft_outside_within_reason(offset, reach):
    lunar = shown('lunar_approach')
    wall = float(radius(-10.0, parse('/**: {ros__parameters: {}}', 'test').part('cone')))
    state = np.array([-10.0, offset*wall, 0.0, 0.25, 0.0, 0.0])
    assert derived(lunar, state, state)['section_extent'] == pytest.approx(reach*wall)


def test_gates_are_ahead_of_the_start_and_narrow_towards_the_port():
    gates = shown('lunar_approach').display.guidance.gates
    assert [gate.at for gate in gates] == [20.0, 10.0, 5.0, 2.0]
    widths = [float(gate.wanted[0].split()[1]) for gate in gates]
    assert widths == sorted(widths, reverse=True)
    near = display_of(parse(
        '/**: {ros__parameters: {operator: console, start: {position_m: [-8.0, 0.0, 0.0]}}}',
        'test')).display.guidance.gates
    assert [gate.at for gate in near] == [5.0, 2.0]
