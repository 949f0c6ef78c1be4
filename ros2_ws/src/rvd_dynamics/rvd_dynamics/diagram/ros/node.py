"""
Base of every node of a run: settings, quiet endpoints, and its place in a process.

A node belongs to a `Host`, its process, which deals with what concerns all nodes in it: the
start-up barrier, the end of the run, diagnostics.

`RVD_LEAN=1` leaves out parameter services, the type-description service, /rosout and QoS event
callbacks (20 % of the CPU of the whole graph); `scripts/bringup.sh` sets it, a node started by
hand has them.
"""

import os
import time
from typing import Any, Callable

from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile
from rclpy.subscription import Subscription

from rvd_dynamics.bad_input import one_line
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.params import declare
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import Scenario, sections_of, SHARED
from rvd_dynamics.diagram.signal import Signal

LONGEST = 300                   # [characters] of what is said about a message
REST_S = 0.03                   # [s] wall time a watcher that has caught up lets messages gather


class RunNode(Node):
    """
    A node of a run; by itself a watcher outside the ring.

    Subclasses create their endpoints in `__init__` with `watch` and `writer` and may override
    `on_ready`, `on_end` and `close`. `finished` is true when it has nothing more to do.
    """

    def __init__(self, host: Any, name: str) -> None:
        self.lean = os.environ.get('RVD_LEAN') == '1'
        super().__init__(
            name, start_parameter_services=not self.lean, enable_rosout=not self.lean,
            parameter_overrides=[Parameter('start_type_description_service', value=not self.lean)])
        self.host = host
        self.scenario: Scenario = host.scenario
        self.roster: Roster = host.roster
        self.run = self.scenario.run
        self.finished = False
        self.step = -1                          # last step dealt with
        self.trouble: dict[str, str] = {}       # shown in /diagnostics
        self.refused_count: dict[str, int] = {}     # messages left out, by topic
        self.subscriptions_of: dict[str, Subscription] = {}
        self.publishers_of: dict[str, Publisher] = {}
        self.held = self.scenario.has_shared('joy_input') and \
            self.scenario.part('operation').joy_input == 'held'
        if not self.lean:
            self._declare(name)
        host.add(self)

    def _declare(self, name: str) -> None:
        """Serve the parameters that this node has, with their meaning and limits."""
        sections = sections_of(self.scenario.mission, {SHARED, name})
        for settings in (sections.get(SHARED, []), sections.get(name, [])):
            for prefix, cls in settings:
                declare(self, cls, prefix)

    # -- endpoints ------------------------------------------------------------------------

    def quality(self, topic: str) -> QoSProfile:
        """Return the quality of service that the writer of a topic of this run offers."""
        return qos.of(topic, self.held)

    def watch(self, topic: str, kind: type, callback: Callable, raw: bool = False,
              group: CallbackGroup | None = None, rests: bool = False,
              profile: QoSProfile | None = None) -> Subscription:
        """Subscribe with the topic's own quality of service; `rests`: see `rest`."""
        guarded, numbers = self.guarded(callback), self.host.traces.numbers(topic)

        def call(message: Any, info: dict) -> None:     # rclpy counts the arguments
            numbers(info)
            guarded(message)
            if rests:
                self.rest(info)
        events = SubscriptionEventCallbacks(use_default_callbacks=False) if self.lean else None
        subscription = self.create_subscription(
            kind, topic, call, profile or qos.taken(topic, self.held), raw=raw,
            callback_group=group, event_callbacks=events)
        self.subscriptions_of[topic] = subscription
        self.host.traces.follow(topic, subscription)
        return subscription

    def watch_raw(self, topic: str, kind: type, callback: Callable, profile: QoSProfile) -> None:
        """Subscribe to serialised messages; the callback gets the bytes and their origin."""
        events = SubscriptionEventCallbacks(use_default_callbacks=False) if self.lean else None
        guarded, numbers = self.guarded(callback), self.host.traces.numbers(topic)

        def call(data: bytes, info: dict) -> None:      # rclpy counts the arguments
            numbers(info)
            guarded(data, info)
        self.subscriptions_of[topic] = self.create_subscription(
            kind, topic, call, profile, raw=True, event_callbacks=events)
        self.host.traces.follow(topic, self.subscriptions_of[topic])

    def writer(self, topic: str, kind: type, profile: QoSProfile | None = None) -> Publisher:
        """Advertise with the topic's own quality of service."""
        events = PublisherEventCallbacks(use_default_callbacks=False) if self.lean else None
        publisher = self.create_publisher(kind, topic, profile or self.quality(topic),
                                          event_callbacks=events)
        self.publishers_of[topic] = publisher
        return publisher

    def guarded(self, callback: Callable) -> Callable:
        """Let an error in a callback end the process instead of being lost in the executor."""
        def call(*arguments):
            try:
                callback(*arguments)
            except Exception as error:          # noqa: B902 - handed on through the host
                self.host.fail(self, error)
        return call

    def codec_of(self, signal: Signal) -> Any:
        """Return the codec of a signal, with what its constructor names."""
        own = {'signal': signal, 'run': self.run, 'event': self.event}

        def available(name: str) -> Any:
            return own[name] if name in own else self.scenario.part(name)
        return made(signal.codec, available, f'signal {signal.name}')

    # -- while it runs --------------------------------------------------------------------

    def rest(self, message_info: dict) -> None:
        """
        Sleep for a moment if the message at hand is fresh; for watchers outside the ring.

        What comes meanwhile is taken in one go: to be woken for each message costs a process
        several times what it does with it.
        """
        age_ns = time.time_ns() - message_info['source_timestamp']
        if 0 <= age_ns < REST_S * 1e9 and not self.finished:
            time.sleep(REST_S)

    def event(self, code: str, text: str) -> None:
        """Say on /run/events that something happened, once."""
        self.host.event(self, code, text)

    def refuse(self, topic: str, why: str) -> None:
        """Be told that a message cannot be and is left out: count, and say so once a topic."""
        self.refused_count[topic] = self.refused_count.get(topic, 0) + 1
        text = one_line(f'{topic}: {why}')[:LONGEST]
        if self.refused_count[topic] == 1:
            self.event('REFUSED', f'{text}: left out, as if it had not come')
        self.trouble['refused'] = f'{text}: {sum(self.refused_count.values())} left out so far'

    # -- start and end --------------------------------------------------------------------

    def on_ready(self) -> None:
        """Be told that every endpoint of this process is matched."""

    def settle(self) -> None:
        """Be told that the process is about to wait for messages."""

    def on_end(self, final_step: int) -> None:
        """Be told which step is the last; a watcher may finish now or drain first."""
        self.finish()

    def finish(self) -> None:
        """Have nothing more to do."""
        self.finished = True
        self.host.look()

    def close(self) -> None:
        """Be told that the process ends, while its endpoints are still there."""

    def destroy_node(self) -> None:
        """Leave the graph; a reader of which something is still held would stay in it."""
        self.host.traces.close()
        super().destroy_node()
