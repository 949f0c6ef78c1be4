"""Conditions in words, with the units of their axes."""

import pytest

from rvd_dynamics.recording.worded import worded, worded_axis


@pytest.mark.parametrize('name, words', [
    ('manual', 'manual'), ('A manual', 'A manual'),
    ('corridor_apf with pilot', 'corridor APF with pilot'),
    ('odrrca_k2', 'ODRRCA k2'), ('velocity_profile', 'velocity profile'),
    ('shared,loop_delay_s=10', 'shared, loop delay 10 s'),
    ('corridor_apf,loss_percent=5', 'corridor APF, loss 5 %'),
    ('barrier,eta=0.5', 'barrier, eta 0.5'), ('x,alignment_deg=0.04', 'x, alignment 0.04 deg'),
    ('x,slope_per_s=-1e-05', 'x, slope -1e-05 per s'),
    ('pid,faults=actuator 0.4 sensor 1,world=x1', 'PID, faults: actuator 0.4 sensor 1, world: x1'),
    ('orbit=GEO,spline=clipped', 'orbit: GEO, spline: clipped'), ('_s=1', 's 1'), ('', '')])
def test_a_condition_in_words(name, words):
    assert worded(name).strip() == words


def test_an_axis_in_words():
    assert worded_axis('loop_delay_s') == 'loop delay [s]'
    assert worded_axis('eta') == 'eta'
    assert worded_axis('loss_percent') == 'loss [%]'
