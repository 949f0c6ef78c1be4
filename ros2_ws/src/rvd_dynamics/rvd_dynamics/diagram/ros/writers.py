"""
Who writes on the topics of a run, looked at from outside the ring: nobody but its own nodes may.

DDS lets anybody write anywhere, and a message does not say who wrote it. What can be known is who
announces a writer. The table of the run (`Roster.may_write`) says who may; everybody else is named,
once. It is looked at some times a second: to count the writers of a topic takes microseconds, and
only where their number has changed are they asked for by name, and now and then all of them.

A writer that comes and goes between two looks leaves traces with who reads (`traces`): it is told
of, too, by its name if that was seen.
"""

from collections import Counter
from collections.abc import Callable, Iterable
import os
from pathlib import Path
import time
from typing import Any, NamedTuple

from rvd_dynamics.diagram.identity import AREA
from rvd_dynamics.diagram.roster import ALSO_WRITES, NAMELESS, Roster, SECOND_WRITER

LOOK_S = 0.1                    # [s] wall time between two looks at the numbers of writers
NAMED_S = 0.25                  # [s] wall time in which one is seen who has left a trace
NAMES_S = 1.0                   # [s] wall time between two looks at all names
# [s] wall time in which the node of a new writer becomes known, for each process that wants a core
NAMELESS_S = 0.5
LATE_S = 5.0                    # [s] the same where one of the run's own has not been seen yet
# [s] wall time that nodes of another run get to leave, which they do when they see this one
OTHER_RUN_S = 15.0
UNKNOWN_NODE = '_NODE_NAME_UNKNOWN_'    # rmw: of a writer that was seen before its node
OF_ANY_NODE = ('/parameter_events', '/rosout')      # every node of ROS writes on one of them
MANY = 100                      # strangers that are told: who makes more need not be told of more
LOAD = Path('/proc/loadavg')
PREFIX = 12                     # [bytes] of a writer's id: those of its process


class Stranger(NamedTuple):
    """A writer that is none of the run's."""

    topic: str
    node: str                           # name of its node; empty: it has none
    twin: bool                          # a node of the run has that name, too
    counts: bool                        # what it writes acts on the run

    @property
    def code(self) -> str:
        """Code of the event that says so."""
        return SECOND_WRITER if self.counts else ALSO_WRITES

    @property
    def words(self) -> str:
        """What a person is told."""
        who = f'{"another " * self.twin}node {self.node}' if self.node else NAMELESS
        return f'{self.on}{who}'

    @property
    def on(self) -> str:
        """How these words begin, whoever it is."""
        return f'a second writer on {self.topic}: '


class _Waiting(NamedTuple):
    """A writer of which it is not known yet whether it is a stranger."""

    since: float                        # [s]
    of_another_run: bool
    seems: str                          # of which node; empty: not known


class Writers:
    """
    The writers of one run; ask `look` often.

    Parameters
    ----------
    roster : Roster
    run_id : str
        Enclave of the run; '/' of nodes that were started by hand.
    graph : rclpy.node.Node
        Any node in the domain: counts and names writers, and names nodes with their enclaves.
    clock : callable
        Wall time [s].
    crowd : callable
        How many processes want each core: names come later then.
    """

    def __init__(self, roster: Roster, run_id: str, graph: Any,
                 clock: Callable[[], float] = time.monotonic,
                 crowd: Callable[[], float] | None = None) -> None:
        self._roster, self._run_id, self._graph, self._clock = roster, run_id, graph, clock
        self._crowd = crowd or processes_a_core
        self._counts = dict.fromkeys(roster.topics, 0)
        # Of each topic: the writers that are the run's, by their ids, with their nodes' names.
        self._ours: dict[str, dict[bytes, str]] = {topic: {} for topic in roster.topics}
        # Those of them that have gone, which DDS finds again if all of a run stood still.
        self._left: dict[str, dict[bytes, str]] = {topic: {} for topic in roster.topics}
        self._waiting: dict[str, dict[bytes, _Waiting]] = {topic: {} for topic in roster.topics}
        self._names = frozenset(name for topic in roster.topics
                                for name in roster.may_write(topic).names) | {''}
        self._told: set[Stranger] = set()
        self._found: dict[str, set[bytes]] = {topic: set() for topic in roster.topics}
        self._looked = self._named = float('-inf')
        self._begun_at: float | None = None
        self._met = float('-inf')               # when a node of another run was there last
        self._neighbours: dict[bytes, set[str]] | None = None   # of each process, in this look
        self._traced: dict[str, float] = {}     # topics with a trace of a stranger, and since when

    def look(self, begun: bool, traced: Iterable[str] = ()) -> list[Stranger]:
        """
        Return who is there that should not be, each once; nothing between two looks.

        `begun`: every node of the run is there. Before that, a writer whose node is not known yet
        may be one of them. `traced`: topics on which readers know that there was a stranger.
        """
        now = self._clock()
        if now - self._looked < LOOK_S:
            return []
        self._looked, self._neighbours = now, None
        if begun and self._begun_at is None:
            self._begun_at = now
        every = now - self._named >= NAMES_S
        if every:
            self._named = now
        found: dict[Stranger, None] = {}
        for topic, count in self._counted().items():
            if every or count != self._counts[topic] or self._waiting[topic]:
                self._counts[topic] = count
                found |= dict.fromkeys(self._of_topic(topic, now))
        found |= dict.fromkeys(self._nameless(traced, now, {stranger.topic for stranger in found}))
        new = [stranger for stranger in found if stranger not in self._told]
        new = new[:MANY - len(self._told)]
        self._told.update(new)
        return new

    def _nameless(self, traced: Iterable[str], now: float, named: set[str]) -> list[Stranger]:
        """Return who has left a trace and is not seen, after a moment in which he may be."""
        found = []
        for topic in traced:
            since = self._traced.setdefault(topic, now)
            if now - since >= NAMED_S and topic not in named | {told.topic for told in self._told}:
                seems = {waiting.seems for waiting in self._waiting[topic].values()} - {''}
                node = seems.pop() if len(seems) == 1 else ''
                rule = self._roster.may_write(topic)
                found.append(Stranger(topic, node, node in rule.names, rule.counts))
        return found

    def _counted(self) -> dict[str, int]:
        """Return the numbers of writers; what rclpy adds to the question takes 20 times as long."""
        with (handle := self._graph.handle):
            return {topic: handle.get_count_publishers(topic) for topic in self._counts}

    # -- one topic --------------------------------------------------------------------------

    def _of_topic(self, topic: str, now: float) -> list[Stranger]:
        # Who comes or leaves while it is asked for is among the nodes before or after that.
        before_that = self._of_other_runs() if self._waiting[topic] or \
            self._counts[topic] > len(self._ours[topic]) else Counter()
        there = self._on(topic)
        ours, waiting = self._ours[topic], self._waiting[topic]
        rule = self._roster.may_write(topic)
        left = self._left[topic]
        for gid in set(ours) - set(there):
            left[gid] = ours.pop(gid)
        for gid in set(left) & set(there):      # DDS took it for dead: all of a run stood still
            ours[gid] = left.pop(gid)
        self._found[topic] &= set(there)
        for gid, node in there.items():
            if gid in ours:                     # a node that leaves has its name taken first
                ours[gid] = ours[gid] or node
            elif self._takes(topic, gid, node):
                ours[gid] = node
                waiting.pop(gid, None)
        elsewhere: Counter[str] | None = None   # nodes of another run, asked for where it matters
        found = []

        def stranger(gid: bytes, node: str) -> None:
            self._found[topic].add(gid)
            found.append(Stranger(topic, node, bool(node) and node in rule.names, rule.counts))
        for gid, node in there.items():
            if gid in ours or gid in self._found[topic]:
                continue
            guess = '' if node else self._neighbour(gid)
            if guess not in self._names:        # no group of the run's that is still coming up
                node = guess
            if elsewhere is None:
                elsewhere = before_that | self._of_other_runs()
            before = waiting.get(gid, _Waiting(now, False, ''))
            of_another = before.of_another_run or (
                elsewhere[node] > 0 if node else now - self._met < OTHER_RUN_S)
            if node and of_another:
                elsewhere[node] -= 1            # one writer for each such node
            waiting[gid] = _Waiting(before.since, of_another, node or guess or before.seems)
            if now >= self._until(topic, node, waiting[gid]):
                stranger(gid, waiting.pop(gid).seems)
        for gid in set(waiting) - set(there):   # it has gone
            before = waiting.pop(gid)
            if not (before.of_another_run or self._begun_at is None or self._may_come(topic)):
                stranger(gid, before.seems)
        return found

    def _takes(self, topic: str, gid: bytes, node: str) -> bool:
        """Say whether a writer is one that the run has there."""
        rule, present = self._roster.may_write(topic), self._ours[topic].values()
        if rule.anyone:
            return not present
        if node not in rule.names or node in present:
            return False
        if not rule.shared:
            return True
        # One for each process of the run, and in the process in which that node writes the rest.
        home = self._roster.home_of(node)
        homes = self._homes()
        known = homes.get(gid[:PREFIX])
        if known is None:
            return home not in homes.values() and \
                home not in map(self._roster.home_of, present)
        return known == home

    def _homes(self) -> dict[bytes, str]:
        """Return the processes of the run that are known, by what begins the ids of writers."""
        return {gid[:PREFIX]: self._roster.home_of(node)
                for topic, ours in self._ours.items()
                if not self._roster.may_write(topic).shared for gid, node in ours.items() if node}

    def _may_come(self, topic: str) -> bool:
        """Say whether one of the run's own writers has not been seen yet."""
        rule = self._roster.may_write(topic)
        return rule.shared or not set(rule.names) <= set(self._ours[topic].values())

    def _until(self, topic: str, node: str, waiting: _Waiting) -> float:
        """Return until when a writer may be there before it counts as a stranger [s]."""
        if waiting.of_another_run:
            return waiting.since + OTHER_RUN_S
        if node:
            return waiting.since
        if self._begun_at is None:
            return float('inf')
        patience = LATE_S if self._may_come(topic) else NAMELESS_S
        return max(waiting.since, self._begun_at) + patience * max(self._crowd(), 1.0)

    def _neighbour(self, gid: bytes) -> str:
        """
        Return the one node that is known in the process of a writer; empty if there is not one.

        The name of a node comes with its first writers, that of a new writer some time after it.
        """
        if self._neighbours is None:
            self._neighbours = {}
            for topic in (*OF_ANY_NODE, *self._counts):
                for other, node in self._on(topic).items():
                    self._neighbours.setdefault(other[:PREFIX], set()).add(node)
        names = self._neighbours.get(gid[:PREFIX], set()) - {''}
        return next(iter(names)) if len(names) == 1 else ''

    def _on(self, topic: str) -> dict[bytes, str]:
        """Return the writers of a topic by their ids, with the names of their nodes."""
        return {bytes(info.endpoint_gid): _name(info.node_name, info.node_namespace)
                for info in self._graph.get_publishers_info_by_topic(topic)}

    def _of_other_runs(self) -> Counter[str]:
        """Return how many nodes of each name are there of another run of `fly`."""
        found = Counter(
            _name(name, namespace) for name, namespace, enclave
            in self._graph.get_node_names_and_namespaces_with_enclaves()
            if enclave != self._run_id and enclave.startswith(AREA))
        if found:
            self._met = self._looked
        return found


def _name(name: str, namespace: str) -> str:
    """Return the name of a node as a person writes it; empty where it is not known."""
    if not name or name == UNKNOWN_NODE:
        return ''
    return name if namespace in ('', '/') else f'{namespace}/{name}'


def processes_a_core() -> float:
    """Return how many processes want each core, now or in the last minute; 0: not known."""
    try:
        last_minute, _, _, now, _ = LOAD.read_text(encoding='ascii').split()
        return max(float(last_minute), float(now.partition('/')[0])) / (os.cpu_count() or 1)
    except (OSError, ValueError):
        return 0.0
