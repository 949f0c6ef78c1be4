"""
The tokens of a console, kept for the next one at the same address.

A page that was open when a console ended comes back by itself to the one that is started in its
place, so that has the same tokens: they are kept in a file that only this user can read, until
`KEEP_S` after a console has last used them. A console at a port that was free by chance has new
ones. Where there is no folder of the user's own nothing is kept, and pages say that their token
is wrong.
"""

from contextlib import suppress
import json
import os
from pathlib import Path
import re
import stat
import tempfile
import time
from typing import NamedTuple

from rvd_dynamics.given import json_in
from rvd_groundstation.console.access import new_token

KEEP_S = 12 * 3600.0            # [s] wall time
TOKEN = re.compile(r'[\w-]{22}', re.ASCII)
MOST_BYTES = 1024


class Tokens(NamedTuple):
    """What lets pages in."""

    fly: str
    watch: str

    @classmethod
    def new(cls) -> 'Tokens':
        """Return two that nobody has had before."""
        return cls(new_token(), new_token())


def tokens_of(bind: str, port: int, folder: Path | None = None) -> Tokens:
    """
    Return the tokens of the console before at this address, or new ones, which are then kept.

    `folder` is where, None stands for one of this user's own.
    """
    folder = own_folder() if folder is None else folder
    if port == 0 or folder is None:
        return Tokens.new()
    file = folder / f'{re.sub(r"[^0-9A-Za-z.-]", "_", bind)}-{port}.json'
    tokens = _kept(file) or Tokens.new()
    with suppress(OSError):                     # a full disk: pages will have to be opened anew
        _keep(file, tokens)
    return tokens


def own_folder() -> Path | None:
    """Return a folder that nobody else can read or write to; None if there is none."""
    runtime = os.environ.get('XDG_RUNTIME_DIR', '')
    folder = (Path(runtime) / 'rvd-console' if runtime and _is_ours(Path(runtime))
              else Path(tempfile.gettempdir()) / f'rvd-console-{os.getuid()}')
    with suppress(OSError):
        folder.mkdir(mode=0o700, exist_ok=True)
    return folder if _is_ours(folder) else None


def _is_ours(path: Path) -> bool:
    try:
        about = path.lstat()                    # a link may lead anywhere
    except OSError:
        return False
    return stat.S_ISDIR(about.st_mode) and _private(about)


def _private(about: os.stat_result) -> bool:
    return about.st_uid == os.getuid() and about.st_mode & 0o077 == 0


def _kept(file: Path) -> Tokens | None:
    """Return what a file keeps, None if there is nothing that counts."""
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK)
    except OSError:
        return None
    with os.fdopen(descriptor, 'rb') as opened:
        about = os.fstat(descriptor)
        fresh = 0.0 <= time.time() - about.st_mtime < KEEP_S
        if not (stat.S_ISREG(about.st_mode) and _private(about) and fresh):
            return None
        try:
            said = json_in(opened.read(MOST_BYTES).decode(), file.name)
            made = Tokens(said['fly'], said['watch'])
        except (ValueError, KeyError, TypeError):
            return None
    good = all(isinstance(one, str) and TOKEN.fullmatch(one) for one in made)
    return made if good and made.fly != made.watch else None


def _keep(file: Path, tokens: Tokens) -> None:
    draft = file.with_suffix(f'.{os.getpid()}')
    with suppress(FileNotFoundError):
        draft.unlink()
    descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    with os.fdopen(descriptor, 'w') as opened:
        json.dump(tokens._asdict(), opened)
    os.replace(draft, file)
