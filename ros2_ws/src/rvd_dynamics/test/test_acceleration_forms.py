"""What thrusters of each kind can do: limits per step, impulse delivered, switch counts."""

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.acceleration import BangBang, Continuous, Pulses, RateLimited, switches
from rvd_dynamics.commands.form import FORMS
from rvd_dynamics.diagram.run import Run

MOST = 0.01                     # [m/s^2]
wishes = st.lists(st.floats(-0.05, 0.05), min_size=1, max_size=60)


def flown(form, wanted):
    """Return the commands (steps, 3) that follow wishes (steps,) along x."""
    made, last = [], form.neutral
    for wish in wanted:
        last = form.follow(last, np.array([wish, 0.0, 0.0]))
        made.append(last)
    return np.array(made)


@pytest.mark.parametrize('form', FORMS.values(), ids=FORMS)
@given(wishes)
@settings(max_examples=30, deadline=None)
def test_commands_that_follow_are_legal_and_no_larger_than_the_largest(form, wanted):
    made = flown(form(), wanted)
    assert all(form().legal(command) for command in made.tolist())
    assert np.abs(form().effect(made)).max() <= (0.03 if form is FORMS['levels'] else MOST)


@pytest.mark.parametrize('form', FORMS.values(), ids=FORMS)
def test_a_row_of_a_batch_follows_as_alone_to_the_bit(form):
    rng = np.random.default_rng(0)
    form = form()
    last, wish = form.quantise(rng.normal(size=(200, 3)) * MOST), rng.normal(size=(200, 3)) * MOST
    whole = form.follow(last, wish)
    assert whole.dtype == form.neutral.dtype
    for row, before, wanted in zip(whole, last, wish):
        assert form.follow(before, wanted).tobytes() == row.tobytes()


@pytest.mark.parametrize('reading', ['rate', 'rate2'])
@given(wishes, st.sampled_from([2.0, 3.0, 5.0, 0.4]))
@settings(max_examples=60, deadline=None)
def test_thrust_changes_no_faster_than_its_ramp(reading, wanted, ramp_s):
    form = RateLimited(ramp_s=ramp_s, reading=reading)
    made = np.concatenate([[np.zeros(3)], flown(form, wanted)])
    assert np.abs(np.diff(made, axis=0)).max() <= MOST / ramp_s * (1 + 1e-12)


def test_rate_stops_at_the_command_and_rate2_swings_about_it():
    wish = np.full(40, 0.0047)
    kept, swings = (flown(RateLimited(ramp_s=5.0, reading=reading), wish)[:, 0]
                    for reading in ('rate', 'rate2'))
    assert_allclose(kept[3:], 0.0047, rtol=1e-15)
    assert_allclose(swings, np.minimum(np.arange(1, 41), 2) * 0.002, rtol=1e-12)    # dead zone
    between = flown(RateLimited(ramp_s=5.0, reading='rate2'), [0.001, 0.0031, 0.0047, 0.0005])
    assert_allclose(between[:, 0], [0.0, 0.002, 0.004, 0.002], atol=1e-15)


def test_a_thruster_that_obeys_the_same_limits_changes_nothing():
    rng = np.random.default_rng(1)
    for form in (RateLimited(ramp_s=3.0), RateLimited(ramp_s=3.0, reading='rate2'), Continuous()):
        commands = flown(form, rng.normal(size=200) * MOST)
        executed, last = [], np.zeros(3)
        for command in commands:
            last = form.follow(last, form.effect(command))
            executed.append(last)
        assert_array_equal(executed, commands)


def test_engines_of_four_levels_round_or_stay_below():
    wish = np.array([0.0012, 0.0013, 0.0037, 0.0038, 0.0099, 0.5, -0.0049])
    near, below = (BangBang(rounding=rounding).quantise(np.stack([wish, wish, wish], -1))[:, 0]
                   for rounding in ('round', 'floor'))
    assert_array_equal(near, [0, 1, 1, 2, 4, 4, -2])
    assert_array_equal(below, [0, 0, 1, 1, 3, 4, -1])


@given(st.floats(-0.02, 0.02))
@settings(max_examples=200, deadline=None)
def test_a_pulse_delivers_what_is_wanted_within_half_of_the_least_pulse(wanted):
    form = Pulses(least_on_s=0.08, tick_s=0.004)
    impulse = form.effect(form.quantise([wanted, 0.0, 0.0]))[0] * form.step_s
    most = MOST * form.step_s
    assert abs(impulse - np.clip(wanted, -most, most)) <= 0.5 * 0.08 * MOST + 1e-12
    assert impulse == 0.0 or 0.08*MOST - 1e-12 <= abs(impulse) <= most + 1e-12


def test_pulses_know_the_step_of_the_run():
    form = Pulses(tick_s=0.01, least_on_s=0.05, run=Run(step_s=0.5))
    assert (form.least, form.longest) == (5, 50)
    assert_allclose(form.effect(form.quantise([1.0, 0.003, 0.0])), [MOST, 0.003, 0.0])
    with pytest.raises(BadInput, match='least_on_s must not be above step_s = 0.5, got 0.8'):
        Pulses(least_on_s=0.8, run=Run(step_s=0.5))
    with pytest.raises(BadInput, match='tick_s must go 1 to 32767 times into step_s = 0.5'):
        Pulses(tick_s=1e-6, run=Run(step_s=0.5))


def test_a_rate_limit_knows_the_step_of_the_run():
    assert RateLimited(ramp_s=2.0, run=Run(step_s=0.5)).change_m_s2 == pytest.approx(0.0025)


def test_switches_count_engines_that_go_on_or_off():
    x = [0, 1, 1, 2, 0, -1, 1, 0]               # on, off, on, off and on, off
    commands = np.zeros((8, 2, 3), dtype=np.int8)
    commands[:, 0, 0] = x
    commands[3, 1, 2] = 4                       # on, off
    assert_array_equal(switches(commands), [6, 2])
    assert switches(np.ones((5, 3))) == 6       # on at the start, off at the end


def test_an_abort_thrusts_away_from_the_target():
    for form in (Continuous(), RateLimited(), BangBang(), Pulses()):
        ahead = replace(form, away=(1, 0, 0))
        assert_allclose(form.effect(form.retreat), [-MOST, 0.0, 0.0])
        assert_allclose(ahead.effect(ahead.retreat), [MOST, 0.0, 0.0])


def test_impossible_thrusters_are_refused():
    for wrong in (lambda: Continuous(max_m_s2=0.0), lambda: RateLimited(ramp_s=-1.0),
                  lambda: RateLimited(reading='rate3'), lambda: BangBang(engines=0),
                  lambda: Pulses(tick_s=0.0)):
        with pytest.raises(BadInput, match='must be'):
            wrong()
