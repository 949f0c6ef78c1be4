"""
The middle of the console: pages on one side, one run after the other on the other side.

Lives on the event loop's thread alone; the ROS side hands in what it decoded through `post`,
which any thread may call. The lease says who flies. Whoever holds the pilot's token may abort;
a watcher's page asks for nothing.
"""

import asyncio
import json
import time
from collections import deque
from typing import Any, Callable, Protocol

from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.lease import Lease
from rvd_groundstation.console.pages import Client, Pages
from rvd_groundstation.console.protocol import (
    flight_wish, NEEDS_LEASE, OF_WATCHERS, Refused, RELEASED, Request, request_of, Stick, stick_of)
from rvd_groundstation.console.provider import MissionDisplay
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.aborts import ABORT_EVENT

FRAME_S = 1.0 / 30              # [s] wall time: a page gets no more frames than this
HOUSEKEEPING_S = 0.25           # [s] wall time
MAX_CLIENTS = 51                # 50 watchers and a pilot
STICK_S = 0.5                   # [s] wall time after which a held stick is no pilot
ANSWER_S = 2.0                  # [s] wall time in which /run/control must have answered
WAKING = ('begin', 'command', 'event', 'final', 'paused')


class Bridge(Protocol):
    """The running graph, as the hub sees it; every method may be called from the event loop."""

    def joy(self, stick: Stick) -> list[float]:
        """Publish a stick sample; return the command that it means."""

    def control(self, action: str, mode: str, reply: Callable[[bool, str], None]) -> None:
        """Call /run/control; `reply` gets the answer, if one comes, in the event loop."""

    def event(self, code: str, text: str) -> None:
        """Put an event on /run/events."""


class Hub:
    """
    Pages, lease, the current run, and what they say to each other.

    `ask` hands a wish (a new run, stop, quit) to whoever starts runs; None: nobody does.
    `display` (from `as_data`) and `mode` are what a page shows until the first run brings its own.
    """

    def __init__(self, ask: Callable[[dict], None] | None = None, desk: Any = None,
                 display: dict[str, Any] | None = None, mode: str = '') -> None:
        self.lease = Lease()
        self.pages = Pages(self.lease)
        self.desk = desk
        self._display, self._mode = display, mode
        self.feed: Feed | None = None
        self.run_name: str | None = None        # folder name of the run under way
        self.phase = 'idle'                     # idle, starting, flying, closing, ended
        self.note = ''
        self.progress = ''                      # of a start: how many nodes are ready
        self.verdict: dict | None = None
        self.pilot_lost = False
        self.aborted = False                    # an ABORT was asked for, by whomever
        self.sticks = 0
        self._ask = ask
        self._bridge: Bridge | None = None
        self._inbox: deque[tuple[str, tuple]] = deque()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._fresh = asyncio.Event()
        self._numbers = 0
        self._stick: tuple[float, Stick] | None = None

    # -- pages ----------------------------------------------------------------------------

    def join(self, watches: bool = False) -> Client | None:
        """
        Return a new client with all it needs to begin, or None when the house is full.

        One that came with a watcher's token `watches`.
        """
        if len(self.pages.clients) >= MAX_CLIENTS:
            return None
        self._numbers += 1
        client = Client(self._numbers, watches=watches)
        self.pages.clients.add(client)
        self.pages.tell(client, {
            'type': 'hello', 'you': client.number,
            'can': {'fly': self._ask is not None, 'desk': self.desk is not None,
                    'steer': not watches},
            'flown': self.feed is not None, 'display': self._display, 'mode': self._mode})
        if self.feed is not None:
            self.pages.tell(client, {
                **self.feed.run_message(self.run_name or ''), 'trails': self.feed.trails,
                'ladder': self.feed.ladder.changes()})
        if self.verdict is not None:
            self.pages.tell(client, self.verdict)
        if self.feed is not None and self.feed.step >= 0:       # none comes in a pause, or later
            self.pages.tell(client, self.pages.last_frame())
        if self.desk is not None:
            self.pages.tell(client, self.desk.view())
        self._status()
        return client

    def leave(self, client: Client) -> None:
        """Forget a page; if it was the pilot's, the pilot is lost."""
        self.pages.clients.discard(client)
        if self.lease.drop(client):
            self._lost('the page of the pilot is gone')
        self._status()

    def stick(self, client: Client, data: bytes) -> None:
        """Take a stick sample of the pilot; those of others are ignored."""
        now = time.monotonic()
        if not self._allowed(client, now) or not self.lease.heard(client, now):
            return
        try:
            sample = stick_of(data)
        except Refused as refusal:
            self.pages.tell(client, {'type': 'refused', 'code': str(refusal)})
            return
        self.sticks += 1
        self._stick = (now, sample)
        if self._bridge is not None:
            value = self._bridge.joy(sample)
            if self.feed is not None:
                self.feed.pilot(value, sample.held)
            if self.pilot_lost and sample.held:
                self.pilot_lost = False
                self._bridge.event('PILOT', 'a pilot has the stick again')
                self._status()

    def request(self, client: Client, text: str) -> None:
        """Do what a page asks, or say why not."""
        if not self._allowed(client, time.monotonic()):
            return
        try:
            wish = request_of(text, self._modes())
            self._do(client, wish)
        except Refused as refusal:
            self.pages.tell(client, {'type': 'reply', 'id': _id_in(text), 'ok': False,
                                     'code': str(refusal)})

    def _allowed(self, client: Client, now: float) -> bool:
        if client.throttle.allow(now):
            return True
        client.closing = 'FLOOD'
        client.wake.set()
        return False

    def _do(self, client: Client, wish: Request) -> None:
        if client.watches and wish.do not in OF_WATCHERS:
            raise Refused('WATCH')
        if wish.do in NEEDS_LEASE and self.lease.holder is not client:
            raise Refused('LEASE')
        refused = self.desk.refuses(wish.do, self.aborted) if self.desk is not None else ''
        if refused:
            raise Refused(refused)
        if wish.do == 'take':
            if not self.lease.take(client, time.monotonic()):
                raise Refused('TAKEN')
            self._tell_ladder(client)           # pilots and watchers hear its changes apart
        elif wish.do == 'drop':
            if self.lease.drop(client):
                self._release()
        elif wish.do in ('pause', 'resume', 'abort', 'mode'):
            self._control(client, wish)
            return
        elif wish.do in ('fly', 'stop', 'quit'):
            self._ask_for(wish)
        elif wish.do == 'desk':
            self._at_desk(wish)
        elif wish.content.get('resync'):
            self._tell_ladder(client)
        self._reply(client, wish.id, True, '')
        self._status()

    def _control(self, client: Client, wish: Request) -> None:
        if self._bridge is None or self.phase != 'flying':
            raise Refused('NO_RUN')
        if wish.content.get('run', self.run_name) != self.run_name:
            raise Refused('NO_RUN')             # asked again of a run that is over
        mode, feed = wish.content.get('mode', ''), self.feed

        def no_answer() -> None:
            self.pages.tell(client, {'type': 'reply', 'id': wish.id, 'ok': False,
                                     'code': 'NO_ANSWER'})
        timer = asyncio.get_running_loop().call_later(ANSWER_S, no_answer)

        def reply(accepted: bool, text: str) -> None:
            timer.cancel()
            if accepted:                        # also too late: what is in force is shown
                if wish.do == 'mode':
                    feed.mode = mode
                elif wish.do in ('pause', 'resume'):
                    feed.paused = wish.do == 'pause'
                self._fresh.set()
            self._reply(client, wish.id, accepted, text)
        self._bridge.control(wish.do, mode, reply)

    def _modes(self) -> list[str]:
        """Return the names of the modes that the pages have buttons for."""
        if self.feed is not None:
            return [mode.name for mode in self.feed.display.modes]
        return [mode['name'] for mode in (self._display or {}).get('modes', ())]

    def _ask_for(self, wish: Request) -> None:
        if self._ask is None:
            raise Refused('NO_FLY')
        self._ask({'do': wish.do, **(flight_wish(wish.content, self._modes())
                                     if wish.do == 'fly' else {})})
        if wish.do == 'fly':
            self.phase = 'starting'

    def _at_desk(self, wish: Request) -> None:
        if self.desk is None:
            raise Refused('NO_DESK')
        try:
            order = self.desk.do(wish.content)
        except BadInput as error:
            raise Refused(str(error)) from None
        if order is not None:
            self.phase = 'starting'
            self._ask({'do': 'fly', **order})
        self.pages.everybody(self.desk.view())

    def _reply(self, client: Client, number: int, ok: bool, text: str) -> None:
        self.pages.tell(client, {'type': 'reply', 'id': number, 'ok': ok, 'text': text})

    # -- the pilot ------------------------------------------------------------------------

    def _release(self) -> None:
        """Let go of the stick at once, without waiting for it to grow old."""
        self._stick = None
        if self._bridge is not None:
            self._bridge.joy(RELEASED)
        if self.feed is not None:
            self.feed.no_pilot()

    def _lost(self, why: str) -> None:
        self._release()
        if self.phase == 'flying':
            self.pilot_lost = True
            if self._bridge is not None:
                self._bridge.event('PILOT_LOST', why)

    # -- runs -----------------------------------------------------------------------------

    def begin(self, name: str, provider: MissionDisplay, bridge: Bridge) -> None:
        """Let a new run begin; pages stay."""
        self.feed, self.run_name, self._bridge = Feed(provider), name, bridge
        self.phase, self.note, self.verdict, self.pilot_lost = 'flying', '', None, False
        self.aborted = False
        self.pages.begin(self.feed)
        self.pages.everybody(self.feed.run_message(name))
        self._status()

    def end(self) -> None:
        """Let the run be over."""
        self._drain()
        self._bridge = None
        if self.phase == 'flying':              # who starts runs still writes its folder
            self.phase = 'ended' if self._ask is None else 'closing'
        self.pages.show()
        self._status()

    def told(self, phase: str, note: str = '', run: str | None = None) -> None:
        """
        Be told by whoever starts runs how that goes with `run` (its folder).

        `progress` is no phase: its note says how far the start is, also once our own node is there.
        """
        self.progress = note if phase == 'progress' else ''
        if phase == 'progress':
            self._status()
            return
        if phase == 'starting':
            self.run_name = run
        self.phase, self.note = phase, note
        if self.desk is not None and phase == 'ended':
            self.desk.ended(run)
            self.pages.everybody(self.desk.view())
        self._status()

    def post(self, method: str, *args: Any) -> None:
        """
        Hand in decoded content, and with 'begin' a new run before its content; from any thread.

        One queue for both, so that what a node says first can neither be lost nor be taken for
        the run before.
        """
        self._inbox.append((method, args))
        if method in WAKING and self._loop is not None:
            self._loop.call_soon_threadsafe(self._fresh.set)

    def _drain(self) -> None:
        while self._inbox:
            method, args = self._inbox.popleft()
            if method == 'begin':
                self.begin(*args)
            elif method == 'event':
                self.pages.everybody({'type': 'event', **args[0]})
                self.aborted = self.aborted or args[0]['code'] == ABORT_EVENT
                if self.feed is not None:
                    self.feed.event(args[0]['code'], args[0]['text'])
            elif method == 'final':
                self.verdict = {'type': 'verdict', **args[0]}
                if self.feed is not None:
                    self.feed.settle(args[0]['duration'])
                self.pages.everybody(self.verdict)
                if self.desk is not None:
                    self.desk.flown(args[0])
                    self.pages.everybody(self.desk.view())
            elif self.feed is not None:
                if method == 'paused':
                    self.feed.paused = args[0]
                else:
                    getattr(self.feed, method)(*args)

    # -- what goes out --------------------------------------------------------------------

    async def pump(self) -> None:
        """Send frames as the run steps, for ever."""
        self._loop = asyncio.get_running_loop()
        self.pages.pace(self._loop)
        if self._inbox:                         # posted before there was a loop to wake
            self._fresh.set()
        while True:
            await self._fresh.wait()
            self._fresh.clear()
            self._drain()
            self.pages.show()
            await asyncio.sleep(FRAME_S)

    async def housekeeping(self) -> None:
        """Notice a silent pilot, and let every page hear that this server lives, for ever."""
        while True:
            await asyncio.sleep(HOUSEKEEPING_S)
            now = time.monotonic()
            self.pages.beat(now)
            if self.lease.expire(now):
                self._lost('the page of the pilot is silent')
                self._status()
            if self._stick is not None and now - self._stick[0] > STICK_S:
                self._stick = None
                if self.feed is not None:
                    self.feed.no_pilot()
                    self._fresh.set()

    def _status(self) -> None:
        for client in list(self.pages.clients):
            holder = self.lease.holder
            who = 'free' if holder is None else 'you' if holder is client else 'other'
            self.pages.tell(client, {
                'type': 'status', 'phase': self.phase, 'note': self.note, 'lease': who,
                'pages': len(self.pages.clients), 'run': self.run_name,
                'pilot_lost': self.pilot_lost, 'progress': self.progress})

    def _tell_ladder(self, client: Client) -> None:
        if self.feed is not None:
            self.pages.tell(client, {'type': 'ladder', 'ladder': self.feed.ladder.changes()})


def _id_in(text: str) -> int:
    """Return the id of a request that was refused before it was understood, else 0."""
    try:
        number = json.loads(text).get('id', 0)
    except (ValueError, AttributeError, RecursionError):
        return 0
    return number if isinstance(number, int) else 0
