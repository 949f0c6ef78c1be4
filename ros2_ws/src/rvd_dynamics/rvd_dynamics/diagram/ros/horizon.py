"""
How far ahead a step on a topic can be: what has come before, the clock on the wall, the run's end.

A message from beyond would have a node fire for ever, hold what never comes due, or count as lost
what was never sent. It is left out; whoever wrote it is not of this run, or has lost count.
"""

from collections.abc import Callable
import time

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.ros.qos import DEPTH
from rvd_dynamics.diagram.run import Run

AHEAD = 4                       # [firings] that a writer may seem ahead of its own pace
YEARS_S = 10*365*86400.0        # [s] by which the clock of a machine is off at most


class Horizon:
    """
    The last step that a topic can be at.

    lockstep    a writer is never further ahead than its queue is deep; one whose reader was stopped
                for longer goes on from where it was refused, and is believed then. Where the plant
                has noted how far it is, nobody is ahead of it.
    realtime    a writer fires no faster than the wall clock, which runs on while its reader is
                stopped. Before the first message nothing is known: a writer that goes on from
                where it was refused is believed, since its reader may have come late. Where the
                plant has noted how far it is, that alone counts, and nobody is further ahead of it
                than of its own pace: a reader of many topics that is behind meets the newest of one
                before the oldest of another, and steps that come one after the other carry no
                reader beyond the plant.

    Parameters
    ----------
    run : Run, or None
        Whose pace it is; None counts as lock step.
    last_step : int
        Of the run.
    period : int
        Steps between two firings of the writer.
    queue : int
        Firings that its queue holds.
    made : function, optional
        Returns the newest step that the plant has noted, or None; see `Host.bound_of`.
    """

    def __init__(self, run: Run | None, last_step: int, period: int = 1, queue: int = DEPTH,
                 made: Callable[[], int | None] = lambda: None) -> None:
        self._step_s = (run.step_s/run.pace_factor
                        if run is not None and run.pace == 'realtime' else None)
        self._last_step, self._period, self._queue = last_step, period, queue
        self._newest, self._came = -1, 0.0      # newest step that was believed, and when it came
        self._refused = -1                      # step of the last message that was refused
        self._made = made

    def bound(self, need: int = 0) -> int:
        """Return the last step that is believed now, of a reader that needs step `need` next."""
        if self._step_s is None:
            return min(max(need, 0) + self._queue*self._period, self._most())
        if self._made() is not None:
            return self._most()
        allowed = max(self._newest, need, 0) + AHEAD*self._period
        if self._newest >= 0:
            allowed += int((time.monotonic() - self._came)/self._step_s)
        return min(allowed, self._last_step)

    def _most(self) -> int:
        """Return the last step that can be, whatever has come."""
        made = self._made()
        if made is None:
            return self._last_step
        ahead = 0 if self._step_s is None else AHEAD*self._period
        return min(max(made, 0) + ahead, self._last_step)

    def believes(self, step: int, need: int = 0) -> bool:
        """Say whether a message of `step` can be one of this run."""
        if step <= self.bound(need):
            if step > self._newest:
                self._newest, self._came = step, time.monotonic()
            return True
        may_go_on = self._step_s is None or self._newest < 0
        goes_on = may_go_on and 0 <= self._refused < step <= self._refused + self._far()
        self._refused = step
        if not goes_on or step > self._most():
            return False
        self._newest, self._came = max(step, self._newest), time.monotonic()
        return True

    def _far(self) -> int:
        return (self._queue if self._step_s is None else AHEAD)*self._period

    def words(self, step: int, need: int = 0) -> str:
        """Say why a step was refused."""
        end = f' of a run that ends with {self._last_step} at the latest'
        return f'step {step} is beyond {self.bound(need)}, the last that can be due{end}'


def stamped_with_wall_time(stamp_ns: int) -> str:
    """Return when it was, if a stamp is of the clock on the wall; nothing if it is not."""
    if abs(stamp_ns/NS_PER_S - time.time()) > YEARS_S:
        return ''
    return time.strftime('%Y-%m-%d %H:%M:%S UTC', time.gmtime(stamp_ns//NS_PER_S))
