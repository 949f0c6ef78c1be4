"""
The mission docking in process: whole flights, what ends them, what is refused.
"""

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_missions.docking import markers


def scenario(seconds, shared='', **sections):
    """Return a scenario of some length with further settings."""
    limits = '' if 'limits' in shared or seconds > 90 else ', limits: {from_s: 0.5}'
    text = ('/**: {ros__parameters: {mission: docking, step_s: 0.01, '
            f'timeout_s: {seconds}{limits}{", " + shared if shared else ""}}}}}\n')
    sections = {'onboard_guard': 'abort_burn_s: 2.0', **sections}
    for name, settings in sections.items():
        text += f'{name}: {{ros__parameters: {{{settings}}}}}\n'
    return parse(text, 'test')


TRUTH, ESTIMATE, GUIDANCE = '/truth/spacecraft', '/onboard/estimate', '/onboard/guidance'


def test_a_flight_begins_at_the_start_and_follows_the_profile():
    flown = fly(scenario(8.0), range(2), record=[TRUTH, ESTIMATE, GUIDANCE])
    truth, seen, guided = (flown.history[name] for name in (TRUTH, ESTIMATE, GUIDANCE))
    assert_allclose(truth.position[0], [[-6.0, 0.2, -0.15]]*2)
    assert np.isnan(seen.position[10]).all() and np.isfinite(seen.position[11:]).all()
    away = np.abs(seen.position[300:] - truth.position[300:])
    assert away.max() < 0.004
    assert np.abs(guided.reference[800] - truth.position[800]).max() < 0.06
    assert truth.propellant[-1, 0] > 0.0 and guided.safety.max() == 0
    assert not np.array_equal(truth.position[-1, 0], truth.position[-1, 1])


def test_a_row_of_a_batch_has_the_bits_of_the_run_alone():
    short = scenario(3.0)
    together = fly(short, [4, 7, 9], record=[TRUTH])
    alone = fly(short, [7], record=[TRUTH])
    for a, b in zip(alone.history[TRUTH], together.history[TRUTH]):
        assert np.array_equal(a[:, 0], b[:, 1])


def test_who_strays_did_so_when_the_first_limit_was_broken_and_not_at_the_end():
    verdict = fly(scenario(3.0), range(2)).verdict          # judged from 0.5 s on, still far away
    assert list(verdict.reason) == ['strayed']*2
    assert_allclose(verdict.happened, 0.51)
    assert_allclose(verdict.duration, 3.0)


def test_without_noise_and_thrust_nothing_but_gravity_moves_the_craft():
    """No camera, so no estimate: valves stay shut, and the craft drifts as on its orbit."""
    flown = fly(scenario(10.0, camera='image: {drop_out: 1.0}'), range(1), record=[TRUTH])
    truth = flown.history[TRUTH]
    assert truth.pulses[-1, 0] == 0 and np.abs(truth.felt).max() < 1e-8
    # z'' = 3 n^2 z: 1/2 3 n^2 z t^2
    fallen = truth.position[-1, 0, 2] + 0.15
    assert fallen == pytest.approx(-0.5*3*8.1478e-4**2*0.15*100.0, rel=0.01)


@pytest.mark.slow
@pytest.mark.patient
def test_pinhole_camera_and_all_loops_hover_within_all_limits():
    """Specification, section 10: band, time, attitude, lateral, propellant; nothing is fitted."""
    flown = fly(scenario(150.0), range(3))
    v = flown.verdict.values
    assert flown.verdict.success.all(), (flown.verdict.reason, v)
    assert np.all(v['settled_s'] < 80.0)
    assert np.all(np.abs(v['distance_nominal_m'] - 0.047) < 0.01)
    assert np.all(v['lateral_m'] < 0.035) and np.all(v['attitude_deg'] < 0.35)
    assert np.all((v['propellant_kg'] > 0.04) & (v['propellant_kg'] < 0.16))
    assert np.all(flown.columns['nav_error_m'] < 1e-3)
    assert np.all(flown.columns['safety_state'] == 0)


def test_a_camera_that_is_lost_makes_the_craft_hold():
    """From the start it has one view in a hundred: more than 2 s pass without a pose."""
    flown = fly(scenario(12.0, camera='image: {drop_out: 0.97}'), range(6))
    assert 1 in flown.columns['safety_state']
    assert flown.columns['safety_state'].max() <= 1


def test_a_thruster_of_j2_that_is_stuck_open_is_more_than_j3_can_hold():
    """20 N on an arm of 0.8 m are the 16 N m of J3: attitude is lost, and safety says so."""
    flown = fly(scenario(20.0, docking_dynamics='failed_thruster: 1, failure: stuck_on'), range(2))
    assert np.all(flown.verdict.values['propellant_kg'] > 20.0*19.0/(290*9.81))
    assert np.all(flown.columns['safety_state'] >= 1)


@pytest.mark.parametrize('way', ['nnls', 'programme'])
def test_other_allocations_fly_with_a_thruster_that_is_known_to_be_dead(way):
    flown = fly(scenario(12.0, docking_dynamics='failed_thruster: 1, failure: stuck_off',
                         docking_controller=f'allocation: {way}, failed: [1]'), range(1),
                record=[TRUTH, GUIDANCE])
    truth, guided = flown.history[TRUTH], flown.history[GUIDANCE]
    assert truth.thrust[:, 0, 1].max() == 0.0 and truth.thrust.max() > 0.5
    assert np.abs(guided.error[-1, 0, 3:]).max() < np.radians(0.6)
    assert guided.safety.max() == 0


@pytest.mark.parametrize('shared, sections, words', [
    ('chaser: {inertia_kg_m2: [-1.0, 3000.0, 2800.0]}', {}, 'positive, got -1 kg'),
    ('chaser: {inertia_kg_m2: [300.0, 400.0, 500.0]}', {}, 'positive definite'),
    ('start: {position_m: [-6.0, 5.0, 0.0]}', {}, 'at least 4 markers must be in view'),
    ('start: {position_m: [1.0, 0.0, 0.0]}', {}, 'begin with x < 0'),
    ('limits: {from_s: 400.0}', {}, 'from_s must be below timeout_s, 8, got 400'),
    ('limits: {from_s: 1.0, band_m: 0.08}', {}, 'band_m must be below aim.distance_m, 0.07'),
    ('seeing: {latency_s: 0.055}', {}, 'seeing.latency_s'),
    ('aim: {nominal_s: 40.0}', {}, r'profile: a way of 2.9\d* m cannot be gone in 39.89 s'),
    ('', {'docking_controller': 'position: {gain: 5.0}'}, 'position.gain: the dead band'),
    ('', {'docking_controller': 'attitude: {gain: 5.0}'}, 'attitude.gain: the dead band'),
    ('', {'docking_controller': 'failed: [11, 12]'}, 'cannot produce -force z alone'),
    ('', {'docking_dynamics': 'failed_thruster: 50, failure: weak'}, 'between 0 and 36, got 50'),
    ('', {'vision': 'small_below_m: 0.9'}, 'small_below_m must be below both_below_m')])
def test_what_cannot_be_flown_is_refused_in_one_line(shared, sections, words):
    with pytest.raises(BadInput, match=words) as refused:
        fly(scenario(8.0, shared, **sections), range(1))
    assert '\n' not in str(refused.value)


def test_markers_in_one_plane_are_refused_in_one_line(monkeypatch):
    monkeypatch.setattr(markers, 'BIG', markers.BIG*[0.0, 1.0, 1.0])
    with pytest.raises(BadInput, match='^markers: markers must not lie in one plane: .* got 0$'):
        fly(scenario(8.0), range(1))
