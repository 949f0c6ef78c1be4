"""What console and report are shown of the tethered gripper."""

from pathlib import Path

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.history import everything, of_history
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.protocol import encode
from rvd_groundstation.console.provider import display_of
from rvd_missions.tether import geometry
from rvd_missions.tether.figures import FIGURES
from rvd_missions.tether.signals import SITUATION, TRUTH
from rvd_missions.tether_delay.signals import ABORTED, BRAKING, FLYING, LATCHED, STANDING

SCENARIO = load(Path(__file__).parents[4] / 'scenarios' / 'tether.yaml').with_values(
    '/**', step_s=0.1, timeout_s=20.0, approach__duration_s=[20.0, 20.0],
    approach__baseline_m=41.0, planner__nodes=12)


@pytest.fixture(scope='module')
def flown():
    return fly(SCENARIO, [0], record=everything(SCENARIO))


def test_the_ground_places_the_gripper_where_it_is_but_for_its_range(flown):
    """The direction is measured, the range is planned: the error is along the line of sight."""
    said, truth = flown.history[SITUATION.name], flown.history[TRUTH.name]
    gripper, sight = truth.state[:, 0, :3], truth.target[:, 0]
    off = said.gripper[:, 0] - gripper
    length = np.linalg.norm(sight, axis=-1, keepdims=True)
    assert_allclose(np.cross(off, sight/length), 0.0, atol=1e-9)
    assert np.abs(off).max() < 1.0
    assert_allclose(said.target[:, 0], gripper + sight, atol=1e-9)
    assert_allclose(said.sight_angle[:, 0],
                    geometry.sight_angle(truth.state[:, 0, 6:10], sight), atol=1e-9)


def test_the_display_is_data_and_draws_tether_sight_and_cone():
    display = display_of(SCENARIO)
    assert encode(as_data(display.display))
    made = display.derive({SITUATION.name: Sample(3, 3.0, True, {
        'gripper': [10.0, 1.0, 0.0], 'target': [41.0, 0.0, -2.0],
        'attitude': [0.0, 0.0, 0.0, 1.0]})})
    # y points to the Earth and is drawn downwards
    assert made['tether'] == [[0.0, 0.0, 0.0], [10.0, -1.0, 0.0]]
    assert made['sight'] == [[10.0, -1.0, 0.0], [41.0, 0.0, 2.0]]
    cone = np.array(made['cone']) - [10.0, -1.0, 0.0]
    edge = cone[np.linalg.norm(cone, axis=1) > 1.0]
    assert_allclose(np.arccos(edge[:, 0]/np.linalg.norm(edge, axis=1)), 0.4, atol=1e-9)
    angle = np.arctan(np.hypot(1.0, 2.0)/31.0)
    assert_allclose(made['spot'], [0.0, angle/np.sqrt(5.0), 2.0*angle/np.sqrt(5.0)])
    assert made['margin'] == [f'{0.4 - angle:.2f} rad', False]
    assert display.derive({})['tether'] is None


@pytest.mark.parametrize('doing, obeyed', [
    (LATCHED, None), (FLYING, 'go'), (BRAKING, 'hold'), (STANDING, 'hold'), (ABORTED, None)])
def test_behind_a_link_the_order_that_is_obeyed_is_told_by_what_the_gripper_does(doing, obeyed):
    ordered = display_of(load(Path(__file__).parents[4] / 'scenarios' / 'tether_delay.yaml'))
    assert encode(as_data(ordered.display))

    def derived(ahead: float, plans: int) -> dict:
        return ordered.derive({SITUATION.name: Sample(3, 3.0, True, {
            'gripper': [10.0, 1.0, 0.0], 'target': [41.0, 0.0, -2.0], 'range': 31.0,
            'attitude': [0.0, 0.0, 0.0, 1.0], 'doing': float(doing), 'ahead': ahead,
            'plans': float(plans), 'refused': 0.0})})
    made = derived(26.0, 1)
    assert made['obeyed'] == obeyed and made['does'].index(1.0) == doing
    assert made['plans'] == ['plan 1 \u00b7 an order given now acts at 26.0 m', False]
    assert derived(31.0, 0)['plans'] == ['no plan yet', False]
    assert ordered.derive({})['obeyed'] is None


def test_a_review_shows_the_true_gripper_and_no_other_frame_does(flown):
    display = display_of(SCENARIO)
    state = flown.history[TRUTH.name].state[-1, 0]
    made = display.beside({}, {'state': state.tolist()})
    assert_allclose(made['gripper'], state[:3]*[1.0, -1.0, -1.0])
    shown = display.derive({})
    assert 'truth' not in display.derives_from and set(shown.values()) == {None}


def test_figures_of_a_run_are_drawn(flown):
    run = of_history(SCENARIO, flown)
    for figure in FIGURES.values():
        assert not figure.missing(run)
        assert figure.draw(run).axes
