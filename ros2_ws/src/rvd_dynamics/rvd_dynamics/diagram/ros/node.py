"""
Base of every node: settings, quiet entities, the start-up barrier, the end of the run.

A node says on `/run/ready` that each of its endpoints is matched, and stops when the run that
`/run/end` names is over. `StepNode` in `step_node` adds the synchronous firing.

`RVD_LEAN=1` leaves out parameter services, the type-description service, /rosout and QoS event
callbacks (20 % of the CPU of the whole graph); `scripts/bringup.sh` sets it, a node started by
hand has them.
"""

import os
import time
from typing import Any, Callable

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.subscription import Subscription
from rclpy.task import Future
from std_msgs.msg import String, UInt64

from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.ros import graph, qos
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.params import declare
from rvd_interfaces.msg import RunEvent

BARRIER_PERIOD_S = 0.05         # [s] wall time between two looks at the endpoints
DIAGNOSTICS_PERIOD_S = 1.0      # [s] wall time
MOMENT_S = 0.3                  # [s] wall time in which local readers get what was written last
RECORDER_S = 5.0                # [s] wall time that a closing node gives the recorder
REST_S = 0.03                   # [s] wall time a watcher that has caught up lets messages gather


class WatchNode(Node):
    """
    A node with a mission, a barrier and an end; by itself a watcher outside the ring.

    Subclasses create their endpoints in `__init__` with `watch` and `writer` and may override
    `on_end`. `done` is set when the node has nothing more to do.
    """

    def __init__(self, name: str, spec: graph.Spec | None = None) -> None:
        lean = os.environ.get('RVD_LEAN') == '1'
        super().__init__(
            name, start_parameter_services=not lean, enable_rosout=not lean,
            parameter_overrides=[Parameter('start_type_description_service', value=not lean)])
        self._lean = lean
        self.done: Future = Future()
        self.final_step: int | None = None
        self.step = -1                          # last step dealt with
        self.mission: Mission = declare(self, Mission)
        self._names = [n for n in self.mission.nodes if n] or list(
            graph.ring(self.mission.operator))
        self._subscriptions_of: dict[str, Subscription] = {}
        self._publishers_of: dict[str, Publisher] = {}
        self._diagnosed = time.monotonic()
        self.trouble: dict[str, str] = {}       # shown in /diagnostics
        self.spec = spec if spec is not None else self._spec()
        self._ready = self.writer('/run/ready', String)
        self._events = self.writer('/run/events', RunEvent)
        self._diagnostics = self.writer('/diagnostics', DiagnosticArray)
        if '/run/end' not in self.spec.publishes:
            self.watch('/run/end', UInt64, self._ended)
        self._barrier = self.create_timer(BARRIER_PERIOD_S, self._check_barrier)

    def _spec(self) -> graph.Spec:
        return graph.spec_of(self.get_name(), self.mission.operator, self.mission.joy_input)

    # -- endpoints ------------------------------------------------------------------------

    def settings(self, cls: type, **wiring: Any) -> Any:
        """Declare and return the settings of this node's algorithm."""
        return declare(self, cls, **wiring)

    def watch(self, topic: str, kind: type, callback: Callable, raw: bool = False,
              group: CallbackGroup | None = None, rests: bool = False) -> Subscription:
        """Subscribe with the topic's own quality of service; `rests`: see `rest`."""
        guarded = self._guarded(callback)
        events = SubscriptionEventCallbacks(use_default_callbacks=False) if self._lean else None
        subscription = self.create_subscription(
            kind, topic, self._resting(guarded) if rests else guarded,
            qos.of(topic, self.mission.joy_input), raw=raw, callback_group=group,
            event_callbacks=events)
        self._subscriptions_of[topic] = subscription
        return subscription

    def writer(self, topic: str, kind: type) -> Publisher:
        """Advertise with the topic's own quality of service."""
        events = PublisherEventCallbacks(use_default_callbacks=False) if self._lean else None
        publisher = self.create_publisher(
            kind, topic, qos.of(topic, self.mission.joy_input), event_callbacks=events)
        self._publishers_of[topic] = publisher
        return publisher

    def _guarded(self, callback: Callable) -> Callable:
        """Let an error in a callback end the node instead of being lost in the executor."""
        def call(message):
            try:
                callback(message)
            except Exception as error:          # noqa: B902 - handed on through `done`
                self.finish(error)
        return call

    # -- start ----------------------------------------------------------------------------

    def unmatched(self) -> list[str]:
        """Return the topics whose other end is not there yet."""
        mission, missing = self.mission, []
        for topic, publisher in self._publishers_of.items():
            readers = graph.expected(topic, self._names, mission.operator, mission.joy_input)[1]
            if topic not in graph.COMMON and publisher.get_subscription_count() < readers:
                missing.append(topic)
        for topic, subscription in self._subscriptions_of.items():
            writers = graph.expected(topic, self._names, mission.operator, mission.joy_input)[0]
            if topic not in graph.COMMON and subscription.get_publisher_count() < writers:
                missing.append(topic)
        return missing

    def _check_barrier(self) -> None:
        if self.unmatched():
            return
        self._barrier.cancel()
        self.destroy_timer(self._barrier)
        self._ready.publish(String(data=self.get_name()))
        self.on_ready()

    def on_ready(self) -> None:
        """Be told that every endpoint of this node is matched."""

    # -- while it runs --------------------------------------------------------------------

    def rest(self, message_info: dict) -> None:
        """
        Sleep for a moment if the message at hand is fresh; for watchers outside the ring.

        What comes meanwhile is taken in one go: to be woken for each message costs a process
        several times what it does with it.
        """
        age_ns = time.time_ns() - message_info['source_timestamp']
        if 0 <= age_ns < REST_S * 1e9 and not self.done.done():
            time.sleep(REST_S)

    def _resting(self, callback: Callable) -> Callable:
        def call(message, message_info):
            callback(message)
            self.rest(message_info)
        return call

    def event(self, code: str, text: str) -> None:
        """Say on /run/events that something happened, once."""
        step = max(self.step, 0)
        self._events.publish(RunEvent(
            header=header_at(step * self.mission.step_ns, self.mission.frame_id), step=step,
            node=self.get_name(), code=code, text=text))

    def diagnose(self) -> None:
        """
        Publish /diagnostics at most once a second of wall time.

        Called from the work itself, never from a timer: a node that hangs falls silent.
        """
        now = time.monotonic()
        if now - self._diagnosed < DIAGNOSTICS_PERIOD_S:
            return
        self._diagnosed = now
        status = DiagnosticStatus(
            level=DiagnosticStatus.WARN if self.trouble else DiagnosticStatus.OK,
            name=self.get_name(), hardware_id='rvd',
            message='; '.join(self.trouble.values()) or 'running',
            values=[KeyValue(key='step', value=str(self.step))])
        message = DiagnosticArray(status=[status])
        message.header = header_at(max(self.step, 0) * self.mission.step_ns, '')
        self._diagnostics.publish(message)

    # -- end ------------------------------------------------------------------------------

    def _ended(self, message: UInt64) -> None:
        self.final_step = message.data
        self.on_end()

    def on_end(self) -> None:
        """Be told that `final_step` is the last; a watcher may finish now or drain first."""
        self.finish()

    def finish(self, error: Exception | None = None) -> None:
        """End the process, with an error if there is one; the first call counts."""
        if self.done.done():
            return
        if error is not None:
            self.done.set_exception(error)
        else:
            self.done.set_result(None)

    def close(self) -> None:
        """
        Let the readers have the last messages before the writers go.

        The recorder leaves when it has everything, so who is recorded waits for that; others
        stay a moment. (Waiting for acknowledgements takes a heartbeat of 3 s, always.)
        """
        if not self.context.ok():               # told to stop: the graph is gone already
            return
        if 'bag_recorder' not in self._names:
            time.sleep(MOMENT_S)
            return
        deadline = time.monotonic() + RECORDER_S
        while time.monotonic() < deadline and self._recorder_is_here():
            time.sleep(0.02)

    def _recorder_is_here(self) -> bool:
        readers = self.get_subscriptions_info_by_topic('/run/end')
        return any(reader.node_name == 'bag_recorder' for reader in readers)
