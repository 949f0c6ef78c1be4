"""What predictions are worth: against chance that is drawn, and counted by hand."""

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_groundstation.prediction.consistency import Consistency, nees, within


def drawn(rows, seed=1):
    """Return errors (rows, 6) and the covariances (rows, 6, 6) of which they are drawn."""
    rng = np.random.default_rng(seed)
    half = rng.normal(size=(rows, 6, 6)) * np.array([0.01]*3 + [1e-4]*3)[:, None]
    return (half @ rng.normal(size=(rows, 6, 1)))[..., 0], half @ np.swapaxes(half, 1, 2)


def test_errors_drawn_of_the_covariance_have_six_and_95_percent():
    rows = 20_000
    error, covariance = drawn(rows)
    found = nees(error, covariance)
    assert found.mean() == pytest.approx(6.0, abs=5*np.sqrt(12.0/rows))
    assert (found > 12.592).mean() == pytest.approx(0.05, abs=5*np.sqrt(0.05*0.95/rows))
    assert within(error, covariance).mean() == pytest.approx(0.9545, abs=5*np.sqrt(0.045/rows))
    assert nees(3.0*error, covariance).mean() == pytest.approx(54.0, rel=0.05)


def test_units_do_not_matter():
    error, covariance = drawn(50)
    scale = np.array([1e3, 1.0, 1e-3, 60.0, 1.0, 7.0])
    assert_allclose(nees(scale*error, covariance*np.outer(scale, scale)), nees(error, covariance),
                    rtol=1e-6)


def test_what_is_not_known_does_not_count():
    error, covariance = drawn(4)
    error[1, 2], covariance[2] = np.nan, np.nan
    assert np.isnan(nees(error, covariance)).tolist() == [False, True, True, False]


def test_each_prediction_is_held_against_the_truth_of_its_instant_and_only_in_flight():
    ahead, steps, rows = 3, 20, 2
    rng = np.random.default_rng(2)
    truth = rng.normal(size=(steps + ahead, rows, 6))
    off = rng.normal(size=(steps, rows, 6))
    p = np.broadcast_to(np.diag([4.0]*6), (rows, 6, 6))
    made, ends = Consistency(ahead, (rows,)), np.array([12, steps])
    for k in range(steps):
        predicted = truth[k + ahead] + off[k]
        if k == 5:
            predicted = np.full((rows, 6), np.nan)
        made.follow(predicted, p, truth[k], k <= ends)
    for row, end in enumerate(ends):
        counted = [k for k in range(steps - ahead) if k != 5 and k + ahead <= end]
        expected = [(off[k, row]**2).sum()/4.0 for k in counted]
        assert made.mean_nees[row] == pytest.approx(np.mean(expected))
        inside = [(np.abs(off[k, row]) <= 4.0).mean() for k in counted]
        assert made.coverage[row] == pytest.approx(np.mean(inside))


def test_of_no_prediction_nothing_is_said():
    made = Consistency(3, (2,))
    assert np.isnan(made.mean_nees).all() and np.isnan(made.coverage).all()
