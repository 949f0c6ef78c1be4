"""The recorder as a process: everything published is in the bag, in order, however it ends."""

import os
from pathlib import Path
import signal
import subprocess
import sys
import time

from geometry_msgs.msg import PointStamped
from mcap.records import Channel, Footer, Message
import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.serialization import deserialize_message, serialize_message
from rosbags.rosbag2 import Reader
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy
from std_msgs.msg import String, UInt64

from rvd_dynamics import pulse
from rvd_dynamics.pulse import Pulse
from rvd_dynamics.recording import mcap_file
from rvd_dynamics.recording.bag_writer import repair
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.conversions import header_at, time_at
from rvd_dynamics.diagram.roster import Roster, SECOND_WRITER
from rvd_dynamics.diagram.scenario import parse
from rvd_interfaces.msg import LinkFrame, RelativeState, RunEvent

STEP_NS = 500_000_000
FRAME = 'target_lvlh'
RECORDER = [sys.executable, '-c', 'from rvd_dynamics.diagram.ros.main import main; main()',
            '--ros-args', '-r', '__node:=bag_recorder']


@pytest.fixture
def ros(own_domain):
    context = rclpy.Context()
    rclpy.init(context=context)
    node = rclpy.create_node('loop', context=context)
    yield node
    node.destroy_node()
    rclpy.try_shutdown(context=context)


class Recorder:
    """A recorder process and the topics of a loop that feeds it."""

    def __init__(self, node, run: Path, nodes: str, page: Pulse | None = None) -> None:
        self.node = node
        self.bag = run / 'bag'
        self.sent: dict[str, list[bytes]] = {}
        self.recorded = -1
        self.executor = SingleThreadedExecutor(context=node.context)
        self.executor.add_node(node)
        node.create_subscription(UInt64, '/run/recorded_step', self._on_recorded, qos.RING)
        self.ready = False
        node.create_subscription(String, '/run/ready', self._on_ready, qos.of('/run/ready'))
        self.publishers = {
            topic: node.create_publisher(kind, topic, qos.of(topic)) for topic, kind in (
                ('/run/scenario', String), ('/truth/relative_state', RelativeState),
                ('/clock', Clock), ('/onboard/measurement', RelativeState),
                ('/onboard/downlink', LinkFrame), ('/joy', Joy), ('/run/events', RunEvent),
                ('/run/end', UInt64))}
        self.process = subprocess.Popen(
            [*RECORDER, '-p', f'bag_dir:={self.bag}', '-p', f'nodes:={nodes}'],
            env={**os.environ, 'RVD_LEAN': '1', **({} if page is None else
                                                   {pulse.PAGE: str(page.file)})},
            pass_fds=() if page is None else (page.file,), stderr=subprocess.PIPE, text=True)

    def _on_recorded(self, message) -> None:
        self.recorded = message.data

    def _on_ready(self, message) -> None:
        self.ready = message.data == 'bag_recorder'

    def send(self, topic: str, message) -> None:
        self.sent.setdefault(topic, []).append(serialize_message(message))
        self.publishers[topic].publish(message)

    def until(self, condition, seconds: float = 20.0) -> None:
        limit = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < limit, 'waited too long'
            self.executor.spin_once(timeout_sec=0.02)

    def matched(self) -> bool:
        return self.ready and all(p.get_subscription_count() for p in self.publishers.values())

    def step(self, k: int, final: bool = False) -> None:
        """Publish what a small loop publishes in step k."""
        self.send('/truth/relative_state', RelativeState(
            header=header_at(k * STEP_NS, FRAME), step=k, final=final))
        self.send('/clock', Clock(clock=time_at(k * STEP_NS)))
        self.send('/onboard/measurement', RelativeState(step=k))
        self.send('/onboard/downlink', LinkFrame(step=k, sequence=k, payload=bytes(k % 50)))
        self.send('/joy', Joy(header=header_at(k * STEP_NS, ''), axes=[k % 4 / 3.0] * 5,
                              buttons=[0, 0, 0, 0, 1]))

    def stored(self) -> dict[str, list[bytes]]:
        found: dict[str, list[bytes]] = {}
        names = {}
        for record in mcap_file.records(self.bag / 'bag_0.mcap'):
            if isinstance(record, Channel):
                names[record.id] = record.topic
            elif isinstance(record, Message):
                found.setdefault(names[record.channel_id], []).append(record.data)
        return found

    def notes(self, name: str) -> dict[str, str]:
        return next(r.metadata for r in mcap_file.records(self.bag / 'bag_0.mcap')
                    if getattr(r, 'name', '') == name)


def same(a: list[bytes], b: list[bytes], kind: type) -> bool:
    """Compare decoded: padding bytes of CDR are not initialised."""
    return [deserialize_message(x, kind) for x in a] == [deserialize_message(x, kind) for x in b]


NODES = '[bag_recorder, spacecraft_dynamics, relative_sensor, operator_model]'
KINDS = {'/truth/relative_state': RelativeState, '/onboard/downlink': LinkFrame, '/joy': Joy,
         '/clock': Clock, '/onboard/measurement': RelativeState, '/run/scenario': String,
         '/run/events': RunEvent, '/run/end': UInt64}


@pytest.fixture
def recorder(ros, tmp_path):
    made = Recorder(ros, tmp_path, NODES)
    yield made
    if made.process.poll() is None:
        made.process.kill()
    made.process.wait()


def test_a_run_is_recorded_whole_and_the_bag_closed(recorder):
    recorder.until(recorder.matched)
    recorder.send('/run/events', RunEvent(code='EARLY'))        # before the scenario
    time.sleep(0.1)
    recorder.send('/run/scenario', String(data='step_s: 0.5'))
    for k in range(101):
        recorder.step(k, final=k == 100)
    recorder.send('/run/end', UInt64(data=100))
    assert recorder.process.wait(timeout=20) == 0, recorder.process.stderr.read()
    found = recorder.stored()
    for topic, kind in KINDS.items():
        assert same(found[topic], recorder.sent[topic], kind), topic
    assert len(found['/run/ready']) == 1
    with Reader(recorder.bag) as reader:
        messages = [(c.topic, t) for c, t, _ in reader.messages()]
        truth = [t for topic, t in messages if topic == '/truth/relative_state']
    assert messages[0][0] == '/run/scenario'
    assert truth == [k * STEP_NS for k in range(101)]           # simulation time
    assert recorder.notes('rvd_recording') == {'closed': 'true', 'trouble': ''}
    assert recorder.notes('rvd_lost') == {}


def test_what_found_no_room_in_the_socket_is_waited_for(recorder):
    """Fast DDS learns of it from the writer's next heartbeat, up to 3 s after the end."""
    recorder.until(recorder.matched)
    recorder.send('/run/scenario', String(data='step_s: 0.5'))
    time.sleep(0.3)
    recorder.process.send_signal(signal.SIGSTOP)
    for k in range(101):
        recorder.step(k, final=k == 100)
        if k == 96:                             # some 40 steps have found room
            recorder.process.send_signal(signal.SIGCONT)
            time.sleep(0.1)
    recorder.send('/run/end', UInt64(data=100))
    ended = time.monotonic()
    assert recorder.process.wait(timeout=20) == 0, recorder.process.stderr.read()
    assert time.monotonic() - ended > 1.0, 'nothing was lost: the test shows nothing'
    found = recorder.stored()
    for topic in set(KINDS) - {'/run/events'}:
        assert same(found[topic], recorder.sent[topic], KINDS[topic]), topic
    assert set(recorder.notes('rvd_missing').values()) == {'0'}


def test_kill_9_of_the_recorder_loses_nothing_it_had_received(recorder):
    """R2: every message that was acknowledged is in the file, and it can be repaired."""
    recorder.until(recorder.matched)
    recorder.send('/run/scenario', String(data='step_s: 0.5'))
    for k in range(145):
        recorder.step(k)
    recorder.until(lambda: recorder.recorded == 144)
    file, size = recorder.bag / 'bag_0.mcap', -1
    while size != (size := file.stat().st_size):
        time.sleep(0.3)                         # until it has drained its queues
    recorder.process.send_signal(signal.SIGKILL)
    recorder.process.wait()
    found = recorder.stored()
    for topic in set(KINDS) - {'/run/events', '/run/end'}:
        assert same(found[topic], recorder.sent[topic], KINDS[topic]), topic
    assert repair(recorder.bag)
    with Reader(recorder.bag) as reader:
        assert {c.topic: c.msgcount for c in reader.connections if c.msgcount} == {
            topic: len(messages) for topic, messages in found.items()}


@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_told_to_stop_it_closes_the_bag(recorder, number):
    recorder.until(recorder.matched)
    recorder.send('/run/scenario', String(data=''))
    for k in range(20):
        recorder.step(k)
    recorder.until(lambda: recorder.recorded >= 16)
    recorder.process.send_signal(number)
    assert recorder.process.wait(timeout=10) == 0, recorder.process.stderr.read()
    assert isinstance(list(mcap_file.records(recorder.bag / 'bag_0.mcap'))[-1], Footer)
    with Reader(recorder.bag) as reader:
        assert reader.message_count >= 17


def test_topics_nobody_announced_are_recorded_when_they_appear(recorder):
    recorder.until(recorder.matched)
    recorder.send('/run/scenario', String(data=''))
    extra = recorder.node.create_publisher(PointStamped, '/extra/point', 10)
    recorder.until(lambda: extra.get_subscription_count() > 0)
    extra.publish(PointStamped())
    recorder.step(0)
    recorder.send('/run/end', UInt64(data=0))
    assert recorder.process.wait(timeout=20) == 0
    assert len(recorder.stored()['/extra/point']) == 1


def test_steps_that_never_came_are_counted_in_the_file(ros, tmp_path):
    """R3: the loop owes one message per step; the recorder says how many it did not get."""
    made = Recorder(ros, tmp_path, '[bag_recorder, relative_sensor]')
    made.until(made.matched)
    for k in (0, 1, 2, 5, 6, 9):
        made.send('/onboard/downlink', LinkFrame(step=k))
    made.send('/run/end', UInt64(data=10))
    assert made.process.wait(timeout=20) == 0
    assert made.notes('rvd_missing') == {'/onboard/downlink': '5', '/onboard/measurement': '11'}


@pytest.mark.parametrize('noted', [True, False])
def test_a_recorder_that_never_heard_the_end_counts_by_what_the_plant_has_noted(
        ros, tmp_path, noted):
    page = Pulse.shared(2)
    made = Recorder(ros, tmp_path, '[bag_recorder, relative_sensor]', page)
    made.until(made.matched)
    for k in (0, 1, 2):
        page.flown = k                          # the plant notes a step before it has answers
        made.send('/onboard/downlink', LinkFrame(step=k))
    made.until(lambda: page.beaten_s(1) is not None)            # it gives signs of life there
    file = made.bag / 'bag_0.mcap'
    made.until(lambda: b'downlink' in file.read_bytes() and len(
        made.stored().get('/onboard/downlink', ())) == 3)
    if noted:
        page.flown = page.final = 9
    made.process.send_signal(signal.SIGTERM)
    assert made.process.wait(timeout=20) == 0
    assert made.notes('rvd_missing') == ({'/onboard/downlink': '7', '/onboard/measurement': '10'}
                                         if noted else
                                         {'/onboard/downlink': '0', '/onboard/measurement': '0'})
    assert made.notes('rvd_recording').get('last_step') == ('9' if noted else None)
    assert page.beaten_s(1) is None             # it has done its work
    page.handed_on()


@pytest.mark.parametrize('said', [True, False])
def test_what_is_said_of_the_processes_is_an_event_in_the_bag(ros, tmp_path, said):
    """While it records, and what was said while the recorder itself was stopped."""
    page = Pulse.shared(2)
    made = Recorder(ros, tmp_path, '[bag_recorder, relative_sensor]', page)
    made.until(made.matched)
    made.send('/run/scenario', String(data='scenario'))
    made.send('/onboard/downlink', LinkFrame(step=0))

    def events():
        return [(e.step, e.node, e.code, e.text) for e in (
            deserialize_message(data, RunEvent) for data in made.stored().get('/run/events', ()))]
    expected = []
    if said:
        page.say('SILENT', 7, 'law has given no sign')
        expected = [(7, 'rvd_fly', 'SILENT', 'law has given no sign')]
        made.until(lambda: events() == expected)
        made.process.send_signal(signal.SIGSTOP)
        page.say('GIVEN_UP', 9, 'bag_recorder is stopped')
        expected += [(9, 'rvd_fly', 'GIVEN_UP', 'bag_recorder is stopped')]
    made.process.send_signal(signal.SIGTERM)
    made.process.send_signal(signal.SIGCONT)
    assert made.process.wait(timeout=20) == 0
    assert events() == expected
    page.handed_on()


@pytest.mark.parametrize('said', [True, False])
def test_a_second_writer_is_in_the_bag_of_a_recorder_that_heard_no_event_of_it(
        ros, tmp_path, said):
    """By the words of `fly`, by a mark of any process alone, and once."""
    page, roster = Pulse.shared(2), Roster(parse('{}', 'default'))
    made = Recorder(ros, tmp_path, '[bag_recorder, relative_sensor]', page)
    made.until(made.matched)
    made.send('/run/scenario', String(data='scenario'))
    made.send('/onboard/downlink', LinkFrame(step=0))
    made.until(lambda: '/onboard/downlink' in made.stored())
    made.process.send_signal(signal.SIGSTOP)
    if said:
        page.say(SECOND_WRITER, 7, 'a second writer on /joy: node x')
        for topic in ('/joy', '/run/pause'):
            page.mark(roster.place_of(topic))
    made.process.send_signal(signal.SIGTERM)
    made.process.send_signal(signal.SIGCONT)
    assert made.process.wait(timeout=20) == 0
    events = [deserialize_message(data, RunEvent)
              for data in made.stored().get('/run/events', ())]
    assert [(e.node, e.code, e.text) for e in events] == said*[
        ('rvd_fly', SECOND_WRITER, 'a second writer on /joy: node x'),
        ('bag_recorder', SECOND_WRITER, 'a second writer on /run/pause: a node without a name')]
    page.handed_on()


@pytest.mark.parametrize('argument, complaint', [
    ("bag_dir:=''", 'bag_dir must name a directory'),
    ('bag_dir:=/proc/nowhere', 'bag_dir /proc/nowhere: '),
    ('bag_dir:=/tmp', 'bag directory /tmp is not empty')])
def test_a_place_where_no_bag_can_be_is_one_line_and_exit_2(argument, complaint, own_domain):
    done = subprocess.run(
        [*RECORDER, '-p', argument], capture_output=True, text=True, timeout=30)
    assert done.returncode == 2
    assert complaint in done.stderr and 'Traceback' not in done.stderr
