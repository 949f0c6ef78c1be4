"""How the best gain falls with the noise: formulas against scipy, brute force and experiment."""

import numpy as np
from numpy.testing import assert_allclose
import pytest
from rvd_missions.attitude_hold.noise_rules import (
    axis, best_gain, consistent_gain, covariance, experiment, I, loop, minimum, one_step, P, RULES,
    slope, stationary)
from scipy import linalg, optimize, signal

PLANT = axis()
Q0 = float(PLANT.c @ stationary(PLANT, P, 0.0, 1.0).x @ PLANT.c)       # deg^2, variance of c x
RULE = pytest.mark.parametrize('rule', RULES)


def test_the_axis_is_the_sampled_spring_and_damper():
    """By scipy: the disturbance acts like the input and goes by its own pole."""
    w, z = 0.65, 0.6
    a, b, *_ = signal.cont2discrete(
        (np.array([[0.0, 1.0], [-w*w, -2*z*w]]), np.array([[0.0], [1.0]]), np.eye(2),
         np.zeros((2, 1))), 0.5, 'zoh')
    assert_allclose(PLANT.a[:2, :2], a, atol=1e-13)
    assert_allclose([PLANT.a[:2, 2], PLANT.b[:2]], [b[:, 0], b[:, 0]], atol=1e-13)
    assert_allclose(stationary(PLANT, P, 0.0, 1.0).x[2, 2], 0.02**2)


@RULE
@pytest.mark.parametrize('q', [0.1, 10.0])
def test_covariances_are_those_of_scipys_lyapunov_solver(rule, q):
    m, g = loop(PLANT, rule, -0.02)
    n = q*np.outer(g, g)
    n[:3, :3] += PLANT.w
    assert_allclose(covariance(m, n), linalg.solve_discrete_lyapunov(m, n), rtol=1e-9, atol=1e-12)


def test_a_loop_that_is_not_stable_has_no_covariance():
    with pytest.raises(ValueError, match='not stable'):
        stationary(PLANT, I, 0.01, 1.0)


@RULE
def test_the_formula_is_the_minimum_of_the_next_step(rule):
    """J of the next step written out, minimised by scipy."""
    q = 3.0*Q0
    point = stationary(PLANT, rule, -0.01, q)
    joint = np.zeros((4, 4))
    joint[:3, :3], joint[3, :3], joint[:3, 3] = point.x, point.s, point.s
    m, g = loop(PLANT, rule, -0.01)
    n = q*np.outer(g, g)
    n[:3, :3] += PLANT.w
    joint[3, 3] = linalg.solve_discrete_lyapunov(m, n)[3, 3] if rule == I else 0.0

    def cost(gain):
        ahead = np.hstack([PLANT.a + gain*np.outer(PLANT.b, PLANT.c), PLANT.b[:, None]])
        return np.trace(ahead @ joint @ ahead.T) + gain*gain*q*(PLANT.b @ PLANT.b)
    found = optimize.minimize_scalar(cost, (-1.0, 1.0), tol=1e-12).x
    assert_allclose(one_step(PLANT, point, q), found, rtol=1e-6)


@RULE
def test_the_gain_of_the_theorem_is_best_for_the_loop_it_closes(rule):
    for q in (100.0*Q0, 1e4*Q0):
        point = consistent_gain(PLANT, rule, q)
        assert point.gain < 0.0
        assert_allclose(one_step(PLANT, point, q), point.gain, rtol=1e-6)


@RULE
def test_the_gain_of_the_theorem_falls_as_one_over_q_for_large_q(rule):
    q = Q0*np.geomspace(1e3, 1e6, 7)
    gains = np.array([consistent_gain(PLANT, rule, value).gain for value in q])
    assert_allclose(slope(q, gains), -1.0, atol=0.02)
    assert_allclose(gains[-1]*q[-1], gains[-2]*q[-2], rtol=0.01)


def test_at_small_q_the_proportional_gain_does_not_fall_as_one_over_q():
    q = Q0*np.geomspace(1e-4, 1e-2, 3)
    assert slope(q, np.array([consistent_gain(PLANT, P, v).gain for v in q])) > -0.1


def test_the_proportional_gain_that_is_best_for_good_falls_as_one_over_q_too():
    q = Q0*np.geomspace(1e3, 1e6, 4)
    gains = np.array([best_gain(PLANT, P, value).gain for value in q])
    assert_allclose(slope(q, gains), -1.0, atol=0.01)


def test_the_integral_gain_that_is_best_for_good_is_zero_from_some_noise_on():
    """Any integral action that is left costs more by the noise than it wins."""
    assert best_gain(PLANT, I, 10.0*Q0).gain < -1e-3
    q = 1e3*Q0
    none = np.trace(stationary(PLANT, P, 0.0, q).x)
    assert abs(best_gain(PLANT, I, q).gain) < 1e-7
    assert np.trace(consistent_gain(PLANT, I, q).x) > 1.2*none


@RULE
def test_the_loop_flown_agrees_with_the_formula(rule):
    q = 300.0*Q0
    point = consistent_gain(PLANT, rule, q)
    found = experiment(PLANT, rule, point.gain, q, np.random.default_rng(5), groups=10)
    assert found.low < point.gain < found.high
    assert found.high - found.low < 1.5*abs(point.gain)


def test_the_minimum_flown_agrees_with_that_of_the_covariance():
    q = 3.0*Q0
    best = best_gain(PLANT, P, q).gain
    found = minimum(PLANT, P, best*np.array([0.8, 0.9, 1.0, 1.11, 1.25]), q,
                    np.random.default_rng(6), groups=10)
    assert_allclose(found.value, best, rtol=0.1)
    assert found.low < found.value < found.high
