"""A `fly` with a console that is killed takes the console and every node with it."""

import asyncio
import json
import os
import signal
import subprocess
import sys
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


def test_who_reads_a_bag_for_a_review_ends_with_the_console(tmp_path):
    """The reader as it is, but that it has begun for good when it makes itself nice."""
    mark, begun = uuid.uuid4().hex, tmp_path / 'begun'
    reader = ('import os, pathlib, runpy, time\n'
              f'os.nice = lambda n: (pathlib.Path({str(begun)!r}).touch(), time.sleep(600))\n'
              'runpy.run_module("rvd_campaign.report.replay", run_name="__main__")')
    console = subprocess.Popen(
        [sys.executable, '-c', 'import asyncio, pathlib, sys\n'
         'from rvd_groundstation.console import review\n'
         f'review.READER = (sys.executable, "-c", {reader!r})\n'
         'asyncio.run(review.load(pathlib.Path("."), "run"))'],
        cwd=tmp_path, env={**os.environ, MARK: mark})
    try:
        wait_for(begun.exists, 'the reader of a bag', 60.0)
        console.kill()
        console.wait()
        assert left_after(KILLED_S, mark) == {}
    finally:
        for pid in marked(mark):
            os.kill(pid, signal.SIGKILL)
