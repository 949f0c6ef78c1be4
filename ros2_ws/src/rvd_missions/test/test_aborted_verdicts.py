"""A run in which an ABORT came into force was aborted, in every mission; nothing else is new."""

from math import nan

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.diagram.aborts import Aborts
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.judge import aborted, ABORTED, judgement, Verdict
from rvd_dynamics.diagram.in_process import judge_of
from rvd_dynamics.diagram.mission import installed
from rvd_dynamics.diagram.scenario import load
from rvd_campaign.catalogue import root

MISSIONS = {                    # a scenario of each, and what makes it short
    'paper': {'timeout_s': 30.0}, 'ellipse': {'timeout_s': 30.0}, 'obstacles': {'timeout_s': 30.0},
    'tether': {'timeout_s': 100.0}, 'tether_delay': {'timeout_s': 100.0},
    'attitude': {'timeout_s': 30.0, 'limits__window_s': 10.0},
    'docking': {'timeout_s': 2.0, 'limits__from_s': 1.0}}

LONG = ('docking', 'tether', 'tether_delay')    # to compile and to fly


def short(name):
    return load(root() / 'scenarios' / f'{name}.yaml').with_values('/**', **MISSIONS[name])


def test_every_mission_is_here():
    assert {short(name).mission.name for name in MISSIONS} == set(installed())


@pytest.mark.parametrize('name', [pytest.param(name, marks=(
    (pytest.mark.slow, pytest.mark.patient) if name in LONG else ())) for name in MISSIONS])
def test_an_abort_is_the_reason_in_every_mission(name):
    scenario = short(name)
    step = round(min(5.0, 0.25 * scenario.run.timeout_s) / scenario.run.step_s)
    batch = fly(scenario, [0], schedule=[Change(step, abort=True)])
    told = judgement(judge_of(scenario), batch.verdict, 0)
    since = batch.verdict.happened[0]           # what it was sent in, or a delay after that
    assert step <= since / scenario.run.step_s < batch.end_step[0]
    assert (told.success, told.reason, told.words) == (
        False, ABORTED, f'aborted at {since:.1f} s')
    assert told.headline == f'failed: {told.words}; the run ended after {told.duration:.1f} s'
    usual = fly(scenario, [0])
    assert usual.verdict.reason[0] != ABORTED


def test_what_is_measured_is_what_it_was():
    scenario = short('paper')
    batch = fly(scenario, [0, 1, 2], record=True, schedule=[Change(20, abort=True)])
    judge, truth = judge_of(scenario, (3,), [0, 1, 2]), batch.history['/truth/relative_state']
    for k in range(int(batch.end_step.max()) + 1):
        judge.follow(k, type(truth)(*(None if part is None else part[k] for part in truth)))
    alone = judge.verdict()
    assert set(alone.reason) == {'timeout'}     # the truth alone
    assert set(batch.verdict.reason) == {ABORTED}
    np.testing.assert_array_equal(batch.verdict.duration, alone.duration)
    for name, values in alone.values.items():
        np.testing.assert_array_equal(batch.verdict.values[name], values, err_msg=name)


def test_an_abort_that_comes_too_late_to_act_changes_nothing():
    """One asked for in the final step is in force in none; in a row that has ended, neither."""
    scenario = load(root() / 'scenarios' / 'paper.yaml')
    usual = fly(scenario, range(20))
    first = int(usual.end_step.min())
    assert len(set(usual.end_step.tolist())) > 1
    late = fly(scenario, range(20), schedule=[Change(first, abort=True)])
    over = usual.end_step == first
    assert list(late.verdict.reason[over]) == list(usual.verdict.reason[over])
    assert ABORTED not in set(usual.verdict.reason)


def test_a_verdict_of_one_run_keeps_plain_numbers():
    plain = Verdict(True, 'docked', 12.0, {})
    assert aborted(plain, nan) is plain
    assert aborted(plain, 4.5) == Verdict(False, ABORTED, 12.0, {}, 4.5)
    assert aborted(plain._replace(reason='', success=False), 4.5).reason == ''     # under way
    rows = aborted(Verdict(np.array([True, True]), np.array(['docked', 'docked']), 1.0, {}),
                   np.array([nan, 4.5]))
    assert rows.reason.tolist() == ['docked', ABORTED] and rows.success.tolist() == [True, False]
    assert_array_equal(rows.happened, [nan, 4.5])


@pytest.mark.parametrize('said, since', [
    ([('event', 4, 'ABORT'), ('board', 9, True)], 4.5),
    ([('board', 9, True), ('event', 4, 'ABORT')], 4.5),     # in any order
    ([('board', 9, True)], nan),                           # nobody asked: the craft's own
    ([('event', 4, 'ABORT')], nan),                        # it has not come through
    ([('event', 4, 'MODE'), ('board', 9, True)], nan),
    ([('event', 4, 'ABORT'), ('board', 9, False)], nan),
    ([('event', 4, 'ABORT'), ('board', 20, True)], nan),   # what acts after the end
    ([('event', 20, 'ABORT'), ('board', 9, True)], nan)])
def test_it_was_in_force_if_asked_for_and_obeyed_before_the_end(said, since):
    aborts = Aborts(0.5)
    for what, step, value in said:
        getattr(aborts, what)(step, value)
    assert_array_equal(aborts.since(20), since)
