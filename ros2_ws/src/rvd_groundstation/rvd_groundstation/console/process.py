"""
The console's process: web server on the event loop, one rclpy thread per run beside it.

Speaks with `./rvd fly`, which starts it, in lines of JSON: out {"url"}, {"do": "fly" | "stop" |
"quit", ...} and at the end {"refused"}; in {"phase", "note"}. When its standard input ends, it
ends. With {"url"} comes {"watch"}, the address for those who only watch.
"""

import argparse
import asyncio
import json
import signal
import sys
import threading
from pathlib import Path
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.console.attach import listen
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.server import Address, Server

SWITCH_S = 0.0005               # [s] a thread of ROS hands the interpreter on this soon


async def serve(arguments: list[str]) -> int:
    """Serve until told to stop; return the exit code."""
    sys.setswitchinterval(SWITCH_S)
    if '--serve' in arguments:
        return await _serve_runs(_options(arguments))
    return await _serve_one(arguments)


def _options(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog='console')
    parser.add_argument('--serve', action='store_true')
    parser.add_argument('--socket', type=Path, required=True)
    parser.add_argument('--runs', type=Path)
    parser.add_argument('--session', type=Path)
    parser.add_argument('--display', type=Path)
    parser.add_argument('--bind', default='127.0.0.1')
    parser.add_argument('--port', type=int, default=8480)
    parser.add_argument('--tls-cert', default='')
    parser.add_argument('--tls-key', default='')
    return parser.parse_args(arguments)


async def _serve_runs(options: argparse.Namespace) -> int:
    """Serve run after run; `fly` at the other end of our pipes starts them."""
    desk = None
    if options.session is not None:
        from rvd_groundstation.console.desk import Desk, read_session
        desk = Desk(read_session(options.session), options.runs)
    shown = {}
    if options.display is not None:
        shown = json.loads(options.display.read_text(encoding='utf-8'))
    hub = Hub(ask=say, desk=desk, **shown)
    server = Server(hub, Address(options.bind, options.port, options.tls_cert, options.tls_key),
                    options.runs)
    from rvd_groundstation.console import node  # noqa: F401 - loaded now, not in a flight
    url = await server.start()
    runs = await listen(options.socket, lambda words, gone: run_node(hub, words, gone))
    say({'url': url, 'watch': server.access.watch_url})
    await _heed(hub)
    runs.close()
    await server.stop()
    say({'refused': server.door.in_words()})
    return 0


async def _heed(hub: Hub) -> None:
    """Follow what `fly` says until it says no more."""
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader()
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    stop = asyncio.Event()
    for number in (signal.SIGTERM, signal.SIGINT):
        loop.add_signal_handler(number, stop.set)
    stopped = asyncio.create_task(stop.wait())
    while True:
        line = asyncio.create_task(reader.readline())
        await asyncio.wait({line, stopped}, return_when=asyncio.FIRST_COMPLETED)
        if stopped.done() or not line.result():
            return
        told = json.loads(line.result())
        hub.told(told['phase'], told['note'], told['run'])


def say(message: dict[str, Any]) -> None:
    """Write one line to `fly`."""
    print(json.dumps(message), flush=True)


async def _serve_one(arguments: list[str]) -> int:
    """Serve the one run that our own ROS arguments describe."""
    from rvd_groundstation.console.node import own_settings
    params = own_settings(arguments)
    hub = Hub()
    server = Server(hub, Address(params.bind, params.port, params.tls_cert, params.tls_key), None)
    print(f'open {await server.start()}\nwatch {server.access.watch_url}', flush=True)
    gone = asyncio.Event()
    for number in (signal.SIGTERM, signal.SIGINT):
        asyncio.get_running_loop().add_signal_handler(number, gone.set)
    code, text = await run_node(hub, arguments, gone)
    if text:
        print(f'console: {text}', file=sys.stderr)
    await server.stop()
    if server.door.refused:
        print(server.door.in_words(), flush=True)
    return code


async def run_node(hub: Hub, arguments: list[str], gone: asyncio.Event) -> tuple[int, str]:
    """Run one run's node on a thread of its own until it ends or `gone` is set."""
    from rvd_groundstation.console.node import follow
    loop = asyncio.get_running_loop()
    over: asyncio.Future = loop.create_future()
    stop = threading.Event()

    def finish(result: tuple[int, str]) -> None:
        if not over.done():
            over.set_result(result)

    def work() -> None:
        try:
            follow(hub, arguments, stop.is_set, loop.call_soon_threadsafe)
            result = (0, '')
        except BadInput as error:
            result = (2, str(error))
        except Exception as error:              # noqa: B902 - told to whoever started the run
            result = (1, f'{type(error).__name__}: {error}')
        loop.call_soon_threadsafe(finish, result)
    thread = threading.Thread(target=work, name='rclpy', daemon=True)
    thread.start()
    leaving = asyncio.create_task(gone.wait())
    await asyncio.wait({over, leaving}, return_when=asyncio.FIRST_COMPLETED)
    stop.set()
    result = await over
    leaving.cancel()
    hub.end()
    return result
