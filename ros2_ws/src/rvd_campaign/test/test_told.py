"""Why a flight was given up is told by its folder, whatever its recorder had time to store."""

import json

import pytest
from rvd_interfaces.msg import RunEvent
from small_run import messages, write_run

from rvd_campaign.flight import verdict
from rvd_campaign.report.run import write_report
from rvd_campaign.report.told import once, Told, told_by
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.roster import NAMELESS

WHY = 'bag_recorder was ended by signal 9'
SILENT = 'link_back has given no sign of life for 2.1 s: it hangs'
GONE = 65                       # the step with which the recording ends


def cut_off(folder, *events):
    """Write a run whose recorder was killed; `events` are what `fly` had told it: code, text."""
    stored = [('/run/events', GONE - 1, RunEvent(node='rvd_fly', code=code, step=GONE - 1,
                                                 text=text)) for code, text in events]
    return write_run(folder, [item for item in messages() if item[1] < GONE
                              and item[0] != '/run/verdict'] + stored, close=False)


def told(run, **content):
    (run / 'verdict.json').write_text(json.dumps(content))


def report_of(run):
    return write_report(run).read_text()


def test_the_report_of_a_flight_whose_recorder_was_killed_says_why_it_ended(tmp_path):
    run = cut_off(tmp_path / 'run')
    assert 'given up' not in report_of(run)     # a bag alone
    told(run, given_up=WHY, silences=[{'t_s': 12.5, 'said': SILENT}])
    html = report_of(run)
    assert html.count(f'The flight was given up: {WHY}.') == 1
    assert html.count(f'At 12.5 s: {SILENT}.') == 1
    assert 'no verdict: the flight was given up' in html


def test_what_the_bag_tells_is_not_told_twice(tmp_path):
    run = cut_off(tmp_path / 'run', ('SILENT', SILENT), ('GIVEN_UP', WHY))
    told(run, given_up=WHY, silences=[{'t_s': 12.5, 'said': SILENT}])
    html = report_of(run)
    assert 'The flight was given up:' not in html
    assert html.count(f's: {SILENT}.') == html.count(f's: {WHY}.') == 1
    assert 'no verdict: the flight was given up' in html


def test_without_a_bag_the_refusal_of_a_report_says_why_there_is_none(tmp_path):
    told(tmp_path, given_up=WHY)
    with pytest.raises(BadInput, match=f'holds no bag.*the flight was given up: {WHY}'):
        write_report(tmp_path)
    (tmp_path / 'verdict.json').unlink()
    with pytest.raises(BadInput, match='in the folder$'):
        write_report(tmp_path)


@pytest.mark.parametrize('content', [
    {'given_up': ['x'], 'doubts': 'x', 'silences': 'x'}, {'silences': [None, 3, {}, {'t_s': 1.0}]},
    {'silences': [{'t_s': '1', 'said': 'x'}, {'t_s': 1.0, 'said': ['x']},
                  {'t_s': 10**400, 'said': 'x'}, {'t_s': 1e300, 'said': 'x'}]}, {}])
def test_what_is_no_such_file_of_ours_tells_nothing(tmp_path, content):
    told(tmp_path, **content)
    assert told_by(tmp_path / 'verdict.json') == Told([], '', [])


def test_a_flight_that_was_given_up_is_no_success_whatever_was_judged_by_then():
    for last in (None, verdict_that(final=False), verdict_that(final=True)):
        judged = verdict.outcome(last, problem=WHY)
        assert (judged.success, judged.reason) == (False, 'given_up')
        assert judged.words == WHY
    assert verdict.outcome(verdict_that(final=True)).success    # the same, not given up


def verdict_that(final):
    found = next(m for topic, _, m in reversed(list(messages())) if topic == '/run/verdict')
    found.final, found.success = final, True
    return found


def test_of_a_second_writer_the_name_is_said_by_whomever_it_was_seen():
    named, nameless = 'a second writer on /joy: node x', f'a second writer on /joy: {NAMELESS}'
    other = f'a second writer on /run/end: {NAMELESS}'
    assert once([nameless, named, other, named]) == [named, other]
    assert once([nameless, nameless]) == [nameless]


@pytest.mark.parametrize('reason, words', [
    ('interrupted', 'No verdict: ended from the console after'),
    ('aborted', 'No verdict: aborted, and ended from the console after')])
def test_a_flight_that_was_ended_from_the_console_says_so(tmp_path, reason, words):
    run = cut_off(tmp_path / 'run')
    assert 'No verdict: the recording ends before the run does' in report_of(run)
    told(run, reason=reason, ended_by=verdict.STOPPED)
    assert words in report_of(run)
    told(run, reason=reason, ended_by=7)        # not ours
    assert 'No verdict: the recording ends before the run does' in report_of(run)
