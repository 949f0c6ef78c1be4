"""
Shared memory that processes of Fast DDS have left when they were killed: removed at the next start.

A process makes `fastrtps_UUID`, half a megabyte, and holds a lock on `fastrtps_UUID_el` for as long
as it lives. `fastrtps_portN` with `sem.fastrtps_portN_mutex` is a port of a domain, whose reader
holds a lock on `..._el` or `..._sl`; a writer that comes after the reader has gone makes it anew,
without a lock. So what is locked is in use, a port without a lock is not if nobody is in its
domain, and none of another user is ours.

Source  Fast DDS 2.14, src/cpp/rtps/transport/shared_mem, and its own tool `fastdds shm clean`.
"""

from collections import defaultdict
import contextlib
import fcntl
import os
from pathlib import Path
import re
import stat
import time
from typing import NamedTuple

from rvd_campaign.flight.domain import Domain, domain_of_port, nobody_in

FOLDER = Path('/dev/shm')
SEGMENT = re.compile(r'fastrtps_[0-9a-f]{16}')
PORT = re.compile(r'fastrtps_port(\d{1,5})')
LOCKS = ('_el', '_sl')
SETTLED_S = 10.0                # [s] age from which a file is not just being made
MANY = 100                      # files that are worth a line


class Removed(NamedTuple):
    """What was removed."""

    files: int
    size: int                   # [bytes]

    def in_words(self) -> str:
        """Return one line; empty if it is not worth one."""
        if self.files < MANY:
            return ''
        return (f'{self.files} files of shared memory ({self.size/1e6:.0f} MB) that dead processes '
                f'had left in {FOLDER} are removed')


def remove(own: Domain, folder: Path = FOLDER) -> Removed:
    """Remove what dead processes of this user have left; `own` is the domain that is held."""
    try:
        names = set(os.listdir(folder))
    except OSError:
        return Removed(0, 0)
    sizes: list[int] = []
    ports: defaultdict[int, list[str]] = defaultdict(list)
    for name in sorted(names):
        if SEGMENT.fullmatch(name.removesuffix(LOCKS[0])) and name.endswith(LOCKS[0]):
            _remove(folder, [name, name.removesuffix(LOCKS[0])], sizes)
        elif SEGMENT.fullmatch(name) and name + LOCKS[0] not in names:
            _remove(folder, [name], sizes)
        elif port := PORT.fullmatch(name):
            ports[domain_of_port(int(port[1]))].append(name)
    for number, of_it in ports.items():
        with nobody_in(number, own) as free:
            for name in of_it if free else ():
                _remove(folder, [*(name + lock for lock in LOCKS), name, f'sem.{name}_mutex'],
                        sizes)
    return Removed(len(sizes), sum(sizes))


def _remove(folder: Path, names: list[str], sizes: list[int]) -> None:
    """Remove files that belong together, if they are ours, settled, and nobody holds a lock."""
    found: dict[Path, os.stat_result] = {}
    for name in names:
        with contextlib.suppress(FileNotFoundError):
            found[folder / name] = (folder / name).lstat()
    newest_s = time.time() - SETTLED_S
    if not all(stat.S_ISREG(f.st_mode) and f.st_uid == os.getuid() and f.st_ctime < newest_s
               for f in found.values()):
        return
    with contextlib.ExitStack() as held:
        for path in found:
            if path.name.endswith(LOCKS) and not _locked(path, held):
                return
        for path, about in found.items():
            with contextlib.suppress(OSError):
                path.unlink()
                sizes.append(about.st_size)


def _locked(path: Path, held: contextlib.ExitStack) -> bool:
    """Lock a file, until `held` is closed; say whether nobody else has it."""
    try:
        file = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError:
        return False
    held.callback(os.close, file)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
