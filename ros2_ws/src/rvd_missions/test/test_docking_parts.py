"""
Parts of the mission docking: the profile, the safety strategy, valves, the geometry of the ports.
"""

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.control.allocation import Shares
from rvd_missions.docking import markers
from rvd_missions.docking.commands import COUNT, ValveForm
from rvd_missions.docking.profile import Profile, ProfileParams
from rvd_missions.docking.safety import ABORT, HOLD, NOMINAL, RETREAT, Safety, SafetyParams
from rvd_missions.docking.settings import ended, faces

START = np.array([[-3.0, 0.2, -0.15]])


# -- profile --------------------------------------------------------------------------------------

def test_the_profile_goes_from_the_start_to_the_aim_in_the_nominal_time_and_stays():
    profile = Profile(ProfileParams(), START, 0.07, 80.0)
    port, speed = profile.at(0.0)
    assert_allclose(port, START)
    assert_allclose(speed, 0.0)
    for t in (80.0, 100.0, 1000.0):
        port, speed = profile.at(t)
        assert_allclose(port, [[-0.07, 0, 0]], atol=1e-12)
        assert_allclose(speed, 0.0, atol=1e-15)
    assert profile.at(79.5)[0][0, 0] < -0.0701


def test_the_speed_of_the_profile_is_the_slope_of_its_way_and_keeps_its_bounds():
    profile = Profile(ProfileParams(), START, 0.07, 80.0)
    times = np.arange(0.0, 90.0, 0.01)
    ports, speeds = (np.array(v)[:, 0] for v in zip(*(profile.at(t) for t in times)))
    assert_allclose(np.diff(ports, axis=0)/0.01, 0.5*(speeds[1:] + speeds[:-1]), atol=2e-5)
    assert speeds[:, 0].max() == pytest.approx(0.05) and speeds[:, 0].min() >= 0.0
    assert np.abs(np.diff(speeds[:, 0])/0.01).max() < 0.0041
    fast = (speeds[:, 0] > 0.0499).sum()*0.01
    docking = (np.abs(speeds[:, 0] - 0.02) < 1e-9).sum()*0.01
    assert fast == pytest.approx(40.2, abs=0.2) and docking == pytest.approx(14.8, abs=0.2)


@given(st.floats(-3.3, -2.4), st.floats(-0.3, 0.3))
@settings(max_examples=30)
def test_rows_of_the_profile_are_independent(x, y):
    both = Profile(ProfileParams(), [[x, y, 0.0], START[0]], 0.07, 80.0)
    alone = Profile(ProfileParams(), [[x, y, 0.0]], 0.07, 80.0)
    for t in (0.0, 10.0, 33.3, 61.7, 79.0):
        for a, b in zip(both.at(t), alone.at(t)):
            assert np.array_equal(a[0], b[0])


def test_a_way_that_the_speeds_cannot_go_is_refused_with_what_they_can():
    with pytest.raises(BadInput, match=r'a way of 9.93 m cannot be gone in 80 s with fast_m_s 0.05 '
                                       r'and dock_m_s 0.02, but 1.725 to 3.375 m'):
        Profile(ProfileParams(), [[-10.0, 0, 0]], 0.07, 80.0)
    with pytest.raises(BadInput, match='dock_m_s must be below fast_m_s, 0.05, got 0.06'):
        ProfileParams(dock_m_s=0.06)


# -- safety ---------------------------------------------------------------------------------------

def state_after(seconds=0.05, t=0.0, port=(-3.0, 0.2, 0.15), speed=0.0, turn=(0, 0, 0),
                rate=(0, 0, 0), nis=(1.0, 1.0), demand=(0,)*6, params=SafetyParams()):
    """Return the state after some time of one situation."""
    safety = Safety(params, 0.01, 1)
    for k in range(round(seconds/0.01)):
        found = safety.advance(t + 0.01*k, np.array([port], dtype=float), np.array([speed]),
                               np.array([turn], dtype=float), np.array([rate], dtype=float),
                               np.array([nis], dtype=float), np.array([demand], dtype=float))
    return int(found[0])


@pytest.mark.parametrize('situation, expected', [
    ({}, NOMINAL),
    ({'port': (-3.0, 1.2, 0.0)}, HOLD),                     # 22 degrees
    ({'port': (-3.0, 1.0, 0.0)}, NOMINAL),                  # 18 degrees
    ({'port': (-0.2, 0.09, 0.0)}, RETREAT),
    ({'port': (-0.2, 0.07, 0.0)}, NOMINAL),
    ({'port': (-0.5, 0.0, 0.0), 'speed': 0.14}, ABORT),     # sqrt(0.04*0.47) = 0.137
    ({'port': (-0.5, 0.0, 0.0), 'speed': 0.13}, NOMINAL),
    ({'port': (-0.07, 0.0, 0.0), 'speed': 0.05}, ABORT),
    ({'turn': (0.0, 0.09, 0.0)}, HOLD),                     # 5.2 degrees
    ({'rate': (0.0, 0.0, 0.02)}, NOMINAL),                  # 1.1 degrees/s at the start
    ({'rate': (0.0, 0.0, 0.02), 't': 30.0}, HOLD),
    ({'nis': (np.nan, np.nan), 'seconds': 1.9}, NOMINAL),
    ({'nis': (np.nan, np.nan), 'seconds': 2.1}, HOLD),
    ({'nis': (50.0, 1.0), 'seconds': 0.04}, NOMINAL),
    ({'nis': (50.0, 1.0), 'seconds': 0.06}, HOLD),
    ({'demand': (0.5, 0, 0, 0, 0, 0), 'seconds': 15.2}, NOMINAL),       # 30 s ln(5/3) = 15.3 s
    ({'demand': (0.5, 0, 0, 0, 0, 0), 'seconds': 15.4}, HOLD),
    ({'demand': (0, 0, 0, 0, 0, -1), 'seconds': 6.6, 'port': (-0.2, 0.0, 0.0)}, NOMINAL),
    ({'demand': (0, 0, 0, 0, 0, -1), 'seconds': 6.8, 'port': (-0.2, 0.0, 0.0)}, RETREAT),
    ({'demand': (0.19,)*6, 'seconds': 300.0}, NOMINAL),
    ({'port': (np.nan,)*3, 'nis': (np.nan, np.nan), 'seconds': 5.0}, NOMINAL),
    ({'port': (-3.0, 1.2, 0.0), 'params': SafetyParams(active=False)}, NOMINAL)])
def test_states_follow_the_rules(situation, expected):
    assert state_after(**situation) == expected


def test_states_only_rise_and_rows_have_their_own():
    safety = Safety(SafetyParams(), 0.01, 2)
    calm, still = np.zeros((2, 3)), np.zeros(2)
    nis = np.ones((2, 2))
    aside = np.array([[-3.0, 1.2, 0.0], [-3.0, 0.0, 0.0]])
    home = np.array([[-3.0, 0.0, 0.0]]*2)
    assert safety.advance(0.0, aside, still, calm, calm, nis).tolist() == [HOLD, NOMINAL]
    assert safety.advance(0.1, home, still, calm, calm, nis).tolist() == [HOLD, NOMINAL]
    fast = np.array([0.0, 0.6])
    assert safety.advance(0.2, home, fast, calm, calm, nis).tolist() == [HOLD, ABORT]


# -- valves and ports -----------------------------------------------------------------------------

def test_a_command_survives_the_wire_and_nothing_else_is_legal():
    form = ValveForm()
    command = (np.arange(COUNT) % 3 == 0).astype(np.uint8)
    there = form.wire.unpack(form.wire.pack(*command.tolist()))
    assert list(there) == command.tolist() and form.legal(there)
    assert form.legal(form.neutral.tolist())
    assert not form.legal([2] + [0]*(COUNT - 1)) and not form.legal([0]*(COUNT - 1))


def test_an_abort_pushes_straight_away_from_the_target():
    form = ValveForm()
    assert_allclose(form.effect(form.retreat), [-240.0, 0, 0, 0, 0, 0], atol=1e-12)


def test_shares_are_paid_in_whole_pulses():
    """Sixty shares at once: the edges of the range, quarters, and any between."""
    share = np.concatenate([[0.05, 0.25, 0.5, 0.75, 0.95],
                            np.random.default_rng(1).uniform(0.05, 0.95, 55)])
    shares = Shares(4, share.shape)
    on = np.array([shares.open(share) for _ in range(4000)])
    for column, wanted in zip(on.T, share):
        edges = np.flatnonzero(np.diff(np.concatenate([[0], column, [0]]).astype(int)))
        lengths = edges[1::2] - edges[::2]
        assert np.all(lengths[:-1] % 4 == 0)
        assert np.mean(column) == pytest.approx(wanted, abs=0.005)
    assert not Shares(4, ()).open(0.0) and Shares(4, ()).open(1.0)


def test_faces_are_apart_by_what_is_left_of_the_distance_of_the_centres():
    port, turn = faces([-6.0, 0.1, 0.0], [0, 0, 0, 1.0], [0, 0, 0, 1.0])
    assert_allclose(port, [-3.0, 0.1, 0.0])
    q = attitude.from_rotation_vector([0.0, 0.0, 0.1])
    port, turn = faces([-6.0, 0.0, 0.0], q, [0, 0, 0, 1.0])
    assert_allclose(port, [-4.5 + 1.5*np.cos(0.1), 1.5*np.sin(0.1), 0.0])
    turned, _ = faces(attitude.rotate(q, [-6.0, 0.0, 0.0]), q, q)       # all turned alike
    assert_allclose(turned, [-3.0, 0.0, 0.0], atol=1e-12)
    assert np.array_equal(markers.TARGET_PORT, [-1.5, 0, 0])


def test_a_run_ends_in_touch_in_time_or_without_a_number():
    ports = np.array([[-0.07, 0, 0], [0.001, 0, 0], [np.nan, 0, 0]])
    assert ended(5, ports, 10).tolist() == [False, True, True]
    assert ended(10, ports, 10).all()
