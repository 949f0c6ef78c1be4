"""
A hostile publisher in a flight: no node ends by itself, nothing is a traceback, steps go on.

Every topic of the graph gets mutated messages, future steps and broken bytes for as long as the
flight lasts. A second writer ends a flight as not trustworthy, so here the nodes are started one by
one, and nobody ends them: they fly to the end, in lock step with the same truth to the bit.
"""

import contextlib
import time

import numpy as np
import pytest
from rclpy._rclpy_pybind11 import RCLError
from rclpy.serialization import serialize_message
from test_by_hand import Hand

from rvd_campaign.bench import hostile
from rvd_dynamics.diagram import in_process
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.boundary import read, Refused
from rvd_dynamics.diagram.ros.conversions import state_from_msg
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load
from rvd_interfaces.msg import RelativeState, RunEvent

TRUTH = '/truth/relative_state'
SPARED = ('/run/scenario', '/run/verdict', '/run/ready', '/run/pause')  # a pause can be
SCENARIO = '/**: {ros__parameters: {pace: %s, pace_factor: 20.0, processes: %s}}'


def hostile_one(kind, seed, now):
    """
    Return a message, or bytes, that no reader can take for one of this run; None: for once not.
    """
    message = kind()
    if seed % 3 == 0:
        data = hostile.broken(serialize_message(message), seed)
        try:
            return None if getattr(read(data, kind), 'step', 2**62) < 10**6 else data
        except Refused:
            return data
    if seed % 3 == 1:
        steps = [made for _, made in hostile.at_steps(message, now)
                 if not hasattr(made, 'step') or abs(made.step - now) > 400]
        return steps[seed % len(steps)] if steps else None
    made = hostile.mutant(message, seed)[1]
    if hasattr(made, 'step'):
        made.step = 2**62 + seed
    elif hasattr(made, 'header') or hasattr(made, 'clock'):
        return None                             # its stamp may be that of a step
    return made


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('pace, processes', [('lockstep', 'blocks'), ('realtime', 'segments')])
def test_a_flight_outlives_a_hostile_publisher(pace, processes, tmp_path):
    path = tmp_path / 'attacked.yaml'
    path.write_text(SCENARIO % (pace, processes))
    scenario, hand = load(path), Hand(path)
    try:
        heard = hand.listen(TRUTH, RelativeState)
        events = hand.listen('/run/events', RunEvent)
        kinds = {topic: message_type(name) for topic, name in Roster(scenario).topics.items()
                 if topic not in SPARED}
        writers = {topic: hand.node.create_publisher(kind, topic, qos.of(topic))
                   for topic, kind in kinds.items()}

        def truth():                            # a stranger names no frame
            return [m for m in heard if m.header.frame_id == scenario.run.frame_id]
        hand.start_ring(waits=True)
        hand.go()
        hand.until(lambda: len(truth()) > 10, 'the first steps')
        seed, limit = 0, time.monotonic() + 300.0
        while not any(m.final for m in truth()):
            assert time.monotonic() < limit, len(truth())
            now = len(truth())
            for topic, kind in kinds.items():
                seed += 1
                made = hostile_one(kind, seed, now)
                if topic == '/run/end':         # left behind, and what no run gets to
                    made = kind(data=(0, 2**63, 10**6)[seed % 3])
                if made is not None:
                    with contextlib.suppress(RCLError):         # longer than the type can be
                        writers[topic].publish(made)
            hand.executor.spin_once(timeout_sec=0.005)
            for _ in range(20):
                hand.executor.spin_once(timeout_sec=0.0)
        for name, process in hand.processes.items():
            code = process.wait(60.0)
            said = process.stderr.read()
            assert code == 0 and 'Traceback' not in said, (name, code, said)
        flown = truth()
        assert [m.step for m in flown] == list(range(len(flown))) and seed > 300
        assert {e.code for e in events if e.node in kinds or e.node} >= {'REFUSED'}
        if pace == 'lockstep':
            alone = in_process.fly(scenario, [0], record=[TRUTH]).history[TRUTH].state[:, 0]
            np.testing.assert_array_equal(
                [state_from_msg(m) for m in flown], alone[:len(flown)])
    finally:
        hand.close()
