"""
Random streams: one per (seed, run, purpose), drawn as whole-run blocks.

The key never holds the condition (mode, law, pilot weight), a worker or a batch, so
conditions are paired draw by draw and results do not depend on how work was split.
A block has one row per step 0 .. steps - 1, used or not, and a longer run begins with
the rows of a shorter one. Normals have zero mean and unit deviation; uniforms lie in [0, 1).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple, Protocol
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import seeding

Block = NDArray[np.float64]

HANDFUL = 32                            # runs that are drawn before they are put in their places

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


def number_of(purpose: str) -> int:
    """
    Return the number of a purpose in the key of its stream.

    The purposes of the first mission have numbers of their own; any other is named
    `mission/block/purpose` and keyed by the CRC-32 of that name.

    Raises
    ------
    ValueError
        If the purpose is neither, or its number is that of a numbered one.
    """
    if purpose in PURPOSES:
        return PURPOSES[purpose]
    if purpose.count('/') != 2:
        raise ValueError(f'purpose must be one of {", ".join(PURPOSES)}, or of the form '
                         f'mission/block/purpose, got {purpose!r}')
    number = crc32(purpose.encode())
    if number in PURPOSES.values():
        raise ValueError(f'purpose {purpose!r} has the stream of another: give it another name')
    return number


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
        If `purpose` is impossible, or `seed` or `run` is negative or too large.
    """
    number = number_of(purpose)
    if not 0 <= seed < 2**64:
        raise ValueError(f'seed must be between 0 and 2^64 - 1, got {seed}')
    if not 0 <= run < 2**32:            # one word of the key: two runs cannot share one
        raise ValueError(f'run must be between 0 and 2^32 - 1, got {run}')
    key = np.random.SeedSequence(entropy=int(seed), spawn_key=(int(run), number))
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
    return seeding.generators(seed, [(run, number_of(purpose)) for run in runs])


def start_normals_of_runs(seed: int, runs: Sequence[int]) -> Block:
    """Return `start_normals` of N runs, shape (N, 6)."""
    return _columns(generators(seed, runs, 'start'), len(runs), 6).T


def normals_of_runs(seed: int, runs: Sequence[int], purpose: str, steps: int, width: int) -> Block:
    """
    Return standard normal draws of N runs, shape (N, steps, width).

    In memory the runs come last: a loop over steps reads each component of all runs in a row.
    """
    drawn = _columns(generators(seed, runs, purpose), len(runs), steps*width)
    return _blocks(drawn, width)


def pilot_draws_of_runs(seed: int, runs: Sequence[int], steps: int) -> PilotDraws:
    """Return `pilot_draws` of N runs with a leading axis; memory as `normals_of_runs`."""
    normal_rngs, uniform_rngs = (
        seeding.generators(seed, [(run, PURPOSES['pilot'], child) for run in runs])
        for child in (0, 1))
    normals = _columns(normal_rngs, len(runs), 6 + steps*10)
    uniforms = _columns(uniform_rngs, len(runs), 3 + steps*6, uniform=True)
    return PilotDraws(normals[:6].T, uniforms[:3].T, _blocks(normals[6:], 10),
                      _blocks(uniforms[3:], 6))


def skill_normals(seed: int, operators: Sequence[int]) -> Block:
    """Return `skill_normal` of N operators, shape (N,)."""
    return _columns(generators(seed, operators, 'pilot_skill'), len(operators), 1)[0]


def _columns(rngs: Iterator[np.random.Generator], count: int, size: int,
             uniform: bool = False) -> Block:
    """Return (size, count): the first `size` draws of each generator, one column each."""
    drawn = np.empty((size, count))
    handful = np.empty((HANDFUL, size))         # a column alone touches a page of memory a draw
    for i, rng in enumerate(rngs):
        at = i % HANDFUL
        if uniform:
            rng.random(out=handful[at])
        else:
            rng.standard_normal(out=handful[at])
        if at == HANDFUL - 1 or i == count - 1:
            drawn[:, i - at:i + 1] = handful[:at + 1].T
    return drawn


def _blocks(columns: Block, width: int) -> Block:
    """Return (N, steps, width) of columns (steps*width, N), in place."""
    return columns.reshape(-1, width, columns.shape[-1]).transpose(2, 0, 1)


# -- what a block declares --------------------------------------------------------------------

class Draw(Protocol):
    """
    Chance that a block declares: drawn before the run, for one run or for many.

    Equal draws of one seed and one time grid are the same numbers, so draws are hashable and
    conditions with equal draws share them.
    """

    @property
    def purposes(self) -> tuple[str, ...]:
        """What the streams are for from which it draws; see `number_of`."""

    def of_run(self, seed: int, run: int, steps: int) -> Any:
        """Return the draws of one run."""

    def of_runs(self, seed: int, runs: Sequence[int], steps: int) -> Any:
        """Return the draws of N runs, with a leading axis."""


@dataclass(frozen=True)
class Normals:
    """Standard normals, one row for each step: (steps, width)."""

    purpose: str
    width: int

    @property
    def purposes(self) -> tuple[str, ...]:
        """The one stream."""
        return (self.purpose,)

    def of_run(self, seed: int, run: int, steps: int) -> Block:
        """Return (steps, width)."""
        return generator(seed, run, self.purpose).standard_normal((steps, self.width))

    def of_runs(self, seed: int, runs: Sequence[int], steps: int) -> Block:
        """Return (N, steps, width)."""
        return normals_of_runs(seed, runs, self.purpose, steps, self.width)


@dataclass(frozen=True)
class StartNormals:
    """Standard normals of the start, one row for the run: (width,)."""

    purpose: str = 'start'
    width: int = 6

    @property
    def purposes(self) -> tuple[str, ...]:
        """The one stream."""
        return (self.purpose,)

    def of_run(self, seed: int, run: int, steps: int) -> Block:
        """Return (width,)."""
        return generator(seed, run, self.purpose).standard_normal(self.width)

    def of_runs(self, seed: int, runs: Sequence[int], steps: int) -> Block:
        """Return (N, width)."""
        return _columns(generators(seed, runs, self.purpose), len(runs), self.width).T


@dataclass(frozen=True)
class PilotChance:
    """Everything that a model pilot draws over a run, and the skill of the person who flies."""

    runs_per_operator: int = 1
    purposes: ClassVar[tuple[str, ...]] = ('pilot', 'pilot_skill')

    def of_run(self, seed: int, run: int, steps: int) -> tuple[PilotDraws, float]:
        """Return the draws of a run and the skill."""
        return pilot_draws(seed, run, steps), skill_normal(seed, run // self.runs_per_operator)

    def of_runs(self, seed: int, runs: Sequence[int], steps: int) -> tuple[PilotDraws, Block]:
        """Return the draws of N runs and the skills (N,)."""
        return (pilot_draws_of_runs(seed, runs, steps),
                skill_normals(seed, [run // self.runs_per_operator for run in runs]))
