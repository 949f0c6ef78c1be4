"""Payloads of the link: what is packed comes back, and nothing else gets through."""

from array import array
from dataclasses import dataclass
from math import inf, nan
import struct
from zlib import crc32

from hypothesis import example, given, settings, strategies as st
import numpy as np
import pytest
from rvd_dynamics.commands import codes
from rvd_dynamics.link import frame
from rvd_dynamics.link.frame import (
    Command, Downlink, pack_command, pack_downlink, Refusal, unpack_command, unpack_downlink)

SEQUENCES = st.integers(1, 2**64 - 1)
INSTANTS = st.integers(-2**63, 2**63 - 1)
LEVELS = st.tuples(*3 * [st.integers(-3, 3)])
FLOATS = st.floats(allow_nan=True, allow_infinity=True)
STATE = (-30.0, 0.5, -0.25, 0.25, nan, -0.01)
COMMAND = pack_command(7, 3_500_000_000, (3, -2, 0))
DOWNLINK = pack_downlink(8, 4_000_000_000, STATE, 7, codes.REASON_AGE)
BOTH = pytest.mark.parametrize(('payload', 'unpack'), [
    (COMMAND, unpack_command), (DOWNLINK, unpack_downlink)], ids=['command', 'downlink'])


def sealed(body):
    return body + struct.pack('<I', crc32(body))


def flipped(payload, first, burst):
    """Flip the bits of `burst` from bit `first` on, bits numbered from each byte's lowest."""
    changed = bytearray(payload)
    for i in range(burst.bit_length()):
        if burst >> i & 1 and first + i < 8 * len(payload):
            changed[(first + i) // 8] ^= 1 << (first + i) % 8
    return bytes(changed)


# the way there and back

@given(SEQUENCES, INSTANTS, LEVELS, st.integers(0, 4))
def test_commands_come_back_as_they_went(sequence, instant, levels, kind):
    payload = pack_command(sequence, instant, levels, kind)
    assert unpack_command(payload) == Command(sequence, instant, kind, levels)


@given(SEQUENCES, INSTANTS, st.lists(FLOATS, min_size=6, max_size=6), st.integers(0, 2**64 - 1),
       st.integers(0, 255))
def test_downlinks_come_back_bit_for_bit(sequence, instant, state, accepted, refusal):
    payload = pack_downlink(sequence, instant, state, accepted, refusal)
    back = unpack_downlink(payload)
    assert back == Downlink(sequence, instant, back.state, accepted, refusal)
    assert struct.pack('6d', *back.state) == struct.pack('6d', *state)


def test_layout_is_the_documented_one():
    body = (b'\x01' + b'\x00\x00' + bytes(8) + (7).to_bytes(8, 'little')
            + (3_500_000_000).to_bytes(8, 'little') + b'\x00' + b'\x03\xfe\x00')
    assert COMMAND == sealed(body) and len(COMMAND) == 35
    head = b'\x01' + b'\x00\x00' + bytes(8) + (8).to_bytes(8, 'little')
    body = (head + (4_000_000_000).to_bytes(8, 'little') + b'\x00' + struct.pack('<6d', *STATE)
            + (7).to_bytes(8, 'little') + b'\x05')
    assert DOWNLINK == sealed(body) and len(DOWNLINK) == 89


def test_numpy_numbers_are_packed_too():
    levels = np.array([3, -2, 0], dtype=np.int8)
    assert pack_command(np.int64(7), np.int64(3_500_000_000), levels) == COMMAND
    assert pack_downlink(8, 4_000_000_000, np.array(STATE), 7, 5) == DOWNLINK


@BOTH
@pytest.mark.parametrize('kind', [bytes, bytearray, memoryview, lambda b: array('B', b)])
def test_every_kind_of_byte_string_is_read(payload, unpack, kind):
    assert not isinstance(unpack(kind(payload)), Refusal)


def test_refusal_codes_are_those_of_the_message():
    assert {r.name: int(r) for r in Refusal} == {
        name: getattr(codes, f'REASON_{name}')
        for name in ('LENGTH', 'CHECKSUM', 'ORDER', 'AGE', 'RANGE')}


def test_a_form_lays_out_its_own_command():
    @dataclass(frozen=True)
    class Torques:
        neutral = np.zeros(2)
        wire = struct.Struct('<2d')

        def legal(self, command):
            return all(abs(torque) <= 1.0 for torque in command)

    form = Torques()
    payload = pack_command(7, 3_500_000_000, np.array([0.25, -1.0]), form=form)
    assert payload == sealed(COMMAND[:28] + struct.pack('<2d', 0.25, -1.0))
    assert unpack_command(payload, form) == Command(7, 3_500_000_000, codes.KIND_THRUST,
                                                    (0.25, -1.0))
    assert unpack_command(payload) is unpack_command(COMMAND, form) is Refusal.LENGTH
    for command in ((nan, 0.0), (1.5, 0.0), (0.0,), (0.0, 0.0, 0.0)):
        with pytest.raises(ValueError, match='command must be a command of Torques'):
            pack_command(1, 0, command, form=form)


@given(st.lists(FLOATS, min_size=1, max_size=20))
def test_a_downlink_has_the_width_that_was_agreed_on(state):
    payload = pack_downlink(1, 0, state)
    back = unpack_downlink(payload, len(state))
    assert struct.pack(f'{len(state)}d', *back.state) == struct.pack(f'{len(state)}d', *state)
    assert unpack_downlink(payload, len(state) + 1) is Refusal.LENGTH


# what the sender must not send

@pytest.mark.parametrize(('name', 'bad'), [
    ('sequence', (0, 0, (0, 0, 0))), ('sequence', (2**64, 0, (0, 0, 0))),
    ('generated_ns', (1, 2**63, (0, 0, 0))), ('command', (1, 0, (4, 0, 0))),
    ('command', (1, 0, (0, 0, -4))), ('command', (1, 0, (0, 1.5, 0))),
    ('kind', (1, 0, (0, 0, 0), 5)), ('kind', (1, 0, (0, 0, 0), -1))])
def test_impossible_commands_are_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=name):
        pack_command(*bad)


@pytest.mark.parametrize('levels', [(nan, 0, 0), (inf, 0, 0), (1, 2), (1, 2, 3, 0)])
def test_levels_that_are_no_three_numbers_are_refused(levels):
    with pytest.raises(ValueError):
        pack_command(1, 0, levels)


@pytest.mark.parametrize(('name', 'bad'), [
    ('sequence', (0, 0, STATE)), ('generated_ns', (1, -2**63 - 1, STATE)),
    ('state', (1, 0, ())), ('accepted_sequence', (1, 0, STATE, -1)),
    ('refusal', (1, 0, STATE, 0, 256))])
def test_impossible_downlinks_are_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=name):
        pack_downlink(*bad)


# fuzz: P29, P30, L6, X4

@BOTH
@settings(max_examples=500)
@given(data=st.binary(max_size=200))
@example(data=b'')
@example(data=bytes(35))
@example(data=bytes(89))
@example(data=b'\xff' * 35)
@example(data=b'\xff' * 89)
def test_arbitrary_bytes_are_refused_and_never_raise(payload, unpack, data):
    assert unpack(data) is (Refusal.CHECKSUM if len(data) == len(payload) else Refusal.LENGTH)


@BOTH
@given(data=st.data())
@settings(max_examples=500)
def test_arbitrary_bytes_of_the_right_length_are_refused(payload, unpack, data):
    assert unpack(data.draw(st.binary(min_size=len(payload), max_size=len(payload)))) is (
        Refusal.CHECKSUM)


@given(body=st.binary(min_size=31, max_size=31))
def test_well_sealed_nonsense_is_parsed_or_refused_but_never_raises(body):
    assert isinstance(unpack_command(sealed(body)), (Command, Refusal))
    if body[:11] != COMMAND[:11]:
        assert unpack_command(sealed(body)) is Refusal.RANGE


@given(body=st.binary(min_size=85, max_size=85))
def test_well_sealed_downlink_nonsense_never_raises(body):
    assert isinstance(unpack_downlink(sealed(body)), (Downlink, Refusal))
    known = bytearray(body)
    known[:11], known[27] = DOWNLINK[:11], 0
    assert isinstance(unpack_downlink(sealed(bytes(known))), Downlink)


@BOTH
def test_every_flip_of_one_or_two_bits_is_refused(payload, unpack):
    size = 8 * len(payload)
    for i in range(size):
        assert unpack(flipped(payload, i, 1)) is Refusal.CHECKSUM
    for i in range(size):
        for j in range(i + 1, size, 1 if size < 300 else 7):
            assert unpack(flipped(payload, i, 1 | 1 << (j - i))) is Refusal.CHECKSUM


@BOTH
def test_every_place_of_bursts_up_to_32_bits_is_refused(payload, unpack):
    rng = np.random.default_rng(1)
    for first in range(8 * len(payload)):
        for length in range(1, 33):
            middle = int(rng.integers(0, 2**length))
            assert unpack(flipped(payload, first, middle | 1 | 1 << (length - 1))) is (
                Refusal.CHECKSUM)


@BOTH
@settings(max_examples=1000)
@given(data=st.data())
def test_any_burst_up_to_32_bits_is_refused(payload, unpack, data):
    first = data.draw(st.integers(0, 8 * len(payload) - 1))
    burst = data.draw(st.integers(0, 2**32 - 1)) | 1
    assert unpack(flipped(payload, first, burst)) is Refusal.CHECKSUM


@BOTH
def test_every_truncation_and_every_extension_is_refused(payload, unpack):
    for size in range(len(payload)):
        assert unpack(payload[:size]) is Refusal.LENGTH
    for more in range(1, 40):
        assert unpack(payload + bytes(more)) is Refusal.LENGTH
    assert unpack(bytes(1_000_000)) is Refusal.LENGTH


def test_one_payload_is_not_taken_for_the_other():
    assert unpack_command(DOWNLINK) is unpack_downlink(COMMAND) is Refusal.LENGTH


@pytest.mark.parametrize('place', [0, 1, 2, 3, 10])      # version, key, session
def test_unknown_versions_keys_and_sessions_are_refused(place):
    for payload, unpack in ((COMMAND, unpack_command), (DOWNLINK, unpack_downlink)):
        body = bytearray(payload[:-4])
        body[place] ^= 2
        assert unpack(sealed(bytes(body))) is Refusal.RANGE


def test_an_unknown_kind_of_downlink_is_refused():
    body = bytearray(DOWNLINK[:-4])
    body[27] = 1
    assert unpack_downlink(sealed(bytes(body))) is Refusal.RANGE


def test_nothing_is_parsed_before_length_and_checksum_are_right(monkeypatch):      # P34
    class Untouchable:
        def __init__(self, size):
            self.size = size

        def unpack(self, body):
            raise AssertionError('parsed')
    monkeypatch.setattr(frame, '_HEAD', Untouchable(28))
    for payload, unpack in ((COMMAND, unpack_command), (DOWNLINK, unpack_downlink)):
        assert unpack(payload[:-1]) is Refusal.LENGTH
        assert unpack(flipped(payload, 100, 1)) is Refusal.CHECKSUM
        with pytest.raises(AssertionError, match='parsed'):
            unpack(payload)
