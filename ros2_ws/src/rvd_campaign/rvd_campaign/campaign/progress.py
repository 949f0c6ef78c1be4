"""
The line that says how far a campaign is.
"""

import sys
import time
from typing import TextIO

SHOW_S = 0.2                            # [s] between two looks at a terminal
LOG_S = 10.0                            # [s] between two lines in a log


class Progress:
    """Counts runs and says rate and time left, on a terminal in one line."""

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream or sys.stdout
        self._live = self._stream.isatty()
        self._begun = self._shown = time.monotonic()
        self._ended: float | None = None
        self._start = self.done = self.total = 0

    @property
    def flown(self) -> int:
        """Runs of this session."""
        return self.done - self._start

    @property
    def elapsed_s(self) -> float:
        """Wall time of this session, until `end`: what comes after is no flying."""
        return (self._ended or time.monotonic()) - self._begun

    def begin(self, done: int, total: int) -> None:
        """Begin with so many runs finished before."""
        self._start, self.done, self.total = done, done, total
        self._begun = time.monotonic()
        if done:
            print(f'{done:,} of {total:,} runs are there already', file=self._stream, flush=True)

    def add(self, runs: int) -> None:
        """Count finished runs."""
        self.done += runs
        now = time.monotonic()
        if now - self._shown >= (SHOW_S if self._live else LOG_S):
            self._shown = now
            text = f'\r\x1b[K{self.line()}' if self._live else f'{self.line()}\n'
            self._stream.write(text)
            self._stream.flush()

    def say(self, sentence: str) -> None:
        """Say something else that happened."""
        self._stream.write(('\r\x1b[K' if self._live else '') + f'{sentence}\n')
        self._stream.flush()

    def line(self) -> str:
        """Return how far it is."""
        rate = self.flown / max(self.elapsed_s, 1e-9)
        left = clock((self.total - self.done) / rate) if rate > 0 else 'unknown'
        return (f'{self.done:,} of {self.total:,} runs ({100*self.done/self.total:.0f} %), '
                f'{rate:,.0f} runs/s, {left} left')

    def end(self) -> None:
        """Leave the line, and stop the clock."""
        self._ended = time.monotonic()
        if self._live and self.flown:
            self._stream.write('\r\x1b[K')
            self._stream.flush()


def clock(seconds: float) -> str:
    """Return a time as people say it: 12 s, 3 min 05 s, 2 h 10 min."""
    whole = round(seconds)
    if whole < 60:
        return f'{whole} s'
    if whole < 3600:
        return f'{whole // 60} min {whole % 60:02d} s'
    return f'{whole // 3600} h {whole % 3600 // 60:02d} min'
