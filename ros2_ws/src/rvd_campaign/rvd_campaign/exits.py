"""
How a command ends: exit codes, and the error that becomes one line.
"""

from rvd_dynamics.bad_input import one_line

EXIT_DONE = 0                   # for `fly`: docked
EXIT_FAILED = 1                 # flown and failed
EXIT_CANNOT = 2                 # could not run
EXIT_FAULT = 3                  # a fault of this software, with its traceback
EXIT_INTERRUPTED = 130          # Ctrl-C


class CannotRun(Exception):
    """The command cannot do what was asked; the text is the one line that says why."""

    def __str__(self) -> str:
        return one_line(super().__str__())
