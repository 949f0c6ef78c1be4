"""The potential field against finite differences of its potential, and by what it must do."""

from dataclasses import replace

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.geometry.cone import control_boundary, nearest_point, radius, signed_distance
from rvd_groundstation.guidance.corridor_apf import CorridorApf

PAPER = Paper()
LAW = PAPER.law(CorridorApf)
CONE = PAPER.cone
L1, L2 = 2e-4, 5e-3
ALPHA = np.radians(3.0)


def band_states(rows, seed=0):
    """Return states (rows, 6) between the control boundary and 5 cm from the wall."""
    rng = np.random.default_rng(seed)
    x = rng.uniform(-30.0, -2.5, rows)
    share = rng.uniform(0.05, 0.8, rows)
    rho = LAW.boundary(x) + share * (radius(x, CONE) - LAW.boundary(x))
    angle = rng.uniform(0, 2*np.pi, rows)
    rates = [0.25, 0.0, 0.0] + rng.normal(scale=0.05, size=(rows, 3))
    return np.column_stack([x, rho*np.cos(angle), rho*np.sin(angle), rates])


def wall_point(p):
    """Return the wall point nearest to `p` (3,) from the cone's geometry, another road."""
    apex = np.array([0.3 / np.tan(ALPHA), 0.0, 0.0])
    side = np.array([0.0, p[1], p[2]]) / np.hypot(p[1], p[2])
    ray = -np.cos(ALPHA) * np.array([1.0, 0, 0]) + np.sin(ALPHA) * side
    return apex + ray * (ray @ (p - apex))


def potential(p, v, q=None):
    """Return W of eq. 9 with the nearest wall point, or with a frozen one."""
    to_wall = (wall_point(p) if q is None else q) - p
    distance = np.sqrt(to_wall @ to_wall)
    return L1 / distance + L2 * (v @ to_wall) / distance


def descent(state, q=None):
    """Return -grad_p W - grad_v W by central differences of fourth order."""
    p, v, force = state[:3], state[3:], np.empty(3)

    def slope(i, h):
        step = h * np.eye(3)[i]
        return (potential(p + step, v, q) - potential(p - step, v, q)
                + potential(p, v + step, q) - potential(p, v - step, q)) / (2*h)

    for i in range(3):
        force[i] = -(4*slope(i, 1e-4) - slope(i, 2e-4)) / 3
    return force


def whole(law, **settings):
    """Return the law with every component of its force."""
    return replace(law, along_x=True, **settings)


@pytest.mark.parametrize('variant, frozen', [('moving_q', False), ('frozen_q', True)])
def test_force_is_the_gradient_of_the_potential(variant, frozen):
    states = band_states(200)
    got = whole(LAW, tangential=variant).repulsion(states)
    reference = [descent(s, wall_point(s[:3]) if frozen else None) for s in states]
    assert_allclose(got, reference, rtol=0, atol=5e-11)


def test_default_is_that_without_the_middle_term_and_without_x():
    states = band_states(100, 1)
    still = states.copy()
    still[:, 3:] = 0.0
    reference = np.array([descent(s, wall_point(s[:3])) for s in still])
    reference[:, 0] = 0.0
    assert_allclose(LAW.repulsion(states), reference, rtol=1e-6, atol=1e-9)


def test_printed_sign_is_the_opposite():
    states = band_states(100, 2)
    assert_array_equal(replace(LAW, gradient='printed_ascent').repulsion(states),
                       -LAW.repulsion(states))


@given(x=st.floats(-40, 0.2), share=st.floats(0, 3), angle=st.floats(0, 6.3),
       rates=st.tuples(*[st.floats(-0.5, 0.5)] * 3))
def test_push_points_inwards_and_is_finite(x, share, angle, rates):         # P15
    rho = share * float(radius(x, CONE))
    state = np.array([x, rho*np.cos(angle), rho*np.sin(angle), *rates])
    push = LAW.repulsion(state)
    assert np.isfinite(push).all()
    assert push[0] == 0.0 and push[1]*state[1] + push[2]*state[2] <= 0.0
    # at most l1 / 0.02^2 + l2, also on the wall and outside
    assert np.abs(push).max() <= L1/0.02**2 + L2


def test_outside_it_pushes_back_as_hard_as_at_the_wall():
    for beyond in (0.0, 0.01, 0.5, 5.0):
        rho = float(radius(-10.0, CONE)) + beyond
        assert_array_equal(PAPER.levels(LAW, [-10.0, rho, 0, 0.25, 0, 0], None), [0, -3, 0])
        assert_array_equal(PAPER.levels(LAW, [-10.0, 0, -rho, 0.25, 0, 0], None), [0, 0, 3])


def test_printed_distance_drives_out_who_is_out():
    printed = replace(LAW, distance='printed_unsigned')
    rho = float(radius(-10.0, CONE)) + 0.2
    assert printed.repulsion([-10.0, rho, 0, 0.25, 0, 0])[1] > 0.0
    states = band_states(100, 3)                                # inside it is the same law
    assert_allclose(printed.repulsion(states), LAW.repulsion(states), rtol=1e-14)


def test_axis_and_the_inner_side_of_the_boundary_are_free():                # P15
    assert_array_equal(LAW.repulsion([-10.0, 0, 0, 0.25, 0.3, -0.3]), 0.0)
    x = np.linspace(-30, 0, 200)
    boundary = LAW.boundary(x)
    for inside, free in ((0.999, True), (1.001, False)):
        states = np.zeros((200, 6))
        states[:, 0], states[:, 1] = x, inside * boundary
        assert ((LAW.repulsion(states)[:, 1] == 0.0) == free).all()


def test_boundary_takes_the_whole_delay_of_the_link():
    for forward, back in ((5.0, 5.0), (0.0, 0.0), (2.0, 7.0), (20.0, 20.0)):
        paper = Paper(forward_delay_s=forward, back_delay_s=back)
        x = np.linspace(-30, 0, 50)
        expected = control_boundary(x, CONE, paper.orbit.mean_motion, 0.25, forward + back)
        assert_array_equal(paper.law(CorridorApf).boundary(x), expected)


@pytest.mark.parametrize('x, boundary, band', [(-30.0, 1.364, 0.509), (-2.5, 0.143, 0.288),
                                               (0.0, 0.300, 0.0)])
def test_boundary_at_the_stations_of_the_documentation(x, boundary, band):
    assert LAW.boundary(x) == pytest.approx(boundary, abs=6e-4)
    assert radius(x, CONE) - LAW.boundary(x) == pytest.approx(band, abs=6e-4)


@pytest.mark.parametrize('distance, level', [(0.45, 1), (0.29, 1), (0.27, 2), (0.15, 2),
                                             (0.125, 3), (0.02, 3), (0.0, 3)])
def test_level_rises_towards_the_wall(distance, level):
    """Thresholds are .0075 and .015 m/s^2: l1/D^2 + l2 passes them at .283 and .141 m."""
    q = nearest_point([-30.0, 1.0, 0.0], CONE)
    inward = np.array([-np.sin(ALPHA), -np.cos(ALPHA), 0.0])
    state = np.concatenate([q + distance*inward, [0.25, 0, 0]])
    assert signed_distance(state[:3], CONE) == pytest.approx(distance, abs=1e-12)
    assert_array_equal(PAPER.levels(LAW, state, None), [0, -level, 0])


def test_damping_brakes_motion_towards_the_wall_only():
    damped = replace(LAW, damping_per_s=0.1)
    state = np.array([-20.0, 1.2, 0.0, 0.25, 0.0, 0.0])
    for rate in (-0.05, 0.0, 0.08):
        state[4] = rate
        towards = 0.25*np.sin(ALPHA) + rate*np.cos(ALPHA)
        extra = damped.repulsion(state) - LAW.repulsion(state)
        assert_allclose(extra, [0, -0.1*max(towards, 0.0)*np.cos(ALPHA), 0], atol=1e-15)


def test_fixed_band_is_a_depth_measured_at_right_angles_to_the_wall():
    law = replace(LAW, band_m=0.5)
    for x in (-30.0, -10.0):
        assert signed_distance([x, law.boundary(x), 0.0], CONE) == pytest.approx(0.5)
    assert law.boundary(0.0) == 0.0                 # nearer than 0.5 m everywhere


def test_x_component_is_a_twentieth_of_the_force():
    force = whole(LAW).repulsion(band_states(50, 4))
    assert_allclose(np.abs(force[:, 0]) / np.hypot(force[:, 1], force[:, 2]), np.tan(ALPHA))


def test_frozen_middle_term_pushes_along_the_wall_at_the_closing_rate():
    """The artefact: at 0.25 m/s it is some l2 0.25 / D along +x, above the level threshold."""
    state = np.array([-15.0, 0.95, 0.0, 0.25, 0.0, 0.0])
    distance = signed_distance(state[:3], CONE)
    extra = whole(LAW, tangential='frozen_q').repulsion(state) - whole(LAW).repulsion(state)
    along = np.array([np.cos(ALPHA), -np.sin(ALPHA), 0.0])
    assert extra @ along == pytest.approx(L2 * 0.25 * np.cos(ALPHA) / distance)


def test_printed_ray_misses_by_metres_and_hardly_turns_the_push():
    """The wrong point lies far along nearly the same line, and only its direction is used."""
    states = band_states(50, 5)
    force = replace(LAW, nearest_point='printed_ray').repulsion(states)
    right = LAW.repulsion(states)
    off = np.abs(force - right).max(axis=1) / np.abs(right).max(axis=1)
    assert 0.001 < off.max() < 0.25


def test_printed_boundary_jumps_and_printed_sign_turns_round():
    printed = replace(LAW, boundary_rate='printed_at_station')
    jump = printed.boundary(-2.5 + 1e-9) - printed.boundary(-2.5 - 1e-9)
    assert jump == pytest.approx(0.031, abs=1e-3)               # 0.112 to 0.143 m
    assert LAW.boundary(-2.5 + 1e-9) == pytest.approx(LAW.boundary(-2.5 - 1e-9), abs=1e-8)
    long = Paper(forward_delay_s=15.0, back_delay_s=15.0)
    x = np.linspace(-12, -6, 30)
    clamped = long.law(CorridorApf).boundary(x)
    squared = long.law(CorridorApf, boundary_sign='printed_squared').boundary(x)
    assert (clamped == 0.0).any() and (squared[clamped == 0.0] > 0.0).any()


@pytest.mark.parametrize('name, bad', [
    ('lambda_1_m3_s2', -1.0), ('lambda_2_m_s2', np.inf), ('least_distance_m', 0.0),
    ('band_m', -0.1), ('damping_per_s', np.nan), ('closing_rate_m_s', 0.0),
    ('gradient', 'up'), ('tangential', 'yes'), ('distance', ''), ('nearest_point', 'ray'),
    ('boundary_rate', 'x'), ('boundary_sign', 'x')])
def test_impossible_settings_are_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=name):
        CorridorApf(**{name: bad})
