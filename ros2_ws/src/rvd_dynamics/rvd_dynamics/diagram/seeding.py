"""
NumPy's `SeedSequence` and the seeding of PCG64, for many spawn keys at once.

A campaign makes nine generators a run, and making one costs more than drawing from most of
them (13 us each). This computes the same states for all runs together; the numbers are NumPy's
to the bit, and a test holds them against it.

Source  numpy/random/bit_generator.pyx (SeedSequence, after M. E. O'Neill, randutils) and
        numpy/random/src/pcg64 (pcg_setseq_128_srandom): both are frozen by NumPy's policy on
        compatible streams.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

POOL = 4                        # [words of 32 bits]
INIT_A, MULT_A = 0x43b0d7e5, 0x931e8875
INIT_B, MULT_B = 0x8b51f9dd, 0x58f38ded
MIX_L, MIX_R = np.uint32(0xca01f9dd), np.uint32(0x4973f715)
SHIFT = np.uint32(16)
WORD = (1 << 32) - 1
PCG_MULTIPLIER = 0x2360ed051fc65da44385df649fccf645
MASK = (1 << 128) - 1

Words = NDArray[np.uint32]


class _Hash:
    """The running hash of SeedSequence: its constants do not depend on what is hashed."""

    def __init__(self, init: int, multiplier: int) -> None:
        self._constant, self._multiplier = init, multiplier

    def __call__(self, value: Words) -> Words:
        value = value ^ np.uint32(self._constant)
        self._constant = self._constant * self._multiplier & WORD
        value = value * np.uint32(self._constant)
        return value ^ (value >> SHIFT)


def _mix(x: Words, y: Words) -> Words:
    result = MIX_L * x - MIX_R * y
    return result ^ (result >> SHIFT)


def states(entropy: int, spawn_keys: ArrayLike) -> NDArray[np.uint64]:
    """
    Return `SeedSequence(entropy, spawn_key=k).generate_state(4, uint64)` for every key k.

    Parameters
    ----------
    entropy : int
        Below 2^64.
    spawn_keys : array_like of int, shape (N, m)
        Each number below 2^32.

    Returns
    -------
    ndarray of uint64, shape (N, 4)
    """
    keys = np.asarray(spawn_keys, dtype=np.uint32)
    n = len(keys)
    seed = [entropy & WORD, entropy >> 32, 0, 0]        # padded because a spawn key follows
    assembled = [np.full(n, word, dtype=np.uint32) for word in seed] + list(keys.T)
    with np.errstate(over='ignore'):
        hashed = _Hash(INIT_A, MULT_A)
        pool = [hashed(word) for word in assembled[:POOL]]
        for source in range(POOL):
            for target in range(POOL):
                if source != target:
                    pool[target] = _mix(pool[target], hashed(pool[source]))
        for word in assembled[POOL:]:
            for target in range(POOL):
                pool[target] = _mix(pool[target], hashed(word))
        hashed = _Hash(INIT_B, MULT_B)
        words = np.stack([hashed(pool[i % POOL]) for i in range(2 * POOL)], axis=-1)
    low, high = words[:, 0::2].astype(np.uint64), words[:, 1::2].astype(np.uint64)
    return low | high << np.uint64(32)


def generators(entropy: int, spawn_keys: ArrayLike) -> Iterator[np.random.Generator]:
    """
    Yield, for each key, the generator that NumPy makes of it, at its beginning.

    It is one object that is set anew: draw what you need before you take the next.
    """
    bits = np.random.PCG64(0)
    rng = np.random.Generator(bits)
    inner = {'state': 0, 'inc': 0}
    state = {'bit_generator': 'PCG64', 'state': inner, 'has_uint32': 0, 'uinteger': 0}
    for a, b, c, d in states(entropy, spawn_keys).tolist():
        inc = ((c << 64 | d) << 1 | 1) & MASK
        inner['inc'] = inc
        inner['state'] = ((inc + (a << 64 | b)) * PCG_MULTIPLIER + inc) & MASK
        bits.state = state
        yield rng
