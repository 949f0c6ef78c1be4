"""A second writer on a topic of a flight: named within a second, and the flight is not believed."""

from dataclasses import replace
import os
import re
import time
from types import SimpleNamespace

from diagnostic_msgs.msg import DiagnosticArray
import pytest
from rclpy.context import Context
from rclpy.node import Node
from rclpy.serialization import serialize_message
from runs import in_flight, messages, ROOT, verdict_of, wait_for
from std_msgs.msg import Bool, UInt64
from test_by_hand import Hand

from rvd_campaign.flight import fly, second_opinion, stick, verdict
from rvd_campaign.flight.domain import reserved_domain
from rvd_campaign.flight.supervisor import Supervisor
from rvd_campaign.flight.watch import FlightWatch
from rvd_campaign.report.attempt import attempt
from rvd_campaign.report.run import page
from rvd_dynamics import verdict_line
from rvd_dynamics.commands.levels import StickParams
from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.roster import Roster, SECOND_WRITER
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.messages import files_of, MessageFile
from rvd_dynamics.recording.reader import newest, read
from rvd_dynamics.recording.recording import Event
from rvd_dynamics.verdict_line import Message, VerdictLine
from rvd_interfaces.msg import RelativeState, RunEvent, Verdict
from rvd_missions.tether import optimum

TRUTH = '/truth/relative_state'
DOCKED = Verdict(step=9, final=True, success=True, reason='docked', words='docked', duration=4.5)


@pytest.fixture
def flying(start, monkeypatch):
    """Return a starter of flights in real time, in a domain that this test knows."""
    with reserved_domain() as number:
        domain = int(number)
    monkeypatch.setattr('runs.environment', lambda: {
        **os.environ, 'RVD_ROOT': str(ROOT), 'ROS_DOMAIN_ID': str(domain)})

    def fly(*args):
        return start('fly', '--headless', '--pace', '2', '--out', 'run', *args)
    fly.domain = domain
    return fly


class Forger:
    """A node that writes where it must not, from this process."""

    def __init__(self, domain, name):
        self.context = Context()
        self.context.init(domain_id=domain)
        self.node = Node(name, context=self.context, enable_rosout=False)

    def write(self, topic, message, seconds=0.3, seen=None, over=lambda: False):
        """
        Announce a writer, write once, and take the writer away again; or when it is `seen`.

        A flight may have noticed and ended (`over`) before he has found a reader, which takes him
        up to 3 s where a packet is lost: one in ten times it was so.
        """
        publisher = self.node.create_publisher(type(message), topic, qos.of(topic))
        wait_for(lambda: publisher.get_subscription_count() or over(), f'a reader of {topic}')
        publisher.publish(message)
        time.sleep(seconds)
        if seen is not None:
            wait_for(seen, 'a word on the writer')
        self.node.destroy_publisher(publisher)

    def close(self):
        self.node.destroy_node()
        self.context.try_shutdown()


# -- a flight -------------------------------------------------------------------------------------

@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('topic, message, name, seconds', [
    ('/run/verdict', DOCKED, 'forger', 0.3),
    ('/run/pause', Bool(data=True), 'command_blender', 0.3),
    ('/run/pause', Bool(data=False), 'forger', 0.0)])
def test_a_writer_that_lives_a_moment_ends_the_flight_as_not_to_be_trusted(
        topic, message, name, seconds, flying, tmp_path):
    """
    Also one with the name of the node that is to write there; a forged verdict is no verdict.

    And who leaves at once: his name may not be known, the trace that he leaves is.
    """
    process = flying()
    in_flight(tmp_path / 'run', 2)
    forger = Forger(flying.domain, name)
    try:
        began = time.time_ns()
        forger.write(topic, message, seconds, over=lambda: process.poll() is not None)
        assert process.wait(60.0) == 2
    finally:
        forger.close()
    out, told = (tmp_path / 'out').read_text(), verdict_of(tmp_path / 'run')
    words, = told['doubts']                     # on a machine with other work it has no name yet
    assert re.fullmatch(f'a second writer on {topic}: '
                        f'((another )?node {name}|a node without a name)', words)
    assert f'rvd fly: not to be trusted: {words}\n' in out and 'docked' not in out, out
    assert (told['success'], told['reason'], told['trusted']) == (False, 'untrusted', False)
    assert told['bag_agrees'] is None
    said = [m for m in messages(tmp_path / 'run', '/run/events') if m.code == SECOND_WRITER]
    assert {m.node for m in said} <= {'mission_monitor', 'rvd_fly', 'bag_recorder'}
    assert len({m.text for m in said}) == len(said) >= 1        # each once, whoever came first
    assert all(f'a second writer on {topic}: ' in m.text for m in said)
    assert f'Not to be trusted: {words}.' in (tmp_path / 'run' / 'report.html').read_text()
    (tmp_path / 'run' / 'verdict.json').unlink()        # the bag alone says it, too
    assert f'Not to be trusted: {said[-1].text}.' in page(read(tmp_path / 'run'))
    noticed = min(stored.publish_ns for file in files_of(tmp_path / 'run')
                for stored in MessageFile(file, {'/run/events'})
                if stored.message.code == SECOND_WRITER)
    assert noticed - began < 10e9               # on a machine that has time for it, 0.2 s


@pytest.mark.slow
@pytest.mark.patient
def test_who_says_how_he_is_beside_a_flight_does_not_end_it(flying, tmp_path):
    """The twin: on /diagnostics programs of any make write; it is said, and flown on."""
    (tmp_path / 'short.yaml').write_text('/**: {ros__parameters: {timeout_s: 60.0}}')
    process = flying('short.yaml', '--pace', '10')
    in_flight(tmp_path / 'run', 2)
    guest = Forger(flying.domain, 'guest')
    try:
        out, words = tmp_path / 'out', 'a second writer on /diagnostics: '
        guest.write('/diagnostics', DiagnosticArray(), 0.5,
                    lambda: words in out.read_text() or process.poll() is not None)
        assert process.wait(90.0) == 1
    finally:
        guest.close()
    told = verdict_of(tmp_path / 'run')
    assert told['trusted'] and told['doubts'] == [] and told['bag_agrees'] is True
    assert words in out.read_text()
    assert 'Not to be trusted' not in (tmp_path / 'run' / 'report.html').read_text()


@pytest.mark.slow
@pytest.mark.patient
def test_a_run_that_was_started_by_hand_is_told_by_its_monitor_and_goes_on(tmp_path):
    (tmp_path / 's.yaml').write_text(
        '/**: {ros__parameters: {pace: realtime, operator: none, mode: auto, processes: segments}}')
    hand = Hand(tmp_path / 's.yaml')
    try:
        events, truth = hand.listen('/run/events', RunEvent), hand.listen(TRUTH, RelativeState)
        hand.start('mission_monitor')
        hand.start_ring()
        hand.until(lambda: len(truth) > 2, 'three steps')
        assert [e.text for e in events if e.code == SECOND_WRITER] == []
        hand.node.create_publisher(UInt64, '/run/end', qos.of('/run/end'))
        hand.until(lambda: [e for e in events if e.code == SECOND_WRITER], 'the event')
        steps = len(truth)
        hand.until(lambda: len(truth) > steps + 2, 'three steps more')
        # Who reads there has its own word for it: without the page of a run nobody else hears it.
        told = {(e.node, e.text) for e in events if e.code == SECOND_WRITER}
        nameless = 'a second writer on /run/end: a node without a name'
        assert {(node, text) for node, text in told if text != nameless} == {
            ('mission_monitor', 'a second writer on /run/end: node test_hand')}
        assert 'mission_monitor' not in {node for node, text in told if text == nameless}
    finally:
        hand.close()


# -- the verdict, and the judge asked again -------------------------------------------------------

def test_the_final_verdict_is_that_of_the_line_whatever_is_on_the_topic(own_domain):
    lines = []
    watch = FlightWatch(Roster(load(ROOT / 'scenarios' / 'paper.yaml')), own_domain, '/',
                        lambda: lines)
    try:
        watch.ready.add('spacecraft_dynamics')
        watch._on_verdict(DOCKED)
        assert watch.verdict is None            # anybody may have said it
        under_way = Verdict(step=7)
        watch._on_verdict(under_way)
        assert watch.verdict is under_way
        final = Verdict(step=9, final=True, reason='timeout')
        lines.append(Message(verdict_line.VERDICT, serialize_message(final)))
        watch._on_verdict(DOCKED)
        assert watch.verdict.reason == 'timeout' and watch.verdict.final
        lines.append(Message(verdict_line.STRANGER, b'a second writer on /joy: node x'))
        assert watch.strangers == ['a second writer on /joy: node x']
    finally:
        watch.close()


def test_a_forged_verdict_in_the_bag_is_none_of_the_flight(monkeypatch):
    """The line is silent: its judge has died."""
    flight = object.__new__(fly.Flight)
    flight._roster = SimpleNamespace(diagram=SimpleNamespace(legs=list))
    flight._run_dir, flight._watch = None, SimpleNamespace(verdict=None)
    monkeypatch.setattr(fly.reader, 'newest', lambda *_: {'/run/verdict': DOCKED})
    assert flight._outcome() == (None, {})


def test_what_is_told_by_the_line_is_taken_whole_or_not_at_all(monkeypatch):
    line = VerdictLine()
    monkeypatch.setenv(verdict_line.VARIABLE, str(line.writes))
    try:
        assert line.heard() == []
        os.write(line.writes, b'V' + (3).to_bytes(4, 'little') + b'ab')
        assert line.heard() == []
        os.write(line.writes, b'c')
        verdict_line.tell(b'S', b'')
        verdict_line.tell(b'S', b'more')
        monkeypatch.setenv(verdict_line.VARIABLE, '99999')
        verdict_line.tell(b'V', b'into nothing')
    finally:
        line.handed_over()
        line.close()
    assert line.heard() == [(b'V', b'abc'), (b'S', b''), (b'S', b'more')]


def test_nobody_waits_for_a_line_that_nobody_reads(monkeypatch):
    line = VerdictLine()
    monkeypatch.setenv(verdict_line.VARIABLE, str(line.writes))
    verdict_line.tell(b'V', b'x'*10_000_000)
    line.handed_over()
    line.close()


def test_the_judge_says_the_same_over_the_bag_and_says_so_where_it_does_not(flight):
    scenario = read(flight.run).scenario
    told = newest(flight.run, ['/run/verdict'])['/run/verdict']
    assert second_opinion.asked(flight.run, scenario, told, []) == (
        [], {'trusted': True, 'doubts': [], 'bag_agrees': True, 'bag_says': ''})
    assert verdict_of(flight.run)['bag_agrees'] is True
    failed = Verdict(final=True, reason='timeout', words='too slow', duration=4.5)
    doubts, trust = second_opinion.asked(flight.run, scenario, failed, [])
    assert 'failed: too slow; the run ended after 4.5 s' in doubts[0]
    assert 'docked after' in doubts[0]
    assert trust['bag_agrees'] is False
    assert (trust['success'], trust['reason']) == (False, verdict.UNTRUSTED)
    told.measures[0].value += 1e-3
    doubts, _ = second_opinion.asked(flight.run, scenario, told, [])
    assert told.measures[0].name in doubts[0]


@pytest.mark.parametrize('change, why', [
    (lambda rows: rows[:-1], 'ends at step'), (lambda rows: rows[:5] + rows[4:], 'from step 4 to'),
    (lambda rows: rows[:5] + rows[6:], 'from step 4 to step 6'), (lambda rows: [], 'step -1')])
def test_a_bag_without_every_truth_once_is_no_second_opinion(change, why, flight, monkeypatch):
    rows = [stored for file in files_of(flight.run)
            for stored in MessageFile(file, {TRUTH})]
    monkeypatch.setattr(second_opinion, 'files_of', lambda _: [None])
    monkeypatch.setattr(second_opinion, 'MessageFile', lambda *_: change(rows))
    told = newest(flight.run, ['/run/verdict'])['/run/verdict']
    doubts, trust = second_opinion.asked(flight.run, read(flight.run).scenario, told, [])
    assert doubts == [] and trust['bag_agrees'] is None and why in trust['bag_says']


def test_what_the_judge_plans_for_the_end_is_there_when_it_is_asked_again(monkeypatch):
    """It takes a second; nodes end meanwhile. What fails is told by who needs it."""
    optimum.plan.cache_clear()
    second_opinion.prepare(load(ROOT / 'scenarios' / 'tether.yaml'))
    assert optimum.plan.cache_info().currsize == 1
    monkeypatch.setattr(second_opinion, 'judge_of', lambda _: 1/0)
    second_opinion.prepare(load(ROOT / 'scenarios' / 'tether.yaml'))


# -- what comes from messages does nothing to a terminal ------------------------------------------

EVIL = '\x1b[2J\x1b]0;title\x07\u202egnp.exe\rdocked\n'


def test_words_of_messages_and_logs_do_nothing_to_a_terminal(monkeypatch, tmp_path, capsys):
    flight = object.__new__(fly.Flight)
    flight._run, flight._headless, flight._on_line = SimpleNamespace(step_s=0.5), False, False
    flight._shown_at, flight._shown = -1e9, ''
    flight._watch = SimpleNamespace(
        new_events=lambda: [RunEvent(step=2, node=EVIL, text=EVIL)], steps=1,
        line=lambda: f't 1.0 s {EVIL}')
    flight._show()
    told = capsys.readouterr().out
    assert told.count('\n') == 2 and 'gnp.exe' in told
    log = tmp_path / 'logs' / 'guard.log'
    log.parent.mkdir()
    log.write_text(f'{EVIL}the end {EVIL.strip()}')
    supervisor = object.__new__(Supervisor)
    supervisor.run_dir = tmp_path
    words = [told, supervisor.last_words('guard'), verdict.in_words(from_message(Verdict(
        success=True, reason=EVIL, words=EVIL, duration=1.0)))]
    for text in words:
        assert 'docked' in text
        assert all(c.isprintable() or c == '\n' for c in text), ascii(text)


def test_nor_do_the_name_of_a_stick_and_what_a_report_fails_of(tmp_path, capsys):
    def fails(folder):
        raise RuntimeError(EVIL)
    attempt(fails, tmp_path, tmp_path / 'log')
    stick.show(lambda: None, StickParams(), EVIL, True)
    told = capsys.readouterr()
    for text in (told.err.partition('\n')[0], told.out.partition('\n')[0]):
        assert 'gnp.exe' in text and text.isprintable(), ascii(text)


def test_verdict_json_and_report_hold_no_raw_control_character(tmp_path, flight):
    run = replace(read(flight.run), events=(Event(1, 0.5, EVIL, 'X', f'<script>{EVIL}'),))
    shown = page(run, [EVIL])
    assert '<script>' not in shown and 'gnp.exe' in shown
    assert all(c.isprintable() or c == '\n' for c in shown)
    verdict.write(tmp_path / 'verdict.json', {'doubts': [EVIL]})
    assert (tmp_path / 'verdict.json').read_text().isprintable() or all(
        c.isprintable() or c == '\n' for c in (tmp_path / 'verdict.json').read_text())
