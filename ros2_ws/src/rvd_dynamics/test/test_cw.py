"""Clohessy-Wiltshire matrices against exponentials, quadrature, long arithmetic and orbits."""

from math import pi

from hypothesis import given, strategies as st
from mpmath import mp, mpf
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.linalg import expm

from rvd_dynamics.motion import cw

N = 8.2071e-4                   # [rad/s] 200 km circular lunar orbit
PERIOD = 2 * pi / N             # [s]
STEPS = [0.05, 0.1, 0.5, 1.0, 10.0, 120.0, 1000.0, PERIOD]

A = np.zeros((6, 6))            # the equations of motion: x' = A x + B u
A[:3, 3:] = np.eye(3)
A[3, 4], A[4, 3], A[4, 1], A[5, 2] = -2*N, 2*N, 3*N*N, -N*N
B = np.vstack([np.zeros((3, 3)), np.eye(3)])

durations = st.floats(-2000.0, 2000.0)


@pytest.mark.parametrize('dt', STEPS)
def test_transition_is_the_exponential_of_the_equations(dt):
    assert_allclose(cw.transition(N, dt), expm(A*dt), rtol=1e-13, atol=1e-13*max(dt, 1.0))


@pytest.mark.parametrize('dt', STEPS)
def test_input_matrix_is_the_integral_of_the_transition(dt):
    nodes, weights = np.polynomial.legendre.leggauss(24)
    times = dt/2 * (nodes + 1.0)
    integral = sum(w * expm(A*t) @ B for w, t in zip(weights, times)) * dt/2
    assert_allclose(cw.input_matrix(N, dt), integral, rtol=1e-12, atol=1e-13*dt*dt)


def exact(dt):
    """Return both matrices from the closed forms, in 60 digits."""
    mp.dps = 60
    n, dt = mpf(N), mpf(dt)
    w = n*dt
    s, c = mp.sin(w), mp.cos(w)
    phi = [[1, 6*(s - w), 0, (4*s - 3*w)/n, 2*(c - 1)/n, 0],
           [0, 4 - 3*c, 0, 2*(1 - c)/n, s/n, 0],
           [0, 0, c, 0, 0, s/n],
           [0, 6*n*(c - 1), 0, 4*c - 3, -2*s, 0],
           [0, 3*n*s, 0, 2*s, c, 0],
           [0, 0, -n*s, 0, 0, c]]
    gamma = [[4*(1 - c)/n**2 - 3*dt**2/2, 2*(s - w)/n**2, 0],
             [2*(w - s)/n**2, (1 - c)/n**2, 0],
             [0, 0, (1 - c)/n**2],
             [(4*s - 3*w)/n, 2*(c - 1)/n, 0],
             [2*(1 - c)/n, s/n, 0],
             [0, 0, s/n]]
    return [np.array([[float(e) for e in row] for row in m]) for m in (phi, gamma)]


@pytest.mark.parametrize('dt', [1e-9, 1e-6, 1e-3, 0.05, 0.5, 1.0, 10.0, 300.0, 1200.0,
                                1217.0, 1219.0, -0.5])
def test_every_entry_keeps_its_digits_at_small_arguments(dt):
    # up to w = 1, where the series hands over to the direct form, and just above
    phi, gamma = exact(dt)
    assert_allclose(cw.transition(N, dt), phi, rtol=4e-15, atol=0.0)
    assert_allclose(cw.input_matrix(N, dt), gamma, rtol=4e-15, atol=0.0)


def test_no_time_changes_nothing():
    assert np.array_equal(cw.transition(N, 0.0), np.eye(6))
    assert np.array_equal(cw.input_matrix(N, 0.0), np.zeros((6, 3)))


@given(durations, durations)
def test_p16_two_transitions_are_one(first, second):
    whole = cw.transition(N, first + second)
    parts = cw.transition(N, second) @ cw.transition(N, first)
    assert_allclose(parts, whole, rtol=1e-11, atol=2e-9)    # 6e3 s entries cancel in a sum of 6


@given(durations, durations)
def test_p17_two_inputs_are_one(first, second):
    whole = cw.input_matrix(N, first + second)
    parts = (cw.transition(N, second) @ cw.input_matrix(N, first) + cw.input_matrix(N, second))
    assert_allclose(parts, whole, rtol=1e-11, atol=1e-7)    # of entries up to 1e7 s^2


def test_p17_finds_the_printed_entry_that_is_four_times_too_large():
    def printed(dt):
        gamma = cw.input_matrix(N, dt)
        gamma[0, 0] += 1.5*dt*dt
        return gamma

    assert printed(1.0)[0, 0] / cw.input_matrix(N, 1.0)[0, 0] == pytest.approx(4.0, rel=1e-6)
    parts = cw.transition(N, 1.0) @ printed(1.0) + printed(1.0)
    assert abs(parts - printed(2.0)).max() > 1.0


def test_a_held_acceleration_agrees_with_runge_kutta():
    accel = np.array([0.03, -0.02, 0.01])
    state = np.array([-30.0, 1.0, -2.0, 0.25, -0.01, 0.02])
    by_step = cw.step(state, accel, cw.transition(N, 200.0), cw.input_matrix(N, 200.0))
    h = 0.1
    for _ in range(2000):
        k1 = A @ state + B @ accel
        k2 = A @ (state + h/2*k1) + B @ accel
        k3 = A @ (state + h/2*k2) + B @ accel
        k4 = A @ (state + h*k3) + B @ accel
        state = state + h/6*(k1 + 2*k2 + 2*k3 + k4)
    assert_allclose(by_step, state, rtol=1e-11)


def test_drift_free_ellipse_closes_after_one_orbit():
    start = [0.0, 50.0, 0.0, -2*N*50.0, 0.0, 0.0]
    assert_allclose(cw.propagate(start, N, PERIOD), start, atol=1e-9)


def test_higher_circular_orbit_falls_behind_at_three_halves_n_y():
    end = cw.propagate([0.0, 10.0, 0.0, -1.5*N*10.0, 0.0, 0.0], N, 600.0)
    assert_allclose(end[:2], [-1.5*N*10.0*600.0, 10.0])


def test_out_of_plane_motion_is_an_oscillation():
    quarter = cw.propagate([0.0, 0.0, 7.0, 0.0, 0.0, 0.0], N, PERIOD/4)
    assert_allclose(quarter, [0.0, 0.0, 0.0, 0.0, 0.0, -7.0*N], atol=1e-12)


def test_the_approach_drifts_outward_while_it_closes():
    end = cw.propagate([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0], N, 60.0)
    assert end[1] > 0.7 and end[4] > 0.0 and end[2] == 0.0


def test_propagation_broadcasts_states_against_times():
    states = np.random.default_rng(3).normal(size=(4, 1, 6))
    assert cw.propagate(states, N, [1.0, 2.0, 3.0]).shape == (4, 3, 6)


def test_unknown_stays_unknown_and_known_axes_stay_known():
    end = cw.propagate([-30.0, 0.0, np.nan, 0.25, 0.0, 0.0], N, 1.0)
    assert np.isnan(end[2])


@pytest.mark.parametrize('n', [0.0, -1e-3, np.nan])
@pytest.mark.parametrize('matrix', [cw.transition, cw.input_matrix])
def test_impossible_mean_motion_is_refused_with_its_value(matrix, n):
    with pytest.raises(ValueError, match=f'mean motion must be positive, got {n}'):
        matrix(n, 1.0)


@given(st.integers(0, 2**32 - 1), st.sampled_from([(), (1,), (5,), (2, 3)]))
def test_product_is_the_matrix_product_whatever_is_zero(seed, batch):
    rng = np.random.default_rng(seed)
    matrix = rng.normal(size=(4, 6)) * (rng.random((4, 6)) < 0.5)
    matrix[2] = 0.0
    vectors = rng.normal(size=(*batch, 6))
    assert_allclose(cw.product(matrix, vectors), vectors @ matrix.T, rtol=1e-13, atol=1e-13)
