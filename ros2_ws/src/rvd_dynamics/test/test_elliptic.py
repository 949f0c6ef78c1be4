"""Relative motion on an ellipse, against Kepler's closed solution in 40 digits and conservation."""

from math import cos, degrees, pi, radians, sin

from hypothesis import given, settings, strategies
import mpmath
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.motion import elliptic, two_body
from rvd_dynamics.motion.kepler import EllipseParams, mean_anomaly, true_anomaly

ORBIT = EllipseParams(start_anomaly_deg=-50.0)
MU = ORBIT.gravitational_parameter_m3_s2
COAST = np.zeros(3)
STARTS = {
    'near': [-40.0, 25.0, 10.0, 0.03, -0.02, 0.01],
    'far': [-25e3, -40e3, 5e3, 12.0, -20.0, 3.0],
}


def coasted(state, duration, dt, orbit=ORBIT, accel=COAST):
    """Return the state after `duration`, in steps of dt."""
    for i in range(round(duration/dt)):
        state = elliptic.step(state, accel, orbit, i*dt, dt)
    return state


# -- the target's orbit -------------------------------------------------------------------------

@settings(deadline=None)
@given(strategies.floats(-50.0, 50.0), strategies.floats(0.0, 0.99))
def test_kepler_equation_holds_and_anomalies_count_orbits_on(mean, e):
    nu = true_anomaly(mean, e)
    assert_allclose(mean_anomaly(nu, e), mean, atol=1e-10)
    assert abs(nu - mean) < pi                              # the same orbit
    # by areas: dM = (1 - e^2)^1.5 / (1 + e cos nu)^2 dnu
    h = 1e-6
    slope = (mean_anomaly(nu + h, e) - mean_anomaly(nu - h, e))/(2.0*h)
    assert_allclose(slope, (1.0 - e*e)**1.5/(1.0 + e*cos(nu))**2, rtol=1e-6, atol=1e-8)


def test_one_orbit_takes_the_period_and_the_rates_are_derivatives():
    assert_allclose(ORBIT.at(ORBIT.period).anomaly - ORBIT.at(0.0).anomaly, 2.0*pi)
    assert_allclose(ORBIT.time_of(ORBIT.at(3456.7).anomaly), 3456.7)
    assert_allclose(degrees(ORBIT.at(0.0).anomaly), -50.0)
    h = 0.01
    for t in (0.0, 700.0, 4000.0):
        before, at, after = (ORBIT.at(t + d) for d in (-h, 0.0, h))
        assert_allclose((after.anomaly - before.anomaly)/(2.0*h), at.rate, rtol=1e-9)
        assert_allclose((after.rate - before.rate)/(2.0*h), at.acceleration, rtol=1e-6)
    perigee = ORBIT.motion(0.0)
    assert_allclose(perigee.radius, ORBIT.body_radius_m + 300e3)
    assert_allclose(perigee.rate**2, MU/perigee.radius**3*1.1)              # v^2 = mu (1 + e) / r


@pytest.mark.parametrize('given,words', [
    ({'eccentricity': 1.0}, 'eccentricity must be below 1'),
    ({'eccentricity': -0.1}, 'eccentricity must not be negative'),
    ({'perigee_altitude_m': 0.0}, 'perigee_altitude_m must be positive: the orbit hits the body'),
    ({'perigee_altitude_m': -1e5}, 'perigee_altitude_m must be positive: the orbit hits')])
def test_an_impossible_orbit_is_refused_with_the_reason(given, words):
    with pytest.raises(BadInput) as refused:
        EllipseParams(**given)
    assert str(refused.value).startswith(words)
    assert str(refused.value).endswith(f'got {list(given.values())[0]}')


# -- both craft by Kepler, in 40 digits ---------------------------------------------------------

def inertial(state, at):
    """Return position and velocity (3,) of the chaser in the target's plane, in mpmath."""
    x, y, z, vx, vy, vz = (mpmath.mpf(float(v)) for v in state)
    r, w, nu = (mpmath.mpf(v) for v in (at.radius, at.rate, at.anomaly))
    closing = r*w*mpmath.mpf(ORBIT.eccentricity)*mpmath.sin(nu)/(
        1 + mpmath.mpf(ORBIT.eccentricity)*mpmath.cos(nu))
    up, along = [mpmath.cos(nu), mpmath.sin(nu)], [-mpmath.sin(nu), mpmath.cos(nu)]
    radial, across = vy - w*x + closing, vx + w*(y + r)
    return ([(r + y)*up[i] + x*along[i] for i in (0, 1)] + [-z],
            [radial*up[i] + across*along[i] for i in (0, 1)] + [-vz])


def kepler(position, velocity, duration):
    """Propagate by Lagrange's coefficients in the eccentric anomaly, in mpmath."""
    mu, t = mpmath.mpf(MU), mpmath.mpf(duration)
    dot = lambda a, b: sum(p*q for p, q in zip(a, b))       # noqa: E731
    r0 = mpmath.sqrt(dot(position, position))
    a = 1/(2/r0 - dot(velocity, velocity)/mu)
    sigma, n = dot(position, velocity)/mpmath.sqrt(mu), mpmath.sqrt(mu/a**3)
    def off(d):
        return (d - (1 - r0/a)*mpmath.sin(d) + sigma/mpmath.sqrt(a)*(1 - mpmath.cos(d)) - n*t)
    d = mpmath.findroot(off, n*t)
    f = 1 - a/r0*(1 - mpmath.cos(d))
    g = t + mpmath.sqrt(a**3/mu)*(mpmath.sin(d) - d)
    r = a + (r0 - a)*mpmath.cos(d) + sigma*mpmath.sqrt(a)*mpmath.sin(d)
    df = -mpmath.sqrt(mu*a)/(r*r0)*mpmath.sin(d)
    dg = 1 - a/r*(1 - mpmath.cos(d))
    return ([f*p + g*v for p, v in zip(position, velocity)],
            [df*p + dg*v for p, v in zip(position, velocity)])


def exact(state, duration):
    """Return the relative state after `duration`: Kepler for both craft, then the difference."""
    with mpmath.workdps(40):
        begin = ORBIT.at(0.0)
        target = kepler(*inertial(np.zeros(6), begin), duration)
        chaser = kepler(*inertial(state, begin), duration)
        (px, py, _), (vx, vy, _) = target
        r = mpmath.sqrt(px*px + py*py)
        up, along = [px/r, py/r], [-py/r, px/r]
        w = (px*vy - py*vx)/(r*r)
        d, v = ([b - a for a, b in zip(*pair)] for pair in zip(target, chaser))
        x, y = (d[0]*axis[0] + d[1]*axis[1] for axis in (along, up))
        dx, dy = (v[0]*axis[0] + v[1]*axis[1] for axis in (along, up))
        return np.array([float(q) for q in (x, y, -d[2], dx - w*y, dy + w*x, -v[2])])


@pytest.mark.parametrize('name', STARTS)
@pytest.mark.parametrize('dt', [1.0, 2.0])
def test_agrees_with_kepler_for_both_craft_after_a_whole_orbit(name, dt):
    state, duration = np.array(STARTS[name]), dt*round(ORBIT.period/dt)
    expected = exact(state, duration)
    size = np.linalg.norm(expected[:3])
    found = coasted(state, duration, dt)
    assert_allclose(found[:3], expected[:3], atol=3e-9*size)
    assert_allclose(found[3:], expected[3:], atol=3e-9*size*ORBIT.mean_motion)


def test_differential_gravity_keeps_its_digits_at_50_m():
    x, y = 30.0, -40.0
    with mpmath.workdps(40):
        r, big_y = mpmath.mpf(ORBIT.at(0.0).radius), mpmath.mpf(ORBIT.at(0.0).radius) + y
        cube = (big_y**2 + x*x)**mpmath.mpf(1.5)
        expected = [float(-MU*x/cube), float(-MU*big_y/cube + MU/r**2)]
    at = ORBIT.at(0.0)._replace(rate=0.0, acceleration=0.0)         # gravity alone
    found = elliptic._rate((x, y, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0), at, MU)[3:5]
    assert_allclose(found, expected, rtol=1e-14)


@pytest.mark.parametrize('name', STARTS)
def test_energy_and_angular_momentum_of_the_chaser_are_kept(name):
    def constants(state, at):
        p, v = (np.array([float(c) for c in part]) for part in inertial(state, at))
        return v @ v/2.0 - MU/np.linalg.norm(p), np.cross(p, v)
    state = np.array(STARTS[name])
    begin = constants(state, ORBIT.at(0.0))
    end = constants(coasted(state, 4000.0, 2.0), ORBIT.at(4000.0))
    assert_allclose(end[0], begin[0], rtol=1e-13)
    assert_allclose(end[1], begin[1], atol=1e-13*np.linalg.norm(begin[1]))


# -- other roads --------------------------------------------------------------------------------

def test_held_thrust_agrees_with_an_inertial_integration():
    accel, state, duration = np.array([0.03, -0.02, 0.01]), np.array(STARTS['far']), 600.0

    def rate(t, s):
        at = ORBIT.at(t)
        up, along = np.array([cos(at.anomaly), sin(at.anomaly), 0.0]), np.array(
            [-sin(at.anomaly), cos(at.anomaly), 0.0])
        thrust = accel[0]*along + accel[1]*up - accel[2]*np.array([0.0, 0.0, 1.0])
        return [*s[3:], *(-MU*s[:3]/np.linalg.norm(s[:3])**3 + thrust)]
    p, v = (np.array([float(c) for c in part]) for part in inertial(state, ORBIT.at(0.0)))
    way = solve_ivp(rate, (0.0, duration), [*p, *v], method='DOP853', rtol=1e-13, atol=1e-6)
    end = way.y[:, -1]
    found = coasted(state, duration, 2.0, accel=accel)
    p, v = (np.array([float(c) for c in part]) for part in inertial(found, ORBIT.at(duration)))
    assert_allclose(end[:3], p, atol=2e-5)
    assert_allclose(end[3:], v, atol=2e-8)


def test_on_a_circle_it_is_the_two_body_motion_of_a_circular_target():
    circle = EllipseParams(eccentricity=0.0)
    n, radius = circle.mean_motion, circle.parameter
    state = other = np.array(STARTS['far'])
    for i in range(300):
        state = elliptic.step(state, COAST + 0.01, circle, 2.0*i, 2.0)
        other = two_body.step(other, COAST + 0.01, n, radius, 2.0)
    assert_allclose(state, other, rtol=1e-11)


def test_time_reversed_at_perigee_it_is_mirrored():
    """t -> -t maps the orbit onto itself: x, vy, vz change sign."""
    orbit, mirror = EllipseParams(), np.array([-1.0, 1.0, 1.0, 1.0, -1.0, -1.0])
    state = back = np.array(STARTS['far'])
    for i in range(500):
        state = elliptic.step(state, COAST, orbit, 2.0*i, 2.0)
        back = elliptic.step(back, COAST, orbit, -2.0*i, -2.0)
    ahead = state
    state = mirror*np.array(STARTS['far'])
    for i in range(500):
        state = elliptic.step(state, COAST, orbit, 2.0*i, 2.0)
    assert_allclose(state, mirror*back, rtol=1e-12)
    assert not np.allclose(ahead, state)


def test_the_plane_of_the_orbit_is_a_mirror():
    flip = np.array([1.0, 1.0, -1.0, 1.0, 1.0, -1.0])
    assert_allclose(coasted(flip*STARTS['far'], 1000.0, 2.0), flip*coasted(
        np.array(STARTS['far']), 1000.0, 2.0), rtol=0)


@pytest.mark.parametrize('batch', [(), (3,), (2, 2)])
def test_a_batch_has_the_bits_of_its_rows(batch):
    states = np.random.default_rng(3).normal(size=(*batch, 6))*[5e3, 5e3, 5e3, 5, 5, 5]
    accels = np.random.default_rng(4).normal(size=(*batch, 3))*0.1
    together = elliptic.step(states, accels, ORBIT, 100.0, 2.0)
    alone = [elliptic.step(s, a, ORBIT, 100.0, 2.0)
             for s, a in zip(states.reshape(-1, 6), accels.reshape(-1, 3))]
    assert_array_equal(together.reshape(-1, 6), alone)


def test_unknown_stays_unknown_and_degrees_are_degrees():
    assert np.isnan(elliptic.step(np.full(6, np.nan), COAST, ORBIT, 0.0, 1.0)).all()
    assert_allclose(ORBIT.at(0.0).anomaly, radians(-50.0))
