"""
Traces that a second writer leaves at a reader, though it comes and goes between two looks at it.

DDS counts for each reader all the writers that it was ever matched with, and no message gets to a
reader before that. And a writer numbers what it writes from 1, each message by one more than the
last: in what two of them have written the numbers do not ascend. Where a node of the run seldom
writes or several do (`roster.COUNTED`) that says nothing; there each process of the run counts on
its page what it writes (`pulse`), before it does: who has read more has read a stranger. None of
them says who it was; that is known while it is there (`writers`).

Nodes of another run that come into this one match its readers, too, until they have seen it and
leave. They write nothing: the messages count at once, the count of writers only where no such node
is seen, as the one of another run is by its enclave.

Where all of a run stood still (a paused container, SIGSTOP), DDS takes the writers for dead, finds
them again and hands over once more what they keep: both traces are of the run itself then, and are
left out until it has settled.

Source  OMG, Data Distribution Service 1.4, 2.2.4.1: SUBSCRIPTION_MATCHED, total_count; The
        Real-time Publish-Subscribe Protocol 2.5, 8.3.5.4: sequence numbers of a writer.
"""

from collections.abc import Callable
import time
from typing import Any

from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.subscription import Subscription

from rvd_dynamics.diagram.identity import AREA
from rvd_dynamics.diagram.ros.writers import OTHER_RUN_S, processes_a_core, UNKNOWN_NODE
from rvd_dynamics.diagram.roster import COUNTED, Roster

# [s] wall time in which a node of another run becomes known by its writer, for each process that
# wants a core
SURE_S = 0.3
STILL_S = 5.0                   # [s] wall time without a look: this process stood still
# [s] wall time in which writers are found again: participants announce themselves every 3 s, and
# what is reliable is asked for as often
SETTLE_S = 10.0
MATCHED = _rclpy.rcl_subscription_event_type_t.RCL_SUBSCRIPTION_MATCHED


class _Count:
    """How many messages a reader has read of a topic, and what of it need not be written."""

    def __init__(self, topic: str) -> None:
        self.topic, self.read, self.allowed = topic, 0, 0
        self.since: float | None = None         # when it was asked first who has written [s]


class Traces:
    """
    What the readers of one process know of the writers of a run; ask `look` often.

    Parameters
    ----------
    roster : Roster
    run_id : str
        Enclave of the run; '/' of nodes that were started by hand.
    graph : callable
        Returns any node in the domain, which names nodes and writers.
    clock : callable
        Wall time [s].
    crowd : callable
        How many processes want each core: names come later then.
    written : callable
        Returns how many messages the run has written on a topic of COUNTED; None: nobody knows.
    """

    def __init__(self, roster: Roster, run_id: str, graph: Callable[[], Any],
                 clock: Callable[[], float] = time.monotonic,
                 crowd: Callable[[], float] = processes_a_core,
                 written: Callable[[str], int | None] = lambda topic: None) -> None:
        self._roster, self._run_id, self._graph = roster, run_id, graph
        self._clock, self._crowd, self._written = clock, crowd, written
        self._matches: dict[str, Any] = {}      # of each topic: what counts its writers
        self._allowed: dict[str, int] = {}      # writers that each may ever have had
        self._since: dict[str, float] = {}      # when a reader had more than that first
        self._met = float('-inf')               # when a node of another run was there last
        self._looked, self._settled = self._clock(), float('-inf')
        self._found: dict[str, None] = {}
        self._told: set[str] = set()
        self._counts: list[_Count] = []         # of each reader of a topic that is counted
        self._surplus = False                   # one of them has read more than was written
        self.begun = False

    def follow(self, topic: str, subscription: Subscription) -> None:
        """Count the writers of a reader, where it is known how many there may be."""
        if topic not in self._roster.topics:
            return
        rule = self._roster.may_write(topic)
        if rule.counts and not rule.anyone:
            with subscription.handle:
                self._matches[topic] = _rclpy.EventHandle(subscription.handle, MATCHED)

    def numbers(self, topic: str) -> Callable[[dict], None]:
        """Return what is to be shown where each message of a topic is from, in their order."""
        last, found, settles = 0, self._found, self._settles
        one = topic in self._roster.topics and self._is_of_one(topic)
        count = _Count(topic) if topic in COUNTED else None
        if count is not None:
            self._counts.append(count)

        def look(message_info: dict) -> None:
            nonlocal last
            if count is not None:
                count.read += 1
                self._surplus = self._surplus or self._beyond(count) > 0
            number = message_info['publication_sequence_number']
            if number is None:                  # a middleware that does not tell
                return
            if number <= last and one and not settles():
                found[topic] = None
            last = number
        return look

    def _is_of_one(self, topic: str) -> bool:
        rule = self._roster.may_write(topic)
        return rule.counts and len(rule.names) == 1 and not rule.anyone

    def begin(self) -> None:
        """Note the writers that are there at the start, when all of the run's own are."""
        self.begun = True
        for count in self._counts:              # what came before may be of a run that has left
            count.allowed += self._beyond(count)
        for topic in self._matches:
            self._allowed[topic] = max(self._own(topic), self._ever(topic))

    def _own(self, topic: str) -> int:
        """Return how many writers of the run a topic has."""
        if not self._roster.may_write(topic).shared:
            return self._roster.expected(topic)[0]
        external = self._roster.externals
        return len({self._roster.home_of(name) for name in self._roster.names
                    if not (name in external and external[name].foreign)})

    def _ever(self, topic: str) -> int:
        with (event := self._matches[topic]):
            return event.take_event().total_count

    @property
    def urgent(self) -> bool:
        """Whether a message has come that a second writer has written."""
        return self._surplus or len(self._found) > len(self._told)

    def look(self, last: bool = False) -> list[str]:
        """
        Return the topics on which there was a second writer, each once; `last`: be sure now.

        To be called at each turn of the loop until the run begins: a count that has changed and
        that nobody has read wakes the reader's process at once, again and again.
        """
        if not self.begun:
            for topic in self._matches:
                self._ever(topic)
        settles, self._surplus = self._settles(), False
        self._looked = self._clock()
        for count in self._counts if self.begun else ():
            self._judge(count, settles, last)
        for topic, allowed in self._allowed.items():
            ever = self._ever(topic)
            if settles:
                self._allowed[topic] = max(allowed, ever)
                self._since.pop(topic, None)
                continue
            if ever > allowed and self._is_nobodys(topic, last):
                self._found[topic] = None
            if ever > allowed and topic not in self._since:
                self._allowed[topic] = ever
        new = [topic for topic in self._found if topic not in self._told]
        self._told.update(new)
        return new

    def _beyond(self, count: '_Count') -> int:
        """Return how many messages a reader has that nobody of the run has written."""
        written = self._written(count.topic)
        return 0 if written is None else max(count.read - count.allowed - written, 0)

    def _judge(self, count: '_Count', settles: bool, last: bool) -> None:
        """
        See whether a reader has a message of a stranger.

        A node that the run began without may write where all do, and is there when it is asked
        for. Its name may come later than what it has written.
        """
        beyond, now = self._beyond(count), self._clock()
        if not beyond:
            return
        if not settles and count.topic not in self._found:
            writers = self._guests(count.topic)
            if writers is None and not last:
                count.since = now if count.since is None else count.since
                if now - count.since < SURE_S*max(self._crowd(), 1.0):
                    return                      # asked again at the next look
            if not writers and not self._may_be_of_another_run(count.topic, now):
                self._found[count.topic] = None
        count.since = None
        count.allowed += beyond

    def _guests(self, topic: str) -> set[str] | None:
        """
        Return who writes there that may, and that the run began without: a console.

        None: it is not known yet of all who are there.
        """
        guests = self._roster.may_write(topic).names - set(self._roster.names)
        if not guests:
            return set()
        writers = {info.node_name for info in self._graph().get_publishers_info_by_topic(topic)}
        return writers & guests or (None if UNKNOWN_NODE in writers else set())

    def _may_be_of_another_run(self, topic: str, now: float) -> bool:
        """Say whether nodes of another run have been here, which may have said something."""
        if not self._roster.may_write(topic).shared:
            return False
        self._look_for_others(now)
        return now - self._met < OTHER_RUN_S

    def _settles(self) -> bool:
        """Say whether this process has stood still, lately."""
        now = self._clock()
        if now - self._looked > STILL_S:
            self._settled = now + SETTLE_S
        return now < self._settled

    def _is_nobodys(self, topic: str, last: bool) -> bool:
        """Say whether there was a writer too many; asked again while it may be another run's."""
        now = self._clock()
        self._look_for_others(now)
        since = self._since.setdefault(topic, now)
        if now - self._met < OTHER_RUN_S or self._guests(topic):
            del self._since[topic]
            return False
        if not last and now - since < SURE_S*max(self._crowd(), 1.0):
            return False
        del self._since[topic]
        return True

    def _look_for_others(self, now: float) -> None:
        nodes = self._graph().get_node_names_and_namespaces_with_enclaves()
        if any(enclave.startswith(AREA) and enclave != self._run_id for _, _, enclave in nodes):
            self._met = now

    def close(self) -> None:
        """Let go of the readers."""
        for event in self._matches.values():
            event.destroy_when_not_in_use()
        self._matches, self._allowed = {}, {}
