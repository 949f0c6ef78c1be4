"""The filter against a Riccati recursion written out, against chance, and row by row."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest
from scipy.linalg import expm

from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.prediction.filter import (
    AdaptiveFilter, FILTERS, gain_sequence, ScheduledFilter)
from rvd_groundstation.prediction.filter_params import FilterParams

PARAMS = FilterParams()
NOMINAL = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])


def model(paper):
    """Return Phi and Gamma by the matrix exponential of the augmented system."""
    n = paper.orbit.mean_motion
    a = np.zeros((9, 9))
    a[:3, 3:6] = a[3:6, 6:] = np.eye(3)
    a[3, 4], a[4, 3], a[4, 1], a[5, 2] = -2*n, 2*n, 3*n*n, -n*n
    big = expm(a * paper.step_s)
    return big[:6, :6], big[:6, 6:]


def riccati(paper, steps):
    """Return gains and covariances by the textbook recursion with the numbers written out."""
    phi, gamma = model(paper)
    q = 9e-8 * gamma @ gamma.T + 1e-10 * (paper.step_s / 0.5) * np.eye(6)
    p = np.diag([0.3, 0.5, 0.5, 0.01, 0.02, 0.02])**2
    gains, covariances = [], []
    for m in range(steps):
        x = abs(-30.0 + 0.25 * m * paper.step_s)
        sizes = np.array([max(x, 0.25), 0.3, 0.3, 0.25, 0.02, 0.02])
        r = np.diag((0.01 * sizes)**2 + np.array([1e-8]*3 + [1e-10]*3))
        if m > 0:
            p = phi @ p @ phi.T + q
        k = np.linalg.solve(p + r, p).T
        p = np.linalg.inv(np.linalg.inv(p) + np.linalg.inv(r))
        gains.append(k)
        covariances.append(p)
    return np.array(gains), np.array(covariances)


@pytest.mark.parametrize('step_s', [0.05, 0.1, 0.5, 1.0])
def test_gains_are_those_of_the_riccati_recursion(step_s):
    paper = Paper(step_s=step_s)
    schedule = gain_sequence(PARAMS, paper.start, paper.orbit, paper.step_s, 100)
    gains, covariances = riccati(paper, 100)
    assert_allclose(schedule.gains, gains, atol=1e-8)           # the reference inverts twice
    assert_allclose(schedule.covariances, covariances, rtol=1e-6, atol=1e-12)


def test_longer_schedule_begins_with_the_shorter_one():
    short, long = (gain_sequence(PARAMS, StartParams(), OrbitParams(), 0.5, steps)
                   for steps in (20, 50))
    assert_array_equal(long.gains[:20], short.gains)


def test_floor_of_the_process_noise_scales_with_the_step():
    for step_s in (0.05, 0.5, 1.0):
        quiet = replace(PARAMS, process_noise_m_s2=0.0)
        q = quiet.process_covariance(np.zeros((6, 3)), step_s)
        assert_allclose(q, 1e-10 * step_s / 0.5 * np.eye(6), rtol=1e-15)


def test_measurement_noise_follows_the_state_down_to_the_floors():
    r = PARAMS.measurement_variance(np.array([-20.0, 2.0, 0.0, 0.5, -0.01, 0.03]))
    expected = [0.2, 0.02, 0.003, 0.005, 0.0002, 0.0003]
    assert_allclose(r, np.square(expected) + np.array([1e-8]*3 + [1e-10]*3), rtol=1e-12)


@pytest.fixture(params=FILTERS.values(), ids=FILTERS.keys())
def kind(request):
    return request.param


def test_perfect_samples_of_a_perfect_start_change_nothing(kind):
    paper = Paper()
    phi, gamma = model(paper)
    flt, truth = paper.filter(kind, PARAMS), NOMINAL
    rng = np.random.default_rng(4)
    for m in range(60):
        accel = rng.normal(scale=0.01, size=3)
        if m > 0:
            truth = phi @ truth + gamma @ accel
        assert_allclose(flt.advance(m, accel, truth, np.array(True)), truth, atol=1e-11)


def test_lost_sample_leaves_the_time_update(kind):
    paper = Paper()
    phi, gamma = model(paper)
    flt = paper.filter(kind, PARAMS)
    before = flt.advance(0, np.zeros(3), NOMINAL + 0.1, np.array(True)).copy()
    accel = np.array([0.01, -0.02, 0.005])
    after = flt.advance(1, accel, np.full(6, np.nan), np.array(False))
    assert_allclose(after, phi @ before + gamma @ accel, atol=1e-12)


def test_tracked_covariance_without_loss_is_the_schedule():
    paper = Paper()
    flt = paper.filter(ScheduledFilter, PARAMS)
    schedule = gain_sequence(PARAMS, paper.start, paper.orbit, paper.step_s, 50)
    for m in range(50):
        flt.advance(m, np.zeros(3), NOMINAL, np.array(True))
        assert_allclose(flt.covariance, schedule.covariances[m], rtol=1e-9, atol=1e-15)


def test_error_is_as_large_as_the_covariance_says_also_after_losses():
    rows, steps, paper = 4000, 40, Paper()
    rng = np.random.default_rng(11)
    phi, gamma = model(paper)
    flt = paper.filter(ScheduledFilter, PARAMS, (rows,))
    schedule = gain_sequence(PARAMS, paper.start, paper.orbit, paper.step_s, steps)
    q = np.linalg.cholesky(PARAMS.process_covariance(gamma, paper.step_s))
    truth = NOMINAL + rng.normal(size=(rows, 6)) @ np.sqrt(PARAMS.start_covariance())
    received = rng.random((steps, rows)) < 0.8
    for m in range(steps):
        if m > 0:
            truth = truth @ phi.T + rng.normal(size=(rows, 6)) @ q.T
        noise = rng.normal(size=(rows, 6)) * np.sqrt(schedule.measurement_variances[m])
        flt.advance(m, np.zeros((rows, 3)), truth + noise, received[m])
    error = flt.estimate - truth
    nees = np.einsum('ni,nij,nj->n', error, np.linalg.inv(flt.covariance), error)
    assert abs(nees.mean() - 6.0) < 5 * np.sqrt(12.0 / rows)    # chi-square, 6 degrees of freedom
    assert abs((nees > 12.592).mean() - 0.05) < 5 * np.sqrt(0.05 * 0.95 / rows)


def test_adaptive_filter_knows_the_noise_of_a_large_offset():
    paper, start = Paper(), np.array([-30.0, 3.0, 0.0, 0.25, 0.0, 0.0])
    flt = paper.filter(AdaptiveFilter, PARAMS)
    for m in range(5):
        flt.advance(m, np.zeros(3), start, np.array(True))
    scheduled = gain_sequence(PARAMS, paper.start, paper.orbit, paper.step_s, 5).covariances[4]
    # The first sample was weighed at the floor of 0.3 m, before 3 m was known.
    assert np.sqrt(flt.covariance[1, 1]) > 2 * np.sqrt(scheduled[1, 1])
    assert flt.covariance[2, 2] == pytest.approx(scheduled[2, 2], rel=1e-3)


@pytest.mark.parametrize('rows', [1, 7, 1000])
def test_rows_are_equal_to_single_filters_bit_for_bit(kind, rows):
    paper = Paper()
    steps = 12 if kind is ScheduledFilter else 2
    rng = np.random.default_rng(rows)
    accel = rng.normal(scale=0.01, size=(steps, rows, 3))
    measured = NOMINAL + rng.normal(scale=0.1, size=(steps, rows, 6))
    received = rng.random((steps, rows)) < 0.9
    batch = paper.filter(kind, PARAMS, (rows,), track=False)
    for m in range(steps):
        batch.advance(m, accel[m], measured[m], received[m])
    for row in range(0, rows, max(1, rows // 20)):
        single = paper.filter(kind, PARAMS, track=True)
        for m in range(steps):
            single.advance(m, accel[m, row], measured[m, row], received[m, row])
        assert_array_equal(single.estimate, batch.estimate[row])


@pytest.mark.parametrize('name, bad', [
    ('process_noise_m_s2', -1.0), ('measurement_fraction', 0.0), ('position_sigma_m', np.nan),
    ('position_floor_m', (0.1, 0.1)), ('start_velocity_sigma_m_s', (0.1, -0.1, 0.1))])
def test_impossible_settings_are_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=name):
        FilterParams(**{name: bad})
