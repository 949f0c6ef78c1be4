"""A law that looks at the stick: told the mode of its step and the reading that the blender has."""

import numpy as np
import pytest
from sensor_msgs.msg import Joy
from test_by_hand import Hand
from test_groups import Control, GROUPED

from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.scenario import load
from rvd_groundstation.sharing import Eq25
from rvd_interfaces.msg import RunEvent, ThrustCommand, Values
from rvd_interfaces.srv import RunControl

STEPPED = """
/**:
  ros__parameters: {pace: lockstep, seed: 3, mode: %s, step_s: 0.1, processes: %s}
auto_controller:
  ros__parameters: {law: barrier}
"""
HELD = """
/**:
  ros__parameters: {pace: realtime, pace_factor: 4.0, operator: joy, joy_input: held}
auto_controller:
  ros__parameters: {law: %s}
"""


@pytest.mark.parametrize('processes', [
    'blocks', *(pytest.param(p, marks=pytest.mark.slow) for p in GROUPED)])
@pytest.mark.parametrize('before, after', [('shared', 'auto'), ('auto', 'shared')])
def test_a_change_in_flight_reaches_law_and_blender_in_one_step(before, after, processes, tmp_path):
    """The same automatic commands as in process, where the mode changes by a schedule."""
    scenario = tmp_path / 'changed.yaml'
    scenario.write_text(STEPPED % (before, processes))
    hand = Hand(scenario)
    try:
        heard = {topic: hand.listen(topic, ThrustCommand) for topic in (
            '/ground/auto_command', '/ground/command', '/onboard/thruster_command')}
        auto = heard['/ground/auto_command']
        events, control = hand.listen('/run/events', RunEvent), Control(hand)
        hand.start_ring(waits=True)
        hand.go()
        hand.until(lambda: len(auto) > 200, 'the beginning')
        control(RunControl.Request.MODE, after)
        hand.until(lambda: len(auto) > 900, 'enough steps')
    finally:
        hand.close()
    changed = next(e.step for e in events if e.code == 'MODE') + 1
    assert 200 < changed < 850
    flown = fly(load(scenario), [0], record=True, schedule=[Change(changed, mode=after)]).history
    for topic, messages in heard.items():
        steps = [m.step for m in messages]
        assert steps == list(range(len(steps))) and steps[-1] > 890
        np.testing.assert_array_equal([m.levels for m in messages],
                                      flown[topic].command[steps, 0], topic)


@pytest.mark.parametrize('law', ['barrier', 'none'])
def test_a_held_stick_is_read_once_in_a_step_and_the_reading_is_told(law, tmp_path):
    """It moves from stop to stop all the time: two readings of a step would soon differ."""
    scenario = tmp_path / 'held.yaml'
    scenario.write_text(HELD % law)
    hand = Hand(scenario)
    try:
        heard = {topic: hand.listen(topic, kind) for topic, kind in (
            ('/ground/auto_command', ThrustCommand), ('/ground/command', ThrustCommand),
            ('/ground/stick', Values))}
        joy = hand.node.create_publisher(Joy, '/joy', qos.of('/joy', 'held'))
        hand.start_ring(waits=True)
        hand.until(lambda: joy.get_subscription_count() >= 1 + (law == 'barrier'), 'readers')
        hand.go()
        sign = 1.0

        def shake():
            nonlocal sign
            sign = -sign
            joy.publish(Joy(axes=[0.0, sign, 0.0, sign, sign], buttons=[0, 0, 0, 0, 1]))
            hand.executor.spin_once(timeout_sec=0.001)
            return len(heard['/ground/command']) > 120
        hand.until(shake, 'a hundred commands')
    finally:
        hand.close()
    by_step = [{m.step: m for m in messages} for messages in heard.values()]
    both, checked = set.intersection(*map(set, by_step)), 0
    for k in sorted(both):
        auto, command, reading = (messages[k] for messages in by_step)
        levels, valid = np.array(reading.values[:3], dtype=int), bool(reading.values[3])
        if valid and auto.valid and command.decided_by == ThrustCommand.BY_BLEND:
            assert list(command.levels) == Eq25().share(levels, auto.levels).tolist(), k
            checked += 1
    assert checked > 60
