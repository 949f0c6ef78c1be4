"""Keep-out spheres: no contact from any feasible start, whoever flies and whatever is lost."""

import re

from hypothesis import given, Phase, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.levels import ThrustParams
from rvd_dynamics.geometry.keep_out import (
    beyond, room, SLACK_M, start_room, stop_of, StopParams, stopping, times)
from rvd_dynamics.geometry.obstacles import Closest
from rvd_dynamics.motion import cw
from rvd_groundstation.guidance.barrier import Barrier
from rvd_groundstation.guidance.corridor_apf import CorridorApf
from rvd_groundstation.guidance.damped_apf import DampedApf
from rvd_groundstation.guidance.keep_out import among, Map, uses_covariance
from rvd_groundstation.guidance.none import NoLaw
from rvd_groundstation.guidance.safe_approach import ApproachObstacles, SafeApproach
from rvd_groundstation.sharing import StickFilter

class Among(Paper):
    """The paper's approach, with laws that know a map."""

    def levels_among(self, law, state, stick, covariance):
        return self.form.quantise(law.wanted(state, stick, covariance))


PAPER = Among()
N = PAPER.orbit.mean_motion
ROWS = 100
# without shrinking: a failing field of 100 rows is as good as a small one, and found in a second
FIELDS = settings(deadline=None, max_examples=6, derandomize=True,
                  phases=(Phase.explicit, Phase.generate))
PILOTS = ('none', 'at it', 'forward', 'random')


def stop_for(paper=PAPER, **changes):
    return stop_of(StopParams(**changes), paper.form, N, paper.step_s, paper.leg_params.loop_s)


def fields(seed, rows=ROWS, spheres=3):
    """Return states (rows, 6), places (rows, M, 3) and radii: any approach, any map."""
    rng = np.random.default_rng(seed)
    state = np.column_stack([
        rng.uniform(-32.0, -6.0, rows), rng.uniform(-1.5, 1.5, (rows, 2)),
        rng.uniform(-0.1, 0.29, rows), rng.normal(0.0, 0.04, (rows, 2))])
    places = state[:, None, :3] + np.stack([
        rng.uniform(-3.0, 9.0, (rows, spheres)), *rng.normal(0.0, 0.7, (2, rows, spheres))], -1)
    return state, places, rng.uniform(0.05, 0.9, spheres)


def stick_of(pilot, state, places, radii, rng):
    """Return what a pilot does who means ill; None for nobody."""
    rows = len(state)
    if pilot == 'none':
        return None
    if pilot == 'random':
        return rng.integers(-3, 4, (rows, 3), dtype=np.int8)
    if pilot == 'forward':
        return np.broadcast_to(np.int8([3, 0, 0]), (rows, 3)).copy()
    away = places - state[:, None, :3]                      # full ahead at the nearest sphere
    nearest = (np.linalg.norm(away, axis=-1) - radii).argmin(axis=1)
    return (3*np.sign(away[np.arange(rows), nearest])).astype(np.int8)


def flown(law, places, radii, state, pilot, sigma, error, steps, seed, lost=0):
    """
    Fly in the ideal plant and return the least gap (rows,) [m].

    `error(k)` is what the prediction is wrong by, (rows, 6); `lost` commands in any loop delay do
    not arrive, those that brake hardest, and the ground learns of it a loop delay later.
    """
    rng, rows = np.random.default_rng(seed), len(state)
    phi, gamma = cw.transition(N, PAPER.step_s), cw.input_matrix(N, PAPER.step_s)
    covariance = np.broadcast_to(np.diag(np.square(sigma)), (rows, 6, 6))
    closest, least = Closest(radii), np.full(rows, np.inf)
    loop = PAPER.legs.loop
    drops = [np.zeros((rows, 6))]*loop                      # effect of each command not arrived
    dropped = np.zeros((loop, rows), dtype=bool)
    for k in range(steps):
        np.minimum(least, closest.follow(state, places), out=least)
        predicted = state + sum(drops) + error(k)
        levels = PAPER.levels_among(law, predicted, stick_of(pilot, state, places, radii, rng),
                                    covariance)
        accel = PAPER.form.effect(levels)
        lose = np.zeros(rows, dtype=bool)
        if lost:
            brakes = (levels[:, 0] < 0) | (np.abs(levels[:, 1:]).max(axis=1) > 0)
            lose = brakes & (dropped.sum(axis=0) < lost) & (rng.random(rows) < 0.5)
        arrived = np.where(lose[:, None], 0.0, accel)
        drops = [cw.product(phi, d) for d in drops[1:]] + [cw.product(gamma, accel - arrived)]
        dropped = np.concatenate([dropped[1:], lose[None]])
        state = cw.step(state, arrived, phi, gamma)
    return np.minimum(least, closest.follow(state, places))


def barrier(places, radii, stop, **changes):
    return among(PAPER.law(Barrier, sharing=StickFilter(), **changes), Map(places, radii, stop))


def feasible(seed, stop, sigma, shift=None, rows=ROWS):
    """Return those of random fields from which a stop keeps out of all bodies."""
    state, places, radii = fields(seed, rows)
    seen = state if shift is None else state + shift
    box = stop.box(np.repeat(np.asarray(sigma)[:, None], rows, 1), seen[:, 3:].T)
    free = room(seen.T, np.moveaxis(places, 0, -1), radii, box, stop) >= 0.0
    free &= ((np.linalg.norm(state[:, None, :3] - places, axis=-1) - radii) > 0.0).all(axis=1)
    return state[free], places[free], radii


# -- no contact ------------------------------------------------------------------------------------

@FIELDS
@given(st.integers(0, 2**32 - 1), st.sampled_from(PILOTS), st.sampled_from([0.0, 0.05]))
def test_nobody_flies_into_a_sphere_from_any_start_that_leaves_room(seed, pilot, around):
    stop = stop_for(lost_commands=0)
    state, places, radii = feasible(seed, stop, [0.0]*6)
    law = barrier(places, radii, stop, around_m_s=around)
    least = flown(law, places, radii, state, pilot, [0.0]*6, lambda k: 0.0, 160, seed)
    assert len(state) > 20 and least.min() > 0.0


@FIELDS
@given(st.integers(0, 2**32 - 1), st.sampled_from(PILOTS), st.sampled_from(['steady', 'jumping']))
def test_nor_where_the_prediction_is_wrong_by_all_that_is_allowed_for(seed, pilot, kind):
    """Four sigma on each axis in any direction: for good, or another one every loop delay."""
    stop, sigma = stop_for(lost_commands=0), np.array([0.06, 0.01, 0.01, 5e-4, 2e-4, 2e-4])
    rng = np.random.default_rng(seed + 1)
    corners = np.sign(rng.normal(size=(13, ROWS, 6))) * 4.0 * sigma
    corners[..., 3:] *= 0.0 if kind == 'jumping' else 1.0
    state, places, radii = fields(seed)
    box = stop.box(np.repeat(2.0*sigma[:, None], ROWS, 1), state[:, 3:].T)
    free = room(state.T, np.moveaxis(places, 0, -1), radii, box, stop) >= 0.0
    state, places, corners = state[free], places[free], corners[:, free]
    law = barrier(places, radii, stop)
    # a correction comes over many samples: the error goes from corner to corner in a loop delay
    def error(k):
        i, share = divmod(k, 20)
        share = share/20 if kind == 'jumping' else 0.0
        i = i if kind == 'jumping' else 0
        return (1.0 - share)*corners[i] + share*corners[i + 1]
    least = flown(law, places, radii, state, pilot, sigma, error, 160, seed)
    assert len(state) > 10 and least.min() > 0.0


@FIELDS
@given(st.integers(0, 2**32 - 1), st.sampled_from(PILOTS))
def test_nor_where_a_command_of_each_loop_delay_is_lost_the_one_that_brakes(seed, pilot):
    lost = 1
    stop = stop_for(lost_commands=lost)
    state, places, radii = feasible(seed, stop, [0.0]*6)
    law = barrier(places, radii, stop)
    least = flown(law, places, radii, state, pilot, [0.0]*6, lambda k: 0.0, 160, seed, lost)
    assert len(state) > 10 and least.min() > 0.0


def test_without_the_map_the_same_barrier_does(seed=3):
    """The fields and the pilot are such that it matters: the same barrier without the map."""
    stop = stop_for(lost_commands=0)
    state, places, radii = feasible(seed, stop, [0.0]*6)
    nowhere = np.full_like(places, 1e6)
    least = flown(barrier(nowhere, radii, stop), places, radii, state, 'at it', [0.0]*6,
                  lambda k: 0.0, 160, seed)
    assert (least <= 0.0).mean() > 0.2


# -- what a stop is --------------------------------------------------------------------------------

def test_a_stop_is_a_braking_to_rest_on_each_axis():
    """Against small steps of Newton's law."""
    for v, a in ((0.25, 0.0185), (-0.07, 0.009), (0.0, 0.01)):
        at = np.linspace(0.0, 20.0, 41)
        p, rate, path, dt = 1.0, v, [1.0], 1e-3
        for i in range(20_000):
            rate_next = rate - np.sign(v)*a*dt if abs(rate) > a*dt else 0.0
            p += 0.5*(rate + rate_next)*dt
            rate = rate_next
            if (i + 1) % 500 == 0:
                path.append(p)
        assert_allclose(stopping(1.0, v, a, at), path, atol=2e-5)


def test_samples_of_a_stop_miss_less_than_the_slack():
    """A sphere passed as closely as it can be: 24 samples against 5,000 of the same path."""
    stop, rng = stop_for(), np.random.default_rng(2)
    state = np.column_stack([np.zeros((2000, 3)), rng.uniform(-0.3, 0.3, 2000),
                             rng.uniform(-0.06, 0.06, (2000, 2))]).T
    places = rng.uniform(-1.5, 1.5, (1, 3, 2000))*[[[1.5], [0.3], [0.3]]]
    radii, box = np.array([0.3]), np.zeros((3, 2000))
    fine = np.linspace(0.0, 1.0, 5000)[:, None] * times(state[3:], stop.decelerations)[-1]
    square = sum(beyond(stopping(state[i], state[3 + i], stop.decelerations[i], fine),
                        places[0, i], 0.0) for i in range(3))
    exact = np.sqrt(square.min(axis=0)) - 0.3
    near = (exact > 0.0) & (exact < 0.5)
    found = room(state, places, radii, box, stop)
    assert near.sum() > 100
    assert np.all(found[near] <= exact[near] + 1e-12)
    assert np.all(found[near] >= exact[near] - SLACK_M)


def test_a_body_holds_every_place_that_the_box_allows():
    """Random true places within the box about a prediction: outside the body, none touches."""
    rng = np.random.default_rng(4)
    box, r = np.array([0.4, 0.1, 0.05]), 0.3
    predicted = rng.uniform(-1.0, 1.0, (400, 3))
    gap = np.sqrt(sum(beyond(predicted[:, i], 0.0, box[i]) for i in range(3))) - r
    true = predicted[:, None] + rng.uniform(-1.0, 1.0, (400, 500, 3))*box
    least = np.linalg.norm(true, axis=-1).min(axis=1) - r
    assert np.all(least[gap > 0.0] > 0.0)
    corner = np.abs(predicted) - np.minimum(np.abs(predicted), box)     # the nearest it allows
    assert_allclose(np.linalg.norm(corner, axis=1) - r, gap, atol=1e-12)


def test_how_a_paper_chaser_stops():
    stop = stop_for()
    assert_allclose(stop.decelerations, [0.02*0.95 - 2*N*0.3, *[0.01*0.95 - 2*N*0.3]*2])
    still = stop.box(np.zeros((6, 1)), np.zeros((3, 1)))[:, 0]
    lost = np.array([0.03, 0.02, 0.02])*0.5
    assert_allclose(still, lost*11.0 + lost**2/(2*stop.decelerations))
    moving = stop_for(lost_commands=0).box(np.array([[0.05, 0.004, 0.004, 1e-3, 0.0, 0.0]]).T,
                                           np.array([[-0.25, 0.1, 0.0]]).T)[:, 0]
    assert_allclose(moving, [4*(0.05 + 1e-3*0.25/stop.decelerations[0]), 0.016, 0.016])


# -- which starts are feasible ---------------------------------------------------------------------

def test_a_start_straight_at_a_sphere_has_the_room_that_the_equations_of_motion_leave():
    stop, x, v = stop_for(lost_commands=0), -30.0, 0.25
    state = np.array([x, 0.0, 0.0, v, 0.0, 0.0])
    coast = cw.propagate(state, N, 10.0)
    way = coast[3]**2/(2*stop.decelerations[0])
    for centre in (-22.0, -24.5, -25.5):
        found = start_room(state, np.array([[centre, 0.0, 0.0]]), np.array([0.4]), stop, N, 0.5)
        expected = centre - coast[0] - way - 2*1.0 - 0.4 - SLACK_M
        assert found == pytest.approx(expected if expected > 0 else found, abs=2e-3)
        assert (found >= 0.0) == (expected >= 0.0)


def test_a_start_that_coasts_into_a_sphere_before_a_command_can_act_is_not_feasible():
    state, stop = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0]), stop_for()
    found = start_room(state, np.array([[-28.5, 0.3, 0.0]]), np.array([0.4]), stop, N, 0.5)
    assert found < 0.0


@pytest.mark.parametrize('batch', [(), (1,), (7,), (4, 3)])
def test_room_of_a_start_is_the_same_alone_and_in_a_batch(batch):
    state, places, radii = fields(5, 12)
    rows, stop = int(np.prod(batch, dtype=int)), stop_for()
    whole = start_room(state[:rows].reshape(*batch, 6), places[:rows].reshape(*batch, 3, 3), radii,
                       stop, N, 0.5)
    alone = [start_room(s, p, radii, stop, N, 0.5) for s, p in zip(state[:rows], places)]
    assert_array_equal(np.reshape(whole, -1), alone)


# -- the laws as laws ------------------------------------------------------------------------------

@pytest.mark.parametrize('kind', [Barrier, CorridorApf, DampedApf, SafeApproach])
def test_rows_among_obstacles_are_equal_to_single_calls_bit_for_bit(kind):
    state, places, radii = fields(8, 60)
    law = PAPER.law(kind, **({'sharing': StickFilter()} if kind is Barrier else {}))
    rng = np.random.default_rng(9)
    stick = rng.integers(-3, 4, (60, 3), dtype=np.int8)
    covariance = np.abs(rng.normal(size=(60, 6, 6)))*1e-3
    extra = (covariance,) if uses_covariance(law) else ()
    whole = among(law, Map(places, radii, stop_for())).wanted(state, stick, *extra)
    for i in range(60):
        one = among(law, Map(places[i], radii, stop_for()))
        alone = one.wanted(state[i], stick[i], *(each[i] for each in extra))
        assert whole[i].tobytes() == alone.tobytes()


def test_an_unknown_state_is_level_zero_and_disturbs_no_other_row():
    state, places, radii = fields(8, 30)
    law = barrier(places, radii, stop_for())
    covariance = np.broadcast_to(1e-4*np.eye(6), (30, 6, 6))
    clean = PAPER.levels_among(law, state, None, covariance)
    state[3, 2] = np.nan
    got = PAPER.levels_among(law, state, None, covariance)
    assert_array_equal(got[3], 0)
    assert_array_equal(np.delete(got, 3, axis=0), np.delete(clean, 3, axis=0))


def test_far_from_obstacles_the_barrier_is_the_barrier():
    state, places, radii = fields(10, 500)
    law = PAPER.law(Barrier, sharing=StickFilter())
    stick = np.random.default_rng(1).integers(-3, 4, (500, 3), dtype=np.int8)
    far = among(law, Map(places + 1000.0, radii, stop_for()))
    assert_array_equal(PAPER.levels_among(far, state, stick, np.zeros((500, 6, 6))),
                       PAPER.levels(law, state, stick))


def test_the_field_of_a_sphere_is_that_of_the_wall_at_the_same_distance():
    """Eq. 11 with D and the speed towards it, along the line to the centre."""
    law = PAPER.law(DampedApf)
    place, r = np.array([-10.0, 0.0, 0.0]), 0.4
    state = np.array([-11.0, 0.0, 0.0, 0.25, 0.03, 0.0])            # 0.6 m in front of it
    assert_allclose(law.from_sphere(state, place, r),
                    [-(2e-4/0.36 + 5e-3 + 0.2*0.25), 0.0, 0.0], atol=1e-15)
    assert_array_equal(law.from_sphere(state - [1.0, 0, 0, 0, 0, 0], place, r), 0.0)
    total = among(law, Map(place[None], np.array([r]), stop_for())).wanted(state, None)
    assert_allclose(total, law.wanted(state, None) + law.from_sphere(state, place, r))


def approach(**obstacles):
    return PAPER.law(SafeApproach, obstacles=ApproachObstacles(**obstacles))


def test_safe_apf_adds_its_repulsion_while_the_zone_is_entered_and_no_longer():
    law, r = approach(), np.array([0.4])
    place = np.array([[-10.0, 0.0, 0.0]])
    among_one = among(law, Map(place, r, stop_for()))
    zone = 1.8*(0.4 + 0.25**2/(2*0.02))                             # d_0 (L_o + D_stop)
    sigma = (0.4 + zone)/3.0
    for distance in (3.0, zone - 0.01, zone + 0.01, 6.0):
        state = np.array([-10.0 - distance, 0.0, 0.0, 0.25, 0.0, 0.0])
        push = 0.4/sigma**2*distance*np.exp(-0.5*(distance/sigma)**2)*(distance < zone)
        assert_allclose(among_one.wanted(state, None) - law.wanted(state, None),
                        [-push/0.666, 0.0, 0.0], atol=1e-12)


def test_by_probability_it_asks_for_the_covariance_and_alarms_where_the_sphere_is_likely():
    law, sharp, blunt = approach(alarm='probability'), np.eye(6)*1e-4, np.eye(6)
    assert uses_covariance(law) and not uses_covariance(approach())
    known = Map(np.array([[-10.0, 0.0, 0.0]]), np.array([0.4]), stop_for())
    state = np.array([-12.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    plain = law.wanted(state, None)
    assert_array_equal(among(law, known).wanted(state, None, sharp), plain)
    assert among(law, known).wanted(state, None, blunt)[0] < plain[0]


def test_a_law_without_a_term_for_obstacles_is_left_as_it_is():
    law = PAPER.law(NoLaw)
    assert among(law, Map(np.zeros((1, 3)), np.array([1.0]), stop_for())) is law


@pytest.mark.parametrize('key, bad, said', [
    ('brake_level', 0, 'brake_level must be between 1 and 3, got 0'),
    ('error_sigmas', -1.0, 'error_sigmas must be between 0 and 10, got -1.0'),
    ('lost_commands', -1, 'lost_commands must be between 0 and 20, got -1'),
    ('first_error_m', (1.0, -0.1, 0.1), 'first_error_m[1] must be between 0 and 100, got -0.1')])
def test_impossible_settings_are_refused_by_name(key, bad, said):
    with pytest.raises(BadInput, match=f'^{re.escape(said)}$'):
        StopParams(**{key: bad})


def test_a_brake_weaker_than_the_orbit_is_refused():
    weak = Paper(thrust=ThrustParams(lateral_m_s2=(1e-4, 4e-4, 0.02)))
    with pytest.raises(BadInput, match='brake_level must give more than 0.000518 m/s.2, what the '):
        stop_for(weak)
