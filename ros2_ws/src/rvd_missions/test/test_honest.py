"""What the blocks of a mission make is within the limits to which its readers hold them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import check, draw, Loop
from rvd_dynamics.diagram.limits import checker
from rvd_dynamics.diagram.scenario import load, parse

SCENARIOS = Path(__file__).parents[4] / 'scenarios'
STEPS = 30
SIMPLE = ('{"/**": {ros__parameters: {mission: docking, seeing: {camera: simple}}}}', 'simple')


def complaints(scenario, declared=lambda signal: signal):
    """Return what readers would refuse of the first steps, by signal."""
    loop = Loop(scenario, [0], draw(scenario, [0], whole=True), True, ())
    for k in range(STEPS):
        loop.advance(k)
    found = {}
    for name, signal in scenario.diagram.signals.items():
        refused = checker(declared(signal), [part.name for part in signal.parts])
        for k, value in enumerate(loop._history[name]):
            why = refused(type(value)(*map(_of_one_run, value, signal.parts)), k)
            if why:
                found.setdefault(name, f'step {k}: {why}')
    return found


def _of_one_run(value, part):
    return value if value is None or np.ndim(value) == len(part.shape) else np.asarray(value)[0]


@pytest.mark.parametrize('name', sorted(path.stem for path in SCENARIOS.glob('*.yaml')))
def test_no_output_of_a_block_would_be_refused(name):
    scenario = load(SCENARIOS / f'{name}.yaml')
    try:
        check(scenario)
    except BadInput:
        pytest.skip('a person has the stick')
    assert complaints(scenario) == {}


def test_a_limit_that_keeps_out_what_an_honest_block_says_is_found():
    """The pictures of a camera whose first ones are of before the run."""
    def no_step_before_the_run(signal):
        made = object.__new__(type(signal))
        made.__dict__.update(signal.__dict__, parts=tuple(
            replace(part, low=-1) if part.name == 'exposed' else part for part in signal.parts))
        return made
    scenario = parse(*SIMPLE)
    assert complaints(scenario) == {}
    assert complaints(scenario, no_step_before_the_run) == {
        '/onboard/pose': 'step 0: exposed must be from -1 to 9.0072e+15, got -5'}
