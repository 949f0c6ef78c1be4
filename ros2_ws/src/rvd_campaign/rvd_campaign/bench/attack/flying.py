"""
Real flights for the attacks: `fly` as a process, and all that it has started, found by a mark.

Every process of a flight inherits a variable of the environment that no other process has, so that
what is left of a flight is found whatever session, group or parent it has.
"""

from collections.abc import Callable
from contextlib import suppress
import os
from pathlib import Path
import shutil
import signal
import subprocess
import sys
import time
import uuid

from mcap.records import Channel, Message

from rvd_campaign import catalogue
from rvd_dynamics.recording import mcap_records

MARK = 'RVD_BENCH_ATTACK'
LOOK_S = 0.1                    # [s] wall time between two looks
STEPS = 5                       # in the bag: it flies
GONE_S = 5.0                    # [s] wall time in which all has ended after `fly`


class Flying:
    """A flight under way in a new folder; use it as a context: what is left of it is ended."""

    def __init__(self, folder: Path, *arguments: str, domain: int | None = None) -> None:
        self.folder, self.run = folder, folder / 'run'
        self._mark = f'{MARK}={uuid.uuid4().hex}'
        folder.mkdir(parents=True, exist_ok=True)
        environment = {k: v for k, v in os.environ.items() if k != 'ROS_DOMAIN_ID'}
        if domain is not None:
            environment['ROS_DOMAIN_ID'] = str(domain)
        name, value = self._mark.split('=')
        self.begun = time.monotonic()
        with (folder / 'out').open('w') as out:
            self.process = subprocess.Popen(
                [sys.executable, '-m', 'rvd_campaign.cli', 'fly', *arguments, '--headless',
                 '--out', str(self.run)], cwd=folder, stdout=out, stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL, start_new_session=True,
                env={**environment, 'RVD_ROOT': str(catalogue.root()), name: value})

    def __enter__(self) -> 'Flying':
        return self

    def __exit__(self, *_: object) -> None:
        for pid in self.pids():
            send(pid, signal.SIGKILL)
        self.process.wait()

    def pids(self) -> dict[int, list[str]]:
        """Return the living processes of the flight with their command lines."""
        found = {}
        for folder in Path('/proc').glob('[0-9]*'):
            try:
                if self._mark.encode() not in (folder / 'environ').read_bytes().split(b'\0'):
                    continue
                state = (folder / 'stat').read_text().rsplit(')', 1)[1].split()[0]
                words = (folder / 'cmdline').read_bytes().decode(errors='replace').split('\0')
            except OSError:                     # ended meanwhile, or somebody else's
                continue
            if state not in 'ZX':
                found[int(folder.name)] = words
        return found

    def said(self) -> str:
        """Return what `fly` has said so far."""
        return (self.folder / 'out').read_text(errors='replace')

    def logs(self) -> dict[str, str]:
        """Return the logs of the processes by their names."""
        return {file.stem: file.read_text(errors='replace')
                for file in sorted((self.run / 'logs').glob('*.log'))}

    def wait(self, seconds: float) -> int | None:
        """Return the exit code of `fly`; None if it does not end in time."""
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None

    def until(self, look: Callable[[], object], seconds: float) -> object:
        """Return what `look` finds in time while `fly` is there, else None."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline and self.process.poll() is None:
            found = look()
            if found:
                return found
            time.sleep(LOOK_S)
        return None

    def flies(self) -> bool:
        """Say whether steps have been recorded, so that all of the graph flies."""
        for file in (self.run / 'bag').glob('*.mcap*'):
            with suppress(OSError, ValueError):         # as far as it has been written
                clocks, seen = set(), 0
                for record in mcap_records.records(file):
                    if isinstance(record, Channel) and record.topic == '/clock':
                        clocks.add(record.id)
                    elif isinstance(record, Message) and record.channel_id in clocks:
                        seen += 1
                        if seen >= STEPS:
                            return True
        return False

    def orphans(self) -> list[str]:
        """Return what has not ended some seconds after `fly`."""
        deadline = time.monotonic() + GONE_S
        while (left := self.pids()) and time.monotonic() < deadline:
            time.sleep(LOOK_S)
        return [f'{pid} {" ".join([Path(words[0]).name, *words[1:]])[:80]}'
                for pid, words in left.items()]

    def kept(self, where: Path) -> Path:
        """Copy the folder of a failure to `where`, or beside it; return its place."""
        number, place = 1, where
        while place.exists():
            number, place = number + 1, where.with_name(f'{where.name}-{number}')
        shutil.copytree(self.folder, place, symlinks=True)
        return place


def send(pid: int, number: int) -> bool:
    """Send a signal; say whether the process was there."""
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        return False
    return True
