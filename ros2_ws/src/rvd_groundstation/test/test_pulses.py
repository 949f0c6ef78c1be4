"""The vectorised pilot against the model written out in scalars, and by what he must do."""

from dataclasses import replace
from math import copysign, exp, log, sqrt, tan, radians

import numpy as np
from numpy.testing import assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.diagram.streams import pilot_draws, PilotDraws, skill_normal
from rvd_groundstation.operators.pilot import PERSONS
from rvd_groundstation.operators.pulses import Pulses

STEPS = 300
QUIET = Pulses(rate_bias_m_s=0.0, position_bias_m=0.0, position_bias_per_m=0.0,
               slip_fraction=0.0, lapse_interval_s=1e12, skill_spread=0.0)


def stack(draws):
    """Return the draws of single runs with a leading axis."""
    return PilotDraws(*(np.stack(part) for part in zip(*draws)))


class Scalar:
    """The pilot as its description reads: one run, seconds, one axis after the other."""

    def __init__(self, g, spread, trust, step_s, draws, z):
        self.T, self.draws = step_s, draws
        self.G = g * exp(spread * z)
        self.phi = min(max(1 - (1 - trust) * self.G, 0.0), 1.0)
        self.b = list(draws.initial_normals)
        self.t_next = [4.0 * u for u in draws.initial_uniforms]
        self.busy_until, self.level = [0, 0, 0], [0, 0, 0]
        self.lapse_until = 0.0
        self.shown = []

    def step(self, k, d, p, valid):
        T, G, t = self.T, self.G, k * self.T
        N, U = self.draws.normals[k], self.draws.uniforms[k]
        rho = exp(-T / 15.0)
        self.b = [rho * b + sqrt(1 - rho*rho) * n for b, n in zip(self.b, N[:6])]
        if t >= self.lapse_until and U[0] < G * T / 120.0:
            self.lapse_until = t + 8.0 * -log(U[1])
        if valid:
            self.shown.append([a + self.phi * (b - a) for a, b in zip(d, p)])
        if self.shown and t >= self.lapse_until - 1e-12:
            late = round(1.0 / T)
            self.decide(k, t, self.shown[max(len(self.shown) - 1 - late, 0)], N, U)
        return [self.level[i] if k < self.busy_until[i] else 0 for i in range(3)]

    def decide(self, k, t, s, N, U):
        T, G = self.T, self.G
        r = max(-s[0], 0.0)
        for i in range(3):
            if k < self.busy_until[i] or t < self.t_next[i] - 1e-9:
                continue
            if i == 0:
                ex = s[3] - 0.25 + G * 0.006 * self.b[3]
                if abs(ex) > 0.03:
                    self.level[0], self.busy_until[0] = int(copysign(1, -ex)), k + round(1 / T)
                self.t_next[0] = t + 8.0
                continue
            pos = s[i] + G * (0.010 + 0.004 * r) * self.b[i]
            rate = s[3 + i] + G * 0.006 * self.b[3 + i]
            if abs(rate) < 0.003:
                rate = 0.0
            wall = 0.3 + r * tan(radians(3.0))
            e = copysign(max(abs(pos) - 0.1 * wall, 0.0), pos)
            lead = min(max(0.35 * r / 0.25, 6.0), 15.0)
            err = min(max(-e / lead, -0.06), 0.06) - rate
            acts = abs(err) > 0.016
            wait = 0.6
            if acts:
                dv = 0.9 * exp(0.25 * N[6 + i]) * abs(err)
                level = 1 + (dv > 0.015) + (dv > 0.03)
                accel = (0.005, 0.010, 0.020)[level - 1]
                n = min(max(round(dv / (accel * T)), max(round(1.5 / T), 1)), round(5.0 / T))
                sign = copysign(1, err) * (-1 if U[1 + i] < 0.01 * G else 1)
                self.level[i], self.busy_until[i] = int(sign * level), k + n
                wait = 1.0
            self.t_next[i] = t + 4.0 * exp(0.35 * N[9]) * wait + (n * T if acts else 0.0)


def displays(rows, steps, step_s, seed=0):
    """Return estimates and predictions (rows, steps, 6) of drifting approaches."""
    rng = np.random.default_rng(seed)
    t = step_s * np.arange(steps)[:, None]
    start = np.array([-30.0, 0, 0]) + rng.normal(scale=[0, 0.5, 0.5], size=(rows, 1, 3))
    rate = np.array([0.25, 0, 0]) + rng.normal(scale=[0.02, 0.02, 0.02], size=(rows, 1, 3))
    wave = 0.3 * np.sin(0.05 * t + rng.uniform(0, 6, (rows, 1, 3))) * [0, 1, 1]
    d = np.concatenate([start + rate*t + wave, rate + 0*t + 0.05*wave], axis=-1)
    p = d.copy()
    p[..., :3] += 10.0 * d[..., 3:]
    return d, p


def fly(params, paper, rows, d, p, first=10, seed=0, draws=None):
    """Return levels (rows, steps, 3) of a batch whose displays begin at step `first`."""
    steps = d.shape[1]
    draws = draws or stack(pilot_draws(seed, run, steps) for run in range(rows))
    skill = np.array([skill_normal(seed, run) for run in range(rows)])
    pilot = paper.pilot(params, draws, skill, (rows,))
    return np.stack([pilot.advance(k, d[:, k], p[:, k], np.full(rows, k >= first))
                     for k in range(steps)], axis=1)


@pytest.mark.parametrize('step_s', [0.05, 0.1, 0.5, 1.0])
@pytest.mark.parametrize('name, g, spread, trust', [
    ('A', 1.635, 0.35, 0.9), ('C', 1.77, 0.20, 0.9), ('B', 1.0, 0.35, 0.602)])
def test_is_the_model_written_out_in_scalars(name, g, spread, trust, step_s):
    rows, paper = 12, Paper(step_s=step_s)
    d, p = displays(rows, STEPS, step_s)
    got = fly(PERSONS[name], paper, rows, d, p)
    acted = 0
    for run in range(rows):
        scalar = Scalar(g, spread, trust, step_s, pilot_draws(0, run, STEPS),
                        skill_normal(0, run))
        reference = [scalar.step(k, d[run, k], p[run, k], k >= 10) for k in range(STEPS)]
        assert_array_equal(got[run], reference)
        acted += np.count_nonzero(reference)
    assert acted > 50


@pytest.mark.parametrize('rows', [1, 7, 300, 1000])
def test_rows_are_equal_to_single_pilots_bit_for_bit(rows):
    paper, steps = Paper(), 60
    d, p = displays(rows, steps, 0.5, seed=rows)
    valid = np.random.default_rng(rows).random((rows, steps)) < 0.95
    draws = [pilot_draws(3, run, steps) for run in range(rows)]
    skill = np.array([skill_normal(3, run) for run in range(rows)])
    batch = paper.pilot(Pulses(), stack(draws), skill, (rows,))
    whole = [batch.advance(k, d[:, k], p[:, k], valid[:, k]) for k in range(steps)]
    for row in range(0, rows, max(1, rows // 12)):
        single = paper.pilot(Pulses(), draws[row], skill[row])
        for k in range(steps):
            got = single.advance(k, d[row, k], p[row, k], valid[row, k])
            assert got.shape == (3,) and got.dtype == np.int8
            assert_array_equal(got, whole[k][row])


def test_neutral_until_the_first_displays():
    paper = Paper()
    d, p = displays(50, 80, 0.5)
    d[:, :30], p[:, :30] = np.nan, np.nan
    levels = fly(Pulses(), paper, 50, d, p, first=30)
    assert not levels[:, :30].any()
    assert levels[:, 30:].any(axis=(1, 2)).mean() > 0.5


def test_displays_that_go_out_stay_as_they_were():
    paper = Paper()
    d, p = displays(40, 120, 0.5, seed=2)
    frozen_d, frozen_p = d.copy(), p.copy()
    frozen_d[:, 60:], frozen_p[:, 60:] = d[:, 59:60], p[:, 59:60]
    draws = stack(pilot_draws(0, run, 120) for run in range(40))
    skill = np.zeros(40)
    dark, still = (paper.pilot(Pulses(), draws, skill, (40,)) for _ in range(2))
    for k in range(120):
        lit = k < 60
        nothing = np.full((40, 6), np.nan)
        assert_array_equal(
            dark.advance(k, d[:, k] if lit else nothing, p[:, k] if lit else nothing,
                         np.full(40, lit)),
            still.advance(k, frozen_d[:, k], frozen_p[:, k], np.full(40, True)))


def constant(state, rows=1, steps=STEPS):
    return np.broadcast_to(np.asarray(state, dtype=float), (rows, steps, 6))


@pytest.mark.parametrize('step_s', [0.05, 0.1, 0.3, 0.5, 0.7, 1.0])
def test_clock_along_x_keeps_eight_seconds_on_any_grid(step_s):
    """Too fast for ever: a pulse of 1 s at -1 every 8 s, to the step."""
    paper = Paper(step_s=step_s, forward_delay_s=0.0, back_delay_s=0.0)
    steps = round(100 / step_s)
    d = constant([-30, 0, 0, 0.31, 0, 0], steps=steps)
    levels = fly(QUIET, paper, 1, d, d, first=0)[0, :, 0]
    begins = np.flatnonzero((levels == -1) & (np.append(0, levels[:-1]) == 0))
    period = int(np.ceil(round(8.0 / step_s, 6)))
    assert len(begins) >= 12 and set(np.diff(begins)) == {period}
    assert np.count_nonzero(levels[begins[0]:begins[0] + period]) == max(round(1 / step_s), 1)


@pytest.mark.parametrize('axis', [1, 2])
@pytest.mark.parametrize('side', [1, -1])
def test_pushes_against_what_he_sees_and_lets_the_other_axis_be(axis, side):
    state = np.array([-20.0, 0, 0, 0.25, 0, 0])
    state[axis] = 0.9 * side
    d = constant(state, rows=20)
    levels = fly(QUIET, Paper(), 20, d, d)
    assert set(np.unique(levels[..., axis])) <= {0, -side, -2*side, -3*side}
    assert levels[..., axis].any(axis=1).all()
    assert not np.delete(levels, axis, axis=-1).any()


def test_lets_be_what_lies_in_the_dead_zone_or_moves_slowly():
    for state in ([-20, 0.13, -0.13, 0.25, 0, 0], [-20, 0, 0, 0.27, 0.015, -0.015]):
        d = constant(state, rows=5)
        assert not fly(QUIET, Paper(), 5, d, d).any()


def test_sees_late_by_his_reaction():
    """The offset appears at one step: nobody acts on it before the reaction time is over."""
    paper, steps, rows = Paper(), 120, 400
    d = np.array(constant([-20.0, 0, 0, 0.25, 0, 0], rows, steps))
    d[:, 50:, 1] = 1.0
    levels = fly(QUIET, paper, rows, d, d)
    acted = levels[..., 1].any(axis=0)
    assert not acted[:52].any() and acted[52]


def test_trust_in_the_prediction_falls_with_skill_and_without_the_display():
    """With the telemetry on the axis and the prediction off it, trust decides what he sees."""
    paper, rows = Paper(), 300
    d, p = constant([-20, 0, 0, 0.25, 0, 0], rows), constant([-20, 0.8, 0, 0.25, 0, 0], rows)
    quiet = replace(QUIET, skill_gain=1.0)
    shown = fly(quiet, paper, rows, d, p)
    hidden = fly(replace(quiet, display=False), paper, rows, d, p)
    assert np.abs(shown[..., 1]).sum() > 1.3 * np.abs(hidden[..., 1]).sum() > 0


def test_no_more_than_the_documented_draws_are_used():
    """N6, U4 and U5 are reserved: other values there change nothing."""
    paper, rows = Paper(), 30
    d, p = displays(rows, STEPS, 0.5)
    draws = stack(pilot_draws(0, run, STEPS) for run in range(rows))
    other = PilotDraws(*(part.copy() for part in draws))
    other.normals[..., 6] += 3.0
    other.uniforms[..., 4:] = 0.0
    assert_array_equal(fly(Pulses(), paper, rows, d, p, draws=draws),
                       fly(Pulses(), paper, rows, d, p, draws=other))


def test_slips_are_one_in_a_hundred_times_the_gain():
    paper, rows = Paper(), 1500
    state = constant([-20, 0.9, 0, 0.25, 0, 0], rows)
    params = replace(QUIET, slip_fraction=0.01)
    levels = fly(params, paper, rows, state, state)[..., 1].astype(int)
    begins = (levels != 0) & (np.pad(levels, ((0, 0), (1, 0)))[:, :-1] == 0)
    slips, pulses = np.count_nonzero(levels[begins] > 0), np.count_nonzero(begins)
    expected = 0.01 * 1.635
    assert abs(slips/pulses - expected) < 5 * np.sqrt(expected / pulses)


def test_lapses_take_their_share_of_the_time():
    """Asleep 8 s after 120 / G s awake: with G = 4 decisions fall by 8 / (8 + 30)."""
    paper, rows = Paper(), 400
    state = constant([-30, 0, 0, 0.31, 0, 0], rows, 400)
    counts = []
    for lapses in (1e12, 120.0):
        params = replace(QUIET, skill_gain=4.0, lapse_interval_s=lapses,
                         closing_interval_s=0.5, closing_pulse_s=0.5)
        counts.append(np.count_nonzero(fly(params, paper, rows, state, state)[:, 100:, 0]))
    assert counts[1] / counts[0] == pytest.approx(30 / 38, abs=0.02)


def test_presets_are_those_of_the_documentation():
    assert PERSONS['A'] == Pulses()
    assert (PERSONS['C'].skill_gain, PERSONS['C'].skill_spread) == (1.77, 0.20)
    assert (PERSONS['B'].skill_gain, PERSONS['B'].display) == (1.0, False)
    assert replace(PERSONS['B'], display=True) == Pulses(skill_gain=1.0)


@pytest.mark.parametrize('name, bad', [
    ('skill_gain', 0.0), ('skill_spread', -0.1), ('reaction_s', np.nan), ('bias_time_s', 0.0),
    ('lead_max_s', 1.0), ('pulse_max_s', 1.0), ('level_3_m_s', 0.01),
    ('lapse_interval_s', np.inf)])
def test_impossible_settings_are_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=name):
        Pulses(**{name: bad})
