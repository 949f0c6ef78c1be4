"""
Who of a run's processes gives no sign of life, and why: what `fly` says of it.

Each notes on the page of the run (`rvd_dynamics.pulse`) when its loop turns: at each message, at
each firing, and twice a second when it has nothing to do. So it is silent when it is stopped, when
it hangs, and while it computes; /proc tells which. That it compiles a loop, as at a first use, it
notes: on a machine with other work that takes minutes, and is no reason to give the run up.
"""

from collections.abc import Callable, Collection
import math
import time
from typing import NamedTuple

from rvd_campaign import cpu
from rvd_campaign.cpu import Usage, usage
from rvd_dynamics.diagram.roster import Process
from rvd_dynamics.pulse import Pulse

SILENT_S = 2.0                  # [s] wall time without a sign of life that is said,
STALL_S = 10.0                  # [s] with which a run is given up,
WORK_S = 120.0                  # [s] and where the process computes
SINCE_S = 1.0                   # [s] wall time between two loops that are compiled
BUSY = 0.1                      # share of a core that is more than waiting
LATELY_S = 4.0                  # [s] wall time over which that is looked at
LOOK_S = 0.2                    # [s] wall time between two looks
UNSEEN_S = 1.0                  # [s] wall time between two looks: this process did not run itself
STOPPED, COMPUTES, HANGS = 'is stopped', 'computes', 'hangs'
COMPILES = 'compiles'
MEANT = {STOPPED: 'is stopped (SIGSTOP, or a debugger)', COMPUTES: 'computes', HANGS: 'hangs',
         COMPILES: 'compiles loops, which is done once on a machine'}


class Silent(NamedTuple):
    """A process that gives no sign of life."""

    name: str
    seconds: float              # wall time since the last one
    how: str                    # STOPPED, COMPUTES, COMPILES or HANGS
    counted: float              # those of the seconds since it has compiled

    @property
    def patience_s(self) -> float:
        """How long it may be silent before the run is given up [s]."""
        return {COMPILES: math.inf, COMPUTES: WORK_S}.get(self.how, STALL_S)


class Vigil:
    """
    Watches the processes of one run; `look` now and then.

    Parameters
    ----------
    processes : tuple of Process
        In the order of the roster, which is that of the page.
    pulse : Pulse
    pids : callable
        Returns the ids of those that are still there, by name.
    spared : collection of str
        Processes without which the flight goes on.
    usage : callable
        Returns what a process does and has used.
    """

    def __init__(self, processes: tuple[Process, ...], pulse: Pulse,
                 pids: Callable[[], dict[str, int]], spared: Collection[str] = (),
                 usage: Callable[[int], Usage] = usage) -> None:
        self._places = {process.name: place for place, process in enumerate(processes)}
        self._words = {process.name: in_words(process) for process in processes}
        self._pulse, self._pids, self._usage = pulse, pids, usage
        self._spared = frozenset(spared)
        self._looked = self._since = time.monotonic()
        self._used: dict[str, tuple[float, float]] = {}     # when looked at, CPU time then [s]
        self._busy_at: dict[str, float] = {}                # when a silent one was seen to compute
        self._stopped_at: dict[str, float] = {}
        self.silent: dict[str, Silent] = {}                 # by name, those that were told

    def look(self, now: float | None = None) -> list[str]:
        """Return what has changed since the last look, a sentence for each process."""
        now = time.monotonic() if now is None else now
        if now - self._looked < LOOK_S:
            return []
        if now - self._looked > UNSEEN_S:       # this process stood still, maybe all did
            self._since = now
        self._looked = now
        said, before, self.silent = [], self.silent, {}
        for name, pid in self._pids().items():
            found = self._silence(name, pid, now)
            if found is not None and found.seconds > SILENT_S:
                self.silent[name] = found
                if name not in before or (STOPPED in (found.how, before[name].how)
                                          and found.how != before[name].how):
                    said.append(f'{self._words[name]} has given no sign of life for '
                                f'{found.seconds:.1f} s: it {MEANT[found.how]}; '
                                + self._what_then(found))
            elif name in before:
                said.append(f'{self._words[name]} goes on, after {before[name].seconds:.1f} s')
        return said

    def _what_then(self, silent: Silent) -> str:
        if silent.how == COMPILES:
            return 'the flight waits for it'
        return ('the flight goes on without it' if silent.name in self._spared else
                f'the flight is given up after {silent.patience_s:g} s')

    def given_up(self) -> list[Silent]:
        """Return those whose silence has lasted too long; none while there is hope."""
        return [s for s in self.silent.values()
                if s.counted > s.patience_s and s.name not in self._spared]

    def in_words(self, lost: list[Silent], owing: str = '') -> str:
        """Return one sentence for each of `lost`; `owing`: what they owe, where that is known."""
        return '; '.join(f'{self._words[s.name]} has given no sign of life for '
                         f'{s.patience_s:g} s of wall time: {owing}it {MEANT[s.how]}'
                         for s in lost)

    @property
    def waits(self) -> bool:
        """Whether the flight waits for a process that may yet come back."""
        return not self.silent.keys() <= self._spared

    def compiling(self) -> list[str]:
        """Return the names of the processes that compile; one that is stopped does not."""
        return [name for name, pid in self._pids().items()
                if self._compiles(name, time.monotonic())
                and self._usage(pid).state not in cpu.STOPPED]

    def _compiles(self, name: str, now: float) -> bool:
        compiles, at = self._pulse.compiled_s(self._places[name])
        return compiles or now - at < SINCE_S

    def _silence(self, name: str, pid: int, now: float) -> Silent | None:
        """Return for how long a process has been silent, and why; None where it need not speak."""
        found = self._usage(pid)
        beaten = self._pulse.beaten_s(self._places[name])
        if found.state in cpu.STOPPED:
            beaten = beaten or self._stopped_at.setdefault(name, now)
        else:
            self._stopped_at.pop(name, None)
        if beaten is None:                      # not begun, not ours, or done with its work
            return None
        seconds = now - max(beaten, self._since)
        counted = min(seconds, now - self._pulse.compiled_s(self._places[name])[1])
        if found.state in cpu.STOPPED:
            return Silent(name, seconds, STOPPED, counted)
        if seconds < 0.5*SILENT_S:
            self._used.pop(name, None)
            return None
        busy = self._computes(name, found, now)
        how = COMPILES if busy and self._compiles(name, now) else COMPUTES if busy else HANGS
        return Silent(name, seconds, how, counted)

    def _computes(self, name: str, found: Usage, now: float) -> bool:
        """Say whether a silent process has lately done more than wait."""
        at, cpu_s = self._used.setdefault(name, (now, found.cpu_s))
        if now - at > 2*LOOK_S:
            self._used[name] = now, found.cpu_s
            if found.cpu_s - cpu_s > BUSY*(now - at):
                self._busy_at[name] = now
        if found.state in ('R', 'D'):
            self._busy_at[name] = now
        return now - self._busy_at.get(name, -LATELY_S) < LATELY_S


def in_words(process: Process) -> str:
    """Return the name of a process, with its nodes where they share it."""
    if process.nodes in ((), (process.name,)):
        return process.name
    return f'process {process.name} ({", ".join(process.nodes)})'
