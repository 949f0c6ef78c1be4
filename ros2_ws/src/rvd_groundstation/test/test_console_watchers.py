"""Pages that only watch, what a page hears without asking, and tokens that outlive a console."""

import asyncio
import hashlib
import hmac
import json
import os

import aiohttp
import pytest
from test_console_server import ask, command, House, run, stick

from rvd_groundstation.console import tokens
from rvd_groundstation.console.access import Access
from rvd_groundstation.console.protocol import REQUESTS
from rvd_groundstation.console.tokens import Tokens, tokens_of


def watching(house):
    return house.socket(house.server.access.watch_token)


async def hear(socket, kind):
    """Return the next message of a kind."""
    while True:
        message = json.loads((await socket.receive(5.0)).data)
        if message['type'] == kind:
            return message


# -- a watcher's token ----------------------------------------------------------------------

@pytest.mark.parametrize('do', [do for do in REQUESTS if do != 'ping'])
def test_a_watcher_is_refused_whatever_he_asks_for_and_a_pilot_is_not_told_so(do):
    async def work():
        async with House() as house, watching(house) as watcher, house.socket() as pilot:
            reply = await ask(watcher, do=do, mode='auto')
            assert not reply['ok'] and reply['code'] == 'WATCH'
            assert house.graph.asked == [] and house.hub.lease.holder is None
            assert (await ask(pilot, do=do, mode='auto')).get('code') != 'WATCH'
    run(work())


def test_a_watcher_sees_the_flight_and_is_told_that_he_cannot_steer():
    async def work():
        async with House() as house, watching(house) as watcher, house.socket() as pilot:
            for socket, steers in ((watcher, False), (pilot, True)):
                assert (await hear(socket, 'hello'))['can']['steer'] is steers
            house.hub.post('command', command(3, 1))
            assert (await hear(watcher, 'frame'))['k'] == 3
            assert (await ask(watcher, do='ping'))['ok']
    run(work())


def test_the_stick_of_a_watcher_flies_nothing():
    async def work():
        async with House() as house, watching(house) as watcher:
            await watcher.send_bytes(stick(x=1.0))
            assert (await ask(watcher, do='ping'))['ok']        # it has been read by now
            assert house.graph.sticks == []
    run(work())


def test_a_watcher_may_look_at_finished_runs(tmp_path):
    async def work():
        async with House(tmp_path) as house:
            for token, status in ((house.server.access.watch_token, 200), ('no', 403), ('', 403)):
                async with house.session.get(
                        house.base + '/api/runs',
                        headers={'Authorization': f'Bearer {token}'}) as answer:
                    assert answer.status == status
    run(work())


def test_without_a_watchers_token_no_other_is_one():
    access = Access('right', '127.0.0.1', 8480)
    assert not any(access.watches(token) for token in (None, '', 'right'))
    two = Access('right', '127.0.0.1', 8480, watch_token='look')
    assert two.watches('look') and not two.knows('look') and not two.watches('right')
    assert two.watch_url == 'http://127.0.0.1:8480/#look'


# -- what a page hears ----------------------------------------------------------------------

def test_who_joins_gets_the_last_picture_though_no_step_is_made():
    async def work():
        async with House() as house:
            house.hub.post('command', command(7, 1))
            house.hub.post('paused', True)
            await asyncio.sleep(0.3)
            async with watching(house) as late:
                frame = await hear(late, 'frame')
                assert frame['k'] == 7 and frame['paused']
                assert '/ground/command' in frame['signals']
    run(work())


def test_who_joins_before_the_first_step_gets_no_empty_picture():
    async def work():
        async with House() as house, watching(house) as early:
            await hear(early, 'status')
            with pytest.raises(asyncio.TimeoutError):
                await asyncio.wait_for(hear(early, 'frame'), 0.8)
    run(work())


def test_a_page_hears_of_the_server_though_nothing_happens():
    async def work():
        async with House() as house, watching(house) as idle:
            for _ in range(4):
                await hear(idle, 'beat')
    run(work())


def test_hello_says_whether_a_run_is_there():
    async def work():
        async with House() as house:
            async with house.socket() as page:
                assert (await hear(page, 'hello'))['flown'] is True
            house.hub.feed = None
            async with house.socket() as page:
                assert (await hear(page, 'hello'))['flown'] is False
    run(work())


# -- proofs and tokens ----------------------------------------------------------------------

def test_the_server_proves_that_it_has_the_token_of_a_page():
    nonce = 'ab' * 16

    async def work():
        async with House() as house:
            host = house.base.removeprefix('http://')
            async with house.session.get(house.base + '/api/proof', params={'nonce': nonce}
                                         ) as answer:
                proofs = await answer.json()
            access = house.server.access
            for token in (access.token, access.watch_token):
                wanted = hmac.new(token.encode(), f'{host} {nonce}'.encode(), hashlib.sha256)
                assert wanted.hexdigest() in proofs
                assert token not in str(proofs)
            assert len(proofs) == 2
            for wrong in ('', 'AB' * 16, 'ab' * 15, 'ab' * 17, 'zz' * 16):
                async with house.session.get(house.base + '/api/proof', params={'nonce': wrong}
                                             ) as answer:
                    assert answer.status == 422
            async with house.session.get(house.base + '/api/proof', params={'nonce': nonce},
                                         headers={'Host': 'evil.example'}) as answer:
                assert answer.status == 403
    run(work())


def test_the_next_console_at_an_address_has_the_tokens_of_the_one_before(tmp_path):
    first = tokens_of('127.0.0.1', 8480, tmp_path)
    assert tokens_of('127.0.0.1', 8480, tmp_path) == first and first.fly != first.watch
    assert tokens_of('127.0.0.1', 8481, tmp_path) != first
    assert tokens_of('::1', 8480, tmp_path) != first
    for file in tmp_path.iterdir():
        assert file.stat().st_mode & 0o777 == 0o600


def test_a_port_that_was_free_by_chance_has_new_tokens(tmp_path):
    assert tokens_of('127.0.0.1', 0, tmp_path) != tokens_of('127.0.0.1', 0, tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize('spoil', [
    lambda file: file.chmod(0o644), lambda file: file.write_text('{"fly": "a", "watch": "b"}'),
    lambda file: file.write_text('[]'), lambda file: file.write_text('{"fly": 1, "watch": 2}'),
    lambda file: file.write_text('x' * 5000), lambda file: file.write_bytes(b'\xff'),
    lambda file: os.utime(file, (0, 0)), lambda file: os.utime(file, (4e9, 4e9)),
    lambda file: file.write_text(json.dumps(Tokens('A' * 22, 'A' * 22)._asdict())),
    lambda file: (file.rename(file.with_name('elsewhere')),
                  file.symlink_to(file.with_name('elsewhere')))],
    ids=['readable', 'short', 'list', 'numbers', 'long', 'bytes', 'old', 'future', 'equal', 'link'])
def test_a_file_of_tokens_that_is_not_ours_alone_and_whole_does_not_count(tmp_path, spoil):
    first = tokens_of('127.0.0.1', 8480, tmp_path)
    spoil(next(tmp_path.iterdir()))
    second = tokens_of('127.0.0.1', 8480, tmp_path)
    assert not set(second) & set(first) and all(len(token) == 22 for token in second)
    assert tokens_of('127.0.0.1', 8480, tmp_path) == second


def test_a_folder_that_others_can_read_keeps_nothing(tmp_path, monkeypatch):
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))
    tmp_path.chmod(0o700)
    assert tokens.own_folder() == tmp_path / 'rvd-console'
    (tmp_path / 'rvd-console').chmod(0o755)
    assert tokens.own_folder() is None
    assert tokens_of('127.0.0.1', 8480) != tokens_of('127.0.0.1', 8480)


def test_the_page_comes_with_a_policy_that_forbids_what_is_not_named():
    async def work():
        async with House() as house:
            async with house.session.get(house.base + '/') as answer:
                policy = answer.headers['Content-Security-Policy']
        rules = dict(rule.split(' ', 1) for rule in policy.split('; '))
        assert rules['default-src'] == "'none'"
        assert not any(word in policy for word in ('unsafe', '*', 'http:', 'https:', 'data:'))
    asyncio.run(asyncio.wait_for(work(), 30.0))


def test_a_server_that_nobody_is_connected_to_can_be_asked_for_a_proof():
    """So a page that is away learns that it is back, without showing anything."""
    async def work():
        async with House() as house:
            async with aiohttp.ClientSession() as other:
                async with other.get(house.base + '/api/proof', params={'nonce': '0' * 32}
                                     ) as answer:
                    assert answer.status == 200
                    assert answer.headers['Cache-Control'] == 'no-store'
            assert not house.server.door.refused
    run(work())
