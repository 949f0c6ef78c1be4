"""
A node does not outlive what has started it, and does not stay when it has ended.

A child that nobody waits for any more would fly on, for hours. The kernel tells it: Linux sends
a process the signal of its choice when its parent dies (`prctl(2)`, PR_SET_PDEATHSIG). A parent
that is itself stopped does not act on that; its children then see that the pipe is cut at whose
other end the run was started, and let it go on, or end it.
"""

import ctypes
import faulthandler
import os
import select
import signal
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager

PARENT = 'RVD_PARENT'           # environment: process id of who has started this one
LINE = 'RVD_LINE'               # environment: descriptor of a pipe from who has started the run
PATIENCE_S = 3.5                # [s] wall time for the bring-up to end the run after that was cut
LEAVE_S = 5.0                   # [s] wall time to leave the graph: it takes milliseconds
WRITE_S = 0.5                   # [s] more, to write where it hangs
PR_SET_PDEATHSIG = 1
SIGEV_THREAD = 2
CLOCK_MONOTONIC = 1

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


class _Line:
    """The pipe from who has started the run; it brings nothing, and ends with that process."""

    def __init__(self) -> None:
        self._cut_at: float | None = None
        self._poll = select.poll()
        self._held = False
        try:
            file = int(os.environ.get(LINE, ''))
            self._held = stat.S_ISFIFO(os.fstat(file).st_mode)
            self._poll.register(file, 0)        # POLLHUP is told without being asked for
        except (ValueError, OverflowError, OSError):    # none: a node started by hand
            pass

    def look(self, now: float) -> None:
        """End the run by its bring-up if who has started it has gone."""
        if not self._held or not any(event & select.POLLHUP for _, event in self._poll.poll(0)):
            return
        parent = os.getppid()
        if str(parent) != os.environ.get(PARENT):
            return                              # it has gone, too: the kernel ends this process
        self._cut_at = self._cut_at or now
        late = now - self._cut_at > PATIENCE_S
        try:                                    # it has been told; a stopped one has not heard it
            os.kill(parent, signal.SIGKILL if late else signal.SIGCONT)
        except OSError:
            pass


_line: _Line | None = None


def look(now: float) -> None:
    """
    See whether whoever has started this run is still there; every node calls it now and then.

    `now` is an instant of `time.monotonic` [s].

    The bring-up gets a signal when `fly` dies, but cannot act on it while it is stopped itself.
    """
    global _line
    if _line is None:
        _line = _Line()
    _line.look(now)


class _Event(ctypes.Structure):
    """`struct sigevent` of Linux: call a function in a thread of its own."""

    _fields_ = [('value', ctypes.c_void_p), ('signal', ctypes.c_int), ('notify', ctypes.c_int),
                ('function', ctypes.c_void_p), ('attributes', ctypes.c_void_p),
                ('rest', ctypes.c_char * 32)]


class _Times(ctypes.Structure):
    """`struct itimerspec`: when, and not again."""

    _fields_ = [('again_s', ctypes.c_long), ('again_ns', ctypes.c_long),
                ('s', ctypes.c_long), ('ns', ctypes.c_long)]


@contextmanager
def _exit_after(seconds: float, code: int) -> Iterator[None]:
    """End the process with `code` in a thread of the C library, though Python stands still."""
    library = _libc if hasattr(_libc, 'timer_create') else ctypes.CDLL('librt.so.1')
    event = _Event(value=code, notify=SIGEV_THREAD,
                   function=ctypes.cast(_libc._exit, ctypes.c_void_p))
    timer, whole = ctypes.c_void_p(), int(seconds)
    armed = library.timer_create(CLOCK_MONOTONIC, ctypes.byref(event),
                                 ctypes.byref(timer)) == 0
    if armed:
        library.timer_settime(timer, 0, ctypes.byref(
            _Times(s=whole, ns=int((seconds - whole) * 1e9))), None)
    try:
        yield
    finally:
        if armed:
            library.timer_delete(timer)


def _code_on_the_way() -> int:
    """Return the exit code that the exception at hand leads to; 0 without one."""
    error = sys.exc_info()[1]
    if isinstance(error, SystemExit):
        return error.code if isinstance(error.code, int) else int(error.code is not None)
    return int(error is not None)


@contextmanager
def leaving(seconds: float = LEAVE_S) -> Iterator[None]:
    """
    End this process by force if what is done meanwhile is not done in time.

    Of some hundred processes that leave it at one time, one hangs in Fast DDS 2.14: a thread that
    takes notice of another participant's end waits for a lock that the deletion of this one holds,
    and the reverse. The node has done its work by then, so the exit code is the one it was to
    have: 0, or that of the exception on its way. The watchdogs are threads outside Python, since
    that call holds up all of Python; the first writes where the process was.
    """
    faulthandler.dump_traceback_later(seconds, file=sys.__stderr__)
    try:
        with _exit_after(seconds + WRITE_S, _code_on_the_way()):
            yield
    finally:
        faulthandler.cancel_dump_traceback_later()
