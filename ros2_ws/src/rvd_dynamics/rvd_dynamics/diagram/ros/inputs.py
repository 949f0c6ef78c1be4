"""Inputs of a node: what has come of each, and what a firing gets of it."""

import time
from typing import Any, Callable

from rclpy.callback_groups import CallbackGroup

from rvd_dynamics.diagram.block import Read
from rvd_dynamics.diagram.ros.qos import DEPTH

HELD_FOR_S = 0.5                # [s] wall time after which a held stick is nobody's


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
    """
    One input of a block: what has come, by the step of its writer.

    Attributes
    ----------
    need : int
        Step of the writer whose output the next firing gets; -1: before the start.
    late : dict
        What came after the firing that was to have it, for a block that asks for it.
    """

    def __init__(self, read: Read, period: int, codec: Any, last_step: int) -> None:
        self.topic = read.signal.name
        self.delay, self.period, self.codec = read.delay, period, codec
        self.held: dict[int, Any] = {}          # message, or what passed by hand
        self.late: dict[int, Any] = {}
        self.keeps_late = bool(read.late)
        self.by_hand = False
        self._last_step = last_step
        self._refused = -1                      # step of the last message that was refused
        self.start = read.signal.initial(())
        self.need = self.wanted(0)

    def wanted(self, k: int) -> int:
        """Return the step of the writer whose output firing k needs; -1: before the start."""
        at = k - self.delay
        return at - at % self.period if at >= 0 else -1

    def first_use(self, step: int, period: int) -> int:
        """Return the first firing of a block of this period that needs step `step` or later."""
        return -(-(step + self.delay) // period) * period

    def bound(self) -> int:
        """Return the last step that is believed: a queue ahead, and within the run."""
        return min(max(self.need, 0) + DEPTH * self.period, self._last_step)

    def believes(self, step: int) -> bool:
        """
        Say whether a message of `step` can be one of this run.

        A writer is never further ahead than its queue is deep; a stray number would have the node
        fire for ever, and fill its memory. A reader that was stopped for longer sees the writer go
        on from where it was refused, and believes that.
        """
        if step <= self.bound():
            return True
        goes_on = 0 <= self._refused < step <= self._refused + DEPTH * self.period
        self._refused = step
        return goes_on and step <= self._last_step

    def there(self) -> bool:
        """Say whether what the next firing needs is here."""
        return self.need < 0 or self.need in self.held

    def value(self) -> Any:
        """Return what the next firing gets of this input."""
        if self.codec is None:                  # a leg takes the message as it is, or none
            return self.held.get(self.need)
        if self.need < 0:
            return self.start
        item = self.held.get(self.need)
        if item is None:
            return self.codec.missing(self.need)
        return self._decoded(self.need, item)

    def take_late(self) -> dict[int, Any]:
        """Return what came too late since the last firing, by the step of its writer."""
        late, self.late = self.late, {}
        return {step: self._decoded(step, item) for step, item in sorted(late.items())}

    def _decoded(self, step: int, item: Any) -> Any:
        return item if self.by_hand else self.codec.decode(step, item)

    def advance(self, k: int) -> None:
        """Turn to firing k, and drop what neither it nor a later one needs."""
        need = self.wanted(k)
        for step in range(max(self.need, 0), need):
            self.held.pop(step, None)
        self.need = need


class HeldInput:
    """
    The newest message of a writer that sends when it likes, by the wall clock.

    `said(why)` is called when the input gets lost, or lost for another reason, and with '' when
    it is back: once for each change. The first reading of a good input is no change.
    """

    def __init__(self, read: Read, codec: Any, said: Callable[[str], None] = lambda why: None
                 ) -> None:
        self.codec = codec
        self._said, self._why = said, ''
        self._newest: tuple[float, Any] | None = None

    def keep(self, message: Any) -> None:
        """Keep a message; it came now."""
        self._newest = (time.monotonic(), message)

    def value(self, k: int) -> Any:
        """Return what the newest message says; what is missing when it is too old."""
        if self._newest is None:
            found, why = self.codec.missing(k), 'no message yet'
        elif time.monotonic() - self._newest[0] > HELD_FOR_S:
            found, why = self.codec.missing(k), f'the newest message is older than {HELD_FOR_S:g} s'
        else:
            message = self._newest[1]
            found, why = self.codec.decode(k, message), self.codec.fault(message)
        if why != self._why:
            self._why = why
            self._said(why)
        return found
