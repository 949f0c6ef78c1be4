"""
The bag writer as a node: every topic of the run, as it came, into a rosbag2 MCAP bag.

Reads       every topic of the run, and once a second whatever else has appeared; what nodes of
            the same process write passes by hand, serialised
Publishes   /run/recorded_step      std_msgs/UInt64, every 16 steps: in lock step the dynamics
            do not run further ahead of it than they must
Parameters  the fields of RecorderParams

The scenario is the first message. A message's log time is the simulation time of its step (of
the newest step seen, for messages that belong to none), its publish time is wall time. Steps
that never came, and messages that the disk did not take, are counted per topic and the counts
stored as metadata records `rvd_missing` and `rvd_lost`. A message of a ring topic whose step cannot
be, or after which its writer does not go on, is refused and not stored. What `fly` sees of the
processes of the run (SILENT, ENDED_EARLY, GIVEN_UP) is stored with the events, though nobody
publishes it.
"""

import struct
import time
from pathlib import Path
from typing import Callable

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import serialize_message
from std_msgs.msg import UInt64

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import require
from rvd_dynamics.recording.bag_writer import BagWriter
from rvd_dynamics.recording.params import RecorderParams
from rvd_dynamics.recording.rosbag2 import qos_words
from rvd_dynamics.recording.steps import StepLedger, step_reader
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.boundary import Refused
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.horizon import Horizon
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.news import News
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.roster import COMMON, MONITOR, RECORDER, RECORDER_LEAD
from rvd_interfaces.msg import RunEvent

RECORDED_STEP = '/run/recorded_step'
NOT_RECORDED = (RECORDED_STEP, '/parameter_events')     # our own, and what no run changes
SCENARIO, VERDICT, EVENTS = '/run/scenario', '/run/verdict', '/run/events'
MOST_BYTES = 1 << 20            # of a message at each firing: ours have a few kB
REPORT_EVERY = 16               # [steps]
LOOK_PERIOD_S = 1.0             # [s] wall time between two looks for new topics
DRAIN_PERIOD_S = 0.1            # [s] wall time between two looks whether all has come
# [s] wall time without a message of a step: no more will come. A packet that the socket had no room
# for is repaired at the writer's next heartbeat, which comes every 3 s.
SILENCE_S = 4.0
GRACE_S = 0.2                   # [s] wall time for events and the like after the last step
NOTE_MISSING = 'rvd_missing'    # metadata record: topic -> steps that never came
# What a nearly full disk is kept for, besides the story of the run in /run/*.
COMMANDS = ('/joy', '/ground/command', '/ground/uplink', '/onboard/command',
            '/onboard/thruster_command')


def worth(topic: str) -> int:
    """Say what `topic` is worth on a disk that is nearly full: 2 to the last, 1 longer than 0."""
    return 2 if topic.startswith('/run/') else int(topic in COMMANDS)


class BagRecorder(RunNode):
    """The recorder as a node."""

    _bag: BagWriter | None = None

    def __init__(self, host: Host) -> None:
        super().__init__(host, RECORDER)
        self._truth = self.roster.diagram.truth.name
        self._ledger = StepLedger()
        self._early: list[tuple] | None = []    # kept until the scenario has gone first
        self._pending: list[tuple] = []         # what has come since the last write
        self._quiet = 0                         # looks since a message that one of the nodes owed
        self._complete: float | None = None     # since when the last step is here
        self._judged_step = -1
        self._recorded: set[str] = set()
        self._unknown: set[str] = set()         # topics of types that are not installed
        self._suspects: dict[str, tuple] = {}   # of each topic, what came before it was due
        self._horizon = Horizon(self.run, self.run.last_step, queue=RECORDER_LEAD + REPORT_EVERY,
                                made=host.bound_of(*self.roster.blocks))
        self._complained, self._news = False, News(host)
        self._draining = None
        self._stores: dict[str, Callable] = {}
        self._steps = self.writer(RECORDED_STEP, UInt64)
        for topic, period in self.roster.owed.items():
            self._ledger.expect(topic, period)
        settings: RecorderParams = self.scenario.settings(RECORDER)
        self._bag = self._open(settings.bag_dir)

    def connect(self) -> None:
        """Listen to every topic of the run."""
        # The executor looks in the order of creation: the scenario before what came with it.
        for topic, kind in sorted(self.roster.topics.items(), key=lambda i: i[0] != SCENARIO):
            if topic not in NOT_RECORDED:
                self._record(topic, kind, self.quality(topic), qos.taken(topic, self.held))
        self._bag.describe()
        self.create_timer(LOOK_PERIOD_S, self.guarded(self._look))

    @staticmethod
    def _open(directory: str) -> BagWriter:
        require(bool(directory), 'bag_dir', 'name a directory', repr(directory))
        try:
            return BagWriter(Path(directory), worth)
        except OSError as error:
            raise BadInput(f'bag_dir {directory}: {error.strerror}') from None

    # -- topics ---------------------------------------------------------------------------

    def _record(self, topic: str, kind: str, offered: QoSProfile,
                taken: QoSProfile | None = None) -> None:
        reliable = offered.reliability == ReliabilityPolicy.RELIABLE
        latched = offered.durability == DurabilityPolicy.TRANSIENT_LOCAL
        self._bag.add_topic(topic, kind, qos_words(offered.depth, reliable, latched))
        self._recorded.add(topic)
        store = self._stores[topic] = self._writer_of(topic, kind)
        if topic not in COMMON and self.host.is_local(topic):
            self.host.keep(topic, self.guarded(store))
            return
        taken = taken or offered
        deep = QoSProfile(depth=qos.DEPTH, reliability=taken.reliability,
                          durability=taken.durability)
        read_step = step_reader(kind, self.run.step_ns)

        owed = topic in self._ledger.last
        strict = owed or topic == VERDICT

        def came(data: bytes, info: dict) -> None:
            try:
                step = self.step if read_step is None else self._believed(
                    read_step(data), len(data), strict)
            except (Refused, struct.error) as why:
                self.refuse(topic, str(why))
                return
            message = (step, data, info['source_timestamp'],
                       info['publication_sequence_number'] or 0)
            for each in self._in_turn(topic, message) if owed else (message,):
                store(*each)
            if topic == self._truth:
                self.rest(info)
        self.watch_raw(topic, message_type(kind), came, deep)

    def _believed(self, step: int, size: int, strict: bool) -> int:
        """
        Return the step at which a message is stored: its own, or the newest if that cannot be.

        Raises
        ------
        Refused
            If it is `strict`, of a topic that has a message at each firing, or the verdict.
        """
        if strict and size > MOST_BYTES:
            raise Refused(f'step {step}: {size} bytes are more than the {MOST_BYTES} of any '
                          'message here')
        if self._horizon.believes(step, self.step):
            return step
        if strict:
            raise Refused(self._horizon.words(step, self.step))
        return self.step

    def _in_turn(self, topic: str, message: tuple) -> tuple:
        """
        Return what of a topic may be stored now that this message has come.

        A reliable writer leaves no step out; one that seems to has either lost some, and goes on
        from there, or is not the writer.
        """
        step, suspect = message[0], self._suspects.pop(topic, None)
        due, before = self._ledger.due(topic), ()
        if suspect is not None and step > suspect[0]:
            due, before = due + suspect[0] - self._ledger.last[topic], (suspect,)
        elif suspect is not None:
            self.refuse(topic, f'step {suspect[0]} came where {due} was due')
        if step > due:
            self._suspects[topic] = message
            return before
        return (*before, message)

    def _clear(self, last: int) -> None:
        """Store what came before it was due, up to a step; nothing more comes to go on with it."""
        for topic, (step, *rest) in list(self._suspects.items()):
            if step <= last:
                del self._suspects[topic]
                self._stores[topic](step, *rest)

    def _writer_of(self, topic: str, kind: str) -> Callable:
        """Return what stores the messages of one topic."""
        stepped = step_reader(kind, self.run.step_ns) is not None
        starts = stepped and topic not in COMMON
        owed, step_ns = topic in self._ledger.last, self.run.step_ns
        paces, judges, tells = topic == self._truth, topic == VERDICT, topic == EVENTS

        def store(step: int, data: bytes, sent_ns: int = 0, sequence: int = 0) -> None:
            if not stepped:
                step = self.step
            elif step > self.step:
                self.step = step
            message = (topic, data, max(step, 0) * step_ns, sent_ns or time.time_ns(), sequence)
            if self._early is None:
                self._pending.append(message)
            else:
                self._begin_with(message, starts)
            if tells:
                self._news.read(data)
            if owed:
                self._quiet = 0
                self._ledger.saw(topic, step)
                if self.host.final_step is not None:
                    self.host.ending.goes_on(step)
            if judges:
                self._judged_step = step
            if paces:
                self.settle()
                if step % REPORT_EVERY == 0:
                    self.host.publish(self._steps, RECORDED_STEP, step, UInt64(data=step))
                    self._report()
        return store

    def _begin_with(self, message: tuple, starts: bool) -> None:
        """Keep what came before the scenario; let that go first."""
        if message[0] == SCENARIO:
            self._begin([message, *self._early])
        elif starts:                                    # the run has begun without a scenario
            self._begin([*self._early, message])
        else:
            self._early.append(message)

    def _begin(self, messages: list[tuple]) -> None:
        self._early = None
        self._pending += messages

    def settle(self) -> None:
        """Write what has come: once a step, and whenever the process is about to wait."""
        if self._pending:
            messages, self._pending = self._pending, []
            self._bag.write_all(messages)

    def on_ready(self) -> None:
        """Take viewers' topics in from the beginning."""
        self._look_for_topics()

    def _look(self) -> None:
        self._store_news()
        self._look_for_topics()

    def _store_news(self, last: bool = False) -> None:
        """Store what is on the page of the run: processes may hear nothing, this one too."""
        for node, code, step, text in self._news.take(max(self.step, 0), last):
            header = header_at(step * self.run.step_ns, self.run.frame_id)
            self._stores[EVENTS](self.step, serialize_message(RunEvent(
                header=header, step=step, node=node, code=code, text=text)))

    def _look_for_topics(self) -> None:
        """Record topics that are not in the graph's table, viewers' topics for instance."""
        for topic, kinds in self.get_topic_names_and_types():
            known = topic in self._recorded or topic in self._unknown
            if known or topic in NOT_RECORDED or '/_' in topic:
                continue
            writers = self.get_publishers_info_by_topic(topic)
            if not writers:
                continue
            try:
                self._record(topic, kinds[0], _adapted([w.qos_profile for w in writers]))
            except (LookupError, ImportError, AttributeError, ValueError) as error:
                self._unknown.add(topic)
                self.event('UNRECORDED', f'{topic}: {error}')

    # -- state of the bag -----------------------------------------------------------------

    def _report(self) -> None:
        if self._bag.trouble and not self._complained:
            self._complained = True
            self.trouble['disk'] = self._bag.trouble
            self.get_logger().error(self._bag.trouble)
            self.event('DISK', self._bag.trouble)
        self.host.diagnose()

    def on_end(self, final_step: int) -> None:
        """Wait for the last step of every topic, which may still be on its way."""
        self._quiet, self._complete = 0, None
        self._clear(final_step)
        if self._draining is None:
            self._draining = self.create_timer(DRAIN_PERIOD_S, self.guarded(self._drain))

    def _drain(self) -> None:
        if self.host.final_step is None:        # it was not the end
            return
        now = time.monotonic()
        if self._complete is None and self._all_here():
            self._complete = now
        self._quiet += 1
        if self._quiet > SILENCE_S/DRAIN_PERIOD_S or (
                self._complete is not None and now - self._complete > GRACE_S):
            self.finish()

    def _all_here(self) -> bool:
        final = self.host.final_step
        judged = self._judged_step >= final or MONITOR not in self.roster.names
        return judged and self._ledger.reached(final)

    def close(self) -> None:
        """Close the bag; nobody waits for the recorder's own last messages."""
        if self._bag is None:                   # it could not be opened
            return
        self._clear(self.step if self.host.final_step is None else self.host.final_step)
        if EVENTS in self._stores:              # else it has not begun to listen
            self._store_news(last=True)
        if self._early:
            self._begin(self._early)
        self.settle()
        known = self._known()
        self._ledger.end(known)
        missing = {topic: str(n) for topic, n in self._ledger.missing.items()}
        unheard = known >= 0 and self.host.final_step is None
        self._bag.close({NOTE_MISSING: missing}, **({'last_step': str(known)} if unheard else {}))
        self.host.note_lost(sum(self._bag.lost.values()))

    def _known(self) -> int:
        """
        Return the last step of which every topic owes its message, as far as it is known; or -1.

        A recorder that was stopped has not heard how far the run came: the plant has noted it,
        unless it was started by hand. In the newest step of a run that was interrupted nodes may
        not have fired.
        """
        if self.host.final_step is not None:
            return self.host.final_step
        made, end = self.host.made, self.host.noted_end
        if made is None:
            return -1
        behind = made - 1 > self._ledger.last.get(self._truth, made)
        return end if end >= 0 else made - 1 if behind else -1


def _adapted(offers: list[QoSProfile]) -> QoSProfile:
    """Return the strictest profile that every one of the writers satisfies."""
    reliable = all(o.reliability == ReliabilityPolicy.RELIABLE for o in offers)
    latched = all(o.durability == DurabilityPolicy.TRANSIENT_LOCAL for o in offers)
    return QoSProfile(
        depth=max([o.depth for o in offers]) or 1,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=(DurabilityPolicy.TRANSIENT_LOCAL if latched
                    else DurabilityPolicy.VOLATILE))
