"""
How loops are compiled: by numba, once for a machine.

Import it, and the modules that use it, where they are needed: numba takes a second. A function is
kept beside its source, or in the user's cache; where neither can be written, it is compiled once a
process. Keep functions that call each other in one file: numba looks at that file alone to see
whether what it kept is still good.
"""

from collections.abc import Callable

from numba import njit


def compiled(function: Callable) -> Callable:
    """Compile a function; a division by zero gives what numpy gives."""
    try:
        return njit(cache=True, error_model='numpy')(function)
    except RuntimeError:                # "no locator available": read-only everywhere
        return njit(error_model='numpy')(function)
