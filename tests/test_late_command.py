"""A command of ours that reaches the predictor late, over DDS: made up for, not zero for ever."""

import time

import numpy as np
import pytest
from test_by_hand import Hand

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.conversions import state_from_msg
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.link.frame import pack_downlink
from rvd_groundstation.prediction.predictor import Predictor
from rvd_interfaces.msg import LinkFrame, RelativeState, ThrustCommand

SCENARIO = """
/**:
  ros__parameters: {pace: realtime, operator: none, mode: auto}
"""
STEPS, LOOP = 40, 20            # of half a second
LATE = (12, 13, 20)             # their commands come two steps after they were due


def levels(k):
    return [k % 4, -(k % 3), k % 2]


@pytest.mark.parametrize('aborted', [STEPS, 13])
def test_the_node_predicts_as_if_the_command_had_been_there(aborted, tmp_path):
    scenario = tmp_path / 'late.yaml'
    scenario.write_text(SCENARIO)
    hand, state = Hand(scenario), np.array([-30.0, 0.1, 0.1, 0.25, 0.0, 0.0])
    s = load(scenario)
    try:
        predicted = hand.listen('/ground/prediction', RelativeState)
        frames, commands = (hand.node.create_publisher(kind, topic, qos.of(topic)) for topic,
                            kind in (
            ('/ground/telemetry', LinkFrame), ('/ground/command', ThrustCommand)))
        hand.start('state_predictor', '-p', 'nodes:=[state_predictor]', package='rvd_groundstation')
        hand.until(lambda: frames.get_subscription_count() and commands.get_subscription_count(),
                   'the node')

        def send(k):
            kind = KIND_ABORT if k >= aborted else KIND_THRUST
            commands.publish(ThrustCommand(step=k, kind=kind, levels=[0, 0, 0] if k >= aborted
                                           else levels(k)))

        for k in range(STEPS):
            if k - 3 in LATE:
                send(k - 3)
            if k and k - 1 not in LATE:
                send(k - 1)
            frame = LinkFrame(step=k, empty=k < 10)
            if k >= 10:
                frame.payload = list(pack_downlink(
                    sequence=k - 9, generated_ns=(k - 10)*500_000_000, state=state,
                    accepted_sequence=max(k - LOOP, 0), refusal=0))    # each one has acted
            frames.publish(frame)
            if k - 1 in LATE:           # it fires when something of the next step comes: not yet
                time.sleep(0.2)
            else:
                hand.until(lambda: len(predicted) > k, f'prediction {k}')
    finally:
        hand.close()
    right = Predictor(s.settings('state_predictor'), s.run, s.part('legs'), s.part('orbit'),
                      s.part('start'), s.part('form'), abort=s.part('abort_profile'),
                      scatter=s.part('start_scatter'))
    ideal = [right.advance(k, state, k >= 10, None if k == 0 else (
        [0, 0, 0] if k - 1 >= aborted else levels(k - 1)), k - 1 >= aborted, acted=True).predicted
        for k in range(STEPS)]
    got = np.array([state_from_msg(m) for m in predicted])
    assert [m.step for m in predicted] == list(range(STEPS))
    off = np.abs(got - ideal).max(axis=1)
    assert np.nanmax(off[13:22]) > 1e-3         # without it there is a difference
    np.testing.assert_allclose(off[24:], 0.0, atol=1e-12)
