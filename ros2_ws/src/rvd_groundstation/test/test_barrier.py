"""Predictive barrier: against its text in plain Python, against physics, inside a blend."""

from decimal import Decimal
from math import copysign, inf, pi, sqrt, tan
import re

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.geometry.cone import Cone, radius, signed_distance
from rvd_dynamics.motion import cw
from rvd_dynamics.commands.levels import acceleration, ThrustParams
from rvd_groundstation.guidance.barrier import Barrier, VIOLATION_WEIGHT
from rvd_groundstation.sharing import decide, Eq25, StickFilter

PAPER = Paper()
LATERAL = [-0.02, -0.01, -0.005, 0.0, 0.005, 0.01, 0.02]       # Table 2
ALONG = [-0.03, -0.02, -0.01, 0.0, 0.01, 0.02, 0.03]
OMEGA = 8.2071e-4               # [rad/s] to the five digits of the paper
WIDE = Paper(cone=Cone(half_angle_deg=6.0, docking_radius_m=0.2),
               thrust=ThrustParams(lateral_m_s2=(0.008, 0.02, 0.03)))
SLIM = Paper(cone=Cone(half_angle_deg=2.0, docking_radius_m=0.5), step_s=0.25,
               thrust=ThrustParams(lateral_m_s2=(0.004, 0.006, 0.015)))


def states(rows, seed=0, paper=PAPER, fill=1.2):
    rng = np.random.default_rng(seed)
    x = rng.uniform(-32.0, 0.5, rows)
    angle, rho = rng.uniform(0, 2*pi, rows), radius(x, paper.cone)*rng.uniform(0, fill, rows)
    return np.column_stack([x, rho*np.cos(angle), rho*np.sin(angle),
                            rng.uniform(0.12, 0.31, rows), rng.normal(0, 0.03, (rows, 2))])


def sticks(rows, seed=0):
    return np.random.default_rng(seed).integers(-3, 4, (rows, 3), dtype=np.int8)


# The text of the law, number by number, for the paper's approach.

def violation(x, rate, p, v, a, g, dt=0.5):
    closing = max(rate, 0.05)
    t_go = max(-x/closing, 0.0)
    p1, v1 = p + v*dt + (a + g)*dt**2/2, v + (a + g)*dt
    worst = 0.0
    for coast in (0.0, 8.0):
        t = min(coast, max(t_go - dt, 0.0))
        p2, v2 = p1 + v1*t + g*t**2/2, v1 + g*t
        t_b = min(abs(v2)/0.005, max(t_go - dt - t, 0.0))
        p3 = p2 + v2*t_b - copysign(0.005*t_b**2/2, v2)
        station = min(x + closing*(dt + t + t_b), 0.0)
        worst = max(worst, abs(p3) - 0.75*(0.3 - station*tan(3*pi/180))/sqrt(2))
    return worst


def lateral_costs(x, rate, p, v, pilot, g):
    return [1000*violation(x, rate, p, v, a, g) + abs(a - LATERAL[pilot + 3]) + 1e-4*abs(a)
            for a in LATERAL]


def along(rate, pilot):
    if rate > 0.285:
        return -1
    if rate < 0.15:
        return 1
    after = rate + ALONG[pilot + 3]*0.5
    leaves = (after <= 0.18 and pilot < 0) or (after >= 0.28 and pilot > 0)
    return 0 if leaves else pilot


def test_wants_what_the_text_says():
    state, stick = states(4000, 1), sticks(4000, 2)
    state[:800, 3] -= 0.2                                   # some stand still or go back
    wanted = PAPER.law(Barrier).outcome(state, stick)
    acted = 0
    for (x, y, z, rate, vy, vz), pilot, got in zip(state.tolist(), stick.tolist(),
                                                   wanted.tolist()):
        assert got[0] == along(rate, pilot[0])
        for p, v, man, level, g in ((y, vy, pilot[1], got[1], 2*OMEGA*rate),
                                    (z, vz, pilot[2], got[2], 0.0)):
            costs = lateral_costs(x, rate, p, v, man, g)
            assert costs[level + 3] <= min(costs) + 1e-6    # OMEGA is rounded
            acted += level != man
    assert 1000 < acted < 7000                              # both answers are well tried


# Physics

@pytest.mark.parametrize('paper', [PAPER, WIDE, SLIM], ids=['paper', 'wide', 'slim'])
def test_no_other_level_violates_less(paper):
    law, state, stick = paper.law(Barrier), states(3000, 3, paper), sticks(3000, 4)
    violates = law.violation(np.ascontiguousarray(state.T))
    wanted = law.outcome(state, stick).T[1:]
    chosen = np.take_along_axis(violates, wanted[None] + 3, axis=0)[0]
    dearest = 2.0*paper.thrust.lateral_m_s2[-1]             # what obedience can be worth
    assert np.all(chosen <= violates.min(axis=0) + 1.01*dearest/VIOLATION_WEIGHT)


def test_pilot_is_left_alone_where_his_level_violates_nothing():
    law, state, stick = PAPER.law(Barrier), states(3000, 5, fill=0.5), sticks(3000, 6)
    violates = law.violation(np.ascontiguousarray(state.T))
    free = np.take_along_axis(violates, stick.T[None, 1:] + 3, axis=0)[0] <= 0.0
    assert 0.3 < free.mean() < 0.99
    assert_array_equal(law.outcome(state, stick).T[1:][free], stick.T[1:][free])


@pytest.mark.parametrize('axis', [1, 2])
def test_without_coupling_a_mirror_image_gets_the_mirror_image(axis):
    law, state, stick = PAPER.law(Barrier, coupling='none'), states(3000, 7), sticks(3000, 8)
    image, image_stick = state.copy(), stick.copy()
    image[:, [axis, axis + 3]] *= -1
    image_stick[:, axis] *= -1
    expected = law.outcome(state, stick)
    expected[:, axis] *= -1
    assert_array_equal(law.outcome(image, image_stick), expected)


def test_without_coupling_y_and_z_are_alike():
    law, state, stick = PAPER.law(Barrier, coupling='none'), states(3000, 9), sticks(3000, 10)
    swap, swap_sticks = [0, 2, 1, 3, 5, 4], [0, 2, 1]
    assert_array_equal(law.outcome(state[:, swap], stick[:, swap_sticks]),
                       law.outcome(state, stick)[:, swap_sticks])


def test_the_coriolis_push_is_met_early():
    """2 omega x' pushes outwards on +y only: rest just inside the bound is not safe there."""
    station, x = np.zeros((400, 6)), -15.0
    bound = 0.75*float(radius(x, PAPER.cone))/sqrt(2)
    station[:, 0], station[:, 3] = x, 0.25
    station[:, 1] = np.linspace(0.7, 1.0, 400)*bound
    above = PAPER.law(Barrier).outcome(station, np.zeros((400, 3), dtype=np.int8))[:, 1]
    station[:, 1] *= -1
    below = PAPER.law(Barrier).outcome(station, np.zeros((400, 3), dtype=np.int8))[:, 1]
    assert np.argmax(above < 0) < np.argmax(below > 0)


def test_coupling_all_is_the_free_acceleration_of_relative_motion():
    state, n, dt = states(200, 19), PAPER.orbit.mean_motion, 1e-2
    there, back = cw.propagate(state, n, dt), cw.propagate(state, n, -dt)
    free = (there - back)[:, 4:6] / (2.0*dt)
    state[:, 4:6] = 0.0                                     # z'' = -n^2 z, y'' = 2n x' + 3n^2 y
    drift = PAPER.law(Barrier, coupling='all')._ahead(np.ascontiguousarray(state.T)).drift
    np.testing.assert_allclose(drift.T, free, rtol=0.0, atol=1e-11)


@pytest.mark.parametrize('coupling', ['closing_rate', 'all'])
@pytest.mark.parametrize('paper', [PAPER, WIDE, SLIM], ids=['paper', 'wide', 'slim'])
@pytest.mark.parametrize('pilot', ['outward', 'random', 'forward'])
def test_no_pilot_gets_out_of_the_corridor(paper, coupling, pilot):
    """True state, no delay, no noise; starts from which some level still violates nothing."""
    law = paper.law(Barrier, sharing=StickFilter(), coupling=coupling)
    rng, n = np.random.default_rng(11), paper.orbit.mean_motion
    state = states(1500, 12, paper, fill=0.7)
    state[:, 3] = 0.25
    state = state[(state[:, 0] < -2.0) & (law.violation(state.T).min(axis=0) <= 0.0).all(axis=0)]
    assert len(state) > 200
    phi, gamma = cw.transition(n, paper.step_s), cw.input_matrix(n, paper.step_s)
    docked = np.zeros(len(state), dtype=bool)
    for _ in range(int(260/paper.step_s)):
        stick = rng.integers(-3, 4, (len(state), 3), dtype=np.int8)
        if pilot == 'outward':
            stick[:, 1:] = 3*np.sign(state[:, 1:3])
        elif pilot == 'forward':
            stick[:, 0] = 3
        levels = paper.levels(law, state, stick)
        state = cw.step(state, acceleration(levels, paper.thrust), phi, gamma)
        docked |= state[:, 0] >= 0.0
        flying = state[~docked]
        assert np.all(signed_distance(flying[:, :3], paper.cone) > 0.0)
        assert np.all((flying[:, 3] > 0.13) & (flying[:, 3] < 0.3))
        if docked.all():
            break
    assert docked.all()


# Inside a blend, and without a pilot

@pytest.mark.parametrize('sharing', [Eq25(), Eq25(eta=Decimal('0.2')), Eq25(eta=0.5), Eq25(eta=1.0),
                                     Eq25(rounding='truncate'), StickFilter()], ids=repr)
def test_the_blend_comes_as_near_as_it_can_to_what_is_wanted(sharing):
    law, state, stick = PAPER.law(Barrier, sharing=sharing), states(4000, 13), sticks(4000, 14)
    wanted, auto = law.outcome(state, stick), PAPER.levels(law, state, stick)
    out = decide('shared', sharing, stick, True, auto, True).levels.astype(int)
    for man, want, got, sent in zip(*(a.ravel().tolist() for a in (stick, wanted, auto, out))):
        ways = {a: abs(int(sharing.share([man], [a])[0]) - want) for a in range(-3, 4)}
        assert abs(sent - want) == min(ways.values())
        if man == want:
            assert got == man
        else:
            assert abs(got) == min(abs(a) for a in ways if ways[a] == min(ways.values()))


def test_as_a_filter_it_hands_over_the_command_itself():
    law = PAPER.law(Barrier, sharing=StickFilter())
    state, stick = states(500, 15), sticks(500, 16)
    assert_array_equal(PAPER.levels(law, state, stick), law.outcome(state, stick))


@pytest.mark.parametrize('sharing', [Eq25(), StickFilter()])
def test_without_a_stick_the_pilot_is_neutral_and_nothing_is_blended(sharing):
    state, neutral = states(500, 17), np.zeros((500, 3), dtype=np.int8)
    expected = PAPER.law(Barrier).outcome(state, neutral)
    assert np.abs(expected).max() > 1
    assert_array_equal(PAPER.levels(PAPER.law(Barrier, sharing=sharing), state, None), expected)


@settings(deadline=None, max_examples=200)
@given(st.lists(st.floats(-1e6, 1e6), min_size=6, max_size=6),
       st.lists(st.integers(-3, 3), min_size=3, max_size=3))
def test_any_finite_state_gets_levels(state, stick):
    got = PAPER.levels(PAPER.law(Barrier), state, np.array(stick, dtype=np.int8))
    assert got.shape == (3,) and got.dtype == np.int8 and np.abs(got).max() <= 3


@pytest.mark.parametrize('key, bad, said', [
    ('coasts_s', (), 'coasts_s must be one number or more, got []'),
    ('coasts_s', (0.0, -1.0), 'coasts_s[1] must not be negative, got -1.0'),
    ('coasts_s', (inf,), 'coasts_s[0] must be finite, got inf'),
    ('brake_level', 0, 'brake_level must be between 1 and 3, got 0'),
    ('brake_level', 4, 'brake_level must be between 1 and 3, got 4'),
    ('margin_fraction', 0.0, 'margin_fraction must be above 0 and at most 1, got 0.0'),
    ('margin_fraction', 1.1, 'margin_fraction must be above 0 and at most 1, got 1.1'),
    ('coupling', 'some', 'coupling must be one of closing_rate, all, none, got some'),
    ('keep_closing_m_s', (0.3, 0.2), 'keep_closing_m_s must be rising numbers, got [0.3, 0.2]'),
    ('force_closing_m_s', (0.1,), 'force_closing_m_s must be 2 numbers, got [0.1]')])
def test_impossible_settings_are_refused_by_name(key, bad, said):
    with pytest.raises(ValueError, match=f'^{re.escape(said)}$'):
        Barrier(**{key: bad})
