"""
Files that are there whole or not at all, whatever ends the process or fills the disk.

The content goes into a draft beside the file, `NAME.draft`, and is brought to the disk; then the
draft takes the file's place in one step. Until then a file that was there before stays as it is.
"""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, IO

from rvd_dynamics.bad_input import BadInput


@contextmanager
def draft(path: Path, mode: str = 'wb', **opening: Any) -> Iterator[IO]:
    """
    Open a draft for writing, which becomes the file `path` at the end of the block.

    Parameters
    ----------
    path : Path
        The file that is to be written; its folder exists.
    mode, **opening
        As `open` takes them.

    Raises
    ------
    OSError
        If the disk does not take it. After this or any other error the draft is removed.
    """
    part = path.with_name(f'{path.name}.draft')
    try:
        part.unlink(missing_ok=True)            # of a process that was killed, or a planted link
        with open(part, mode, opener=_new, **opening) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    _sync_folder(path.parent)


def _new(path: str, flags: int) -> int:
    """Open a file that is not there yet: what somebody has put in its place is not written to."""
    return os.open(path, flags | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC, 0o666)


def write_text(path: Path, text: str) -> None:
    """Write a text file, UTF-8; errors as `draft`."""
    with draft(path, 'w', encoding='utf-8') as file:
        file.write(text)


def save(path: Path, text: str) -> Path:
    """Write a text file for a user, and return where it is; BadInput if it cannot be written."""
    try:
        write_text(path, text)
    except OSError as error:
        raise BadInput(f'cannot write {path}: {error.strerror or error}') from None
    return path


def write_new(path: Path, text: str) -> None:
    """
    Write a text file that must not be there yet, UTF-8; errors as `draft`.

    Raises
    ------
    FileExistsError
        If somebody has just made it: of two who want it one gets it.
    """
    os.close(_new(str(path), os.O_WRONLY | os.O_CREAT))     # the name is ours from here on
    try:
        write_text(path, text)
    except BaseException:
        path.unlink(missing_ok=True)
        raise


def _sync_folder(folder: Path) -> None:
    """Make renames in a folder last through a power cut, where the file system can."""
    try:
        handle = os.open(folder, os.O_RDONLY)
    except OSError:
        return
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno not in (errno.EINVAL, errno.EBADF):
            raise
    finally:
        os.close(handle)
