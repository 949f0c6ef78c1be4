"""A stick that sends when it likes, in real time: it reaches the command, and the law too."""

from math import nan
import time

import pytest
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Joy
from test_by_hand import Hand

from rvd_interfaces.msg import RunEvent, ThrustCommand

SCENARIO = """
/**:
  ros__parameters:
    pace: realtime
    pace_factor: 4.0
    operator: joy
    joy_input: held
    processes: %s
auto_controller:
  ros__parameters: {law: %s}
command_blender:
  ros__parameters: {sharing: %s}
"""


@pytest.mark.parametrize('processes', [
    'blocks', *(pytest.param(p, marks=pytest.mark.slow) for p in ('segments', 'one'))])
@pytest.mark.parametrize('law, sharing', [('none', 'eq25'), ('barrier', 'filter')])
def test_a_held_stick_reaches_the_command(law, sharing, processes, tmp_path):
    """
    Level -1 on z, which is safe at the start; a filter that had not heard it would say 0.

    A driver may be best effort; NaN at the end is said once, with the axis.
    """
    scenario = tmp_path / 'held.yaml'
    scenario.write_text(SCENARIO % (processes, law, sharing))
    hand = Hand(scenario)
    try:
        commands = hand.listen('/ground/command', ThrustCommand)
        events = hand.listen('/run/events', RunEvent)
        joy = hand.node.create_publisher(Joy, '/joy', qos_profile_sensor_data)
        hand.start_ring(waits=True)
        sent, readers = 0.0, 1 + (law == 'barrier')
        hand.until(lambda: joy.get_subscription_count() >= readers, 'who reads the stick')
        hand.go()

        def hold():
            nonlocal sent
            if time.monotonic() - sent > 0.05:
                x = nan if len(commands) > 14 else 0.0
                joy.publish(Joy(axes=[0.0, x, nan, 0.0, -1.0/3.0], buttons=[0, 0, 0, 0, 1]))
                sent = time.monotonic()
            return len(commands) > 18
        hand.until(hold, 'eighteen commands')
        held = [list(c.levels) for c in commands if c.step >= 11]
        assert [0, 0, -1] in held, [(c.step, list(c.levels), c.reason) for c in commands]
        lost = [(e.node, e.text) for e in events if e.code == 'STICK_LOST']
        assert lost[-1] == ('command_blender', '/joy does not count: axis 1 (x) is not a number')
        assert len(lost) == len(set(lost)) <= 2             # at first perhaps: no message yet
    finally:
        hand.close()
