"""A recorded run as arrays: what was published, also from a bag that was cut off."""

from dataclasses import fields

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
from rosbags.rosbag2 import Reader
import small_run
from small_run import HOLD, LAST, LOST, write_run

from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.recording import reader
from rvd_dynamics.recording.reader import files_of, mission_of, read
from rvd_dynamics.commands import codes


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


@pytest.mark.parametrize('name, topic', reader.STATES.items())
def test_states_are_those_published(recording, name, topic):
    series = getattr(recording, name)
    sent = [small_run.step_messages(k)[topic] for k in range(LAST + 1)]
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
    assert_array_equal(recording.truth.accel, np.tile([0.01, 0, 0], (LAST + 1, 1)))
    assert np.isnan(recording.prediction.accel).all()


@pytest.mark.parametrize('name, topic', reader.COMMANDS.items())
def test_commands_are_those_published(recording, name, topic):
    series = getattr(recording, name)
    sent = [small_run.step_messages(k)[topic] for k in range(LAST + 1)]
    assert_array_equal(series.levels, [m.levels for m in sent])
    for field in ('valid', 'kind', 'decided_by', 'reason', 'pilot_weight'):
        assert_array_equal(getattr(series, field), [getattr(m, field) for m in sent])


def test_frames_tell_when_they_travelled(recording):
    frames = recording.command_frames
    assert_array_equal(np.flatnonzero(frames.empty), [*range(HOLD), LOST + HOLD])
    assert np.isnan(frames.arrived[frames.empty]).all()
    kept = ~frames.empty
    assert_allclose((frames.released - frames.sent)[kept], 5.0)
    assert_allclose((frames.arrived - frames.sent)[kept], 4.2 + 1e-3 * frames.sequence[kept])


def test_links_scores_stick_verdict_events_are_there(recording):
    assert recording.forward.last['late'] == 1 and recording.back.last['late'] == 0
    assert len(recording.forward.counts['sent']) == LAST + 1
    assert_allclose(recording.score.error[recording.score.valid][-1], small_run.ERROR)
    assert_allclose(recording.joy.axes[4, :2], [1 / 3, (4 % 7 - 3) / 3], atol=1e-7)
    sent = from_message(small_run.step_messages(LAST)['/run/verdict'])
    assert repr(recording.verdict) == repr(sent)        # NaN too
    assert recording.verdict.reason == 'docked' and recording.judged
    assert recording.verdict.value('min_corridor_margin_m') == 0.188
    assert [e.code for e in recording.events] == ['REFUSED'] and recording.events[0].t == 27.5
    assert (recording.onboard.reason == codes.REASON_CHECKSUM).sum() == 1


def test_a_whole_run_misses_nothing(recording):
    assert recording.complete and recording.closed and recording.ended
    assert recording.last_step == LAST
    assert set(recording.missing.values()) == {0} and not recording.lost
    assert recording.mission.seed == 7 and recording.mission.forward_steps == HOLD


def test_steps_that_are_not_in_the_bag_are_counted_by_topic(tmp_path):
    given = [m for m in small_run.messages()
             if not (m[0] == '/joy' and m[1] in (3, 4)) and
             not (m[0] == '/ground/prediction' and m[1] in (0, LAST))]
    found = read(write_run(tmp_path, given))
    assert {t: n for t, n in found.missing.items() if n} == {'/joy': 2, '/ground/prediction': 2}


def test_a_topic_that_the_run_owed_and_never_came_is_counted_too(tmp_path):
    given = [m for m in small_run.messages() if m[0] != '/ground/estimate']
    owed = {topic: '0' for topic in reader.OWED}
    found = read(write_run(tmp_path, given, notes={'rvd_missing': owed}))
    assert found.missing['/ground/estimate'] == LAST + 1


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
        assert_array_equal(found.truth.state,
                           [small_run.true_state(k) for k in range(len(found.truth.step))]
                           or np.zeros((0, 6)))
        assert all(n in (0, 1) for n in found.missing.values())     # of the step it was cut in
    assert total == len(given)


def test_a_run_without_messages_has_arrays_without_rows(tmp_path):
    found = read(write_run(tmp_path, []))
    assert found.last_step == -1 and found.forward.last == {}
    assert found.verdict is None and not found.judged
    for field in fields(found):
        value = getattr(found, field.name)
        for inner in (getattr(value, f.name) for f in fields(value)) if hasattr(
                value, '__dataclass_fields__') else ():
            if isinstance(inner, np.ndarray):
                assert len(inner) == 0


def test_what_is_no_bag_is_one_sentence(tmp_path):
    with pytest.raises(ValueError, match='holds no bag'):
        read(tmp_path)


def test_run_folder_bag_folder_and_file_are_the_same_bag(run):
    assert files_of(run) == files_of(run / 'bag') == files_of(run / 'bag/bag_0.mcap')


@pytest.mark.parametrize('text', [
    '', 'not: [yaml', '/**: 3', '/**: {ros__parameters: {step_s: 9}}'])
def test_a_scenario_that_cannot_be_read_gives_the_defaults(text):
    assert mission_of(text).step_s == 0.5


def test_a_scenario_of_another_version_is_read_as_far_as_it_is_known():
    mission = mission_of('/**: {ros__parameters: {step_s: 0.1, of_tomorrow: 1, '
                         'forward_delay_s: 2, corridor: {half_angle_deg: 4.0}}}')
    assert (mission.step_s, mission.forward_steps, mission.corridor.half_angle_deg) == (0.1, 20, 4)
