"""Inputs of a node: what has come of each, and what a firing gets of it."""

import time
from typing import Any, Callable

from rclpy.callback_groups import CallbackGroup

from rvd_dynamics.diagram.block import Read
from rvd_dynamics.diagram.ros import boundary
from rvd_dynamics.diagram.ros.horizon import Horizon, stamped_with_wall_time
from rvd_dynamics.diagram.ros.qos import DEPTH
from rvd_dynamics.diagram.run import Run

JOY = 'sensor_msgs/msg/Joy'
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
    held : dict
        What has come, by step: a value, or a frame as it is.
    late : dict
        What came after the firing that was to have it, for a block that asks for it.
    missed : dict
        Steps that a firing had to do without, and that may still come; the newest DEPTH.
    local : bool
        Its writer is in this process: what it hands over needs no look.
    """

    def __init__(self, read: Read, period: int, codec: Any, last_step: int,
                 run: Run | None = None, made: Callable[[], int | None] = lambda: None) -> None:
        self.topic = read.signal.name
        self.delay, self.period, self.codec = read.delay, period, codec
        self.held: dict[int, Any] = {}
        self.late: dict[int, Any] = {}
        self.missed: dict[int, None] = {}
        self.keeps_late = bool(read.late)
        self.local = False
        self._horizon = Horizon(run, last_step, period, made=made)
        self._step_ns = run.step_ns if run is not None and read.signal.message == JOY else 0
        self._taken = None if codec is None else boundary.content(
            read.signal, codec, read.optional)
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
        """Return the last step that is believed."""
        return self._horizon.bound(self.need)

    def believes(self, step: int) -> bool:
        """Say whether a message of `step` can be one of this run; see `Horizon`."""
        return self._horizon.believes(step, self.need)

    def taken(self, step: int, item: Any) -> Any:
        """
        Return what is kept of a message from another process.

        Raises
        ------
        Refused
            If its step or its content cannot be; see `boundary`.
        """
        if step < 0 or step % self.period:
            raise boundary.Refused(f'step {step} is none of its writer, which fires at every '
                                   f'{self.period} from 0 on')
        if not self.believes(step):
            raise boundary.Refused(self._wall_time(step) or self._horizon.words(step, self.need))
        try:
            return item if self._taken is None else self._taken(step, item)
        except boundary.Refused as why:
            raise boundary.Refused(f'step {step}: {why}') from None

    def _wall_time(self, step: int) -> str:
        """Return what is wrong with a stamp by the clock on the wall, the usual mistake."""
        when = stamped_with_wall_time(step*self._step_ns) if self._step_ns else ''
        return when and (f'stamped with wall time ({when}); {self.topic} carries the simulation '
                         'time of its step: stamp step * step_s, from 0 on')

    def there(self) -> bool:
        """Say whether what the next firing needs is here."""
        return self.need < 0 or self.need in self.held

    def value(self) -> Any:
        """Return what the next firing gets of this input."""
        if self.codec is None or self.codec.envelope:   # a leg takes the frame as it is, or none
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
        return self.codec.decode(step, item) if self.codec.frames else item

    def advance(self, k: int) -> None:
        """Turn to firing k, and drop what neither it nor a later one needs."""
        need = self.wanted(k)
        if not self.there():
            self.missed[self.need] = None
            if len(self.missed) > DEPTH:
                del self.missed[next(iter(self.missed))]
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
