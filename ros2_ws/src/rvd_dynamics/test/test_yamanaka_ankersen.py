"""Yamanaka and Ankersen's matrix against the exact motion, Clohessy-Wiltshire and itself."""

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.motion import cw, elliptic, yamanaka_ankersen as ya
from rvd_dynamics.motion.kepler import EllipseParams

DIRECTION = np.array([0.3, -0.8, 0.2, 1e-3, -5e-4, 3e-4])      # per metre of separation
COAST = np.zeros(3)


def orbit(e, start_deg=-40.0):
    return EllipseParams(eccentricity=e, start_anomaly_deg=start_deg)


def exact(state, where, begin, end, dt=2.0, accel=COAST):
    for i in range(round((end - begin)/dt)):
        state = elliptic.step(state, accel, where, begin + i*dt, dt)
    return state


@pytest.mark.parametrize('e', [0.0, 0.1, 0.3, 0.7])
@pytest.mark.parametrize('begin', [0.0, 3000.0])
def test_the_error_against_the_exact_motion_is_of_second_order_in_separation(e, begin):
    where, end = orbit(e), begin + 2000.0
    matrix = ya.transition(where, begin, end)
    errors = [np.linalg.norm((matrix @ (size*DIRECTION)
                              - exact(size*DIRECTION, where, begin, end))[:3])
              for size in (4000.0, 2000.0, 1000.0)]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert_allclose(orders, 2.0, atol=0.02)
    assert errors[-1] < 0.01*1000.0


@pytest.mark.parametrize('dt', [-300.0, 2.0, 600.0, 7000.0])
def test_on_a_circle_it_is_clohessy_and_wiltshire(dt):
    where = orbit(0.0)
    n = where.mean_motion
    units = np.repeat([1.0, n], 3)                          # rates in metres per radian
    ours, theirs = (units[:, None]**-1*m*units for m in (
        ya.transition(where, 500.0, 500.0 + dt), cw.transition(n, dt)))
    assert_allclose(ours, theirs, atol=1e-10)
    assert_allclose(ya.input_matrix(where, 500.0, 502.0), cw.input_matrix(n, 2.0), atol=1e-11)


@pytest.mark.parametrize('e', [0.0, 0.1, 0.6, 0.9])
def test_transitions_compose_and_invert(e):
    where = orbit(e)
    there, on = ya.transition(where, 100.0, 900.0), ya.transition(where, 900.0, 5000.0)
    scale = np.abs(on).max()*np.abs(there).max()
    assert_allclose(on @ there, ya.transition(where, 100.0, 5000.0), atol=1e-12*scale)
    assert_allclose(ya.transition(where, 900.0, 100.0) @ there, np.eye(6), atol=1e-8)
    assert_allclose(ya.transition(where, 100.0, 100.0), np.eye(6), atol=1e-11)


def test_the_solution_matrices_are_inverse_to_each_other():
    for e in (0.0, 0.1, 0.5, 0.9):
        for nu in np.linspace(0.1, 6.1, 9):
            product = ya._solutions(e, nu, 0.0) @ ya._inverse_solutions(e, nu)
            assert_allclose(product, np.eye(4), atol=1e-12)


@pytest.mark.parametrize('begin', [0.0, 1500.0, 4000.0])
def test_held_thrust_moves_a_chaser_at_the_target_as_the_exact_motion_does(begin):
    where, accel = orbit(0.3), np.array([0.01, 0.02, -0.03])
    exactly = exact(np.zeros(6), where, begin, begin + 10.0, dt=1.0, accel=accel)
    assert_allclose(ya.input_matrix(where, begin, begin + 10.0) @ accel, exactly, atol=1e-8)


def test_phase_space_keeps_its_volume():
    assert_allclose(np.linalg.det(ya.transition(orbit(0.4), 0.0, 6000.0)), 1.0, rtol=1e-8)
