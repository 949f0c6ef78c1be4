"""
How a run's `console` joins the console process that outlives runs: one local socket per run.

The one that joins sends its ROS arguments and waits; when it goes, its run's node goes. The
console answers with one line of JSON, `{"code": 0}`, when that node has ended by itself.
"""

import asyncio
import json
import os
import signal
import socket
import sys
from pathlib import Path
from typing import Awaitable, Callable

MAX_LINE = 1 << 20              # [bytes]


def join(path: str, arguments: list[str]) -> int:
    """Join the console at `path` for one run; return the exit code when that is over."""
    signal.signal(signal.SIGTERM, lambda *_: os._exit(0))
    signal.signal(signal.SIGINT, lambda *_: os._exit(0))
    try:
        with socket.socket(socket.AF_UNIX) as line:
            line.connect(path)
            line.sendall(json.dumps({'arguments': arguments}).encode() + b'\n')
            answer = b''
            while not answer.endswith(b'\n'):
                part = line.recv(65536)
                if not part:
                    break
                answer += part
    except OSError as error:
        print(f'console: cannot join the console at {path}: {error.strerror}', file=sys.stderr)
        return 2
    if not answer:
        print('console: the console process has gone', file=sys.stderr)
        return 1
    told = json.loads(answer)
    if told.get('text'):
        print(f'console: {told["text"]}', file=sys.stderr)
    return int(told['code'])


async def listen(path: Path, serve: Callable[[list[str], asyncio.Event], Awaitable[tuple]]
                 ) -> asyncio.AbstractServer:
    """
    Take runs that want to join, at a socket that only this user can open.

    `serve(arguments, gone)` runs one node until it ends or `gone` is set and returns
    (exit code, text).
    """
    async def handle(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            arguments = json.loads(await reader.readline())['arguments']
        except (ValueError, KeyError, TypeError):
            writer.close()
            return
        gone = asyncio.Event()

        async def until_closed() -> None:
            await reader.read()
            gone.set()
        watcher = asyncio.create_task(until_closed())
        code, text = await serve(arguments, gone)
        watcher.cancel()
        try:
            writer.write(json.dumps({'code': code, 'text': text}).encode() + b'\n')
            await writer.drain()
            writer.close()
        except ConnectionError:
            pass

    old = os.umask(0o077)
    try:
        return await asyncio.start_unix_server(handle, str(path), limit=MAX_LINE)
    finally:
        os.umask(old)
