"""
What rclpy alone costs: a node with the endpoints of one of ours and nothing behind them.

    python -m rvd_campaign.bench.bare NAME SCENARIO STEPS NODE[,NODE...]

It publishes prebuilt messages of the same types and sizes, on the topics of the graph's table
with the same qualities of service, fires when the inputs of a step are here, takes raw bytes
where ours does, and computes and stores nothing. Plain rclpy in the cheapest set-up there is: no
parameters, no parameter services, no /rosout, no QoS event callbacks. What our nodes publish at a
rate of wall time only (verdict, pictures, diagnostics) it leaves out.
"""

import sys
from pathlib import Path

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.task import Future
from std_msgs.msg import String, UInt64

from rvd_campaign.scenario import load
from rvd_campaign.flight.watch import message_type
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.link.frame import COMMAND_BYTES, DOWNLINK_BYTES
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.ros import graph, qos

BARRIER_PERIOD_S = 0.02         # [s] wall time between two looks at the endpoints
REPORT_EVERY = 16               # [steps] between two /run/recorded_step, as our recorder
AS_BYTES = ('bag_recorder', 'markers')     # nodes of ours that do not decode
FRAMES_DOWN = ('/onboard/downlink', '/ground/telemetry')


class BareNode(Node):
    """One node of the table, hollow."""

    def __init__(self, name: str, mission: Mission, steps: int, names: list[str]) -> None:
        super().__init__(name, enable_rosout=False, start_parameter_services=False,
                         parameter_overrides=[
                             Parameter('start_type_description_service', value=False)])
        self.done: Future = Future()
        self._mission, self._steps, self._names = mission, steps, names
        self._spec = graph.spec_of(name, mission.operator, mission.joy_input)
        self._next, self._held = 0, {}
        self._waiting_for = set(names) if '/run/ready' in self._spec.watches else set()
        topics = {*self._spec.publishes, *graph.COMMON}
        self._writers = {topic: self._writer(topic) for topic in topics}
        self._messages = {topic: prebuilt(topic, mission) for topic in self._spec.emits}
        self._readers = {topic: self._reader(topic) for topic in self._spec.reads}
        self._barrier = self.create_timer(BARRIER_PERIOD_S, self._check_barrier)

    # -- endpoints ------------------------------------------------------------------------

    def _writer(self, topic: str):
        return self.create_publisher(
            message_type(graph.TOPICS[topic]), topic, qos.of(topic, self._mission.joy_input),
            event_callbacks=PublisherEventCallbacks(use_default_callbacks=False))

    def _reader(self, topic: str):
        return self.create_subscription(
            message_type(graph.TOPICS[topic]), topic, self._callback(topic),
            qos.of(topic, self._mission.joy_input), raw=self.get_name() in AS_BYTES,
            event_callbacks=SubscriptionEventCallbacks(use_default_callbacks=False))

    def _callback(self, topic: str):
        if topic == '/run/end':
            return lambda message: self.done.set_result(None)
        if topic == '/run/ready' and self._waiting_for:
            return self._on_ready
        if self._spec.everything:
            return self._count if topic == '/truth/relative_state' else ignore
        lag = dict(self._spec.fires_on).get(topic)
        if lag is None:
            return ignore
        if topic == '/joy':
            step_ns = self._mission.step_ns
            return lambda m: self._receive(
                (m.header.stamp.sec * NS_PER_S + m.header.stamp.nanosec) // step_ns + lag)
        return lambda m: self._receive(m.step + lag)

    def _check_barrier(self) -> None:
        def expected(topic: str) -> tuple[int, int]:
            return graph.expected(topic, self._names, self._mission.operator,
                                  self._mission.joy_input)
        for topic, writer in self._writers.items():
            if (topic not in graph.COMMON
                    and writer.get_subscription_count() < expected(topic)[1]):
                return
        for topic, reader in self._readers.items():
            if topic not in graph.COMMON and reader.get_publisher_count() < expected(topic)[0]:
                return
        self.destroy_timer(self._barrier)
        self._writers['/run/ready'].publish(String(data=self.get_name()))

    # -- one step -------------------------------------------------------------------------

    def _on_ready(self, message: String) -> None:
        if message.data in self._waiting_for:
            self._waiting_for.discard(message.data)
            if not self._waiting_for:
                self._fire()

    def _receive(self, step: int) -> None:
        self._held[step] = self._held.get(step, 0) + 1
        while self._held.get(self._next, 0) >= sum(
                self._next >= lag for _, lag in self._spec.fires_on):
            self._fire()

    def _fire(self) -> None:
        step = self._next
        self._held.pop(step, None)
        self._next = step + 1
        if step >= self._steps:
            if '/run/end' in self._writers:
                self._writers['/run/end'].publish(UInt64(data=step))
                self._writers['/run/end'].wait_for_all_acked()
                self.done.set_result(None)
            return
        for topic, message in self._messages.items():
            set_step(message, step, self._mission.step_ns)
            self._writers[topic].publish(message)

    def _count(self, data: bytes) -> None:
        if self._next % REPORT_EVERY == 0:
            self._writers['/run/recorded_step'].publish(UInt64(data=self._next))
        self._next += 1


def ignore(message) -> None:
    """Take a message and do nothing."""


def prebuilt(topic: str, mission: Mission):
    """Return a message for `topic` as large as ours."""
    message = message_type(graph.TOPICS[topic])()
    if hasattr(message, 'header'):
        message.header.frame_id = 'joy' if topic == '/joy' else mission.frame_id
    if hasattr(message, 'payload'):
        message.payload = bytes(DOWNLINK_BYTES if topic in FRAMES_DOWN else COMMAND_BYTES)
    if hasattr(message, 'axes'):
        message.axes, message.buttons = [0.0] * 5, [0] * 5
    return message


def set_step(message, step: int, step_ns: int) -> None:
    """Say in the message which step it belongs to, in its own way."""
    if hasattr(message, 'step'):
        message.step = step
        return
    stamp = message.header.stamp if hasattr(message, 'header') else message.clock
    stamp.sec, stamp.nanosec = divmod(step * step_ns, NS_PER_S)


def main() -> None:
    """Run one hollow node to the end of the run."""
    name, scenario, steps, names = sys.argv[1:5]
    rclpy.init()
    node = BareNode(name, load(Path(scenario)).mission, int(steps), names.split(','))
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    try:
        executor.spin_until_future_complete(node.done)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
