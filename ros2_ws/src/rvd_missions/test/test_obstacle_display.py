"""What console, report and tables are shown of the approach among obstacles."""

from pathlib import Path

import numpy as np
import pytest

from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.roster import MARKERS, Roster
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.history import everything, of_history
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.protocol import encode
from rvd_groundstation.console.provider import display_of
from rvd_missions.obstacle_field.figures import FIGURES

SCENARIOS = Path(__file__).parents[4] / 'scenarios'
STATIC = load(SCENARIOS / 'obstacles.yaml')
STATES = [50.0, -10.0, -25.0, 0.0, 0.0, 0.0, *np.arange(18.0)]


def sample(**parts):
    return Sample(3, 3.0, True, parts)


def test_telemetry_is_the_chaser_and_the_places_of_the_obstacles():
    shown = display_of(STATIC).measured(STATES)
    assert shown == {'position': [50.0, -10.0, -25.0], 'velocity': [0.0, 0.0, 0.0],
                     'obstacle_1': [0.0, 1.0, 2.0], 'obstacle_2': [6.0, 7.0, 8.0],
                     'obstacle_3': [12.0, 13.0, 14.0]}


def test_clearance_speed_limit_and_alarms_are_derived():
    display = display_of(STATIC.with_values('/**', speed_corridor__form='linear'))
    around = np.zeros((3, 6))
    around[:, 0] = [6.0, 20.0, 30.0]
    made = display.derive({
        '/ground/telemetry': sample(**display.measured([10.0, 0, 0, 0, 0, 0, *around.ravel()])),
        '/ground/prediction': sample(position=[9.0, 0.0, 0.0], velocity=[-0.1, 0.0, 0.0]),
        '/ground/obstacles': sample(obstacles=around.ravel().tolist()),
        '/ground/alarm': sample(on=[1.0, 0.0, 1.0])})
    assert made['clearance_measured'] == pytest.approx(4.0 - 1.6)
    assert made['clearance_predicted'] == pytest.approx(3.0 - 1.6)
    assert made['limit_measured'] == pytest.approx(5e-4 + 0.005*8.0)
    assert made['alarms'] == 2.0 and made['obstacle_2'] == [20.0, 0.0, 0.0]
    assert display.derive({})['clearance_measured'] is None


@pytest.mark.parametrize('number', [0, 1, 3])
@pytest.mark.parametrize('form', ['continuous', 'rate_limited', 'bang_bang', 'pulses'])
def test_every_display_is_data_with_a_sphere_for_each_obstacle(number, form):
    scenario = STATIC.with_values('/**', obstacles__number=number, thrust__form=form)
    data = as_data(display_of(scenario).display)
    assert sum(s['name'].startswith('obstacle') for s in data['surfaces']) == number
    assert encode(data)
    watcher = Roster(scenario).watchers[MARKERS]
    assert ('/ground/obstacles' in watcher.reads) == (number > 0)


@pytest.mark.parametrize('number', [0, 3])
def test_figures_of_a_run_are_drawn(number):
    scenario = STATIC.with_values('/**', obstacles__number=number, timeout_s=120.0)
    run = of_history(scenario, fly(scenario, [0], record=everything(scenario)))
    for name, figure in FIGURES.items():
        assert not figure.missing(run)
        assert figure.draw(run).axes or (name == 'alarms' and not number)
