"""What every form of model pilot keeps: shapes, types, rows by themselves, nothing from nothing."""

from dataclasses import fields, is_dataclass

import numpy as np
from numpy.testing import assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.diagram.params import build, flatten, is_wiring, leaves
from rvd_dynamics.diagram.streams import pilot_draws, PilotDraws, skill_normal
from rvd_groundstation.operators.pilot import (
    FIRST, form_of, keys_of, OperatorParams, PERSONS, PILOTS)
from rvd_groundstation.operators.recorded import text_of_responses

STEPS = 120
PAPER = Paper()


@pytest.fixture(params=PILOTS.values(), ids=PILOTS.keys())
def form(request):
    return request.param


@pytest.fixture(scope='module')
def table(tmp_path_factory):
    """Return recorded responses: five flights of somebody who pushes against offset and rate."""
    flights = []
    for state in displays(5, seed=8)[1]:
        wish = np.rint(-3.0*(state[:, :3] + 8.0*state[:, 3:])).clip(-3, 3).astype(np.int8)
        wish[:, 0] = 0
        flights.append((state, wish))
    path = tmp_path_factory.mktemp('recorded') / 'responses.csv'
    path.write_text(text_of_responses(flights, PAPER.step_s))
    return str(path)


@pytest.fixture
def settings(form, table):
    """Return a form as it can fly: its defaults, and what it cannot do without."""
    return form(responses=table) if 'responses' in dict(leaves(form)) else form()


def chance(rows, seed=4):
    """Return draws and skills of `rows` runs."""
    draws = zip(*(pilot_draws(seed, run, STEPS) for run in range(rows)))
    return (PilotDraws(*(np.stack(part) for part in draws)),
            np.array([skill_normal(seed, run) for run in range(rows)]))


def displays(rows, seed=5):
    """Return estimates and predictions (rows, STEPS, 6) of approaches that drift off the axis."""
    rng = np.random.default_rng(seed)
    t = PAPER.step_s * np.arange(STEPS)[:, None]
    start = [-30.0, 0.0, 0.0] + rng.normal(scale=[0.0, 0.5, 0.5], size=(rows, 1, 3))
    rate = [0.25, 0.0, 0.0] + rng.normal(scale=0.03, size=(rows, 1, 3))
    estimate = np.concatenate([start + rate*t, rate + 0*t], axis=-1)
    predicted = estimate.copy()
    predicted[..., :3] += 10.0 * rate
    return estimate, predicted


def flown(settings, rows, first=10, picked=slice(None)):
    """Return levels (rows, STEPS, 3) of pilots whose displays begin at step `first`."""
    draws, skill = chance(rows)
    estimate, predicted = (shown[picked] for shown in displays(rows))
    draws, skill = PilotDraws(*(part[picked] for part in draws)), skill[picked]
    pilot = PAPER.wired(settings).flying(draws, skill, skill.shape)
    return np.stack([pilot.advance(k, estimate[..., k, :], predicted[..., k, :],
                                   np.full(skill.shape, k >= first)) for k in range(STEPS)], -2)


def test_is_a_frozen_dataclass_whose_wiring_is_no_parameter(form):
    assert is_dataclass(form)
    for f in fields(form):
        if is_wiring(f):
            assert f.name not in dict(leaves(form)) and getattr(form(), f.name) is None
    with pytest.raises(AttributeError):
        form().skill_gain = 2.0


def test_moves_the_stick_between_its_stops_and_only_after_the_first_display(settings):
    levels = flown(settings, 40)
    assert levels.shape == (40, STEPS, 3) and levels.dtype == np.int8
    assert np.abs(levels).max() <= 3
    assert_array_equal(levels[:, :10], 0)
    assert np.abs(levels[:, 10:, 1:]).max() > 0         # and he does fly


@pytest.mark.parametrize('rows', [1, 7, 300])
def test_rows_are_equal_to_single_pilots_bit_for_bit(settings, rows):
    whole = flown(settings, rows)
    for row in {0, rows//2, rows - 1}:
        assert_array_equal(whole[row], flown(settings, rows, picked=row))


def test_a_display_that_goes_blank_disturbs_no_other_row(settings):
    draws, skill = chance(20)
    estimate, predicted = displays(20)
    pilots = [PAPER.wired(settings).flying(draws, skill, (20,)) for _ in range(2)]
    for k in range(STEPS):
        seen, broken = np.ones(20, dtype=bool), estimate[:, k].copy()
        clean = pilots[0].advance(k, estimate[:, k], predicted[:, k], seen)
        if k > 30:
            seen[3], broken[3] = False, np.nan
        got = pilots[1].advance(k, broken, predicted[:, k], seen)
        assert_array_equal(np.delete(got, 3, axis=0), np.delete(clean, 3, axis=0))
        assert np.abs(got[3]).max() <= 3


@pytest.mark.parametrize('name', PERSONS)
def test_the_keys_of_a_person_make_that_pilot_and_no_other(name):
    made = build(OperatorParams, keys_of(PERSONS[name]))
    assert made.selected == PERSONS[name]
    assert made.form == form_of(made.selected)


def test_the_section_holds_the_numbers_of_every_form():
    keys = set(flatten(OperatorParams()))
    for name, form in PILOTS.items():
        prefix = '' if name == FIRST else f'{name}.'
        assert {prefix + key for key, _ in leaves(form)} <= keys


def test_a_form_that_nobody_listed_is_refused():
    with pytest.raises(LookupError, match='Stranger'):
        form_of(type('Stranger', (), {})())


def test_operators_fly_runs_in_a_row():
    assert [OperatorParams(runs_per_operator=10).operator_of(run) for run in (0, 9, 10, 99)] == [
        0, 0, 1, 9]
    assert OperatorParams().operator_of(37) == 37
    with pytest.raises(ValueError, match='runs_per_operator'):
        OperatorParams(runs_per_operator=0)
