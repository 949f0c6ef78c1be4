"""
Limits for a case: wall time in this process, or time and memory in a child.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
import os
import pickle
import resource
import select
import signal
import threading
import time
import traceback
from typing import Any


class Hung(BaseException):
    """A case that took too long, and where it was; nothing that catches an `Exception` holds it."""


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raise `Hung` in what takes longer than `seconds` of wall time; in the main thread alone."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def ring(_: int, frame: Any) -> None:
        where = traceback.extract_stack(frame)[-1]
        raise Hung(f'no end in {seconds:g} s, in {os.path.basename(where.filename)}:{where.lineno}')
    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def in_child(work: Callable[[], Any], seconds: float, extra_bytes: int) -> Any:
    """
    Return what `work()` returns, done in a child of this process with limits of its own.

    The child may take `extra_bytes` of address space beside what this process has.

    Raises
    ------
    Hung
        If it does not end in `seconds` of wall time.
    RuntimeError
        If it ends without an answer, or `work` raises: the text says how.
    """
    mine, its = os.pipe()
    child = os.fork()
    if child == 0:
        _be_the_child(work, its, extra_bytes)
    os.close(its)
    answer, deadline, over = b'', time.monotonic() + seconds, False
    try:
        while not over:
            ready, _, _ = select.select([mine], [], [], max(deadline - time.monotonic(), 0.0))
            if not ready:
                raise Hung(f'no end in {seconds:g} s')
            part = os.read(mine, 1 << 20)
            answer += part
            over = not part
    finally:
        os.close(mine)
        if not over:                            # it is ours until it is waited for
            os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
    if not answer:
        raise RuntimeError(f'ended by signal {os.WTERMSIG(status)}' if os.WIFSIGNALED(status)
                           else f'ended with code {os.waitstatus_to_exitcode(status)}')
    well, made = pickle.loads(answer)
    if not well:
        raise RuntimeError(made)
    return made


def _be_the_child(work: Callable[[], Any], out: int, extra_bytes: int) -> None:
    code = 1
    try:
        now = int(open('/proc/self/statm', encoding='ascii').read().split()[0]) * os.sysconf(
            'SC_PAGE_SIZE')
        resource.setrlimit(resource.RLIMIT_AS, (now + extra_bytes,) * 2)
        try:
            answer = pickle.dumps((True, work()))
        except Exception as error:              # noqa: B902 - told to the parent
            place = traceback.extract_tb(error.__traceback__)[-1]
            answer = pickle.dumps((False, f'{type(error).__name__}: {error} at '
                                          f'{os.path.basename(place.filename)}:{place.lineno}'))
        while answer:
            answer = answer[os.write(out, answer):]
        code = 0
    finally:
        os._exit(code)
