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
        with part.open(mode, **opening) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    _sync_folder(path.parent)


def write_text(path: Path, text: str) -> None:
    """Write a text file, UTF-8; errors as `draft`."""
    with draft(path, 'w', encoding='utf-8') as file:
        file.write(text)


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
