"""The filter that learns: against the textbook, against chance, against what nobody knows of."""

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest
from scipy.linalg import expm

from rvd_groundstation.prediction import learned_compiled
from rvd_groundstation.prediction.filter import FILTERS
from rvd_groundstation.prediction.filter_params import FilterParams
from rvd_groundstation.prediction.predictor import PredictorParams

PAPER, PARAMS = Paper(), FilterParams()
CERTAIN = replace(PARAMS, noise_weight=1e300)   # of how noisy the sensor is
NOMINAL = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
SIGMA = np.sqrt(np.diagonal(PARAMS.start_covariance()))


def model():
    """Return Phi and Gamma by the matrix exponential of the augmented system."""
    n, a = PAPER.orbit.mean_motion, np.zeros((9, 9))
    a[:3, 3:6] = a[3:6, 6:] = np.eye(3)
    a[3, 4], a[4, 3], a[4, 1], a[5, 2] = -2*n, 2*n, 3*n*n, -n*n
    big = expm(a * 0.5)
    return big[:6, :6], big[:6, 6:]


PHI, GAMMA = model()


def textbook(samples, accels, spreads, received, factor=1.0):
    """Yield estimate and covariance of a Kalman filter, all six components at once."""
    x, p = NOMINAL.copy(), np.diag([0.3, 0.5, 0.5, 0.01, 0.02, 0.02])**2
    for m, (z, u, s) in enumerate(zip(samples, accels, spreads)):
        if m:
            q = np.diag((0.05*u)**2 + 3e-8**2 + s[:3])
            q[0, 1] = q[1, 0] = s[3]
            x, p = PHI @ x + GAMMA @ u, PHI @ p @ PHI.T + GAMMA @ q @ GAMMA.T
        if received[m]:
            r = factor*np.diag(1e-4*(x*x + np.diag(p)) + np.array([1e-8]*3 + [1e-10]*3))
            k = np.linalg.solve(p + r, p).T
            x, left = x + k @ (z - x), np.eye(6) - k
            p = left @ p @ left.T + k @ r @ k.T         # Joseph's form
        yield x, p


def calm(made):
    lanes = learned_compiled.LANES
    first = learned_compiled.UNKNOWN*lanes
    made._state[:, first:first + lanes] = PARAMS.unmodelled_m_s2**2


def test_is_the_textbook_filter_where_the_noise_is_as_assumed():
    rng = np.random.default_rng(1)
    u, received = rng.normal(scale=0.01, size=(60, 3)), rng.random(60) < 0.8
    spread = np.abs(rng.normal(scale=1e-5, size=(60, 4)))
    spread[:, 3] = rng.uniform(-1.0, 1.0, 60)*np.sqrt(spread[:, 0]*spread[:, 1])
    spread[:20] = 0.0
    z = NOMINAL + rng.normal(scale=0.02, size=(60, 6))
    made = PAPER.filter(FILTERS['learned'], CERTAIN)
    for m, (x, p) in enumerate(textbook(z, u, spread, received)):
        made.advance(m, u[m], z[m], np.bool_(received[m]), spread[m])
        calm(made)                                      # nor is anything unknown learned
        assert_allclose(made.estimate, x, rtol=1e-10, atol=1e-10)
        scale = np.sqrt(np.diag(p))
        assert_allclose(made.covariance / np.outer(scale, scale), p / np.outer(scale, scale),
                        atol=1e-7)


def test_its_gain_is_what_a_sample_moves_the_estimate_by():
    rng = np.random.default_rng(2)
    made, other = (PAPER.filter(FILTERS['learned'], PARAMS) for _ in range(2))
    z = NOMINAL + rng.normal(scale=0.02, size=(9, 6))
    for m in range(9):
        more = rng.normal(scale=0.01, size=6) if m == 8 else np.zeros(6)
        made.advance(m, np.zeros(3), z[m], np.bool_(True))
        other.advance(m, np.zeros(3), z[m] + more, np.bool_(True))
    assert_allclose(other.estimate - made.estimate, made.gain(8) @ more, atol=1e-13)


class Flown:
    """Free flights that scatter as the filter thinks; noise and thrust it may not know."""

    def __init__(self, rows, steps=240, noise=0.01, unknown=(0.0, 0.0, 0.0), seed=3, params=None):
        rng, paper = np.random.default_rng(seed), Paper()
        self.predictor = paper.predictor(params or PredictorParams(), (rows,))
        self.truth = [NOMINAL + rng.normal(size=(rows, 6))*SIGMA]
        for _ in range(steps + 20):
            self.truth.append(self.truth[-1] @ PHI.T + GAMMA @ unknown)
        self.truth = np.array(self.truth)
        measured = self.truth * (1 + noise*rng.normal(size=self.truth.shape))
        self.got = [self.predictor.advance(
            k, measured[k - 10] if k >= 10 else None, np.full(rows, k >= 10),
            None if k == 0 else np.zeros((rows, 3), np.int8)) for k in range(steps)]

    def nees(self, k):
        """Return the normalised errors squared (rows,) of the prediction made at step k."""
        error = self.got[k].predicted - self.truth[k + 10]
        return np.einsum('ni,nij,nj->n', error, np.linalg.inv(self.got[k].covariance), error)


@pytest.mark.parametrize('noise', [0.003, 0.01, 0.05])
def test_errors_are_as_large_as_it_says_whatever_the_sensor(noise):
    """Once it has seen some samples; before, all it knows is what was assumed."""
    rows = 400
    flown = Flown(rows, noise=noise)
    for k in (30, 60, 120, 239):
        assert 0.8*6.0 < flown.nees(k).mean() < 6.0 + 5*np.sqrt(12.0/rows)
    factor = flown.predictor._filter.factor
    # the part that does not depend on the state counts for more where the noise is small
    assert factor.mean() == pytest.approx((noise/0.01)**2, rel=0.06)
    assert factor.std() < 0.12*factor.mean()


def test_a_filter_that_does_not_learn_would_be_seen():
    certain = PredictorParams(kalman=CERTAIN)
    assert Flown(100, steps=60, noise=0.05, params=certain).nees(59).mean() > 30.0


@pytest.mark.parametrize('axis', range(3))
@pytest.mark.parametrize('size', [4e-4, 2e-3])
def test_what_nobody_knows_of_is_followed_and_owned_up_to(axis, size):
    """
    An acceleration for good: ten thousand times what is assumed, and a fifth of a level.

    It shows after a while, along track after a minute: there the sensor is worst.
    """
    flown = Flown(50, unknown=np.eye(3)[axis]*size)
    for k in (120, 160, 239):
        error = flown.got[k].estimate - flown.truth[k - 10]
        assert np.abs(error).max() < 0.3        # it has moved the craft by 0.6 to 14 m
        assert flown.nees(k).mean() < 6.0


def test_a_filter_that_learns_nothing_of_it_would_be_seen():
    scheduled = PredictorParams(filter='scheduled')
    assert Flown(50, unknown=(0.0, 2e-3, 0.0), params=scheduled).nees(239).mean() > 100.0


def test_what_it_learns_is_forgotten_when_it_is_over():
    made = PAPER.filter(FILTERS['learned'], PARAMS)
    rng, x, most = np.random.default_rng(5), NOMINAL + [0.0, 1.0, 1.0, 0.0, 0.0, 0.0], 0.0
    for m in range(1200):
        made.advance(m, np.zeros(3), x * (1 + 0.01*rng.normal(size=6)), np.bool_(True))
        x = PHI @ x + GAMMA @ [0.0, 2e-3 if m < 100 else 0.0, 0.0]
        most = max(most, float(made.unknown))
    assert np.sqrt(most) > 1e-3 and np.sqrt(made.unknown) < 1e-4


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.0, 1.0))
def test_covariances_are_symmetric_and_positive_whatever_comes(seed, lost):
    rng = np.random.default_rng(seed)
    made = PAPER.filter(FILTERS['learned'], PARAMS, (5,))
    for m in range(40):
        z = NOMINAL + rng.normal(size=(5, 6))*10.0**rng.uniform(-4, 4)
        made.advance(m, rng.normal(scale=0.02, size=(5, 3)), z, rng.random(5) >= lost)
    p = made.covariance
    scale = np.sqrt(np.diagonal(p, axis1=1, axis2=2))
    assert np.isfinite(p).all() and (scale > 0.0).all()
    p = p / (scale[:, :, None]*scale[:, None])
    assert_allclose(p, np.swapaxes(p, 1, 2), rtol=0, atol=1e-14)
    assert np.linalg.eigvalsh(p).min() > -1e-7


def test_restored_it_goes_on_as_it_did():
    rng = np.random.default_rng(6)
    z = NOMINAL + rng.normal(scale=0.1, size=(40, 6))
    made = PAPER.filter(FILTERS['learned'], PARAMS)
    for m in range(20):
        made.advance(m, np.zeros(3), z[m], np.bool_(True))
    then, first = made.state(), []
    for _ in range(2):
        made.restore(then)
        for m in range(20, 40):
            made.advance(m, np.zeros(3), z[m], np.bool_(m % 3 > 0))
        first.append((made.estimate, made.covariance, made.factor))
    for a, b in zip(*first):
        assert_array_equal(a, b)
