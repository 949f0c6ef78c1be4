"""One message with an impossible step, to a real node in real time: left out, said, flown on."""

from argparse import Namespace

import pytest
from test_by_hand import Hand

from rvd_campaign.flight.choice import chosen
from rvd_dynamics.diagram.ros import qos
from rvd_interfaces.msg import RelativeState, RunEvent, ThrustCommand

SCENARIO = """
/**:
  ros__parameters: {pace: realtime, operator: none, mode: auto}
"""


@pytest.mark.parametrize('step', [2**63, 401])
def test_a_node_in_real_time_answers_after_a_message_from_beyond_the_run(step, tmp_path):
    scenario = tmp_path / 'stray.yaml'
    scenario.write_text(SCENARIO)
    hand = Hand(scenario)
    try:
        events = hand.listen('/run/events', RunEvent)
        commands = hand.listen('/ground/auto_command', ThrustCommand)
        topic = '/ground/prediction'
        sender = hand.node.create_publisher(RelativeState, topic, qos.of(topic))
        hand.start('auto_controller', '-p', 'nodes:=[auto_controller]', package='rvd_groundstation')
        hand.until(lambda: sender.get_subscription_count() > 0, 'the node')
        for k in (step, step, 0):
            sender.publish(RelativeState(step=k))
        hand.until(lambda: commands, 'an answer to step 0', timeout=10.0)
        hand.until(lambda: events, 'the event', timeout=10.0)
        assert [c.step for c in commands] == [0]
        assert [e.code for e in events] == ['REFUSED'] and events[0].node == 'auto_controller'
        assert all(word in events[0].text for word in (topic, str(step), '400'))
    finally:
        hand.close()


@pytest.mark.parametrize('flags, told, wanted', [
    ({}, 'joy_input: stepped, ', 'stepped'), ({}, 'pace: realtime, ', 'held'),
    ({'operator': 'joy', 'pace': '1'}, 'joy_input: stepped, ', 'held')])
def test_a_pilot_of_ones_own_may_answer_every_step_of_a_flight(flags, told, wanted, tmp_path):
    scenario = tmp_path / 'pilot.yaml'
    scenario.write_text('/**: {ros__parameters: {%soperator: joy}}' % told)
    nothing = dict.fromkeys(('operator', 'pace', 'processes', 'mode', 'tape', 'tape_topic', 'seed'))
    args = Namespace(**{**nothing, 'scenario': str(scenario), **flags})
    assert chosen(args).part('operation').joy_input == wanted
