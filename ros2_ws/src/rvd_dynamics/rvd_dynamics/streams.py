"""
Random streams: one per (seed, run, purpose), drawn as whole-run blocks.

The key never holds the condition (mode, law, pilot weight), a worker or a batch, so
conditions are paired draw by draw and results do not depend on how work was split.
A block has one row per step 0 .. steps - 1, used or not, and a longer run begins with
the rows of a shorter one. Normals have zero mean and unit deviation; uniforms lie in [0, 1).
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics import seeding

Block = NDArray[np.float64]

# Part of the key of every recorded result: never renumber, only append.
PURPOSES = {
    'start': 0,
    'measurement': 1,
    'execution': 2,
    'link_forward': 3,
    'link_back': 4,
    'pilot': 5,
    'pilot_skill': 6,
}


class PilotDraws(NamedTuple):
    """All draws of one pilot over one run; stacked runs have a leading axis."""

    initial_normals: Block          # (..., 6)         start of the six perception biases
    initial_uniforms: Block         # (..., 3)         first decision instant of x, y, z
    normals: Block                  # (..., steps, 10) N0 .. N9 of each step
    uniforms: Block                 # (..., steps, 6)  U0 .. U5 of each step


def generator(seed: int, run: int, purpose: str) -> np.random.Generator:
    """
    Return the generator of one purpose of one run, at its beginning.

    Raises
    ------
    ValueError
        If `purpose` is not a key of PURPOSES, or `seed` or `run` is negative or too large.
    """
    if purpose not in PURPOSES:
        raise ValueError(f'purpose must be one of {", ".join(PURPOSES)}, got {purpose!r}')
    if not 0 <= seed < 2**64:
        raise ValueError(f'seed must be between 0 and 2^64 - 1, got {seed}')
    if not 0 <= run < 2**32:            # one word of the key: two runs cannot share one
        raise ValueError(f'run must be between 0 and 2^32 - 1, got {run}')
    key = np.random.SeedSequence(entropy=int(seed), spawn_key=(int(run), PURPOSES[purpose]))
    return np.random.Generator(np.random.PCG64(key))


def start_normals(seed: int, run: int) -> Block:
    """Return the draws of the start scatter, shape (6,)."""
    return generator(seed, run, 'start').standard_normal(6)


def measurement_normals(seed: int, run: int, steps: int) -> Block:
    """Return the draws of the sensor, shape (steps, 6)."""
    return generator(seed, run, 'measurement').standard_normal((steps, 6))


def execution_normals(seed: int, run: int, steps: int) -> Block:
    """Return the draws of the thrusters, shape (steps, 3); row k acts on [k, k+1)."""
    return generator(seed, run, 'execution').standard_normal((steps, 3))


def pilot_draws(seed: int, run: int, steps: int) -> PilotDraws:
    """Return every draw of the pilot model over a run; skill is apart, see `skill_normal`."""
    # Two children: a normal takes a varying amount of raw draws, so normals and uniforms
    # from one stream would move against each other when the number of steps changes.
    normal_rng, uniform_rng = generator(seed, run, 'pilot').spawn(2)
    return PilotDraws(
        initial_normals=normal_rng.standard_normal(6),
        initial_uniforms=uniform_rng.random(3),
        normals=normal_rng.standard_normal((steps, 10)),
        uniforms=uniform_rng.random((steps, 6)),
    )


def skill_normal(seed: int, operator: int) -> float:
    """Return the skill draw of an operator; it is the same in all of his runs."""
    return float(generator(seed, operator, 'pilot_skill').standard_normal())


def generators(seed: int, runs: Sequence[int], purpose: str) -> Iterator[np.random.Generator]:
    """
    Yield what `generator` returns for each run; draw from one before you take the next.

    The campaign's way in: a tenth of the time, and the same numbers.
    """
    generator(seed, max(runs), purpose)                 # refuses what it refuses
    return seeding.generators(seed, [(run, PURPOSES[purpose]) for run in runs])


def start_normals_of_runs(seed: int, runs: Sequence[int]) -> Block:
    """Return `start_normals` of N runs, shape (N, 6)."""
    return np.array([rng.standard_normal(6) for rng in generators(seed, runs, 'start')])


def normals_of_runs(seed: int, runs: Sequence[int], purpose: str, steps: int, width: int) -> Block:
    """
    Return standard normal draws of N runs, shape (N, steps, width).

    In memory the runs of one step lie together, as a loop over steps reads them.
    """
    drawn = np.empty((steps, len(runs), width))
    for i, rng in enumerate(generators(seed, runs, purpose)):
        drawn[:, i] = rng.standard_normal((steps, width))
    return drawn.transpose(1, 0, 2)


def pilot_draws_of_runs(seed: int, runs: Sequence[int], steps: int) -> PilotDraws:
    """Return `pilot_draws` of N runs with a leading axis; memory as `normals_of_runs`."""
    n = len(runs)
    drawn = PilotDraws(np.empty((n, 6)), np.empty((n, 3)), np.empty((steps, n, 10)),
                       np.empty((steps, n, 6)))
    children = [(run, PURPOSES['pilot'], child) for run in runs for child in (0, 1)]
    for number, rng in enumerate(seeding.generators(seed, children)):
        i, uniform = divmod(number, 2)
        if not uniform:
            drawn.initial_normals[i] = rng.standard_normal(6)
            drawn.normals[:, i] = rng.standard_normal((steps, 10))
        else:
            drawn.initial_uniforms[i] = rng.random(3)
            drawn.uniforms[:, i] = rng.random((steps, 6))
    return drawn._replace(normals=drawn.normals.transpose(1, 0, 2),
                          uniforms=drawn.uniforms.transpose(1, 0, 2))


def skill_normals(seed: int, operators: Sequence[int]) -> Block:
    """Return `skill_normal` of N operators, shape (N,)."""
    return np.array([rng.standard_normal() for rng in generators(seed, operators, 'pilot_skill')])
