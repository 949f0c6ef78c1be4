"""
A line of its own from the judge to whoever started the run: a pipe, not a topic.

Anybody may write on a topic, and a message does not say who has written it. A pipe is open to the
processes of the run alone. It takes the final verdict, some kilobytes, even while nobody reads, and
needs no room on a disk. Before it come the second writers that the monitor has seen.
"""

import contextlib
import os
import stat
from typing import NamedTuple

VARIABLE = 'RVD_VERDICT_LINE'           # environment: descriptor of the writing end
VERDICT, STRANGER = b'V', b'S'          # kinds of messages: a serialised Verdict, a sentence
_HEAD = 5                               # [bytes] kind, and length of what follows, least byte first


class Message(NamedTuple):
    """What was told."""

    kind: bytes
    content: bytes


def tell(kind: bytes, content: bytes) -> None:
    """Write a message into the line that this process was started with, if it was with one."""
    given = os.environ.get(VARIABLE, '')
    if not given.isdecimal():
        return
    message = memoryview(kind + len(content).to_bytes(_HEAD - 1, 'little') + content)
    with contextlib.suppress(OSError):          # nobody reads any more
        if stat.S_ISFIFO(os.fstat(int(given)).st_mode):
            while message:
                message = message[os.write(int(given), message):]


class VerdictLine:
    """The reading end, and until the processes have started the writing end, too."""

    def __init__(self) -> None:
        self._reads, self.writes = os.pipe()
        for end in (self._reads, self.writes):
            os.set_blocking(end, False)         # neither waits for the other
        self._coming = b''
        self._heard: list[Message] = []

    def handed_over(self) -> None:
        """Close the writing end here: who was started has it."""
        os.close(self.writes)

    def heard(self) -> list[Message]:
        """Return the messages that are here whole, in order."""
        with contextlib.suppress(BlockingIOError):
            while self._reads >= 0 and (part := os.read(self._reads, 65536)):
                self._coming += part
        while len(self._coming) >= _HEAD:
            end = _HEAD + int.from_bytes(self._coming[1:_HEAD], 'little')
            if len(self._coming) < end:
                break
            self._heard.append(Message(self._coming[:1], self._coming[_HEAD:end]))
            self._coming = self._coming[end:]
        return self._heard

    def close(self) -> None:
        """Close the reading end; what has come stays known."""
        self.heard()
        if self._reads >= 0:
            os.close(self._reads)
            self._reads = -1
