"""
The pseudo-rate modulator and the six loops: formulas against simulation and the specification.
"""

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.onboard.control.pseudo_rate import limit_cycle, Modulator, ModulatorParams
from rvd_dynamics.onboard.control.six_loops import (
    AttitudeLoopParams, Design, LoopParams, require_design, SixLoops)

TABLE = ModulatorParams(on_threshold=0.1, off_threshold=0.06, time_constant_s=2.0)
X0 = np.array([0.12, 0.2, 0.5, 0.9])


def pulses(params, x, seconds, step=5e-5):
    """Return the mean on-time, off-time and the number of whole cycles of a constant input."""
    modulator = Modulator(params, step, np.shape(x))
    on = np.array([modulator.step(x) != 0.0 for _ in range(round(seconds/step))])
    return [_cycles(on[:, i], step) for i in range(on.shape[1])]


def _cycles(on, step):
    edges = np.flatnonzero(np.diff(on.astype(int)))
    up, down = edges[~on[edges]], edges[on[edges]]
    down = down[down > up[0]][:len(up) - 1]
    return np.mean(down - up[:len(down)])*step, np.mean(up[1:] - down)*step


def test_formulas_give_the_table_of_the_specification():
    assert_allclose(TABLE.on_time(X0), [.0833, .0909, .1380, .4463], atol=5.1e-5)
    assert_allclose(TABLE.off_time(X0), [2.197, .673, .1906, .0976], atol=5.1e-4)
    assert_allclose(TABLE.frequency(X0), [.438, 1.309, 3.043, 1.839], atol=5.1e-4)
    assert_allclose(TABLE.frequency_approximate(X0), [.48, 1.32, 3.05, 1.84], atol=5.1e-3)
    h, a = 0.1, 0.06
    printed = X0*(1 + h - X0)/(2.0*(h - a)*(1 + h))
    assert_allclose(printed, [1.336, 2.045, 3.409, 2.045], atol=5.1e-4)     # eq. 30 as printed
    # eq. 28 as printed: the negative of the on-time
    assert_allclose(2.0*np.log(1 - (h - a)/(h + 1 - X0)), -TABLE.on_time(X0))


def test_the_trigger_pulses_as_the_formulas_say():
    found = pulses(TABLE, X0, 5.5)
    assert_allclose([f[0] for f in found], TABLE.on_time(X0), rtol=1e-3)
    assert_allclose([f[1] for f in found], TABLE.off_time(X0), rtol=1e-3)


def test_another_feedback_gain_scales_input_and_thresholds():
    scaled = ModulatorParams(on_threshold=0.2, off_threshold=0.12, time_constant_s=2.0,
                             feedback_gain=2.0)
    assert_allclose(scaled.on_time(2*X0), TABLE.on_time(X0))
    (on, off), = pulses(scaled, np.array([1.0]), 2.0, step=1e-4)
    assert_allclose([on, off], [TABLE.on_time(0.5), TABLE.off_time(0.5)], rtol=2e-3)


def test_the_recommended_setting_pulses_at_least_53_ms():
    assert ModulatorParams().shortest_pulse_s == pytest.approx(0.0527, abs=5e-5)
    assert ModulatorParams().on_time(0.3 + 1e-9) == pytest.approx(0.0527, abs=5e-5)


@given(st.floats(-3.0, 3.0), st.floats(0.05, 0.5), st.floats(0.1, 0.9))
@settings(max_examples=25)
def test_duty_is_odd_bounded_and_nearly_linear(x, on, part):
    params = ModulatorParams(on_threshold=on, off_threshold=part*on, time_constant_s=0.5)
    duty = float(params.duty(x))
    assert 0.0 <= duty <= 1.0 and duty == params.duty(-x)
    middle = 0.5*(on + part*on)
    if on < abs(x) < 1.0:
        assert duty == pytest.approx(abs(x) - middle, abs=0.3*on)
    steps = 1000
    modulator = Modulator(params, 1e-3, ())
    u = np.array([float(modulator.step(x)) for _ in range(steps)])
    assert set(np.unique(u)) <= {0.0, np.sign(x)}
    if abs(x) < on:
        assert not u.any()
    if abs(x) >= params.saturation:
        assert u.all()


def test_an_input_that_is_unknown_stops_it():
    modulator = Modulator(ModulatorParams(), 0.01, (2,))
    modulator.step([1.0, 1.0])
    assert modulator.step([np.nan, 1.0]).tolist() == [0.0, 1.0]


def test_off_threshold_above_on_threshold_is_refused():
    with pytest.raises(BadInput, match='off_threshold must be below on_threshold, 0.3, got 0.4'):
        ModulatorParams(off_threshold=0.4)


# -- loops ----------------------------------------------------------------------------------------

@pytest.fixture(scope='module')
def held():
    """
    Position and speed, (80000, 2, 2), of two double integrators of 0.02 m/s^2 in loops: 800 s.
    """
    step, modulator = 0.01, SixLoops(LoopParams(), AttitudeLoopParams(), 0.01, (2,))
    x, v, track = np.array([0.0, 0.5]), np.array([0.5e-3, 0.0]), []
    error, rate = np.zeros((2, 2, 6))
    for _ in range(80_000):
        error[:, 0], rate[:, 0] = -x, -v
        a = 0.02*modulator.step(error, rate)[:, 0]
        x, v = x + step*v + 0.5*step*step*a, v + step*a
        track.append((x, v))
    return np.array(track)


def test_the_recommended_loops_have_the_dead_bands_and_the_limit_cycle_of_the_specification():
    position, attitude = Design(LoopParams(), 0.02), Design(AttitudeLoopParams(), 16.0/2200.0)
    assert position.loop.dead_band == pytest.approx(0.025)
    assert np.degrees(attitude.loop.dead_band) == pytest.approx(0.34, abs=5e-3)
    assert position.limit_cycle_s/2 == pytest.approx(95.0, abs=0.5)
    assert 2*position.limit_cycle_rate == pytest.approx(1.05e-3, abs=5e-6)
    assert limit_cycle(0.025, 0.0525, 0.02) == pytest.approx((190.5, 0.525e-3), rel=1e-3)


def test_a_double_integrator_cycles_about_its_aim_as_the_theory_says(held):
    """A pulse at each edge turns it over; the trigger leads by T_d v, so a way is shorter."""
    x, v = held[:, 0, 0], held[:, 1, 0]
    speeds = v[np.abs(x) < 0.01]
    up, down = np.median(speeds[speeds > 0]), -np.median(speeds[speeds < 0])
    shortest = 0.02*LoopParams().modulator.shortest_pulse_s
    assert 0.6*shortest < up + down <= shortest + 0.02*0.01     # X falls while it pulses
    crossings = 0.01*np.flatnonzero((x[:-1] < 0.0) & (x[1:] >= 0.0))
    way = 2*0.025 - 3.5*(up + down)
    assert len(crossings) > 2
    assert np.mean(np.diff(crossings)) == pytest.approx(way/up + way/down, rel=0.02)
    assert np.abs(x).max() < 0.025


def test_a_loop_brings_an_offset_home_without_overshooting_the_dead_band(held):
    x = held[:30_000, 0, 1]
    assert np.abs(x[-1]) <= 0.026 and x.min() > -0.03


def test_the_integral_takes_away_what_a_constant_push_leaves():
    """With a push of 2 mm/s^2: pulses at the edge of the dead band without, at the aim with it."""
    def mean_of(loop):
        loops = SixLoops(loop, AttitudeLoopParams(), 0.01, ())
        x, v, xs = 0.0, 0.0, []
        for _ in range(15_000):
            u = loops.step([-x, 0, 0, 0, 0, 0], [-v, 0, 0, 0, 0, 0])[0]
            a = 0.02*u + 0.002
            x, v = x + 0.01*v, v + 0.01*a
            xs.append(x)
        return np.mean(xs[-5_000:])
    without, with_it = (mean_of(LoopParams(integral_per_s=k)) for k in (0.0, 0.02))
    assert without > 0.02 and abs(with_it) < 0.4*without


def test_rows_and_axes_are_independent():
    rng = np.random.default_rng(3)
    together = SixLoops(LoopParams(), AttitudeLoopParams(), 0.01, (4,))
    alone = [SixLoops(LoopParams(), AttitudeLoopParams(), 0.01, ()) for _ in range(4)]
    for _ in range(50):
        e, de = rng.normal(size=(2, 4, 6))*0.05
        whole = together.step(e, de)
        for i in range(4):
            assert np.array_equal(alone[i].step(e[i], de[i]), whole[i])


RULES = {'widest': 0.04, 'least_on_s': 0.04, 'delay_s': 0.05, 'frequencies': [0.25, 0.35, 1.5708],
         'clock_s': 0.01}


def test_the_recommended_gains_keep_the_rules():
    require_design('position', Design(LoopParams(), 0.02), **RULES)
    require_design('attitude', Design(AttitudeLoopParams(), 0.0073), **{**RULES, 'widest': 0.00611})


@pytest.mark.parametrize('changed, rules, words', [
    ({'gain': 7.0}, {}, 'position.gain: the dead band .* must be below 0.04, got 0.0428'),
    ({'modulator': ModulatorParams(off_threshold=0.25)}, {}, 'shortest pulse .* got 0.0256'),
    ({'modulator': ModulatorParams(time_constant_s=0.6)}, {},
     '1/T_F must .* 1.15 away from 1.571 .* got 1.667 rad/s'),
    ({'derivative_s': 0.0}, {'delay_s': 0.4}, 'must lead by 20 degrees at 0.25 rad/s'),
    ({'modulator': ModulatorParams(time_constant_s=0.005)}, {'least_on_s': 0.0},
     'at least one step, 0.01 s, got 0.005')])
def test_gains_that_break_a_rule_are_refused_in_one_line(changed, rules, words):
    with pytest.raises(BadInput, match=words) as refused:
        require_design('position', Design(LoopParams(**changed), 0.02), **{**RULES, **rules})
    assert '\n' not in str(refused.value)
