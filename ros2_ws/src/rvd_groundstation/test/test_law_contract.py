"""What every guidance law keeps: shapes, types, rows by themselves, nothing from nothing."""

from dataclasses import fields, is_dataclass

import numpy as np
from numpy.testing import assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.geometry.cone import radius
from rvd_dynamics.diagram.params import is_wiring, leaves
from rvd_groundstation.guidance import LAWS

PAPER = Paper()


@pytest.fixture(params=LAWS.values(), ids=LAWS.keys())
def law(request):
    return PAPER.law(request.param)


def states(rows, seed=0):
    """Return states (rows, 6) inside, near and outside the corridor, also past the plane."""
    rng = np.random.default_rng(seed)
    x = rng.uniform(-32.0, 1.0, rows)
    angle = rng.uniform(0, 2*np.pi, rows)
    rho = radius(x, PAPER.cone) * rng.uniform(0.0, 1.3, rows)
    rates = [0.25, 0.0, 0.0] + rng.normal(scale=0.03, size=(rows, 3))
    return np.column_stack([x, rho*np.cos(angle), rho*np.sin(angle), rates])


def sticks(rows, seed=0):
    return np.random.default_rng(seed).integers(-3, 4, (rows, 3), dtype=np.int8)


def test_is_a_frozen_dataclass_whose_wiring_is_no_parameter(law):
    assert is_dataclass(law) and isinstance(type(law).uses_stick, bool)
    for f in fields(law):
        if is_wiring(f):
            assert f.name not in dict(leaves(type(law)))
            assert getattr(law, f.name) is not None and getattr(type(law)(), f.name) is None
    with pytest.raises(AttributeError):
        law.uses_stick = None


def test_every_setting_says_what_it_means(law):
    for _, f in leaves(type(law)):
        assert len(f.metadata['doc']) > 10


@pytest.mark.parametrize('with_stick', [True, False])
def test_wants_an_acceleration_of_which_the_form_makes_levels(law, with_stick):
    wanted = law.wanted(states(5000), sticks(5000) if with_stick else None)
    assert wanted.shape == (5000, 3) and wanted.dtype == np.float64
    got = PAPER.form.quantise(wanted)
    assert got.shape == (5000, 3) and got.dtype == np.int8
    assert np.abs(got).max(initial=0) <= 3


@pytest.mark.parametrize('with_stick', [True, False])
@pytest.mark.parametrize('batch', [(), (1,), (7,), (1000,), (4, 3)])
def test_rows_are_equal_to_single_calls_bit_for_bit(law, batch, with_stick):
    rows = int(np.prod(batch, dtype=int))
    state, stick = states(rows, 5), sticks(rows, 6)
    seen = stick.reshape(*batch, 3) if with_stick else None
    whole = law.wanted(state.reshape(*batch, 6), seen)
    levels = PAPER.form.quantise(whole)
    assert whole.shape == levels.shape == (*batch, 3)
    for i, (got, level) in enumerate(zip(whole.reshape(-1, 3), levels.reshape(-1, 3))):
        alone = law.wanted(state[i], stick[i] if with_stick else None)
        assert got.tobytes() == alone.tobytes()
        assert_array_equal(level, PAPER.form.quantise(alone))


@pytest.mark.parametrize('component', range(6))
def test_unknown_component_disturbs_no_other_row(law, component):
    state = states(20, 7)
    clean = PAPER.levels(law, state, sticks(20))
    state[3, component] = np.nan
    got = PAPER.levels(law, state, sticks(20))
    assert_array_equal(np.delete(got, 3, axis=0), np.delete(clean, 3, axis=0))
    assert np.abs(got[3]).max() <= 3                                        # P10: never -128


def test_wholly_unknown_state_is_level_zero(law):
    assert_array_equal(PAPER.levels(law, np.full((4, 6), np.nan), None), 0)


def test_input_is_left_alone(law):
    state, stick = states(50), sticks(50)
    kept = state.copy(), stick.copy()
    law.wanted(state, stick)
    assert_array_equal(state, kept[0])
    assert_array_equal(stick, kept[1])
