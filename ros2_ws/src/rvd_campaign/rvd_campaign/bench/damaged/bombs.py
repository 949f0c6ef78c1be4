"""Bombs: some kilobytes that unpack to gigabytes."""

from functools import lru_cache
from pathlib import Path
from random import Random
import struct

import zstandard

from rvd_campaign.bench.damaged.content import content_of, ESCAPES, HEAD, some, written


def damage(rng: Random, base: Path, bag: Path) -> None:
    """Leave a bag that unpacks to more memory than there is."""
    kind = rng.randrange(6)
    if kind == 0:                               # 60 kB to 2 GB, the file
        (bag / 'bag_0.mcap.zstd').write_bytes(zstd_zeros(HEAD, 2 << 30))
    elif kind == 1:
        (bag / 'bag_0.db3.zstd').write_bytes(zstd_zeros(b'', 2 << 30))
    else:                                       # a chunk, or one message
        word = rng.choice(('zstd', 'lz4', '', 'none', ESCAPES))
        said = rng.choice((0, 1 << 20, 200 << 20, 2 << 30, 2**63))
        data = zstd_zeros(b'', 2 << 30) if word != 'lz4' else _lz4_zeros(256 << 20)
        body = struct.pack('<QQQI', 0, 1, said, 0) + struct.pack(
            '<I', len(word.encode())) + word.encode() + struct.pack('<Q', len(data)) + data
        chunk = struct.pack('<BQ', 6, len(body)) + body
        if kind == 5:
            content = content_of(base)
            for m in some(rng, content):
                m.data = data
            (bag / 'bag_0.mcap').write_bytes(written(content))
        else:
            (bag / 'bag_0.mcap').write_bytes(HEAD + chunk * rng.choice((1, 50)))


@lru_cache(maxsize=4)
def zstd_zeros(head: bytes, size: int) -> bytes:
    """Return `head` and so many bytes of nothing, packed."""
    packer, made = zstandard.ZstdCompressor(level=3).compressobj(), []
    made.append(packer.compress(head))
    block = bytes(1 << 24)
    for _ in range(size // len(block)):
        made.append(packer.compress(block))
    return b''.join(made) + packer.flush()


@lru_cache(maxsize=1)
def _lz4_zeros(size: int) -> bytes:
    import lz4.frame
    return lz4.frame.compress(bytes(size))
