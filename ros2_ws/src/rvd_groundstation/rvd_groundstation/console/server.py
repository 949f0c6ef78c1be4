"""
The console's web server: a static page, one socket per page, run folders for review.

Bound to a loopback address, or to another one with TLS. Every request is held against Host and
Origin, every socket and every run folder also against the token.
"""

import asyncio
import ssl
import time
from dataclasses import dataclass
from pathlib import Path

from aiohttp import web, WSMsgType

from rvd_groundstation.console import review
from rvd_groundstation.console.access import (
    Access, check_bind, HEADERS, new_token, SUBPROTOCOL, Throttle, token_of)
from rvd_groundstation.console.clients import STUCK_S
from rvd_groundstation.console.hub import Client, Hub
from rvd_groundstation.console.protocol import MAX_FRAME
from rvd_dynamics.bad_input import BadInput

STATIC = Path(__file__).parent / 'static'
REQUEST_RATE, REQUEST_BURST = 60.0, 200.0       # [1/s] of all pages together
FAILURE_RATE, FAILURE_BURST = 5.0, 5.0          # [1/s] wrong tokens
HEARTBEAT_S = 10.0
ASK_S = 10.0                    # [s] wall time in which a new connection must have asked something
MAX_CONNECTIONS = 256           # a page has one socket, and six more while it loads


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


class Server:
    """Serves one hub."""

    def __init__(self, hub: Hub, address: Address, runs: Path | None) -> None:
        self.hub = hub
        self.access: Access | None = None
        self._address = address
        self._runs = runs
        self._token = new_token()
        self._requests = Throttle(REQUEST_RATE, REQUEST_BURST)
        self._failures = Throttle(FAILURE_RATE, FAILURE_BURST)
        self._tasks: list[asyncio.Task] = []
        # connections that have asked nothing yet, and what will cut them off
        self._silent: dict[asyncio.Protocol, asyncio.TimerHandle] = {}

    async def start(self) -> str:
        """Listen; return the URL to open."""
        context = self._address.tls()
        app = web.Application(middlewares=[self._guard], client_max_size=MAX_FRAME)
        app.add_routes([
            web.get('/', self._page), web.get('/ws', self._socket),
            web.get('/api/runs', self._list), web.get('/api/runs/{name:.+}', self._run)])
        app.router.add_static('/assets', STATIC / 'assets')
        self._runner = web.AppRunner(app, access_log=None, keepalive_timeout=15.0,
                                     shutdown_timeout=0.5)
        await self._runner.setup()
        try:
            self._listener = await asyncio.get_running_loop().create_server(
                self._connection, self._address.bind, self._address.port, ssl=context,
                ssl_handshake_timeout=ASK_S if context else None)
        except OSError as error:
            raise BadInput(f'the console cannot listen on {self._address.bind}:'
                           f'{self._address.port}: {error.strerror}') from None
        port = self._listener.sockets[0].getsockname()[1]
        self.access = Access(self._token, self._address.bind, port, context is not None)
        self._tasks = [asyncio.create_task(self.hub.pump()),
                       asyncio.create_task(self.hub.housekeeping())]
        return self.access.url

    async def stop(self) -> None:
        """Close every page and stop listening."""
        for task in self._tasks:
            task.cancel()
        for client in list(self.hub.clients):
            client.closing = 'BYE'
            client.wake.set()
        await asyncio.sleep(0.05)
        self._listener.close()
        await self._runner.cleanup()

    # -- connections ----------------------------------------------------------------------

    def _connection(self) -> asyncio.Protocol:
        """Admit a connection; it is cut off when it does not ask anything soon."""
        if len(self._runner.server.connections) >= MAX_CONNECTIONS:
            return _NoRoom()
        handler = self._runner.server()
        self._silent[handler] = asyncio.get_running_loop().call_later(
            ASK_S, self._cut_off, handler)
        return handler

    def _cut_off(self, handler: asyncio.Protocol) -> None:
        del self._silent[handler]
        if handler.transport is not None:
            handler.transport.abort()

    # -- requests -------------------------------------------------------------------------

    @web.middleware
    async def _guard(self, request: web.Request, handler) -> web.StreamResponse:
        """Check Host and Origin and add the protecting headers to every answer."""
        timer = self._silent.pop(request.protocol, None)
        if timer is not None:
            timer.cancel()
        if self.access is None or not self._requests.allow(time.monotonic()):
            return _plain(429, 'too many requests')
        why = self.access.refusal(request.headers.get('Host'), request.headers.get('Origin'),
                                  must_have_origin=request.path == '/ws')
        if why is not None:
            return _plain(403, f'refused: {why}')
        try:
            response = await handler(request)
        except web.HTTPException as error:
            return _plain(error.status, error.reason)
        if not response.prepared:
            response.headers.update(HEADERS)
        return response

    def _refuse_stranger(self, token: str | None) -> web.Response | None:
        if self.access.knows(token):
            return None
        if not self._failures.allow(time.monotonic()):
            return _plain(429, 'too many wrong tokens')
        return _plain(403, 'refused: TOKEN')

    async def _page(self, request: web.Request) -> web.StreamResponse:
        if not (STATIC / 'index.html').is_file():
            return _plain(404, 'the page has not been built')
        return web.FileResponse(STATIC / 'index.html', headers={'Cache-Control': 'no-cache'})

    async def _list(self, request: web.Request) -> web.StreamResponse:
        refused = self._refuse_stranger(_bearer(request))
        if refused is not None:
            return refused
        rows = await asyncio.to_thread(review.listing, self._runs)
        return web.json_response([row for row in rows if not self._under_way(row['name'])])

    async def _run(self, request: web.Request) -> web.StreamResponse:
        refused = self._refuse_stranger(_bearer(request))
        if refused is not None:
            return refused
        name = request.match_info['name']
        if self._under_way(name):               # its bag holds the truth
            return _plain(409, 'this run is still under way')
        try:
            body = await review.load(self._runs, name)
        except FileNotFoundError:
            return _plain(404, 'no such run')
        except BadInput as error:
            return _plain(422, str(error))
        response = web.Response(body=body, content_type='application/json')
        response.enable_compression()
        return response

    def _under_way(self, name: str) -> bool:
        return self.hub.phase in ('starting', 'flying', 'closing') and name == self.hub.run_name

    # -- sockets --------------------------------------------------------------------------

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        offered = [word.strip() for word in
                   request.headers.get('Sec-WebSocket-Protocol', '').split(',')]
        refused = self._refuse_stranger(token_of(offered))
        if refused is not None:
            return refused
        client = self.hub.join()
        if client is None:
            return _plain(503, 'no room: 50 pages watch already')
        socket = web.WebSocketResponse(protocols=(SUBPROTOCOL,), max_msg_size=MAX_FRAME,
                                       heartbeat=HEARTBEAT_S, compress=False)
        sender = None
        try:
            await socket.prepare(request)
            client.cut = lambda: _cut(request)
            sender = asyncio.create_task(self._send(socket, client))
            async for message in socket:
                if message.type == WSMsgType.BINARY:
                    self.hub.stick(client, message.data)
                elif message.type == WSMsgType.TEXT:
                    self.hub.request(client, message.data)
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


class _NoRoom(asyncio.Protocol):
    """Turns a connection away."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        transport.abort()


def _cut(request: web.Request) -> None:
    if request.transport is not None:
        request.transport.abort()


def _bearer(request: web.Request) -> str | None:
    scheme, _, token = request.headers.get('Authorization', '').partition(' ')
    return token if scheme == 'Bearer' else None


def _plain(status: int, text: str) -> web.Response:
    return web.Response(status=status, text=text + '\n', headers=HEADERS)
