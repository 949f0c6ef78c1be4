"""A writer that comes and goes between two looks is known by what it leaves with a reader."""

from pathlib import Path
import time
from types import SimpleNamespace

import pytest
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool

from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.traces import SETTLE_S, STILL_S, SURE_S, Traces
from rvd_dynamics.diagram.ros.writers import OTHER_RUN_S, UNKNOWN_NODE, Writers
from rvd_dynamics.diagram.roster import listed
from rvd_dynamics.diagram.scenario import load

SCENARIOS = Path(__file__).resolve().parents[4] / 'scenarios'
RUN, TOPIC = new_run(), '/run/pause'


@pytest.fixture
def roster():
    return listed(load(SCENARIOS / 'paper.yaml'), headless=True)


class Reader:
    """A process of the run that hears of pauses, and the wall time of its traces."""

    def __init__(self, roster, domain):
        self.domain, self.now, self.open, self.written = domain, 100.0, [], None
        self.node = self.joined('reader', RUN)
        self.heard, self.traces = [], Traces(
            roster, RUN, lambda: self.node, lambda: self.now, lambda: 0.0, lambda _: self.written)
        numbers = self.traces.numbers(TOPIC)

        def read(message, info):
            numbers(info)
            self.heard.append(message)
        subscription = self.node.create_subscription(Bool, TOPIC, read, qos.of(TOPIC))
        self.executor = SingleThreadedExecutor(context=self.open[0])
        self.executor.add_node(self.node)
        self.traces.follow(TOPIC, subscription)
        self.ours = self.node.create_publisher(Bool, TOPIC, qos.of(TOPIC))
        self.until(lambda: subscription.get_publisher_count() == 1)
        self.traces.begin()

    def joined(self, name, enclave):
        context = Context()
        context.init(args=['x', '--ros-args', '--enclave', enclave], domain_id=self.domain)
        self.open.append(context)
        return Node(name, context=context, enable_rosout=False, start_parameter_services=False)

    def write_once(self, enclave='/', stays=False):
        """Let somebody come, write as soon as he is matched, and leave; return when he is gone."""
        node = self.joined('forger', enclave)
        publisher = node.create_publisher(Bool, TOPIC, qos.of(TOPIC))
        self.until(publisher.get_subscription_count)
        publisher.publish(Bool(data=True))
        if stays:                               # until he has been read
            self.reads(len(self.heard) + 1)
        node.destroy_node()
        self.open.pop().try_shutdown()
        self.until(lambda: self.node.count_publishers(TOPIC) == 1)

    @staticmethod
    def until(condition):
        deadline = time.monotonic() + 30.0
        while not condition():
            assert time.monotonic() < deadline
            time.sleep(0.001)

    def reads(self, messages):
        """Take in what has come until there are so many messages in all."""
        deadline = time.monotonic() + 30.0
        while len(self.heard) < messages:
            assert time.monotonic() < deadline
            self.executor.spin_once(timeout_sec=0.01)

    def look(self, later=0.05):
        self.now += later
        return self.traces.look()

    def close(self):
        self.traces.close()
        self.executor.shutdown()
        self.node.destroy_node()
        for context in self.open:
            context.try_shutdown()


@pytest.fixture
def reader(roster, own_domain):
    made = Reader(roster, own_domain)
    yield made
    made.close()


def test_who_has_left_before_anybody_looked_is_known_to_have_been_there(reader):
    assert reader.look() == []
    reader.write_once()
    assert reader.look() == []                  # it may yet prove to be of another run
    assert reader.look(2*SURE_S) == [TOPIC]
    assert reader.look(2*SURE_S) == []            # once


def test_who_only_looks_does_not_see_it(roster, reader):
    """The negative twin: without the traces nobody knows."""
    writers = Writers(roster, RUN, reader.node, lambda: reader.now)
    writers.look(True)
    before = reader.node.get_publishers_info_by_topic(TOPIC)
    reader.write_once()
    assert len(reader.node.get_publishers_info_by_topic(TOPIC)) == len(before)
    reader.now += 1.0
    assert [s for s in writers.look(True) if s.node == 'forger'] == []


def test_a_node_of_another_run_that_comes_and_leaves_is_none(reader):
    other = reader.joined('guard', new_run())
    reader.until(lambda: ('guard', '/') in reader.node.get_node_names_and_namespaces())
    reader.write_once()
    assert reader.look() == [] and reader.look(2*SURE_S) == []
    other.destroy_node()
    reader.open.pop().try_shutdown()
    reader.until(lambda: ('guard', '/') not in reader.node.get_node_names_and_namespaces())
    reader.write_once()                         # its last node, of which the name never came
    assert reader.look() == [] and reader.look(2*SURE_S) == []
    for _ in range(int(OTHER_RUN_S) + 1):
        assert reader.look(1.0) == []
    reader.write_once()
    assert reader.look() == [] and reader.look(2*SURE_S) == [TOPIC]


def test_at_the_end_nothing_is_waited_for(reader):
    reader.write_once()
    assert reader.traces.look(last=True) == [TOPIC]


def test_after_all_stood_still_its_own_writers_are_found_again_and_are_no_strangers(reader):
    """The negative twin: once it has settled, a writer too many counts again."""
    reader.write_once()                         # stands for a writer that was taken for dead
    assert reader.look(STILL_S + 0.1) == []
    for _ in range(int(SETTLE_S) + 1):
        assert reader.look(1.0) == []
    reader.write_once()
    assert reader.look() == [] and reader.look(2*SURE_S) == [TOPIC]


# -- numbers of messages --------------------------------------------------------------------------

def shown(roster, topic, *numbers):
    traces = Traces(roster, RUN, lambda: None)
    look = traces.numbers(topic)
    for number in numbers:
        look({'publication_sequence_number': number})
    return traces.urgent, traces.look()


@pytest.mark.parametrize('numbers', [(1, 2, 3), (5, 6, 9), (), (1,), (None, None)])
def test_what_one_writer_has_written_ascends(roster, numbers):
    assert shown(roster, '/clock', *numbers) == (False, [])


@pytest.mark.parametrize('numbers', [(1, 2, 3, 1), (1, 1), (57, 1, 58), (1, 2, 2)])
def test_what_two_have_written_does_not(roster, numbers):
    assert shown(roster, '/clock', *numbers) == (True, ['/clock'])


@pytest.mark.parametrize('still_s, told', [(0.9*STILL_S, True), (1.1*STILL_S, False)])
def test_what_is_handed_over_once_more_after_all_stood_still_is_of_the_same_writer(
        roster, still_s, told):
    now = [100.0]
    traces = Traces(roster, RUN, lambda: None, lambda: now[0])
    look = traces.numbers('/clock')
    for number in (1, 2, 3):
        look({'publication_sequence_number': number})
    now[0] += still_s
    look({'publication_sequence_number': 1})    # before anybody has looked
    assert traces.look() == (['/clock'] if told else [])


@pytest.mark.parametrize('topic', ['/run/events', '/diagnostics', '/elsewhere'])
def test_where_many_write_the_numbers_say_nothing(roster, topic):
    assert shown(roster, topic, 1, 2, 1) == (False, [])


# -- counts of messages ---------------------------------------------------------------------------

@pytest.mark.parametrize('written, told', [(0, [TOPIC]), (None, [])])
def test_a_message_that_nobody_of_the_run_has_written_is_known_as_soon_as_it_is_read(
        reader, written, told):
    """The negative twin: where nobody counts, nothing is known before it is sure who it was."""
    reader.written = written
    reader.write_once(stays=True)
    assert reader.traces.urgent == bool(told)
    assert reader.look(0.0) == told


def test_what_the_run_has_written_is_its_own(reader):
    reader.written = 2                          # noted before it is sent
    for _ in range(2):
        reader.ours.publish(Bool(data=True))
        reader.reads(len(reader.heard) + 1)
    assert not reader.traces.urgent and reader.look() == []


class Page:
    """A reader whose graph, time and page are played."""

    def __init__(self, roster, topic):
        self.now, self.written, self.writers, self.nodes = 100.0, 0, [], []
        self.traces = Traces(roster, RUN, lambda: self, lambda: self.now, lambda: 1.0,
                             lambda _: self.written)
        self._read, self._number = self.traces.numbers(topic), 0

    def get_publishers_info_by_topic(self, topic):
        return [SimpleNamespace(node_name=name) for name in self.writers]

    def get_node_names_and_namespaces_with_enclaves(self):
        return self.nodes

    def reads(self, messages=1):
        for _ in range(messages):
            self._number += 1
            self._read({'publication_sequence_number': self._number})

    def look(self, later=0.05, last=False):
        self.now += later
        return self.traces.look(last)


def test_what_came_before_the_run_began_is_of_no_run_and_what_comes_then_is(roster):
    page = Page(roster, TOPIC)
    page.reads(2)
    assert page.look() == []
    page.traces.begin()
    assert page.look() == []
    page.reads()
    assert page.look() == [TOPIC]
    page.reads()
    assert page.look() == []                    # once


def test_what_is_handed_over_once_more_after_a_standstill_is_not_counted(roster):
    page = Page(roster, TOPIC)
    page.traces.begin()
    page.look()
    page.now += 1.1*STILL_S
    page.reads()
    assert page.look() == []
    assert [page.look(1.0) for _ in range(int(SETTLE_S) + 1)] == [[]]*(int(SETTLE_S) + 1)
    page.reads()
    assert page.look() == [TOPIC]


@pytest.mark.parametrize('named', [True, False])
def test_a_console_that_came_later_may_say_what_happened(roster, named):
    """The negative twin: a writer that is never named, or has gone, is none."""
    page = Page(roster, '/run/events')
    page.traces.begin()
    page.writers = [UNKNOWN_NODE]
    page.reads()
    assert page.look() == []
    if named:
        page.writers = ['console']
    assert page.look(2*SURE_S) == ([] if named else ['/run/events'])
    page.writers = []
    page.reads()
    assert page.look() == (['/run/events'] if named else [])


@pytest.mark.parametrize('topic, told', [('/run/events', False), (TOPIC, True)])
def test_a_node_of_another_run_may_have_said_something_but_has_paused_nothing(
        roster, topic, told):
    page = Page(roster, topic)
    page.traces.begin()
    page.nodes = [('guard', '/', new_run())]
    page.reads()
    assert page.look() == ([topic] if told else [])
    page.nodes = []
    assert {tuple(page.look(1.0)) for _ in range(int(OTHER_RUN_S))} == {()}
    page.reads()
    assert page.look() == ([] if told else [topic])
