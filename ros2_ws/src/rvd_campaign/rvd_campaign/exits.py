"""
How a command ends: exit codes, and the error that becomes one line.
"""

import os
from pathlib import Path

from rvd_dynamics.bad_input import one_line

EXIT_DONE = 0                   # for `fly`: success
EXIT_FAILED = 1                 # flown and failed
EXIT_CANNOT = 2                 # could not run
EXIT_FAULT = 3                  # a fault of this software, with its traceback
EXIT_INTERRUPTED = 130          # Ctrl-C


class CannotRun(Exception):
    """The command cannot do what was asked; the text is the one line that says why."""

    def __str__(self) -> str:
        return one_line(super().__str__())


def check_file(flag: str, given: str, new: bool = True) -> None:
    """
    Refuse a file that could not be written in the end, before the work for it begins.

    Raises
    ------
    CannotRun
        If it is to be `new` and exists, or if it cannot be written there.
    """
    path = Path(given)
    if new and os.path.lexists(path):
        raise CannotRun(f'{flag} {path} exists already: nothing is overwritten')
    if path.is_dir() or path.exists() and not os.access(path, os.W_OK):
        raise CannotRun(f'{flag} {path} is no file that can be written')
    if not path.parent.is_dir() or not os.access(path.parent, os.W_OK | os.X_OK):
        raise CannotRun(f'{flag} {path}: {path.parent} is no folder that can be written to')
