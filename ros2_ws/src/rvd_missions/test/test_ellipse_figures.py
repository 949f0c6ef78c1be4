"""
Figures and display of the elliptic rendezvous: every one is drawn, of every law and of little.
"""

from pathlib import Path

import pytest

from rvd_dynamics.diagram.display import as_data, TRUTH as OF_REVIEW
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.drawing import svg
from rvd_dynamics.recording.history import of_history
from rvd_groundstation.console.provider import display_of
from rvd_missions.elliptic_rendezvous import cycle_figures
from rvd_missions.elliptic_rendezvous.figures import FIGURES
from rvd_missions.elliptic_rendezvous.gains import CycleCase
from rvd_missions.elliptic_rendezvous.limit_cycles import follow
from rvd_missions.elliptic_rendezvous.signals import GUIDANCE, TRUTH

SCENARIOS = Path(__file__).resolve().parents[4] / 'scenarios'
NEAR = {'start.range_m': 60.0, 'start.range_rate_m_s': -0.05, 'step_s': 4.0, 'timeout_s': 1200.0}


def scenario(name, **given):
    return load(SCENARIOS / f'{name}.yaml').with_values('/**', **{**NEAR, **given})


@pytest.mark.parametrize('name,given', [
    ('ellipse', {}), ('ellipse', {'guidance.law': 'odrrca', 'start.direction_deg': -95.0}),
    ('ellipse_combined', {}), ('ellipse', {'timeout_s': 4.0}),
    ('ellipse', {'guidance.rrca.k': -0.9, 'guidance.rrca.k1': 1.5})])     # there is no cycle
@pytest.mark.parametrize('records', [(TRUTH.name,), (TRUTH.name, GUIDANCE.name)])
def test_every_figure_is_drawn(name, given, records):
    made = scenario(name, **given)
    run = of_history(made, fly(made, [0], record=records))
    for key, figure in FIGURES.items():
        assert not figure.missing(run)
        assert '<svg' in svg(key, lambda: figure.draw(run))


def test_the_figures_of_the_cycles_are_drawn_with_unstable_ones_dashed():
    found = cycle_figures.cycles(CycleCase())
    drawing = svg('cycles', lambda: cycle_figures.portraits(found))
    drawn = drawing.partition('>')[2]                       # without its text
    assert drawn.count('unstable') == 1                     # RRCA, k2 = 0, e = 0.3
    branch = follow(CycleCase(), 'e', 0.2, 0.3)
    assert '<svg' in svg('branches', lambda: cycle_figures.branches({'R1': branch}))


@pytest.mark.parametrize('name', ['ellipse', 'ellipse_combined'])
def test_the_console_is_shown_what_the_ground_has_and_the_truth_in_review_alone(name):
    made = load(SCENARIOS / f'{name}.yaml')
    provider = display_of(made)                             # refuses what is not on the ground
    assert as_data(provider.display)['kind'] == 'display'
    diagram = made.diagram
    for topic, parts in provider.display.parts().items():
        if topic != OF_REVIEW and diagram.signals[topic].message.endswith('Values'):
            known = {part.name for part in diagram.signals[topic].parts} | {'value', 'by'}
            assert parts <= known | {'weight', 'reason', 'kind'}, topic
