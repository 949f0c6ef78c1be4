"""The multiplicative sensor: size, independence and what it must not do."""

import numpy as np
import pytest

from rvd_dynamics.world.sensors import Multiplicative

STATE = np.array([-30.0, 0.5, -0.2, 0.25, 0.01, -0.03])


def test_error_is_one_percent_of_each_component():
    normals = np.random.default_rng(1).standard_normal((40_000, 6))
    error = Multiplicative().measure(STATE, normals) - STATE
    # deviation of a deviation from 40,000 draws: 0.35 %; 5 of them
    np.testing.assert_allclose(error.std(axis=0) / np.abs(STATE), 0.01, rtol=0.018)
    assert np.all(np.abs(error.mean(axis=0)) < 5 * 0.01*np.abs(STATE) / 200)


def test_components_err_apart():
    normals = np.random.default_rng(2).standard_normal((40_000, 6))
    error = Multiplicative().measure(STATE, normals) / STATE - 1.0
    correlation = np.corrcoef(error.T) - np.eye(6)
    assert np.abs(correlation).max() < 5 / 200


def test_zero_is_measured_as_zero_since_the_sensor_has_no_floor():
    measured = Multiplicative().measure(np.zeros(6), np.full(6, 3.0))
    assert np.array_equal(measured, np.zeros(6))


def test_a_draw_of_one_deviation_is_one_percent():
    measured = Multiplicative().measure(STATE, np.ones(6))
    np.testing.assert_allclose(measured, 1.01*STATE, rtol=1e-15)


def test_without_noise_the_truth_itself_is_measured():
    measured = Multiplicative(noise_fraction=0.0).measure(STATE, np.full(6, 5.0))
    assert np.array_equal(measured, STATE)


def test_unknown_stays_unknown_by_component():
    blind = STATE.copy()
    blind[2] = np.nan
    measured = Multiplicative().measure(blind, np.zeros(6))
    assert np.isnan(measured[2]) and np.array_equal(measured[[0, 1, 3, 4, 5]],
                                                    STATE[[0, 1, 3, 4, 5]])


@pytest.mark.parametrize('fraction', [-0.01, 1.0, float('nan'), float('inf')])
def test_impossible_noise_is_refused_with_its_value(fraction):
    said = f'noise_fraction must be at least 0 and below 1, got {fraction}'
    with pytest.raises(ValueError, match=said):
        Multiplicative(noise_fraction=fraction)
