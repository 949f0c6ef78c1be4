"""Outliers: left out, never locked out by them, and what is valid is finite."""

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.prediction.gate import Gate
from rvd_groundstation.prediction.predictor import FAR, Predictor, PredictorParams

START, NOTHING = StartParams(), np.zeros(3, dtype=np.int8)
KINDS = ['learned', 'scheduled', 'adaptive']
NUMBERS = st.floats(width=64) | st.sampled_from([1e308, -1e308, np.inf, np.nan, -0.0, 1e15, 1e9])


def predictor(name='scheduled', batch=()):
    run = Run(timeout_s=60.0)
    return Predictor(PredictorParams(filter=name), run, Legs(2, 2, run.step_s),
                     OrbitParams(), START, LevelForm(), batch)


def nominal(k, off=0.0):
    """Return the sample that comes down in step k."""
    m = max(k - 2, 0)
    return np.array([*np.array(START.position_m) + 0.5*m*np.array(START.velocity_m_s),
                     *START.velocity_m_s]) + off


def fly(made, samples):
    return [made.advance(k, sample, np.bool_(sample is not None), None if k == 0 else NOTHING)
            for k, sample in enumerate(samples)]


@settings(max_examples=60)
@given(st.lists(st.lists(NUMBERS, min_size=6, max_size=6), min_size=1, max_size=12),
       st.sampled_from(KINDS))
def test_what_is_valid_is_finite_whatever_comes_down(hostile, name):
    samples = [nominal(k) for k in range(6)] + [np.array(row) for row in hostile] + [nominal(40)]*15
    with np.errstate(all='ignore'):
        for got in fly(predictor(name), samples):
            if got.valid:
                assert (np.abs(got.predicted) <= FAR).all() and np.isfinite(got.estimate).all()
            else:
                assert np.isnan(got.predicted).all()
    assert got.valid                            # and it comes back


@pytest.mark.parametrize('name', KINDS)
@pytest.mark.parametrize('bad', [1e308, -1e308, 1e9, 50.0])
def test_an_outlier_is_as_good_as_a_lost_sample(name, bad):
    with_it = [nominal(k) for k in range(12)]
    without = list(with_it)
    with_it[8], without[8] = nominal(8, [bad, 0, 0, 0, 0, 0]), None
    made = predictor(name)
    with np.errstate(over='ignore'):
        ours = fly(made, with_it)
    for a, b in zip(ours, fly(predictor(name), without)):
        assert_array_equal(a.predicted, b.predicted)
        assert_array_equal(a.covariance, b.covariance)
    assert made._filter.gate.outliers == 1


def test_without_the_gate_one_of_them_is_enough(monkeypatch):
    def believing(self, innovation, prior, variance, noise, received):
        self.taken, self.anew = received, np.zeros_like(received)
        return self.taken, self.anew
    monkeypatch.setattr(Gate, 'judge', believing)
    samples = [nominal(k) for k in range(12)]
    samples[8] = nominal(8, [1e308, 0, 0, 0, 0, 0])
    with np.errstate(all='ignore'):
        last = fly(predictor(), samples)[-1]
    assert not last.valid or abs(last.predicted[0]) > 1e3


@pytest.mark.parametrize('name', KINDS)
def test_a_filter_that_is_wrong_is_not_locked_out(name):
    """The chaser is somewhere else for good: after ten samples the filter believes it."""
    there = np.array([100.0, -40.0, 0.0, 0.0, 0.0, 0.0])
    made = predictor(name)
    got = fly(made, [nominal(k) for k in range(8)] + [nominal(k, there) for k in range(8, 30)])
    for k, one in list(enumerate(got))[2:18]:
        assert abs(one.estimate[0] - nominal(k)[0]) < 2.0
    assert made._filter.gate.outliers == 10
    for k, one in list(enumerate(got))[18:]:
        assert abs(one.estimate[0] - nominal(k, there)[0]) < 2.0
    assert got[18].covariance[0, 0] > 2*got[17].covariance[0, 0]


def test_rows_of_a_batch_are_judged_alone_and_as_a_single_run():
    rng = np.random.default_rng(5)
    samples = [np.stack([nominal(k)]*4) + rng.normal(size=(4, 6))*0.02 for k in range(30)]
    for k in range(9, 24):
        samples[k][1, 0] += 1e6                 # one row, for longer than patience
    samples[12][2, 4] = 1e308
    every, one = predictor(batch=(4,)), [predictor() for _ in range(4)]
    with np.errstate(over='ignore'):
        for k, sample in enumerate(samples):
            both = every.advance(k, sample, np.ones(4, bool),
                                 None if k == 0 else np.zeros((4, 3), np.int8))
            for row in range(4):
                alone = one[row].advance(k, sample[row], np.bool_(True),
                                         None if k == 0 else NOTHING)
                assert_array_equal(alone.predicted, both.predicted[row])
    assert every._filter.gate.outliers.tolist()[0] == 0 and every._filter.gate.outliers[2] == 1
