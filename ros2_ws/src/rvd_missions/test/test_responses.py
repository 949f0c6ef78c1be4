"""Recorded responses: the table tells what was flown, and its pilot does what people did."""

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.streams import PilotDraws
from rvd_dynamics.recording import history
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.operators.pilot import OperatorParams
from rvd_groundstation.operators.recorded import (
    COLUMNS, read_responses, Recorded, text_of_responses)
from rvd_missions.lunar_approach import responses
from rvd_missions.lunar_approach.signals import COMMAND, PREDICTION, STICK

MANUAL = parse('/**: {ros__parameters: {mission: lunar_approach, mode: manual, seed: 5}}', 'test')
RUNS = 6


@pytest.fixture(scope='module')
def flown():
    """Return a batch of manual flights of the first model pilot, with its history."""
    return fly(MANUAL, range(RUNS), record=history.everything(MANUAL))


@pytest.fixture(scope='module')
def flights(flown):
    return [responses.response(history.of_history(MANUAL, flown, row)) for row in range(RUNS)]


@pytest.fixture(scope='module')
def table(flights, tmp_path_factory):
    path = tmp_path_factory.mktemp('responses') / 'flights.csv'
    path.write_text(text_of_responses(flights, MANUAL.run.step_s))
    return str(path)


def test_a_flight_is_told_by_what_was_shown_and_where_the_stick_stood(flown, flights):
    for row, (state, levels) in enumerate(flights):
        shown = flown.history[PREDICTION.name]
        good = np.flatnonzero(shown.valid[:, row] & np.isfinite(shown.state[:, row]).all(axis=1))
        good = good[:len(levels)]
        np.testing.assert_allclose(state, shown.state[good, row])
        assert_array_equal(levels, flown.history[STICK.name].command[good, row])


def test_a_table_is_read_as_it_was_written(flights, table):
    found = read_responses(table)
    assert found.step_s == MANUAL.run.step_s
    assert_array_equal(found.state, np.concatenate([state for state, _ in flights]))
    assert_array_equal(found.levels, np.concatenate([levels for _, levels in flights]))
    ends = np.cumsum([len(levels) for _, levels in flights]) - 1
    assert_array_equal(np.flatnonzero(found.last), ends)


def pilot(table, rows, steps, **numbers):
    rng = np.random.default_rng(2)
    draws = PilotDraws(rng.standard_normal((rows, 6)), rng.random((rows, 3)),
                       rng.standard_normal((rows, steps, 10)), rng.random((rows, steps, 6)))
    form = MANUAL.wired(Recorded(responses=table, **numbers))
    return form.flying(draws, np.zeros(rows), (rows,))


def test_who_sees_a_recorded_flight_again_does_what_was_done(flights, table):
    # One neighbour, and stretches that hardly ever end by chance: the nearest instant is itself.
    for state, levels in flights[:3]:
        flying = pilot(table, 1, len(state), neighbours=1, stretch_s=3600.0)
        again = [flying.advance(k, s[None], s[None], np.ones(1, bool))[0]
                 for k, s in enumerate(state)]
        assert_array_equal(again, levels)


def test_a_stretch_has_the_mean_length_that_was_asked_for(flights, table):
    # A stretch of mean L steps ends in a step with probability 1/L: counted where the display
    # stays, in 300 pilots and 60 steps, is binomial; five deviations are allowed.
    rows, steps, stretch = 300, 60, 4.0
    flying, seen = pilot(table, rows, steps, stretch_s=stretch), np.ones(rows, dtype=bool)
    state, jumps, before = np.tile(flights[0][0][40], (rows, 1)), 0, None
    for k in range(steps):
        flying.advance(k, state, state, seen)
        if before is not None:
            jumps += np.count_nonzero(flying._at[1] != before + 1)
        before = flying._at[1].copy()
    chance, trials = MANUAL.run.step_s/stretch, rows*(steps - 1)
    assert abs(jumps - trials*chance) < 5.0*np.sqrt(trials*chance) + 0.02*trials*chance


def test_without_a_display_he_lets_go_when_the_stretch_ends(flights, table):
    flying = pilot(table, 50, 200, stretch_s=2.0)
    state = np.tile(flights[0][0][30], (50, 1))
    flying.advance(0, state, state, np.ones(50, dtype=bool))
    blank = np.full((50, 6), np.nan)
    for k in range(1, 200):
        levels = flying.advance(k, blank, blank, np.zeros(50, dtype=bool))
    assert_array_equal(levels, 0)


@pytest.mark.slow
def test_resampled_flights_dock_about_as_often_as_the_flights_they_are_made_of(tmp_path):
    source = fly(MANUAL, range(60), record=[PREDICTION.name, COMMAND.name, STICK.name])
    shown, stick = source.history[PREDICTION.name], source.history[STICK.name]
    made = []
    for row in range(60):
        good = shown.valid[:, row] & np.isfinite(shown.state[:, row]).all(axis=1)
        made.append((shown.state[good, row], stick.command[good, row]))
    path = tmp_path / 'many.csv'
    path.write_text(text_of_responses(made, MANUAL.run.step_s))
    again = MANUAL.with_values('operator_model', form='recorded',
                               recorded__responses=str(path)).with_values('/**', seed=6)
    rate = fly(again, range(300)).verdict.success.mean()
    nobody = fly(MANUAL.with_values('/**', operator='none'), range(300)).verdict.success.mean()
    assert nobody < 0.05                        # so that docking at all is the pilot's doing
    assert 0.5*source.verdict.success.mean() < rate


BAD = {
    'no header': ('1,2,3\n', 'line 1: the header must be flight,step'),
    'no step': (','.join(COLUMNS) + '\n', 'no recorded step'),
    'too short': ('# step_s 0.5\n' + ','.join(COLUMNS) + '\n0,0,1\n', 'line 3: 11 columns'),
    'no number': ('# step_s 0.5\n' + ','.join(COLUMNS) + '\n0,0,x,0,0,0,0,0,0,0,0\n',
                  "line 3: a number expected, got 'x'"),
    'level 4': ('# step_s 0.5\n' + ','.join(COLUMNS) + '\n0,0,-9,0,0,0,0,0,0,4,0\n',
                'whole numbers from -3 to 3'),
}


@pytest.mark.parametrize('text, words', BAD.values(), ids=BAD)
def test_what_is_no_table_is_refused_in_one_line(tmp_path, text, words):
    (tmp_path / 'bad.csv').write_text(text)
    with pytest.raises(ValueError, match=words):
        read_responses(str(tmp_path / 'bad.csv'))


def test_a_scenario_without_a_table_or_with_other_steps_is_refused(table):
    bare = MANUAL.with_values('operator_model', form='recorded')
    with pytest.raises(ValueError, match='form recorded needs recorded.responses'):
        fly(bare, [0])
    fine = bare.with_values('operator_model', recorded__responses=table).with_values(
        '/**', step_s=0.1)
    with pytest.raises(ValueError, match='in steps of 0.5 s, the run has step_s 0.1'):
        fly(fine, [0])
    assert OperatorParams(form='recorded').selected == Recorded()


def test_the_command_refuses_what_holds_no_manual_flight(tmp_path, capsys):
    assert responses.main([str(tmp_path), '--out', str(tmp_path / 'x.csv')]) == 2
    assert 'no manual flight in' in capsys.readouterr().err
    assert responses.main([str(tmp_path / 'none'), '--out', str(tmp_path / 'x.csv')]) == 2
    assert 'no such folder' in capsys.readouterr().err


def test_a_shared_flight_is_no_response(flown):
    shared = MANUAL.with_values('/**', mode='shared')
    batch = fly(shared, [0], record=history.everything(shared))
    with pytest.raises(ValueError, match='not flown in mode manual'):
        responses.response(history.of_history(shared, batch, 0))
