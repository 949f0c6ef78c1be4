"""The potential field with alarms: its equations checked by gradients, limits and invariance."""

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from scipy.spatial.transform import Rotation

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.speed_corridor import SpeedCorridor
from rvd_groundstation.guidance.safe_apf import SafeApf

CONTACT, REACH = 2.0, np.array([1.6])           # [m] L, L_o
FREE = SafeApf(run=Run(step_s=1.0), speed_corridor=SpeedCorridor(), contact_m=CONTACT)
LATE = 1e9
SURE = np.eye(3)[None] * 0.01                   # [m^2] covariance (1, 3, 3)


def with_corridor(form='linear', **changed):
    return replace(FREE, speed_corridor=SpeedCorridor(form=form, **changed))


def at(*position, velocity=(0.0, 0.0, 0.0)):
    return np.array([*position, *velocity], dtype=float)


def speed_at(law, r):
    return np.linalg.norm(law.approach(at(r, 0, 0), LATE), axis=0)


def standing(*position):
    return np.array([[*position, 0.0, 0.0, 0.0]])


def push(law, state, obstacles, on=True):
    met = law.encounter(state, obstacles, REACH)
    return np.array(law.repulsion(met, np.full(met.distance.shape, on)))


def test_attraction_heads_for_the_target_with_the_speed_of_equation_4():
    place = np.array([50.0, -10.0, -25.0])
    r = np.linalg.norm(place)
    assert_allclose(FREE.approach(at(*place), LATE), -place/r * (1 - np.exp(-0.0045*r)), rtol=1e-14)
    assert_allclose(FREE.approach(at(*place), 2.0), -place/r * (1 - np.exp(-0.0045*r))
                    * (1 - np.exp(-2.0)), rtol=1e-14)
    assert_array_equal(FREE.approach(at(*place), 0.0), np.zeros(3))     # starts softly
    assert_allclose(speed_at(FREE, 1e-3), 0.0045e-3, rtol=1e-5)         # exponential arrival
    assert_allclose(speed_at(FREE, 1e5), 1.0, rtol=1e-12)


def test_at_rest_the_obstacles_surface_is_a_little_more_than_one_sigma_away():
    met = FREE.encounter(at(10, 0, 0), standing(5, 0, 0), REACH)
    assert REACH[0] / ((REACH[0] + met.zone[0]) / 3.0) == pytest.approx(1.0714, abs=1e-4)


@pytest.mark.parametrize('zone', ['product', 'sum'])
def test_repulsion_is_the_gradient_of_a_gaussian(zone):
    law = replace(FREE, zone=zone)
    state, obstacles = at(3.0, 1.0, -0.7), standing(1.2, 0.4, 0.3)

    def potential(position):
        met = law.encounter(at(*position), obstacles, REACH)
        sigma = (REACH[0] + met.zone[0]) / 3.0
        return law.repulsion_m2_s * np.exp(-0.5 * (met.distance[0] / sigma)**2)

    step = 1e-5
    slope = [(potential(state[:3] + step*e) - potential(state[:3] - step*e)) / (2*step)
             for e in np.eye(3)]
    assert_allclose(push(law, state, obstacles), -np.array(slope), rtol=1e-8)


def test_repulsion_is_largest_one_sigma_away():
    sigma = (1.6 + 1.8*1.6) / 3.0
    near = [np.linalg.norm(push(FREE, at(d, 0, 0), standing(0, 0, 0)))
            for d in sigma * np.array([0.9, 1.0, 1.1])]
    assert max(near) == near[1] == pytest.approx(0.4/sigma * np.exp(-0.5), rel=1e-12)


def test_braking_zone_grows_with_the_square_of_the_relative_speed():
    drifting = standing(5, 0, 0) + [0, 0, 0, 0.0, 0.05, 0.0]
    state = at(10, 0, 0, velocity=(0.1, 0.05, 0.0))
    stop = 0.1**2 / 0.02                        # only the relative velocity counts
    assert_allclose(FREE.encounter(state, drifting, REACH).zone, 1.8 * (1.6 + stop))
    added = replace(FREE, zone='sum', zone_margin_m=1.28)
    assert_allclose(added.encounter(state, drifting, REACH).zone, 1.28 + 1.6 + stop)
    closing = replace(FREE, braking_speed='closing')
    assert_allclose(closing.encounter(state, drifting, REACH).zone, 1.8 * 1.6)  # it recedes
    coming = at(10, 0, 0, velocity=(-0.1, 0.0, 0.2))
    assert_allclose(closing.encounter(coming, drifting, REACH).zone, 1.8 * (1.6 + stop))


def alarms(law, distances, covariance=SURE, before=False):
    found = []
    for d in distances:
        met = law.encounter(at(d, 0, 0), standing(0, 0, 0), REACH)
        found.append(bool(law.alarmed(met, covariance, np.array([before]))[0][0]))
    return found


def test_alarm_by_distance_and_its_hysteresis():
    law = replace(FREE, alarm='distance')
    zone = 1.8 * 1.6
    assert alarms(law, [zone*0.99, zone*1.01]) == [True, False]
    kept = replace(law, release_distance_factor=1.2)
    assert alarms(kept, [zone*1.1, zone*1.3], before=True) == [True, False]
    assert alarms(kept, [zone*1.1, zone*0.9]) == [False, True]


@pytest.mark.parametrize('covariance', ['sphere', 'general'])
def test_alarm_by_probability_and_its_hysteresis(covariance):
    law = replace(FREE, covariance=covariance, alarm_probability=1e-4)
    # sigma 0.1 m: about 1e-4 at 1.6 + 0.36 m, 1e-6 at 1.6 + 0.46 m
    assert alarms(law, [1.90, 2.06, 2.5]) == [True, False, False]
    kept = replace(law, release_probability_factor=1e-3)
    assert alarms(kept, [2.06, 2.5], before=True) == [True, False]
    assert alarms(kept, [2.06, 1.9]) == [False, True]
    assert alarms(replace(FREE, alarm='none'), [0.1]) == [False]


def test_general_alarm_sees_along_which_axis_the_position_is_uncertain():
    law = replace(FREE, covariance='general')
    along, across = np.diag([1.0, 0.01, 0.01])[None], np.diag([0.01, 1.0, 0.01])[None]
    assert alarms(law, [4.0], along) == [True] and alarms(law, [4.0], across) == [False]
    sphere = replace(FREE, covariance='sphere')
    assert alarms(sphere, [4.0], along) == alarms(sphere, [4.0], across)


def test_speed_corridor_bounds_the_approach_and_stops_it_at_contact():
    law = with_corridor()
    r = np.linspace(CONTACT, 60.0, 4000)
    speed = np.array([speed_at(law, d) for d in r])
    assert np.all(speed <= 5e-4 + 0.005*(r - CONTACT) + 1e-15)
    assert speed[0] == 0.0 and np.all(speed[1:] > 0.0)
    wide = with_corridor(slope_per_s=10.0)      # no limit: k_s alone, 0.8 /m far out
    assert_allclose(speed_at(wide, 3.0), (1 - np.exp(-0.0135))
                    * (1 - np.exp(-0.8*(1 - np.exp(-2.5)))), rtol=1e-12)
    assert_allclose(speed_at(wide, 50.0), speed_at(FREE, 50.0), rtol=1e-12)


def test_parabola_is_braking_at_a_constant_rate():
    law = with_corridor('parabola', braking_share=0.004)
    gap = np.array([0.5, 5.0, 30.0])
    speed = np.array([speed_at(law, CONTACT + g) for g in gap])
    limit = 5e-4 + np.sqrt(2 * 0.004 * 0.01 * gap)
    assert np.all(speed <= limit * (1 + 1e-12))
    assert speed[2] == pytest.approx(limit[2], rel=1e-12)


def test_empirical_repulsion_acts_within_its_range_alone():
    law = replace(FREE, target_repulsion='empirical')
    assert_allclose(speed_at(law, 3.0), speed_at(FREE, 3.0) * (1 - np.exp(-0.5)), rtol=1e-12)
    assert speed_at(law, 4.01) == speed_at(FREE, 4.01)
    assert speed_at(replace(law, target_rate_per_m=0.0), 3.0) == 0.0


def test_wanted_velocity_is_reached_in_one_step():
    law, state = with_corridor(), at(20.0, -4.0, 3.0, velocity=(0.3, 0.2, -0.1))
    assert_allclose(state[3:] + law.wanted(state) * 1.0, np.array(law.approach(state, LATE)),
                    rtol=1e-12)
    half = replace(law, run=Run(step_s=0.5))
    assert_allclose(half.wanted(state), 2.0 * law.wanted(state), rtol=1e-14)


@given(st.integers(0, 10_000))
@settings(max_examples=40, deadline=None)
def test_a_rotation_of_everything_rotates_what_is_wanted(seed):
    rng = np.random.default_rng(seed)
    turn = Rotation.random(random_state=seed).as_matrix()

    def turned(states):
        return np.concatenate([states[..., :3] @ turn.T, states[..., 3:] @ turn.T], axis=-1)

    state = np.concatenate([rng.normal(size=3)*5, rng.normal(size=3)*0.2])
    obstacles = np.concatenate([rng.normal(size=(2, 3))*3, rng.normal(size=(2, 3))*0.05], axis=1)

    def wish(state, obstacles):
        met = FREE.encounter(state, obstacles, np.array([1.6, 1.1]))
        return FREE.acceleration(state, 3.0, FREE.repulsion(met, np.array([True, True])))

    assert_allclose(wish(turned(state), turned(obstacles)), turn @ wish(state, obstacles),
                    rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize('law', [
    FREE, with_corridor(), with_corridor('parabola'), replace(FREE, alarm='distance'),
    replace(FREE, covariance='general'), replace(FREE, target_repulsion='empirical')])
def test_a_row_of_a_batch_is_the_single_call_to_the_bit(law):
    rng = np.random.default_rng(3)
    states = np.concatenate([rng.normal(size=(300, 3))*4, rng.normal(size=(300, 3))*0.2], axis=1)
    obstacles = np.concatenate([rng.normal(size=(3, 3))*4, rng.normal(size=(3, 3))*0.02], axis=1)
    reach = np.array([1.6, 1.1, 2.0])
    covariance = np.broadcast_to(np.diag([0.09, 0.01, 0.04]), (3, 3, 3))

    def wish(state, before):
        met = law.encounter(state, obstacles, reach)
        on, _ = law.alarmed(met, covariance, before)
        pushes = law.repulsion(met, on)
        return law.acceleration(state, 7.0, pushes if len(pushes) else np.zeros(3)), on

    whole, on = wish(states, np.zeros((300, 3), dtype=bool))
    assert 0 < on.sum() < on.size
    for layout in (states, np.asfortranarray(states)):
        assert_array_equal(wish(layout, np.zeros((300, 3), dtype=bool))[0], whole)
    for row, state, alarm in zip(whole, states, on):
        alone, one = wish(state, np.zeros(3, dtype=bool))
        assert_array_equal(alone, row)
        assert_array_equal(one, alarm)


@pytest.mark.parametrize('setting', [
    'attraction', 'max_speed_m_s', 'slowing_per_m', 'repulsion_m2_s', 'zone_factor',
    'braking_m_s2', 'target_rate_per_m', 'alarm_probability'])
def test_a_gain_of_the_wrong_sign_is_refused_with_its_name_and_value(setting):
    with pytest.raises(BadInput, match=f'{setting} must .*, got -0.5'):
        SafeApf(**{setting: -0.5})


def test_a_range_of_repulsion_within_contact_is_refused():
    with pytest.raises(BadInput, match='target_range_m must be above the distance at contact, 2'):
        replace(FREE, target_repulsion='empirical', target_range_m=1.5)
