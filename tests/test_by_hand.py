"""Nodes started one by one as a user would, without the bring-up: they find each other and fly."""

import os
import signal
import subprocess
import time

import numpy as np
import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from runs import ROOT

from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load
from rvd_interfaces.msg import RelativeState, ThrustCommand, Verdict
from rvd_interfaces.srv import RunControl
from sensor_msgs.msg import Joy
from std_msgs.msg import String

ME = 'test_hand'                  # the name of this test among the nodes of a run


class Hand:
    """Starts nodes with `./rvd node` and listens as any other ROS program would."""

    def __init__(self, scenario) -> None:
        self.reserved = reserved_domain()       # two of these at once must not hear each other
        domain = self.reserved.__enter__()
        self.environment = {**os.environ, 'ROS_DOMAIN_ID': str(domain)}
        self.scenario, self.processes, self.heard = scenario, {}, {}
        self.context = Context()
        rclpy.init(context=self.context, domain_id=domain)
        self.node = rclpy.create_node(ME, context=self.context)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)

    def start(self, name, *args, package='rvd_dynamics', executable=None):
        self.processes[name] = subprocess.Popen(
            [str(ROOT / 'rvd'), 'node', package, executable or name, '--ros-args',
             *(['-r', f'__node:={name}'] if executable != 'block_group' else []),
             '--params-file', str(self.scenario), *args],
            env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def start_ring(self, but=(), waits=False):
        """
        Start the blocks of the scenario, or their groups; `waits`: they stand still till `go`.
        """
        self.roster = Roster(load(self.scenario))
        told = ['-p', f'nodes:=[{",".join((*self.roster.names, ME))}]'] if waits else []
        if waits:
            self.ready = self.node.create_publisher(String, '/run/ready', qos.of('/run/ready'))
            self.started = self.listen('/run/ready', String)
        for process in self.roster.processes:
            if process.name not in but:
                group = ['-p', f'group:={process.name}'] if process.grouped else []
                self.start(process.name, *group, *told, package=process.package,
                           executable=process.executable)

    def go(self):
        """Let the run begin: who waits for it counts as one of the nodes."""
        self.until(lambda: {m.data for m in self.started} >= set(self.roster.names), 'the nodes')
        self.ready.publish(String(data=ME))

    def listen(self, topic, kind):
        self.heard[topic] = []
        self.node.create_subscription(kind, topic, self.heard[topic].append, qos.of(topic))
        return self.heard[topic]

    def until(self, condition, what, timeout=60.0):
        deadline = time.monotonic() + timeout
        while not condition():
            assert time.monotonic() < deadline, what
            self.executor.spin_once(timeout_sec=0.1)

    def until_still(self, heard, seconds=1.0):
        """Wait until `seconds` of wall time go by without a message; return how many there are."""
        count, since = len(heard), time.monotonic()

        def still():
            nonlocal count, since
            if len(heard) != count:             # what was on its way, however slow this process is
                count, since = len(heard), time.monotonic()
            return time.monotonic() - since > seconds
        self.until(still, 'it does not stand still', 20.0)
        return count

    def close(self):
        for process in self.processes.values():
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
        for process in self.processes.values():
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            process.stderr.close()
        self.executor.shutdown()
        self.node.destroy_node()
        self.context.try_shutdown()
        self.reserved.__exit__(None, None, None)


@pytest.fixture
def hand(tmp_path):
    """Return a hand on a domain of its own; its processes are ended by pid."""
    scenario = tmp_path / 'scenario.yaml'
    text = (ROOT / 'scenarios' / 'paper.yaml').read_text()
    scenario.write_text(text.replace('mode: shared', 'pace: lockstep\n    mode: shared'))
    made = Hand(scenario)
    yield made
    made.close()


def test_a_ring_started_in_any_order_flies_to_its_end(hand):
    """The last node comes 2 s late; nothing moves before, and nothing is lost."""
    truth = hand.listen('/truth/relative_state', RelativeState)
    thrust = hand.listen('/onboard/thruster_command', ThrustCommand)
    verdicts = hand.listen('/run/verdict', Verdict)
    hand.start('mission_monitor')
    hand.start_ring(but=('link_back',))
    time.sleep(2.0)
    hand.executor.spin_once(timeout_sec=0.2)
    assert truth == []
    hand.start('link_back', executable='link_emulator')
    hand.until(lambda: verdicts and verdicts[-1].final, 'no verdict')
    assert [m.step for m in truth] == list(range(len(truth)))
    assert truth[-1].final and truth[-1].position.x >= 0.0
    hand.until(lambda: len(thrust) == len(truth), 'a thruster command for each truth')
    for name, process in hand.processes.items():
        assert process.wait(20.0) == 0, f'{name} says: {process.stderr.read()}'


def test_a_node_of_ones_own_can_be_the_pilot(hand):
    """Any publisher of stamped Joy messages closes the ring in place of the model."""
    predictions = hand.listen('/ground/prediction', RelativeState)
    commands = hand.listen('/ground/command', ThrustCommand)
    joy = hand.node.create_publisher(Joy, '/joy', qos.of('/joy'))
    answered = 0
    hand.scenario.write_text(hand.scenario.read_text().replace(
        'operator: model ', 'operator: joy\n    joy_input: stepped '))
    hand.start_ring()

    def fly():
        nonlocal answered
        for prediction in predictions[answered:]:
            step_ns = prediction.step * 500_000_000
            message = Joy(axes=[2.0 / 3.0, 0.0, 0.0, 0.0, -1.0], buttons=[0, 0, 0, 0, 1])
            message.header.stamp.sec = step_ns // 10**9
            message.header.stamp.nanosec = step_ns % 10**9
            joy.publish(message)
            answered += 1
        return len(commands) > 30
    hand.until(fly, 'thirty commands')
    # eq. 25, automatic command neutral or not: level 2 on y and -3 on z come through
    late = commands[25]
    assert (late.levels[1], late.levels[2], late.levels[0]) == (2, -3, 0)
    np.testing.assert_allclose(late.pilot_weight, 0.7)


def test_control_pauses_resumes_changes_the_mode_and_aborts(hand):
    hand.scenario.write_text(hand.scenario.read_text().replace(
        'pace: lockstep', 'pace: realtime\n    pace_factor: 10.0'))
    truth = hand.listen('/truth/relative_state', RelativeState)
    commands = hand.listen('/ground/command', ThrustCommand)
    thrust = hand.listen('/onboard/thruster_command', ThrustCommand)
    control = hand.node.create_client(RunControl, '/run/control')
    hand.start_ring()
    hand.until(lambda: len(truth) > 20 and control.service_is_ready(), 'twenty steps')

    def call(action, mode=''):
        future = control.call_async(RunControl.Request(action=action, mode=mode))
        hand.until(future.done, 'an answer of /run/control')
        return future.result()

    assert call(RunControl.Request.PAUSE).accepted
    at_pause = hand.until_still(truth)
    assert call(RunControl.Request.RESUME).accepted
    hand.until(lambda: len(truth) > at_pause + 5, 'steps after the pause')

    refused = call(RunControl.Request.MODE, 'psychic')
    assert not refused.accepted and 'manual, shared, auto' in refused.message
    assert call(RunControl.Request.MODE, 'manual').accepted
    at_mode = commands[-1].step
    hand.until(lambda: commands[-1].step > at_mode + 3, 'commands in the new mode')
    assert commands[-1].decided_by == ThrustCommand.BY_PILOT

    assert call(RunControl.Request.ABORT).accepted
    hand.until(lambda: thrust[-1].kind == ThrustCommand.KIND_ABORT, 'the abort on board')
    sent = next(c for c in commands if c.kind == ThrustCommand.KIND_ABORT)
    acted = next(t for t in thrust if t.kind == ThrustCommand.KIND_ABORT)
    assert list(acted.levels) == [-3, 0, 0]
    # transit at least 3.6 s, and no wait in the play-out buffer for slower frames than 5 s
    assert 7 <= acted.step - sent.step <= 11
