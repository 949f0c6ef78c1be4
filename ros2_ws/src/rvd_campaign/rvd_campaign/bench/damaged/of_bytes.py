"""Changes of bytes: a bag that is cut, of flipped bits, of wrong lengths."""

from pathlib import Path
from random import Random
import struct

from mcap.writer import CompressionType
import zstandard

from rvd_campaign.bench.damaged.content import content_of, DOUBLES, read, WHOLES, written
from rvd_dynamics.recording import mcap_records


def _any_file(rng: Random, base: Path) -> bytes:
    """Return the bag as one of the files that it can be."""
    kind = rng.randrange(5)
    if kind == 0:
        return written(content_of(base), closed=False)
    if kind == 1:
        return written(content_of(base), CompressionType.ZSTD)
    if kind == 2:
        return written(content_of(base), CompressionType.LZ4)
    return read(base)[0]


def _cut(rng: Random, data: bytes) -> bytes:
    return data[:rng.randrange(len(data) + 1)]


def _flip(rng: Random, data: bytes) -> bytes:
    changed = bytearray(data)
    for _ in range(rng.choice((1, 1, 1, 3, 10, 100))):
        changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    return bytes(changed)


def _overwrite(rng: Random, data: bytes) -> bytes:
    at = rng.randrange(len(data))
    new = rng.choice((bytes(rng.choice((8, 512, 4096))), b'\xff' * 8, rng.randbytes(64),
                      rng.choice(WHOLES), rng.choice(DOUBLES)))
    return data[:at] + new + data[at + len(new):]


def _insert(rng: Random, data: bytes) -> bytes:
    at, length = rng.randrange(len(data)), rng.choice((1, 8, 100, 5000))
    new = rng.choice((bytes(length), rng.randbytes(length), data[at:at + length]))
    return data[:at] + new + data[at:]


def _delete(rng: Random, data: bytes) -> bytes:
    at = rng.randrange(len(data))
    return data[:at] + data[at + rng.choice((1, 8, 100, 5000)):]


def _length(rng: Random, data: bytes) -> bytes:
    """Make the length of one record a wrong one."""
    places, at = [], len(mcap_records.MAGIC)
    while at + 9 <= len(data):
        places.append(at)
        at += 9 + struct.unpack_from('<Q', data, at + 1)[0]
    at = rng.choice(places or [0])
    return data[:at + 1] + rng.choice(WHOLES) + data[at + 9:]


def _tail(rng: Random, data: bytes) -> bytes:
    return data + rng.choice((bytes(1000), data, rng.randbytes(1000), mcap_records.MAGIC))


OF_BYTES = (_cut, _cut, _flip, _flip, _overwrite, _insert, _delete, _length, _tail)


def damage(rng: Random, base: Path, bag: Path) -> None:
    """Leave the bag, in one of its forms, with changes of its bytes."""
    data = _any_file(rng, base)
    for _ in range(rng.choice((1, 1, 2, 4))):
        if data:
            data = rng.choice(OF_BYTES)(rng, data)
    if rng.random() < 0.1:
        packed = zstandard.compress(data)
        (bag / 'bag_0.mcap.zstd').write_bytes(
            rng.choice(OF_BYTES[:6])(rng, packed) if rng.random() < 0.5 else packed)
        return
    (bag / 'bag_0.mcap').write_bytes(data)
