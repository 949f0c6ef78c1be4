"""Runs that outlast the usual draws come out as if everything had been drawn at once."""

from approaches import approach
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import draw, fly

# The stick brakes along x for a while: some runs arrive late, some never.
BRAKES = 't_s,axis_0,axis_1,axis_2,axis_3,axis_4,button_0,button_1,button_2,button_3,button_4\n'


def require_equal(some, whole):
    """Compare all that two batches say about their runs."""
    assert_array_equal(some.end_step, whole.end_step)
    for name in ('success', 'reason', 'duration'):
        assert_array_equal(getattr(some.verdict, name), getattr(whole.verdict, name))
    assert list(some.verdict.values) == list(whole.verdict.values)
    for name, ours in some.verdict.values.items():
        assert_array_equal(ours, whole.verdict.values[name], name)
    assert list(some.columns) == list(whole.columns) and some.columns
    for name, ours in some.columns.items():
        assert ours.dtype == whole.columns[name].dtype
        assert_array_equal(ours, whole.columns[name], name)


@pytest.mark.parametrize('brake_s', [4.5, 30.0])
def test_a_late_run_is_the_run_drawn_whole(brake_s, tmp_path):
    tape = tmp_path / 'brakes.csv'
    tape.write_text(BRAKES + '0,0,0,0,0,0,0,0,0,0,1\n20,0,-0.333,0,0,0,0,0,0,0,1\n'
                    f'{20 + brake_s},0,0,0,0,0,0,0,0,0,1\n300,0,0,0,0,0,0,0,0,0,1\n')
    scenario = approach({'joystick_replay': {'tape': str(tape)}}, operator='replay')
    usual = draw(scenario, range(40)).steps
    some = fly(scenario, range(40))
    assert usual <= scenario.run.last_step and (some.end_step >= usual).any()
    require_equal(some, fly(scenario, range(40), draws=draw(scenario, range(40), whole=True)))


def test_an_aborted_run_is_late_too():
    """After an abort nobody arrives: every run is flown again, with the abort in it."""
    scenario, schedule = approach(), [Change(70, abort=True)]
    some = fly(scenario, range(10), schedule=schedule)
    assert (some.end_step == scenario.run.last_step).all()
    whole = draw(scenario, range(10), whole=True)
    require_equal(some, fly(scenario, range(10), draws=whole, schedule=schedule))
