"""
The pages of a console: who is connected, and how often each is told what is flown.

The pilot's page gets up to 30 frames a second. Those that watch get up to 10, a few pages at a
time: no stick waits for 50 pages. Lives on the event loop's thread, as the hub does.
"""

import asyncio
import math
import time
from dataclasses import dataclass, field
from typing import Callable

from rvd_groundstation.console.access import Throttle
from rvd_groundstation.console.clients import Outbox
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.lease import Lease
from rvd_groundstation.console.protocol import encode, PAGE_BURST, PAGE_RATE

WATCH_S = 0.1                   # [s] wall time: a page that watches gets no more frames than this
HANDFUL = 4                     # [pages] watchers served at a time
HAND_S = 0.016                  # [s] wall time between two handfuls: 50 pages get 5 frames a second
BEAT = encode({'type': 'beat'})         # to a page that was told nothing for so long:
BEAT_S = 0.1                    # [s] wall time


@dataclass(eq=False)
class Client:
    """One page."""

    number: int
    outbox: Outbox = field(default_factory=Outbox)
    wake: asyncio.Event = field(default_factory=asyncio.Event)
    throttle: Throttle = field(default_factory=lambda: Throttle(PAGE_RATE, PAGE_BURST))
    watches: bool = False       # has a watcher's token: never flies, never aborts
    told_at: float = 0.0        # [s] wall time of the last message for it
    closing: str = ''
    cut: Callable[[], None] = lambda: None      # end the connection, whatever it is waiting for


class Pages:
    """What goes out: messages at once, frames at the rate of whom they are for."""

    def __init__(self, lease: Lease) -> None:
        self.clients: set[Client] = set()
        self._lease = lease
        self._feed: Feed | None = None
        self._frame = 0                         # number of the last one
        self._shown = {'pilot': 0, 'watch': 0}  # ladder versions
        self._loop: asyncio.AbstractEventLoop | None = None
        self._watch_at = 0.0                    # when watchers may have the next frame
        self._watchers_due: asyncio.TimerHandle | None = None

    def begin(self, feed: Feed) -> None:
        """Show another run from now on, its ladder from the beginning."""
        self._feed, self._shown = feed, {'pilot': 0, 'watch': 0}

    def pace(self, loop: asyncio.AbstractEventLoop) -> None:
        """Let the loop wait between frames; before that every frame goes out at once."""
        self._loop = loop

    # -- messages -------------------------------------------------------------------------

    def everybody(self, message: dict) -> None:
        """Tell all pages."""
        text = encode(message)
        for client in list(self.clients):
            self.put(client, text, False)

    def tell(self, client: Client, message: dict) -> None:
        """Tell one page."""
        self.put(client, encode(message), False)

    def put(self, client: Client, text: str, droppable: bool) -> None:
        """Queue an encoded message; the page is closed if it takes none."""
        client.told_at = time.monotonic()
        if not client.outbox.put(text, droppable):
            client.closing = 'SLOW'
            client.cut()
        client.wake.set()

    def beat(self, now: float) -> None:
        """Tell pages that were told nothing for a while that this server lives."""
        for client in list(self.clients):
            if now - client.told_at > BEAT_S:
                self.put(client, BEAT, True)

    # -- frames ---------------------------------------------------------------------------

    def last_frame(self) -> dict:
        """Return what is flown now, under the number of the last frame."""
        return {**self._feed.frame(self._feed.ladder.version), 'n': self._frame}

    def show(self) -> None:
        """Send a frame to the pilot, and to those who watch as soon as they may have one."""
        if self._feed is None:
            return
        if self._lease.holder in self.clients:
            self.put(self._lease.holder, self._frame_text('pilot'), True)
        if self._watchers_due is None:
            self._to_watchers()

    def _to_watchers(self) -> None:
        self._watchers_due = None
        now = time.monotonic()
        left = self._watch_at - now
        if left > 0.0 and self._loop is not None:
            self._watchers_due = self._loop.call_later(left, self._to_watchers)
            return
        self._watch_at = now + max(WATCH_S, HAND_S * math.ceil(len(self.clients) / HANDFUL))
        self._hand_out(self._frame_text('watch'), list(self.clients))

    def _hand_out(self, text: str, watchers: list[Client]) -> None:
        """Send a frame to a few and soon to the rest."""
        for client in watchers[:HANDFUL]:
            if client in self.clients and client is not self._lease.holder:
                self.put(client, text, True)
        rest = watchers[HANDFUL:]
        if rest and self._loop is not None:
            self._loop.call_later(HAND_S, self._hand_out, text, rest)

    def _frame_text(self, audience: str) -> str:
        message = self._feed.frame(self._shown[audience])
        self._shown[audience] = self._feed.ladder.version
        self._frame += 1
        message['n'] = self._frame
        return encode(message)
