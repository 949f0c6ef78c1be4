"""
The eyes of `fly`: a light node that follows a run from outside the ring.

It looks at the newest raw message of each topic some times a second and decodes one only when
it is shown, so that it does not slow the graph.
"""

from collections.abc import Callable
import math
import time
from typing import Any

from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from rclpy.serialization import deserialize_message

from rvd_dynamics.commands.codes import BY_AUTO, BY_BLEND, BY_GUARD, BY_NOBODY, BY_PILOT
from rvd_dynamics.diagram.identity import who_is_ready
from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.ros.traces import Traces
from rvd_dynamics.diagram.ros.writers import NAMELESS, Stranger, Writers
from rvd_dynamics.diagram.roster import COUNTED, Roster
from rvd_dynamics.pulse import Pulse
from rvd_dynamics.verdict_line import Message, STRANGER, VERDICT
from rvd_interfaces.msg import Verdict

THRUST_COMMAND = 'rvd_interfaces/msg/ThrustCommand'
SETTLE_S = 3.0                  # [s] wall time without news after which a look back is complete
TELL_S = 3.0                    # [s] wall time in which the run itself says who is a stranger
STORE_S = 0.3                   # [s] wall time in which the recorder gets that, too
GLANCE_S = 0.05                 # [s] wall time between two looks at the flight
DECIDES = {BY_NOBODY: 'nobody', BY_PILOT: 'pilot', BY_AUTO: 'auto', BY_GUARD: 'guard'}


def step_of(message: Any, step_ns: int) -> int:
    """Return the step that a message of a run is of: its own, or that of its stamp; -1: none."""
    step = getattr(message, 'step', getattr(message, 'data', None))
    if step is not None:
        return step
    stamped = next(iter(message.transforms), None) if hasattr(message, 'transforms') else message
    return -1 if stamped is None else ns_of(stamped.header.stamp) // step_ns


class FlightWatch:
    """Follows one run; `spin` it, then ask."""

    def __init__(self, roster: Roster, domain: int, run_id: str,
                 told: Callable[[], list[Message]] = list,
                 page: Pulse | None = None) -> None:
        """
        Join the domain of a run.

        `told`: returns what the judge's process has told so far by a line of its own. What is on
        /run/verdict and /run/events anybody may have written. `page`: that of the run, on which
        readers mark the topics with a trace of a second writer.
        """
        self._run_id, self._told, self._page = run_id, told, page or Pulse()
        self._roster, self._run = roster, roster.scenario.run
        self._held = roster.scenario.has_shared('joy_input') and \
            roster.scenario.part('operation').joy_input == 'held'
        self._truth = roster.diagram.truth.name
        self._command = next((name for name, kind in roster.topics.items()
                              if kind == THRUST_COMMAND and name.startswith('/ground/')
                              and roster.diagram.writer_of[name].control), None)
        self._back = next((leg.status.name for leg in roster.diagram.legs()
                           if leg.name == 'link_back'), None)
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
        self._verdict, self._final = None, None
        self._events: list[Any] = []
        self._seen: dict[str, str] = {}         # what was said of a second writer, by topic
        self._writers = Writers(roster, run_id, self._node)
        self._traces = Traces(roster, run_id, lambda: self._node, written=self._written)
        self._traced: dict[str, None] = {}      # the topics with such a trace
        self._waited_for = set(roster.names) - {
            e.name for e in roster.diagram.externals if e.foreign}
        self.refused: dict[str, str] = {}       # by node: what it said last that it had left out
        self._steps = 0                         # truth messages looked at
        self._flown = self._page.flown          # the newest step that the plant has noted
        self.progress_at = time.monotonic()     # when the last one came, or was noted
        for topic in filter(None, (self._truth, self._command, self._back)):
            self._subscribe(topic, lambda data, topic=topic: self._keep(topic, data), raw=True)
        self._subscribe('/run/ready', self._on_ready)
        self._subscribe('/run/pause', self._on_pause)
        self._subscribe('/run/verdict', self._on_verdict)
        self._subscribe('/run/events', self._on_event)

    def _subscribe(self, topic: str, callback: Any, raw: bool = False) -> None:
        profile = qos.of(topic, self._held)
        numbers = self._traces.numbers(topic)

        def call(message: Any, info: dict) -> None:     # rclpy counts the arguments
            numbers(info)
            callback(message)
        self._traces.follow(topic, self._node.create_subscription(
            message_type(self._roster.topics[topic]), topic, call,
            _newest(profile) if raw else profile, raw=raw))

    @property
    def begun(self) -> bool:
        """Whether this run has begun: what comes before may be of another run in this domain."""
        return self._roster.diagram.plant in self.ready

    @property
    def steps(self) -> int:
        """
        How many messages of the truth were looked at.

        One that was heard before its plant said that it is ready counts once it has: of a run that
        hangs in its first steps nothing else may come.
        """
        return self._steps if self.begun else 0

    @property
    def verdict(self) -> Any:
        """The last verdict of this run, the final one as its judge told it; None before any."""
        if self._final is None:
            self._final = next((deserialize_message(message.content, Verdict)
                                for message in self._told() if message.kind == VERDICT), None)
        return self._final or (self._verdict if self.begun else None)

    def new_events(self) -> list[Any]:
        """Return what has happened since the last call."""
        if not self.begun:
            return []
        events = self._events[:]
        self._events.clear()
        return events

    def _on_ready(self, message: Any) -> None:
        node, run = who_is_ready(message.data, self._run_id)
        if run == self._run_id:
            self.ready.add(node)

    def _keep(self, topic: str, data: bytes) -> None:
        self._raw[topic] = data
        if topic == self._truth:
            self._steps += 1
            self.progress_at = time.monotonic()
            time.sleep(GLANCE_S)                # what comes meanwhile replaces what came before

    def _on_pause(self, message: Any) -> None:
        self.paused = message.data
        self.progress_at = time.monotonic()

    def _on_event(self, event: Any) -> None:
        self._events.append(event)
        if event.code == 'REFUSED' and event.node in self._roster.names:
            self.refused[event.node] = event.text

    def _on_verdict(self, message: Any) -> None:
        if not message.final:                   # to be shown meanwhile
            self._verdict = message

    def _note(self, words: str) -> None:
        where = words.partition(': ')[0]
        if where not in self._seen or self._seen[where].endswith(NAMELESS):
            self._seen[where] = words

    def spin(self, seconds: float) -> None:
        """Take in what arrives during `seconds` of wall time."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            # Always the same timeout: with another one the executor begins its round anew, and
            # the first topic that is always ready starves the rest.
            self._executor.spin_once(timeout_sec=GLANCE_S)
            if self._page.flown != self._flown:     # it goes on, though this process may be deaf
                self._flown, self.progress_at = self._page.flown, time.monotonic()
            begun = self._waited_for <= self.ready
            if begun and not self._traces.begun:
                self._traces.begin()
            self._look_for_traces()
            for stranger in self._writers.look(begun, self._traced):
                if stranger.counts:
                    self._note(stranger.words)

    def _written(self, topic: str) -> int | None:
        """Return how many messages the run has written on a topic; None: that is not counted."""
        return (self._page.written(COUNTED.index(topic))
                if self._page.inherits and topic in self._roster.counted else None)

    def _look_for_traces(self, last: bool = False) -> None:
        for topic in self._traces.look(last):   # the monitor is to know of it, too
            self._page.mark(self._roster.place_of(topic))
            self._traced[topic] = None
        self._traced |= dict.fromkeys(self._roster.at_places(self._page.marked))

    @property
    def strangers(self) -> list[str]:
        """
        Sentences that say who wrote where only nodes of the run may; one for each topic.

        The monitor sees what this process may miss, and the reverse.
        """
        for words in self._told_of_strangers():
            self._note(words)
        return list(self._seen.values())

    def _told_of_strangers(self) -> list[str]:
        return [message.content.decode() for message in self._told() if message.kind == STRANGER]

    def hear_of_strangers(self) -> None:
        """Let the judge's node say who wrote where nobody may: the recorder hears that, too."""
        until = time.monotonic() + TELL_S
        while not self._told_of_strangers() and time.monotonic() < until:
            self.spin(GLANCE_S)
        self.spin(STORE_S)

    def is_written(self, topic: str) -> bool:
        """Say whether any node publishes a topic."""
        return self._node.count_publishers(topic) > 0

    def newest(self, topic: str | None) -> Any:
        """Return the newest message of a shown topic, decoded; None before the first."""
        data = self._raw.get(topic)
        return None if data is None else deserialize_message(
            data, message_type(self._roster.topics[topic]))

    def line(self) -> str:
        """
        Return one line of progress: time, range and rate, limited measures, who decides, delay.
        """
        truth, command, back = map(self.newest, (self._truth, self._command, self._back))
        if truth is None or not self.begun:
            return ''
        words = [f't {truth.step * self._run.step_s:6.1f} s', *_motion(truth)]
        if self.verdict is not None:
            words += [f'{m.words} {m.said}' for m in from_message(self.verdict).measures
                      if m.known and m.limited]
        if command is not None:
            words.append(_decides(command))
        if back is not None:
            if math.isfinite(back.delay_p50):           # unknown until a frame has come down
                words.append(f'transit {back.delay_p50:4.2f} s')
            words.append(f'one way {back.play_out_delay:g} s')
        return '  '.join([*words, *(['PAUSED'] if self.paused else [])])

    def who_owes(self) -> list[str]:
        """
        Return the nodes that owe a message, from the last step that each topic remembers.

        Topics of the ring keep their history for late readers, so they are read only now. A hung
        node gives nothing back, so the wait ends when nothing new has come for a while.
        """
        last: dict[str, int] = {}

        def note(topic: str, kind: type):
            def take(data: bytes) -> None:
                step = step_of(deserialize_message(data, kind), self._run.step_ns)
                if step <= self._run.last_step:         # of this run, and no stranger's
                    last[topic] = max(step, last.get(topic, -1))
            return take

        topics = {t for name in self._roster.names for t in self._roster.emits(name)}
        for topic in (topics - {'/clock'}) | {'/run/recorded_step'}:
            kind = message_type(self._roster.topics[topic])
            self._node.create_subscription(kind, topic, note(topic, kind), qos.LATCHED, raw=True)
        known = -1
        while known < sum(last.values()):
            known = sum(last.values())
            self.spin(SETTLE_S)
        return self._roster.who_owes(last)

    def close(self) -> None:
        """Leave the graph."""
        self._look_for_traces(last=True)
        for topic in self._traced:
            self._note(Stranger(topic, '', False, True).words)
        self._traces.close()
        self._executor.shutdown()
        self._node.destroy_node()
        self._context.try_shutdown()


def _motion(truth: Any) -> list[str]:
    """Return range and rate along x, where the truth is a relative state."""
    if not hasattr(truth, 'position'):
        return []
    p, v = truth.position, truth.velocity
    return [f'range {(p.x * p.x + p.y * p.y + p.z * p.z) ** 0.5:6.2f} m', f'rate {v.x:6.3f} m/s']


def _newest(profile: QoSProfile) -> QoSProfile:
    return QoSProfile(depth=1, reliability=profile.reliability, durability=profile.durability)


def _decides(command: Any) -> str:
    if command is None:
        return ''
    if command.decided_by == BY_BLEND:
        return f'pilot {command.pilot_weight:g} + auto {1.0 - command.pilot_weight:.2g}'
    return DECIDES.get(command.decided_by, '?')
