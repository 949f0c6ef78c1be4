"""A stick that sends when it likes, in real time: it reaches the command, and the law too."""

import time

import pytest
from sensor_msgs.msg import Joy
from test_by_hand import Hand

from rvd_dynamics.diagram.ros import qos
from rvd_interfaces.msg import ThrustCommand

DOMAIN = 73
SCENARIO = """
/**:
  ros__parameters:
    pace: realtime
    pace_factor: 4.0
    operator: joy
    joy_input: held
auto_controller:
  ros__parameters: {law: %s}
command_blender:
  ros__parameters: {sharing: %s}
"""


@pytest.mark.parametrize('law, sharing', [('none', 'eq25'), ('barrier', 'filter')])
def test_a_held_stick_reaches_the_command(law, sharing, tmp_path):
    """Level -1 on z, which is safe at the start; a filter that had not heard it would say 0."""
    scenario = tmp_path / 'held.yaml'
    scenario.write_text(SCENARIO % (law, sharing))
    hand = Hand(DOMAIN, scenario)
    try:
        commands = hand.listen('/ground/command', ThrustCommand)
        joy = hand.node.create_publisher(Joy, '/joy', qos.of('/joy', 'held'))
        hand.start_ring()
        sent = 0.0

        def hold():
            nonlocal sent
            if time.monotonic() - sent > 0.05:
                joy.publish(Joy(axes=[0.0, 0.0, 0.0, 0.0, -1.0/3.0], buttons=[0, 0, 0, 0, 1]))
                sent = time.monotonic()
            return len(commands) > 14
        hand.until(hold, 'fourteen commands')
        held = [list(c.levels) for c in commands if c.step >= 11]
        assert [0, 0, -1] in held, held
    finally:
        hand.close()
