"""
What only watchers read goes out many messages at a time in lock step; the ring never waits for it.
"""

import pytest
import rclpy

from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.ros.host import BEAT_NS, HANDFUL, Host
from rvd_dynamics.diagram.ros.main import make, wanted

WATCHED = {                           # of each process, by the picture in lunar_approach/diagram.py
    'world': {'/truth/relative_state', '/onboard/measurement', '/clock'},
    'onboard': set(),
    'link': {'/link/back/status', '/link/forward/status'},
    'ground': {'/ground/estimate', '/ground/prediction', '/ground/prediction_score', '/joy',
               '/ground/auto_command', '/ground/command'},
}


class Noted:
    """A publisher that keeps what it is given."""

    def __init__(self):
        self.messages = []

    def publish(self, message):
        self.messages.append(message)


@pytest.fixture
def process(own_domain, monkeypatch):
    """Return a function that makes a process of a run; it has found its partners."""
    monkeypatch.setenv('RVD_LEAN', '1')
    made = []

    def start(group, pace='lockstep', processes='segments'):
        words = ['/x/block_group', '--ros-args', '-p', f'group:={group}', '-p', f'pace:={pace}',
                 '-p', f'processes:={processes}']
        rclpy.init(args=words)
        host = Host(parsed(words))
        made.append(host)
        make(host, wanted(host, host.arguments))
        monkeypatch.setattr(host._barrier, 'unmatched', list)
        monkeypatch.setattr(host._barrier, 'are_known', lambda: True)
        host._barrier.look()
        assert host.begun
        return host
    yield start
    for host in made:
        for node in host.nodes.values():
            node.destroy_node()
    rclpy.try_shutdown()


@pytest.mark.parametrize('group', WATCHED)
def test_only_what_no_other_process_needs_for_a_firing_is_kept(group, process):
    host = process(group)
    kept = {topic for name in host.nodes for topic in host.roster.emits(name)
            if not _goes_out_at_once(host, topic)}
    assert kept == WATCHED[group]


def test_in_real_time_everything_goes_out_at_once(process):
    host = process('world', pace='realtime')
    assert all(_goes_out_at_once(host, topic) for topic in host.roster.emits('relative_sensor'))


def _goes_out_at_once(host, topic):
    publisher = Noted()
    host.publish(publisher, topic, 0, b'message')
    return bool(publisher.messages)


def test_a_process_of_one_block_keeps_nothing(process):
    host = process('onboard')
    assert _goes_out_at_once(host, '/onboard/thruster_command')
    timers = list(host.nodes['onboard_guard'].timers)      # of which only the heartbeat's is left
    assert len(host.firing) == 1 and [t.timer_period_ns for t in timers] == [BEAT_NS]


def test_a_handful_goes_out_in_order_without_waiting_for_the_timer(process):
    host, publisher = process('world'), Noted()
    for step in range(HANDFUL - 1):
        host.publish(publisher, '/clock', step, b'%d' % step)
    host.work()
    assert not publisher.messages
    host.publish(publisher, '/clock', HANDFUL - 1, b'%d' % (HANDFUL - 1))
    host.work()
    assert publisher.messages == [b'%d' % step for step in range(HANDFUL)]


def test_less_goes_out_after_a_moment_and_at_the_end(process):
    host, publisher = process('world'), Noted()
    host.publish(publisher, '/clock', 0, b'first')
    host.spin(stopped=lambda: bool(publisher.messages))
    assert publisher.messages == [b'first']
    host.publish(publisher, '/clock', 1, b'last')
    host.close()
    assert publisher.messages == [b'first', b'last']
    host.nodes.clear()                          # closed: the fixture need not
