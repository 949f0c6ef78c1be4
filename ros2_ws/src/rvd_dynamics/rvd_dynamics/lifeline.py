"""
A node does not outlive what has started it, and does not stay when it has ended.

A child that nobody waits for any more would fly on, for hours. The kernel tells it: Linux sends
a process the signal of its choice when its parent dies (`prctl(2)`, PR_SET_PDEATHSIG).
"""

import ctypes
import faulthandler
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager

PARENT = 'RVD_PARENT'           # environment: process id of who has started this one
LEAVE_S = 5.0                   # [s] wall time to leave the graph: it takes milliseconds
PR_SET_PDEATHSIG = 1

_libc = ctypes.CDLL(None)


def die_with_parent(number: int = signal.SIGKILL) -> None:
    """Let the kernel send this process a signal when its parent dies; nothing elsewhere."""
    if sys.platform == 'linux':
        _libc.prctl(PR_SET_PDEATHSIG, number, 0, 0, 0)


def hold() -> None:
    """
    End with the process that `RVD_PARENT` names, if it names one.

    The bring-up ends its nodes in order, whatever ends it; only where it cannot, because it was
    itself killed, nodes are: the bag is written to stand that (at most two steps are lost).
    """
    parent = os.environ.get(PARENT)
    if parent:
        die_with_parent()
        if str(os.getppid()) != parent:         # gone before the kernel was asked
            sys.exit(f'{os.path.basename(sys.argv[0])}: process {parent}, which started this one, '
                     'has gone')


@contextmanager
def leaving(seconds: float = LEAVE_S) -> Iterator[None]:
    """
    End this process by force, with code 1, if what is done meanwhile is not done in time.

    Of some hundred processes that leave it at one time, one hangs in Fast DDS 2.14: a thread that
    takes notice of another participant's end waits for a lock that the deletion of this one holds,
    and the reverse. The watchdog is a thread outside Python, since that call holds up all of
    Python; it writes where the process was.
    """
    faulthandler.dump_traceback_later(seconds, exit=True, file=sys.__stderr__)
    try:
        yield
    finally:
        faulthandler.cancel_dump_traceback_later()
