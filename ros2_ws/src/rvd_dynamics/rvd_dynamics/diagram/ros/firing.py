"""
Nodes of blocks: fire once per period, in order, when the inputs of that step are complete.

The diagram is a synchronous dataflow, so the order in which DDS delivers does not matter and a
run in lock step is the same to the last bit every time, however its blocks share processes. In
real time a block that has not fired for k when an input of a later firing arrives fires k with
what it holds; the rest is MISSING, and its codec says what that is worth.
"""

from math import inf
import struct
import time
from typing import Any

import numpy as np
from rclpy.callback_groups import CallbackGroup
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool, String, UInt64

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.block import Block, Leg, Read
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.diagram import DiagramError
from rvd_dynamics.diagram.in_process import everything
from rvd_dynamics.diagram.ros.codecs import FrameOfLink
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.roster import RECORDER, RECORDER_LEAD
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.play_out import Frame
from rvd_interfaces.msg import LinkFrame, LinkStatus
from rvd_interfaces.srv import RunControl

HELD_FOR_S = 0.5                # [s] wall time after which a held stick is nobody's
TICKS_PER_STEP = 8              # how often the wall clock is looked at in real time


class Gate(CallbackGroup):
    """Subscriptions that do not wake the node while the gate is shut; their messages wait."""

    def __init__(self) -> None:
        super().__init__()
        self.open = True

    def can_execute(self, entity: Any) -> bool:
        """Say whether the executor may look at `entity`."""
        return self.open

    def beginning_execution(self, entity: Any) -> bool:
        """Allow whatever the gate has let through."""
        return True

    def ending_execution(self, entity: Any) -> None:
        """Nothing is held between callbacks."""


class Input:
    """One input of a block: what has come, by the step of its writer."""

    def __init__(self, read: Read, period: int, codec: Any) -> None:
        self.delay, self.period, self.codec = read.delay, period, codec
        self.held: dict[int, Any] = {}          # message, or what passed by hand
        self.by_hand = False
        self.start = read.signal.initial(())

    def wanted(self, k: int) -> int:
        """Return the step of the writer whose output firing k needs; -1: before the start."""
        at = k - self.delay
        return at - at % self.period if at >= 0 else -1

    def first_use(self, step: int, period: int) -> int:
        """Return the first firing of a block of this period that needs step `step` or later."""
        return -(-(step + self.delay) // period) * period

    def there(self, k: int) -> bool:
        """Say whether what firing k needs is here."""
        wanted = self.wanted(k)
        return wanted < 0 or wanted in self.held

    def value(self, k: int) -> Any:
        """Return what firing k gets of this input."""
        wanted = self.wanted(k)
        if wanted < 0:
            return self.start
        item = self.held.get(wanted)
        if item is None:
            return self.codec.missing(wanted)
        return item if self.by_hand else self.codec.decode(wanted, item)

    def forget(self, k: int) -> None:
        """Drop what no firing from k on needs."""
        least = self.wanted(k)
        for step in [step for step in self.held if step < least]:
            del self.held[step]


class HeldInput:
    """The newest message of a writer that sends when it likes, by the wall clock."""

    def __init__(self, read: Read, codec: Any) -> None:
        self.codec = codec
        self._newest: tuple[float, Any] | None = None

    def keep(self, message: Any) -> None:
        """Keep a message; it came now."""
        self._newest = (time.monotonic(), message)

    def value(self, k: int) -> Any:
        """Return what the newest message says; what is missing when it is too old."""
        if self._newest is None or time.monotonic() - self._newest[0] > HELD_FOR_S:
            return self.codec.missing(k)
        return self.codec.decode(k, self._newest[1])


class FiringNode(RunNode):
    """What nodes of blocks and of legs have in common: inputs, and when to fire."""

    raw = False                                 # takes messages as they are, not values

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block.name)
        self.block = block
        self.realtime = self.run.pace == 'realtime'
        self.missing_count = self.late_count = 0
        self._next = 0
        self._gate = Gate()
        self._inputs: dict[str, Input] = {}
        self._held: dict[str, HeldInput] = {}
        self._last: Input | None = None         # the input that comes last
        self._gated = False
        self._limit = inf                       # last step that may be fired so far
        host.firing.append(self)

    # -- inputs -----------------------------------------------------------------------------

    def connect(self) -> None:
        """Subscribe to what other processes write, once all blocks of this one are made."""
        order = {block.name: i for i, block in enumerate(self.roster.diagram.order)}
        remote: list[tuple[tuple, str, Read]] = []
        for name, read in self.block.reads.items():
            writer = self.roster.diagram.writer_of.get(read.signal.name)
            codec = None if self.raw else self._codec(read.signal)
            if read.held:
                self._hold(name, read, codec)
                continue
            self._inputs[name] = Input(read, writer.period if writer else 1, codec)
            if self.host.is_local(read.signal.name):
                self._inputs[name].by_hand = codec is not None and not codec.frames
                self.host.take(read.signal.name, self._taker(name, codec))
                continue
            signals = list(writer.writes.values()) if writer else []
            rank = (-read.delay, order[writer.name] if writer else len(order),
                    [s.name for s in signals].index(read.signal.name) if writer else 0)
            remote.append((rank, name, read))
        remote.sort(key=lambda item: item[0])
        for _, name, read in remote:
            early = name != remote[-1][1] and not self.realtime
            self._subscribe(name, read, self._gate if early else None)
            self._gated |= early
        self._last = self._inputs[remote[-1][1]] if remote else None
        if self.roster.follows_clock(self.block.name):
            self._limit = -1
            self.listen('/clock', Clock, self._on_clock)

    def _codec(self, signal: Any) -> Any:
        own = {'signal': signal, 'run': self.run, 'event': self.event}

        def available(name: str) -> Any:
            return own[name] if name in own else self.scenario.part(name)
        return made(signal.codec, available, f'signal {signal.name}')

    def _taker(self, name: str, codec: Any) -> Any:
        if codec is None or codec.frames:
            return lambda step, frame: self._came(name, step, frame)
        return lambda step, value: self._came(name, step, codec.wired(value))

    def _subscribe(self, name: str, read: Read, group: CallbackGroup | None) -> None:
        kind, step_ns = message_type(read.signal.message), self.run.step_ns
        if 'step' in kind.get_fields_and_field_types():
            def came(message: Any) -> None:
                self._came(name, message.step, message)
        else:                                   # Joy carries its step in the stamp
            def came(message: Any) -> None:
                self._came(name, ns_of(message.header.stamp) // step_ns, message)
        self.watch(read.signal.name, kind, came, group=group)

    def _hold(self, name: str, read: Read, codec: Any) -> None:
        held = self._held[name] = HeldInput(read, codec)
        self.watch(read.signal.name, message_type(read.signal.message), held.keep)

    def listen(self, topic: str, kind: type, heard: Any) -> None:
        """Hear what the run says about itself, by hand where it is said in this process."""
        if self.host.is_local(topic):
            self.host.take(topic, heard)
        else:
            self.watch(topic, kind, lambda message: heard(-1, message))

    def _on_clock(self, step: int, message: Any) -> None:
        self._limit = step if step >= 0 else ns_of(message.clock) // self.run.step_ns

    def _came(self, name: str, step: int, item: Any) -> None:
        """Take in what the writer of an input wrote in `step`."""
        given, period = self._inputs[name], self.block.period
        if step < given.wanted(self._next):
            first = given.first_use(step, period)
            if first < self._next and given.wanted(first) == step:     # fired without it
                self.late_count += 1
                self.trouble['late'] = f'{self.late_count} messages came after their step'
            return
        given.held[step] = item
        if self.realtime:
            due = given.first_use(step, period)
            while self._next < due and self._next <= self._limit and not self._is_over():
                self.fire()
        if self._gated:
            self._look_at_gate()

    def _look_at_gate(self) -> None:
        self._gate.open = self._last.there(self._next)

    # -- firing -----------------------------------------------------------------------------

    def may_fire(self) -> bool:
        """Say whether every input of the next firing is here."""
        k = self._next
        return (not self.finished and k <= self._limit and bool(self._inputs)
                and all(given.there(k) for given in self._inputs.values())
                and not self._is_over())

    def _is_over(self) -> bool:
        final = self.host.final_step
        return final is not None and self._next > final

    def fire(self) -> None:
        """Do everything that belongs to the next firing."""
        k = self._next
        missing = sum(not given.there(k) for given in self._inputs.values())
        if missing:
            self.missing_count += missing
            self.trouble['missing'] = f'{self.missing_count} inputs missing so far'
        self._next = k + self.block.period
        self.step = k
        try:
            self.on_step(k)
        except Exception as error:              # noqa: B902 - named and handed on
            if not hasattr(error, 'rvd_node'):  # in real time a firing may lie within another
                error.rvd_node = self
            raise
        for given in self._inputs.values():
            given.forget(self._next)
        if self._gated:
            self._look_at_gate()
        self.host.diagnose()
        if self._is_over():
            self.finish()

    def on_step(self, k: int) -> None:
        """Compute and publish; implemented by each kind of node."""
        raise NotImplementedError

    def on_end(self, final_step: int) -> None:
        """Finish after the last firing, which may still be on its way."""
        if self._is_over():
            self.finish()


class BlockNode(FiringNode):
    """A block as a node."""

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block)
        self._outputs = {name: (signal, self._codec(signal),
                                self.writer(signal.name, message_type(signal.message)))
                         for name, signal in block.writes.items()}
        self._commands = [name for name, signal in block.writes.items() for part in signal.parts
                          if part.name == 'command' and part.dtype.startswith('f')]
        self._control = Control()
        if block.control:
            self._serve_control()

    def make(self) -> None:
        """Make what computes: after the endpoints, which find their partners meanwhile."""
        block, run = self.block, self.run
        own = {name: draw.of_run(run.seed, run.run, run.last_step + 1)
               for name, draw in block.draws.items()}
        own |= {'batch': (), 'block': block, 'runs': [run.run], 'steps': run.last_step + 1,
                'abort_step': None, 'wanted': everything(block)}
        if block.settings:
            own['settings'] = self.scenario.settings(block.section)

        def available(name: str) -> Any:
            return own[name] if name in own else self.scenario.part(name)
        self._compute = made(block.make, available, f'block {block.name}').step

    def on_step(self, k: int) -> None:
        """Compute and publish."""
        given = {name: source.value(k) for name, source in self._inputs.items()}
        for name, source in self._held.items():
            given[name] = source.value(k)
        if self.block.control:
            given['control'] = self._control
        outputs = self._compute(k, **given)
        if k == 0 or self._commands:
            self._check(k, outputs)
        self.before_publishing(k, outputs)
        publish = self.host.publish
        for name, (signal, codec, publisher) in self._outputs.items():
            try:
                value = outputs[name]
                made_of = codec.encode(k, value)
            except Exception as error:          # noqa: B902 - said better, or handed on
                self._check(k, outputs)
                if isinstance(error, (ValueError, struct.error)):
                    raise self._refusal(k, signal, error) from error
                raise
            if codec.frames:
                publish(publisher, signal.name, k, made_of.serialised(), made_of)
            else:
                publish(publisher, signal.name, k, made_of, value)

    def before_publishing(self, k: int, outputs: dict[str, Any]) -> None:
        """Look at the outputs of step k."""

    def _check(self, k: int, outputs: Any) -> None:
        """
        Refuse outputs that have not the form of their signals, or a command that is no number.

        All of it at the first firing, and at each one where the command is a float. Later a value
        of another form is noticed when it does not go into its message.
        """
        given = set(outputs) if isinstance(outputs, dict) else set()
        if given != set(self._outputs):
            raise DiagramError(f'block {self.block.name}: step must return a value for each of '
                               f'{", ".join(self._outputs) or "no output"} by name, got '
                               f'{", ".join(sorted(given)) or type(outputs).__name__}')
        for name, (signal, _, _) in self._outputs.items():
            complaint = signal.complaint(outputs[name], ())
            if complaint:
                raise self._refusal(k, signal, complaint)
        for name in self._commands:
            command = outputs[name].command
            if not np.isfinite(command).all():
                raise self._refusal(k, self.block.writes[name],
                                    f'a command must be finite, got {np.asarray(command).tolist()}')

    def _refusal(self, k: int, signal: Signal, why: Any) -> DiagramError:
        return DiagramError(f'block {self.block.name} writes {signal.name} at step {k}: {why}')

    # -- control ----------------------------------------------------------------------------

    def _serve_control(self) -> None:
        scenario = self.scenario
        if scenario.has_shared('mode'):
            self._control = Control(scenario.part('operation').mode)
        self._pause = self.writer('/run/pause', Bool)
        self.create_service(RunControl, '/run/control', self._on_control)

    def _on_control(self, request: RunControl.Request, response: RunControl.Response
                    ) -> RunControl.Response:
        actions, modes = RunControl.Request, self.scenario.mission.modes
        response.accepted = True
        if request.action in (actions.PAUSE, actions.RESUME):
            pause = request.action == actions.PAUSE
            self.host.publish(self._pause, '/run/pause', -1, Bool(data=pause))
            response.message = 'paused' if pause else 'resumed'
        elif request.action == actions.MODE and request.mode in modes:
            self._control = self._control._replace(mode=request.mode)
            response.message = f'mode {request.mode}'
            self.event('MODE', response.message)
        elif request.action == actions.ABORT:
            self._control = self._control._replace(abort=True)
            response.message = 'abort goes out with the next frame'
            self.event('ABORT', response.message)
        else:
            response.accepted = False
            response.message = (f'mode must be one of {", ".join(modes) or "none"}, got '
                                f'{request.mode!r}' if request.action == actions.MODE
                                else f'unknown action {request.action}')
        return response


class LegNode(FiringNode):
    """A leg of the link as a node: it reads the envelope of a frame, the payload is bytes to it."""

    raw = True

    def __init__(self, host: Host, block: Leg) -> None:
        super().__init__(host, block)
        self._name = block.writes['arrival'].name
        self._out = self.writer(self._name, LinkFrame)
        if block.status is not None:
            self._status = self.writer(block.status.name, LinkStatus)
            self._counted = Layout(LinkStatus, {'header.frame_id': self.run.frame_id})

    def make(self) -> None:
        """Draw what will happen to every frame."""
        run, drawn = self.run, self.block.draws['chance']
        plan = drawn.of_run(run.seed, run.run, run.last_step + 1)
        self._channel = Channel(plan, drawn.hold_steps, run.step_ns)
        self._hold_s = drawn.hold_steps * run.step_s

    def on_step(self, k: int) -> None:
        """Send what came in, hand on what is due, and say what became of it all."""
        sent = self._inputs['content'].held.get(k)
        frame = None
        if sent is not None and not sent.empty:
            frame = Frame(sequence=sent.sequence, sent_ns=sent.sent, expedited=sent.expedited,
                          payload=bytes(sent.payload))
        due = self._channel.advance(k, frame)
        passed = FrameOfLink(k, empty=True)
        if due is not None:
            passed = FrameOfLink(
                step=k, sequence=due.sequence, sent=due.sent_ns, arrived=due.arrived_ns,
                released=due.released_ns, expedited=due.expedited, payload=due.payload)
        self.host.publish(self._out, self._name, k, passed.serialised(), passed)
        if self.block.status is not None:
            self._tell(k)

    def _tell(self, k: int) -> None:
        delay_s = self._channel.delay_s
        self.host.publish(self._status, self.block.status.name, k, self._counted.pack(
            *divmod(k * self.run.step_ns, NS_PER_S), k, *vars(self._channel.counts).values(),
            self._hold_s, delay_s(50), delay_s(99), delay_s(100)))


class PlantNode(BlockNode):
    """
    The true world; it owns `/clock`, the pacing and the end of the run.

    lockstep    step k+1 is made when the thrust of step k is here: as fast as the machine can.
    realtime    step k is made at k * step_s / pace_factor of wall time, whatever has come.
    """

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block)
        self._started = self._paused = False
        self._recorded: int | None = None
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
        self.watch('/run/ready', String, lambda message: self._on_ready(message.data))
        self.listen('/run/pause', Bool, lambda _, message: self._on_pause(message.data))
        if RECORDER in self.roster.names:
            self._recorded = -1
            self.listen('/run/recorded_step', UInt64, self._on_recorded)
        self.host.publish(self._story, '/run/scenario', -1,
                          String(data=self.host.arguments.text()))

    def on_step(self, k: int) -> None:
        """Advance the truth; say when it is the last of it."""
        super().on_step(k)
        self.host.publish(self._time, '/clock', k, self._time_layout.pack(
            *divmod(k * self.run.step_ns, NS_PER_S)))

    def before_publishing(self, k: int, outputs: dict[str, Any]) -> None:
        """Say that step k is the last before anybody can have it."""
        try:
            final = outputs[self._truth].final
        except (LookupError, TypeError, AttributeError):
            self._check(k, outputs)
            raise
        if final:
            self.host.publish(self._end, '/run/end', -1, UInt64(data=k))
            self.host.end(k)

    # -- pacing -----------------------------------------------------------------------------

    def may_fire(self) -> bool:
        """In lock step, say whether the next step is due; in real time the clock alone does."""
        return (self._started and not self.realtime and not self._paused and not self._too_far()
                and super().may_fire())

    def _too_far(self) -> bool:
        behind = self._recorded is not None and self._next - self._recorded > RECORDER_LEAD
        if behind:
            self.trouble['recorder'] = f'waiting for {RECORDER}, at step {self._recorded}'
        elif self.trouble:
            self.trouble.pop('recorder', None)
        return behind

    def _on_ready(self, name: str) -> None:
        self._waiting_for.discard(name)
        if self._waiting_for or self._started:
            return
        self._started = True
        if self.realtime:
            self._step_s = self.run.step_s / self.run.pace_factor
            self._origin = time.monotonic()
            self.create_timer(self._step_s / TICKS_PER_STEP, self.guarded(self._tick))

    def _tick(self) -> None:
        while (not self._paused and not self.finished and not self._is_over()
               and time.monotonic() - self._origin >= self._next * self._step_s):
            self.fire()
            self.host.work()                    # what of it is here fires before the next step

    def _on_recorded(self, _: int, message: UInt64) -> None:
        self._recorded = message.data

    def _on_pause(self, paused: bool) -> None:
        if paused == self._paused:
            return
        self._paused = paused
        self.event('PAUSE' if paused else 'RESUME', 'simulation time '
                   + ('stands still' if paused else 'goes on'))
        if self._started and self.realtime and not paused:
            self._origin = time.monotonic() - self._next * self._step_s


def node_of(host: Host, block: Block) -> FiringNode:
    """Make the node of a block."""
    if isinstance(block, Leg):
        return LegNode(host, block)
    if block.name == host.roster.diagram.plant:
        return PlantNode(host, block)
    return BlockNode(host, block)
