"""
How a command ends: exit codes, and the error that becomes one line.
"""

import errno
import os
from pathlib import Path
import resource
from tempfile import gettempdir, TemporaryFile

from rvd_dynamics.bad_input import one_line

EXIT_DONE = 0                   # for `fly`: success
EXIT_FAILED = 1                 # flown and failed
EXIT_CANNOT = 2                 # could not run
EXIT_FAULT = 3                  # a fault of this software, with its traceback
EXIT_INTERRUPTED = 130          # Ctrl-C

OPEN_FILES = 256                # a process of a flight has about a hundred
# What a disk, or a limit of the user, says to whoever comes: no fault of ours wherever it does.
OF_THE_DISK = (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EFBIG, errno.EMFILE, errno.ENFILE,
               errno.ENAMETOOLONG)


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
    try:
        with TemporaryFile(dir=path.parent):    # root may write to what nobody can write to
            pass
    except OSError as error:
        raise CannotRun(f'{flag} {path}: {path.parent} is no folder that can be written to '
                        f'({error.strerror})') from None


def lacks_temporary(error: Exception) -> bool:
    """Say whether an error is due to a machine without any folder for temporary files."""
    if not isinstance(error, OSError) or 'temporary directory' not in str(error):
        return False
    try:
        gettempdir()
    except FileNotFoundError:
        return True
    return False


def check_open_files() -> None:
    """
    Let this process and its children open enough files.

    Raises
    ------
    CannotRun
        If the limit of the shell or the machine is too low for a flight.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if 0 <= soft < OPEN_FILES:
        if 0 <= hard < OPEN_FILES:
            raise CannotRun(f'only {hard} files may be open at once, {OPEN_FILES} are needed: '
                            'raise the limit (ulimit -n)')
        resource.setrlimit(resource.RLIMIT_NOFILE, (OPEN_FILES, hard))
