"""What the console shows of an aborted approach, held against what is then flown."""

import numpy as np
import pytest

from rvd_dynamics.commands.codes import KIND_ABORT
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, parse
from rvd_campaign.catalogue import root
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.provider import display_of
from rvd_groundstation.prediction.abort import Acting
from rvd_groundstation.prediction.predictor import Predictor

TRUTH, ESTIMATE, PREDICTION, COMMAND = ('/truth/relative_state', '/ground/estimate',
                                        '/ground/prediction', '/ground/command')
ABORT = 100                     # step
CASES = {'paper': '/**: {ros__parameters: {operator: model}}',
         'short steps': '/**: {ros__parameters: {operator: model, step_s: 0.1}}',
         'no delay': '/**: {ros__parameters: {operator: model, forward_delay_s: 0.0, '
                     'back_delay_s: 0.0}}'}


def shown(text, looks, abort=True):
    """Fly one approach; return the scenario, the truth (K, 6) and what is derived at `looks`."""
    scenario = parse(text, 'test')
    history = fly(scenario, [0], record=[TRUTH, ESTIMATE, PREDICTION, COMMAND],
                  schedule=[Change(ABORT, abort=True)] if abort else []).history
    feed, made = Feed(display_of(scenario)), {}
    legs, step_s = scenario.part('legs'), scenario.run.step_s
    sent = history[COMMAND]
    for k in range(max(looks) + 1):
        for name, at in ((ESTIMATE, k - legs.back), (PREDICTION, k + legs.forward)):
            state = history[name].state[k, 0]
            feed.signal(name, Sample(k, at * step_s, bool(np.isfinite(state).all()), {
                'position': state[:3].tolist(), 'velocity': state[3:].tolist()}))
        feed.command(Sample(k, k * step_s, True, {
            'value': sent.command[k, 0].tolist(), 'kind': int(sent.kind[k, 0]), 'by': 1,
            'weight': 1.0, 'reason': 0, 'sequence': k + 1}))
        if k in looks:
            made[k] = feed.derived()
    assert (sent.kind[ABORT, 0] == KIND_ABORT) == abort
    return scenario, history[TRUTH].state[:, 0], made


def worst(path, times, truth, begin, step_s):
    """Return the largest distance [m] of a path from the truth at `times` [s] after `begin`."""
    steps = begin + np.rint(times / step_s).astype(int)
    there = steps < len(truth)
    assert there.sum() > 3
    off = np.asarray(path)[there] - truth[steps[there], :3]
    return float(np.sqrt((off**2).sum(axis=1)).max())


@pytest.mark.parametrize('name', CASES)
def test_the_drift_that_is_shown_is_what_the_guard_flies(name):
    looks = [ABORT + 5, ABORT + 15, ABORT + 60]
    scenario, truth, made = shown(CASES[name], looks)
    step_s, forward = scenario.run.step_s, scenario.part('legs').forward
    for k in looks:
        drift = made[k]['drift']
        times = np.linspace(0.0, 240.0, len(drift))
        near = times < 40.0                     # errors of the estimate grow with time
        assert worst(np.array(drift)[near], times[near], truth, k + forward, step_s) < 0.6, k


def test_a_drift_that_knows_nothing_of_the_burn_leads_to_a_plane_that_is_never_reached(
        monkeypatch):
    """The negative twin: what was shown before."""
    from rvd_missions.lunar_approach.display import LunarDisplay
    _, truth, made = shown(CASES['paper'], [ABORT + 5])
    assert truth[:, 0].max() < -1.0 and made[ABORT + 5]['hit'] is None
    monkeypatch.setattr(LunarDisplay, '_push', lambda self, predicted: None)
    assert shown(CASES['paper'], [ABORT + 5])[2][ABORT + 5]['hit'] is not None


@pytest.mark.parametrize('name', ['paper', 'short steps'])
def test_the_way_ahead_is_what_acts_and_not_what_was_sent_before(name):
    scenario, truth, made = shown(CASES[name], [ABORT + 5, ABORT + 12])
    back, step_s = scenario.part('legs').back, scenario.run.step_s
    for k in (ABORT + 5, ABORT + 12):
        rows = made[k]['ahead']
        every = max(1, round(0.5 / step_s))
        times = (1 + np.arange(len(rows))) * every * step_s
        assert len(rows) > 10
        assert worst(rows, times, truth, k - back, step_s) < 0.4
    assert shown(CASES[name], [ABORT + 5], abort=False)[2][ABORT + 5]['ahead'] is None


def test_the_scene_stays_as_it_was_at_contact():
    scenario, truth, _ = shown(CASES['paper'], [3], abort=False)
    legs, step_s = scenario.part('legs'), scenario.run.step_s
    feed, last = Feed(display_of(scenario)), len(truth) - 1
    history = fly(scenario, [0], record=[PREDICTION]).history[PREDICTION].state[:, 0]
    for k in range(last + 1):
        if last - 12 < k < last - 8:            # a console that was held up for a while
            continue
        state = history[k]
        feed.signal(PREDICTION, Sample(k, (k + legs.forward) * step_s,
                                       bool(np.isfinite(state).all()), {
            'position': state[:3].tolist(), 'velocity': state[3:].tolist()}))
    after = feed.frame()['signals'][PREDICTION]['parts']['position'][0]
    contact = (last - 0.4) * step_s             # between two steps, as contact is
    feed.settle(contact)
    shown_now = feed.frame()['signals'][PREDICTION]
    assert shown_now['t'] == pytest.approx(contact) and after > 0.5     # behind the port
    assert abs(shown_now['parts']['position'][0]) < 0.2
    feed.signal(PREDICTION, Sample(last + 1, 999.0, True, {'position': [9.0, 0.0, 0.0],
                                                           'velocity': [0.0] * 3}))
    assert feed.frame()['signals'][PREDICTION]['t'] == pytest.approx(contact)


def test_ranges_have_a_sign():
    display = display_of(parse(CASES['paper'], 'test')).display
    of_range = next(row for row in display.instruments.rows if row.label == 'range')
    assert {reading.value.past for reading in of_range.readings} == {0}
    assert {reading.value.past for reading in display.camera.distance} == {0}


def predicted_off(name, step_of_abort=30, **shared):
    """Return the largest error [m] of the position predicted in the 60 s after an ABORT."""
    scenario = load(root() / 'scenarios' / f'{name}.yaml').with_values('/**', **shared)
    truth, forward = scenario.diagram.truth.name, scenario.part('legs').forward
    history = fly(scenario, [0], record=[truth, PREDICTION],
                  schedule=[Change(step_of_abort, abort=True)]).history
    state, flown = history[PREDICTION].state[:, 0, :3], history[truth].state[:, 0, :3]
    last = min(len(flown) - 1, step_of_abort + forward + round(60.0 / scenario.run.step_s))
    k = np.arange(step_of_abort + 1, last - forward)
    return float(np.nanmax(np.linalg.norm(state[k] - flown[k + forward], axis=-1)))


@pytest.mark.parametrize('name, shared', [
    ('ellipse', {'forward_delay_s': 20.0, 'back_delay_s': 20.0}),
    ('obstacles', {'forward_delay_s': 5.0, 'back_delay_s': 5.0})])
def test_every_mission_that_predicts_knows_what_the_guard_does(name, shared, monkeypatch):
    knows = predicted_off(name, **shared)
    monkeypatch.setattr(Acting, 'mean', lambda self, step, own: own)        # the negative twins:
    monkeypatch.setattr(Predictor, '_learn_of_abort', lambda self, emitted: None)   # as before
    assert predicted_off(name, **shared) > 3.0 * knows
