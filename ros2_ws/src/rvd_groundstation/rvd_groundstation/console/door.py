"""
The console's door: connections are bounded in pace, number and time, refusals are counted.

On a loopback address a page that has yet to be loaded looks like anybody else: it has no token.
So nobody is refused for coming often. Connections are let in in the order in which they came, so
many a second; when the house is full the one has to go that has been idle for longest. Who has
shown the token is never put out.
"""

import asyncio
import socket
import ssl
from collections import Counter
from collections.abc import Iterable

from aiohttp import web
from aiohttp.http import HttpProcessingError

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.console.access import HEADERS, Pace

CONNECT_RATE, CONNECT_BURST = 200.0, 300.0      # [1/s] connections, of all together
BACKLOG = 1024                  # connections that wait to be let in
MAX_CONNECTIONS = 256           # a page has one socket, and six more while it loads
ASK_S = 10.0                    # [s] wall time in which a new connection must have asked something
SEND_S = 30.0                   # [s] an answer to who has shown no token that takes longer: cut off
IDLE_S = 15.0                   # [s] between two requests
LINGER_S = 1.0                  # [s] for the rest of a request that was answered already
BREATH_S = 0.1                  # [s] before the next try where the system can open no connection

BAD_HTTP, ELSEWHERE, STRANGER, TOO_MANY, SLOW, BAD_FRAME, OTHER = KINDS = (
    'no HTTP', 'for another Host or from another Origin', 'without the token',
    'too many at once', 'never finished', 'with bad frames', 'other')
KIND_OF = {400: BAD_HTTP, 403: STRANGER, 429: TOO_MANY, 503: TOO_MANY}
ANSWERS = (404, 409, 422)       # to who asked properly


class Door:
    """Lets connections in, and counts what was refused, by kind."""

    def __init__(self) -> None:
        self.refused: Counter[str] = Counter()
        self._visitors: dict[Visitor, asyncio.Task] = {}
        self._listeners: list[socket.socket] = []
        self._tasks: list[asyncio.Task] = []
        self._pace = Pace(CONNECT_RATE, CONNECT_BURST)

    async def open(self, bind: str, port: int, context: ssl.SSLContext | None,
                   server: web.Server) -> int:
        """
        Let connections to a server in; return the port.

        Raises
        ------
        BadInput
            If it cannot listen there.
        """
        loop = asyncio.get_running_loop()
        try:
            for listener in _listening(await loop.getaddrinfo(
                    bind, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE), port):
                self._listeners.append(listener)
        except OSError as error:
            self.close()
            raise BadInput(f'the console cannot listen on {bind}:{port}: '
                           f'{error.strerror}') from None
        self._tasks = [loop.create_task(self._let_in(listener, context, server))
                       for listener in self._listeners]
        return self._listeners[0].getsockname()[1]

    def close(self) -> None:
        """Let nobody in any more."""
        for task in self._tasks:
            task.cancel()
        for listener in self._listeners:
            listener.close()

    def cut_all(self) -> None:
        """Cut off every connection."""
        for visitor in list(self._visitors):
            self._cut(visitor)

    def in_words(self) -> str:
        """Return how many requests were refused, and of which kinds; empty: none."""
        total = self.refused.total()
        kinds = ', '.join(f'{self.refused[kind]} {kind}' for kind in KINDS if self.refused[kind])
        return f'console refused {total} request{"s" * (total > 1)}: {kinds}' if total else ''

    async def _let_in(self, listener: socket.socket, context: ssl.SSLContext | None,
                      server: web.Server) -> None:
        loop = asyncio.get_running_loop()
        while True:
            try:
                connection, _ = await loop.sock_accept(listener)
            except OSError:                     # gone meanwhile, or no descriptor is left
                self._make_room()
                await asyncio.sleep(BREATH_S)
                continue
            if len(self._visitors) >= MAX_CONNECTIONS and not self._make_room():
                self.refused[TOO_MANY] += 1
                connection.close()
            else:
                visitor = Visitor(server, self)
                self._visitors[visitor] = loop.create_task(
                    self._connect(visitor, connection, context))
            await asyncio.sleep(self._pace.wait_s(loop.time()))

    async def _connect(self, visitor: 'Visitor', connection: socket.socket,
                       context: ssl.SSLContext | None) -> None:
        try:
            await asyncio.get_running_loop().connect_accepted_socket(
                lambda: visitor, connection, ssl=context,
                ssl_handshake_timeout=ASK_S if context else None)
        except (OSError, asyncio.CancelledError):       # of TLS, too
            self.forget(visitor)
            connection.close()

    def forget(self, visitor: 'Visitor') -> None:
        """Be told that a connection is over."""
        self._visitors.pop(visitor, None)

    def _make_room(self) -> bool:
        """Put out who has been idle for longest, who has never asked anything first of all."""
        idle = [v for v in self._visitors if v.idle_since is not None and not v.trusted]
        if not idle:
            return False
        self._cut(min(idle, key=lambda v: (v.asked, v.idle_since)))
        return True

    def _cut(self, visitor: 'Visitor') -> None:
        task = self._visitors.pop(visitor, None)
        if visitor.transport is not None:
            visitor.transport.abort()
        elif task is not None:
            task.cancel()                       # still at its handshake


class Visitor(web.RequestHandler):
    """One connection, from coming in to leaving."""

    __slots__ = ('_door', 'trusted', 'asked', 'idle_since', '_spoke', '_deadline')

    def __init__(self, server: web.Server, door: Door) -> None:
        loop = asyncio.get_running_loop()
        super().__init__(server, loop=loop, access_log=None, keepalive_timeout=IDLE_S,
                         lingering_time=LINGER_S)
        self._door = door
        self.trusted = False                    # has shown the token
        self.asked = False                      # a whole request has come
        self.idle_since: float | None = loop.time()     # None: is being answered
        self._spoke = False
        self._deadline: asyncio.TimerHandle | None = loop.call_later(ASK_S, self._too_slow)

    def connection_lost(self, exc: BaseException | None) -> None:
        """Forget it."""
        self._in_time()
        self._door.forget(self)
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Note that something was said; what that is, is found out elsewhere."""
        self._spoke = True
        super().data_received(data)

    def begun(self, trusted: bool) -> None:
        """Be told that a request is about to be answered."""
        self._in_time()
        self.asked, self.idle_since = True, None
        self.trusted = self.trusted or trusted
        if not self.trusted:
            self._deadline = self._loop.call_later(SEND_S, self._too_slow)

    async def finish_response(self, request: web.BaseRequest, resp: web.StreamResponse,
                              start_time: float | None) -> tuple[web.StreamResponse, bool]:
        """Send an answer with the protecting headers; count a refusal."""
        if not resp.prepared:
            resp.headers.update(HEADERS)
            if resp.status >= 400 and resp.status not in ANSWERS:
                kind = getattr(resp, 'kind', '') or KIND_OF.get(resp.status, OTHER)
                self._door.refused[kind] += 1
                resp.force_close()              # the next one has to come in again
        try:
            return await super().finish_response(request, resp, start_time)
        finally:
            self._in_time()
            self.idle_since = self._loop.time()

    def handle_error(self, request: web.BaseRequest, status: int = 500,
                     exc: BaseException | None = None, message: str | None = None
                     ) -> web.StreamResponse:
        """Return the answer to what is no HTTP; a fault of ours keeps its traceback."""
        if isinstance(exc, ConnectionError):
            raise exc
        if status >= 500:
            return super().handle_error(request, status, exc, message)
        return Answer(status, 'this is no HTTP')

    def log_exception(self, *args, exc_info: BaseException | None = None, **kw) -> None:
        """Keep what a stranger can cause out of the log."""
        if isinstance(exc_info, (web.RequestPayloadError, HttpProcessingError, ConnectionError)):
            self._door.refused[BAD_HTTP] += 1
        else:
            super().log_exception(*args, exc_info=exc_info, **kw)

    def _in_time(self) -> None:
        if self._deadline is not None:
            self._deadline.cancel()
            self._deadline = None

    def _too_slow(self) -> None:
        self._deadline = None
        if self._spoke:                         # a browser opens some that it may never need
            self._door.refused[SLOW] += 1
        self._door._cut(self)


class Answer(web.Response):
    """An answer of one line."""

    def __init__(self, status: int, text: str, kind: str = '',
                 headers: dict[str, str] | None = None) -> None:
        super().__init__(status=status, text=text + '\n', headers=headers)
        self.kind = kind                        # what a refusal is counted as; empty: by status


def _listening(addresses: Iterable[tuple], port: int) -> Iterable[socket.socket]:
    """Yield a listening socket for each address of a host; the first chooses a port that is 0."""
    for family, _, _, _, address in dict.fromkeys(addresses):
        listener = socket.socket(family, socket.SOCK_STREAM)
        try:
            listener.setblocking(False)
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            if family == socket.AF_INET6:
                listener.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
            listener.bind((address[0], port, *address[2:]))
            listener.listen(BACKLOG)
        except OSError:
            listener.close()
            raise
        port = listener.getsockname()[1]
        yield listener
