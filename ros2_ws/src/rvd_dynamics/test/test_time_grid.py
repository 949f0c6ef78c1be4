"""
Delays as whole numbers of steps.
"""

import pytest

from rvd_dynamics.diagram.time_grid import whole_steps


@pytest.mark.parametrize('duration_s, step_s, steps', [
    (0.0, 0.5, 0), (5.0, 0.5, 10), (0.3, 0.1, 3), (3600.0, 0.05, 72_000)])
def test_steps_are_counted_although_tenths_are_not_exact(duration_s, step_s, steps):
    assert whole_steps('delay_s', duration_s, step_s) == steps


@pytest.mark.parametrize('duration_s, step_s, nearest', [
    (0.7, 0.5, '0.5 and 1'), (0.05, 0.1, '0 and 0.1'), (5.24, 0.5, '5 and 5.5')])
def test_what_is_off_the_grid_is_refused_with_its_neighbours(duration_s, step_s, nearest):
    with pytest.raises(ValueError, match=f'^delay_s must be a whole number of steps of {step_s} s, '
                       f'got {duration_s}: the two nearest are {nearest}$'):
        whole_steps('delay_s', duration_s, step_s)
