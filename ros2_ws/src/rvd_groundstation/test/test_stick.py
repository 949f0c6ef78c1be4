"""A held stick: the newest message counts, for half a second, for blender and controller alike."""

import pytest

from rvd_dynamics.diagram.ros.graph import spec_of
from rvd_groundstation.nodes import stick
from rvd_groundstation.nodes.stick import HeldStick


@pytest.fixture
def clock(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(stick.time, 'monotonic', lambda: now[0])
    return now


def test_nobody_has_touched_it(clock):
    assert HeldStick().newest() is None


def test_the_newest_counts_until_it_is_too_old(clock):
    held = HeldStick()
    held.take('first')
    clock[0] += 0.4
    held.take('second')
    clock[0] += 0.5
    assert held.newest() == 'second'
    clock[0] += 0.01
    assert held.newest() is None
    held.take('third')
    assert held.newest() == 'third'


@pytest.mark.parametrize('operator, joy_input, fires, watches', [
    ('model', 'stepped', True, False), ('console', 'held', False, True),
    ('joy', 'held', False, True), ('none', 'stepped', False, False)])
def test_a_law_that_uses_the_stick_gets_it_as_the_blender_does(operator, joy_input, fires,
                                                               watches):
    for node in ('auto_controller', 'command_blender'):
        spec = spec_of(node, operator, joy_input, law_uses_stick=True)
        assert (('/joy', 0) in spec.fires_on, '/joy' in spec.watches) == (fires, watches)
    blind = spec_of('auto_controller', operator, joy_input)
    assert '/joy' not in blind.reads
