"""
Workers that somebody has stopped (SIGSTOP, a debugger): ended, so that others fly their runs.

A worker that is stopped keeps its handful of runs for ever, and the campaign would wait for it.
When this process was stopped with them (Ctrl-Z, a paused container) nobody is ended: only the time
counts in which this process ran.

Source  proc(5): the state of a process is the first word after its name in `/proc/PID/stat`.
"""

from contextlib import suppress
import os
from pathlib import Path
import signal
import threading
import time
from typing import Any

STOPPED_S = 5.0                 # [s] wall time for which a worker may stand still
LOOK_S = 0.5                    # [s] wall time between two looks
GAP_S = 2.0                     # [s] between two looks: this process was stopped, too
STOPPED = ('T', 't')            # by a signal, by a debugger
WORKER = b'popen_loky'          # in the command line of a worker


class Standstill:
    """Looks after the workers of this process while a `with` block lasts."""

    def __init__(self) -> None:
        self.ended: list[int] = []              # workers that were stopped and are ended
        self._since: dict[int, float] = {}
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> 'Standstill':
        self._thread.start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._over.set()
        self._thread.join()

    def _watch(self) -> None:
        looked = time.monotonic()
        while not self._over.wait(LOOK_S):
            now = time.monotonic()
            if now - looked > GAP_S:
                self._since.clear()
            looked = now
            stopped = [pid for pid, state in workers().items() if state in STOPPED]
            self._since = {pid: self._since.get(pid, now) for pid in stopped}
            for pid, since in self._since.items():
                if now - since > STOPPED_S and pid not in self.ended:
                    self.ended.append(pid)
                    with suppress(ProcessLookupError):
                        os.kill(pid, signal.SIGKILL)


def workers() -> dict[int, str]:
    """Return the state of each worker process of this process."""
    found, parent = {}, os.getpid()
    for folder in Path('/proc').glob('[0-9]*'):
        with suppress(OSError, ValueError, IndexError):     # it has ended meanwhile
            words = (folder / 'stat').read_text(errors='replace').rpartition(')')[2].split()
            if int(words[1]) == parent and WORKER in (folder / 'cmdline').read_bytes():
                found[int(folder.name)] = words[0]
    return found
