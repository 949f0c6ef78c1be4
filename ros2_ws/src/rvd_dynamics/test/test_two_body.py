"""Two-body relative motion against an adaptive integrator, inertial orbits and CW."""

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics import frames
from rvd_dynamics.motion import two_body
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.world.plants.relative import Cw, TwoBody
from rvd_dynamics.commands.levels import acceleration, ThrustParams

ORBIT = OrbitParams()
N, RADIUS, MU = ORBIT.mean_motion, ORBIT.radius_m, ORBIT.gravitational_parameter_m3_s2
STARTS = {
    'approach': [-30.0, 0.5, -0.5, 0.25, 0.01, -0.01],
    'far': [-2000.0, 300.0, 500.0, 1.0, -0.5, 0.4],
}


def relative_rate(t, s, accel):
    """Return the equations of motion as they are written, large terms and all."""
    x, y, z, vx, vy, vz = s
    cube = (x*x + (RADIUS + y)**2 + z*z)**1.5
    return [vx, vy, vz,
            -2*N*vy + N*N*x - MU*x/cube + accel[0],
            2*N*vx + N*N*(RADIUS + y) - MU*(RADIUS + y)/cube + accel[1],
            -MU*z/cube + accel[2]]


def authority(state, accels, step_s):
    """Integrate with DOP853 from switch to switch of the thrust."""
    for accel in accels:
        state = solve_ivp(relative_rate, (0.0, step_s), state, method='DOP853', rtol=1e-13,
                          atol=1e-14, args=(accel,)).y[:, -1]
    return state


@pytest.mark.parametrize('start', STARTS.values(), ids=STARTS.keys())
@pytest.mark.parametrize('step_s', [0.05, 0.1, 0.5, 1.0])
def test_agrees_with_dop853_over_200_s_of_switching_thrust(step_s, start):
    model = TwoBody(ORBIT, step_s)
    hold = round(2.0 / step_s)                      # thrust switches every 2 s
    levels = np.random.default_rng(4).integers(-3, 4, size=(100, 3))
    accels = acceleration(levels, ThrustParams())
    state = np.array(start)
    for accel in accels:
        for _ in range(hold):
            state = model.advance(state, accel)
    error = np.abs(state - authority(np.array(start), accels, 2.0))
    assert error[:3].max() < 1e-9
    assert error[3:].max() < 1e-11


def test_agrees_with_two_inertial_orbits_seen_from_the_target():
    def attraction(t, s):
        return [*s[3:], *(-MU * s[:3] / (s[:3] @ s[:3])**1.5)]

    start = np.array(STARTS['far'])
    chaser = solve_ivp(attraction, (0.0, 200.0), frames.to_inertial(start, 0.0, ORBIT),
                       method='DOP853', rtol=1e-13, atol=1e-9).y[:, -1]
    state = start
    for _ in range(200):
        state = two_body.step(state, np.zeros(3), N, RADIUS, 1.0)
    # a position of 2e6 m in 16 digits, integrated: 1e-8 m is what that road can give
    assert_allclose(state, frames.to_target(chaser, 200.0, ORBIT), rtol=0.0, atol=1e-7)


def test_cw_agrees_over_the_whole_approach():
    linear, nonlinear = Cw(ORBIT, 0.5), TwoBody(ORBIT, 0.5)
    one = other = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    away = np.zeros(6)
    for _ in range(240):
        one, other = linear.advance(one, np.zeros(3)), nonlinear.advance(other, np.zeros(3))
        away = np.maximum(away, np.abs(one - other))
    assert away[:3].max() < 2e-6 and away[3:].max() < 2e-8
    assert away[:3].max() > 1e-9                    # and they are not the same model


def test_the_target_itself_stays_where_it_is():
    state = np.zeros(6)
    for _ in range(400):
        state = two_body.step(state, np.zeros(3), N, RADIUS, 1.0)
    assert np.array_equal(state, np.zeros(6))


def test_a_higher_circular_orbit_stays_circular():
    # its rate at the target's: relative angle phi(t), seen in the turning frame
    higher = RADIUS + 1000.0
    rate = np.sqrt(MU / higher**3)
    state = np.array([0.0, 1000.0, 0.0, higher*(rate - N), 0.0, 0.0])
    for _ in range(1000):
        state = two_body.step(state, np.zeros(3), N, RADIUS, 1.0)
    angle = (rate - N) * 1000.0
    assert_allclose(state[:3], [higher*np.sin(angle), higher*np.cos(angle) - RADIUS, 0.0],
                    rtol=0.0, atol=1e-8)


def test_energy_of_the_orbit_is_kept():
    def energy(state):
        s = frames.to_inertial(state, 0.0, ORBIT)
        return s[3:] @ s[3:] / 2 - MU / np.sqrt(s[:3] @ s[:3])

    state = np.array(STARTS['far'])
    before = energy(state)
    for _ in range(7656):
        state = two_body.step(state, np.zeros(3), N, RADIUS, 1.0)
    assert energy(state) == pytest.approx(before, rel=1e-13)


def test_unknown_stays_unknown():
    state = two_body.step([np.nan, 0.0, 0.0, 0.25, 0.0, 0.0], np.zeros(3), N, RADIUS, 0.5)
    assert np.isnan(state[:2]).all()
