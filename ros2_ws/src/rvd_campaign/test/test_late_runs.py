"""Runs that outlast the usual draws come out as if everything had been drawn at once."""

import numpy as np
import pytest

from rvd_campaign import catalogue
from rvd_dynamics.diagram.in_process import draw, fly
from rvd_dynamics.diagram.scenario import load

# The stick brakes along x for a while: some runs arrive late, some never.
BRAKES = 't_s,axis_0,axis_1,axis_2,axis_3,axis_4,button_0,button_1,button_2,button_3,button_4\n'


@pytest.mark.parametrize('brake_s', [4.5, 30.0])
def test_a_late_run_is_the_run_drawn_whole(brake_s, tmp_path):
    tape = tmp_path / 'brakes.csv'
    tape.write_text(BRAKES + '0,0,0,0,0,0,0,0,0,0,1\n20,0,-0.333,0,0,0,0,0,0,0,1\n'
                    f'{20 + brake_s},0,0,0,0,0,0,0,0,0,1\n300,0,0,0,0,0,0,0,0,0,1\n')
    scenario = load(catalogue.root() / 'scenarios' / 'paper.yaml').with_values(
        '/**', operator='replay').with_values('joystick_replay', tape=str(tape))
    usual = draw(scenario, range(40)).steps
    some = fly(scenario, range(40))
    whole = fly(scenario, range(40), draws=draw(scenario, range(40), whole=True))
    assert usual <= scenario.run.last_step and (some.end_step >= usual).any()
    for name in ('success', 'reason', 'duration'):
        np.testing.assert_array_equal(getattr(some.verdict, name), getattr(whole.verdict, name))
    assert list(some.verdict.values) == list(whole.verdict.values)
    for name, ours in some.verdict.values.items():
        np.testing.assert_array_equal(ours, whole.verdict.values[name], err_msg=name)
    assert list(some.columns) == list(whole.columns)
    for name in some.columns:                   # the state at the docking plane, who decided
        np.testing.assert_array_equal(some.columns[name], whole.columns[name], err_msg=name)
    np.testing.assert_array_equal(some.end_step, whole.end_step)
