"""Range-rate control along the V-bar: flown by scipy on the orbit, against closed forms."""

from math import sqrt

import numpy as np
from numpy.testing import assert_allclose
from paper import Paper
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.guidance.odrrca import Odrrca, OdrrcaAim

PAPER = Paper()
N = PAPER.orbit.mean_motion
PUBLISHED = {'k': -0.5, 'k1': 1.0, 'q': 10.0, 'q1': 0.0, 'ff': 'off',
             'aim': OdrrcaAim(beyond_m=0.0)}


def flown(law, state, seconds):
    """Return the states (6, 61) under the law, on the target's orbit, without thrusters' levels."""
    def motion(_, s):
        a = law.wanted(s, None)
        x, y, z, u, v, w = s
        return [u, v, w, -2*N*v + a[0], 2*N*u + 3*N*N*y + a[1], -N*N*z + a[2]]
    return solve_ivp(motion, (0.0, seconds), state, t_eval=np.linspace(0.0, seconds, 61),
                     rtol=1e-10, atol=1e-12, max_step=1.0).y


def test_at_the_published_gain_it_closes_with_12_mm_s_at_30_m():
    law = PAPER.law(Odrrca, **PUBLISHED)
    wanted = law.wanted([-30.0, 0.0, 0.0, 0.0, 0.0, 0.0], None)
    assert wanted[0] / law.rate_gain_per_s == pytest.approx(0.0123, abs=5e-5)
    assert 0.5*N*30.0 == pytest.approx(0.0123, abs=5e-5)


def lagging(k, gain, start_m, t):
    """Return the range under D.. = gain (k n D - D.), from D. = k n D: exponential, with a lag."""
    slow, fast = np.roots([1.0, gain, -gain*k*N])[::-1]
    share = (k*N - fast) / (slow - fast)
    return start_m * (share*np.exp(slow*t) + (1.0 - share)*np.exp(fast*t))


def test_the_range_to_the_aim_point_dies_away_as_exp_k_nu_with_the_lag_of_the_rate_loop():
    law = PAPER.law(Odrrca, k=-5.0, rate_gain_per_s=0.5, aim=OdrrcaAim(beyond_m=20.0))
    track = flown(law, [-30.0, 0.0, 0.0, 5.0*N*50.0, 0.0, 0.0], 100.0)
    t = np.linspace(0.0, 100.0, 61)
    distance = np.hypot(track[0] - 20.0, track[1])
    assert_allclose(distance, lagging(-5.0, 0.5, 50.0, t), rtol=1e-5)
    assert_allclose(distance, 50.0*np.exp(-5.0*N*t), rtol=5.0*N/0.5)        # the lag is no more


def test_without_an_aim_point_the_docking_plane_is_never_reached():
    law = PAPER.law(Odrrca, k=-10.0, rate_gain_per_s=0.5, aim=OdrrcaAim(beyond_m=0.0))
    track = flown(law, [-30.0, 0.0, 0.0, 10.0*N*30.0, 0.0, 0.0], 1000.0)
    assert (track[0] < 0.0).all()
    assert -track[0, -1] == pytest.approx(lagging(-10.0, 0.5, 30.0, 1000.0), rel=1e-3)


def test_the_least_closing_speed_is_kept_where_the_law_would_be_slower():
    aim = OdrrcaAim(beyond_m=0.0, least_closing_m_s=0.1)
    law = PAPER.law(Odrrca, k=-1.0, aim=aim)
    slow = law.wanted([-10.0, 0.0, 0.0, 0.1, 0.0, 0.0], None)
    assert slow[0] == pytest.approx(0.0, abs=1e-12)             # wants exactly what it has
    quick = PAPER.law(Odrrca, k=-50.0, aim=aim)
    assert quick.wanted([-10.0, 0.0, 0.0, 50*N*10.0, 0.0, 0.0], None)[0] == pytest.approx(
        0.0, abs=1e-12)                                         # faster than the floor: untouched


def test_out_of_the_plane_it_is_an_oscillator_damped_as_said():
    q, q1 = 15000.0, 100.0
    law = PAPER.law(Odrrca, q=q, q1=q1)
    z = flown(law, [-30.0, 0.0, 0.5, 0.25, 0.0, 0.0], 60.0)[2]
    t, half = np.linspace(0.0, 60.0, 61), q1*N/2
    pace = sqrt(N*N*(1 + q) - half*half)                        # z'' = -n^2 (1 + q) z - q1 n z'
    assert_allclose(z, 0.5*np.exp(-half*t)*(np.cos(pace*t) + half/pace*np.sin(pace*t)), atol=1e-8)


@pytest.mark.parametrize('y', [0.5, -0.5])
def test_in_the_plane_it_comes_back_to_the_v_bar_from_either_side(y):
    law = PAPER.law(Odrrca, q=15000.0, q1=150.0)
    track = flown(law, [-30.0, y, 0.0, 0.25, 0.0, 0.0], 90.0)
    assert abs(track[1, -1]) < 0.02*abs(y)
    # past the axis by exp(-pi zeta / sqrt(1 - zeta^2)), zeta = q1 / (2 sqrt(q)) = 0.61, and no more
    assert (np.sign(y)*track[1] > -0.1*abs(y)).all()


@pytest.mark.parametrize('given, said', [
    ({'k': 0.5}, 'k must be negative: the range follows exp(k n t) and would not shrink, got 0.5'),
    ({'k': 0.0}, 'k must be negative'),
    ({'k': -5.0, 'k1': 1.0, 'q1': 2.0}, 'k1 must be above -k - q1/2 = 4'),
    ({'q': -1.0}, 'q must be above 0 and at most 100000000, got -1.0'),
    ({'q1': -3.0}, 'q1 must not be negative, got -3.0'),
    ({'rate_gain_per_s': 0.0}, 'rate_gain_per_s must be above 0')])
def test_gains_of_the_wrong_sign_are_refused(given, said):
    with pytest.raises(BadInput) as refused:
        Odrrca(**given)
    assert str(refused.value).startswith(said)


@pytest.mark.parametrize('given', [{'beyond_m': -1.0}, {'least_closing_m_s': -0.1}])
def test_an_aim_point_before_the_plane_is_refused(given):
    with pytest.raises(BadInput, match=next(iter(given))):
        OdrrcaAim(**given)
