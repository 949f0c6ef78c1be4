"""
What ends a command in order: Ctrl-C, and with it a closed terminal and a polite kill.
"""

import signal
from contextlib import contextmanager
from typing import Any, Iterator


_came: list[int] = []                           # the signals that have interrupted this command


@contextmanager
def ctrl_c_heard() -> Iterator[None]:
    """
    Hear Ctrl-C, also one that came while Python started.

    The script `rvd` blocks it until then, since Python would tell it as a traceback.
    """
    _came.clear()
    before = signal.getsignal(signal.SIGINT)
    if before == signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)
    try:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def has_come() -> bool:
    """
    Say whether this command was interrupted.

    What it did then may have ended in another error: numpy, interrupted while it is imported,
    raises ImportError.
    """
    return bool(_came)


def all_like_ctrl_c() -> None:
    """Let SIGTERM and SIGHUP interrupt as SIGINT does, unless they are ignored (`nohup`)."""
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        if number == signal.SIGINT or signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _interrupt)


def _interrupt(number: int, _: Any) -> None:
    _came.append(number)
    raise KeyboardInterrupt


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Ignore a second Ctrl-C, which would cut short what the first one has begun."""
    numbers = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
    before = [signal.signal(number, signal.SIG_IGN) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before):
            signal.signal(number, handler)
