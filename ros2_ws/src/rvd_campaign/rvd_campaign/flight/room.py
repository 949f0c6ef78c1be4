"""
Room on the disk for the verdict of a flight, whatever else fills it: a file that gives way to it.

The bag of a run takes what the disk has. What a run is flown for, a few kilobytes of verdict, must
not be what does not fit any more.
"""

from contextlib import suppress
import os
from pathlib import Path

from rvd_campaign.exits import CannotRun

NAME = '.room_for_the_verdict'
LEAST = 16 << 10                # [B] that a bag and the logs need besides, to begin at all
BYTES = 32 << 10                # [B] three times what a verdict.json and its draft take


def keep(run_dir: Path) -> None:
    """
    Take the room in a new run folder.

    Raises
    ------
    CannotRun
        If there is none: then there is none for a flight either.
    """
    path = run_dir / NAME
    try:
        with path.open('xb') as file:
            file.write(os.urandom(BYTES))       # that no file system makes small
            file.flush()
            os.fsync(file.fileno())
    except OSError as error:
        give(run_dir)
        raise CannotRun(f'cannot write into the run folder {run_dir}: {error.strerror}') from None
    disk = os.statvfs(run_dir)
    if disk.f_bavail * disk.f_frsize < LEAST:
        give(run_dir)
        raise CannotRun(f'the disk of {run_dir} is full: make room, a flight needs a few megabytes')


def give(run_dir: Path) -> None:
    """Give the room back; nothing happens where it is not there."""
    with suppress(OSError):
        (run_dir / NAME).unlink()
