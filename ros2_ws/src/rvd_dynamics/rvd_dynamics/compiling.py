"""
Whether this process compiles a loop, told to who follows it; without numba, which takes a second.

A loop is compiled once for a machine (`compiled`), for up to a minute, while the process gives no
other sign of life.
"""

from collections.abc import Callable

_follower: Callable[[bool], None] | None = None
_depth = 0                              # of loops that are being compiled: one may need another


def follow(follower: Callable[[bool], None] | None) -> None:
    """From now on tell `follower` alone when this process compiles: True, then False."""
    global _follower
    _follower = follower


def begin() -> None:
    """Be told that a loop is going to be compiled."""
    _change(1)


def end() -> None:
    """Be told that a loop has been compiled."""
    _change(-1)


def _change(by: int) -> None:
    global _depth
    _depth += by
    if _follower is not None and _depth == max(by, 0):      # the first begins, the last has ended
        _follower(by > 0)
