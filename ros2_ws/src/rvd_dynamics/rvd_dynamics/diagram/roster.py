"""
Who takes part in a run: nodes, the processes that they share, and the topics between them.

Read from the diagram; it imports no ROS, so that tools may read it. The start-up barrier counts
its endpoints here, the recorder its topics, the bring-up its processes, and `fly` finds here who
owes a message.

    python -m rvd_dynamics.diagram.roster SCENARIO RUN_DIR [--headless]

prints one process a line for `scripts/bringup.sh`: name, package, executable, arguments.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
import shlex
import sys
from typing import NamedTuple

import yaml

from rvd_dynamics.diagram.block import External, GROUND, Leg, Read, WATCH
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.scenario import load, Scenario

# What a run says about itself, besides the signals of its diagram.
RUN_TOPICS = {
    '/clock': 'rosgraph_msgs/msg/Clock',
    '/run/scenario': 'std_msgs/msg/String',
    '/run/ready': 'std_msgs/msg/String',
    '/run/pause': 'std_msgs/msg/Bool',
    '/run/end': 'std_msgs/msg/UInt64',
    '/run/recorded_step': 'std_msgs/msg/UInt64',
    '/run/verdict': 'rvd_interfaces/msg/Verdict',
    '/run/events': 'rvd_interfaces/msg/RunEvent',
    '/diagnostics': 'diagnostic_msgs/msg/DiagnosticArray',
}
# Written by any node whenever it has something to say; nobody waits for them at the start.
COMMON = ('/run/ready', '/run/events', '/diagnostics')
# Where a node of the run seldom writes or several do: what is written there is counted (`pulse`).
COUNTED = ('/run/pause', '/run/end', '/run/events')
# Where programs of any make say something, too, and no node of a run obeys.
FOR_ALL = ('/diagnostics', '/tf', '/tf_static')
SECOND_WRITER, ALSO_WRITES = 'SECOND_WRITER', 'ALSO_WRITES'     # events: on other topics, and there
NAMELESS = 'a node without a name'      # how the words on one end of which no name is known
# Events of who follows a run: a process without a sign of life, or that ended; an end of the
# flight.
SILENT, ENDED_EARLY, GIVEN_UP = 'SILENT', 'ENDED_EARLY', 'GIVEN_UP'
STATE = 'rvd_interfaces/msg/RelativeState'
RECORDER, MONITOR, MARKERS = 'bag_recorder', 'mission_monitor', 'markers'
# The browser console where it is not an operator, who declares it in the diagram: it watches.
CONSOLE = External('console', 'rvd_groundstation', 'console', GROUND)
RECORDER_LEAD = 64              # [steps] in lock step the recorder is never further behind
GROUP_EXECUTABLE = 'block_group'        # of rvd_dynamics: several blocks in one process


@dataclass(frozen=True)
class Watcher:
    """A node that watches a run from outside the ring."""

    name: str
    reads: tuple[str, ...] = ()
    writes: tuple[str, ...] = ()
    package: str = 'rvd_dynamics'


class MayWrite(NamedTuple):
    """Who may write on a topic of a run."""

    names: frozenset[str]               # nodes, one writer each
    anyone: bool = False                # one writer, of a node of any name: a stick's driver
    shared: bool = False                # by one node of each process, whichever speaks for it
    counts: bool = True                 # what is written there acts on the run


class Process(NamedTuple):
    """One process of the bring-up."""

    name: str
    package: str
    executable: str
    nodes: tuple[str, ...]
    grouped: bool


class Roster:
    """
    Nodes of one run.

    Parameters
    ----------
    scenario : Scenario
    names : iterable of str, optional
        Nodes that take part; by default, and where it is empty, those without which the run
        cannot step.
    """

    def __init__(self, scenario: Scenario, names: Iterable[str] = ()) -> None:
        self.scenario, self.diagram = scenario, scenario.diagram
        self.blocks = {b.name: b for b in self.diagram.blocks if b.in_graph}
        self.externals = {e.name: e for e in (CONSOLE, *self.diagram.externals)}
        self.names = tuple(n for n in names if n) or tuple(self.blocks)

    # -- topics -----------------------------------------------------------------------------

    @cached_property
    def topics(self) -> dict[str, str]:
        """Message types of all topics of the run."""
        found = {s.name: s.message for b in self.blocks.values() for s in b.writes.values()}
        found |= {leg.status.name: leg.status.message for leg in self.blocks.values()
                  if isinstance(leg, Leg) and leg.status is not None}
        for external in self.externals.values():
            found |= {r.signal.name: r.signal.message for b in self.blocks.values()
                      for r in b.reads.values() if r.signal.name in external.writes}
        return {**found, **RUN_TOPICS}

    @cached_property
    def watchers(self) -> dict[str, Watcher]:
        """The watchers that a run may have."""
        truth = self.diagram.truth.name
        viewed = tuple(name for name in ('/ground/estimate', '/ground/prediction', truth)
                       if self.topics.get(name) == STATE)
        if self.scenario.mission.scene:
            field = loaded(self.scenario.mission.scene)(self.scenario)
            viewed += tuple(s.rows.signal for s in field.moving) if field else ()
        aborts = (self.diagram.abort_shown.signal,) if self.diagram.abort_shown else ()
        return {watcher.name: watcher for watcher in (
            Watcher(MONITOR, (truth, *aborts, '/run/end'), ('/run/verdict',)),
            Watcher(RECORDER, tuple(self.topics), ('/run/recorded_step',)),
            Watcher(MARKERS, (*viewed, '/run/end')))}

    def emits(self, name: str) -> tuple[str, ...]:
        """Return the topics that a node writes once at each of its firings."""
        block = self.blocks.get(name)
        if block is None:
            return ()
        found = [signal.name for signal in block.writes.values() if not signal.still]
        if isinstance(block, Leg) and block.status is not None:
            found.append(block.status.name)
        return (*found, '/clock') if name == self.diagram.plant else tuple(found)

    @cached_property
    def owed(self) -> dict[str, int]:
        """The topics that get one message at each firing of their node: its period [steps]."""
        return {topic: self.blocks[name].period for name in self.names if name in self.blocks
                for topic in self.emits(name)}

    def writes(self, name: str) -> frozenset[str]:
        """Return all topics that a node writes, the common ones aside."""
        found = set(self.emits(name))
        if name == self.diagram.plant:
            found |= {'/run/end', '/run/scenario'}
        if name in self.blocks:
            found |= {signal.name for signal in self.blocks[name].writes.values() if signal.still}
            if self.blocks[name].control:
                found.add('/run/pause')
        if name in self.watchers:
            found |= set(self.watchers[name].writes)
        if name in self.externals:
            found |= set(self.externals[name].writes)
        return frozenset(found)

    @cached_property
    def counted(self) -> frozenset[str]:
        """
        The topics of COUNTED on which every writer of this run notes what it writes on its page.

        A console that outlives runs has been there before the page of one.
        """
        ours = [n for n in self.names if n in self.externals and not self.externals[n].foreign]
        return frozenset(COUNTED).difference(COMMON if ours else (), *map(self.writes, ours))

    def reads(self, name: str) -> frozenset[str]:
        """Return all topics that a node reads."""
        found: set[str] = set()
        if name in self.blocks:
            found = {read.signal.name for read in self.blocks[name].reads.values()} | {'/run/end'}
        if self.follows_clock(name):
            found.add('/clock')
        if name == self.diagram.plant:
            found |= {'/run/ready', '/run/recorded_step', '/run/pause'}
        if name in self.watchers:
            found = set(self.watchers[name].reads)
        if name in self.externals:
            external = self.externals[name]
            found = set(external.reads)
            if not external.foreign:
                found.add('/run/end')
                found |= {'/run/pause', '/run/events', '/run/verdict'} if external.viewer else set()
        return frozenset(found) - self.writes(name)

    @cached_property
    def _may_write(self) -> dict[str, MayWrite]:
        """Who may write on each topic, whether it takes part in this run or not."""
        everybody = {**self.blocks, **self.watchers, **self.externals, **dict.fromkeys(self.names)}
        foreign = {topic for external in self.externals.values() if external.foreign
                   for topic in external.writes}
        table = {topic: MayWrite(frozenset(n for n in everybody if topic in self.writes(n)),
                                 anyone=topic in foreign) for topic in self.topics}
        table |= {topic: MayWrite(frozenset(everybody), shared=True) for topic in COMMON}
        return {topic: rule._replace(counts=topic not in FOR_ALL) for topic, rule in table.items()}

    def may_write(self, topic: str) -> MayWrite:
        """Return who may write on a topic of the run."""
        return self._may_write[topic]

    def place_of(self, topic: str) -> int:
        """Return the place of a topic among those of the run, the same in each process."""
        return self._places.index(topic)

    def at_places(self, places: Iterable[int]) -> list[str]:
        """Return the topics at places."""
        return [self._places[i] for i in places if i < len(self._places)]

    @cached_property
    def _places(self) -> list[str]:
        return sorted(self.topics)

    def home_of(self, name: str) -> str:
        """Return the process of a node; one that nobody groups is alone."""
        return self.process_of.get(name, name)

    def follows_clock(self, name: str) -> bool:
        """
        Say whether a block must wait for the world's /clock.

        Where every input is delayed, nothing of step k itself holds firing k up: the block would
        run ahead of the world, and past the end of the run.
        """
        return name in self.blocks and name != self.diagram.plant and all(
            read.delay > 0 or read.held for read in self.blocks[name].reads.values())

    @cached_property
    def follow_world(self) -> frozenset[str]:
        """
        The blocks that in lock step fire for no step which the plant has not made.

        Those that follow its clock, and those that need something of the same step from one of
        these; not who reads a pilot's page or program alone, which may be ahead.
        """
        found = {self.diagram.plant}
        for block in (block for block in self.diagram.order if block.name in self.blocks):
            writers = (self.diagram.writer_of.get(read.signal.name) for read in
                       block.reads.values() if read.delay == 0 and not read.held)
            if self.follows_clock(block.name) or any(
                    writer is not None and writer.name in found and not block.period % writer.period
                    for writer in writers):
                found.add(block.name)
        return frozenset(found)

    # -- processes --------------------------------------------------------------------------

    @cached_property
    def processes(self) -> tuple[Process, ...]:
        """The processes of the run, with the nodes that each holds."""
        grouping = self.scenario.run.processes
        watchers = tuple(n for n in self.names if n in self.watchers)
        groups = {name: tuple(b.name for b in blocks if b.name in self.names)
                  for name, blocks in self.diagram.groups(grouping).items()}
        if grouping == 'blocks':
            found = [Process(n, self.blocks[n].package, self.blocks[n].executable, (n,), False)
                     for n in groups if groups[n]]
            found += [Process(n, self.watchers[n].package, n, (n,), False) for n in watchers]
        else:
            home = WATCH if grouping == 'segments' else grouping
            groups[home] = groups.get(home, ()) + watchers
            found = [Process(name, 'rvd_dynamics', GROUP_EXECUTABLE, nodes, True)
                     for name, nodes in groups.items() if nodes]
        found += [Process(n, self.externals[n].package, self.externals[n].executable, (n,), False)
                  for n in self.names if n in self.externals and self.externals[n].started]
        return tuple(found)

    @cached_property
    def process_of(self) -> dict[str, str]:
        """Name of the process of each node."""
        return {node: process.name for process in self.processes for node in process.nodes}

    def expected(self, topic: str) -> tuple[int, int]:
        """
        Return the least numbers of (publishers, subscriptions) that a topic has in DDS.

        Within a process signals pass by hand, and a process subscribes once to a topic.
        """
        writers = [n for n in self.names if topic in self.writes(n)]
        homes = {self.process_of.get(n, n) for n in writers}       # a foreign one may be anywhere
        readers = {self.process_of[n] for n in self.names if topic in self.reads(n)}
        return len(writers), len(readers - homes)

    # -- who owes ---------------------------------------------------------------------------

    def who_owes(self, last: dict[str, int]) -> list[str]:
        """
        Name the nodes whose inputs are complete and whose output is missing.

        `last` is the last step seen on each topic (-1: nothing yet). In lock step the world also
        waits for a recorder that is RECORDER_LEAD steps behind: then that one owes. Where no block
        does, whoever is waited for and is none: a pilot who answers every step.
        """
        def seen(topic: str) -> int:
            return last.get(topic, -1)

        truth = self.diagram.truth.name
        if RECORDER in self.names and seen(truth) - seen('/run/recorded_step') >= RECORDER_LEAD:
            return [RECORDER]
        owing = []
        for name in self.names:
            block = self.blocks.get(name)
            if block is None:
                continue
            stepped = [topic for topic in self.emits(name) if topic != '/clock']
            if not stepped:                     # it has nothing to give
                continue
            due = min(seen(topic) for topic in stepped) + block.period
            due -= due % block.period
            if self.follows_clock(name) and seen(truth) < due:
                continue
            if all(seen(read.signal.name) >= self.needed(read, due)
                   for read in block.reads.values() if not read.held):
                owing.append(name)
        return owing or [name for name, external in self.externals.items()
                         if name in self.names and any(
                             read.signal.name in external.writes and not read.held
                             for block in self.blocks.values() for read in block.reads.values())]

    def needed(self, read: Read, due: int) -> int:
        """Return the step of the writer whose output a block needs for its firing `due`."""
        writer = self.diagram.writer_of.get(read.signal.name)
        at = due - read.delay
        return at - at % writer.period if writer else at


def listed(scenario: Scenario, headless: bool, console: bool = False) -> Roster:
    """Return the roster of a whole run, as the bring-up starts it; `console`: with one to watch."""
    blocks = [block.name for block in scenario.diagram.blocks if block.in_graph]
    externals = [external.name for external in scenario.diagram.externals]
    if console and CONSOLE.name not in externals:
        externals.append(CONSOLE.name)
    watchers = [MONITOR, RECORDER]
    if not headless and scenario.mission.markers:
        watchers.append(MARKERS)
    return Roster(scenario, (*blocks, *externals, *watchers))


def lines(roster: Roster, run_dir: str, run_id: str) -> list[str]:
    """
    Return one line per process: name, package, executable and ROS arguments, for a shell.

    `run_id`: enclave of the run, from `identity.new_run`. The recorder's line is the last one, by
    which the bring-up knows it.
    """
    names = f'[{",".join(roster.names)}]'
    made = []
    for process in sorted(roster.processes, key=lambda p: RECORDER in p.nodes):
        arguments = ['--enclave', run_id, '-p', f'nodes:={names}']
        if process.grouped:
            arguments += ['-p', f'group:={process.name}']
        else:
            arguments += ['-r', f'__node:={process.name}']
        if RECORDER in process.nodes:
            arguments += ['-p', f'{RECORDER}:bag_dir:={scalar(f"{run_dir}/bag")}']
        made.append(' '.join((process.name, process.package, process.executable,
                              *map(shlex.quote, arguments))))
    return made


def scalar(text: str) -> str:
    """
    Return any text as a YAML scalar on one line, which ROS and we read as this very text.

    ROS parses what follows `:=` as YAML: bare, ` #` would begin a comment, `: ` a mapping.
    """
    return yaml.safe_dump(text, default_style='"', allow_unicode=True,
                          width=float('inf')).rstrip('\n')


def main(arguments: list[str]) -> int:
    """Print the processes of a scenario; return the exit code."""
    try:
        scenario, run_dir, *options = arguments
        print('\n'.join(lines(
            listed(load(Path(scenario)), '--headless' in options), run_dir, new_run())))
    except BadInput as error:
        print(f'bringup: {error}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
