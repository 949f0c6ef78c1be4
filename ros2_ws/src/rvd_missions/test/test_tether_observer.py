"""The observer on board: a filter that numpy writes anew, and a baseline that need not be known."""

from pathlib import Path

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_missions.tether import motion, observer
from tether_cases import CRAFT, GEO, GRIPPER, over_step

ROOT = Path(__file__).resolve().parents[4]
NOISE = {'encoder_sigma_m': 0.005, 'bearing_sigma_rad': 5e-4, 'attitude_sigma_rad': 5e-4}
X = np.array([40.0, 1.5, -1.0, 0.8, 0.05, -0.03, 0.7, 0.01])
U = np.array([2.0, 0.3, -0.4, 0.5, 0.0, 0.0, 0.0])
ALONG = np.array([np.cos(0.01), np.sin(0.01)])
ORBIT = over_step(GEO, 50.0, 0.02)[1]


def covariance():
    root = np.random.default_rng(5).normal(size=(8, 8))
    return root @ root.T/8.0


def seen(x):
    sight = np.array([(101.0 + x[6])*ALONG[0], (101.0 + x[6])*ALONG[1], 0.0]) - x[:3]
    return np.array([np.linalg.norm(x[:3]), np.arctan2(sight[1], sight[0]),
                     np.arctan2(sight[2], np.hypot(sight[0], sight[1]))])


def slopes(f, x):
    step = 1e-6*np.maximum(np.abs(x), 1.0)
    return np.stack([(f(x + s) - f(x - s))/(2.0*s.sum()) for s in np.diag(step)], axis=-1)


def predicted(x, h=0.02):
    made = x[np.newaxis].copy()
    observer.predict(made, np.zeros((1, 8, 8)), U[np.newaxis], ORBIT, GRIPPER.mass_kg, 0.0, h)
    return made[0]


def test_it_predicts_the_motion_of_the_plant():
    """Mass off by q: commands act as on a craft of m/(1 - q)."""
    state = np.concatenate([X[:6], [0.0, 0.0, 0.0, 1.0], np.zeros(3)])[np.newaxis]
    craft = CRAFT.copy()
    craft[0] = GRIPPER.mass_kg/(1.0 - X[7])
    moved = motion.advance(state, U[np.newaxis], over_step(GEO, 50.0, 0.02), craft[np.newaxis],
                           0.02)
    assert_allclose(predicted(X)[:6], moved[0, :6], atol=1e-8)


def test_covariances_are_those_of_numpys_filter():
    x, cov = X[np.newaxis].copy(), covariance()[np.newaxis]
    observer.predict(x, cov, U[np.newaxis], ORBIT, GRIPPER.mass_kg, 30.0, 0.02)
    jump, white = slopes(predicted, X), np.zeros((8, 8))
    white[3:6, 3:6] = 0.02*(30.0/GRIPPER.mass_kg)**2*np.eye(3)
    # the turning of thrust across, h F/(m l), is left out of the filter's Jacobian
    assert_allclose(cov[0], jump @ covariance() @ jump.T + white, rtol=1e-4, atol=2e-5)


def test_one_measurement_at_a_time_is_the_textbook_correction():
    sigma, z = np.array([0.05, 2e-3, 2e-3]), seen(X) + [0.03, 1e-3, -2e-3]
    for which in range(3):
        only = np.where(np.arange(3) == which, z, np.nan)[np.newaxis]
        x, cov = X[np.newaxis].copy(), covariance()[np.newaxis]
        missed = np.zeros((1, 3), dtype=np.int64)
        observer.correct(x, cov, only, sigma, ALONG, 101.0, np.inf, 1, missed)
        h = slopes(seen, X)[which]
        gain = covariance() @ h/(h @ covariance() @ h + sigma[which]**2)
        assert_allclose(x[0], X + gain*(z - seen(X))[which], rtol=1e-5, atol=1e-7)
        assert_allclose(cov[0], covariance() - np.outer(gain, h @ covariance()), atol=1e-6)
        assert_array_equal(cov[0], cov[0].T)


def test_a_shifted_plan_ends_where_it_should_for_the_true_baseline():
    place, target = np.array([81.0, 0.5, -0.2]), np.array([101.0, 0.7, 0.0])
    length, alpha, beta, far = observer.shifted(place, target, np.array([1.5]), 1.0)[0]
    along = target/np.linalg.norm(target)
    assert length == pytest.approx(np.linalg.norm(place + 1.5*along))
    assert far == pytest.approx(np.linalg.norm(target - place))         # the planned range
    assert alpha == pytest.approx(0.2/20.0, abs=1e-5) and beta == pytest.approx(0.2/20.0, abs=1e-5)
    unmoved = observer.shifted(place, target, np.array([1.5]), 0.0)[0]
    assert unmoved[3] == pytest.approx(far + 1.5, abs=1e-3)


def flown(on, runs, step=0.05, **shared):
    scenario = load(ROOT / 'scenarios' / 'tether.yaml').with_values(
        '/**', step_s=step, **shared)
    scenario = scenario.with_values('gripper_sensors', **NOISE).with_values(
        'gripper_dynamics', baseline_sigma_m=1.0).with_values(
            'gripper_tracker', observer__on=on)
    return fly(scenario, runs)


@pytest.mark.slow
@pytest.mark.patient
def test_it_takes_away_most_of_the_error_of_the_baseline_and_of_the_thrust():
    """The default release, the same noise and baselines for both."""
    without, with_it = (flown(on, range(12)).verdict.values for on in (False, True))
    before, after = (np.sqrt(np.mean(v['range_error_m']**2)) for v in (without, with_it))
    assert before > 0.7 and after < 0.15*before
    assert with_it['fuel_N_s'].mean() < 0.6*without['fuel_N_s'].mean()
    assert with_it['cross_error_m'].max() < 0.01


def test_a_row_is_the_same_alone_and_in_a_batch():
    whole, alone = flown(True, range(3), step=0.1), flown(True, [2], step=0.1)
    assert whole.verdict.values['range_error_m'][2] == alone.verdict.values['range_error_m'][0]


def test_behind_the_link_it_is_refused():
    scenario = load(ROOT / 'scenarios' / 'tether_delay.yaml').with_values(
        'gripper_tracker', observer__on=True)
    with pytest.raises(BadInput, match='observer.on must be false'):
        fly(scenario, [0])
