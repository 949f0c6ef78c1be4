"""A `fly` with a console that is killed takes the console and every node with it."""

import asyncio
from contextlib import suppress
import json
import os
from pathlib import Path
import signal
from threading import Thread
import urllib.request
import uuid

import aiohttp
import pytest
from console_page import Console
from runs import in_flight, wait_for
from test_outlives import KILLED_S, left_after, MARK, marked

pytestmark = [pytest.mark.slow, pytest.mark.patient]


async def start_a_run(console: Console) -> str:
    """Take the stick and start a run, as a page does; return its folder's name."""
    base = console.url.split('/#')[0]
    async with aiohttp.ClientSession() as session, session.ws_connect(
            base + '/ws', protocols=('rvd.console.1', 'token.' + console.token),
            headers={'Origin': base}) as socket:
        for number, do in enumerate(('take', 'fly'), 1):
            await socket.send_str(json.dumps({'do': do, 'id': number}))
        while True:
            told = json.loads((await socket.receive(90.0)).data)
            if told['type'] == 'frame':
                return await _name(socket)


async def _name(socket) -> str:
    await socket.send_str(json.dumps({'do': 'drop', 'id': 3}))      # a status comes of that
    while True:
        told = json.loads((await socket.receive(90.0)).data)
        if told['type'] == 'status' and told['run']:
            return told['run']


@pytest.mark.parametrize('when', ['idle', 'in flight'])
def test_fly_with_a_console_that_is_killed_leaves_nothing(tmp_path, monkeypatch, when):
    mark = uuid.uuid4().hex
    monkeypatch.setenv(MARK, mark)
    console = Console(tmp_path, 'hand')
    try:
        if when == 'in flight':
            in_flight(tmp_path / 'runs' / asyncio.run(start_a_run(console)))
            wait_for(lambda: len(marked(mark)) > 5, 'the nodes')
        assert any('console.main' in line for line in marked(mark).values())
        console.process.send_signal(signal.SIGKILL)
        console.process.wait()
        assert left_after(KILLED_S, mark) == {}
    finally:
        for pid in marked(mark):
            os.kill(pid, signal.SIGKILL)
        console.close()


def test_who_reads_a_bag_for_a_review_ends_with_the_console(tmp_path, monkeypatch):
    """The bag is a pipe that brings nothing, so that its reader would wait for ever."""
    mark = uuid.uuid4().hex
    monkeypatch.setenv(MARK, mark)
    console = Console(tmp_path, 'hand')
    run = tmp_path / 'runs' / 'slow'
    (run / 'bag').mkdir(parents=True)
    (run / 'verdict.json').write_text('{}')
    os.mkfifo(run / 'bag' / 'a.mcap')
    asking = Thread(target=ask_for, args=(console, '/api/runs/slow'))
    asking.start()
    try:
        pid = wait_for(lambda: next((pid for pid, line in marked(mark).items()
                                     if 'report.replay' in line and reads(pid)), None),
                       'the reader of a bag')
        console.process.send_signal(signal.SIGKILL)
        console.process.wait()
        assert pid not in left_after(KILLED_S, mark)
    finally:
        for pid in marked(mark):
            os.kill(pid, signal.SIGKILL)
        console.close()
        asking.join()


def reads(pid: int) -> bool:
    """Say whether a reader has begun: it limits its own processor time before it reads."""
    limits = Path(f'/proc/{pid}/limits').read_text()
    return 'Max cpu time              unlimited' not in limits


def ask_for(console: Console, path: str) -> None:
    request = urllib.request.Request(f'http://{console.address}{path}',
                                     headers={'Authorization': f'Bearer {console.token}'})
    with suppress(OSError):                     # it ends meanwhile
        urllib.request.urlopen(request, timeout=60.0)
