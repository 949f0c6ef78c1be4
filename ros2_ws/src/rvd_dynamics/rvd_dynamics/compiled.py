"""
How loops are compiled: by numba, once for a machine.

Import it, and the modules that use it, where they are needed: numba takes a second. A function is
kept beside its source, or in the user's cache; where neither can be written, it is compiled once a
process. Keep functions that call each other in one file: numba looks at that file alone to see
whether what it kept is still good.

While one is compiled, who follows this process is told (`compiling`).
"""

from collections.abc import Callable

from numba import njit
from numba.core import event

from rvd_dynamics import compiling


def compiled(function: Callable) -> Callable:
    """Compile a function; a division by zero gives what numpy gives."""
    try:
        return njit(cache=True, error_model='numpy')(function)
    except RuntimeError:                # "no locator available": read-only everywhere
        return njit(error_model='numpy')(function)


class _Told(event.Listener):
    """What numba tells of: a function that was kept is loaded without a word."""

    def on_start(self, _: event.Event) -> None:
        compiling.begin()

    def on_end(self, _: event.Event) -> None:
        compiling.end()


event.register('numba:compile', _Told())
