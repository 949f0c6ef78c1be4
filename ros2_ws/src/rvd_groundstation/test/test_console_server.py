"""The server with pages but without ROS: sockets, lease, lost pages, slow watchers, limits."""

import asyncio
import json
from pathlib import Path
import ssl
import struct

import aiohttp
import pytest

from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.console import door, hub as hub_module
from rvd_groundstation.console import node as node_module
from rvd_groundstation.console import server
from rvd_groundstation.console.access import CONTENT_POLICY
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.protocol import encode
from rvd_groundstation.console.provider import display_of
from rvd_groundstation.console.server import Address, Server

SCENARIO = parse('/**: {ros__parameters: {}}', 'test')
TLS = Path(__file__).parent / 'tls'         # made for these tests, trusted by nobody else


class Graph:
    """Stands for the running graph: keeps what the hub asks of it."""

    def __init__(self):
        self.sticks, self.asked, self.events = [], [], []
        self.dead, self.replies = False, []     # dead: answers only when `replies` are called

    def joy(self, stick):
        self.sticks.append(stick)
        return [round(3 * a) for a in stick.deflection[:3]]

    def control(self, action, mode, reply):
        self.asked.append((action, mode))
        self.replies.append(reply)
        if not self.dead:
            reply(True, action)

    def event(self, code, text):
        self.events.append(code)


class House:
    """A server with a run under way."""

    def __init__(self, runs=None, address=Address(port=0), **hub):
        self.hub, self.graph, self.runs = Hub(**hub), Graph(), runs
        self.address = address

    async def __aenter__(self):
        self.server = Server(self.hub, self.address, self.runs)
        self.base = (await self.server.start()).split('/#')[0]
        self.session = aiohttp.ClientSession()
        self.hub.begin('run', display_of(SCENARIO), self.graph)
        return self

    async def __aexit__(self, *_):
        await self.session.close()
        await self.server.stop()

    def socket(self, token=None, **headers):
        token = self.server.access.token if token is None else token
        return self.session.ws_connect(
            self.base + '/ws', protocols=('rvd.console.1', 'token.' + token), autoping=True,
            headers={'Origin': self.base, **headers})


def stick(held=1, x=0.0, sequence=0):
    return struct.pack('<BBH6fd', 1, held, sequence, x, *[0.0] * 6)


def command(step, sequence, value=(0, 0, 0), by=0, weight=1.0):
    return Sample(step, 0.5 * step, True, {
        'value': list(value), 'kind': 0, 'by': by, 'weight': weight, 'reason': 0,
        'sequence': sequence})


async def ask(socket, **wish):
    """Send a request and return its reply."""
    await socket.send_str(json.dumps({'id': 5, **wish}))
    while True:
        message = json.loads((await socket.receive(5.0)).data)
        if message['type'] == 'reply':
            return message


def run(coroutine):
    return asyncio.run(asyncio.wait_for(coroutine, 30.0))


def test_w3_wrong_token_origin_and_host_open_no_socket():
    async def work():
        async with House() as house:
            for headers, token in (({}, 'wrong'), ({'Origin': 'http://evil.example'}, None),
                                   ({'Host': 'evil.example'}, None), ({'Origin': ''}, None)):
                with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                    await house.socket(token, **headers)
                assert refused.value.status == 403
            assert not house.hub.pages.clients
    run(work())


def test_answers_carry_the_policy_and_files_outside_are_not_served():
    async def work():
        async with House() as house:
            async with house.session.get(house.base + '/') as answer:
                assert answer.headers['Content-Security-Policy'] == CONTENT_POLICY
                assert answer.headers['X-Content-Type-Options'] == 'nosniff'
            for path in ('/assets/../../hub.py', '/assets/%2e%2e/%2e%2e/hub.py', '/hub.py'):
                async with house.session.get(house.base + path) as answer:
                    assert answer.status in (403, 404)
    run(work())


def test_a_page_knows_what_it_will_show_before_the_first_run():
    shown = as_data(display_of(SCENARIO).display)

    async def work():
        async with House(display=shown) as house, house.socket() as page:
            hello = json.loads((await page.receive(5.0)).data)
            assert hello['type'] == 'hello'
            assert hello['display'] == json.loads(encode(shown))
    run(work())


def test_only_the_lease_flies_and_abort_needs_none():
    async def work():
        async with House() as house, house.socket() as pilot, house.socket() as other:
            await other.send_bytes(stick(x=1.0))
            assert (await ask(other, do='mode', mode='auto'))['code'] == 'LEASE'
            assert (await ask(pilot, do='take'))['ok']
            assert (await ask(other, do='take'))['code'] == 'TAKEN'
            await pilot.send_bytes(stick(x=1.0, sequence=9))
            assert (await ask(pilot, do='mode', mode='auto'))['ok']
            assert (await ask(other, do='abort'))['ok']
            assert [s.sequence for s in house.graph.sticks] == [9]
            assert house.graph.asked == [('mode', 'auto'), ('abort', '')]
    run(work())


@pytest.mark.parametrize('action', ['abort', 'pause', 'mode'])
def test_a_request_that_the_graph_does_not_answer_is_said_to_be_unanswered(monkeypatch, action):
    monkeypatch.setattr(hub_module, 'ANSWER_S', 0.2)

    async def work():
        async with House() as house, house.socket() as page:
            await ask(page, do='take')
            house.graph.dead = True
            reply = await ask(page, do=action, mode='auto')
            assert (reply['id'], reply['ok'], reply['code']) == (5, False, 'NO_ANSWER')
            house.graph.replies[0](True, 'late')            # what is in force is shown all the same
            assert (house.hub.feed.paused, house.hub.feed.mode) == (
                action == 'pause', 'auto' if action == 'mode' else 'shared')
            house.graph.dead = False
            assert (await ask(page, do=action, mode='auto'))['ok']
            await asyncio.sleep(0.3)                        # and the time of an answer is over
            while True:
                try:
                    message = json.loads((await page.receive(0.2)).data)
                except asyncio.TimeoutError:
                    break
                assert message.get('code') != 'NO_ANSWER'
    run(work())


def test_an_abort_that_is_asked_again_does_not_reach_another_run():
    async def work():
        async with House() as house, house.socket() as page:
            assert (await ask(page, do='abort', run='before'))['code'] == 'NO_RUN'
            assert house.graph.asked == []
            assert (await ask(page, do='abort', run='run'))['ok']
    run(work())


@pytest.mark.parametrize('first, seen', [
    (('paused', True), lambda hub: hub.feed.paused),
    (('command', command(0, 7)), lambda hub: [r.sequence for r in hub.feed.ladder.rungs] == [7])])
def test_what_a_node_says_first_is_heard_in_its_run_and_in_no_other(first, seen):
    """The node's thread may post before the loop has run: nothing is lost, nothing comes early."""
    async def work():
        async with House() as house:
            old = house.hub.feed
            house.hub.post('begin', 'next', display_of(SCENARIO), Graph())
            house.hub.post(*first)
            await asyncio.sleep(0.2)
            assert house.hub.run_name == 'next' and house.hub.feed is not old and seen(house.hub)
            assert not old.paused and not old.ladder.rungs
    run(work())


def test_what_was_posted_before_there_was_a_loop_is_not_left_lying():
    async def work():
        hub = Hub()
        hub.post('begin', 'run', display_of(SCENARIO), Graph())
        pump = asyncio.create_task(hub.pump())
        await asyncio.sleep(0.1)
        assert hub.phase == 'flying'
        pump.cancel()
    run(work())


def test_a_node_begins_its_run_before_it_listens(monkeypatch):
    """Its thread does not wait for the loop, which is behind here until all has been said."""
    hub, later = Hub(), []

    class Node:
        provider = display_of(SCENARIO)

        def __init__(self, host, hub, call_soon):
            pass

        def connect(self):
            hub.post('paused', True)

        def leave(self):
            pass

    class Host:
        def __init__(self, given):
            pass

        def spin(self, stopped):
            pass

        close = leave = lambda self: None
    for name, value in (('ConsoleNode', Node), ('Host', Host), ('of_the_run', lambda a: a),
                        ('listen_for_the_end', lambda host: None)):
        monkeypatch.setattr(node_module, name, value)
    monkeypatch.setattr(node_module.rclpy, 'init', lambda **_: None)
    monkeypatch.setattr(node_module.rclpy, 'try_shutdown', lambda: None)
    node_module.follow(hub, [], lambda: True, lambda *call: later.append(call))
    for method, *args in later:
        method(*args)
    hub._drain()
    assert hub.phase == 'flying' and hub.feed.paused


def test_who_takes_the_stick_hears_the_whole_ladder():
    """Changes are told to pilot and watchers apart, so a watcher may have missed the pilot's."""
    async def work():
        async with House() as house, house.socket() as page:
            house.hub.post('command', command(0, 7, (1, 0, 0)))
            await ask(page, do='ping')
            await asyncio.sleep(0.1)            # the rung has gone out by now
            await page.send_str(json.dumps({'id': 5, 'do': 'take'}))
            heard = []
            while not heard or heard[-1]['type'] != 'reply':
                heard.append(json.loads((await page.receive(5.0)).data))
            ladders = [m['ladder'] for m in heard if m['type'] == 'ladder']
            assert len(ladders) == 1 and [rung[0] for rung in ladders[0]] == [7]
    run(work())


def test_o4_a_lost_page_lets_go_of_the_stick_at_once():
    async def work():
        async with House() as house:
            pilot = await house.socket()
            await ask(pilot, do='take')
            await pilot.send_bytes(stick(x=1.0))
            await ask(pilot, do='ping')
            await pilot.close()
            await asyncio.sleep(0.1)
            assert not house.graph.sticks[-1].held and house.hub.pilot_lost
            assert house.graph.events == ['PILOT_LOST'] and house.hub.lease.holder is None
    run(work())


def test_w1_too_large_and_too_many_frames_close_the_page_and_no_other():
    async def work():
        async with House() as house, house.socket() as quiet:
            big = await house.socket()
            await big.send_str('x' * 70_000)
            flood = await house.socket()
            for _ in range(2000):
                await flood.send_bytes(stick())
            for socket in (big, flood):
                while not (await socket.receive(5.0)).type.name.startswith('CLOS'):
                    pass
            assert (await ask(quiet, do='take'))['ok']
    run(work())


async def half_a_request(house):
    """Open a connection and send a request that does not end."""
    reader, writer = await asyncio.open_connection('127.0.0.1', house.server.access.port)
    writer.write(b'GET / HTTP/1.1\r\nHost: 127.0')
    await writer.drain()
    return reader, writer


async def cut_off(reader):
    try:
        return await asyncio.wait_for(reader.read(), 5.0) == b''
    except ConnectionResetError:
        return True


def test_w1_a_connection_that_never_finishes_asking_is_cut_off(monkeypatch):
    monkeypatch.setattr(door, 'ASK_S', 0.4)

    async def work():
        async with House() as house, house.socket() as pilot:
            slow = [await half_a_request(house) for _ in range(20)]
            assert all([await cut_off(reader) for reader, _ in slow])
            assert (await ask(pilot, do='take'))['ok']      # it has been there for as long
            for _, writer in slow:
                writer.close()
    run(work())


def test_w1_who_is_silent_for_longest_makes_room_for_who_comes():
    async def work():
        async with House() as house, house.socket() as pilot:
            held = [await half_a_request(house) for _ in range(door.MAX_CONNECTIONS)]
            assert await cut_off(held[0][0])                # one of all had no room
            async with house.session.get(house.base + '/') as answer:
                assert answer.status == 200                 # and who asks has
            assert (await ask(pilot, do='take'))['ok']
            assert not held[-1][0].at_eof()
            for _, writer in held:
                writer.close()
    run(work())


def test_beyond_loopback_pages_come_and_fly_by_tls_alone():
    address = Address('127.0.0.2', 0, str(TLS / 'cert.pem'), str(TLS / 'key.pem'))
    trusted = ssl.create_default_context(cafile=TLS / 'cert.pem')

    async def work():
        async with House(address=address) as house:
            assert house.base.startswith('https://127.0.0.2:')
            async with house.session.get(house.base + '/', ssl=trusted) as answer:
                assert answer.status == 200
            async with house.session.ws_connect(
                    house.base + '/ws', headers={'Origin': house.base}, ssl=trusted,
                    protocols=('rvd.console.1', 'token.' + house.server.access.token)) as pilot:
                assert (await ask(pilot, do='take'))['ok']
                await pilot.send_bytes(stick(x=1.0, sequence=3))
                await ask(pilot, do='ping')
                assert [s.sequence for s in house.graph.sticks] == [3]
            plain = house.base.replace('https', 'http')
            with pytest.raises(aiohttp.ClientError):
                await house.session.get(plain + '/')
            with pytest.raises(aiohttp.WSServerHandshakeError):
                await house.session.ws_connect(house.base + '/ws', headers={'Origin': plain},
                                               ssl=trusted)
    run(work())


def test_a_certificate_that_is_none_is_one_line(tmp_path):
    with pytest.raises(ValueError, match='cannot load the TLS certificate .*nowhere.pem'):
        Address('127.0.0.2', 0, str(tmp_path / 'nowhere.pem'), str(TLS / 'key.pem')).tls()


def test_there_is_room_for_fifty_watchers_and_a_pilot():
    async def work():
        async with House() as house:
            sockets = [await house.socket() for _ in range(51)]
            with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                await house.socket()
            assert refused.value.status == 503
            for socket in sockets:
                await socket.close()
    run(work())


def test_a_crowd_is_served_in_turns_and_each_page_in_order():
    """Frames for 50 pages at once would hold up a stick; in turns they come to all, if rarer."""
    async def work():
        async with House() as house:
            pilot, *crowd = [await house.socket() for _ in range(51)]
            await ask(pilot, do='take')

            async def fly():
                for k in range(60):             # a step every 20 ms
                    house.hub.post('command', command(k, k))
                    await asyncio.sleep(0.02)
            flying = asyncio.create_task(fly())
            heard = await asyncio.gather(*(frames(page, 1.5) for page in (pilot, *crowd)))
            await flying
            rounds = [len(numbers) for numbers in heard[1:]]
            assert 2 <= min(rounds) and max(rounds) <= 9 and len(heard[0]) > 2 * max(rounds), rounds
            assert all(numbers == sorted(set(numbers)) for numbers in heard)
            # a round gives all of them one and the same frame
            assert len({tuple(numbers[:2]) for numbers in heard[1:]}) <= 2
            for page in (pilot, *crowd):
                await page.close()

    async def frames(page, seconds):
        numbers, end = [], asyncio.get_running_loop().time() + seconds
        while (left := end - asyncio.get_running_loop().time()) > 0:
            try:
                message = json.loads((await page.receive(left)).data)
            except asyncio.TimeoutError:
                break
            if message['type'] == 'frame':
                numbers.append(message['n'])
        return numbers
    run(work())


async def a_watcher_that_reads_nothing(house):
    """Return its client in the hub and its end of the connection."""
    before = set(house.hub.pages.clients)
    _, writer = await asyncio.open_connection('127.0.0.1', house.server.access.port, limit=1)
    writer.write((
        'GET /ws HTTP/1.1\r\nHost: {0}\r\nOrigin: http://{0}\r\nUpgrade: websocket\r\n'
        'Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n'
        'Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n'
        'Sec-WebSocket-Protocol: rvd.console.1, token.{1}\r\n\r\n').format(
            house.base[7:], house.server.access.token).encode())
    await writer.drain()
    await asyncio.sleep(0.1)
    return (house.hub.pages.clients - before).pop(), writer


def test_a_page_stuck_in_one_message_is_cut_off(monkeypatch):
    monkeypatch.setattr(server, 'STUCK_S', 0.3)

    async def work():
        async with House() as house:
            client, writer = await a_watcher_that_reads_nothing(house)
            for _ in range(40):
                house.hub.pages.put(client, 'x' * 900_000, False)
                await asyncio.sleep(0.02)
                if client.outbox.bytes:
                    break
            assert client.outbox.bytes and not client.closing    # far from too much, yet stuck
            await asyncio.sleep(0.6)
            assert client.closing == 'STUCK' and client not in house.hub.pages.clients
            writer.close()
    run(work())


def test_w2_a_watcher_that_reads_nothing_does_not_hold_up_the_pilot():
    async def work():
        async with House() as house, house.socket() as pilot:
            await ask(pilot, do='take')
            watcher, writer = await a_watcher_that_reads_nothing(house)
            for k in range(600):                # 600 messages of 20 kB that it does not read
                house.hub.pages.put(watcher, 'x' * 20000, False)
                if k % 20 == 0:
                    assert (await ask(pilot, do='resume'))['ok']
            while len(house.hub.pages.clients) > 1:   # and in the end it is cut off
                assert (await ask(pilot, do='resume'))['ok']
                await asyncio.sleep(0.05)
            writer.close()
    run(work())


def test_a_run_under_way_is_not_given_out_for_review(tmp_path):
    (tmp_path / 'run').mkdir()
    (tmp_path / 'run' / 'verdict.json').write_text('{}')
    (tmp_path.parent / 'secret').mkdir(exist_ok=True)
    (tmp_path.parent / 'secret' / 'verdict.json').write_text('{}')

    async def work():
        async with House(tmp_path) as house:
            bearer = {'Authorization': f'Bearer {house.server.access.token}'}

            async def status(path, headers=bearer):
                async with house.session.get(house.base + path, headers=headers) as answer:
                    return answer.status
            assert await status('/api/runs', {}) == 403
            assert await status('/api/runs/run') == 409
            house.hub.end()
            assert await status('/api/runs/run') == 422         # it has no bag
            assert await status('/api/runs/%2e%2e%2fsecret') == 404
    run(work())


def test_a_run_is_reviewed_only_when_its_folder_is_whole(tmp_path):
    (tmp_path / 'run').mkdir()
    (tmp_path / 'run' / 'verdict.json').write_text('{}')

    async def work():
        async with House(tmp_path, ask=lambda wish: None) as house:
            bearer = {'Authorization': f'Bearer {house.server.access.token}'}

            async def names():
                async with house.session.get(house.base + '/api/runs', headers=bearer) as answer:
                    return [row['name'] for row in await answer.json()]
            house.hub.end()                     # the graph is down, its folder is being written
            assert house.hub.phase == 'closing' and await names() == []
            house.hub.told('ended', run='run')
            assert await names() == ['run']
    run(work())


def test_without_anyone_to_start_runs_a_wish_for_one_is_refused():
    async def work():
        async with House() as house, house.socket() as pilot:
            await ask(pilot, do='take')
            assert (await ask(pilot, do='fly'))['code'] == 'NO_FLY'
    run(work())


def test_a_wish_for_a_run_reaches_who_starts_them():
    wishes = []

    async def work():
        async with House(ask=wishes.append) as house, house.socket() as pilot:
            await ask(pilot, do='take')
            assert (await ask(pilot, do='fly', mode='manual', seed=8, out='/x'))['ok']
    run(work())
    assert wishes == [{'do': 'fly', 'mode': 'manual', 'seed': 8}]


def test_pilot_and_watchers_get_frames_and_a_late_page_gets_the_run_first():
    async def frames(socket, wanted):
        types = []
        while types.count('frame') < wanted:
            types.append(json.loads((await socket.receive(5.0)).data)['type'])
        return types

    async def work():
        async with House() as house, house.socket() as pilot, house.socket() as other:
            await ask(pilot, do='take')
            for k in range(30):
                house.hub.post('command', command(k, k + 1, (1, 0, 0), 3, 0.7))
                await asyncio.sleep(0.02)
            assert 'run' in await frames(other, 3)
            await frames(pilot, 8)
            async with house.socket() as late:
                house.hub.post('command', command(30, 31, (1, 0, 0), 3, 0.7))
                types = await frames(late, 1)
                assert types.index('run') < types.index('frame')
    run(work())
