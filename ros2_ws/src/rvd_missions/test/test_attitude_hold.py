"""Attitude hold in one process: plant, sensors, faults, judge, against closed forms."""

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.in_process import fly, judge_of
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import display_of
from rvd_missions.attitude_hold import MISSION
from rvd_missions.attitude_hold.commands import form, TorqueParams
from rvd_missions.attitude_hold.control import Control
from rvd_missions.attitude_hold.laws import LAWS
from rvd_missions.attitude_hold.settings import Attitude, Craft
from rvd_missions.attitude_hold.signals import LAW, MEASUREMENT, TELEMETRY, THRUST, TRUTH
from rvd_missions.attitude_hold.stability import loop, poles, TWO_TAPS

ROOT = Path(__file__).resolve().parents[4]
QUIET = {'attitude_sensors': {'horizon_sigma_deg': 0.0, 'sun_sigma_deg': 0.0,
                              'gyro_sigma_deg': 0.0},
         'attitude_dynamics': {'angle_sigma_deg': 0.0, 'rate_sigma_deg_s': 0.0}}
FIXED = {'law': 'golden_section', 'golden_section.adapts': False,
         'golden_section.derivative_per_s': 0.0, 'golden_section.softening': 0.0}
LAW_NAMES = pytest.mark.parametrize('law', LAWS)
PAIRS = [(a, s) for a in (0.4, 1.0, 2.5) for s in (0.5, 1.0, 2.0)]


def scenario(sections=None, **shared):
    """Return a scenario of the mission; keys of `shared` have `__` for a dot."""
    keys = {'timeout_s': 300.0, **{key.replace('__', '.'): v for key, v in shared.items()}}
    return Scenario('held', MISSION, {'/**': keys, **(sections or {})}).check()


def flown(sections=None, runs=(0,), **shared):
    return fly(scenario(sections, **shared), runs, record=True)


# -- plant and sensors -------------------------------------------------------------------------

def test_a_constant_disturbance_moves_the_axis_along_a_parabola():
    """J angle'' = torque; the law is switched off by an actuator of next to no gain."""
    sections = {**QUIET, 'attitude_dynamics': {
        'angle_sigma_deg': 0.0, 'rate_sigma_deg_s': 0.0, 'rate_deg_s': 0.1,
        'disturbance_n_m': 0.003}}
    batch = flown(sections, timeout_s=60.0, craft__inertia_kg_m2=50.0, faults__actuator_gain=1e-12,
                  faults__actuator_at_s=0.0, attitude__reference_deg=0.0)
    state = batch.history[TRUTH.name].state[:, 0]
    t = 0.5*np.arange(len(state))
    assert_allclose(state[:, 0], np.radians(0.1)*t + 0.5*0.003/50.0*t*t, rtol=1e-9, atol=1e-12)
    assert_allclose(state[:, 1], np.radians(0.1) + 0.003/50.0*t, rtol=1e-9)


def test_the_combined_sensors_are_exact_without_noise_and_see_the_gain_fault():
    batch = flown(QUIET, faults__sensor_gain=2.0, faults__sensor_at_s=10.0, timeout_s=60.0)
    truth, seen = batch.history[TRUTH.name], batch.history[MEASUREMENT.name]
    angle = truth.state[:, 0, 0]
    assert_allclose(seen.state[:20, 0, 0], angle[:20], atol=1e-15)
    left = 0.5**np.arange(1, 101)                   # what the gyro's share still remembers
    assert_allclose(seen.state[20:120, 0, 0], 2.0*angle[20:120] - left*angle[19], atol=1e-12)


def test_noise_of_the_combined_attitude_is_that_of_its_recursion():
    """Variance (w^2 g^2 + (1-w)^2 s^2/2)/(1-w^2), and the gyro's difference."""
    batch = flown(runs=range(60), timeout_s=60.0)
    error = (batch.history[MEASUREMENT.name].state[40:, :, 0]
             - batch.history[TRUTH.name].state[40:, :, 0])
    sigma = np.sqrt((0.25 + 0.25/2)/0.75)*0.002
    assert_allclose(np.degrees(error.std()), sigma, rtol=0.05)


@pytest.mark.parametrize('law_runs', ['ground', 'onboard'])
def test_the_actuator_gain_acts_on_the_torque_from_its_instant_on(law_runs):
    batch = flown(law_runs=law_runs, faults__actuator_gain=0.4, faults__actuator_at_s=30.0)
    asked = batch.history[THRUST.name].command[:-1, 0, 0]
    done = batch.history[TRUTH.name].torque[1:, 0, 0]
    gain = np.where(np.arange(len(asked)) < 60, 1.0, 0.4)
    assert_array_equal(done, gain*asked)


# -- loop ----------------------------------------------------------------------------------------

@pytest.mark.parametrize('rho', [0.5, 1.0, 1.8, 2.4, 2.6, 2.8])
def test_the_fixed_law_decays_or_grows_as_its_poles_say(rho):
    """The actuator's gain is rho; two taps, and f1, f2 of the corner of the range."""
    batch = flown(
        {**QUIET, 'attitude_controller': FIXED, 'attitude_dynamics': {
            'angle_sigma_deg': 0.0, 'rate_sigma_deg_s': 0.0, 'angle_deg': 0.001}},
        timeout_s=60.0, faults__actuator_gain=rho, faults__actuator_at_s=0.0,
        attitude__reference_deg=0.0, torque__step_n_m=1e-7, torque__max_n_m=50.0)
    angle = np.abs(np.degrees(batch.history[TRUTH.name].state[:, 0, 0]))
    size = np.maximum.accumulate(angle[::-1])[::-1] if rho < 2.5 else np.maximum.accumulate(angle)
    seen = size[:40]
    rate = np.exp(np.polyfit(np.arange(10, 40), np.log(np.maximum(seen[10:40], 1e-300)), 1)[0])
    base, change = loop(TWO_TAPS)
    expected = abs(poles(rho, base, change)[0])
    assert_allclose(rate, expected, atol=0.05)
    assert (rate < 1.0) == (rho < 2.5)


@LAW_NAMES
@pytest.mark.parametrize(('actuator', 'sensor'), PAIRS)
def test_every_pair_of_faults_is_held(law, actuator, sensor):
    verdict = fly(scenario({'attitude_controller': {'law': law}}, faults__actuator_gain=actuator,
                           faults__sensor_gain=sensor), range(10)).verdict
    assert verdict.success.all(), verdict.reason
    assert np.all(verdict.values['rms_final_deg'] < 0.02)


@LAW_NAMES
def test_on_board_and_on_the_ground_without_delay_are_the_same_bits(law):
    made = [flown({'attitude_controller': {'law': law}}, law_runs=place, runs=[3],
                  faults__actuator_gain=2.5) for place in ('ground', 'onboard')]
    for part in ('state', 'torque'):
        assert_array_equal(*(getattr(b.history[TRUTH.name], part) for b in made))


def test_a_run_is_the_same_alone_and_in_any_batch():
    world = scenario(faults__actuator_gain=0.4, faults__sensor_gain=2.0)
    together = fly(world, range(20), record=[TRUTH.name]).history[TRUTH.name].state
    for run in (0, 7, 19):
        alone = fly(world, [run], record=[TRUTH.name]).history[TRUTH.name].state
        assert_array_equal(alone[:, 0], together[:, run])


def test_pid_removes_a_constant_disturbance_and_golden_section_does_not():
    """Without an integral the error is what balances it: d/J = (l1 f1 + l2 f2) e/((b+l) dt^2)."""
    final = {}
    for law, sections in (('pid', {'law': 'pid', 'pid.integral_per_s3': 0.005}),
                          ('golden_section', FIXED)):
        batch = flown({**QUIET, 'attitude_controller': sections, 'attitude_dynamics': {
            'angle_sigma_deg': 0.0, 'rate_sigma_deg_s': 0.0, 'disturbance_n_m': 0.005}},
            timeout_s=1200.0)
        final[law] = np.degrees(batch.history[TRUTH.name].state[-1, 0, 0])
    assert abs(final['pid']) < 5e-4
    golden = (np.sqrt(5.0) - 1.0)/2.0
    stiffness = ((1.0 - golden)*1.9975 - golden*0.9999)/0.25
    assert_allclose(final['golden_section'], np.degrees(0.005/100.0/stiffness), rtol=0.01)


def test_noise_alone_does_not_move_the_gain_of_the_model_within_an_hour():
    """What a dead zone below the noise would let happen: 3 in place of 0.9."""
    def gain(**law):
        world = scenario({'attitude_controller': law}, timeout_s=3600.0, attitude__step_at_s=3600.0,
                         faults__actuator_at_s=3600.0, faults__sensor_at_s=3600.0)
        return fly(world, range(5), record=[LAW.name]).history[LAW.name].inside[:, :, 2]
    steady = gain()
    assert np.all(np.abs(steady[-1] - steady[240]) < 0.1)
    drifting = gain(**{'golden_section.dead_zone_deg': 6e-4, 'golden_section.f_variance': 0.12,
                       'golden_section.forgetting': 0.956})
    assert np.all(drifting[-1] > 2.0)


def test_a_lost_sample_is_bridged_and_a_long_outage_leaves_the_torque_at_zero():
    lossy = {'link_back': {'loss_fraction': 0.1}}
    assert fly(scenario(lossy, law_runs='ground'), range(10)).verdict.success.all()
    gone = {'link_back': {'loss_fraction': 1.0}}
    batch = flown(gone, law_runs='ground', timeout_s=60.0)
    assert np.all(batch.history[THRUST.name].command == 0.0)


class Noting:
    """A law that notes what it is told of the command that acted, and asks for its own number."""

    def __init__(self):
        self.told, self.inside = [], {}

    def controller(self, step_s, batch):
        return self

    def wanted(self, errors, acted, fresh):
        self.told.append(float(acted))
        return np.float64(1e-3*len(self.told))


@pytest.mark.parametrize('loop_steps', [0, 1, 5])
def test_a_law_is_told_the_command_that_acted_before_its_newest_sample(loop_steps):
    """What was asked for in step k acts on [k + forward, ...) and is in the sample of one later."""
    law = Noting()
    control = Control(law, form(TorqueParams(), Craft()), Attitude(), 0.5, loop_steps, ())
    for k in range(12):
        control.command(k, np.float64(0.0), np.True_)
    expected = [0.0]*(loop_steps + 1) + [1e-3*k for k in range(1, 12)]
    assert_allclose(law.told, expected[:12], atol=1e-9)


def test_an_abort_leaves_the_axis_to_coast():
    for place in ('ground', 'onboard'):
        batch = fly(scenario(law_runs=place), [0], record=True, schedule=[Change(20, abort=True)])
        assert np.all(batch.history[THRUST.name].command[22:] == 0.0)


# -- judge -----------------------------------------------------------------------------------

def judged(angle_deg, **shared):
    """Return the verdict on a track of true angles [deg], one for each step."""
    world = scenario(timeout_s=0.5*(len(angle_deg) - 1), **shared)
    judge = judge_of(world)
    for k, angle in enumerate(angle_deg):
        judge.follow(k, TRUTH(state=np.radians([angle, 0.0]), torque=np.array([0.2]),
                              final=np.bool_(k == len(angle_deg) - 1)))
    return judge.verdict()


def test_measures_of_a_track_drawn_by_hand():
    """Reference 0.5 up to 10 s, then zero; 61 steps to 30 s, the window is the last 10 s."""
    track = np.full(61, 0.5)
    track[0], track[3] = 0.0, 0.6                   # from below, 0.1 beyond
    track[20:30] = np.linspace(0.5, -0.2, 10)
    track[30:41] = 0.04
    track[41:] = np.where(np.arange(20) % 2, 0.01, -0.01)
    v = judged(track, attitude__step_at_s=10.0, faults__actuator_at_s=10.0,
               faults__sensor_at_s=10.0, limits__window_s=10.0)
    assert (v.success, v.reason, v.duration) == (True, 'held', 30.0)
    assert_allclose([v.values[n] for n in ('rms_final_deg', 'overshoot_deg', 'overshoot_first_deg',
                                           'peak_after_deg', 'settling_s')],
                    [0.01, 0.2, 0.1, 0.5, 5.0], rtol=1e-9)
    assert_allclose(v.values['rms_after_deg'], np.sqrt(np.mean(track[20:]**2)))
    assert_allclose(v.values['impulse_N_m_s'], 40*0.2*0.5)


def test_a_reference_that_is_zero_from_the_start_has_one_step_and_one_overshoot():
    track = np.concatenate([[0.4, 0.2, -0.1], np.zeros(58)])
    v = judged(track, attitude__step_at_s=0.0, attitude__reference_deg=0.0, limits__window_s=10.0)
    assert_allclose(v.values['overshoot_deg'], 0.1)
    assert np.isnan(v.values['overshoot_first_deg']) and v.values['settling_s'] == 1.5
    still = judged(track, attitude__step_at_s=10.0, attitude__reference_deg=0.0,
                   limits__window_s=10.0)
    assert np.isnan(still.values['overshoot_deg'])


def test_a_track_that_goes_out_of_bounds_is_lost_there():
    v = judged(np.concatenate([np.full(10, 0.5), [25.0], np.full(10, 0.5)]), limits__window_s=2.0)
    assert (v.success, v.reason, v.duration) == (False, 'lost', 5.0)
    assert np.isnan(v.values['rms_final_deg'])


def test_a_track_that_stays_off_is_restless_and_one_that_is_not_a_number_invalid():
    assert judged(np.full(61, 0.6), limits__window_s=10.0).reason == 'restless'
    assert judged(np.array([0.5, np.nan, 0.5, 0.5, 0.5]), limits__window_s=1.0).reason == 'invalid'


def test_plant_and_judge_agree_on_when_a_run_ends():
    """Behind a long delay the law, which makes no prediction, loses the axis."""
    batch = fly(scenario(law_runs='ground', forward_delay_s=10.0, back_delay_s=10.0,
                         limits__lost_deg=2.0), range(5))
    assert np.all(batch.verdict.reason == 'lost')
    assert_allclose(batch.verdict.duration, 0.5*batch.end_step)


# -- command form, display, bad input ------------------------------------------------------------

def test_a_torque_survives_the_way_there_and_back():
    made = form(TorqueParams(max_n_m=1.7, step_n_m=0.003), Craft(inertia_kg_m2=37.0))
    torques = made.quantise(np.linspace(-0.06, 0.06, 4001)[:, None])
    assert_array_equal(made.quantise(made.effect(torques)), torques)
    assert np.abs(torques).max() <= 1.7 and all(made.legal(t.tolist()) for t in torques)
    assert not made.legal([0.0001]) and not made.legal([1.8]) and not made.legal([float('nan')])
    assert_array_equal(made.quantise([[np.nan], [np.inf]]), [[0.0], [0.0]])
    with np.errstate(all='raise'):              # from the wire anything may come
        assert not made.legal([1e308]) and not made.legal([-1e308])


def test_the_console_shows_the_attitude_and_needles_that_turn_with_it():
    provider = display_of(load(ROOT / 'scenarios' / 'attitude.yaml'))
    as_data(provider.display)
    made = provider.derive({
        TELEMETRY.name: Sample(1, 0.5, True, {'state': [0.01, 0.0]}),
        LAW.name: Sample(1, 0.5, True, {'error': 0.0, 'reference': 0.0, 'inside': [0.0]*3})})
    assert_allclose(made['attitude'], [np.sin(0.005), 0.0, 0.0, np.cos(0.005)])
    assert_allclose(made['needle'][1], [0.0, 2.2*np.cos(0.4), 2.2*np.sin(0.4)])
    assert made['wanted'][1] == [0.0, 2.2, 0.0]
    assert provider.derive({}) == {'attitude': None, 'needle': None, 'wanted': None}


BAD = {
    'inertia': ({'craft.inertia_kg_m2': 0.0}, {}, 'craft.inertia_kg_m2 must be between 1e-06 and '
                '100000000, got 0.0'),
    'negative inertia': ({'craft.inertia_kg_m2': -3.0}, {}, 'craft.inertia_kg_m2 .* got -3.0'),
    'actuator of the wrong sign': ({'faults.actuator_gain': -1.0}, {},
                                   'faults.actuator_gain must be above 0.*got -1.0'),
    'dead sensor': ({'faults.sensor_gain': 0.0}, {}, 'faults.sensor_gain must be above 0.*got 0.0'),
    'fault before the start': ({'faults.actuator_at_s': -1.0}, {},
                               'faults.actuator_at_s must be between 0 and 86400, got -1.0'),
    'noise': ({}, {'attitude_sensors': {'gyro_sigma_deg': -0.1}},
              'attitude_sensors: gyro_sigma_deg must be between 0 and 90, got -0.1'),
    'weight': ({}, {'attitude_sensors': {'gyro_weight': 1.0}}, 'gyro_weight .* below 1, got 1.0'),
    'gain of the law': ({}, {'attitude_controller': {'pid.proportional_per_s2': -0.1}},
                        'pid.proportional_per_s2 must be between 0 and 10000, got -0.1'),
    'forgetting': ({}, {'attitude_controller': {'golden_section.forgetting': 1.5}},
                   'golden_section.forgetting must be between 0.5 and 1, got 1.5'),
    'law': ({}, {'attitude_controller': {'law': 'silver'}},
            'law must be one of golden_section, pid'),
    'torque step': ({'torque.step_n_m': 5.0}, {}, 'torque.step_n_m must be .* got 5.0'),
    'window': ({'limits.window_s': 400.0}, {}, 'limits.window_s must be at most timeout_s, 300'),
    'lost': ({'limits.lost_deg': 0.4}, {}, 'limits.lost_deg must be above the reference, 0.5'),
    'off the grid': ({'forward_delay_s': 0.7, 'law_runs': 'ground'}, {}, 'forward_delay_s.*0.7'),
    'nan': ({'faults.sensor_gain': float('nan')}, {}, 'faults.sensor_gain .* nan'),
    'place': ({'law_runs': 'moon'}, {}, 'law_runs must be one of ground, onboard|onboard, ground'),
}


@pytest.mark.parametrize('case', BAD)
def test_bad_input_is_one_line_that_names_key_value_and_bound(case):
    shared, sections, words = BAD[case]
    with pytest.raises(BadInput, match=words) as refused:
        Scenario('held', MISSION, {'/**': {'timeout_s': 300.0, **shared}, **sections}).check()
    assert '\n' not in str(refused.value)


def test_a_console_needs_a_law_on_the_ground():
    with pytest.raises(BadInput, match='law_runs must be ground for a console'):
        display_of(scenario(law_runs='onboard'))


# -- anything that a scenario may say ----------------------------------------------------------

@settings(max_examples=20, deadline=None)
@given(st.data())
def test_whatever_a_scenario_may_say_ends_with_one_of_the_reasons(data):
    """Odd steps, all faults at once, extreme gains and noise: no warning, no exception."""
    def draw(low, high):
        return float(np.clip(np.exp(data.draw(st.floats(np.log(low), np.log(high)))), low, high))

    step_s = data.draw(st.sampled_from([0.001, 0.05, 0.3, 0.7, 1.0, 3.7, 10.0]))
    law = data.draw(st.sampled_from(sorted(LAWS)))
    shared = {
        'step_s': step_s, 'timeout_s': 40.3*step_s, 'limits.window_s': draw(0.1, 40.0)*step_s,
        'law_runs': data.draw(st.sampled_from(['ground', 'onboard'])),
        'forward_delay_s': step_s*data.draw(st.integers(0, 4)),
        'back_delay_s': step_s*data.draw(st.integers(0, 4)),
        'faults.actuator_gain': draw(1e-9, 100.0), 'faults.sensor_gain': draw(1e-9, 100.0),
        'faults.actuator_at_s': data.draw(st.floats(0.0, 50.0))*step_s,
        'faults.sensor_at_s': data.draw(st.floats(0.0, 50.0))*step_s,
        'attitude.step_at_s': data.draw(st.floats(0.0, 50.0))*step_s,
        'attitude.reference_deg': data.draw(st.floats(-19.0, 19.0)),
        'craft.inertia_kg_m2': draw(1e-6, 1e8), 'torque.max_n_m': draw(0.1, 1e4),
        'torque.step_n_m': draw(1e-4, 0.1)}
    sections = {
        'attitude_dynamics': {'angle_deg': data.draw(st.floats(-30.0, 30.0)),
                              'disturbance_n_m': data.draw(st.floats(-1e6, 1e6))},
        'attitude_sensors': {'gyro_sigma_deg': draw(1e-6, 90.0),
                             'gyro_weight': data.draw(st.floats(0.0, 0.999))},
        'link_back': {'loss_fraction': data.draw(st.sampled_from([0.0, 0.5, 1.0]))},
        'attitude_controller': {'law': law}}
    world = Scenario('any', MISSION, {'/**': shared, **sections}).check()
    with np.errstate(all='raise', under='ignore'):
        batch = fly(world, range(3))
    assert set(batch.verdict.reason) <= {'held', 'restless', 'lost', 'invalid'}
    assert np.all(batch.verdict.duration <= world.run.last_step*step_s + 1e-9)
    for values in batch.verdict.values.values():
        assert not np.any(values < 0.0)
