"""The judge on motions whose events are known in closed form, and against brute force."""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq, minimize_scalar

from rvd_dynamics.commands.levels import acceleration, ThrustParams
from rvd_dynamics.diagram.judge import judgement
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry import cone
from rvd_dynamics.geometry.cone import Cone
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.world.plants.relative import Cw
from rvd_missions.lunar_approach.end import ended
from rvd_missions.lunar_approach.judge import AMONG, Judge, REASONS
from rvd_missions.lunar_approach.settings import DockingParams

H = 0.5                                             # [s] step
CONE, DOCKING = Cone(), DockingParams()
RUN = Run(step_s=H)
REST = np.zeros(3)


def straight(start, accel, t):
    """Return the state after `t` under constant acceleration, far from any orbit."""
    start, accel = np.asarray(start, dtype=float), np.asarray(accel, dtype=float)
    return np.concatenate([start[:3] + start[3:]*t + accel*t*t/2, start[3:] + accel*t])


def seen(verdict):
    """Return a verdict with its measures by short names, and the exit as one position (..., 3)."""
    v = verdict.values
    return SimpleNamespace(
        success=verdict.success, reason=verdict.reason, duration=verdict.duration,
        x_rate=v['x_rate_m_s'], offset=v['offset_m'], lateral_rate=v['lateral_rate_m_s'],
        min_corridor_margin=v['min_corridor_margin_m'], delta_v=v['delta_v_m_s'],
        exit_time=v['exit_time_s'],
        exit_position=np.stack([v[f'exit_{axis}_m'] for axis in 'xyz'], axis=-1))


def fields(verdict):
    """Return every field of a verdict with its name, the measures among them."""
    return {'success': verdict.success, 'reason': verdict.reason, 'duration': verdict.duration,
            **verdict.values}


def judged(start, *accels, run=RUN, docking=DOCKING, until_end=True):
    """Judge a flight from `start` with one acceleration per step, then coasting."""
    judge, state, step = Judge(run, CONE, docking), np.asarray(start, dtype=float), 0
    judge.start(state)
    while not judge.ended and (until_end or step < len(accels)):
        accel = np.asarray(accels[step] if step < len(accels) else REST, dtype=float)
        step += 1
        state = straight(state, accel, run.step_s)
        judge.advance(step, state, accel)
    return seen(judge.verdict())


# -- docking ----------------------------------------------------------------------------------

def test_a_straight_approach_docks_between_two_samples():
    v = judged([-1.03, 0.1, -0.05, 0.25, 0.002, 0.01])
    assert (v.success, v.reason) == (True, 'docked')
    assert v.duration == pytest.approx(4.12, abs=1e-9)
    assert v.x_rate == pytest.approx(0.25, abs=1e-12)
    y, z = 0.1 + 0.002*4.12, -0.05 + 0.01*4.12
    assert v.offset == pytest.approx(np.hypot(y, z), abs=1e-9)
    assert v.lateral_rate == pytest.approx(np.hypot(0.002, 0.01), abs=1e-12)
    assert np.isnan(v.exit_time) and np.isnan(v.exit_position).all()


def test_a_thrusting_approach_docks_at_the_root_of_its_parabola():
    start, accel = [-0.1, 0.0, 0.0, 0.2, 0.0, 0.0], [0.03, 0.0, -0.01]
    v = judged(start, accel)
    t = (-0.2 + np.sqrt(0.04 + 2*0.03*0.1)) / 0.03
    assert v.duration == pytest.approx(t, abs=1e-8)
    assert_allclose([v.x_rate, v.offset, v.lateral_rate],
                    [0.2 + 0.03*t, 0.005*t*t, 0.01*t], atol=1e-8)


def test_thrust_counts_up_to_the_docking_only():
    v = judged([-0.25, 0.0, 0.0, 0.2, 0.0, 0.0], [0.0, 0.01, -0.02], [0.0, -0.005, 0.0],
               [0.01, 0.0, 0.0])
    t = (-0.2 + np.sqrt(0.04 + 2*0.01*0.05)) / 0.01     # third step: 0.05 m to go
    assert v.delta_v == pytest.approx(H*0.03 + H*0.005 + t*0.01, abs=1e-9)


def test_a_sample_exactly_on_the_plane_has_docked():
    v = judged([-0.125, 0.0, 0.0, 0.25, 0.0, 0.0])
    assert v.success and v.duration == H


def test_there_and_back_between_two_samples_is_a_docking():
    start, accel = [-0.0005, 0.0, 0.0, 0.01, 0.0, 0.0], [-0.06, 0.0, 0.0]
    assert straight(start, accel, H)[0] < 0.0
    v = judged(start, accel)
    t = (0.01 - np.sqrt(1e-4 - 2*0.06*0.0005)) / 0.06
    assert v.success and v.duration == pytest.approx(t, abs=1e-7)
    assert v.x_rate == pytest.approx(0.01 - 0.06*t, abs=1e-8)


def test_almost_there_and_back_is_none():
    v = judged([-0.00084, 0.0, 0.0, 0.01, 0.0, 0.0], [-0.06, 0.0, 0.0], until_end=False)
    assert v.reason == '' and np.isnan(v.x_rate)    # turns at 0.000833 m


@pytest.mark.parametrize('rate, reason', [(0.2999, 'docked'), (0.3, 'closing_rate'),
                                          (0.35, 'closing_rate')])
def test_the_closing_rate_must_stay_below_its_limit(rate, reason):
    v = judged([-1.0, 0.0, 0.0, rate, 0.0, 0.0])
    assert (v.success, v.reason) == (reason == 'docked', reason)
    assert v.x_rate == pytest.approx(rate, abs=1e-12)


def test_coming_to_rest_on_the_plane_is_no_docking():
    v = judged([-0.125, 0.0, 0.0, 0.5, 0.0, 0.0], [-1.0, 0.0, 0.0])
    assert (v.success, v.reason, v.x_rate, v.duration) == (False, 'closing_rate', 0.0, H)


def test_the_lateral_rate_must_stay_below_its_limit():
    docking = DockingParams(max_lateral_rate_m_s=0.05)
    v = judged([-0.5, 0.0, 0.0, 0.25, 0.03, 0.05], docking=docking)
    assert v.reason == 'lateral_rate' and v.lateral_rate == pytest.approx(np.hypot(.03, .05))
    assert judged([-0.5, 0.0, 0.0, 0.25, 0.03, 0.03], docking=docking).reason == 'docked'


def test_the_reasons_are_those_of_the_message():
    assert REASONS.tolist() == ['', 'docked', 'invalid', 'left_corridor', 'closing_rate',
                                'offset', 'lateral_rate', 'timeout', 'contact', 'deadlock']


# -- the corridor -----------------------------------------------------------------------------

def test_margin_of_a_straight_run_is_that_of_its_worst_end():
    v = judged([-1.03, 0.1, 0.0, 0.25, 0.0, 0.0])
    expected = cone.signed_distance([0.0, 0.1, 0.0], CONE)
    assert v.min_corridor_margin == pytest.approx(expected, abs=1e-10)


def test_an_exit_is_timed_and_placed_and_does_not_end_the_run():
    v = judged([-10.0, 0.5, 0.0, 0.25, 0.05, 0.0])
    wall = 0.3 + 10.0*CONE.tan_alpha
    t = (wall - 0.5) / (0.05 + 0.25*CONE.tan_alpha)
    assert v.exit_time == pytest.approx(t, abs=1e-8)
    assert_allclose(v.exit_position, [-10.0 + 0.25*t, 0.5 + 0.05*t, 0.0], atol=1e-8)
    assert (v.success, v.reason) == (False, 'left_corridor')
    assert v.duration == pytest.approx(40.0, abs=1e-9) and v.offset == pytest.approx(2.5)


def dense(start, accel):
    """Return the margin as a function of time under constant acceleration."""
    return lambda t: float(cone.signed_distance(straight(start, accel, t)[:3], CONE))


@pytest.mark.parametrize('step_s', [0.05, 0.5, 1.0])
def test_leaving_and_coming_back_between_two_samples_is_leaving(step_s):
    run = Run(step_s=step_s)
    wall, accel = 0.3 + 10.0*CONE.tan_alpha, np.array([0.0, -0.02, 0.0])
    rate = -accel[1]*step_s/2                       # outward, back at the end of the step
    inside = 0.4 * rate**2/(2*0.02)                 # start less than the height from the wall
    start = [-10.0, wall - inside, 0.0, 0.0, rate, 0.0]
    margin = dense(start, accel)
    assert margin(0.0) > 0 and margin(step_s) > 0
    lowest = minimize_scalar(margin, bounds=(0.0, step_s), method='bounded',
                             options={'xatol': 1e-12})
    assert lowest.fun < 0
    v = judged(start, accel, run=run, until_end=False)
    assert v.min_corridor_margin == pytest.approx(lowest.fun, abs=1e-8)
    t = brentq(margin, 0.0, lowest.x, xtol=1e-14)
    assert v.exit_time == pytest.approx(t, abs=1e-6)
    assert_allclose(v.exit_position, straight(start, accel, t)[:3], atol=1e-7)


def test_coming_close_between_two_samples_without_leaving_is_seen():
    accel, start = [0.0, 0.0, -0.02], [-10.0, 0.0, 0.82, 0.0, 0.0, 0.005]
    margin = dense(start, accel)
    lowest = minimize_scalar(margin, bounds=(0.0, H), method='bounded').fun
    assert 0 < lowest < min(margin(0.0), margin(H)) - 1e-4
    v = judged(start, accel, until_end=False)
    assert v.min_corridor_margin == pytest.approx(lowest, abs=1e-8)
    assert np.isnan(v.exit_time)


def test_what_lies_behind_the_docking_plane_does_not_count():
    start = [-0.01, 0.29, 0.0, 0.25, 0.1, 0.0]      # sample at x = 0.115 has y = 0.34
    v = judged(start)
    assert (v.success, v.reason) == (True, 'docked')
    assert v.offset == pytest.approx(0.29 + 0.1*0.04)
    assert v.min_corridor_margin > 0


def test_the_last_way_to_the_plane_counts_for_the_margin():
    # in, then out again in the last tenth of a second: lower at the plane than at any sample
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-0.5, 0.2, 0.0, 0.25, 0.0, 0.0])
    judge.advance(1, [-0.115, 0.15, 0.0, 0.25, 0.0, 0.0], REST)
    judge.advance(2, [0.01, 0.2, 0.0, 0.25, 0.24, 0.0], REST)
    v = seen(judge.verdict())
    spline = CubicHermiteSpline([0, H], [[-0.115, 0.15, 0], [0.01, 0.2, 0]],
                                [[0.25, 0, 0], [0.25, 0.24, 0]])
    place = spline(0.46)
    assert v.offset == pytest.approx(place[1], abs=1e-9)
    assert v.min_corridor_margin == pytest.approx(cone.signed_distance(place, CONE), abs=1e-8)


def test_leaving_just_before_the_docking_plane_counts():
    start = [-0.1, 0.29, 0.0, 0.25, 0.1, 0.0]
    v = judged(start)
    assert v.reason == 'left_corridor' and v.exit_time < v.duration == pytest.approx(0.4)
    t = brentq(dense(start, REST), 0.0, 0.4, xtol=1e-14)
    assert v.exit_time == pytest.approx(t, abs=1e-8)


def test_a_run_that_starts_outside_left_at_once():
    start = [-30.0, 1.9, 0.0, 0.25, -0.02, 0.0]
    v = judged(start, REST, until_end=False)        # inside again after a second
    assert v.exit_time == 0.0
    v = judged(start)
    assert (v.reason, v.exit_time) == ('left_corridor', 0.0)
    assert v.exit_position.tolist() == start[:3]
    assert v.min_corridor_margin <= cone.signed_distance(start[:3], CONE)


# -- other ends -------------------------------------------------------------------------------

def test_a_run_that_does_not_come_is_timed_out():
    v = judged([-1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert (v.success, v.reason, v.duration) == (False, 'timeout', 200.0)
    assert np.isnan([v.x_rate, v.offset, v.lateral_rate]).all()


def test_the_time_limit_off_the_grid_ends_at_the_step_after_it():
    v = judged([-1.0, 0.0, 0.0, 0.0, 0.0, 0.0], run=Run(step_s=0.5, timeout_s=1.2))
    assert (v.reason, v.duration) == ('timeout', 1.5)


def test_of_leaving_and_timing_out_the_first_is_named():
    v = judged([-1.0, 0.0, 0.0, 0.0, 0.05, 0.0])
    assert v.reason == 'left_corridor' and v.duration == 200.0


@pytest.mark.parametrize('bad', [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize('where', range(9))
def test_p10_truth_that_is_not_finite_is_invalid_wherever_it_stands(where, bad):
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    judge.advance(1, [-29.875, 0.0, 0.0, 0.25, 0.0, 0.0], REST)
    truth = np.array([-29.75, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0])
    truth[where] = bad
    judge.advance(2, truth[:6], truth[6:])
    v = seen(judge.verdict())
    assert judge.ended and (v.success, v.reason, v.duration) == (False, 'invalid', H)
    assert np.isfinite([v.min_corridor_margin, v.delta_v]).all()    # what was known is kept


def test_p10_truth_that_is_not_finite_cannot_dock_even_beyond_the_plane():
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-0.1, 0.0, 0.0, 0.25, 0.0, 0.0])
    judge.advance(1, [0.025, np.nan, 0.0, 0.25, 0.0, 0.0], REST)
    assert judge.verdict().reason == 'invalid'


def test_leaving_does_not_hide_what_came_later():
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-1.0, 0.5, 0.0, 0.25, 0.0, 0.0])
    assert (judge.verdict().reason, judge.verdict().values['exit_time_s']) == ('', 0.0)
    judge.advance(1, np.full(6, np.nan), REST)
    assert (judge.verdict().reason, judge.verdict().values['exit_time_s']) == ('invalid', 0.0)


@pytest.mark.parametrize('start', [[0.0, 0.0, 0.0, 0.25, 0.0, 0.0], [2.0] + [0.0]*5,
                                   [np.nan] + [0.0]*5, [-1.0, 0.0, 0.0, np.inf, 0.0, 0.0]])
def test_a_start_that_is_none_is_invalid(start):
    judge = Judge(RUN, CONE, DOCKING)
    judge.start(start)
    v = seen(judge.verdict())
    assert judge.ended and (v.reason, v.duration) == ('invalid', 0.0)


def test_a_run_under_way_has_no_reason_and_no_success():
    v = judged([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0], REST, until_end=False)
    assert (v.success, v.reason, v.duration) == (False, '', H)
    assert np.isnan(v.x_rate) and v.min_corridor_margin > 0


def test_a_run_that_is_stopped_under_way_counts_as_timed_out():
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    judge.advance(1, [-0.875, 0.0, 0.0, 0.25, 0.0, 0.0], REST)
    assert judge.verdict(final=True).reason == 'timeout'
    assert judge.verdict().reason == ''             # asking changes nothing


def test_a_single_verdict_is_made_of_plain_numbers():
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    kinds = [type(value) for value in fields(judge.verdict()).values()]
    assert kinds == [bool, str] + [float]*10


@pytest.mark.parametrize('step', [0, 1, 3, 7])
def test_a_gap_is_refused_with_its_step(step):
    judge = Judge(RUN, CONE, DOCKING)
    judge.start([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    judge.advance(1, [-29.875, 0.0, 0.0, 0.25, 0.0, 0.0], REST)
    with pytest.raises(ValueError, match=f'got {step} after 1'):
        judge.advance(step, np.zeros(6), REST)


def test_nothing_can_be_judged_before_the_start():
    with pytest.raises(ValueError, match='got 1 after none'):
        Judge(RUN, CONE, DOCKING).advance(1, np.zeros(6), REST)


def test_a_batch_of_another_shape_is_refused():
    with pytest.raises(ValueError, match=r'expected shape \(3, 6\), got \(2, 6\)'):
        Judge(RUN, CONE, DOCKING, (3,)).start(np.zeros((2, 6)))


def test_without_any_control_the_reference_approach_leaves_at_69_seconds():
    model, judge = Cw(OrbitParams(), H), Judge(RUN, CONE, DOCKING)
    state = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    judge.start(state)
    for step in range(1, 401):
        state = model.advance(state, REST)
        judge.advance(step, state, REST)
    v = seen(judge.verdict())
    n = OrbitParams().mean_motion

    def station(t):                                 # eq. 19
        return -30.0 + np.sin(n*t)/n - 0.75*t

    def offset(t):
        return 0.5*(1 - np.cos(n*t))/n

    t = brentq(lambda t: offset(t) - cone.radius(station(t), CONE), 10.0, 100.0, xtol=1e-12)
    assert t == pytest.approx(68.9, abs=0.1) and station(t) == pytest.approx(-12.8, abs=0.05)
    assert v.reason == 'left_corridor' and v.exit_time == pytest.approx(t, abs=1e-7)
    assert_allclose(v.exit_position, [station(t), offset(t), 0.0], atol=1e-8)
    told = judgement(judge, judge.verdict(final=True))
    assert told.headline.startswith(f'failed: left the corridor at {t:.1f} s; the run ended after ')
    assert told.duration > t + 50.0


# -- flights ----------------------------------------------------------------------------------

def flights(runs, run, seed=0):
    """Fly clumsy pulses towards the axis; return states (K, N, 6) and accelerations."""
    rng, model = np.random.default_rng(seed), Cw(OrbitParams(), run.step_s)
    state = rng.normal(size=(runs, 6)) * [0, .5, .5, 0, .01, .01] + [-30, 0, 0, .25, 0, 0]
    states, accels, levels = [state], [], np.zeros((runs, 3), dtype=int)
    for _ in range(run.last_step):
        miss = -np.clip(state[:, :3]/12, -.06, .06) - state[:, 3:]
        miss[:, 0] = 0.25 - state[:, 3]
        change = rng.random((runs, 3)) < run.step_s/3
        wanted = np.sign(miss) * (np.abs(miss) > 0.012) * rng.integers(1, 4, size=(runs, 3))
        levels = np.where(change, wanted.astype(int), levels)
        accel = acceleration(levels, ThrustParams()) * (1 + .01*rng.normal(size=(runs, 3)))
        state = model.advance(state, accel)
        states.append(state)
        accels.append(accel)
    return np.array(states), np.array(accels)


def judge_all(run, states, accels, batch, ask=()):
    judge = Judge(run, CONE, DOCKING, batch)
    judge.start(states[0])
    for step, accel in enumerate(accels, start=1):
        judge.advance(step, states[step], accel)
        if step in ask:
            judge.verdict()
    return judge.verdict(final=True)


def oracle(states, run):
    """Judge one flight by brute force: a spline, dense sampling, scipy's searches."""
    h = run.step_s
    spline = CubicHermiteSpline(h*np.arange(len(states)), states[:, :3], states[:, 3:])
    t = np.linspace(0.0, h*(len(states) - 1), 40*(len(states) - 1) + 1)
    x = spline(t)[:, 0]
    behind = np.flatnonzero(x >= 0)
    end = t[-1]
    if behind.size:
        end = brentq(lambda u: spline(u)[0], t[behind[0] - 1], t[behind[0]], xtol=1e-13)

    def margin(u):
        return cone.signed_distance(spline(u), CONE)

    flown = np.append(t[t < end], end)
    sampled = margin(flown)
    i = sampled.argmin()
    span = flown[max(i - 1, 0)], flown[min(i + 1, flown.size - 1)]
    fine = minimize_scalar(margin, bounds=span, method='bounded', options={'xatol': 1e-12})
    outside = np.flatnonzero(sampled <= 0)
    left = np.nan
    if outside.size:
        j = outside[0]
        left = brentq(margin, flown[j - 1], flown[j], xtol=1e-13) if j else 0.0
    return end, min(sampled[i], fine.fun), left, spline(end), spline(end, 1), spline


@pytest.mark.parametrize('step_s', [0.1, 0.5, 1.0])
def test_flights_are_judged_as_brute_force_judges_them(step_s):
    run, runs = Run(step_s=step_s), 40
    states, accels = flights(runs, run, seed=3)
    v = seen(judge_all(run, states, accels, (runs,)))
    assert len(set(v.reason.tolist())) > 1          # docked ones and others
    for r in range(runs):
        end, margin, left, place, rate, spline = oracle(states[:, r], run)
        assert v.duration[r] == pytest.approx(end, abs=1e-7)
        assert v.min_corridor_margin[r] == pytest.approx(margin, abs=1e-7)
        assert v.exit_time[r] == pytest.approx(left, abs=1e-5, nan_ok=True)
        if left > 0:
            assert_allclose(v.exit_position[r], spline(left), atol=1e-6)
        if place[0] > -1e-9:
            assert_allclose([v.x_rate[r], v.offset[r], v.lateral_rate[r]],
                            [rate[0], np.hypot(*place[1:]), np.hypot(*rate[1:])], atol=1e-7)
        assert v.success[r] == (np.isnan(left) and place[0] > -1e-9 and 0 < rate[0] < 0.3
                                and np.hypot(*rate[1:]) < 0.3)


def row(verdict, i):
    return [np.asarray(field[i]).tobytes() for field in fields(verdict).values()]


def test_a_run_in_a_batch_is_judged_to_the_bit_like_a_single_one():
    states, accels = flights(1000, RUN, seed=1)
    states[100, 4] = np.inf                         # also among broken ones
    accels[50, 5] = np.inf
    with np.errstate(invalid='raise', over='raise'):
        batch = judge_all(RUN, states, accels, (1000,))
    for size in (1, 7):
        few = judge_all(RUN, states[:, :size], accels[:, :size], (size,))
        assert all(row(few, i) == row(batch, i) for i in range(size))
    for i in range(60):
        single = judge_all(RUN, states[:, i], accels[:, i], ())
        for name, one in fields(single).items():
            of_batch = fields(batch)[name][i]
            assert np.array_equal(one, of_batch, equal_nan=not isinstance(one, str)), (i, name)
    assert {'docked', 'left_corridor', 'invalid'} <= set(batch.reason.tolist())


def test_asking_under_way_does_not_change_the_verdict():
    states, accels = flights(200, RUN, seed=2)
    quiet = judge_all(RUN, states, accels, (200,))
    asked = judge_all(RUN, states, accels, (200,), ask=range(0, 400, 3))
    assert [row(quiet, i) for i in range(200)] == [row(asked, i) for i in range(200)]


def test_a_run_that_has_ended_keeps_its_verdict_whatever_comes():
    states, accels = flights(50, RUN, seed=4)
    judge = Judge(RUN, CONE, DOCKING, (50,))
    judge.start(states[0])
    kept = {}
    for step, accel in enumerate(accels, start=1):
        judge.advance(step, states[step], accel)
        for i in np.flatnonzero(judge.ended):
            if i not in kept:
                kept[i] = row(judge.verdict(), i)
                states[step + 1:, i] = np.nan       # nonsense from now on
    final = judge.verdict()
    assert len(kept) == 50 and all(kept[i] == row(final, i) for i in range(50))


def test_batches_may_have_several_axes():
    states, accels = flights(6, RUN, seed=5)
    flat = judge_all(RUN, states, accels, (6,))
    folded = judge_all(RUN, states.reshape(-1, 2, 3, 6), accels.reshape(-1, 2, 3, 3), (2, 3))
    assert {field.shape for field in fields(folded).values()} == {(2, 3)}
    assert np.array_equal(folded.duration.ravel(), flat.duration)


# -- what it declares -------------------------------------------------------------------------

def test_a_run_succeeds_when_every_measure_is_within_its_limits():
    states, accels = flights(400, RUN, seed=6)
    judge = Judge(RUN, CONE, DOCKING, (400,))
    v = judge_all(RUN, states, accels, (400,))
    within = np.all([m.ok(v.values[m.name]) for m in judge.measures], axis=0)
    assert np.array_equal(within, v.success) and 0 < v.success.sum() < 400
    assert [m.name for m in judge.measures] == list(v.values)


def test_limits_and_reasons_are_those_of_the_settings():
    judge = Judge(Run(), Cone(3.0, 0.4), DockingParams(0.2, 0.05))
    limits = {m.name: (m.low, m.high) for m in judge.measures}
    assert limits['x_rate_m_s'] == (0.0, 0.2) and limits['lateral_rate_m_s'][1] == 0.05
    assert limits['offset_m'][1] == 0.4 and limits['min_corridor_margin_m'][0] == 0.0
    assert {*Judge.reasons, *AMONG} == set(REASONS.tolist()) - {''}


# -- the end of a run, which plant and judge agree on ------------------------------------------

@pytest.mark.parametrize('state, step, over', [
    ([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0], 399, False), ([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0], 400, True),
    ([0.0, 0.0, 0.0, 0.25, 0.0, 0.0], 1, True), ([2.0, 9.0, 0.0, 0.25, 0.0, 0.0], 1, True),
    ([-np.inf, 0.0, 0.0, 0.25, 0.0, 0.0], 1, True), ([np.nan]*6, 1, True),
    ([-1.0, 0.0, 0.0, 0.25, 0.0, np.nan], 1, True)])
def test_a_run_ends_at_the_plane_at_the_time_limit_or_where_nothing_is_known(state, step, over):
    assert ended(step, state, 400) == over
    batch = np.tile([-1.0, 0.0, 0.0, 0.25, 0.0, 0.0], (3, 2, 1))
    batch[1, 0] = state
    expected = np.full((3, 2), step >= 400)
    expected[1, 0] = over
    assert np.array_equal(ended(step, batch, 400), expected)


def test_the_judge_ends_a_run_no_later_than_the_plant_does():
    states, accels = flights(300, RUN, seed=8)
    states[77, 3, 4] = np.nan
    judge = Judge(RUN, CONE, DOCKING, (300,))
    judge.start(states[0])
    for step, accel in enumerate(accels, start=1):
        judge.advance(step, states[step], accel)
        assert judge.ended[ended(step, states[step], RUN.last_step)].all()
    assert judge.ended.all()
