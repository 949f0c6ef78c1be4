"""The pilot of perception to response: by the theory that his parts come from."""

from dataclasses import replace
from math import atan, pi, sqrt

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.diagram.streams import PilotDraws
from rvd_groundstation.operators.human_control import HumanControl, HumanControlPilot, inferred

PAPER = Paper(step_s=0.1)
CALM = HumanControl(noise_ratio=0.0, skill_spread=0.0, skill_gain=1.0, rate_threshold_m_s=0.0,
                    reaction_s=0.0, hold_s=0.0)
unit = st.floats(-1.5, 1.5)


def chance(rows, steps, seed=0):
    rng = np.random.default_rng(seed)
    return PilotDraws(rng.standard_normal((rows, 6)), rng.random((rows, 3)),
                      rng.standard_normal((rows, steps, 10)), rng.random((rows, steps, 6)))


def pilot(params, rows=1, steps=2000, paper=PAPER):
    return paper.wired(params).flying(chance(rows, steps), np.zeros(rows), (rows,))


def triangles(value):
    """Return the seven memberships of a value, as the rule base is drawn in a textbook."""
    centres = np.arange(-3, 4) / 3.0
    return np.maximum(1.0 - np.abs(np.clip(value, -1.0, 1.0) - centres)*3.0, 0.0)


@given(unit, unit)
def test_inference_is_the_rule_base_written_out(offset, rate):
    total = weight = 0.0
    for i, one in zip(range(-3, 4), triangles(offset)):
        for j, other in zip(range(-3, 4), triangles(rate)):
            total += one*other * -min(max(i + j, -3), 3)/3.0
            weight += one*other
    assert inferred(offset, rate) == pytest.approx(total/weight, abs=1e-12)


@given(unit, unit)
def test_inference_is_odd_limited_and_never_pushes_outwards_harder(offset, rate):
    wish = float(inferred(offset, rate))
    assert wish == pytest.approx(-float(inferred(-offset, -rate)), abs=1e-12)
    assert abs(wish) <= 1.0
    assert float(inferred(offset + 0.1, rate)) <= wish + 1e-12


def test_inference_is_linear_where_no_rule_is_limited():
    e, c = np.meshgrid(np.linspace(-0.33, 0.33, 21), np.linspace(-0.33, 0.33, 21))
    assert_allclose(inferred(e, c), -(e + c), atol=1e-12)


@pytest.mark.parametrize('crossover, lead', [(0.1, 5.0), (0.3, 8.0), (1.0, 2.0)])
def test_pilot_and_craft_cross_over_where_he_says(crossover, lead):
    k = HumanControl(crossover_rad_s=crossover, lead_s=lead).gain_per_s2
    s = 1j*crossover
    loop = k*(1.0 + lead*s)/s**2            # of a double integrator
    assert abs(loop) == pytest.approx(1.0)
    assert np.angle(-loop) == pytest.approx(atan(lead*crossover))       # the phase margin


def test_nobody_can_tell_the_rate_of_a_craft_that_hardly_moves():
    still = pilot(replace(CALM, rate_threshold_m_s=0.003))
    state = np.array([[-20.0, 0.0, 0.0, 0.25, 0.0029, -0.0029]])
    still.advance(0, state, state, np.ones(1, dtype=bool))
    _, rate = still._perceive(state.T)
    assert_array_equal(rate[1:], 0.0)


@pytest.mark.parametrize('ratio, attention, time_s', [(0.01, 1.0, 1.0), (0.04, 0.5, 2.0)])
def test_noise_has_the_power_of_the_optimal_control_model(ratio, attention, time_s):
    # Intensity pi P y^2 / f, through a lag: variance = intensity / (2 T). 400 pilots, 60
    # independent instants of each: the deviation is known to 0.5 %, five of which are allowed.
    params = replace(CALM, noise_ratio=ratio, attention=attention, noise_time_s=time_s,
                     offset_floor_m=0.0)
    paper = Paper(step_s=0.5)
    rows, apart = 400, round(8.0*time_s/paper.step_s)
    flying = pilot(params, rows, 60*apart, paper)
    state = np.tile([-20.0, 2.0, 0.0, 0.25, 0.0, 0.0], (rows, 1))
    seen = []
    for k in range(60*apart):
        flying.advance(k, state, state, np.ones(rows, dtype=bool))
        if k % apart == 0:
            seen.append(flying._perceive(state.T)[0][1] - 2.0)
    wanted = 2.0*sqrt(pi*ratio/(2.0*attention*time_s))
    assert np.std(seen) == pytest.approx(wanted, rel=0.025)
    assert abs(np.mean(seen)) < 5.0*wanted/sqrt(400*60)


def test_along_the_way_he_thrusts_until_the_middle_of_the_band():
    flying, rate, seen = pilot(CALM), 0.25 + 0.031, []
    for k in range(100):
        state = np.array([[-20.0, 0.0, 0.0, rate, 0.0, 0.0]])
        level = int(flying.advance(k, state, state, np.ones(1, dtype=bool))[0, 0])
        seen.append(level)
        rate += 0.01*level*PAPER.step_s
    thrusting = [k for k, level in enumerate(seen) if level]
    assert set(seen) == {-1, 0} and thrusting == list(range(len(thrusting)))    # once, at once
    assert len(thrusting) == 31 and rate == pytest.approx(0.25, abs=1.1e-3)


def test_a_display_of_the_present_leaves_only_the_reaction():
    params = replace(CALM, reaction_s=1.0, closing_error_m_s=0.01)
    flying = pilot(params)
    fast = np.array([[-20.0, 0.0, 0.0, 0.30, 0.0, 0.0]])
    slow = np.array([[-20.0, 0.0, 0.0, 0.25, 0.0, 0.0]])
    levels = [int(flying.advance(k, s, s, np.ones(1, dtype=bool))[0, 0])
              for k, s in enumerate([slow]*20 + [fast]*30)]
    assert levels.index(-1) == 20 + round(1.0/PAPER.step_s)


@pytest.mark.parametrize('display, factor, gain, at', [
    (True, 'display_factor', 1.0, 0.9), (False, 'predictive_factor', 2.0, 0.4)])
def test_looks_ahead_by_the_factor_of_what_he_has(display, factor, gain, at):
    number = {'display_factor': 0.9, 'predictive_factor': 0.7}
    flying = pilot(replace(CALM, display=display, skill_gain=gain, **number))
    told, ahead = np.zeros((1, 6)), np.full((1, 6), 10.0)
    shown = flying._look(0, told, ahead, np.ones(1, dtype=bool))
    assert_allclose(shown, 10.0*at, rtol=1e-12)
    assert factor not in flying._params.idle


def closed_loop(params, delay_s, seconds=400.0):
    """Return the offset over time of a double integrator flown through a delay."""
    step, late = PAPER.step_s, round(delay_s/PAPER.step_s)
    flying, y, v, told = pilot(params, steps=round(seconds/step)), 0.5, 0.0, []
    levels, path = np.array([0.0, *PAPER.thrust.lateral_m_s2]), []
    for k in range(round(seconds/step)):
        told.append([-20.0, y, 0.0, 0.25, v, 0.0])
        state = np.array([told[max(k - late, 0)]])
        level = int(flying.advance(k, state, state, np.ones(1, dtype=bool))[0, 1])
        accel = np.sign(level)*levels[abs(level)]
        y, v = y + v*step + accel*step*step/2.0, v + accel*step
        path.append(y)
    return np.array(path)


def test_delay_within_the_margin_is_stood_and_far_beyond_it_is_not():
    # Linear theory: the margin is atan(T w)/w. Levels and their threshold make a limit cycle of
    # what is beyond, so what is asked for is one that grows from within to well beyond.
    params = replace(CALM, crossover_rad_s=0.15, lead_s=6.0)
    margin = atan(6.0*0.15)/0.15
    calm, lost = (np.abs(closed_loop(params, share*margin)[-2000:]).max()
                  for share in (0.3, 2.0))
    assert calm < 0.25 and lost > 3.0*calm and lost > 0.5


@pytest.mark.parametrize('name, bad', [
    ('skill_gain', 0.0), ('display_factor', 1.1), ('attention', 0.0), ('lead_s', np.nan),
    ('crossover_rad_s', 0.0), ('noise_time_s', np.inf), ('back_fraction', 1.5)])
def test_impossible_settings_are_refused_by_name_of_the_form(name, bad):
    with pytest.raises(ValueError, match=name):
        HumanControl(**{name: bad})


def test_flying_is_made_by_the_form():
    assert isinstance(pilot(HumanControl()), HumanControlPilot)
