"""
The console's web server: a static page, one socket per page, run folders for review.

Bound to a loopback address, or to another one with TLS. Every request is held against Host and
Origin, every socket and every run folder also against the token, before anything else is done
for it. Who fails takes nothing from who passes.
"""

import asyncio
import hashlib
import logging
import re
import ssl
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from aiohttp import web, WSMsgType

from rvd_groundstation.console import review
from rvd_groundstation.console.access import (
    Access, check_bind, HEADERS, Pace, SUBPROTOCOL, Throttle, token_of)
from rvd_groundstation.console.clients import STUCK_S
from rvd_groundstation.console.door import (
    Answer, BAD_FRAME, Door, ELSEWHERE, STRANGER, TOO_MANY)
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.pages import Client
from rvd_groundstation.console.protocol import encode, MAX_FRAME
from rvd_groundstation.console.reports import POLICY, Reports
from rvd_groundstation.console.tokens import tokens_of
from rvd_dynamics.bad_input import BadInput

STATIC = Path(__file__).parent / 'static'
REQUEST_RATE, REQUEST_BURST = 60.0, 200.0       # [1/s] with the token, of all pages together
FAILURE_RATE, FAILURE_BURST = 5.0, 5.0          # [1/s] refusals that are told why
# [1/s] files of the page, which anybody may have: they wait, in the order in which they were asked
# for; a large one counts for several
FILE_RATE, FILE_BURST, FILE_BYTES = 300.0, 100.0, 200_000
PART_BYTES = 64 * 1024          # of a file, sent at a time
NONCE = re.compile(r'[0-9a-f]{32}')       # of a page that wants a proof
KINDS = {'.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8',
         '.css': 'text/css; charset=utf-8', '.svg': 'image/svg+xml'}
HEARTBEAT_S = 10.0
REVIEWS = 2                     # at a time: each reads a bag in a process of its own
REVIEW_S = 120.0                # [s] wall time that one may take
MOST_WAITING = 4                # reviews; who comes then is told to come again
AGAIN_S = 5                     # [s] when

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


@dataclass(frozen=True)
class Address:
    """Where to listen."""

    bind: str = '127.0.0.1'
    port: int = 8480                # 0: any free one
    tls_cert: str = ''
    tls_key: str = ''

    def __post_init__(self) -> None:
        check_bind(self.bind, self.tls_cert, self.tls_key)
        if not 0 <= self.port < 1 << 16:
            raise BadInput(f'port must be 0 to 65535, got {self.port}')

    def tls(self) -> ssl.SSLContext | None:
        """Return the TLS context, None on a loopback address without one."""
        if not self.tls_cert:
            return None
        context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
        try:
            context.load_cert_chain(self.tls_cert, self.tls_key)
        except OSError as error:
            raise BadInput(f'cannot load the TLS certificate {self.tls_cert} with the key '
                           f'{self.tls_key}: {error}') from None
        return context


class File(NamedTuple):
    """A file of the page."""

    body: bytes
    kind: str                       # its media type
    tag: str                        # changes with it


def files_of_the_page() -> dict[str, File]:
    """Return the files of the page by their paths; none if it has not been built."""
    found = {'/': STATIC / 'index.html',
             **{f'/assets/{file.name}': file for file in (STATIC / 'assets').glob('*')}}
    made = {}
    for path, file in found.items():
        if file.is_file():
            body = file.read_bytes()
            made[path] = File(body, KINDS.get(file.suffix, 'application/octet-stream'),
                              f'"{hashlib.sha256(body).hexdigest()[:16]}"')
    return made


class Server:
    """Serves one hub."""

    def __init__(self, hub: Hub, address: Address, runs: Path | None) -> None:
        self.hub = hub
        self.access: Access | None = None
        self._address = address
        self._runs = runs
        self._requests = Throttle(REQUEST_RATE, REQUEST_BURST)
        self._failures = Throttle(FAILURE_RATE, FAILURE_BURST)
        self._files = Pace(FILE_RATE, FILE_BURST)
        self._page: dict[str, File] = {}        # by path
        self._token_in: dict[Handler, Callable[[web.Request], str | None]] = {
            self._socket: _offered, self._list: _bearer, self._run: _bearer,
            self._ticket: _bearer}
        self._tasks: list[asyncio.Task] = []
        self._in_review = 0
        self._reports = Reports(runs)
        self.door = Door()

    async def start(self) -> str:
        """Listen; return the URL for who flies. That for watchers is `access.watch_url`."""
        # What a stranger says is counted, not logged; faults of ours are logged.
        logging.getLogger('aiohttp.websocket').setLevel(logging.ERROR)
        context = self._address.tls()
        self._line, self._listings = asyncio.Lock(), asyncio.Semaphore(REVIEWS)
        self._reviews = asyncio.Semaphore(REVIEWS)
        self._page = files_of_the_page()
        app = web.Application(middlewares=[self._guard], client_max_size=MAX_FRAME)
        app.add_routes([
            web.get('/', self._file), web.get('/assets/{name:.+}', self._file),
            web.get('/ws', self._socket), web.get('/api/proof', self._proof),
            web.get('/api/runs', self._list), web.get('/api/runs/{name:.+}', self._run),
            web.get('/api/reports/{name:.+}', self._ticket),
            web.get('/report/{ticket}', self._report)])
        self._runner = web.AppRunner(app, access_log=None, shutdown_timeout=0.5)
        await self._runner.setup()
        port = await self.door.open(
            self._address.bind, self._address.port, context, self._runner.server)
        tokens = tokens_of(self._address.bind, self._address.port)
        self.access = Access(tokens.fly, self._address.bind, port, context is not None,
                             tokens.watch)
        self._tasks = [asyncio.create_task(self.hub.pump()),
                       asyncio.create_task(self.hub.housekeeping())]
        return self.access.url

    async def stop(self) -> None:
        """Close every page and stop listening."""
        for task in self._tasks:
            task.cancel()
        for client in list(self.hub.pages.clients):
            client.closing = 'BYE'
            client.wake.set()
        await asyncio.sleep(0.05)
        self.door.close()
        await self._runner.cleanup()
        self.door.cut_all()

    # -- requests -------------------------------------------------------------------------

    @web.middleware
    async def _guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        """Check Host, Origin and token, then how often."""
        why = self.access.refusal(request.headers.get('Host'), request.headers.get('Origin'),
                                  must_have_origin=request.path == '/ws')
        token_in = self._token_in.get(request.match_info.handler)
        if why is None and token_in is not None and not self._lets_in(token_in(request)):
            why = 'TOKEN'
        request.protocol.begun(trusted=why is None and token_in is not None)
        if why is not None:
            return self._refuse(why)
        if token_in is None:
            await self._turn(request)
        elif not self._requests.allow(time.monotonic()):
            return Answer(429, 'too many requests')
        try:
            return await handler(request)
        except web.HTTPException as error:
            return Answer(error.status, error.reason)

    def _lets_in(self, token: str | None) -> bool:
        return self.access.knows(token) or self.access.watches(token)

    def _refuse(self, why: str) -> web.Response:
        """Say why, but not to everybody who asks again and again."""
        kind = STRANGER if why == 'TOKEN' else ELSEWHERE
        if self._failures.allow(time.monotonic()):
            return Answer(403, f'refused: {why}', kind)
        return Answer(429, 'too many requests were refused', kind)

    async def _turn(self, request: web.Request) -> None:
        """Wait until it is this request's turn to be given a file."""
        async with self._line:                  # first come, first served
            if request.transport is None:
                raise ConnectionResetError('gone while waiting')
            size = len(self._page[request.path].body) if request.path in self._page else 0
            await asyncio.sleep(self._files.wait_s(time.monotonic(), 1.0 + size // FILE_BYTES))

    async def _file(self, request: web.Request) -> web.StreamResponse:
        """Send a file of the page, in parts: a page that reads slowly takes no room here."""
        file = self._page.get(request.path)
        if file is None:
            return Answer(404, 'the page has not been built' if not self._page else 'no such file')
        about = {**HEADERS, 'Cache-Control': 'no-cache', 'ETag': file.tag}
        if request.headers.get('If-None-Match') == file.tag:
            return web.Response(status=304, headers=about)
        return await _in_parts(request, file.body, {**about, 'Content-Type': file.kind})

    async def _proof(self, request: web.Request) -> web.StreamResponse:
        """Prove to a page that this server has its token, before it shows that."""
        nonce = request.query.get('nonce', '')
        if not NONCE.fullmatch(nonce):
            return Answer(422, 'the nonce must be 32 hexadecimal digits')
        return web.Response(text=encode(self.access.proofs(request.headers['Host'], nonce)),
                            content_type='application/json',
                            headers={'Cache-Control': 'no-store'})

    async def _list(self, request: web.Request) -> web.StreamResponse:
        async with self._listings:              # a slow disk must not hold up files of the page
            rows = await asyncio.to_thread(review.listing, self._runs)
        shown = [row for row in rows if not self._under_way(row['name'])]
        return web.Response(text=encode(shown), content_type='application/json')

    async def _run(self, request: web.Request) -> web.StreamResponse:
        name = request.match_info['name']
        if self._under_way(name):               # its bag holds the truth
            return Answer(409, 'this run is still under way')
        if self._in_review >= REVIEWS + MOST_WAITING:
            return Answer(503, f'{REVIEWS} reviews are being prepared and {MOST_WAITING} wait: '
                         f'try again in {AGAIN_S} s', TOO_MANY, {'Retry-After': str(AGAIN_S)})
        self._in_review += 1
        try:
            async with self._reviews:
                if request.transport is None:
                    raise ConnectionResetError('gone while waiting')
                body = await asyncio.wait_for(review.load(self._runs, name), REVIEW_S)
        except FileNotFoundError:
            return Answer(404, 'no such run')
        except BadInput as error:
            return Answer(422, str(error))
        except asyncio.TimeoutError:
            return Answer(422, f'{name}: its bag was not read within {REVIEW_S:g} s')
        finally:
            self._in_review -= 1
        response = web.Response(body=body, content_type='application/json')
        response.enable_compression()
        return response

    async def _ticket(self, request: web.Request) -> web.StreamResponse:
        name = request.match_info['name']
        if self._under_way(name):
            return Answer(409, 'this run is still under way')
        try:
            ticket = self._reports.ticket(name, time.monotonic())
        except FileNotFoundError:
            return Answer(404, 'no such run, or it has no report: ./rvd report makes one')
        return web.json_response({'url': f'report/{ticket}'})

    async def _report(self, request: web.Request) -> web.StreamResponse:
        """Send the report that a ticket opens: it is not the console's page, and may do less."""
        body = await asyncio.to_thread(
            self._reports.read, request.match_info['ticket'], time.monotonic())
        if body is None:
            return Answer(404, 'this address opens no report any more: open it from the console')
        return await _in_parts(request, body, {
            **HEADERS, 'Content-Security-Policy': POLICY, 'Cache-Control': 'no-store',
            'Content-Type': KINDS['.html']})

    def _under_way(self, name: str) -> bool:
        return self.hub.phase in ('starting', 'flying', 'closing') and name == self.hub.run_name

    # -- sockets --------------------------------------------------------------------------

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        client = self.hub.join(self.access.watches(_offered(request)))
        if client is None:
            return Answer(503, 'no room: 50 pages watch already')
        socket = web.WebSocketResponse(protocols=(SUBPROTOCOL,), max_msg_size=MAX_FRAME,
                                       heartbeat=HEARTBEAT_S, compress=False)
        sender = None
        try:
            await _shake_hands(socket, request)
            client.cut = lambda: _cut(request)
            sender = asyncio.create_task(self._send(socket, client))
            async for message in socket:
                if message.type == WSMsgType.BINARY:
                    self.hub.stick(client, message.data)
                elif message.type == WSMsgType.TEXT:
                    self.hub.request(client, message.data)
                elif message.type == WSMsgType.ERROR:       # the socket closes itself
                    self.door.refused[BAD_FRAME] += 1
                if client.closing:
                    break
        finally:
            self.hub.leave(client)
            if sender is not None:
                sender.cancel()
        return socket

    async def _send(self, socket: web.WebSocketResponse, client: Client) -> None:
        """Send what waits for one page; a page that takes nothing is cut off."""
        loop = asyncio.get_running_loop()
        while not client.closing:
            text = client.outbox.take()
            if text is None:
                client.wake.clear()
                await client.wake.wait()
                continue
            stuck = loop.call_later(STUCK_S, client.cut)    # ends the wait below
            try:
                await socket.send_str(text)
            except ConnectionError:
                client.closing = 'STUCK'
            finally:
                stuck.cancel()
        if client.closing in ('SLOW', 'STUCK'):
            client.cut()
            return
        await socket.close(code=1008, message=client.closing.encode())


async def _in_parts(request: web.Request, body: bytes, headers: dict[str, str]
                    ) -> web.StreamResponse:
    response = web.StreamResponse(headers=headers)
    response.content_length = len(body)
    await response.prepare(request)
    if request.method != 'HEAD':
        for at in range(0, len(body), PART_BYTES):
            await response.write(body[at:at + PART_BYTES])
    return response


async def _shake_hands(socket: web.WebSocketResponse, request: web.Request) -> None:
    try:
        await socket.prepare(request)
    except ValueError:                          # a key that is not ASCII
        raise web.HTTPBadRequest from None


def _cut(request: web.Request) -> None:
    if request.transport is not None:
        request.transport.abort()


def _offered(request: web.Request) -> str | None:
    return token_of([word.strip() for word in
                     request.headers.get('Sec-WebSocket-Protocol', '').split(',')])


def _bearer(request: web.Request) -> str | None:
    scheme, _, token = request.headers.get('Authorization', '').partition(' ')
    return token if scheme == 'Bearer' else None
