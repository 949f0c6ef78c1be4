"""
One connected page: what is waiting to be sent to it, with an end to patience.

Frames of the running flight may be dropped, oldest first, and the page sees the gap in their
numbers; what happens once (run, verdict, replies) is kept. A page that takes nothing is
closed, and nobody else notices.
"""

from collections import deque

SOFT_BYTES = 128 * 1024         # frames beyond this are dropped, oldest first
HARD_BYTES = 1024 * 1024        # more than this waiting: close
STUCK_S = 10.0                  # [s] one send that takes longer: close


class Outbox:
    """Messages for one page, in order."""

    def __init__(self, soft: int = SOFT_BYTES, hard: int = HARD_BYTES) -> None:
        self._soft, self._hard = soft, hard
        self._waiting: deque[tuple[bool, str]] = deque()
        self.bytes = 0
        self.dropped = 0

    def put(self, text: str, droppable: bool) -> bool:
        """Add a message; False when the page is too far behind and is to be closed."""
        self._waiting.append((droppable, text))
        self.bytes += len(text)
        while self.bytes > self._soft and self._drop_oldest():
            pass
        return self.bytes <= self._hard

    def _drop_oldest(self) -> bool:
        for i, (droppable, text) in enumerate(self._waiting):
            if droppable and i < len(self._waiting) - 1:
                del self._waiting[i]
                self.bytes -= len(text)
                self.dropped += 1
                return True
        return False

    def take(self) -> str | None:
        """Return the oldest message, None when there is none."""
        if not self._waiting:
            return None
        _, text = self._waiting.popleft()
        self.bytes -= len(text)
        return text

    def __len__(self) -> int:
        return len(self._waiting)
