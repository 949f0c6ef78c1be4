"""How much gain error the golden-section law bears, against roots and discretisation by others."""

from hypothesis import assume, given
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from rvd_missions.attitude_hold.laws.golden_section import L1, L2
from rvd_missions.attitude_hold.stability import (
    is_stable, loop, ONE_TAP, poles, radius, range_of_gain, TWO_TAPS)
from scipy import signal


def test_the_two_shares_are_the_golden_section():
    assert_allclose([L1 + L2, L2*L2, L1/L2], [1.0, L1, L2], rtol=1e-15)


def test_exact_parameters_give_the_one_tap_loop_a_double_pole_at_the_golden_section():
    base, change = loop(ONE_TAP)
    assert_allclose(base + change, [1.0, -2.0*L2, L2*L2], atol=1e-15)       # (z - .618)^2
    assert_allclose(poles(1.0, base, change), [0.618, 0.618], atol=1e-3)


def test_one_tap_bears_a_gain_error_up_to_2_89():
    low, high = range_of_gain(*loop(ONE_TAP))
    assert low == 0.0
    assert_allclose(high, 4.0/(1.0 + L1), rtol=1e-12)       # z = -1 by hand
    assert round(high, 2) == 2.89


def test_two_taps_have_the_poles_and_the_bound_of_the_sampled_double_integrator():
    base, change = loop(TWO_TAPS)
    found = poles(1.0, base, change)
    assert_allclose(found, [0.727, 0.446 + 0.476j, 0.446 - 0.476j], atol=6e-4)
    assert_allclose(range_of_gain(base, change), [0.0, 2.552], atol=1e-3)


def test_the_two_taps_are_those_of_a_double_integrator_behind_a_hold():
    """By scipy: its numerator over dt^2, its denominator."""
    dt = 0.5
    numerator, denominator, _ = signal.cont2discrete(([1.0], [1.0, 0.0, 0.0]), dt, 'zoh')
    assert_allclose(np.ravel(numerator)/dt**2, [0.0, *TWO_TAPS], atol=1e-12)
    assert_allclose(denominator, [1.0, -2.0, 1.0], atol=1e-12)


@pytest.mark.parametrize('taps', [ONE_TAP, TWO_TAPS])
@pytest.mark.parametrize('delay', [0, 1, 2, 3])
def test_the_polynomial_is_that_of_the_loop_in_state_space(taps, delay):
    """Eigenvalues of the matrix that carries samples and commands one step on."""
    rho, n = 0.7, len(taps) + delay
    step = np.zeros((2 + n, 2 + n))                 # y(k), y(k-1), u(k-1), ..., u(k-n)
    law = np.array([-2.0*L1, L2])
    step[0, :2], step[1, 0] = (2.0, -1.0), 1.0
    shares = np.concatenate([np.zeros(delay), taps])            # of u(k), u(k-1), ...
    step[0, :2] += rho*shares[0]*law
    step[0, 2:2 + n - 1] += rho*shares[1:]
    step[2, :2] = law
    for i in range(1, n):
        step[2 + i, 1 + i] = 1.0
    eigen = np.linalg.eigvals(step)
    largest = poles(rho, *loop(taps, delay=delay))
    order = np.sort(np.abs(eigen))[::-1][:len(largest)]
    assert_allclose(order, np.abs(largest), atol=1e-6)


@pytest.mark.parametrize('taps', [ONE_TAP, TWO_TAPS])
@pytest.mark.parametrize('delay', [0, 1, 2, 3])
def test_poles_cross_the_unit_circle_at_the_ends_of_the_range_and_not_inside(taps, delay):
    base, change = loop(taps, delay=delay)
    low, high = range_of_gain(base, change)
    inside = np.linspace(low, high, 203)[1:-1]
    assert np.all(radius(inside, base, change) < 1.0)
    assert_allclose(radius(high, base, change), 1.0, atol=1e-9)
    assert radius(1.001*high, base, change) > 1.0


def test_four_steps_of_delay_leave_no_gain_at_which_the_double_integrator_is_held():
    with pytest.raises(ValueError, match='stable at no positive gain'):
        range_of_gain(*loop(TWO_TAPS, delay=4))
    assert np.all(radius(np.geomspace(1e-4, 10.0, 200), *loop(TWO_TAPS, delay=4)) > 1.0)


@given(st.lists(st.floats(-3.0, 3.0), min_size=1, max_size=6), st.floats(0.1, 5.0))
def test_jurys_table_tells_what_the_roots_tell(rest, first):
    polynomial = np.array([first, *rest])
    farthest = np.abs(np.roots(polynomial)).max(initial=0.0)
    assume(abs(farthest - 1.0) > 1e-3)
    assert is_stable(polynomial) == (farthest < 1.0)


def test_a_polynomial_without_its_first_coefficient_is_refused():
    with pytest.raises(ValueError, match='must not be zero, got 0.0'):
        is_stable([0.0, 1.0])
