"""Inputs of a node: what has come of each, and what a firing gets of it."""

import time
from typing import Any, Callable

from rclpy.callback_groups import CallbackGroup

from rvd_dynamics.diagram.block import Read

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
    """

    def __init__(self, read: Read, period: int, codec: Any) -> None:
        self.delay, self.period, self.codec = read.delay, period, codec
        self.held: dict[int, Any] = {}          # message, or what passed by hand
        self.by_hand = False
        self.start = read.signal.initial(())
        self.need = self.wanted(0)

    def wanted(self, k: int) -> int:
        """Return the step of the writer whose output firing k needs; -1: before the start."""
        at = k - self.delay
        return at - at % self.period if at >= 0 else -1

    def first_use(self, step: int, period: int) -> int:
        """Return the first firing of a block of this period that needs step `step` or later."""
        return -(-(step + self.delay) // period) * period

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
        return item if self.by_hand else self.codec.decode(self.need, item)

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
