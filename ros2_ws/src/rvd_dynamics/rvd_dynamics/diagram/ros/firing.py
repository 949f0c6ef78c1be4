"""
Nodes of blocks: fire once per period, in order, when the inputs of that step are complete.

The diagram is a synchronous dataflow, so the order in which DDS delivers does not matter and a
run in lock step is the same to the last bit every time, however its blocks share processes. In
real time a block that has not fired for k when an input of a later firing arrives fires k with
what it holds; the rest is MISSING, and its codec says what that is worth.
"""

from math import inf
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rosgraph_msgs.msg import Clock

from rvd_dynamics.diagram.block import Block, Read
from rvd_dynamics.diagram.ros.boundary import Refused
from rvd_dynamics.diagram.ros.frame_codecs import Envelope
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.horizon import Horizon
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.inputs import Gate, HeldInput, Input
from rvd_dynamics.diagram.ros.node import RunNode


class FiringNode(RunNode):
    """What nodes of blocks and of legs have in common: inputs, and when to fire."""

    raw = False                                 # takes messages as they are, not values
    hurries = True                              # in real time, fires for what is due later

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block.name)
        self.block = block
        self.realtime = self.run.pace == 'realtime'
        self.missing_count = self.late_count = 0
        self._next = 0
        self._gate = Gate()
        self._inputs: dict[str, Input] = {}
        self._given: list[Input] = []           # the same, without their names
        self._held: dict[str, HeldInput] = {}
        self._last: Input | None = None         # the input that comes last
        self._gated = False
        self._taking = False                    # what waits in the middleware
        self._limit = self.run.last_step        # last step that may be fired so far
        host.firing.append(self)

    # -- inputs -----------------------------------------------------------------------------

    def connect(self) -> None:
        """Subscribe to what other processes write, once all blocks of this one are made."""
        order = {block.name: i for i, block in enumerate(self.roster.diagram.order)}
        remote: list[tuple[tuple, str, Read]] = []
        for name, read in self.block.reads.items():
            writer = self.roster.diagram.writer_of.get(read.signal.name)
            codec = Envelope(read.signal, self.run) if self.raw else self.codec_of(read.signal)
            if read.held:
                self._hold(name, read, codec)
                continue
            self._inputs[name] = Input(read, writer.period if writer else 1, codec,
                                       self.run.last_step, self.run,
                                       *([self.host.bound_of(writer.name)] if writer else []))
            if self.host.is_local(read.signal.name):
                self._inputs[name].local = True
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
        self._given = list(self._inputs.values())
        if self.roster.follows_clock(self.block.name):
            self._limit = -1
            self._instants = Horizon(self.run, self.run.last_step)
            self.listen('/clock', Clock, self._on_clock)

    def _taker(self, name: str, codec: Any) -> Any:
        if codec.frames:
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
        readers = [block.name for block in self.roster.diagram.order
                   if any(r.held and r.signal.name == read.signal.name
                          for r in block.reads.values())]
        speaks = readers[-1] == self.block.name             # once, whoever else reads it
        held = self._held[name] = HeldInput(
            read, codec, *([self._speaker(read.signal.name)] if speaks else []))
        self.watch(read.signal.name, message_type(read.signal.message), held.keep)

    def _speaker(self, topic: str) -> Any:
        """Return what says, as an event and in /diagnostics, that a held input is lost or back."""
        def said(why: str) -> None:
            if why:
                self.trouble[topic] = f'{topic} does not count: {why}'
                self.event('STICK_LOST', self.trouble[topic])
            else:
                del self.trouble[topic]
                self.event('STICK', f'{topic} counts')
        return said

    def listen(self, topic: str, kind: type, heard: Any) -> None:
        """Hear what the run says about itself, by hand where it is said in this process."""
        if self.host.is_local(topic):
            self.host.take(topic, heard)
        else:
            self.watch(topic, kind, lambda message: heard(-1, message))

    def _on_clock(self, step: int, message: Any) -> None:
        if step < 0:                            # from another process
            step, rest = divmod(ns_of(message.clock), self.run.step_ns)
            if rest or step < 0:
                self.refuse('/clock', f'{ns_of(message.clock)} ns is no instant of a step')
                return
            made = self.host.made
            if made is not None and step > made:
                self.refuse('/clock', f'step {step} has not been: this is step {made}')
                return
            if not self._instants.believes(step, self._limit):
                self.refuse('/clock', self._instants.words(step, self._limit))
                return
        self._limit = max(self._limit, min(step, self.run.last_step))

    def latest(self) -> float:
        """Return the last step at which anything can have been written, if this node knows."""
        return inf

    def _came(self, name: str, step: int, item: Any) -> None:
        """Take in what the writer of an input wrote in `step`."""
        given, period = self._inputs[name], self.block.period
        if step < given.need:
            if step in given.missed:            # of a step that was there nobody needs another
                self._take_late(given, step, item)
            return
        try:
            if not given.local:
                if step > self.latest():
                    raise Refused(f'step {step} has not been: this is step {self.step}')
                item = given.taken(step, item)
        except Refused as why:
            self.refuse(given.topic, str(why))
            return
        given.held[step] = item
        if self.host.final_step is not None and not given.local:
            self.host.ending.goes_on(step)
        if self.realtime and self.host.begun and not self._taking and self.hurries:
            due = given.first_use(step, period)
            if self._next < due:
                self._take_waiting()
            while self._next < due and self._next <= self._limit and not self._is_over():
                self.fire()
        if self._gated:
            self._look_at_gate()

    def _take_waiting(self) -> None:
        """
        Take in what has arrived and waits for the executor, before any of it counts as missing.

        The executor serves topics in turn, one message of each. In a process that is behind, an
        input of every tenth step would overtake one of every step, for good.
        """
        self._taking = True
        try:
            for given in self._given:
                subscription = self.subscriptions_of.get(given.topic)
                while subscription is not None:
                    with subscription.handle:
                        found = subscription.handle.take_message(
                            subscription.msg_type, subscription.raw)
                    if found is None:
                        break
                    subscription.callback(*found)
        finally:
            self._taking = False

    def _take_late(self, given: Input, step: int, item: Any) -> None:
        """Count what a firing had to do without, and keep it for a block that asks for it."""
        try:
            item = item if given.local else given.taken(step, item)
        except Refused as why:
            self.refuse(given.topic, str(why))
            return
        del given.missed[step]
        self.late_count += 1
        self.trouble['late'] = f'{self.late_count} messages came after their step'
        if given.keeps_late:
            given.late[step] = item

    def _look_at_gate(self) -> None:
        self._gate.open = self._last.there()

    # -- firing -----------------------------------------------------------------------------

    def may_fire(self) -> bool:
        """Say whether every input of the next firing is here."""
        if self.finished or self._next > self._limit or not self._inputs or self._is_over():
            return False
        for given in self._given:
            if not given.there():
                return False
        return True

    def _is_over(self) -> bool:
        final = self.host.final_step
        return final is not None and self._next > final

    def fire(self) -> None:
        """Do everything that belongs to the next firing."""
        k = self._next
        if self.realtime:
            self._count_missing()
        self._next = k + self.block.period
        self.step = k
        try:
            values = {name: given.value() for name, given in self._inputs.items()}
            for given in self._given:           # in real time a firing may lie within another
                given.advance(self._next)
            self.on_step(k, values)
        except Exception as error:              # noqa: B902 - named and handed on
            if not hasattr(error, 'rvd_node'):
                error.rvd_node = self
            raise
        if self._gated:
            self._look_at_gate()
        self.host.diagnose()
        if self._is_over():
            self.finish()

    def _count_missing(self) -> None:
        missing = sum(not given.there() for given in self._given)
        if missing:
            before, self.missing_count = self.missing_count, self.missing_count + missing
            self.trouble['missing'] = f'{self.missing_count} inputs missing so far'
            if len(str(before or '')) < len(str(self.missing_count)):   # 1, 10, 100 ...
                self.event('LATE', f'inputs missing at their step: {self.missing_count} so far; '
                           'this machine does not keep up with the pace')

    def on_step(self, k: int, values: dict[str, Any]) -> None:
        """Compute and publish, from the values of the inputs; implemented by each kind of node."""
        raise NotImplementedError

    def on_end(self, final_step: int) -> None:
        """Finish after the last firing, which may still be on its way."""
        if self._is_over():
            self.finish()
