"""A writer that comes and goes between two looks is known by what it leaves with a reader."""

from pathlib import Path
import time

import pytest
from rclpy.context import Context
from rclpy.node import Node
from std_msgs.msg import Bool

from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.traces import SETTLE_S, STILL_S, SURE_S, Traces
from rvd_dynamics.diagram.ros.writers import OTHER_RUN_S, Writers
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
        self.domain, self.now, self.open = domain, 100.0, []
        self.node = self.joined('reader', RUN)
        self.heard, self.traces = [], Traces(
            roster, RUN, lambda: self.node, lambda: self.now, lambda: 0.0)
        subscription = self.node.create_subscription(
            Bool, TOPIC, self.heard.append, qos.of(TOPIC))
        self.traces.follow(TOPIC, subscription)
        self.ours = self.node.create_publisher(Bool, TOPIC, qos.of(TOPIC))
        self.until(lambda: subscription.get_publisher_count() == 1)
        self.traces.begin()

    def joined(self, name, enclave):
        context = Context()
        context.init(args=['x', '--ros-args', '--enclave', enclave], domain_id=self.domain)
        self.open.append(context)
        return Node(name, context=context, enable_rosout=False, start_parameter_services=False)

    def write_once(self, enclave='/'):
        """Let somebody come, write as soon as he is matched, and leave; return when he is gone."""
        node = self.joined('forger', enclave)
        publisher = node.create_publisher(Bool, TOPIC, qos.of(TOPIC))
        self.until(publisher.get_subscription_count)
        publisher.publish(Bool(data=True))
        node.destroy_node()
        self.open.pop().try_shutdown()
        self.until(lambda: self.node.count_publishers(TOPIC) == 1)

    @staticmethod
    def until(condition):
        deadline = time.monotonic() + 30.0
        while not condition():
            assert time.monotonic() < deadline
            time.sleep(0.001)

    def look(self, later=0.05):
        self.now += later
        return self.traces.look()

    def close(self):
        self.traces.close()
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
