"""
Hostile messages: every field of a message with a value that it should not have, and broken bytes.

For the tests of what a node does with them, and for `rvd bench attack`. Everything is seeded: the
same seed gives the same message.

    mutants(message)            each field with each hostile value, one at a time: (name, message)
    mutant(message, seed)       one of them, or up to three fields at once
    at_steps(message, step)     the message at steps of the past and the future
    broken(data, seed)          serialised bytes that are cut, flipped, lengthened or replaced
    payload(good, seed)         a frame's payload that is damaged, or intact with hostile numbers
"""

from collections.abc import Iterator
from copy import deepcopy
from importlib import import_module
import math
import random
import re
import struct
from typing import Any
from zlib import crc32

HUGE = 100_000                  # elements of a list, characters of a string
INTEGERS = {'uint8': (8, False), 'int8': (8, True), 'octet': (8, False), 'uint16': (16, False),
            'int16': (16, True), 'uint32': (32, False), 'int32': (32, True),
            'uint64': (64, False), 'int64': (64, True)}
FLOATS = (math.nan, math.inf, -math.inf, -0.0, 5e-324, -1.0, 1e15, -1e300, 1e308)
SINGLES = (math.nan, math.inf, -math.inf, -0.0, -1.0, 1.5, 3e38)       # that a float32 holds
STRINGS = ('', 'x'*HUGE, '\x1b[2J\x1b[31m', '\u202e\u2066', '/', '%s%n{0}', '<b>&')
PAST_AND_FUTURE = (-1, 1, 2, 3, 10, 100, 1999, 2001, 10**4, 10**6, 2**31, 2**53 + 1, 2**62)
ARRAY = re.compile(r'(.+)\[(\d+)\]')
SEQUENCE = re.compile(r'sequence<([^,>]+)(?:, \d+)?>')


def hostile_values(kind: str) -> list[Any]:
    """Return what a field of a plain type should not have: 'double', 'uint8', 'string', ..."""
    if kind in INTEGERS:
        bits, signed = INTEGERS[kind]
        top = (1 << bits - signed) - 1
        low = -top - 1 if signed else 0
        return sorted({low, low + 1, 0, 1, 5, 13, 100, top//2, top - 1, top})
    if kind in ('double', 'float64'):
        return list(FLOATS)
    if kind in ('float', 'float32'):
        return list(SINGLES)
    if kind == 'boolean':
        return [False, True]
    return list(STRINGS) if kind.startswith('string') else []


def fields(message: Any, prefix: str = '') -> Iterator[tuple[str, str]]:
    """Yield path and type of each plain field, each list, and the ends of each array."""
    for name, text in message.get_fields_and_field_types().items():
        path = prefix + name
        array = ARRAY.fullmatch(text)
        if array:
            for i in sorted({0, int(array[2])//2, int(array[2]) - 1}):
                if '/' in array[1]:
                    yield from fields(getattr(message, name)[i], f'{path}[{i}].')
                else:
                    yield f'{path}[{i}]', array[1]
        elif SEQUENCE.fullmatch(text) or '/' not in text:
            yield path, text
        else:
            yield from fields(getattr(message, name), f'{path}.')


def put(message: Any, path: str, value: Any) -> None:
    """Set a field by its path."""
    *way, last = re.findall(r'\w+|\[\d+\]', path)
    for step in way:
        message = message[int(step[1:-1])] if step[0] == '[' else getattr(message, step)
    if last[0] == '[':
        message[int(last[1:-1])] = value
    else:
        setattr(message, last, value)


def lists(kind: str) -> Iterator[tuple[str, list]]:
    """Yield hostile lists of a type of elements, by name."""
    yield 'empty', []
    if '/' in kind:
        package, name = kind.split('/')[0], kind.split('/')[-1]
        made = getattr(import_module(f'{package}.msg'), name)
        yield 'one', [made()]
        yield 'many', [made()]*1000
        return
    worst = hostile_values(kind)
    for i, value in enumerate(worst):
        yield f'one of {i}', [value]
        yield f'eight of {i}', [value]*8
    yield 'huge', [worst[-1] if kind != 'string' else 'x']*HUGE


def mutants(message: Any) -> Iterator[tuple[str, Any]]:
    """Yield a copy of a message for each field and hostile value, with its name."""
    for path, kind in fields(message):
        sequence = SEQUENCE.fullmatch(kind)
        found = lists(sequence[1]) if sequence else (
            (_short(value), value) for value in hostile_values(kind))
        for name, value in found:
            made = deepcopy(message)
            put(made, path, value)
            yield f'{path} = {name}', made


def mutant(message: Any, seed: int) -> tuple[str, Any]:
    """Return a copy of a message in which one to three fields are hostile, and its name."""
    draw, made, names = random.Random(seed), deepcopy(message), []
    there = list(fields(made))
    for path, kind in draw.sample(there, min(len(there), draw.choice((1, 1, 2, 3)))):
        sequence = SEQUENCE.fullmatch(kind)
        if sequence:
            name, value = draw.choice(list(lists(sequence[1])))
        else:
            value = draw.choice(hostile_values(kind))
            name = _short(value)
        put(made, path, value)
        names.append(f'{path} = {name}')
    return ', '.join(names), made


def at_steps(message: Any, step: int) -> Iterator[tuple[str, Any]]:
    """
    Yield copies of a message at steps of the past and the future of a run that is at `step`.

    A message without a step (Joy, Clock) gets stamps instead, of wall time among them.
    """
    if hasattr(message, 'step'):
        for off in PAST_AND_FUTURE:
            for at in (step + off, step - off):
                if 0 <= at < 1 << 64:
                    made = deepcopy(message)
                    made.step = at
                    yield f'step = {at}', made
        return
    stamp = next((way for way in ('header.stamp', 'clock') if hasattr(
        message, way.split('.')[0])), None)
    if stamp is not None:
        for sec, nanosec in ((-1, 0), (0, 2**32 - 1), (2**31 - 1, 0), (-2**31, 0),
                             (1_790_000_000, 123)):
            made = deepcopy(message)
            put(made, f'{stamp}.sec', sec)
            put(made, f'{stamp}.nanosec', nanosec)
            yield f'{stamp} = {sec} s, {nanosec} ns', made


def broken(data: bytes, seed: int) -> bytes:
    """Return serialised bytes of which no message can be made, or another one."""
    draw = random.Random(seed)
    way = draw.randrange(6)
    if way == 0:
        return data[:draw.randrange(len(data) + 1)]
    if way == 1:
        return data + draw.randbytes(draw.choice((1, 4, 1000)))
    if way == 2:
        return draw.randbytes(draw.choice((0, 1, 3, 4, 8, 64, 4096)))
    spoilt = bytearray(data)
    if way == 3 and len(data) > 8:              # a length, maybe
        at = 4*draw.randrange(1, len(data)//4)
        spoilt[at:at + 4] = struct.pack('<I', draw.choice((2**32 - 1, 2**31, 10**6)))
    else:
        for _ in range(draw.choice((1, 2, 8))):
            at = draw.randrange(len(spoilt) or 1)
            spoilt[at:at + 1] = bytes([draw.randrange(256)])
    return bytes(spoilt)


def payload(good: bytes, seed: int) -> tuple[bytes, bool]:
    """
    Return a hostile payload made of a good one, and whether its checksum is right.

    An intact one has hostile numbers where the good one has others; a receiver can only see that
    by what it knows of them.
    """
    draw = random.Random(seed)
    body = bytearray(good[:-4])
    if draw.random() < 0.5:
        return broken(good, seed + 1), False
    if len(body) >= 8:
        for _ in range(draw.choice((1, 1, 2, 8))):
            at = draw.randrange(len(body) - 7)
            body[at:at + 8] = draw.choice((
                struct.pack('<d', draw.choice(FLOATS)), struct.pack('<Q', draw.choice(
                    (0, 1, 2**63, 2**64 - 1))), draw.randbytes(8)))
    return bytes(body) + struct.pack('<I', crc32(bytes(body))), True


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 40 else f'{text[:20]}... ({len(text)} characters)'
