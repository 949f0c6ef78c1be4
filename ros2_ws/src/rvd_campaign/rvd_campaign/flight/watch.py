"""
The eyes of `fly`: a light node that follows a run from outside the ring.

It looks at the newest raw message of each topic some times a second and decodes one only when
it is shown, so that it does not slow the graph.
"""

import time
from importlib import import_module
from typing import Any

from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from rclpy.serialization import deserialize_message

from rvd_dynamics.commands.codes import BY_AUTO, BY_BLEND, BY_GUARD, BY_NOBODY, BY_PILOT
from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.ros import graph, qos
from rvd_dynamics.diagram.ros.conversions import ns_of

SHOWN = ('/truth/relative_state', '/ground/command', '/link/back/status')
SETTLE_S = 3.0                  # [s] wall time without news after which a look back is complete
GLANCE_S = 0.05                 # [s] wall time between two looks at the flight
DECIDES = {BY_NOBODY: 'nobody', BY_PILOT: 'pilot', BY_AUTO: 'auto', BY_GUARD: 'guard'}


def message_type(name: str) -> type:
    """Return the class of a type such as 'std_msgs/msg/String'."""
    package, _, kind = name.split('/')
    return getattr(import_module(f'{package}.msg'), kind)


class FlightWatch:
    """Follows one run; `spin` it, then ask."""

    def __init__(self, mission: Mission, domain: int) -> None:
        self._mission = mission
        self._context = Context()
        self._context.init(domain_id=domain)
        self._node = Node('rvd_fly', context=self._context, enable_rosout=False,
                          start_parameter_services=False, parameter_overrides=[
                              Parameter('start_type_description_service', value=False)])
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._raw: dict[str, bytes] = {}
        self.ready: set[str] = set()
        self.paused = False
        self.verdict = None
        self.events: list[Any] = []
        self.steps = 0                          # truth messages looked at
        self.progress_at = time.monotonic()     # when the last one came
        for topic in SHOWN:
            self._subscribe(topic, lambda data, topic=topic: self._keep(topic, data), raw=True)
        self._subscribe('/run/ready', lambda m: self.ready.add(m.data))
        self._subscribe('/run/pause', self._on_pause)
        self._subscribe('/run/verdict', self._on_verdict)
        self._subscribe('/run/events', self.events.append)

    def _subscribe(self, topic: str, callback: Any, raw: bool = False) -> None:
        profile = qos.of(topic, self._mission.joy_input)
        self._node.create_subscription(
            message_type(graph.TOPICS[topic]), topic, callback,
            _newest(profile) if raw else profile, raw=raw)

    def _keep(self, topic: str, data: bytes) -> None:
        self._raw[topic] = data
        if topic == '/truth/relative_state':
            self.steps += 1
            self.progress_at = time.monotonic()
            time.sleep(GLANCE_S)                # what comes meanwhile replaces what came before

    def _on_pause(self, message: Any) -> None:
        self.paused = message.data
        self.progress_at = time.monotonic()

    def _on_verdict(self, message: Any) -> None:
        self.verdict = message

    def spin(self, seconds: float) -> None:
        """Take in what arrives during `seconds` of wall time."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            # Always the same timeout: with another one the executor begins its round anew, and
            # the first topic that is always ready starves the rest.
            self._executor.spin_once(timeout_sec=GLANCE_S)

    def newest(self, topic: str) -> Any:
        """Return the newest message of a shown topic, decoded; None before the first."""
        data = self._raw.get(topic)
        return None if data is None else deserialize_message(
            data, message_type(graph.TOPICS[topic]))

    def line(self) -> str:
        """Return one line of progress: range, rate, limited measures, who decides, delay."""
        truth, command = self.newest('/truth/relative_state'), self.newest('/ground/command')
        back = self.newest('/link/back/status')
        if truth is None:
            return ''
        p, v = truth.position, truth.velocity
        judged = from_message(self.verdict).measures if self.verdict is not None else ()
        measures = ''.join(f'  {m.words} {m.said}' for m in judged if m.known and m.limited)
        delay = back.delay_p50 if back is not None else float('nan')
        loop = self._mission.forward_delay_s + self._mission.back_delay_s
        return (f't {truth.step * self._mission.step_s:6.1f} s  '
                f'range {(p.x * p.x + p.y * p.y + p.z * p.z) ** 0.5:6.2f} m  '
                f'rate {v.x:6.3f} m/s{measures}  {_decides(command)}  '
                f'transit {delay:4.2f} s, loop {loop:g} s  y {p.y:5.2f} z {p.z:5.2f} m'
                + ('  PAUSED' if self.paused else ''))

    def who_owes(self, nodes: list[str], law_uses_stick: bool) -> list[str]:
        """
        Return the nodes that owe a message, from the last step that each topic remembers.

        Ring topics keep their history for late readers, so they are read only now. A hung node
        gives nothing back, so the wait ends when nothing new has come for a while.
        """
        last: dict[str, int] = {}

        def note(topic: str, kind: type):
            def take(data: bytes) -> None:
                message = deserialize_message(data, kind)
                step = getattr(message, 'step', getattr(message, 'data', None))
                if step is None:                # Joy
                    step = ns_of(message.header.stamp) // self._mission.step_ns
                last[topic] = max(step, last.get(topic, -1))
            return take

        topics = {t for name in nodes if name in graph.NODES for t in graph.NODES[name].emits}
        for topic in (topics - {'/clock'}) | {'/run/recorded_step'}:
            kind = message_type(graph.TOPICS[topic])
            self._node.create_subscription(kind, topic, note(topic, kind), qos.LATCHED, raw=True)
        known = -1
        while known < sum(last.values()):
            known = sum(last.values())
            self.spin(SETTLE_S)
        return graph.who_owes(last, nodes, self._mission.operator, self._mission.joy_input,
                              law_uses_stick)

    def close(self) -> None:
        """Leave the graph."""
        self._executor.shutdown()
        self._node.destroy_node()
        self._context.try_shutdown()


def _newest(profile: QoSProfile) -> QoSProfile:
    return QoSProfile(depth=1, reliability=profile.reliability, durability=profile.durability)


def _decides(command: Any) -> str:
    if command is None:
        return ''
    if command.decided_by == BY_BLEND:
        return f'pilot {command.pilot_weight:g} + auto {1.0 - command.pilot_weight:.2g}'
    return DECIDES.get(command.decided_by, '?')
