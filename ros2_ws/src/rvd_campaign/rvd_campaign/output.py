"""
Standard output and error that never stop the work: a closed pipe or a full disk ends the writing.
"""

import os
import sys
from io import TextIOWrapper
from typing import Any, TextIO


class Unbroken:
    """A text stream that is silent from the first text on that cannot be written."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write `text` if it can be written."""
        try:
            return self._stream.write(text)
        except OSError as error:
            self._fall_silent(error)
            return len(text)

    def flush(self) -> None:
        """Write what waits if it can be written."""
        try:
            self._stream.flush()
        except OSError as error:
            self._fall_silent(error)

    def _fall_silent(self, error: OSError) -> None:
        """Send the rest nowhere; what is waiting in the buffers, too."""
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, self._stream.fileno())
        os.close(nowhere)
        if not isinstance(error, BrokenPipeError) and self._stream is not sys.__stderr__:
            print(f'rvd: output cannot be written: {error.strerror}', file=sys.stderr)


def keep_going() -> None:
    """Let neither a closed pipe nor a full disk at the other end of the output stop the work."""
    for name in ('stdout', 'stderr'):
        stream = getattr(sys, name)
        if isinstance(stream, Unbroken):
            continue
        if stream is not None:                  # else closed by the shell (`>&-`)
            if isinstance(stream, TextIOWrapper):
                stream.reconfigure(errors='backslashreplace')   # what the terminal cannot show
            setattr(sys, name, Unbroken(stream))
        else:
            setattr(sys, name, open(os.devnull, 'w', encoding='utf-8'))
