"""The true world as a node: the clock, the pacing and the end of a run."""

import time
from typing import Any

from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool, String, UInt64

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.identity import in_words, is_ready_words, who_is_ready
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.block_node import BlockNode
from rvd_dynamics.diagram.ros.boundary import read, Refused
from rvd_dynamics.diagram.ros.host import Host, SLICE_S
from rvd_dynamics.diagram.ros.lateness import Lateness
from rvd_dynamics.diagram.ros.node import LONGEST
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.roster import RECORDER, RECORDER_LEAD

TICKS_PER_STEP = 8              # how often the wall clock is looked at in real time
PATIENCE = 0.5                  # share of a step by which one may be late for want of its thrust
MOST_STRANGERS = 100            # [runs] that are told of
STILL_S = 2.0                   # [s] wall time between two looks: this process did not run


class PlantNode(BlockNode):
    """
    The true world; it owns `/clock`, the pacing and the end of the run.

    lockstep    step k+1 is made when the thrust of step k is here: as fast as the machine can.
    realtime    step k is made at k * step_s / pace_factor of wall time; if the thrust of step k-1
                is not here by then, when it comes, or half a step later without it.
    """

    hurries = False                             # the clock alone says when a step is due

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block)
        self._paused = False
        self._started_ns: int | None = None     # wall time
        self._recorded: int | None = None
        self._strangers: set[str] = set()       # runs that came into this one
        self._lateness = Lateness()             # in real time: of each step, by the wall clock
        self._waiting_for = set(self.roster.names) - {
            e.name for e in self.roster.externals.values() if e.foreign}
        self._time, self._time_layout = self.writer('/clock', Clock), Layout(Clock)
        self._end = self.writer('/run/end', UInt64)
        self._story = self.writer('/run/scenario', String)
        truth = self.roster.diagram.truth
        self._truth = next(n for n, s in block.writes.items() if s.name == truth.name)

    def connect(self) -> None:
        """Subscribe, also to what the run says about itself."""
        super().connect()
        self.watch_raw('/run/ready', String, self._heard_ready,
                       qos.taken('/run/ready', self.held))
        self.listen('/run/pause', Bool, lambda _, message: self._on_pause(message.data))
        if RECORDER in self.roster.names:
            self._recorded = -1
            self.listen('/run/recorded_step', UInt64, self._on_recorded)

    def on_step(self, k: int, values: dict[str, Any]) -> None:
        """Advance the truth; say when it is the last of it."""
        super().on_step(k, values)
        self.host.publish(self._time, '/clock', k, self._time_layout.pack(
            *divmod(k * self.run.step_ns, NS_PER_S)))

    def before_publishing(self, k: int, outputs: dict[str, Any]) -> None:
        """Say that step k is the last before anybody can have it."""
        try:
            final = outputs[self._truth].final
        except (LookupError, TypeError, AttributeError):
            self._check(k, outputs)
            raise
        self.host.flown(k, final)
        if final:
            if self.realtime:
                self.event('PACE', self._pace_kept())
            self.host.publish(self._end, '/run/end', -1, UInt64(data=k))
            self.host.end(k)

    def latest(self) -> int:
        """Return the step that was made last: nobody answers one that has not been."""
        return self.step

    # -- start and pacing -------------------------------------------------------------------

    def may_fire(self) -> bool:
        """In lock step, say whether the next step is due; in real time the clock alone does."""
        return (self.started and not self.realtime and not self._paused and not self._too_far()
                and super().may_fire())

    def _too_far(self) -> bool:
        behind = self._recorded is not None and self._next - self._recorded > RECORDER_LEAD
        if behind:
            self.trouble['recorder'] = f'waiting for {RECORDER}, at step {self._recorded}'
        elif self.trouble:
            self.trouble.pop('recorder', None)
        return behind

    @property
    def started(self) -> bool:
        """Whether every node of the run has been ready, and steps are made."""
        return self._started_ns is not None

    def on_ready(self) -> None:
        """Say what is flown, once it is sure that no other run hears it."""
        self.host.publish(self._story, '/run/scenario', -1,
                          String(data=self.host.arguments.text()))

    def _heard_ready(self, data: bytes, info: dict) -> None:
        try:
            words = read(data, String).data
            if not is_ready_words(words):
                raise Refused(f'{words[:LONGEST]!r} is no name of a node that is ready')
        except Refused as why:
            self.refuse('/run/ready', str(why))
            return
        name, run = who_is_ready(words, self.host.run_id)
        if run != self.host.run_id:
            self._met(run, info['source_timestamp'])
            return
        self._waiting_for.discard(name)
        if self._waiting_for or self.started:
            return
        self._started_ns = time.time_ns()
        if self.realtime:
            self._step_s = self.run.step_s / self.run.pace_factor
            self._origin = self._looked = time.monotonic()
            self.create_timer(self._step_s / TICKS_PER_STEP, self.guarded(self._tick))

    def _met(self, run: str, ready_ns: int) -> None:
        """
        End if another run was ready before this one had started; else go on, and say so.

        Of two runs that each had begun before they met, at least one ends, however their clocks
        differ: a run that goes on has started before all that the other was ready for, and the
        other was ready before it started.
        """
        domain = self.context.get_domain_id()
        if not self.started or ready_ns <= self._started_ns:
            raise BadInput(f'another run has come into ROS_DOMAIN_ID={domain}: {in_words(run)}; '
                           'give each run its own')
        if run not in self._strangers and len(self._strangers) < MOST_STRANGERS:
            self._strangers.add(run)
            self.event('STRANGER', f'another run has come into ROS_DOMAIN_ID={domain} and was '
                       f'refused: {in_words(run)}; give each run its own')

    def _tick(self) -> None:
        until = self._now() + SLICE_S           # a plant that is behind hears the others, too
        while (not self._paused and not self.finished and not self._is_over()
               and (late := self._late()) >= 0.0 and time.monotonic() < until
               and (late >= PATIENCE*self._step_s or all(g.there() for g in self._given))):
            self._lateness.add(late)
            self.fire()
            self.host.work()                    # what of it is here fires before the next step

    def _now(self) -> float:
        """
        Return the wall time; the clock of the run is moved on by what this process stood still.

        That is looked at wherever the time is: a process can be stopped within a step as well as
        while it waits for one.
        """
        now, before = time.monotonic(), self._looked
        self._looked = now
        self._wake(now - before)
        return now

    def _late(self) -> float:
        """Return for how long the next step has been due [s]; negative before."""
        return self._now() - self._origin - self._next * self._step_s

    def _pace_kept(self) -> str:
        """Say how well real time was kept: commands that were missing, and when steps were made."""
        if not len(self._lateness):
            return f'{self.missing_count} commands missing; no step was due'
        middle, most, worst = (f'{1e3*self._lateness.percentile(p):.1f}' for p in (50, 99, 100))
        return (f'{self.missing_count} commands missing in {len(self._lateness)} steps; steps came '
                f'{middle} ms after they were due at the median, {most} ms at the 99th '
                f'percentile, {worst} ms at most')

    def _wake(self, still_s: float) -> None:
        """Take up the clock where it was left, if this process was stopped meanwhile."""
        if still_s > STILL_S:
            self._origin += still_s
            if not self._paused:
                self.event('STILL', f'the computer or this process stood still for {still_s:.0f} s '
                           'of wall time; simulation time goes on from where it was')

    def _on_recorded(self, step: int, message: UInt64) -> None:
        if step < 0 and not self._recorded < message.data <= self.step:     # from another process
            self.refuse('/run/recorded_step', f'step {message.data} cannot be recorded after '
                        f'{self._recorded} and in step {self.step}')
            return
        self._recorded = message.data

    def _on_pause(self, paused: bool) -> None:
        if paused == self._paused:
            return
        self._paused = paused
        self.event('PAUSE' if paused else 'RESUME', 'simulation time '
                   + ('stands still' if paused else 'goes on'))
        if self.started and self.realtime and not paused:
            self._origin = time.monotonic() - self._next * self._step_s
