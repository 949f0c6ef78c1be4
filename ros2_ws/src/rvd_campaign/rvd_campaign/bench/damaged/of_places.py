"""What else can lie at the path of a bag, of its metadata and of a verdict."""

from contextlib import closing
import os
from pathlib import Path
from random import Random
import socket

from rvd_campaign.bench import hostile_texts
from rvd_campaign.bench.damaged.content import read


def damage(rng: Random, base: Path, bag: Path) -> None:
    """Leave what is no bag, or a bag beside it."""
    path = bag / f'bag_0{rng.choice((".mcap", ".db3", ".mcap.zstd", ".db3.zstd"))}'
    kind = rng.randrange(10)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.mkdir()
    elif kind == 2:
        path.symlink_to(rng.choice(('/dev/zero', '/dev/random', '/dev/full', '/proc/self/mem')))
    elif kind == 3:
        path.symlink_to(path.name)              # to itself
    elif kind == 4:
        path.symlink_to('nowhere')
    elif kind == 5:
        with closing(socket.socket(socket.AF_UNIX)) as made:
            here = os.open(bag, os.O_RDONLY)
            try:
                made.bind(f'/proc/self/fd/{here}/{path.name}')      # of 107 bytes at most
            finally:
                os.close(here)
    elif kind == 6:
        path.write_bytes(b'')
    elif kind == 7:
        with path.open('wb') as file:
            file.write(read(base)[0][:rng.choice((0, 8, 5000))])
            file.truncate(1 << 40)              # a terabyte of nothing
    elif kind == 8:
        for i in range(1200):
            (bag / f'bag_{i}.mcap').write_bytes(b'')
    else:
        path.write_bytes(rng.randbytes(10_000))
    if rng.random() < 0.3:                      # beside one that is whole
        (bag / 'bag_1.mcap').write_bytes(read(base)[0])


def damage_beside(rng: Random, base: Path, bag: Path) -> None:
    """Leave the bag as it is, with what does harm beside it."""
    (bag / 'bag_0.mcap').write_bytes(read(base)[0])
    path = bag / 'metadata.yaml'
    kind = rng.randrange(6)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.symlink_to('/dev/zero')
    elif kind == 2:
        path.mkdir()
    else:
        path.write_text(rng.choice(hostile_texts.LARGE_ONES)(rng), encoding='utf-8')
    kind = rng.randrange(6)                     # and what the review looks for
    verdict = bag.parent / 'verdict.json'
    if kind < 4:
        verdict.unlink()
        (lambda: os.mkfifo(verdict), lambda: verdict.symlink_to('/dev/zero'), verdict.mkdir,
         lambda: verdict.write_text('[' * 100_000, encoding='utf-8'))[kind]()
