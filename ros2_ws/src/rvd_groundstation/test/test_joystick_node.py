"""The node `joystick` with a real SDL device: published, silent when unplugged, and back again."""

import time
from types import SimpleNamespace

import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Joy
from virtual_stick import VirtualStick

from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.joystick.node import Joystick
from rvd_interfaces.msg import RunEvent


@pytest.fixture
def graph(own_domain):
    """Return the node, a function that spins until something is true, and what has been heard."""
    rclpy.init()
    scenario = parse("""
/**: {ros__parameters: {pace: realtime, operator: joy, joy_input: held}}
joystick: {ros__parameters: {deadzone: 0.1, autorepeat_rate: 50.0}}
""", 'driven')
    node = Joystick(Host(SimpleNamespace(name='joystick', scenario=scenario,
                                          text=lambda: '', run_id='/')))
    listener = rclpy.create_node('listener')
    joys, events = [], []
    listener.create_subscription(Joy, '/joy', joys.append, qos_profile_sensor_data)
    listener.create_subscription(RunEvent, '/run/events', events.append, 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.add_node(listener)

    def until(condition, seconds=20.0):
        deadline = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < deadline, (len(joys), [e.text for e in events])
            executor.spin_once(timeout_sec=0.02)
    yield SimpleNamespace(node=node, until=until, joys=joys, events=events)
    executor.shutdown()
    node.close()
    node.destroy_node()
    listener.destroy_node()
    rclpy.try_shutdown()


def test_a_stick_is_published_lost_and_back(graph):
    node, until, joys, events = graph.node, graph.until, graph.joys, graph.events
    until(lambda: node.trouble)
    assert node.trouble['device'].startswith('no stick') and not joys
    for _ in range(2):
        stick = VirtualStick(axes=4, buttons=5, hats=0)
        until(lambda: not node.trouble)
        stick.move(1, -32768)
        stick.press(4)
        until(lambda: joys and joys[-1].axes[1] == 1.0 and list(joys[-1].buttons) == [0]*4 + [1])
        assert joys[-1].header.frame_id == 'joy'
        stick.move(1, 2000)                     # within the dead zone
        until(lambda: joys[-1].axes[1] == 0.0)
        stick.unplug()
        until(lambda: node.trouble)
        assert node.trouble['device'].startswith('the stick has gone')
        until(lambda: events and events[-1].code == 'DEVICE_LOST')
        sent, later = len(joys), time.monotonic() + 0.3
        until(lambda: time.monotonic() > later)
        assert len(joys) <= sent + 1            # one may have been under way
    assert [e.code for e in events if e.node == 'joystick'][-4:] == ['DEVICE', 'DEVICE_LOST'] * 2
