"""What every guidance law keeps: shapes, types, rows by themselves, nothing from nothing."""

from dataclasses import fields, is_dataclass

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.geometry.cone import radius
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import leaves
from rvd_groundstation.guidance import LAWS

MISSION = Mission()


@pytest.fixture(params=LAWS.values(), ids=LAWS.keys())
def law(request):
    return request.param(MISSION)


def states(rows, seed=0):
    """Return states (rows, 6) inside, near and outside the corridor, also past the plane."""
    rng = np.random.default_rng(seed)
    x = rng.uniform(-32.0, 1.0, rows)
    angle = rng.uniform(0, 2*np.pi, rows)
    rho = radius(x, MISSION.corridor) * rng.uniform(0.0, 1.3, rows)
    rates = [0.25, 0.0, 0.0] + rng.normal(scale=0.03, size=(rows, 3))
    return np.column_stack([x, rho*np.cos(angle), rho*np.sin(angle), rates])


def sticks(rows, seed=0):
    return np.random.default_rng(seed).integers(-3, 4, (rows, 3), dtype=np.int8)


def test_is_a_frozen_dataclass_with_the_mission_first(law):
    assert is_dataclass(law) and fields(law)[0].name == 'mission'
    assert isinstance(type(law).uses_stick, bool)
    assert 'mission' not in dict(leaves(type(law)))
    with pytest.raises(AttributeError):
        law.mission = None


def test_every_setting_says_what_it_means(law):
    for _, f in leaves(type(law)):
        assert len(f.metadata['doc']) > 10


@pytest.mark.parametrize('with_stick', [True, False])
def test_levels_are_whole_and_in_range_everywhere(law, with_stick):
    got = law.levels(states(5000), sticks(5000) if with_stick else None)
    assert got.shape == (5000, 3) and got.dtype == np.int8
    assert np.abs(got).max(initial=0) <= 3


@pytest.mark.parametrize('with_stick', [True, False])
@pytest.mark.parametrize('batch', [(), (1,), (7,), (1000,), (4, 3)])
def test_rows_are_equal_to_single_calls_bit_for_bit(law, batch, with_stick):
    rows = int(np.prod(batch, dtype=int))
    state, stick = states(rows, 5), sticks(rows, 6)
    whole = law.levels(state.reshape(*batch, 6), stick.reshape(*batch, 3) if with_stick else None)
    assert whole.shape == (*batch, 3)
    for i, got in enumerate(whole.reshape(-1, 3)):
        assert_array_equal(got, law.levels(state[i], stick[i] if with_stick else None))


@pytest.mark.parametrize('component', range(6))
def test_unknown_component_disturbs_no_other_row(law, component):
    state = states(20, 7)
    clean = law.levels(state, sticks(20))
    state[3, component] = np.nan
    got = law.levels(state, sticks(20))
    assert_array_equal(np.delete(got, 3, axis=0), np.delete(clean, 3, axis=0))
    assert np.abs(got[3]).max() <= 3                                        # P10: never -128


def test_wholly_unknown_state_is_level_zero(law):
    assert_array_equal(law.levels(np.full((4, 6), np.nan), None), 0)


def test_input_is_left_alone(law):
    state, stick = states(50), sticks(50)
    kept = state.copy(), stick.copy()
    law.levels(state, stick)
    assert_array_equal(state, kept[0])
    assert_array_equal(stick, kept[1])
