"""
The server under attack by who has no token: pages load, sticks get through, nothing is printed.

What is said here is bytes of its own making on plain sockets, so that nothing mends it on its way.
"""

import asyncio
import contextlib
import json
import logging
import os
import random
import socket
import subprocess
import sys

import aiohttp
import pytest
from test_console_server import ask, House, run, stick

from rvd_groundstation.console import door, review, server
from rvd_groundstation.console.access import HEADERS, Throttle

PAGE = ('/', '/assets/index.js', '/assets/index.css', '/assets/main.js', '/assets/main.css',
        '/assets/link.worker.js', '/assets/icon.svg')
ATTACKERS, LOADS = 20, 10
UPGRADE = ('Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n'
           'Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n')


async def say(house, data, patience=5.0):
    """Send bytes on a connection of their own; return all that is answered until it closes."""
    reader, writer = await asyncio.open_connection('127.0.0.1', house.server.access.port)
    answer = b''
    with contextlib.suppress(ConnectionError, asyncio.TimeoutError):
        writer.write(data)
        await writer.drain()
        while part := await asyncio.wait_for(reader.read(65536), patience):
            answer += part
    writer.close()
    return answer


def request(house, path='/', method='GET', host=None, *lines):
    head = [f'{method} {path} HTTP/1.1', f'Host: {host or house.base[7:]}', *lines]
    return ('\r\n'.join(head) + '\r\n').encode('utf-8', 'surrogateescape')


def is_protected(answer):
    """Say whether an answer carries the protecting headers."""
    head = answer.split(b'\r\n\r\n')[0].decode('latin-1').lower()
    return all(f'{name}: {value}'.lower() in head for name, value in HEADERS.items())


# -- who has no token starves nobody --------------------------------------------------------

ATTACKS = {
    'page': lambda house: request(house) + b'\r\n',
    'bundle': lambda house: request(house, '/assets/main.js') + b'\r\n',
    'no token': lambda house: request(house, '/api/runs') + b'\r\n',
    'wrong token': lambda house: request(
        house, '/ws', 'GET', None, f'Origin: {house.base}',
        'Sec-WebSocket-Protocol: rvd.console.1, token.no') +
        UPGRADE.encode() + b'\r\n',
    'other host': lambda house: request(house, '/', 'GET', 'evil.example') + b'\r\n',
    'garbage': lambda house: b'\x16\x03\x01' + bytes(range(256)) + b'\r\n\r\n',
    'half': lambda house: request(house)[:20],
}


async def hammer(house, data, over):
    """Say the same again and again, each time as soon as there is an answer, until it is over."""
    while not over.is_set():
        with contextlib.suppress(ConnectionError, asyncio.TimeoutError):
            reader, writer = await asyncio.open_connection('127.0.0.1', house.server.access.port)
            with contextlib.closing(writer):
                while not over.is_set():
                    writer.write(data)
                    if not await asyncio.wait_for(reader.read(1 << 20), 0.5):
                        break


async def loads(house):
    """Load the page as a browser does, on new connections; return whether all of it came."""
    async with aiohttp.ClientSession() as fresh:
        async def get(path):
            async with fresh.get(house.base + path) as answer:
                return answer.status == 200 and bool(await answer.read())
        try:
            return await get('/') and all(await asyncio.gather(*map(get, PAGE[1:])))
        except aiohttp.ClientError:
            return False


@contextlib.asynccontextmanager
async def attacked(house, kinds):
    over = asyncio.Event()
    tasks = [asyncio.create_task(hammer(house, ATTACKS[kinds[i % len(kinds)]](house), over))
             for i in range(ATTACKERS)]
    await asyncio.sleep(0.5)
    try:
        yield
    finally:
        over.set()
        await asyncio.gather(*tasks)


@pytest.mark.parametrize('kinds', [['page'], ['wrong token', 'no token', 'other host'],
                                   sorted(ATTACKS)], ids=['page', 'refused', 'all'])
def test_a_page_loads_each_time_and_the_pilot_flies_while_twenty_without_a_token_ask(kinds):
    async def work():
        async with House() as house, house.socket() as pilot:
            await ask(pilot, do='take')
            async with attacked(house, kinds):
                for n in range(LOADS if len(kinds) == 1 else 3):
                    assert await loads(house), n
                    await pilot.send_bytes(stick(x=0.5, sequence=n))
                    assert (await ask(pilot, do='resume'))['ok']
                async with house.socket() as another:       # with the token, in the middle of it
                    assert (await ask(another, do='ping'))['ok']
            assert len(house.graph.sticks) >= 3
    run(work())


def test_twin_one_budget_for_all_who_ask_keeps_the_page_from_loading(monkeypatch):
    """As it was: a throttle before anything is checked. Then hardly a page loads."""
    throttle = Throttle(60.0, 200.0)
    checked = server.Server._guard

    @aiohttp.web.middleware
    async def guard(self, request, handler):
        if not throttle.allow(asyncio.get_running_loop().time()):
            return door.Answer(429, 'too many requests')
        return await checked(self, request, handler)
    monkeypatch.setattr(server.Server, '_guard', guard)

    async def work():
        async with House() as house:
            async with attacked(house, ['page', 'no token']):
                await asyncio.sleep(1.5)                    # the burst is used up
                assert [await loads(house) for _ in range(4)].count(True) < 2
    run(work())


def test_a_token_that_is_right_is_let_in_whoever_has_guessed_wrong(monkeypatch):
    async def work():
        async with House() as house:
            codes = [(await say(house, request(house, '/api/runs') + b'\r\n'))[9:12]
                     for _ in range(30)]
            assert codes[:5] == [b'403'] * 5 and codes[-1] == b'429'
            good = f'Authorization: Bearer {house.server.access.token}'
            answer = await say(house, request(house, '/api/runs', 'GET', None, good,
                                              'Connection: close') + b'\r\n')
            assert answer.startswith(b'HTTP/1.1 200')
            assert house.server.door.refused == {door.STRANGER: 30}
    run(work())


def test_connections_come_in_at_a_pace_and_nobody_is_turned_away(monkeypatch):
    monkeypatch.setattr(door, 'CONNECT_RATE', 20.0)
    monkeypatch.setattr(door, 'CONNECT_BURST', 1.0)

    async def work():
        async with House() as house:
            clock = asyncio.get_running_loop().time
            begun = clock()
            ask_once = request(house, '/', 'GET', None, 'Connection: close') + b'\r\n'
            answers = await asyncio.gather(*(say(house, ask_once) for _ in range(20)))
            assert all(answer.startswith(b'HTTP/1.1 200') for answer in answers)
            assert clock() - begun > 0.8
    run(work())


def test_who_has_shown_the_token_is_never_put_out_and_who_is_answered_comes_last(monkeypatch):
    monkeypatch.setattr(door, 'MAX_CONNECTIONS', 3)

    async def work():
        async with House() as house, house.socket() as pilot:
            async with house.session.get(house.base + '/') as answer:       # stays open, idle
                assert answer.status == 200
            for _ in range(20):
                _, writer = await asyncio.open_connection(
                    '127.0.0.1', house.server.access.port)
                assert (await say(house, request(house, '/', 'GET', None, 'Connection: close')
                                  + b'\r\n')).startswith(b'HTTP/1.1 200')
                writer.close()
            assert (await ask(pilot, do='take'))['ok']
    run(work())


def test_who_reads_no_answer_is_cut_off_and_who_sends_no_rest_is_not_waited_for(monkeypatch):
    monkeypatch.setattr(door, 'SEND_S', 0.3)
    monkeypatch.setattr(server, 'FILE_BURST', 1e6)

    async def work():
        async with House() as house:
            clock = asyncio.get_running_loop().time
            reader, writer = await asyncio.open_connection(
                '127.0.0.1', house.server.access.port, limit=1)
            writer.write(30 * (request(house, '/assets/main.js') + b'\r\n'))
            await asyncio.sleep(0.1)
            while not reader.at_eof() and house.server.door._visitors:
                await asyncio.sleep(0.05)
            assert house.server.door.refused[door.SLOW] == 1
            writer.close()
            begun = clock()
            answer = await say(house, request(house, '/', 'GET', None, 'Content-Length: 1000')
                               + b'\r\nless')
            assert answer.startswith(b'HTTP/1.1 200') and clock() - begun < 4.0
    run(work())


# -- bad tokens ----------------------------------------------------------------------------

BAD = 't\udcc5\udc99\udcff\u0159'               # bytes that are UTF-8, and some that are not


@pytest.mark.parametrize('path, lines', [
    ('/api/runs', [f'Authorization: Bearer {BAD}']), (f'/api/runs?token={BAD}', []),
    ('/api/runs', [f'Cookie: token={BAD}; {BAD}={BAD}']), ('/api/runs/%FF%00', []),
    ('/ws', ['ORIGIN', f'Sec-WebSocket-Protocol: rvd.console.1, token.{BAD}']),
    ('/ws', [f'Origin: http://{BAD}']), ('/', [f'Origin: {BAD}'])])
def test_a_token_that_is_not_ascii_is_refused_with_the_headers_kept(path, lines):
    async def work():
        async with House() as house:
            lines_sent = [f'Origin: {house.base}' if line == 'ORIGIN' else line for line in lines]
            answer = await say(house, request(house, path, 'GET', None, *lines_sent)
                               + UPGRADE.encode() + b'\r\n')
            assert answer[9:12] in (b'403', b'400'), answer[:200]
            assert answer[9:12] == b'403' or '?' in path        # a target must be ASCII
            assert is_protected(answer), answer
    run(work())


# -- what is no HTTP ---------------------------------------------------------------------------

def bad(house):
    """Yield bad requests, and the status of the answer: None where it may be cut off in silence."""
    good, end = request(house), b'\r\n'
    yield b'GET /\r\n\r\n', 403                                 # HTTP/0.9: it has no Host
    yield b'\x00\xff\xfe garbage \x1b[31m\r\n\r\n', 400
    yield b'\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03' + bytes(40), None     # TLS
    yield b'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n', None
    yield good + b'X: ' + b'x' * 100_000 + b'\r\n' + end, 400
    yield good + b''.join(b'X%d: x\r\n' % i for i in range(5000)) + end, 400
    yield b'GET /' + b'a' * 100_000 + b' HTTP/1.1\r\nHost: x\r\n\r\n', 400
    yield good + b'Content-Length: 5\r\nTransfer-Encoding: chunked\r\n' + end + b'0\r\n\r\n', 400
    yield good + b'Content-Length: 5\r\nContent-Length: 6\r\n' + end + b'hello', 400
    yield good + b'Content-Length: -1\r\n' + end, 400
    yield good + b'Content-Length: +5\r\n' + end + b'hello', 400
    yield good + b'Transfer-Encoding: chunked\r\n' + end + b'zz\r\n', None
    yield good + b'Transfer-Encoding: chunked, identity\r\n' + end, None
    yield good + b' folded: yes\r\n' + end, None
    yield good + b'no colon\r\n' + end, 400
    yield good + b'Bad\x00Name: x\r\n' + end, 400
    yield good + b'Host: evil.example\r\n' + end, None          # two hosts
    yield request(house, 'http://[::1', 'GET') + end, None
    yield request(house, '*', 'OPTIONS') + end, None
    yield request(house, '/', 'DELETE') + end, 405
    yield request(house, '/', 'BREW') + end, None
    yield request(house, '/', 'POST') + b'Expect: 100-continue\r\nContent-Length: 9\r\n' + end, None
    yield good + b'Expect: nonsense\r\n' + end, 417
    yield good + b'Content-Encoding: gzip\r\nContent-Length: 4\r\n' + end + b'nono', None
    yield good + b'Range: bytes=9-1\r\n' + end, None
    yield good + b'If-Modified-Since: never\r\n' + end, None
    yield request(house, '/%ff%fe%00') + end, None


def fine(answer):
    return answer.startswith((b'HTTP/1.1 200', b'HTTP/1.1 206'))


@pytest.fixture
def printed(capfd, caplog):
    """Return what has reached the terminal or a log so far."""
    logging.getLogger('aiohttp').setLevel(logging.NOTSET)

    def so_far():
        out, err = capfd.readouterr()
        return out + err + '\n'.join(r.getMessage() for r in caplog.records)
    return so_far


def test_what_is_no_http_is_answered_counted_and_not_printed(printed):
    async def work():
        async with House() as house, house.socket() as pilot:
            for n, (data, status) in enumerate(bad(house)):
                before = house.server.door.refused.total()
                answer = await say(house, data, 0.4 if status is None else 5.0)
                if status is not None:
                    assert answer[9:12] == b'%d' % status, (n, data[:60], answer[:100])
                if answer:
                    first = answer.split(b'HTTP/1.1 100 Continue\r\n\r\n')[-1]
                    assert is_protected(first), (n, data[:60], answer)
                    assert b'Traceback' not in answer and not answer.startswith(b'HTTP/1.1 500')
                    assert fine(answer) or b' 404 ' in answer or (
                        house.server.door.refused.total() > before), (n, data[:60], answer[:80])
                assert (await ask(pilot, do='ping'))['ok']
            words = house.server.door.in_words()
            assert words.startswith('console refused ') and f' {door.BAD_HTTP}' in words
    run(work())
    assert printed() == ''


def test_random_bytes_and_damaged_requests_leave_the_server_as_it_was(printed):
    rng = random.Random(16)

    async def work():
        async with House() as house, house.socket() as pilot:
            whole = request(house, '/ws', 'GET', None, f'Origin: {house.base}',
                            'Sec-WebSocket-Protocol: rvd.console.1, token.no') \
                + UPGRADE.encode() + b'Content-Length: 3\r\n\r\nabc'
            said = []
            for _ in range(150):
                data = bytearray(whole)
                for _ in range(rng.randint(1, 6)):
                    where = rng.randrange(len(data))
                    data[where:where + rng.randint(0, 3)] = rng.randbytes(rng.randint(0, 4))
                said.append(bytes(data) if rng.random() < 0.8 else rng.randbytes(200))
            answers = await asyncio.gather(*(say(house, data, 0.5) for data in said))
            assert not [a for a in answers if a.startswith((b'HTTP/1.1 500', b'HTTP/1.1 101'))]
            assert (await ask(pilot, do='take'))['ok'] and await loads(house)
    run(work())
    assert printed() == ''


def test_what_is_smuggled_behind_a_request_is_a_request_of_its_own_or_none():
    """There is one answer to each request, and a second one needs the token for itself."""
    async def work():
        async with House() as house:
            inner = request(house, '/api/runs') + b'\r\n'
            body = b'Content-Length: %d\r\n\r\n' % len(inner)
            answer = await say(house, request(house) + body + inner, 1.5)
            assert answer.count(b'HTTP/1.1 ') == 1
            good = f'Authorization: Bearer {house.server.access.token}'
            answer = await say(house, request(house, '/api/runs', 'GET', None, good) + b'\r\n'
                               + inner, 1.5)
            assert answer.count(b'HTTP/1.1 200') == 1 and b'HTTP/1.1 403' in answer
    run(work())


def frame(opcode, payload=b'', fin=1, mask=b'\0\0\0\0', length=None, rsv=0):
    """Return a frame of a socket; `mask` None: not masked, which a client must not do."""
    size = len(payload) if length is None else length
    head = bytes([fin << 7 | rsv << 4 | opcode])
    bit = 0 if mask is None else 128
    head += (bytes([bit | size]) if size < 126 else bytes([bit | 126]) + size.to_bytes(2, 'big')
             if size < 1 << 16 else bytes([bit | 127]) + size.to_bytes(8, 'big'))
    return head + (mask or b'') + payload


FRAMES = {
    'reserved opcode': frame(3, b'x'), 'reserved bits': frame(1, b'x', rsv=4),
    'oversize': frame(2, b'x', length=1 << 62), 'large': frame(1, b'x' * 70_000),
    'no UTF-8': frame(1, b'\xff\xfe'), 'long ping': frame(9, b'x' * 200),
    'ping in parts': frame(9, b'x', fin=0), 'continuation of nothing': frame(0, b'x'),
    'bad close': frame(8, b'\x00'), 'close with a bad code': frame(8, b'\x00\x01'),
    'in parts for ever': frame(1, b'x' * 60_000, fin=0) + 2 * frame(0, b'x' * 60_000, fin=0)}


@pytest.mark.parametrize('name', sorted(FRAMES))
def test_a_bad_frame_closes_its_page_alone_and_is_counted(name, printed):
    async def work():
        async with House() as house, house.socket() as pilot:
            shake = request(house, '/ws', 'GET', None, f'Origin: {house.base}',
                            'Sec-WebSocket-Protocol: rvd.console.1, token.'
                            + house.server.access.token) + UPGRADE.encode() + b'\r\n'
            answer = await say(house, shake + FRAMES[name])
            assert answer.startswith(b'HTTP/1.1 101')
            assert len(house.hub.pages.clients) == 1
            assert (await ask(pilot, do='take'))['ok']
            assert house.server.door.refused == {door.BAD_FRAME: 1}
    run(work())
    assert printed() == ''


@pytest.mark.parametrize('lines', [
    'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n'
    'Sec-WebSocket-Key: short\r\n',
    'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n'
    'Sec-WebSocket-Key: \udcc5\udc99\udcff\r\n',
    'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n',
    'Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 99\r\n'
    'Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n', '', 'Upgrade: h2c\r\n'])
def test_a_bad_handshake_is_refused_and_leaves_nobody_in_the_house(lines, printed):
    async def work():
        async with House() as house:
            answer = await say(house, request(
                house, '/ws', 'GET', None, f'Origin: {house.base}',
                f'Sec-WebSocket-Protocol: rvd.console.1, token.{house.server.access.token}')
                + lines.encode('utf-8', 'surrogateescape') + b'\r\n')
            assert answer.startswith(b'HTTP/1.1 400') and is_protected(answer)
            assert not house.hub.pages.clients and house.server.door.refused == {door.BAD_HTTP: 1}
    run(work())
    assert printed() == ''


def test_a_fault_of_ours_keeps_its_traceback_and_the_headers(caplog, monkeypatch):
    monkeypatch.setattr(review, 'listing', lambda runs: 1 / 0)

    async def work():
        async with House() as house:
            good = f'Authorization: Bearer {house.server.access.token}'
            answer = await say(house, request(house, '/api/runs', 'GET', None, good) + b'\r\n')
            assert answer.startswith(b'HTTP/1.1 500') and is_protected(answer)
    run(work())
    assert 'ZeroDivisionError' in caplog.text


# -- reviews -------------------------------------------------------------------------------

def test_two_reviews_are_prepared_at_a_time_some_wait_and_the_rest_are_told_when(
        tmp_path, monkeypatch):
    """The reader here is a process that waits to be let go, and says that it has begun."""
    reader = ('import pathlib, sys, time; top = pathlib.Path(sys.argv[1]); '
              '(top / ("begun" + sys.argv[2])).touch()\n'
              'while not (top / "go").exists(): time.sleep(0.02)\nprint("{}")')
    monkeypatch.setattr(review, 'READER', (sys.executable, '-c', reader))

    async def work():
        async with House(tmp_path) as house, house.socket() as pilot:
            house.hub.end()
            bearer = {'Authorization': f'Bearer {house.server.access.token}'}

            async def get(name):
                async with house.session.get(f'{house.base}/api/runs/{name}',
                                             headers=bearer) as answer:
                    return answer.status, answer.headers.get('Retry-After')
            asked = [asyncio.create_task(get(n)) for n in range(10)]
            while sum(task.done() for task in asked) < 4 or len(begun()) < 2:
                assert (await ask(pilot, do='ping'))['ok']
                await asyncio.sleep(0.02)
            assert [task.result() for task in asked if task.done()] == [(503, '5')] * 4
            await asyncio.sleep(0.3)
            assert len(begun()) == 2
            (tmp_path / 'go').touch()
            assert sorted(await asyncio.gather(*asked)) == [(200, None)] * 6 + [(503, '5')] * 4

    def begun():
        return list(tmp_path.glob('begun*'))
    run(work())


def test_a_review_that_takes_too_long_is_ended(tmp_path, monkeypatch):
    reader = ('import os, pathlib, sys, time; '
              'pathlib.Path(sys.argv[1], "pid").write_text(str(os.getpid())); time.sleep(60)')
    monkeypatch.setattr(review, 'READER', (sys.executable, '-c', reader))
    monkeypatch.setattr(server, 'REVIEW_S', 1.0)

    async def work():
        async with House(tmp_path) as house:
            house.hub.end()
            good = f'Authorization: Bearer {house.server.access.token}'
            answer = await say(house, request(house, '/api/runs/x', 'GET', None, good,
                                              'Connection: close') + b'\r\n', 20.0)
            assert b'422' in answer[:20] and b'within 1 s' in answer
            await asyncio.sleep(0.2)
    run(work())
    pid = (tmp_path / 'pid').read_text()
    with pytest.raises(FileNotFoundError):
        open(f'/proc/{pid}/stat')


def test_the_list_of_runs_leaves_out_what_is_no_verdict(tmp_path):
    for name in ('good', 'fifo', 'deep', 'list', 'huge', 'nowhere', 'nan'):
        (tmp_path / name).mkdir()
    (tmp_path / 'good/verdict.json').write_text('{"reason": "docked", "seed": 3}')
    (tmp_path / 'nan/verdict.json').write_text('{"reason": "docked", "seed": NaN}')
    os.mkfifo(tmp_path / 'fifo/verdict.json')
    (tmp_path / 'deep/verdict.json').write_text('[' * 100_000)
    (tmp_path / 'list/verdict.json').write_text('[1]')
    (tmp_path / 'huge/verdict.json').write_text(json.dumps({'reason': 'x' * (2 << 20)}))
    (tmp_path / 'nowhere/verdict.json').symlink_to(tmp_path / 'no')

    async def work():
        async with House(tmp_path) as house:
            good = f'Authorization: Bearer {house.server.access.token}'
            answer = await say(house, request(house, '/api/runs', 'GET', None, good,
                                              'Connection: close') + b'\r\n')
            return json.loads(answer.split(b'\r\n\r\n')[1], parse_constant=lambda _: 1 / 0)
    rows = {row['name']: row for row in run(work())}
    assert set(rows) == {'good', 'nan'} and rows['nan']['seed'] is None


# -- what is told in the end -----------------------------------------------------------------

def test_a_console_tells_who_has_started_it_what_it_refused(tmp_path):
    console = subprocess.Popen(
        [sys.executable, '-m', 'rvd_groundstation.console.main', '--serve', '--socket',
         str(tmp_path / 'socket'), '--runs', str(tmp_path), '--port', '0'], text=True,
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        url = json.loads(console.stdout.readline())['url']
        port = int(url.split(':')[2].split('/')[0])
        for data in (b'\0\x1b[31m\r\n\r\n', b'GET /ws HTTP/1.1\r\nHost: evil\r\n\r\n'):
            with socket.create_connection(('127.0.0.1', port), timeout=10.0) as line:
                line.sendall(data)
                assert line.recv(1 << 16)
    finally:
        out, err = console.communicate(timeout=20.0)
    assert json.loads(out)['refused'] == (
        'console refused 2 requests: 1 no HTTP, 1 for another Host or from another Origin')
    assert err == ''
