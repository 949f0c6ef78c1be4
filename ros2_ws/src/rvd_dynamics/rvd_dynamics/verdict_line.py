"""
A line of its own from the judge to whoever started the run: a pipe, not a topic.

Anybody may write on a topic, and a message does not say who has written it. A pipe is open to the
processes of the run alone. It takes the final verdict, some kilobytes, even while nobody reads, and
needs no room on a disk.
"""

import contextlib
import os
import stat

VARIABLE = 'RVD_VERDICT_LINE'           # environment: descriptor of the writing end
_HEAD = 4                               # [bytes] length of what follows, least byte first


def tell(content: bytes) -> None:
    """Write a message into the line that this process was started with, if it was with one."""
    given = os.environ.get(VARIABLE, '')
    if not given.isdecimal():
        return
    message = memoryview(len(content).to_bytes(_HEAD, 'little') + content)
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
        self._come = b''

    def handed_over(self) -> None:
        """Close the writing end here: who was started has it."""
        os.close(self.writes)

    def heard(self) -> bytes | None:
        """Return the first message, None until it is here whole; what follows it is left alone."""
        with contextlib.suppress(BlockingIOError):
            while self._reads >= 0 and (part := os.read(self._reads, 65536)):
                self._come += part
        size = int.from_bytes(self._come[:_HEAD], 'little')
        whole = len(self._come) >= _HEAD and len(self._come) >= _HEAD + size
        return self._come[_HEAD:_HEAD + size] if whole else None

    def close(self) -> None:
        """Close the reading end; what has come stays known."""
        self.heard()
        if self._reads >= 0:
            os.close(self._reads)
            self._reads = -1
