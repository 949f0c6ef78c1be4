"""Collision probability: against other authorities, by symmetry, at its limits."""

import subprocess
import sys

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from scipy import integrate
from scipy.spatial.transform import Rotation
from scipy.stats import ncx2, norm

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.geometry import collision
from rvd_dynamics.motion import cw

RADIUS = 1.6                    # [m] of chaser and obstacle together


def covariances(rows, seed, least=0.1, most=1.0, ratio=5.0):
    """Return covariances (rows, 3, 3) in random directions, deviations from least to most."""
    rng = np.random.default_rng(seed)
    shortest = rng.uniform(least, most / 1.01, rows)
    longest = np.minimum(shortest * rng.uniform(1.0, ratio, rows), most)
    middle = rng.uniform(shortest, longest)
    turn = Rotation.random(rows, random_state=seed).as_matrix()
    deviations = np.stack([shortest, middle, longest], axis=-1)
    made = (turn * deviations[:, None, :]**2) @ np.swapaxes(turn, 1, 2)
    return 0.5 * (made + np.swapaxes(made, 1, 2))


def offsets(rows, seed, farthest=4.0):
    rng = np.random.default_rng(seed)
    return Rotation.random(rows, random_state=seed).apply([1.0, 0.0, 0.0]) * rng.uniform(
        0.0, farthest, (rows, 1))


def test_sphere_is_the_noncentral_chi_square_distribution():
    rng = np.random.default_rng(1)
    d, s, r = rng.uniform(0, 6, 5000), rng.uniform(0.05, 2, 5000), rng.uniform(0.1, 3, 5000)
    assert_allclose(collision.sphere_probability(d, s, r), ncx2.cdf((r/s)**2, 3, (d/s)**2),
                    rtol=0, atol=1e-12)


def test_sphere_has_no_cancellation_where_the_centres_meet():
    d = np.array([0.0, 1e-300, 1e-12, 1e-6, 1e-3, 9.9e-3 * 0.25/1.6, 1.01e-2 * 0.25/1.6])
    centre = ncx2.cdf((RADIUS / 0.5)**2, 3, (d / 0.5)**2)
    assert_allclose(collision.sphere_probability(d, 0.5, RADIUS), centre, rtol=1e-13)


@pytest.mark.parametrize('mean, covariance', [
    ((1.2, 0.5, -0.4), np.diag([0.25, 0.25, 0.25])),
    ((1.6, 0.0, 0.0), np.diag([0.04, 0.36, 1.0])),
    ((0.9, -1.1, 0.8), [[0.5, 0.2, -0.1], [0.2, 0.3, 0.05], [-0.1, 0.05, 0.1]]),
])
def test_monte_carlo_agrees_within_three_sigma(mean, covariance):
    count = 400_000
    drawn = np.random.default_rng(3).multivariate_normal(mean, covariance, count)
    share = np.mean(np.sum(drawn**2, axis=1) <= RADIUS**2)
    p = collision.probability(mean, covariance, RADIUS)
    assert 0.05 < p < 0.95
    assert abs(share - p) < 3.0 * np.sqrt(p * (1 - p) / count)


def test_general_is_the_sphere_where_the_covariance_is_one():
    rng = np.random.default_rng(4)
    s, r, mean = rng.uniform(0.1, 1, 2000), rng.uniform(0.3, 3, 2000), offsets(2000, 4, 6.0)
    p = collision.probability(mean, np.eye(3) * (s*s)[:, None, None], r)
    exact = ncx2.cdf((r/s)**2, 3, np.sum(mean**2, axis=1) / s**2)
    assert_allclose(p, exact, rtol=0, atol=1e-6)


@pytest.mark.parametrize('seed', range(3))
def test_general_agrees_with_adaptive_quadrature(seed):
    covariance, mean = covariances(1, seed)[0], offsets(1, seed, 2.5)[0]
    weights, axes = np.linalg.eigh(covariance)
    s, m = np.sqrt(weights), axes.T @ mean

    def chord(y, x):
        half = np.sqrt(max(RADIUS**2 - x*x - y*y, 0.0))
        across = norm.cdf((half - m[2]) / s[2]) - norm.cdf((-half - m[2]) / s[2])
        return across * norm.pdf(x, m[0], s[0]) * norm.pdf(y, m[1], s[1])

    low, high = max(-RADIUS, m[0] - 7*s[0]), min(RADIUS, m[0] + 7*s[0])
    if low >= high:
        exact = 0.0
    else:
        exact, _ = integrate.dblquad(chord, low, high, lambda x: -np.sqrt(RADIUS**2 - x*x),
                                     lambda x: np.sqrt(RADIUS**2 - x*x), epsabs=3e-8)
    assert collision.probability(mean, covariance, RADIUS) == pytest.approx(exact, abs=1e-6)


def test_a_rotation_changes_nothing():
    covariance, mean = covariances(300, 7), offsets(300, 7)
    turn = Rotation.random(300, random_state=8)
    matrix = turn.as_matrix()
    turned = matrix @ covariance @ np.swapaxes(matrix, 1, 2)
    assert_allclose(collision.probability(turn.apply(mean), turned, RADIUS),
                    collision.probability(mean, covariance, RADIUS), rtol=0, atol=2e-7)


def test_limits_are_certainty_and_impossibility():
    small = np.diag([1e-8, 4e-8, 9e-8])
    assert collision.probability([1.5, 0, 0], small, RADIUS) == pytest.approx(1.0, abs=1e-6)
    assert collision.probability([1.7, 0, 0], small, RADIUS) == 0.0
    assert collision.probability([0, 0, 0], np.eye(3), 0.0) == 0.0
    assert collision.probability([0, 0, 0], np.eye(3), 40.0) == pytest.approx(1.0, abs=1e-6)
    assert np.isnan(collision.probability([np.nan, 0, 0], np.eye(3), RADIUS))
    assert np.isnan(collision.sphere_probability(np.nan, 0.1, RADIUS))


def test_probability_falls_with_distance_and_rises_with_radius():
    covariance = covariances(1, 11)[0]
    along = np.linspace(0, 5, 60)[:, None] * [0.6, 0.0, 0.8]
    assert np.all(np.diff(collision.probability(along, covariance, RADIUS)) <= 1e-9)
    assert np.all(np.diff(collision.probability([1, 1, 0], covariance,
                                                np.linspace(0.1, 4, 60))) >= -1e-9)


def test_bounds_decide_as_the_probability_does_and_spare_most_quadratures():
    covariance, mean = covariances(4000, 12), offsets(4000, 12, 10.0)
    p = collision.probability(mean, covariance, RADIUS)
    for threshold in (1e-6, 1e-4, 1e-2, 0.3):
        decided = collision.reaches(mean, covariance, RADIUS, threshold)
        assert_array_equal(decided.above, p >= threshold)
        assert decided.integrated.mean() < 0.5
    assert not collision.reaches([np.nan, 0, 0], np.eye(3), RADIUS, 0.0).above


@pytest.mark.parametrize('call', [
    lambda mean, c: collision.probability(mean, c, RADIUS),
    lambda mean, c: collision.reaches(mean, c, RADIUS, 1e-3).above.astype(float),
])
def test_a_row_of_a_batch_is_the_single_call_to_the_bit(call):
    covariance, mean = covariances(60, 13), offsets(60, 13)
    whole = call(mean, covariance)
    assert_array_equal(whole, [call(m, c) for m, c in zip(mean, covariance)])
    assert_array_equal(call(mean.reshape(4, 15, 3), covariance.reshape(4, 15, 3, 3)).ravel(), whole)


def test_rows_of_the_sphere_are_single_calls_to_the_bit():
    d = np.linspace(0, 6, 500)
    assert_array_equal(collision.sphere_probability(d, 0.3, RADIUS),
                       [collision.sphere_probability(v, 0.3, RADIUS) for v in d])


def test_an_indefinite_or_lopsided_covariance_is_refused_with_its_number():
    with pytest.raises(BadInput, match='positive definite, got a least eigenvalue of -0.2'):
        collision.probability([1, 0, 0], np.diag([0.1, -0.2, 0.3]), RADIUS)
    with pytest.raises(BadInput, match='symmetric'):
        collision.probability([1, 0, 0], [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]], RADIUS)


def test_covariance_carried_by_the_motion_is_that_of_moved_samples():
    phi = cw.transition(1.1e-3, 60.0)
    start = np.diag([0.01, 0.04, 0.09, 1e-6, 4e-6, 9e-6])
    root = np.linalg.cholesky(start)
    moved = (phi @ root) @ (phi @ root).T
    assert_allclose(cw.carried(start, phi), moved, rtol=1e-12, atol=1e-18)
    step = cw.transition(1.1e-3, 1.0)
    many = np.broadcast_to(start, (3, 6, 6))
    for _ in range(60):
        many = cw.carried(many, step)
    assert_allclose(many, np.broadcast_to(moved, (3, 6, 6)), rtol=1e-9, atol=1e-15)


def test_nobody_waits_for_numba_who_does_not_integrate():
    code = ('import sys; from rvd_dynamics.geometry import collision as c; '
            'c.sphere_probability(1.0, 0.1, 1.0); print("numba" in sys.modules)')
    told = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == 'False'
