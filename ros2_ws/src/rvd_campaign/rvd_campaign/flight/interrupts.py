"""
What ends a command in order: Ctrl-C, and with it a closed terminal and a polite kill.
"""

import signal
from contextlib import contextmanager
from typing import Any, Iterator


def all_like_ctrl_c() -> None:
    """Let SIGTERM and SIGHUP interrupt as SIGINT does, unless they are ignored (`nohup`)."""
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        if number == signal.SIGINT or signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _interrupt)


def _interrupt(*_: Any) -> None:
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
