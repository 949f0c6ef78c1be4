"""What processes have used of the processor, and what they are doing."""

import os
from pathlib import Path
from typing import NamedTuple

TICKS_PER_S = os.sysconf('SC_CLK_TCK')
GONE, DEAD = '', ('Z', 'X')     # states: there is no such process, or it has ended;
STOPPED = ('T', 't')            # by a signal, or by a debugger


class Usage(NamedTuple):
    """
    One look at a process.

    Attributes
    ----------
    state : str
        Of its main thread, a letter of proc(5): R runs, S sleeps, D waits for a disk, T or t is
        stopped, Z has ended; empty when it is gone.
    cpu_s : float
        CPU time so far, user and system, all threads [s].
    """

    state: str
    cpu_s: float


def usage(pid: int) -> Usage:
    """Return what a process does, and what it has used so far."""
    try:
        fields = Path(f'/proc/{pid}/stat').read_text(errors='replace').rsplit(')', 1)[1].split()
    except OSError:
        return Usage(GONE, 0.0)
    return Usage(fields[0], (int(fields[11]) + int(fields[12])) / TICKS_PER_S)


def cpu_s(pid: int) -> float:
    """Return the CPU time of a process so far, user and system, all threads [s]; 0 when gone."""
    return usage(pid).cpu_s


def is_alive(pid: int) -> bool:
    """Say whether a process is there and has not ended."""
    return usage(pid).state not in (GONE, *DEAD)
