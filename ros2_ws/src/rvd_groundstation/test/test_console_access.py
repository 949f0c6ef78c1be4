"""Who may talk to the console, who flies, and what a page may say."""

import json
import math
import struct

from hypothesis import given, strategies as st
import pytest

from rvd_groundstation.console.access import (
    Access, check_bind, new_token, Pace, Throttle, token_of)
from rvd_groundstation.console.clients import Outbox
from rvd_groundstation.console.lease import Lease
from rvd_groundstation.console.protocol import (
    encode, flight_wish, Refused, request_of, STICK, stick_of)

ACCESS = Access('right', '127.0.0.1', 8480)


@pytest.mark.parametrize('host', ['127.0.0.1:8480', 'localhost:8480', '[::1]:8480'])
def test_our_own_hosts_are_let_in(host):
    assert ACCESS.refusal(host, f'http://{host}', True) is None


@pytest.mark.parametrize('host, origin, why', [
    ('evil.example:8480', 'http://evil.example:8480', 'HOST'),      # DNS rebinding
    (None, None, 'HOST'), ('127.0.0.1', None, 'HOST'), ('127.0.0.1:80', None, 'HOST'),
    ('127.0.0.1:8480', 'http://evil.example', 'ORIGIN'),            # another site's script
    ('127.0.0.1:8480', 'null', 'ORIGIN'), ('127.0.0.1:8480', None, 'ORIGIN'),
    ('127.0.0.1:8480', 'https://127.0.0.1:8480', 'ORIGIN'),
    ('127.0.0.1:8480', 'http://127.0.0.1:8481', 'ORIGIN')])
def test_other_hosts_and_origins_are_refused(host, origin, why):
    assert ACCESS.refusal(host, origin, True) == why


def test_tokens_are_128_bits_and_never_the_same():
    tokens = {new_token() for _ in range(200)}
    assert len(tokens) == 200 and all(len(token) >= 22 for token in tokens)


@pytest.mark.parametrize('token', [
    None, '', 'righ', 'rightt', 'wrong', 'ri\u0119ht', 'ri\udcffght', 'ri\ud800ght'])
def test_only_the_token_itself_is_known(token):
    assert not ACCESS.knows(token)
    assert ACCESS.knows('right')


def test_the_token_is_in_the_fragment_of_the_address():
    assert ACCESS.url == 'http://127.0.0.1:8480/#right'
    assert token_of(['rvd.console.1', 'token.right']) == 'right'
    assert token_of(['rvd.console.1']) is None


@pytest.mark.parametrize('bind', ['192.168.1.4', '127.0.0.2', 'fe80::1', 'example.org'])
def test_an_address_that_others_reach_needs_tls(bind):
    with pytest.raises(ValueError, match='TLS'):
        check_bind(bind, '', '')
    check_bind(bind, 'cert.pem', 'key.pem')
    check_bind('127.0.0.1', '', '')


@pytest.mark.parametrize('bind', ['', '0.0.0.0', '::'])
def test_an_address_that_stands_for_all_is_refused(bind):
    with pytest.raises(ValueError, match='give the one address or name that pages will open'):
        check_bind(bind, 'cert.pem', 'key.pem')


def test_an_address_of_ipv6_is_in_brackets():
    access = Access('right', 'fe80::1', 8480, secure=True)
    assert access.url == 'https://[fe80::1]:8480/#right'
    assert access.refusal('[fe80::1]:8480', 'https://[fe80::1]:8480', True) is None


def test_throttle_lets_its_rate_through_and_no_more():
    throttle = Throttle(5.0, 5.0)
    passed = sum(throttle.allow(100.0 + i / 100) for i in range(1000))
    assert passed == pytest.approx(5 + 10 * 5, abs=1)


def test_a_pace_lets_a_burst_through_and_then_its_rate():
    pace, now = Pace(10.0, 5.0), 100.0
    for i in range(105):                        # each waits for its turn, as the server does
        now += pace.wait_s(now)
    assert now - 100.0 == pytest.approx(10.0)
    pace, now = Pace(10.0, 5.0), 100.0
    assert [pace.wait_s(now) for _ in range(5)] == [0.0] * 5
    assert pace.wait_s(now, 3.0) == pytest.approx(0.3)


# -- lease --------------------------------------------------------------------------------

def test_one_pilot_at_a_time():
    lease = Lease()
    assert lease.take('a', 0.0) and not lease.take('b', 0.1)
    assert lease.heard('a', 0.2) and not lease.heard('b', 0.2)
    assert lease.drop('a') and not lease.drop('a')
    assert lease.take('b', 0.3)


def test_a_silent_pilot_loses_the_lease_and_one_that_speaks_keeps_it():
    lease = Lease(silent_s=3.0)
    lease.take('a', 0.0)
    assert lease.heard('a', 2.9) and not lease.expire(5.8)
    assert lease.expire(6.0) and lease.holder is None
    assert not lease.heard('a', 6.1)


# -- what a page may say ------------------------------------------------------------------

AXES = ('x', 'y', 'z', 'a', 'b', 'c')           # as many as a sample has, whatever they push


def frame(kind=1, held=1, sequence=7, **deflection):
    at = [deflection.get(axis, 0.0) for axis in AXES]
    return struct.pack('<BBH6fd', kind, held, sequence, *at, 0.0)


def test_a_stick_sample_is_read_as_it_was_sent():
    stick = stick_of(frame(x=1.0, y=-0.5, c=0.25))
    assert (stick.held, stick.sequence) == (True, 7)
    assert stick.deflection == (1.0, -0.5, 0.0, 0.0, 0.0, 0.25)


@pytest.mark.parametrize('value', [math.nan, math.inf, -math.inf, 1.001, -2.0, 3e38])
@pytest.mark.parametrize('axis', AXES)
def test_o2_o3_a_deflection_that_is_none_refuses_the_whole_sample(axis, value):
    with pytest.raises(Refused, match='RANGE'):
        stick_of(frame(**{axis: value}))


@given(st.binary(max_size=64))
def test_no_bytes_make_the_stick_reader_do_anything_but_read_or_refuse(data):
    try:
        stick = stick_of(data)
    except Refused:
        return
    assert len(data) == STICK.size
    assert all(abs(a) <= 1.0 for a in stick.deflection)


@given(st.text(max_size=200))
def test_no_text_makes_the_request_reader_do_anything_but_read_or_refuse(text):
    try:
        request_of(text)
    except Refused:
        pass


@pytest.mark.parametrize('text, why', [
    ('[]', 'JSON'), ('{', 'JSON'), ('{"do": NaN}', 'JSON'), ('[' * 100_000, 'JSON'),
    ('{"do": "rm"}', 'REQUEST'), ('{"do": "take", "id": -1}', 'ID'),
    ('{"do": "take", "id": true}', 'ID'), ('{"do": "mode", "mode": "fast"}', 'MODE')])
def test_requests_that_are_none_are_refused_by_name(text, why):
    with pytest.raises(Refused, match=why):
        request_of(text)


def test_the_modes_that_may_be_asked_for_are_those_of_the_mission():
    assert request_of('{"do": "mode", "mode": "hold"}', ['hold', 'go']).content['mode'] == 'hold'
    assert flight_wish({'mode': 'go'}, ['hold', 'go']) == {'mode': 'go'}
    for wrong in ('auto', ['hold'], None):
        with pytest.raises(Refused, match='MODE'):
            request_of(json.dumps({'do': 'mode', 'mode': wrong}), ['hold', 'go'])
    with pytest.raises(Refused, match='MODE'):
        flight_wish({'mode': 'auto'}, ['hold', 'go'])


def test_a_wish_for_a_run_is_checked():
    assert flight_wish({'mode': 'auto', 'seed': 4, 'out': '/etc'}) == {'mode': 'auto', 'seed': 4}
    for seed in (-1, 1.5, True, '3', 1 << 40):
        with pytest.raises(Refused, match='SEED'):
            flight_wish({'seed': seed})


def test_what_is_unknown_goes_out_as_null():
    assert json.loads(encode({'a': [math.nan, 1.0, (math.inf,)]})) == {'a': [None, 1.0, [None]]}


# -- pages that take nothing --------------------------------------------------------------

def test_w2_frames_are_dropped_oldest_first_and_what_happens_once_is_kept():
    outbox = Outbox(soft=1000, hard=5000)
    assert outbox.put('V' * 100, droppable=False)
    for i in range(50):
        assert outbox.put(f'{i:03d}' + 'f' * 97, droppable=True)
    assert outbox.bytes <= 1000 and outbox.dropped == 41
    first, second = outbox.take(), outbox.take()
    assert first[0] == 'V' and second.startswith('041')


def test_w2_a_page_that_is_hopelessly_behind_is_given_up():
    outbox = Outbox(soft=100, hard=300)
    alive = [outbox.put('x' * 100, droppable=False) for _ in range(4)]
    assert alive == [True, True, True, False]
