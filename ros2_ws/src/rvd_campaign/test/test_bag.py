"""A recorded run as arrays: what was published, also from a bag that was cut off."""

from dataclasses import fields
import re
import subprocess
import sys

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from rosbags.rosbag2 import Reader
import small_run
from small_run import HOLD, LAST, LOST, ROSTER, SCENARIO, write_run
from std_msgs.msg import String

from rvd_campaign.report import replay
from rvd_campaign.report.figures import figures_of
from rvd_campaign.report.run import page
from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.recording import reader
from rvd_dynamics.recording.reader import files_of, read
from rvd_dynamics.recording.recording import scenario_of
from rvd_dynamics.recording.series import Commands, Scores, SERIES, Sticks, Table
from rvd_interfaces.msg import Values

THRUST = '/onboard/thruster_command'


def topics_of(message):
    """Return the topics that carry messages of this type of ours."""
    return [topic for topic, kind in ROSTER.topics.items()
            if kind == f'rvd_interfaces/msg/{message}']


def sent_on(topic):
    """Return what was published on a topic, a message for each step."""
    return [small_run.step_messages(k)[topic] for k in range(LAST + 1)]


@pytest.fixture(scope='module')
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp('runs') / 'whole')


@pytest.fixture(scope='module')
def recording(run):
    return read(run)


def test_counts_are_those_of_an_independent_reader_and_of_what_was_published(run, recording):
    with Reader(run / 'bag') as opened:
        independent = {c.topic: c.msgcount for c in opened.connections}
    published = {}
    for topic, _, _ in small_run.messages():
        published[topic] = published.get(topic, 0) + 1
    assert recording.counts == independent
    assert {t: n for t, n in recording.counts.items() if n} == published


@pytest.mark.parametrize('topic', topics_of('RelativeState'))
def test_states_are_those_published(recording, topic):
    series, sent = recording.of(topic), sent_on(topic)
    assert_array_equal(series.step, range(LAST + 1))
    assert_array_equal(series.state, [small_run.as_state(m) for m in sent])
    assert_array_equal(series.valid, [m.valid for m in sent])
    assert_allclose(series.t, [m.header.stamp.sec + m.header.stamp.nanosec * 1e-9 for m in sent],
                    rtol=0, atol=1e-9)
    given = np.array([m.covariance for m in sent]).reshape(-1, 6, 6)
    known = ~np.isnan(given[:, 0, 0])
    assert_array_equal(series.covariance[known], given[known])
    assert np.isnan(series.covariance[~known]).all()


def test_truth_carries_the_executed_acceleration_and_nothing_else_does(recording):
    assert_array_equal(recording.of('/truth/relative_state').accel,
                       np.tile([0.01, 0, 0], (LAST + 1, 1)))
    assert np.isnan(recording.of('/ground/prediction').accel).all()


@pytest.mark.parametrize('topic', topics_of('ThrustCommand'))
def test_commands_are_those_published(recording, topic):
    series, sent = recording.of(topic), sent_on(topic)
    assert_array_equal(series.levels, [m.levels for m in sent])
    for field in ('valid', 'kind', 'sequence', 'decided_by', 'reason', 'pilot_weight'):
        assert_array_equal(getattr(series, field), [getattr(m, field) for m in sent])


def test_frames_tell_when_they_travelled(recording):
    frames = recording.of('/onboard/command')
    assert_array_equal(np.flatnonzero(frames.empty), [*range(HOLD), LOST + HOLD])
    assert np.isnan(frames.arrived[frames.empty]).all()
    kept = ~frames.empty
    assert_allclose((frames.released - frames.sent)[kept], 5.0)
    assert_allclose((frames.arrived - frames.sent)[kept], 4.2 + 1e-3 * frames.sequence[kept])


def test_links_go_by_their_legs_with_what_they_released_and_counted(recording):
    assert list(recording.links) == ['forward', 'back']
    forward, back = recording.links.values()
    assert forward.upward and not back.upward
    assert forward.hold_s == 5.0 and forward.frames is recording.of('/onboard/command')
    assert back.frames is recording.of('/ground/telemetry')
    assert forward.history.last['late'] == 1 and back.history.last['late'] == 0
    assert len(forward.history.counts['sent']) == LAST + 1
    assert_array_equal(forward.never_released, [LOST * 0.5])
    assert_array_equal(back.never_released, [])


def test_scores_stick_verdict_events_are_there(recording):
    score = recording.of('/ground/prediction_score')
    assert_allclose(score.error[score.valid][-1], small_run.ERROR)
    assert_array_equal(score.scored, range(LAST + 1))
    assert_allclose(recording.of('/joy').axes[4, :2], [1 / 3, (4 % 7 - 3) / 3], atol=1e-7)
    sent = from_message(small_run.step_messages(LAST)['/run/verdict'])
    assert repr(recording.verdict) == repr(sent)        # NaN too
    assert recording.verdict.reason == 'docked' and recording.judged
    assert recording.verdict.value('min_corridor_margin_m') == 0.188
    assert [e.code for e in recording.events] == ['REFUSED'] and recording.events[0].t == 27.5
    assert (recording.of(THRUST).reason == codes.REASON_CHECKSUM).sum() == 1


def test_a_series_is_found_by_signal_or_topic_and_has_no_rows_where_nothing_came(recording):
    signals = recording.scenario.diagram.signals
    assert recording.of(signals[THRUST]) is recording.of(THRUST)
    assert recording.of(signals['/joy'].shifted(1)) is recording.of('/joy')
    empty = recording.of(Signal('/nobody', (), signals['/joy'].message))
    assert isinstance(empty, Sticks) and len(empty) == 0
    assert recording.has('/joy') and not recording.has('/nobody')
    assert isinstance(recording.of('/nobody'), Table) and len(recording.of('/nobody')) == 0


def test_a_topic_of_another_type_than_the_signal_is_not_mistaken_for_it(recording):
    found = recording.of(Signal(THRUST, (), 'rvd_interfaces/msg/PredictionScore'))
    assert isinstance(found, Scores) and len(found) == 0
    assert isinstance(recording.of(THRUST), Commands)


def test_a_whole_run_misses_nothing(recording):
    assert recording.complete and recording.closed and recording.ended
    assert recording.last_step == LAST
    assert set(recording.missing.values()) == {0} and not recording.lost
    assert recording.name == recording.scenario.name == 'small'
    assert recording.scenario.run.seed == 7 and recording.scenario.part('legs').forward == HOLD
    assert recording.scenario_trouble == ''


def test_steps_that_are_not_in_the_bag_are_counted_by_topic(tmp_path):
    given = [m for m in small_run.messages()
             if not (m[0] == '/joy' and m[1] in (3, 4)) and
             not (m[0] == '/ground/prediction' and m[1] in (0, LAST))]
    found = read(write_run(tmp_path, given))
    assert {t: n for t, n in found.missing.items() if n} == {'/joy': 2, '/ground/prediction': 2}


@pytest.mark.parametrize('noted', [True, False])
def test_a_topic_that_the_run_owed_and_never_came_is_counted_too(noted, tmp_path):
    given = [m for m in small_run.messages() if m[0] != '/ground/estimate']
    notes = {'rvd_missing': dict.fromkeys(ROSTER.owed, '0')} if noted else None
    found = read(write_run(tmp_path, given, notes=notes))
    assert found.missing['/ground/estimate'] == LAST + 1


def test_what_a_slow_node_writes_is_owed_at_its_firings_only(tmp_path, monkeypatch):
    """Every fourth step, and one of these is gone."""
    given = [m for m in small_run.messages()
             if m[0] != '/joy' or (m[1] % 4 == 0 and m[1] != 8)]
    monkeypatch.setattr(reader.Roster, 'owed', {'/joy': 4, THRUST: 1})
    assert read(write_run(tmp_path, given)).missing == {'/joy': 1, THRUST: 0}


def test_a_bag_cut_at_any_byte_is_read_up_to_there(tmp_path):
    """R2: a prefix of whole messages, never an exception, and the loss is counted."""
    given = small_run.messages(24)
    whole = write_run(tmp_path / 'whole', given, close=False) / 'bag/bag_0.mcap'
    data = whole.read_bytes()
    cut = tmp_path / 'cut.mcap'
    before = -1
    for size in (*range(0, 200, 7), *range(200, len(data), 3571), len(data)):
        cut.write_bytes(data[:size])
        found = read(cut)
        total = sum(found.counts.values())
        assert before <= total <= len(given)
        before = total
        assert not found.complete and not found.closed and not found.ended
        truth = found.of('/truth/relative_state')
        assert_array_equal(truth.state if len(truth) else np.zeros((0, 6)),
                           [small_run.true_state(k) for k in range(len(truth))]
                           or np.zeros((0, 6)))
        assert all(n in (0, 1) for n in found.missing.values())     # of the step it was cut in
    assert total == len(given)


def test_a_run_without_messages_has_arrays_without_rows(tmp_path):
    found = read(write_run(tmp_path, []))
    assert found.last_step == -1 and found.scenario is None
    assert found.links['forward'].history.last == {}
    assert found.verdict is None and not found.judged
    for topic, kind in ROSTER.topics.items():
        series = found.of(topic)
        assert type(series) is SERIES.get(kind, Table) and len(series) == 0
        for field in fields(series):
            value = getattr(series, field.name)
            for column in value.values() if isinstance(value, dict) else [value]:
                assert len(column) == 0


def test_what_is_no_bag_is_one_sentence(tmp_path):
    with pytest.raises(ValueError, match='holds no bag'):
        read(tmp_path)


def test_run_folder_bag_folder_and_file_are_the_same_bag(run):
    assert files_of(run) == files_of(run / 'bag') == files_of(run / 'bag/bag_0.mcap')


# -- signals without a message of their own --------------------------------------------------------

def values(k, numbers, layout='rate[3], angle[2,2], armed'):
    return Values(header=header_at(k * small_run.STEP_NS, 'body'), step=k, layout=layout,
                  values=[float(n) for n in numbers])


@pytest.fixture
def with_values(tmp_path):
    """Return what writes a run with Values on a topic and reads it."""
    def written(given):
        added = [('/onboard/attitude', m.step, m) for m in given]
        return read(write_run(tmp_path, [*small_run.messages(3), *added],
                              kinds={'/onboard/attitude': 'rvd_interfaces/msg/Values'}))
    return written


def test_values_are_a_table_of_their_parts(with_values):
    table = with_values([values(k, [k, 1, 2, 3, 4, 5, 6, k % 2]) for k in range(3)]
                        ).of('/onboard/attitude')
    assert list(table.parts) == ['rate', 'angle', 'armed']
    assert_array_equal(table.step, range(3))
    assert_allclose(table.t, [0.0, 0.5, 1.0])
    assert_array_equal(table['rate'], [[k, 1, 2] for k in range(3)])
    assert_array_equal(table['angle'], [[[3, 4], [5, 6]]] * 3)
    assert_array_equal(table['armed'], [0, 1, 0])
    with pytest.raises(LookupError, match="no part 'rte' was recorded; there are: rate, angle"):
        table['rte']


@pytest.mark.parametrize('last', [values(1, range(7)), values(1, range(8), 'rate[8]')])
def test_values_whose_layout_changes_are_refused_when_somebody_looks(with_values, last):
    found = with_values([values(0, range(8)), last])
    assert found.last_step == 2
    with pytest.raises(ValueError, match='/onboard/attitude: step 1: [78] values of layout'):
        found.of('/onboard/attitude')


# -- other versions, other missions ----------------------------------------------------------------

def test_a_bag_of_a_mission_that_is_not_installed_gives_what_it_can(tmp_path):
    text = SCENARIO.replace('mode: shared', 'mission: of_tomorrow')
    given = [('/run/scenario', 0, String(data=text)), *small_run.messages()[1:]]
    found = read(write_run(tmp_path, given, notes={'rvd_missing': {'/joy': '3'}}))
    assert found.scenario is None and "no mission 'of_tomorrow'" in found.scenario_trouble
    assert found.name == 'small' and found.last_step == LAST
    assert found.verdict.reason == 'docked' and len(found.events) == 1
    assert found.missing == {'/joy': 3} and found.counts['/joy'] == LAST + 1
    assert {name: link.history.last['late'] for name, link in found.links.items()} == {
        'forward': 1, 'back': 0}
    assert len(found.of('/truth/relative_state')) == LAST + 1       # the types are ours


def test_a_bag_of_a_mission_that_is_not_installed_may_be_cut_off(tmp_path):
    given = [('/run/scenario', 0, String(data='/**: {ros__parameters: {mission: of_tomorrow}}')),
             *small_run.messages(20)[1:]]
    found = read(write_run(tmp_path, given, close=False))
    assert (found.last_step, found.missing, found.ended) == (19, {}, False)


@pytest.mark.parametrize('text, why', [
    ('', 'holds no scenario'), ('not: [yaml', 'not valid YAML'),
    ('/*: {ros__parameters: {mission: tether}}',
     r'names no mission, and lunar_approach has no node \*'),
    ('arm: {ros__parameters: {a: 1}}', 'names no mission, and lunar_approach has no node arm'),
    ('/**: {ros__parameters: {seed: 1}}\narm: {ros__parameters: {a: 1}}', 'no node arm'),
    ('{}', 'names no mission and holds nothing'),
    ('/**: 3', 'must hold ros__parameters'), ('/**: {ros__parameters: {step_s: 90}}', 'step_s')])
def test_a_scenario_that_cannot_be_read_is_none_and_says_why(text, why):
    scenario, trouble = scenario_of(text)
    assert scenario is None and re.search(why, trouble) and '\n' not in trouble


def test_a_bag_whose_scenario_cannot_be_told_is_shown_as_no_mission(tmp_path):
    """Not by the figures and limits of the default one."""
    text = SCENARIO.replace('/**:', '/*:')
    found = read(write_run(tmp_path, [('/run/scenario', 0, String(data=text)),
                                      *small_run.messages()[1:]]))
    assert found.scenario is None and 'names no mission' in found.scenario_trouble
    assert figures_of(found) == {}
    assert 'There are no figures: scenario' in page(found)
    (tmp_path / 'verdict.json').write_text('{}')
    with pytest.raises(ValueError, match='names no mission'):
        replay.load(tmp_path.parent, tmp_path.name)


def test_a_scenario_from_before_there_were_missions_is_of_the_first():
    scenario, trouble = scenario_of('/**: {ros__parameters: {seed: 3, gone: 1}}\n'
                                    'auto_controller: {ros__parameters: {law: none}}')
    assert scenario.mission.name == 'lunar_approach' and 'gone' in trouble


def test_a_scenario_of_another_version_is_read_as_far_as_it_is_known():
    scenario, trouble = scenario_of(
        '/**: {ros__parameters: {mission: lunar_approach, step_s: 0.1, of_tomorrow: 1, '
        'forward_delay_s: 2, corridor: {half_angle_deg: 4.0}}}\n'
        'next_node: {ros__parameters: {a: 1}}')
    assert (scenario.run.step_s, scenario.part('legs').forward,
            scenario.part('cone').half_angle_deg) == (0.1, 20, 4)
    assert trouble == 'this version does not know /**: of_tomorrow, next_node'


@pytest.mark.parametrize('mode', [None, 'file', 'message'])
def test_a_bag_converted_to_sqlite_is_the_same_recording(run, recording, mode, tmp_path):
    converter = [sys.executable, '-m', 'rosbags.convert', '--src', run / 'bag', '--dst',
                 tmp_path / 'bag', '--dst-storage', 'sqlite3']
    packed = ['--compress', 'zstd', '--compress-mode', mode] if mode else []
    subprocess.run(converter + packed, check=True)
    found = read(tmp_path)
    assert found.counts == recording.counts and found.complete
    assert found.scenario_text == recording.scenario_text and found.last_step == LAST
    for topic in recording.series:
        assert repr(found.of(topic)) == repr(recording.of(topic))
