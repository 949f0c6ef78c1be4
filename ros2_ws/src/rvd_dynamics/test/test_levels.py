"""Levels, their thresholds, and how a stick becomes levels."""

import json
from pathlib import Path

from hypothesis import given, strategies as st
import numpy as np
import pytest

from rvd_dynamics.commands.layouts import LAYOUTS
from rvd_dynamics.commands.levels import (
    acceleration, level_of_deflection, nearest_level, stick_axes, stick_fault, stick_levels,
    StickParams, ThrustParams)
from rvd_dynamics.diagram.params import build

THRUST, STICK = ThrustParams(), StickParams()
ALL = np.arange(-3, 4)


def test_table_2_of_the_paper():
    expected = [[-.03, -.02, -.02], [-.02, -.01, -.01], [-.01, -.005, -.005], [0, 0, 0],
                [.01, .005, .005], [.02, .01, .01], [.03, .02, .02]]
    assert np.array_equal(acceleration(np.stack([ALL]*3, axis=-1), THRUST), expected)


@pytest.mark.parametrize('levels', [[4, 0, 0], [0, -4, 0], [0, 0, 100], [-128, 0, 0]])
def test_a_level_out_of_range_is_refused_with_its_value(levels):
    with pytest.raises(ValueError, match='levels must be -3 to 3'):
        acceleration(np.array(levels, dtype=np.int8), THRUST)


@pytest.mark.parametrize('levels', [[1.0, 0.0, 0.0], [np.nan, 0.0, 0.0], [True, False, True]])
def test_a_level_that_is_no_whole_number_is_refused(levels):
    with pytest.raises(ValueError, match='levels must be whole numbers'):
        acceleration(levels, THRUST)


def test_every_level_is_nearest_to_its_own_acceleration():
    levels = np.array(np.meshgrid(ALL, ALL, ALL)).reshape(3, -1).T
    back = nearest_level(acceleration(levels, THRUST), THRUST)
    assert np.array_equal(back, levels) and back.dtype == np.int8


@given(st.floats(-0.1, 0.1))
def test_nearest_means_nearest(a):
    for axis in range(3):
        accel = np.zeros(3)
        accel[axis] = a
        got = nearest_level(accel, THRUST)[axis]
        table = acceleration(np.stack([ALL]*3, axis=-1), THRUST)[:, axis]
        assert abs(table[got + 3] - a) <= np.abs(table - a).min() + 1e-17


@pytest.mark.parametrize('axis, thresholds', [(0, (.005, .015, .025)), (1, (.0025, .0075, .015)),
                                              (2, (.0025, .0075, .015))])
def test_thresholds_lie_half_way_and_belong_to_the_larger_level(axis, thresholds):
    for level, threshold in enumerate(thresholds, start=1):
        for sign in (-1, 1):
            accel = np.zeros(3)
            accel[axis] = sign * threshold * (1 + 1e-12)
            assert nearest_level(accel, THRUST)[axis] == sign*level
            accel[axis] = sign * threshold * (1 - 1e-12)
            assert nearest_level(accel, THRUST)[axis] == sign*(level - 1)
    accel = np.zeros(3)
    accel[axis] = 0.0025 if axis else 0.005
    assert nearest_level(accel, THRUST)[axis] == 1


def test_p10_what_is_not_finite_asks_for_nothing():
    assert nearest_level([np.nan, np.inf, -np.inf], THRUST).tolist() == [0, 0, 0]
    assert nearest_level([np.nan, 0.02, -0.02], THRUST).tolist() == [0, 3, -3]


def test_thresholds_follow_the_settings():
    strong = ThrustParams(x_m_s2=(1.0, 2.0, 4.0), lateral_m_s2=(1.0, 2.0, 4.0))
    assert nearest_level([2.9, 3.1, -0.6], strong).tolist() == [2, 3, -1]


# -- stick ------------------------------------------------------------------------------------

def test_a_stick_at_a_third_per_level_gives_that_level():
    assert level_of_deflection(ALL / 3).tolist() == ALL.tolist()
    assert level_of_deflection((ALL / 3).astype(np.float32)).tolist() == ALL.tolist()


@given(st.floats(-1.0, 1.0))
def test_deflection_rounds_to_the_nearest_third_and_is_odd(a):
    level = int(level_of_deflection(a, dead_zone=0.0))
    assert abs(3*a - level) <= 0.5 + 1e-15
    assert int(level_of_deflection(-a, dead_zone=0.0)) == -level


@pytest.mark.parametrize('deflection, level', [(0.166, 0), (0.167, 1), (0.499, 1), (0.5, 2),
                                               (0.833, 2), (0.834, 3), (1.0, 3)])
def test_the_steps_of_the_stick(deflection, level):
    assert level_of_deflection([deflection, -deflection]).tolist() == [level, -level]


def test_a_wide_dead_zone_is_neutral_up_to_its_edge():
    assert level_of_deflection([0.4, 0.41], dead_zone=0.4).tolist() == [0, 1]


def test_a_joy_message_becomes_levels_by_the_default_map():
    axes = np.array([1/3, 1.0, 0.9, -0.9, -2/3, 0.0], dtype=np.float32)     # y, x, ., ., z, .
    levels, valid = stick_levels(axes, [0, 0, 0, 0, 1], STICK)
    assert valid and levels.tolist() == [3, 1, -2] and levels.dtype == np.int8


def test_map_and_signs_are_settings():
    stick = StickParams(axis_x=0, axis_y=1, axis_z=2, sign_x=-1, sign_z=-1, deadman_button=-1)
    levels, valid = stick_levels([1.0, 1/3, -2/3], [], stick)
    assert valid and levels.tolist() == [-3, 1, 2]


OTHERS = (StickParams(), StickParams(axis_x=2, axis_y=7, axis_z=0, sign_x=-1, sign_z=-1),
          StickParams(deadman_button=0), StickParams(deadman_button=-1))


@pytest.mark.parametrize('stick', OTHERS)
@pytest.mark.parametrize('levels', [(0, 0, 0), (3, -2, 1), (-1, 0, 2)])
def test_a_stick_put_to_levels_gives_them(stick, levels):
    axes, buttons = stick_axes([level / 3 for level in levels], True, stick)
    sent = np.array(axes, dtype=np.float32)                     # as a Joy carries them
    found, valid = stick_levels(sent, buttons, stick)
    assert valid and found.tolist() == list(levels)
    assert not np.signbit(sent[sent == 0.0]).any()


@pytest.mark.parametrize('stick', OTHERS[:3])
def test_a_stick_that_nobody_holds_is_invalid(stick):
    assert not stick_levels(*stick_axes((0.0, 1.0, 0.0), False, stick), stick)[1]


NEUTRAL, HELD = [0.0]*6, [0, 0, 0, 0, 1]


@pytest.mark.parametrize('axes, buttons', [
    ([0.0, np.nan, 0.0, 0.0, 0.0, 0.0], HELD),
    ([0.0, 1.0001, 0.0, 0.0, 0.0, 0.0], HELD),
    ([np.inf, 0.0, 0.0, 0.0, 0.0, 0.0], HELD),
    ([0.0, 1.0, 0.0, 0.0], HELD),
    ([], HELD),
    ([0.0, 1.0, 0.0, 0.0, 0.0], [0, 0, 0, 0, 0]),
    ([0.0, 1.0, 0.0, 0.0, 0.0], [0, 0, 0, 0]),
    ([0.0, 1.0, 0.0, 0.0, 0.0], [1, 1, 1, 1, -7]),
    ([0.0, 1.0, 0.0, 0.0, 0.0], []),
], ids=['nan', 'beyond 1', 'infinite', 'four axes', 'no axes', 'dead-man open',
        'too few buttons', 'no button state', 'no buttons'])
def test_o2_o3_one_fault_makes_the_whole_message_invalid(axes, buttons):
    levels, valid = stick_levels(axes, buttons, STICK)
    assert not valid and levels.tolist() == [0, 0, 0]


def test_a_neutral_stick_that_is_held_is_valid():
    levels, valid = stick_levels(NEUTRAL, HELD, STICK)
    assert valid and levels.tolist() == [0, 0, 0]


def test_invalid_levels_may_be_written_without_spoiling_the_next():
    first, _ = stick_levels([], [], STICK)
    first[:] = 3
    assert stick_levels([], [], STICK)[0].tolist() == [0, 0, 0]


@pytest.mark.parametrize('a', [np.nan, 1.1, -np.inf])
def test_a_deflection_that_no_stick_has_is_refused(a):
    with pytest.raises(ValueError, match='deflection must be -1 to 1'):
        level_of_deflection([0.0, a])


CASES = json.loads((Path(__file__).parent / 'data' / 'joys.json').read_text())['cases']


@pytest.mark.parametrize('case', CASES, ids=[case['name'] for case in CASES])
def test_only_the_axes_and_the_button_that_the_stick_names_count(case):
    axes = np.array([np.nan if a is None else float(a) for a in case['axes']], dtype=np.float32)
    assert stick_fault(axes, case['buttons'], STICK) == case['fault']
    levels, valid = stick_levels(axes, case['buttons'], STICK)
    assert (levels.tolist(), valid) == (case['levels'], not case['fault'])


def test_the_default_layout_is_the_defaults_of_the_settings():
    assert build(StickParams, {}) == StickParams()
    assert build(StickParams, {'layout': 'xbox'}) == StickParams()


@pytest.mark.parametrize('name', LAYOUTS)
def test_a_layout_gives_what_it_names_and_a_given_key_counts_before_it(name):
    made = build(StickParams, {'layout': name})
    for key, value in LAYOUTS[name].items():
        assert getattr(made, key) == value
        assert getattr(build(StickParams, {'layout': name, key: 40}), key) == 40
    assert build(StickParams, {'layout': name, 'axis_z': 4}).axis_z == 4    # the default, given


def test_an_unknown_layout_is_refused_with_those_there_are():
    with pytest.raises(ValueError, match='layout must be one of xbox, ps4, .*, got gameboy'):
        build(StickParams, {'layout': 'gameboy'})
