"""The sensor whose errors do not vanish: what is added to each sample, what lasts for a run."""

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from rvd_dynamics.world.sensors import Additive, Multiplicative

STATE = np.array([-30.0, 0.5, -0.2, 0.25, 0.01, -0.03])
SIGMA = np.array([0.02, 0.01, 0.03, 0.001, 0.002, 0.003])
BIAS = np.array([0.1, 0.05, 0.02, 0.01, 0.004, 0.002])
SENSOR = Additive(0.01, tuple(SIGMA[:3]), tuple(SIGMA[3:]), tuple(BIAS[:3]), tuple(BIAS[3:]))


def test_variances_of_the_three_errors_add_up():
    rng = np.random.default_rng(8)
    draws = rng.standard_normal((3, 40_000, 6))
    error = SENSOR.measure(STATE, *draws) - STATE
    expected = np.sqrt((0.01*STATE)**2 + SIGMA**2 + BIAS**2)
    assert_allclose(error.std(axis=0), expected, rtol=0.018)        # 5 deviations of it
    assert np.all(np.abs(error.mean(axis=0)) < 5*expected/200)


def test_at_the_origin_only_what_is_added_is_left():
    measured = SENSOR.measure(np.zeros(6), np.full(6, 3.0), np.full(6, -2.0), np.ones(6))
    assert_allclose(measured, BIAS - 2.0*SIGMA, rtol=1e-14)


def test_the_mean_of_many_samples_of_a_run_is_off_by_the_bias():
    rng = np.random.default_rng(9)
    bias = rng.standard_normal(6)
    measured = SENSOR.measure(np.zeros(6), rng.standard_normal((40_000, 6)),
                              rng.standard_normal((40_000, 6)), bias)
    assert np.all(np.abs(measured.mean(axis=0) - BIAS*bias) < 5*SIGMA/200)


def test_with_nothing_added_it_is_the_multiplicative_sensor():
    zero = (0.0, 0.0, 0.0)
    normals = np.random.default_rng(1).standard_normal((100, 6))
    plain = Additive(0.02, zero, zero, zero, zero)
    assert_array_equal(plain.measure(STATE, normals, normals, normals),
                       Multiplicative(0.02).measure(STATE, normals))
