"""
A process of a run: its nodes, what passes between them, the end.

Any number of nodes share a process (`--processes`): each keeps its rclpy node and publishes
everything, but what one writes and another in the same process reads passes by hand. A process
says on `/run/ready` that all its endpoints are matched, once for each node, and stops when the run
that `/run/end` names is over.
"""

from collections import defaultdict
from collections.abc import Callable
import importlib
import time
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from rclpy.executors import SingleThreadedExecutor
from rclpy.publisher import Publisher
from rclpy.serialization import serialize_message
from std_msgs.msg import String

from rvd_dynamics import compiling, lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram import identity
from rvd_dynamics.diagram.ros.arguments import Arguments
from rvd_dynamics.diagram.ros.barrier import Barrier
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.ending import Ending
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.ros.traces import Traces
from rvd_dynamics.diagram.ros.writers import Stranger, UNKNOWN_NODE
from rvd_dynamics.diagram.roster import COUNTED, MONITOR, RECORDER, Roster, SECOND_WRITER
from rvd_dynamics.pulse import BEAT_S, Pulse
from rvd_interfaces.msg import RunEvent

ASK_S = 0.1                     # [s] wall time between two looks whether to stop
BEAT_NS = round(BEAT_S * NS_PER_S)      # [ns] wall time
DIAGNOSTICS_PERIOD_NS = NS_PER_S        # [ns] wall time
GATHER_S = 0.02                 # [s] wall time for which messages are kept that only watchers read
HANDFUL = 64                    # [messages] of them that go out at once
MOMENT_S = 0.3                  # [s] wall time in which local readers get what was written last
RECORDER_S = 8.0                # [s] wall time that a closing process gives the recorder
SILENT_NS = 2 * NS_PER_S        # [ns] wall time between two turns that is told
SLICE_S = 0.05                  # [s] wall time of firing before the executor is looked at again
TRACES_NS = NS_PER_S // 20      # [ns] wall time between two looks for second writers


def message_type(name: str) -> type:
    """Return the class of a message type such as 'std_msgs/msg/String'."""
    package, folder, kind = name.split('/')
    try:
        return getattr(importlib.import_module(f'{package}.{folder}'), kind)
    except (ImportError, AttributeError):
        raise BadInput(f'message type {name} is not installed') from None


class Host:
    """One process; make it, make its nodes, then `spin`."""

    def __init__(self, arguments: Arguments) -> None:
        self.arguments = arguments
        self.scenario = arguments.scenario
        self.roster = Roster(self.scenario, self.scenario.run.nodes)
        self.nodes: dict[str, RunNode] = {}
        self.firing: list[Any] = []             # nodes of blocks, in the order of the diagram
        self.final_step: int | None = None
        self._error: tuple[RunNode, Exception] | None = None
        self._takers: dict[str, list[Callable]] = defaultdict(list)     # (step, what passes)
        self._keepers: dict[str, list[Callable]] = defaultdict(list)    # (step, bytes)
        self._unhurried: frozenset[str] = frozenset()
        self._later: list[tuple[Publisher, Any]] = []   # of those topics
        self._pulse, self._place = Pulse.inherited(), 0
        self._heard = 0                         # [bytes] of what is said on the page
        self._is_told = False                   # the plant notes on our page how far it is
        self._beat_ns = self._looked_ns = self._diagnosed_ns = time.monotonic_ns()
        self._traced_ns = self._beat_ns
        self._ended = False
        self._busy = False
        self.begun = False                      # the barrier is behind us
        self._barrier = Barrier(self)
        self.ending = Ending(self)
        self.run_id = arguments.run_id
        self._traced: list[str] = []            # topics with such a trace, where there is no page
        self.traces = Traces(self.roster, self.run_id, lambda: self._lead,
                             written=self._written)

    # -- nodes ------------------------------------------------------------------------------

    def add(self, node: RunNode) -> None:
        """Take in a node; the first one speaks for the process."""
        lead = not self.nodes
        self.nodes[node.get_name()] = node
        if not lead:
            return
        self._lead = node
        homes = [process.name for process in self.roster.processes]
        home = self.roster.process_of.get(node.get_name())
        if self._pulse.inherits and len(self._pulse) == len(homes) and home in homes:
            self._place, self._is_told = homes.index(home), True
        else:                                   # started by hand
            self._pulse = Pulse()
        compiling.follow(self._compiles)
        self._ready = node.writer('/run/ready', String)
        self._events = node.writer('/run/events', RunEvent)
        self._diagnostics = node.writer('/diagnostics', DiagnosticArray)
        self._barrier.wait()

    def _compiles(self, begins: bool) -> None:
        self._pulse.compile(self._place, begins, time.monotonic_ns())

    @property
    def lead(self) -> RunNode:
        """The node that speaks for the process."""
        return self._lead

    def is_local(self, topic: str) -> bool:
        """Say whether a node of this process writes a topic; ask when all nodes are made."""
        return any(topic in self.roster.writes(name) for name in self.nodes)

    def take(self, topic: str, taker: Callable[[int, Any], None]) -> None:
        """Hand on what nodes of this process write on a topic: the step, and what passes."""
        self._takers[topic].append(taker)

    def keep(self, topic: str, keeper: Callable[[int, bytes], None]) -> None:
        """Hand on, serialised, what nodes of this process write on a topic."""
        self._keepers[topic].append(keeper)

    def publish(self, publisher: Publisher, topic: str, step: int, message: Any,
                by_hand: Any = None) -> None:
        """
        Publish a message, serialised or not, and hand it to whoever reads it in this process.

        `by_hand` is what its readers in this process get; the message itself unless given. In lock
        step, a process of several blocks sends what no firing in another process waits for a
        little later, many at a time: the ring would stand still meanwhile, and each reader be
        woken for each.
        """
        if topic in COUNTED:
            self._pulse.write(self._place, COUNTED.index(topic))
        keepers = self._keepers.get(topic)
        if keepers and not isinstance(message, bytes):
            message = serialize_message(message)
        if topic in self._unhurried:
            self._later.append((publisher, message))
        else:
            publisher.publish(message)
        if keepers:
            for keeper in keepers:
                keeper(step, message)
        for taker in self._takers.get(topic, ()):
            taker(step, message if by_hand is None else by_hand)

    def _gather(self) -> None:
        """From now on, keep for a moment what only watchers read."""
        hurried = {topic for name in self.roster.names
                   if name not in self.nodes and name not in self.roster.watchers
                   for topic in self.roster.reads(name)}
        self._unhurried = frozenset(topic for name in self.nodes
                                    for topic in self.roster.emits(name)) - hurried
        if self._unhurried:
            self._lead.create_timer(GATHER_S, self._lead.guarded(self._publish_the_rest))

    def _publish_the_rest(self) -> None:
        later, self._later = self._later, []
        for publisher, message in later:
            publisher.publish(message)

    def begin(self) -> None:
        """Be told that everything this process talks to is there."""
        self.begun = True
        self.traces.begin()
        for name in self.nodes:
            self.publish(self._ready, '/run/ready', -1,
                         String(data=identity.ready_words(name, self.run_id)))
        for node in self.nodes.values():
            node.guarded(node.on_ready)()
        if self.scenario.run.pace == 'lockstep' and len(self.firing) > 1:
            self._gather()                  # its timer would cost a single block more than it saves
        if not any(list(node.timers) for node in self.nodes.values()):
            self._lead.create_timer(BEAT_S, lambda: None)   # a turn of the loop, and a beat

    # -- while it runs ----------------------------------------------------------------------

    def event(self, node: RunNode, code: str, text: str) -> None:
        """Say on /run/events that something happened to a node, once."""
        step = max(node.step, 0)
        self.publish(self._events, '/run/events', step, RunEvent(
            header=header_at(step * node.run.step_ns, node.run.frame_id), step=step,
            node=node.get_name(), code=code, text=text))

    def flown(self, step: int, final: bool = False) -> None:
        """Note how far the run has come: told by the plant, for who may hear nothing any more."""
        self._pulse.flown = step
        if final:
            self._pulse.final = step

    def note_lost(self, messages: int) -> None:
        """Note how many messages there was no disk for; who started the run reads it."""
        self._pulse.lost = messages

    def news(self) -> list[tuple[str, int, str]]:
        """Return what who started the run has said since the last call: code, step and words."""
        said, self._heard = self._pulse.heard(self._heard)
        return said

    @property
    def made(self) -> int | None:
        """The newest step that the plant has noted; None in a node that was started by hand."""
        return self._pulse.flown if self._is_told else None

    def bound_of(self, *blocks: str) -> Callable[[], int | None]:
        """Return a function that returns how far these blocks can be; None: nobody knows."""
        if self.scenario.run.pace == 'realtime' or self.roster.follow_world.issuperset(blocks):
            return lambda: self.made
        return lambda: None

    @property
    def noted_end(self) -> int | None:
        """The last step as the plant has noted it, -1 while the run goes on; None as for `made`."""
        return self._pulse.final if self._is_told else None

    def diagnose(self) -> None:
        """
        Give a sign of life: on the page of the run, and once a second on /diagnostics.

        Called from the work itself, at each firing and at each turn of the loop, and never from
        another thread: a process that hangs falls silent.
        """
        now = time.monotonic_ns()
        self._pulse.beat(self._place, now)
        still_ns, self._beat_ns = now - self._beat_ns, now
        if still_ns > SILENT_NS and self.begun:
            self._lead.trouble['still'] = (f'stood still for {still_ns / NS_PER_S:.1f} s of wall '
                                           'time, or computed meanwhile')
        if (now - self._traced_ns >= TRACES_NS or self.traces.urgent
                or not self.traces.begun):
            self._traced_ns = now
            self._look_for_traces()
        if now - self._looked_ns < BEAT_NS:
            return
        self._looked_ns = now
        lifeline.look(now / NS_PER_S)
        if now - self._diagnosed_ns >= DIAGNOSTICS_PERIOD_NS and self.begun:
            self._diagnosed_ns = now
            self._publish_diagnostics()

    def _look_for_traces(self, last: bool = False) -> None:
        """Let the monitor know where there was a second writer; by hand, say so here."""
        for topic in self.traces.look(last):
            if self._pulse.mark(self.roster.place_of(topic)):
                continue
            if MONITOR in self.nodes:
                self._traced.append(topic)
            else:
                self.event(self._lead, SECOND_WRITER, Stranger(topic, '', False, True).words)

    def _written(self, topic: str) -> int | None:
        """Return how many messages the run has written on a topic; None: that is not counted."""
        return (self._pulse.written(COUNTED.index(topic))
                if self._is_told and topic in self.roster.counted else None)

    @property
    def traced(self) -> list[str]:
        """The topics on which any process of the run found a trace of a second writer."""
        return [*self.roster.at_places(self._pulse.marked), *self._traced]

    def _publish_diagnostics(self) -> None:
        lead = self._lead
        message = DiagnosticArray(status=[DiagnosticStatus(
            level=DiagnosticStatus.WARN if node.trouble else DiagnosticStatus.OK,
            name=name, hardware_id='rvd', message='; '.join(node.trouble.values()) or 'running',
            values=[KeyValue(key='step', value=str(node.step))])
            for name, node in self.nodes.items()])
        message.header = header_at(max(lead.step, 0) * lead.run.step_ns, '')
        self.publish(self._diagnostics, '/diagnostics', -1, message)

    def work(self) -> None:
        """Fire every block whose inputs are complete, for a while; nothing before the start."""
        until = time.monotonic() + SLICE_S
        moved = self.begun
        while moved and not self._ended:
            moved = False
            for node in self.firing:
                if node.may_fire():
                    node.fire()
                    moved = True
            if len(self._later) >= HANDFUL:
                self._publish_the_rest()
            if moved and len(self.firing) > 1 and time.monotonic() > until:
                break
        self._busy = moved and not self._ended
        for node in self.nodes.values():
            node.settle()

    # -- end --------------------------------------------------------------------------------

    def end(self, final_step: int) -> None:
        """Be told the last step of the run."""
        if self.final_step is not None:
            return
        self.final_step = final_step
        for node in self.nodes.values():
            node.guarded(node.on_end)(final_step)

    def fail(self, node: RunNode, error: Exception) -> None:
        """End the process with an error of `node`, or of the one it carries; the first counts."""
        if self._error is None and not self._ended:
            self._error = (getattr(error, 'rvd_node', node), error)
        self._ended = True

    def look(self) -> None:
        """See whether every node has finished."""
        self._ended = self._ended or (self.ending.sure and all(
            node.finished for node in self.nodes.values()))

    @property
    def ended(self) -> bool:
        """Whether nothing is left to do, or an error has ended it."""
        return self._ended

    def spin(self, stopped: Callable[[], bool] | None = None) -> None:
        """
        Serve the nodes to the end of the run, or until `stopped()`, which is asked now and then.

        Raises
        ------
        Exception
            What a node raised; it carries the node's name in `rvd_node`.
        """
        executor = SingleThreadedExecutor()
        for node in self.nodes.values():
            executor.add_node(node)
        try:
            while not self._ended and not (stopped and stopped()):
                executor.spin_once(timeout_sec=0.0 if self._busy else
                                   ASK_S if stopped else None)
                self.diagnose()
                try:
                    self.work()
                except Exception as error:      # noqa: B902 - of the block that fired last
                    self.fail(self._lead, error)
        finally:
            self._pulse.leave(self._place, early=not self._ended)
            executor.shutdown(timeout_sec=0.0)
        self.raise_error()

    def raise_error(self) -> None:
        """Raise what ended the process, if an error did."""
        if self._error is not None:
            node, error = self._error
            error.rvd_node = node
            raise error

    def close(self) -> None:
        """
        Let the readers have the last messages before the writers go.

        The recorder leaves when it has everything, so who is recorded waits for that; others
        stay a moment. (Waiting for acknowledgements takes a heartbeat of 3 s, always.)
        """
        if self.nodes and self._lead.context.ok():      # else told to stop: the graph is gone
            try:
                self._look_for_traces(last=True)
                self._wait_for_readers()
            except RuntimeError:                # RCLError: told to stop meanwhile
                if self._lead.context.ok():
                    raise
        for node in self.nodes.values():
            node.close()
        with lifeline.leaving():
            for node in self.nodes.values():
                node.destroy_node()

    def _wait_for_readers(self) -> None:
        self._publish_the_rest()
        if RECORDER not in self.roster.names:
            time.sleep(MOMENT_S)
        elif RECORDER not in self.nodes:
            deadline = time.monotonic() + RECORDER_S
            while time.monotonic() < deadline and self._recorder_is_here():
                time.sleep(0.02)

    def _recorder_is_here(self) -> bool:
        """
        Say whether the recorder is there, and may still take what comes.

        The graph has no names for nodes that DDS has taken for dead and found again. On the page of
        the run the recorder notes when it is done; by hand, one without a name counts.
        """
        names = {RECORDER}
        if self._is_told:
            homes = [process.name for process in self.roster.processes]
            if self._pulse.beaten_s(homes.index(self.roster.process_of[RECORDER])) is not None:
                return True
        else:
            names.add(UNKNOWN_NODE)
        readers = self._lead.get_subscriptions_info_by_topic('/run/end')
        return any(reader.node_name in names for reader in readers)
