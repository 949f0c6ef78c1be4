"""Inputs of a node: what has come of each, and what a firing gets of it."""

import time
from typing import Any

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
