"""
What rclpy alone costs: a node with the endpoints of one of ours and nothing behind them.

    python -m rvd_campaign.bench.bare NAME SCENARIO STEPS MESSAGES

It publishes messages that one of ours has sent (MESSAGES: topic to hex, as JSON), on the topics
of the run's roster with the same qualities of service, fires when the inputs of a step are here,
takes raw bytes where ours does, and computes and stores nothing. Plain rclpy in the cheapest
set-up there is: no parameters, no parameter services, no /rosout, no QoS event callbacks. What our
nodes publish at a rate of wall time only (verdict, pictures, diagnostics) it leaves out.
"""

import json
from pathlib import Path
import sys
from typing import Any

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.serialization import deserialize_message
from rclpy.task import Future
from std_msgs.msg import String, UInt64

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.block import Read
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import COMMON, listed, MARKERS, RECORDER, Roster
from rvd_dynamics.diagram.scenario import load

BARRIER_PERIOD_S = 0.02         # [s] wall time between two looks at the endpoints
REPORT_EVERY = 16               # [steps] between two /run/recorded_step, as our recorder
AS_BYTES = (RECORDER, MARKERS)  # nodes of ours that do not decode


class BareNode(Node):
    """One node of a run, hollow."""

    def __init__(self, name: str, roster: Roster, steps: int, messages: dict[str, Any]) -> None:
        super().__init__(name, enable_rosout=False, start_parameter_services=False,
                         parameter_overrides=[
                             Parameter('start_type_description_service', value=False)])
        self.done: Future = Future()
        self._roster, self._steps, self._step_ns = roster, steps, roster.scenario.run.step_ns
        block = roster.blocks.get(name)
        self._period = block.period if block else 1
        self._needs = [read for read in block.reads.values() if not read.held] if block else []
        self._next = 0
        self._seen = dict.fromkeys((read.signal.name for read in self._needs), -1)
        self._is_plant = name == roster.diagram.plant
        self._waiting_for = set(roster.names) if self._is_plant else set()
        self._writers = {topic: self._writer(topic) for topic in (*roster.writes(name), *COMMON)}
        self._messages = {topic: messages[topic] for topic in roster.emits(name)}
        self._readers = {topic: self._reader(topic) for topic in roster.reads(name)}
        self._barrier = self.create_timer(BARRIER_PERIOD_S, self._check_barrier)

    # -- endpoints ------------------------------------------------------------------------

    def _writer(self, topic: str) -> Any:
        return self.create_publisher(
            message_type(self._roster.topics[topic]), topic, qos.of(topic),
            event_callbacks=PublisherEventCallbacks(use_default_callbacks=False))

    def _reader(self, topic: str) -> Any:
        return self.create_subscription(
            message_type(self._roster.topics[topic]), topic, self._callback(topic),
            qos.of(topic), raw=self.get_name() in AS_BYTES,
            event_callbacks=SubscriptionEventCallbacks(use_default_callbacks=False))

    def _callback(self, topic: str) -> Any:
        if topic == '/run/end':
            return lambda message: self.done.set_result(None)
        if topic == '/run/ready' and self._is_plant:
            return self._on_ready
        if self.get_name() == RECORDER:
            return self._count if topic == self._roster.diagram.truth.name else ignore
        if topic in self._seen:
            return lambda message: self._receive(topic, step_of(message, self._step_ns))
        return ignore

    def _check_barrier(self) -> None:
        for topic, writer in self._writers.items():
            if (topic not in COMMON
                    and writer.get_subscription_count() < self._roster.expected(topic)[1]):
                return
        for topic, reader in self._readers.items():
            if (topic not in COMMON
                    and reader.get_publisher_count() < self._roster.expected(topic)[0]):
                return
        self.destroy_timer(self._barrier)
        self._writers['/run/ready'].publish(String(data=self.get_name()))

    # -- one step -------------------------------------------------------------------------

    def _on_ready(self, message: String) -> None:
        if message.data in self._waiting_for:
            self._waiting_for.discard(message.data)
            if not self._waiting_for:
                self._fire()

    def _receive(self, topic: str, step: int) -> None:
        self._seen[topic] = step
        while all(self._seen[read.signal.name] >= self._needed(read) for read in self._needs):
            self._fire()

    def _needed(self, read: Read) -> int:
        return max(self._roster.needed(read, self._next), -1)

    def _fire(self) -> None:
        step = self._next
        self._next = step + self._period
        if step >= self._steps:
            if self._is_plant:
                self._writers['/run/end'].publish(UInt64(data=step))
                self._writers['/run/end'].wait_for_all_acked()
                self.done.set_result(None)
            return
        for topic, message in self._messages.items():
            set_step(message, step, self._step_ns)
            self._writers[topic].publish(message)

    def _count(self, data: bytes) -> None:
        if self._next % REPORT_EVERY == 0:
            self._writers['/run/recorded_step'].publish(UInt64(data=self._next))
        self._next += 1


def ignore(message: Any) -> None:
    """Take a message and do nothing."""


def step_of(message: Any, step_ns: int) -> int:
    """Return the step of a message; Joy carries it in its stamp."""
    return message.step if hasattr(message, 'step') else ns_of(message.header.stamp) // step_ns


def set_step(message: Any, step: int, step_ns: int) -> None:
    """Say in the message which step it belongs to, in its own way."""
    if hasattr(message, 'step'):
        message.step = step
        return
    stamp = message.header.stamp if hasattr(message, 'header') else message.clock
    stamp.sec, stamp.nanosec = divmod(step * step_ns, NS_PER_S)


def main() -> None:
    """Run one hollow node to the end of the run."""
    name, scenario, steps, messages = sys.argv[1:5]
    rclpy.init()
    roster = listed(load(Path(scenario)), headless=False)
    kept = json.loads(Path(messages).read_text(encoding='utf-8'))
    node = BareNode(name, roster, int(steps), {
        topic: deserialize_message(bytes.fromhex(kept[topic]),
                                   message_type(roster.topics[topic]))
        for topic in roster.emits(name)})
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    try:
        executor.spin_until_future_complete(node.done)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
