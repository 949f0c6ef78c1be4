"""Frames against orbital elements, invariants and a moving observer."""

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics import frames
from rvd_dynamics.motion.orbit import OrbitParams

ORBIT = OrbitParams()
N, RADIUS = ORBIT.mean_motion, ORBIT.radius_m
TIMES = np.array([0.0, 1.0, 1234.5, 7656.0, 1e5])


def elementary(axis, angle):
    """Return the matrix of a turn by `angle` [rad] about a coordinate axis."""
    c, s = np.cos(angle), np.sin(angle)
    turns = {'x': [[1, 0, 0], [0, c, -s], [0, s, c]], 'z': [[c, -s, 0], [s, c, 0], [0, 0, 1]]}
    return np.array(turns[axis])


def test_orbital_rate_and_period_are_the_papers():
    assert N == pytest.approx(8.2071e-4, abs=5e-9)
    assert 2*np.pi/N == pytest.approx(7656.0, abs=0.5)


@pytest.mark.parametrize('t', TIMES)
def test_axes_are_velocity_radius_and_minus_normal_of_the_elements(t):
    # the textbook road: node, inclination, argument of latitude as three turns
    perifocal = elementary('z', np.radians(25.0)) @ elementary('x', np.radians(45.0)) \
        @ elementary('z', N*t)
    expected = np.stack([perifocal[:, 1], perifocal[:, 0], -perifocal[:, 2]], axis=-1)
    assert_allclose(frames.rotation(t, ORBIT), expected, atol=1e-13)


def test_the_frame_is_right_handed_and_orthonormal():
    r = frames.rotation(TIMES, ORBIT)
    assert_allclose(r @ np.swapaxes(r, -1, -2), np.broadcast_to(np.eye(3), r.shape), atol=1e-15)
    assert_allclose(np.linalg.det(r), 1.0, rtol=1e-15)


def test_the_target_starts_at_its_ascending_node_and_goes_north():
    state = frames.target_state(0.0, ORBIT)
    node = np.radians(25.0)
    assert_allclose(state[:3], RADIUS*np.array([np.cos(node), np.sin(node), 0.0]), rtol=1e-15)
    assert state[5] > 0.0
    assert_allclose(np.sqrt(state[3:] @ state[3:]), N*RADIUS, rtol=1e-15)


def test_the_target_moves_as_its_velocity_says():
    h = 1e-2
    ahead, behind = frames.target_state(500.0 + h, ORBIT), frames.target_state(500.0 - h, ORBIT)
    rate = (ahead - behind) / (2*h)
    now = frames.target_state(500.0, ORBIT)
    assert_allclose(rate[:3], now[3:], atol=1e-6)
    assert_allclose(rate[3:], -N*N*now[:3], atol=1e-6)      # central attraction


def test_the_target_is_at_rest_at_its_own_origin():
    assert_allclose(frames.to_target(frames.target_state(TIMES, ORBIT), TIMES, ORBIT), 0.0,
                    atol=1e-9)


def test_there_and_back_changes_nothing():
    states = np.random.default_rng(5).normal(size=(5, 6)) * [30, 30, 30, .3, .3, .3]
    back = frames.to_target(frames.to_inertial(states, TIMES, ORBIT), TIMES, ORBIT)
    assert_allclose(back[:, :3], states[:, :3], atol=2e-9)
    assert_allclose(back[:, 3:], states[:, 3:], atol=2e-12)


def test_rates_are_those_of_an_observer_who_turns_with_the_frame():
    # a chaser at rest in the inertial frame beside the target: difference its relative place
    place = frames.to_inertial([-30.0, 4.0, 2.0, 0.0, 0.0, 0.0], 0.0, ORBIT)
    place[3:] = [10.0, -20.0, 5.0]

    def seen(t):
        moved = place.copy()
        moved[:3] += t*place[3:]
        return frames.to_target(moved, t, ORBIT)

    h = 1e-2
    assert_allclose((seen(h) - seen(-h))[:3] / (2*h), seen(0.0)[3:], atol=1e-6)


def test_behind_above_and_right_of_the_orbit():
    now = frames.target_state(0.0, ORBIT)
    along, outward = now[3:] / np.sqrt(now[3:] @ now[3:]), now[:3] / RADIUS
    chaser = now.copy()
    chaser[:3] += -30.0*along + 4.0*outward - 2.0*np.cross(outward, along)
    assert_allclose(frames.to_target(chaser, 0.0, ORBIT)[:3], [-30.0, 4.0, 2.0], atol=1e-9)


def test_an_impossible_orientation_is_refused_by_name():
    with pytest.raises(ValueError, match='inclination_deg must be finite, got nan'):
        frames.PlaneParams(inclination_deg=float('nan'))
