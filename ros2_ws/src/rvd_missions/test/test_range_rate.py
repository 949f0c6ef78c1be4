"""
Range-rate laws: the line-of-sight equations, the reference rates, thrust, prediction, scenarios.
"""

from dataclasses import replace
from math import cos, pi, radians, sin
from pathlib import Path

from hypothesis import given, settings, strategies
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.acceleration import Continuous
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.motion import elliptic
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_groundstation.guidance.range_rate import (
    across, feed_forward, line_of_sight, LineOfSight, range_rate, state_of, wrap)
from rvd_missions.elliptic_rendezvous.laws import LAWS, Odrrca, Rrca
from rvd_missions.elliptic_rendezvous.prediction import VaryingPredictor
from rvd_missions.elliptic_rendezvous.thrust import ThrustParams, Thrusters

ROOT = Path(__file__).resolve().parents[4]
ORBIT = EllipseParams(start_anomaly_deg=60.0)
AT = ORBIT.at(0.0)
C = ORBIT.parameter/AT.radius
numbers = strategies.floats(-3.0, 3.0)


def los_of(d=800.0, phi=1.0, closing=-2.0, turning=2e-4):
    return LineOfSight(*(np.float64(v) for v in (d, phi, closing, turning)))


# -- the line of sight --------------------------------------------------------------------------

@given(strategies.floats(1.0, 1e5), numbers, strategies.floats(-30, 30),
       strategies.floats(-1e-2, 1e-2))
def test_state_and_line_of_sight_are_inverse(d, phi, closing, turning):
    found = line_of_sight(state_of(LineOfSight(d, phi, closing, turning)))
    assert_allclose([*found], [d, phi, closing, turning], rtol=1e-9, atol=1e-9)


def test_zero_is_radial_out_and_ahead_is_plus_ninety_degrees():
    directions = line_of_sight(np.array([
        [0.0, 9.0, 0, 0, 0, 0], [9.0, 0.0, 0, 0, 0, 0], [-9.0, 0.0, 0, 0, 0, 0]])).direction
    assert_allclose(np.degrees(directions), [0.0, 90.0, -90.0])


@pytest.mark.parametrize('phi', np.radians([-150.0, -90.0, 20.0, 69.0, 140.0]))
@pytest.mark.parametrize('accel', [(0.0, 0.0), (0.03, -0.02)])
def test_the_line_of_sight_equations_are_those_of_the_exact_motion_near_the_target(phi, accel):
    """
    (4) and (5) of the paper, to first order in D / r, against differences of the exact motion.
    """
    los, h = los_of(50.0, phi), 0.02
    s, c = np.sin(phi), np.cos(phi)
    thrust = np.array([accel[0]*s + accel[1]*c, accel[0]*c - accel[1]*s, 0.0])
    state = state_of(los)
    ends = [line_of_sight(elliptic.step(state, thrust, ORBIT, 0.0, t)) for t in (-h, h)]
    d2 = (ends[1].range_rate - ends[0].range_rate)/(2.0*h)
    phi2 = (ends[1].direction_rate - ends[0].direction_rate)/(2.0*h)
    gravity, turn = AT.rate**2/C, los.direction_rate + AT.rate
    d2_expected = los.range*turn**2 + accel[0] + gravity*los.range*(3.0*c*c - 1.0)
    phi2_expected = (accel[1]/los.range - AT.acceleration - 2.0*los.range_rate/los.range*turn
                     - 1.5*gravity*np.sin(2.0*phi))
    assert_allclose(d2, d2_expected, atol=1e-6)
    assert_allclose(phi2, phi2_expected, atol=1e-8)


# -- reference rates ----------------------------------------------------------------------------

def test_forms_agree_where_the_direction_stands_still_and_there_is_no_k2():
    los = los_of(turning=0.0)
    rates = [range_rate(form, -0.5, k1, 0.0, los, AT) for form, k1 in
             (('r1', 1.0), ('r2', 0.5), ('r4', 0.5))]
    assert_allclose(rates, -0.5*AT.rate*los.range)
    assert_allclose(range_rate('r4', -0.5, 0.5, -0.3, los, AT),
                    range_rate('r2', -0.5, 0.5, -0.3, los, AT))


def test_k2_of_minus_a_half_lets_the_range_follow_the_radius():
    """-1/2 nu.. / nu. = r. / r: with k = 0 and a line of sight that stands, D / r is held."""
    los = los_of(turning=0.0)
    h = 0.5
    growth = (ORBIT.at(h).radius - ORBIT.at(-h).radius)/(2.0*h)/AT.radius
    assert_allclose(range_rate('r1', 0.0, 1.0, -0.5, los, AT)/los.range, growth, rtol=1e-6)


@pytest.mark.parametrize('form', ['r2', 'r4'])
def test_the_quotient_is_bounded_where_the_line_of_sight_stands_in_inertial_space(form):
    for turn in (-1e-9, 0.0, 1e-9):
        los = los_of(turning=(turn - 1.0)*AT.rate)
        rate = range_rate(form, -0.5, 0.5, 0.0, los, AT)
        assert abs(rate) <= 1.0001*los.range*AT.rate/0.05


@settings(deadline=None)
@given(numbers, numbers)
def test_transverse_thrust_pulls_the_short_way_to_the_direction(phi, phi_d):
    los = los_of(phi=phi, turning=0.0)
    pull = across(10.0, 0.0, phi_d, los, AT, 0.0)
    if 1e-6 < abs(wrap(phi - phi_d)) < pi - 1e-6:
        assert np.sign(pull) == -np.sign(sin(phi - phi_d))
    assert_allclose(pull, -10.0*los.range*AT.rate**2*wrap(phi - phi_d))


@pytest.mark.parametrize('k2', [0.0, -0.5, 0.3])
def test_full_feed_forward_is_what_keeps_the_direction(k2):
    """With it phi.. = 0 at phi = phi_d at rest, for D. = D._r of form R1."""
    phi_d, k = radians(40.0), -0.5
    los = los_of(phi=phi_d, turning=0.0)
    los = los._replace(range_rate=range_rate('r1', k, 1.0, k2, los, AT))
    fed = feed_forward('full', k, k2, phi_d, AT, C)
    push = across(10.0, 4.0, phi_d, los, AT, fed)/los.range
    phi2 = (push - AT.acceleration - 2.0*los.range_rate/los.range*AT.rate
            - 1.5*AT.rate**2/C*sin(2.0*phi_d))
    assert abs(phi2) < 1e-12*AT.rate


# -- thrust -------------------------------------------------------------------------------------

def thrusters(**given):
    return Thrusters(ThrustParams(**given), 1.0, ())


def demand(rate, push=0.0):
    from rvd_missions.elliptic_rendezvous.laws import Demand
    return Demand(np.float64(rate), np.float64(push), np.bool_(False))


def test_ideal_thrust_keeps_the_range_rate_where_there_is_no_error():
    los = los_of(50.0)
    along, push, _ = thrusters().acceleration(state_of(los), los, demand(los.range_rate), AT, C,
                                              -0.5)
    state = elliptic.step(state_of(los), along*np.array([np.sin(los.direction), np.cos(
        los.direction), 0.0]), ORBIT, 0.0, 0.1)
    assert_allclose(line_of_sight(state).range_rate, los.range_rate, atol=1e-7)
    assert push == 0.0


@pytest.mark.parametrize('reference', [-30.0, -1.0, -0.02])
def test_the_dead_band_scales_with_the_reference_rate_down_to_its_floor(reference):
    band = max(0.001, 0.002*abs(reference))
    pulses = thrusters(thrusters='pulses')
    for error, fires in ((0.9*band, False), (1.1*band, True), (-1.1*band, True)):
        los = los_of(closing=reference - error)
        along, _, _ = pulses.acceleration(state_of(los), los, demand(reference), AT, C, -0.5)
        assert_allclose(along, error if fires else 0.0, atol=1e-12)     # within one step of 1 s


def test_pulses_across_fire_what_is_owed_no_more_and_no_less():
    pulses, los, fired = thrusters(thrusters='pulses'), los_of(closing=-1.0), 0.0
    for _ in range(1000):
        _, push, _ = pulses.acceleration(state_of(los), los, demand(-1.0, 3.3e-4), AT, C, -0.5)
        assert push == 0.0 or abs(push) > 0.002
        fired += push
    assert_allclose(fired, 0.33, atol=0.0025)


def test_thrust_is_limited():
    los = los_of(50e3, closing=100.0)
    along, _, _ = thrusters().acceleration(state_of(los), los, demand(-30.0), AT, C, -0.5)
    assert along == -0.4


# -- prediction across the loop -----------------------------------------------------------------

def test_prediction_is_the_exact_motion_with_the_commands_in_flight():
    legs, form, rng = Legs(3, 2, 2.0), Continuous(0.6), np.random.default_rng(1)
    predictor = VaryingPredictor(ORBIT, legs, form, (2,))
    commands = form.quantise(rng.normal(size=(60, 2, 3))*0.01)
    states = [np.array([[-90.0, 40, 5, 0.1, -0.1, 0.01], [400.0, -900, 0, 0.5, 0.2, 0]])]
    for k in range(60):                                     # sent at k, acts on k + forward
        accel = commands[k - legs.forward] if k >= legs.forward else np.zeros((2, 3))
        states.append(elliptic.step(states[-1], accel, ORBIT, 2.0*k, 2.0))
    for k in range(50):
        m = k - legs.back
        received = np.array([m >= 0 and k % 7 != 3, m >= 0])
        _, ahead = predictor.advance(k, states[max(m, 0)], received, commands[k - 1] if k else None)
        if m >= 0 and k > 5:
            assert_allclose(ahead, states[k + legs.forward], atol=2e-4)


def test_without_delay_the_prediction_is_the_sample_itself():
    predictor = VaryingPredictor(ORBIT, Legs(0, 0, 2.0), Continuous(0.6), ())
    sample = np.array([1.0, 2, 3, 4, 5, 6])
    assert_array_equal(predictor.advance(0, sample, np.bool_(True), None)[1], sample)


# -- what is refused ----------------------------------------------------------------------------

@pytest.mark.parametrize('given,words', [
    ({'k': 0.0}, 'k must be negative'), ({'k': 0.5}, 'k must be negative'),
    ({'k1': 0.5}, 'k1 must be above -k = 0.5'),
    ({'form': 'r2', 'k1': -0.1}, 'k1 must be above 0'),
    ({'form': 'r5'}, 'form must be one of r1, r2, r4')])
@pytest.mark.parametrize('law', LAWS.values())
def test_gains_of_the_wrong_sign_are_refused(law, given, words):
    with pytest.raises(BadInput) as refused:
        law(**given)
    assert str(refused.value).startswith(words) and '\n' not in str(refused.value)


def test_gains_of_the_transverse_thruster_are_refused_likewise():
    for wrong in ({'q': 0.0}, {'q': -3.0}, {'q1': -0.1}, {'ff': 'some'}):
        with pytest.raises(BadInput, match=list(wrong)[0]):
            Odrrca(**wrong)
    assert replace(Rrca(), k2=-0.5).k2 == -0.5


@pytest.mark.parametrize('key,value,words', [
    ('orbit.eccentricity', 1.0, 'orbit.eccentricity must be below 1: an orbit'),
    ('orbit.perigee_altitude_m', -5.0, 'orbit.perigee_altitude_m must be positive: the orbit hits'),
    ('guidance.rrca.k1', 0.3, 'guidance.rrca.k1 must be above -k = 0.5'),
    ('guidance.law', 'pid', 'guidance.law must be one of'),
    ('start.range_m', 40.0, 'start.range_m must be above arrival.range_m = 50'),
    ('step_s', 10.0, 'step_s must be at most 8.2')])
def test_a_scenario_that_cannot_be_flown_is_refused_by_key_and_bound(key, value, words):
    with pytest.raises(BadInput) as refused:
        load(ROOT / 'scenarios' / 'ellipse.yaml').with_values('/**', **{key: value})
    assert words in str(refused.value) and str(value) in str(refused.value)
    assert '\n' not in str(refused.value)


def test_one_plus_e_cos_nu_is_parameter_over_radius():
    assert_allclose(C, 1.0 + ORBIT.eccentricity*cos(AT.anomaly))
