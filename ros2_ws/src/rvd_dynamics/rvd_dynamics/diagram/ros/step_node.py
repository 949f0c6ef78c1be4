"""
Nodes of the ring: fire once per step, in order, when the inputs of that step are complete.

The loop is a synchronous dataflow, so the order in which DDS delivers does not matter and a
run in lock step is the same to the last bit every time. In real time a node that has not fired
for k when an input of k+1 arrives fires k with what it holds; the rest is `None`, MISSING.
"""

from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.publisher import Publisher

from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.node import WatchNode


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


class StepNode(WatchNode):
    """
    A node of the ring.

    Subclasses declare `step_input`s in the order in which `on_step` takes them and
    `step_output`s, all of them in the node's spec, and implement
    `on_step(step, *messages)`: a message is None when it is missing or lies before the start.
    """

    def __init__(self, name: str, **kwargs: Any) -> None:
        super().__init__(name, **kwargs)
        self._lags: list[int] = []
        self._last = 0                          # slot of the input that comes last
        self._gate = Gate()
        self._held: dict[int, list] = {}
        self._next = 0
        self._realtime = self.mission.pace == 'realtime'
        self.missing_count = 0
        self.late_count = 0

    def step_input(self, topic: str, kind: type, lag: int = 0, early: bool = False) -> None:
        """
        Take the message of step k - lag of `topic` when firing for step k.

        `early`: it comes before that of another input, so in lock step, where nothing is ever
        missing, the node need not wake up for it (4 % of the CPU of the whole graph).
        """
        if (topic, lag) not in self.spec.fires_on:
            raise ValueError(f'{self.get_name()} does not fire on {topic} with lag {lag}')
        slot = len(self._lags)
        self._lags.append(lag)
        group = self._gate if early and not self._realtime else None
        self._last = self._last if early else slot
        if hasattr(kind, 'step'):
            self.watch(topic, kind, lambda m: self._receive(slot, m.step + lag, m), group=group)
        else:                                   # Joy carries its step in the stamp
            step_ns = self.mission.step_ns
            self.watch(topic, kind,
                       lambda m: self._receive(slot, ns_of(m.header.stamp) // step_ns + lag, m),
                       group=group)

    def step_output(self, topic: str, kind: type) -> Publisher:
        """Advertise a topic that gets exactly one message per step."""
        if topic not in self.spec.emits:
            raise ValueError(f'{self.get_name()} does not emit {topic}')
        return self.writer(topic, kind)

    def on_step(self, step: int, *messages: Any) -> None:
        """Act on step `step`; implemented by each node."""
        raise NotImplementedError

    # -- firing ---------------------------------------------------------------------------

    def _receive(self, slot: int, step: int, message: Any) -> None:
        if step < self._next:                   # its step was fired without it
            self.late_count += 1
            self.trouble['late'] = f'{self.late_count} messages came after their step'
            return
        self._slots(step)[slot] = message
        if self._realtime:
            while self._next < step and self.final_step is None:
                self._fire()
        self.advance()

    def _slots(self, step: int) -> list:
        if step not in self._held:
            self._held[step] = [None] * len(self._lags)
        return self._held[step]

    def complete(self) -> bool:
        """Say whether every input of the next step is there (or lies before the start)."""
        held = self._slots(self._next)
        return all(held[i] is not None or self._next < lag for i, lag in enumerate(self._lags))

    def advance(self) -> None:
        """Fire every step whose inputs are complete."""
        while not self.done.done() and self.complete():
            self._fire()
        self._gate.open = self._slots(self._next)[self._last] is not None

    def _fire(self) -> None:
        step = self._next
        messages = self._slots(step)
        del self._held[step]
        self._next = step + 1
        self.step = step
        missing = sum(m is None and step >= lag for m, lag in zip(messages, self._lags))
        if missing:
            self.missing_count += missing
            self.trouble['missing'] = f'{self.missing_count} inputs missing so far'
        self.on_step(step, *messages)
        self.diagnose()
        if self.final_step is not None and step >= self.final_step:
            self.finish()

    def on_end(self) -> None:
        """Close after the last step, which may still be on its way."""
        if self.step >= self.final_step:
            self.finish()


