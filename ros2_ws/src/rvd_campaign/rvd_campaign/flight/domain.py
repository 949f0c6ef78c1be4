"""
A DDS domain id for each run, so that runs side by side do not hear each other.

A run holds its id by a lock on a file in a folder that only its user can write to; the file says
who holds it. Other users have folders of their own: an id is only chosen where nobody on this
machine uses its ports, and two runs that meet all the same tell each other apart (see
`rvd_dynamics.diagram.identity`).
"""

from collections.abc import Iterator
from contextlib import contextmanager, suppress
import fcntl
import json
import os
from pathlib import Path
import random
import stat
import tempfile
import time

from rvd_campaign.exits import CannotRun
from rvd_dynamics.diagram.identity import LARGEST_DOMAIN
from rvd_dynamics.given import json_in

# Above 101 the ports of a domain reach into the range that Linux gives to outgoing connections.
IDS = range(1, 102)
FIRST_PORT, PORTS = 7400, 250           # UDP ports of domain 0, and how many each domain has
MOST_SAID = 64 << 10                    # [B] of what a lock says: a process and a run folder
SOCKETS = Path('/proc/net/udp')


class Domain(int):
    """A DDS domain id that is held."""

    file: int                               # descriptor of the lock

    def held_for(self, what: str) -> None:
        """Say what holds it, a run folder: told to whoever asks for the same id."""
        text = json.dumps({'pid': os.getpid(), 'what': what,
                           'since': time.strftime('%Y-%m-%d %H:%M:%S')})
        with suppress(OSError):                 # a full disk: it is held all the same
            os.ftruncate(self.file, 0)
            os.pwrite(self.file, text.encode(), 0)


@contextmanager
def reserved_domain() -> Iterator[Domain]:
    """
    Hold the user's own `ROS_DOMAIN_ID`, or one that no other run of this machine holds.

    Raises
    ------
    CannotRun
        If `ROS_DOMAIN_ID` is no whole number from 0 to 232 or another run of this user holds it,
        if every id is taken, or if there is no folder of the user's own for the locks.
    """
    given, folder = asked_for(), _folder()
    busy = _busy() if given is None else set()
    ids = random.SystemRandom().sample(IDS, len(IDS)) if given is None else [given]
    domain = next((found for i in ids if i not in busy
                   and (found := _locked(folder, i)) is not None), None)
    if domain is None and given is not None:
        raise CannotRun(f'ROS_DOMAIN_ID={given} is held by another run'
                        f'{_who_holds(folder / str(given))}: unset ROS_DOMAIN_ID to get a free '
                        'one, or give another')
    if domain is None:
        raise CannotRun('every DDS domain id from 1 to 101 is in use on this machine: end other '
                        'runs, or set ROS_DOMAIN_ID')
    try:
        yield domain
    finally:
        os.close(domain.file)


def domain_of_port(port: int) -> int:
    """Return the domain id to which a port belongs; it need not be a possible one."""
    return (port - FIRST_PORT) // PORTS


@contextmanager
def nobody_in(number: int, own: Domain) -> Iterator[bool]:
    """
    Say whether nobody on this machine is in a domain; meanwhile no run of this user comes there.

    In the `own` one, which is held, none of ours is yet.
    """
    domain = None
    if 0 <= number <= LARGEST_DOMAIN and number not in _busy():
        if number == own:
            yield True
            return
        with suppress(CannotRun):
            domain = _locked(_folder(), number)
    try:
        yield domain is not None
    finally:
        if domain is not None:
            os.close(domain.file)


def asked_for() -> int | None:
    """Return the user's own `ROS_DOMAIN_ID`, None if there is none; CannotRun if it is wrong."""
    given = os.environ.get('ROS_DOMAIN_ID', '')
    if not given:
        return None
    if not (given.isascii() and given.isdecimal() and len(given) < 10
            and int(given) <= LARGEST_DOMAIN):
        raise CannotRun(
            f'ROS_DOMAIN_ID must be a whole number from 0 to {LARGEST_DOMAIN}, got {given!r}')
    return int(given)


def _folder() -> Path:
    """Return the folder of the locks, which nobody else can write to."""
    runtime = os.environ.get('XDG_RUNTIME_DIR', '')
    if runtime and _is_ours(Path(runtime)):
        folder = Path(runtime) / 'rvd-domains'
    else:
        folder = Path(tempfile.gettempdir()) / f'rvd-domains-{os.getuid()}'
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
    except OSError as error:
        if not isinstance(error, FileExistsError):
            raise CannotRun(f'cannot make {folder}, where runs lock their ROS_DOMAIN_ID: '
                            f'{error.strerror}') from None
    if not _is_ours(folder):
        raise CannotRun(f'{folder} must be a folder of your own that nobody else can write to, '
                        'since runs lock their ROS_DOMAIN_ID there: remove it, or set '
                        'XDG_RUNTIME_DIR to a folder of your own with mode 700')
    return folder


def _is_ours(folder: Path) -> bool:
    try:
        return _nobody_else_writes(folder.lstat())      # a link may lead anywhere
    except OSError:
        return False


def _nobody_else_writes(folder: os.stat_result) -> bool:
    writable = folder.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return stat.S_ISDIR(folder.st_mode) and folder.st_uid == os.getuid() and not writable


def _opened(folder: Path, name: str, flags: int) -> int:
    """
    Open a file in the folder of the locks; return its descriptor.

    The folder is checked again where it is opened, and the file before it is used: a link is not
    followed, and what has a second name (a hard link) or another owner is somebody else's file,
    put there when the folder could be written to.

    Raises
    ------
    OSError
        If it cannot be opened.
    CannotRun
        If it is not the user's own.
    """
    place = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    try:
        if not _nobody_else_writes(os.fstat(place)):
            raise CannotRun(f'{folder} must be a folder of your own: remove it')
        file = os.open(name, flags | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, 0o600,
                       dir_fd=place)
    finally:
        os.close(place)
    found = os.fstat(file)
    if not (stat.S_ISREG(found.st_mode) and found.st_uid == os.getuid() and found.st_nlink == 1):
        os.close(file)
        raise CannotRun(f'cannot lock {folder / name}: it is no file of your own alone: remove it')
    return file


def _locked(folder: Path, number: int) -> Domain | None:
    """Lock the file of a domain id; return the id, None if another process has locked it."""
    path, domain = folder / str(number), Domain(number)
    domain.file = -1
    try:
        domain.file = _opened(folder, str(number), os.O_RDWR | os.O_CREAT)
        fcntl.flock(domain.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        domain.held_for('')
    except OSError as error:
        if domain.file >= 0:
            os.close(domain.file)
        if isinstance(error, BlockingIOError):
            return None
        raise CannotRun(f'cannot lock {path}: {error.strerror}') from None
    return domain


def _who_holds(path: Path) -> str:
    """Return in words who has locked a file; empty if it does not say."""
    try:
        file = _opened(path.parent, path.name, os.O_RDONLY)
        try:
            said = json_in(os.read(file, MOST_SAID).decode(), str(path))
        finally:
            os.close(file)
        what = f', {said["what"]}' if said['what'] else ''
        return f' (process {said["pid"]}{what}, since {said["since"]})'
    except (OSError, CannotRun, ValueError, TypeError, KeyError):   # it is just being written
        return ''


def _busy() -> set[int]:
    """Return the domains of which somebody on this machine, whoever it is, uses a UDP port."""
    try:
        lines = SOCKETS.read_text(encoding='ascii').splitlines()[1:]
    except OSError:
        return set()
    ports = [int(line.split()[1].rpartition(':')[2], 16) for line in lines]
    return {domain_of_port(port) for port in ports}
