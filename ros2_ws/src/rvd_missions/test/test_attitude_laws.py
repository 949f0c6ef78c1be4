"""The laws that hold an axis, and the model that one of them identifies."""

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from rvd_dynamics.diagram.in_process import fly
from rvd_missions.attitude_hold import tuning
from rvd_missions.attitude_hold.laws import characteristic_model as model
from rvd_missions.attitude_hold.laws import LAWS
from rvd_missions.attitude_hold.laws.characteristic_model import F1, F2, Identifier, projected, SUM
from rvd_missions.attitude_hold.laws.golden_section import GoldenSection, L1, L2
from rvd_missions.attitude_hold.laws.pid import Pid
from scipy import signal
from scipy.spatial import HalfspaceIntersection

STEP_S = 0.5
PLANES = np.array([[-1, 0, F1[0]], [1, 0, -F1[1]], [0, -1, F2[0]], [0, 1, -F2[1]],
                   [-1, -1, SUM[0]], [1, 1, -SUM[1]]], dtype=float)     # a x <= -c
CORNERS = HalfspaceIntersection(PLANES, np.array([1.7, -0.75])).intersections
LAW = pytest.mark.parametrize('law', LAWS.values(), ids=LAWS)


# -- the range of the model ------------------------------------------------------------------

@given(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0))
def test_projection_gives_the_nearest_point_of_the_range(f1, f2):
    """Optimal for a convex set: no corner lies on the given point's side of it."""
    found = np.array(projected(f1, f2))
    assert np.all(PLANES[:, :2] @ found + PLANES[:, 2] <= 1e-12)
    assert np.all((CORNERS - found) @ (np.array([f1, f2]) - found) <= 1e-9)


def test_what_is_in_the_range_stays_as_it_is():
    assert_array_equal(projected(1.8, -0.85), (1.8, -0.85))


def test_the_double_integrator_lies_just_outside_and_is_moved_to_a_corner():
    assert_allclose(projected(2.0, -1.0), (1.9975, -0.9999))


# -- identification --------------------------------------------------------------------------

def data(f1, f2, b, steps, noise=0.0, seed=3):
    """Return y and v of the model, driven by chance."""
    rng = np.random.default_rng(seed)
    y, v = np.zeros(steps), rng.normal(size=steps)
    for k in range(2, steps):
        y[k] = f1*y[k - 1] + f2*y[k - 2] + b*v[k - 1] + noise*rng.normal()
    return y, v


def identified(y, v, **changes):
    """Return the estimate after all samples."""
    given_ = {'forgetting': 1.0, 'dead_zone': 0.0, 'variances': (0.5, 2.0), 'bounds': (0.1, 20.0),
              'batch': (), **changes}
    found = Identifier(**given_)
    for k in range(2, len(y)):
        found.learn(y[k], (y[k - 1], y[k - 2], v[k - 1]), np.True_)
    return np.array(found.estimate)


@pytest.mark.parametrize('forgetting', [1.0, 0.97])
def test_recursive_is_batch_least_squares_with_the_prior(monkeypatch, forgetting):
    """By numpy.linalg.lstsq on all samples at once, where no bound is in the way."""
    monkeypatch.setattr(model, 'projected', lambda f1, f2: (np.asarray(f1), np.asarray(f2)))
    y, v = data(1.7, -0.8, 2.0, 60, noise=0.3)
    found = identified(y, v, forgetting=forgetting, bounds=(-1e6, 1e6), variances=(1e-3, 1e-3))
    rows = np.stack([y[1:-1], y[:-2], v[1:-1]], axis=1)
    n = len(rows)
    weight = np.sqrt(forgetting**np.arange(n - 1, -1, -1))
    prior = np.sqrt(forgetting**n)*np.eye(3)/np.sqrt(1e-3)
    start = np.array([2.0, -1.0, 1.0])
    a = np.concatenate([rows*weight[:, None], prior])
    assert_allclose(found, np.linalg.lstsq(a, np.concatenate([y[2:]*weight, prior @ start]),
                                           rcond=None)[0], rtol=1e-8)


def test_what_made_the_data_is_found():
    y, v = data(1.75, -0.8, 2.5, 400)
    assert_allclose(identified(y, v, forgetting=0.95), [1.75, -0.8, 2.5], rtol=1e-3)


@given(st.integers(0, 10_000), st.floats(0.9, 1.0), st.floats(0.01, 10.0))
def test_estimates_never_leave_range_and_bounds(seed, forgetting, size):
    rng = np.random.default_rng(seed)
    y, v = size*rng.normal(size=(2, 40))
    f1, f2, b = identified(y, v, forgetting=forgetting, bounds=(0.4, 3.0))
    assert np.all(PLANES[:, :2] @ (f1, f2) + PLANES[:, 2] <= 1e-12) and 0.4 <= b <= 3.0


def test_residuals_within_the_dead_zone_teach_nothing():
    y, v = data(1.9975, -0.9999, 1.0, 60, noise=0.01)
    assert_array_equal(identified(y, v, dead_zone=0.06), identified(y[:2], v))
    assert not np.array_equal(identified(y, v, dead_zone=0.006), identified(y[:2], v))


def test_forgetting_without_excitation_does_not_blow_up_the_matrix():
    found = Identifier(0.9, 0.0, (0.1, 1.0), (0.1, 10.0), ())
    for k in range(2000):
        found.learn(np.float64(1e-9*(-1)**k), (np.float64(1e-9), np.float64(0), np.float64(0)),
                    np.True_)
    assert np.isfinite(found._matrix).all() and max(map(float, found._matrix)) <= 10.0


# -- contract of the laws ----------------------------------------------------------------------

def wanted(law, angles, fresh=True):
    """Return what a law wants along a track (steps, ...) of angles [rad], commands fed back."""
    batch = angles.shape[1:]
    at_work, acted, made = law.controller(STEP_S, batch), np.zeros(batch), []
    for k in range(2, len(angles)):
        acted = at_work.wanted((angles[k], angles[k - 1], angles[k - 2]), acted,
                               np.full(batch, fresh))
        made.append(acted)
    return np.array(made)


def tracks(rows, steps=40, seed=1):
    return 0.01*np.cumsum(np.random.default_rng(seed).normal(size=(steps, rows)), axis=0)


@LAW
@pytest.mark.parametrize('rows', [1, 7, 300])
@pytest.mark.parametrize('order', 'CF')
def test_a_row_is_the_same_to_the_bit_alone_and_in_any_batch(law, rows, order):
    angles = np.asarray(tracks(rows), order=order)
    together = wanted(law(), angles)
    for row in {0, rows//2, rows - 1}:
        assert_array_equal(together[:, row], wanted(law(), angles[:, row].copy()))


@LAW
def test_a_mirrored_track_gets_the_mirrored_answer(law):
    angles = tracks(20)
    assert_allclose(wanted(law(), -angles), -wanted(law(), angles), rtol=1e-12)


@LAW
def test_an_axis_at_rest_off_the_reference_is_pushed_back(law):
    assert np.all(wanted(law(), np.full((5, 1), 0.01)) < 0.0)


@LAW
def test_unknown_samples_spoil_nothing_that_comes_later(law):
    angles = np.repeat(tracks(1), 2, axis=1)
    at_work = law().controller(STEP_S, (2,))
    for k in range(2, 30):
        errors = [angles[k - i].copy() for i in range(3)]
        if k < 10:
            for e in errors:
                e[1] = np.nan
        out = at_work.wanted(tuple(errors), np.zeros(2), np.isfinite(errors[0]))
        assert np.isfinite(out[0]) and np.isnan(out[1]) == (k < 10)


# -- each law --------------------------------------------------------------------------------

def test_golden_section_is_the_formula_without_adaptation():
    law = GoldenSection(adapts=False, softening=0.5, derivative_per_s=0.3)
    now, before = 0.4, 0.1                                      # deg
    f1, f2 = projected(2.0, -1.0)
    u = -(0.381966*f1*now + 0.618034*f2*before)/(1.5*STEP_S**2)
    u -= 0.3*np.sqrt(0.5)*(now - before)/STEP_S
    found = law.controller(STEP_S, ()).wanted(
        tuple(np.radians([now, before, 0.0])), np.zeros(()), np.True_)
    assert_allclose(np.degrees(found), u, rtol=1e-6)


def test_golden_section_learns_a_lower_gain_and_pushes_harder():
    """The double integrator with 0.3 of the gain; the model is told what was commanded."""
    at_work = GoldenSection(lowest_gain=0.1, b_variance=10.0).controller(STEP_S, ())
    y = [0.0, 0.0, 0.3]
    u, before = 0.0, 0.0
    for _ in range(60):
        errors = tuple(np.radians(y[-1:-4:-1]))
        u, before = float(np.degrees(at_work.wanted(errors, np.radians(u), np.True_))), u
        y.append(2*y[-1] - y[-2] + 0.3*STEP_S**2/2*(u + before))
    assert at_work.inside['b'] < 0.6


def test_pid_is_the_sum_of_three_filters_of_scipy():
    law = Pid(proportional_per_s2=0.2, integral_per_s3=0.03, derivative_per_s=0.7, filter_s=1.3,
              integral_limit_deg_s=1e6)
    angles = tracks(1)[:, 0]
    angles[:2] = 0.0
    n, c = angles[2:], STEP_S/(STEP_S + 1.3)
    integral = signal.lfilter([STEP_S], [1.0, -1.0], n)
    rate = signal.lfilter([c/STEP_S, -c/STEP_S], [1.0, -(1.0 - c)], n)
    assert_allclose(wanted(law, angles), -(0.2*n + 0.03*integral + 0.7*rate), rtol=1e-9, atol=1e-15)


def test_the_integral_of_pid_is_bounded_on_both_sides():
    law = Pid(proportional_per_s2=0.0, derivative_per_s=0.0, integral_per_s3=1.0,
              integral_limit_deg_s=2.0)
    assert_allclose(np.degrees(wanted(law, np.full((300, 1), 0.1)))[-1], -2.0)
    assert_allclose(np.degrees(wanted(law, np.full((300, 1), -0.1)))[-1], 2.0)


def test_the_golden_shares():
    assert_allclose([L1, L2], [0.382, 0.618], atol=1e-4)


# -- tuning ------------------------------------------------------------------------------------

@LAW
def test_the_bench_of_the_tuning_flies_each_case_to_the_bits_of_the_mission(law):
    """All cases in one batch, strung together by hand, against the diagram one by one."""
    cases = (tuning.Case(0.4, 2.0), tuning.Case(2.5, 0.5, 0.001), tuning.Case(2.5, 2.0))
    base = tuning.base().with_values('/**', timeout_s=200.0, limits__window_s=40.0)
    name = next(name for name, one in LAWS.items() if one is law)
    bench = tuning.Bench(base, cases, runs=3).fly(law())
    for at, (actuator, sensor, torque) in enumerate(cases):
        one = base.with_values('/**', faults__actuator_gain=actuator, faults__sensor_gain=sensor)
        one = one.with_values('attitude_dynamics', disturbance_n_m=torque)
        flown = fly(one.with_values('attitude_controller', law=name), range(3)).verdict
        for measure, values in flown.values.items():
            assert_array_equal(bench.values[measure][3*at:3*at + 3], values, err_msg=measure)


def test_the_search_is_over_the_parameters_that_the_laws_have_and_within_their_bounds():
    for name, ranges in tuning.RANGES.items():
        for place in (np.zeros(len(ranges)), np.ones(len(ranges))):
            LAWS[name](**tuning.values(name, place))


@LAW
def test_no_point_near_the_defaults_is_much_better_on_the_runs_of_the_tuning(law):
    """The defaults are what the search has found, in the figures that are written down."""
    name = next(name for name, one in LAWS.items() if one is law)
    bench = tuning.Bench(tuning.base())
    least = bench.cost(law())
    for parameter in tuning.RANGES[name]:
        value = getattr(law(), parameter)
        for factor in (0.5, 2.0):
            if parameter in tuning.FROM_ONE:
                other = 1.0 - factor*(1.0 - value)
            else:
                other = factor*value
            low, high = tuning.RANGES[name][parameter]
            if low <= other <= high:
                assert bench.cost(law(**{parameter: other})) > least - 0.005, parameter
