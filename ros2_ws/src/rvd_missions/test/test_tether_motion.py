"""The tethered gripper's motion: spherical against Cartesian, compiled against scipy, physics."""

import casadi as ca
from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from rvd_missions.tether import geometry, motion
from rvd_missions.tether.optimum import rates, target
from rvd_missions.tether.settings import OrbitParams
from tether_cases import (
    APPROACH, CRAFT, ELLIPSE, GEO, GRIPPER, LEO, ORBITS, orbit_at, over_step, plant_start, TETHER)

each_orbit = pytest.mark.parametrize('orbit', ORBITS.values(), ids=ORBITS)


def inputs(t):
    """Return smooth inputs with all seven at work."""
    return np.array([0.3 + 0.2*np.sin(0.1*t), 0.2*np.cos(0.05*t), 0.15*np.sin(0.07*t),
                     -0.1*np.cos(0.09*t), 0.002*np.sin(0.2*t), 0.003*np.cos(0.1*t),
                     -0.002*np.sin(0.15*t)])


def cartesian(orbit, start, duration, control=inputs):
    """Integrate the compiled rates by scipy's DOP853; states (13,)."""
    out = np.empty(13)

    def rate(t, x):
        u = control(t)
        motion.rate(x, u, u[0], *orbit_at(orbit, t), CRAFT, out)
        return out.copy()
    return solve_ivp(rate, (0.0, duration), start, method='DOP853', rtol=1e-13,
                     atol=1e-13).y[:, -1]


def spherical_rate(orbit, t, s, force, mass):
    """
    The paper's translation: rates of (l, a, b, l', a', b') under a force along the tether frame.

    Written with the angle u_r of the radial direction from x_I; a target on any ellipse.
    """
    length, a, b, dl, da, db = s
    now = orbit.at(t)
    g = orbit.gravitational_parameter_m3_s2/now.radius**3
    u_r = now.anomaly - orbit.at(0.0).anomaly - np.pi/2
    ca_, sa, cb, sb = np.cos(u_r - a), np.sin(u_r - a), np.cos(b), np.sin(b)
    f_l, f_a, f_b = force/mass
    ddl = length*(db**2 + da**2*cb**2) + g*length*(3*cb**2*ca_**2 - 1) + f_l
    dda = (2*length*da*db*sb + 3*g*length*cb*ca_*sa + f_a)/(cb*length) - 2*dl*da/length
    ddb = (-3*g*length*sb*cb*ca_**2 + f_b - 2*dl*db - length*da**2*sb*cb)/length
    return np.array([dl, da, db, ddl, dda, ddb])


def to_spherical(r, v):
    length, a, b = geometry.line(r)
    e_r = r/length
    e_a = np.array([-np.sin(a), np.cos(a), 0.0])
    e_b = np.cross(e_r, e_a)
    return np.array([length, a, b, v @ e_r, v @ e_a/(length*np.cos(b)), v @ e_b/length])


@each_orbit
def test_the_papers_spherical_form_flies_the_same_way(orbit):
    """To 1e-9 m over 100 s: row 10 of the specification's acceptance, not run in its prototype."""
    start = plant_start(orbit=orbit)[0]
    start[:3] += [30.0, 4.0, -3.0]              # an ordinary place; the release is at 1 m
    end = cartesian(orbit, start, 100.0)

    def rate(t, s):
        u = inputs(t)
        return spherical_rate(orbit, t, s, u[1:4] - [u[0], 0.0, 0.0], GRIPPER.mass_kg)
    made = solve_ivp(rate, (0.0, 100.0), to_spherical(start[:3], start[3:6]), method='DOP853',
                     rtol=1e-13, atol=1e-14).y[:, -1]
    assert_allclose(made, to_spherical(end[:3], end[3:6]), rtol=0, atol=1e-9)


@each_orbit
def test_sight_line_and_tether_close_the_triangle(orbit):
    """The sight line obeys the same equation with the force turned round, seen from the target."""
    start = plant_start(orbit=orbit)[0]
    start[:3] += [30.0, 4.0, -3.0]
    end = cartesian(orbit, start, 60.0)
    place, moving = geometry.baseline(orbit, 101.0, 0.0)

    def rate(t, s):
        tether = cartesian_path(t)[:3]
        u = inputs(t)
        push = Rotation.from_euler('ZY', [geometry.line(tether).alpha,
                                          -geometry.line(tether).beta]).apply(
            u[1:4] - [u[0], 0.0, 0.0])
        sight = Rotation.from_euler('ZY', [s[1], -s[2]]).inv().apply(-push)
        return spherical_rate(orbit, t, s, sight, GRIPPER.mass_kg)

    out = np.empty(13)

    def whole(t, x):
        u = inputs(t)
        motion.rate(x, u, u[0], *orbit_at(orbit, t), CRAFT, out)
        return out.copy()
    cartesian_path = solve_ivp(whole, (0.0, 60.0), start, method='DOP853', rtol=1e-12, atol=1e-12,
                               dense_output=True).sol
    made = solve_ivp(rate, (0.0, 60.0), to_spherical(place - start[:3], moving - start[3:6]),
                     method='DOP853', rtol=1e-11, atol=1e-12).y[:, -1]
    place, moving = geometry.baseline(orbit, 101.0, 60.0)
    assert_allclose(made, to_spherical(place - end[:3], moving - end[3:6]), rtol=0, atol=1e-8)


@each_orbit
def test_gravity_is_that_of_two_bodies_to_first_order(orbit):
    """The difference of two Kepler orbits: what is left shrinks with the square of the distance."""
    def left(scale):
        start = np.zeros(13)
        start[:6] = scale*np.array([3.0, 4.0, 2.0, 0.01, -0.02, 0.015])
        start[9] = 1.0
        end = cartesian(orbit, start, 600.0, lambda t: np.zeros(7))
        mu, now = orbit.gravitational_parameter_m3_s2, orbit.at(0.0)
        radial, along = np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0])
        e, c = orbit.eccentricity, 1.0 + orbit.eccentricity*np.cos(now.anomaly)
        climb = now.radius*now.rate*e*np.sin(now.anomaly)/c
        centre = np.concatenate([now.radius*radial, climb*radial + now.radius*now.rate*along])

        def kepler(t, y):
            return np.concatenate([y[3:], -mu*y[:3]/np.linalg.norm(y[:3])**3])
        ends = [solve_ivp(kepler, (0.0, 600.0), y, method='DOP853', rtol=1e-13, atol=1e-7).y[:3, -1]
                for y in (centre, centre + start[:6])]
        return np.linalg.norm(ends[1] - ends[0] - end[:3])
    far, near = left(8000.0), left(4000.0)
    assert far/near == pytest.approx(4.0, rel=0.05)


@each_orbit
def test_the_baseline_is_a_free_motion_normal_to_the_radius(orbit):
    place, moving = geometry.baseline(orbit, 101.0, 0.0)
    start = np.concatenate([place, moving, [0, 0, 0, 1, 0, 0, 0]])
    end = cartesian(orbit, start, 500.0, lambda t: np.zeros(7))
    place, moving = geometry.baseline(orbit, 101.0, 500.0)
    assert_allclose(end[:3], place, atol=1e-9)
    assert_allclose(end[3:6], moving, atol=1e-11)
    _, s, c = orbit_at(orbit, 500.0)
    assert abs(place @ [s, -c, 0.0]) < 1e-12


@each_orbit
def test_the_planner_has_the_same_rates_with_euler_angles(orbit):
    """Written twice: scalars of casadi over Euler angles, compiled loops over a quaternion."""
    rng = np.random.default_rng(3)
    t, x, u = ca.SX.sym('t'), ca.SX.sym('x', 12), ca.SX.sym('u', 7)
    planned = ca.Function('f', [t, x, u], [ca.vertcat(*rates(
        orbit, GRIPPER, t, ca.vertsplit(x), ca.vertsplit(u)))])
    out, h = np.empty(13), 1e-6
    for _ in range(20):
        state, control = rng.normal(size=12), rng.normal(size=7)
        state[:3] += [40.0, 0.0, 0.0]
        state[6:9] *= 0.4
        when = rng.uniform(0.0, 300.0)
        made = np.asarray(planned(when, state, control)).ravel()
        q = geometry.quaternion(state[6:9])
        motion.rate(np.concatenate([state[:6], q, state[9:]]), control, control[0],
                    *orbit_at(orbit, when), CRAFT, out)
        assert_allclose(made[:6], out[:6], rtol=1e-12, atol=1e-13)
        assert_allclose(made[9:], out[10:], rtol=1e-12, atol=1e-13)
        moved = geometry.quaternion(state[6:9] + h*made[6:9]) - geometry.quaternion(
            state[6:9] - h*made[6:9])
        assert_allclose(moved/(2*h), out[6:10], atol=1e-9)


@each_orbit
def test_the_planner_has_the_same_target(orbit):
    t = ca.SX.sym('t')
    place, moving = (ca.Function('f', [t], [ca.vertcat(*v)]) for v in target(orbit, 101.0, t))
    for when in (0.0, 37.0, 500.0):
        exact = geometry.baseline(orbit, 101.0, when)
        assert_allclose(np.ravel(place(when)), exact.place, atol=1e-10)
        assert_allclose(np.ravel(moving(when)), exact.rate, atol=1e-12)


def test_a_circle_is_an_ellipse_of_no_eccentricity():
    flat, round_ = (OrbitParams(eccentricity=e, perigee_altitude_m=500e3) for e in (1e-12, 0.0))
    u = np.tile(inputs(3.0), (1, 1))
    ends = [motion.advance(plant_start(), u, over_step(o, 5.0, 0.02), CRAFT[np.newaxis], 0.02)
            for o in (flat, round_)]
    assert_allclose(*ends, rtol=1e-12)


# -- the compiled step -----------------------------------------------------------------------------

def test_steps_of_20_ms_are_those_of_dop853():
    states, h = plant_start(orbit=LEO), 0.02
    held = inputs(0.0)
    for k in range(1000):
        states = motion.advance(states, held[np.newaxis], over_step(LEO, k*h, h),
                                CRAFT[np.newaxis], h)
    assert_allclose(states[0], cartesian(LEO, plant_start(orbit=LEO)[0], 20.0, lambda t: held),
                    atol=1e-9)


@pytest.mark.parametrize('n', [1, 7, 50])
def test_a_row_does_not_depend_on_its_batch(n):
    rng = np.random.default_rng(n)
    states = plant_start() + 0.01*rng.normal(size=(n, 13))
    commands, craft = rng.normal(size=(n, 7)), CRAFT*(1.0 + 0.1*rng.uniform(size=(n, 8)))
    orbit = over_step(GEO, 1.0, 0.02)
    whole = motion.advance(states, commands, orbit, craft, 0.02)
    single = [motion.advance(*(a[i:i + 1] for a in (states, commands)), orbit, craft[i:i + 1], 0.02)
              for i in range(n)]
    assert_array_equal(whole, np.concatenate(single))


# -- physics ---------------------------------------------------------------------------------------

def test_without_torque_angular_momentum_and_energy_stay():
    start = plant_start()[0]
    start[10:] = [0.3, -0.2, 0.4]
    end = cartesian(GEO, start, 60.0, lambda t: np.zeros(7))
    inertia = np.array(GRIPPER.inertia_kg_m2)

    def momentum(x):
        return Rotation.from_quat(x[6:10]).apply(inertia*x[10:])
    assert_allclose(momentum(end), momentum(start), rtol=1e-10)
    assert_allclose(np.sum(inertia*end[10:]**2), np.sum(inertia*start[10:]**2), rtol=1e-10)


def test_the_tether_is_a_pendulum_about_pitch_and_yaw_and_has_no_hold_on_roll():
    """sqrt(0.25 m T / I): 1.09 rad/s at 10 N in pitch, by the specification."""
    out, start = np.empty(13), np.zeros(13)
    start[0], start[9] = 50.0, 1.0
    pull = np.array([10.0, 0, 0, 0, 0, 0, 0])
    for axis, inertia in ((1, 2.1), (2, 2.2)):
        angle = 1e-4*np.eye(3)[axis]
        start[6:10] = geometry.quaternion(angle)
        motion.rate(start, pull, 10.0, *orbit_at(GEO, 0.0), CRAFT, out)
        assert -out[10 + axis]/angle[axis] == pytest.approx(2.5/inertia, rel=1e-6)
    assert np.sqrt(2.5/2.1) == pytest.approx(1.09, abs=2e-3)
    start[6:10] = geometry.quaternion([0.3, 0.0, 0.0])
    motion.rate(start, pull, 10.0, *orbit_at(GEO, 0.0), CRAFT, out)
    assert_allclose(out[10:], 0.0, atol=1e-15)


def test_tension_pulls_towards_the_platform_by_newtons_law():
    out, start = np.empty(13), plant_start()[0]
    start[:3] = [3.0, -4.0, 12.0]
    far = np.array([0.0, 0.0, 1.0])                     # no gravity
    motion.rate(start, np.array([6.5, 0, 0, 0, 0, 0, 0]), 6.5, *far*0, CRAFT, out)
    assert_allclose(out[3:6], -6.5/36.0*start[:3]/13.0, rtol=1e-14)
    assert_allclose(np.linalg.norm(out[3:6]), 6.5/36.0)


# -- the elastic tether ----------------------------------------------------------------------------

def test_stiffness_is_that_of_the_specification():
    assert TETHER.stiffness_n == pytest.approx(1.0210e5, rel=1e-4)


def test_a_locked_reel_leaves_the_axial_mode():
    """sqrt(EA / (l m)): 53 rad/s at 1 m."""
    length, h = 1.0, 2e-5
    states = np.zeros((1, 13))
    states[0, 0], states[0, 9] = length*(1 + 2e-6), 1.0
    reels = np.array([[length, 0.0, TETHER.stiffness_n*2e-6, 2e-6]])
    reel = np.array([TETHER.stiffness_n, 0.0, 0.0, 1.0])
    # about a pull that keeps it taut
    push = np.array([[0.0, TETHER.stiffness_n*1e-6, 0, 0, 0, 0, 0]])
    still = over_step(GEO, 0.0, 1.0)*[[0.0, 1.0, 1.0]]
    seen = []
    for _ in range(12_000):
        states, reels = motion.advance_elastic(states, reels, push, still, CRAFT[np.newaxis], reel,
                                               h, 1)
        seen.append(states[0, 3])
    crossings = np.flatnonzero(np.diff(np.sign(seen)))
    rate = np.pi/(np.diff(crossings).mean()*h)
    assert rate == pytest.approx(np.sqrt(TETHER.stiffness_n/36.0), rel=2e-3)
    assert np.sqrt(TETHER.stiffness_n/36.0) == pytest.approx(53.0, abs=0.5)


def test_a_good_reel_holds_the_tension_and_flies_like_tension_itself():
    stiff, h = TETHER.stiffness_n, 0.02
    states = elastic = plant_start()
    craft = CRAFT[np.newaxis]
    reels = np.array([[1.0/(1 + 0.02/stiff), 1.0, 0.02, 0.02/stiff]])
    reel = np.array([stiff, 0.1, 0.5, 0.05])
    for k in range(500):
        u = np.array([[1.0 + 0.8*np.sin(0.5*k*h), 0.1, 0, 0, 0, 0, 0]])
        orbit = over_step(GEO, k*h, h)
        states = motion.advance(states, u, orbit, craft, h)
        elastic, reels = motion.advance_elastic(elastic, reels, u, orbit, craft, reel, h, 20)
    assert_allclose(elastic[0, :3], states[0, :3], atol=0.02)
    assert reels[0, 2] == pytest.approx(u[0, 0], abs=0.05)
    assert reels[0, 0] == pytest.approx(
        np.linalg.norm(elastic[0, :3])/(1 + reels[0, 2]/stiff), rel=1e-9)


@given(st.floats(0.5, 100.0), st.floats(0.0, 10.0), st.floats(-1e-4, 1e-4), st.floats(-1.0, 1.0))
def test_the_reel_solves_its_own_equation(length, wanted, stretch, speed):
    """Backward Euler of ls' = speed + gain (T - wanted), speed' = gain/reset (T - wanted)."""
    gain, reset, h, stiffness, damping = 0.5, 0.05, 1e-3, 1.021e5, 0.1
    before, strain = length*(1.0 - stretch), 0.5*stretch
    found, turned, tension, now = motion.reel_step(
        length, wanted, before, speed, strain, stiffness, damping, gain, reset, h)
    assert now == pytest.approx((length - found)/found, abs=1e-12)
    assert tension == pytest.approx(max(0.0, stiffness*now + damping*(now - strain)/h), abs=1e-6)
    assert turned == pytest.approx(speed + h*gain/reset*(tension - wanted), abs=1e-9)
    assert found == pytest.approx(before + h*(turned + gain*(tension - wanted)), abs=1e-9)


def test_a_tether_does_not_push():
    found, _, tension, strain = motion.reel_step(10.0, 0.02, 10.5, 0.0, -0.01, 1e5, 0.0, 0.0, 1.0,
                                                 1e-3)
    assert tension == 0.0 and strain < 0.0 and found == 10.5


# -- geometry --------------------------------------------------------------------------------------

@given(st.tuples(*[st.floats(-1.4, 1.4)]*3))
def test_attitude_is_3_2_1(angles):
    q = geometry.quaternion(angles)
    turned = Rotation.from_euler('ZYX', angles[::-1])
    assert_allclose(Rotation.from_quat(q).as_matrix(), turned.as_matrix(), atol=1e-12)
    assert_allclose(geometry.euler(q), angles, atol=1e-9)
    phi, theta, psi = angles
    assert_allclose(geometry.boresight(q), [np.cos(theta)*np.cos(psi), np.cos(theta)*np.sin(psi),
                                            -np.sin(theta)], atol=1e-12)


@given(st.floats(-0.1, 0.1), st.floats(-0.1, 0.1), st.floats(-0.1, 0.1), st.floats(-0.1, 0.1))
def test_four_angles_within_a_quarter_of_the_cone_keep_the_target_in_view(alpha, beta, theta, psi):
    """gamma <= |psi - alpha0| + |theta + beta0|: the paper's rule, with the bound derived."""
    towards = [np.cos(beta)*np.cos(alpha), np.cos(beta)*np.sin(alpha), np.sin(beta)]
    gamma = geometry.sight_angle(geometry.quaternion([0.2, theta, psi]), towards)
    assert gamma <= abs(psi - alpha) + abs(theta + beta) + 1e-12 <= 0.4 + 1e-9
    exact = (np.cos(theta)*np.cos(beta)*np.cos(psi - alpha) - np.sin(theta)*np.sin(beta))
    assert np.cos(gamma) == pytest.approx(exact, abs=1e-12)


def test_the_goal_is_at_rest_before_the_target():
    end = geometry.goal(ELLIPSE, APPROACH, 100.0)
    place, moving = geometry.baseline(ELLIPSE, 101.0, 100.0)
    assert_allclose(place - end[:3], [20.0, 0.0, 0.0])
    assert_allclose(moving, end[3:6])
