"""
What a campaign claims beyond its own runs: a confirmation with another seed, and people's data.

    confirm: {seed: 2, runs: 10000}     # runs: those of the campaign, if left out
    reference:
      WORDS: {condition: NAME, runs: 100, successes: 76, margin: 0.1, design_effect: 3.7}

A difference that was picked among many because it is large is smaller elsewhere: the confirmation
flies all conditions with a seed of its own. `margin` is the largest difference of success rates
that counts as none; `design_effect` is by how much flights that come in clusters, of the same
people, are worth less than independent ones.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rvd_dynamics.bad_input import BadInput

NUMBER = (int, float)


@dataclass(frozen=True)
class Confirmation:
    """With what a campaign is flown again."""

    seed: int
    runs: int


def confirmation(value: Any, seed: int, runs: int, most: int | None = None
                 ) -> Confirmation | None:
    """
    Return what `confirm:` says, or nothing.

    Parameters
    ----------
    value : Any
        As it was read.
    seed, runs : int
        Those of the campaign; `runs` of each condition where the file says nothing else.
    most : int, optional
        Runs of each condition, at most: those that the command line asks for.

    Raises
    ------
    ValueError
        If it is impossible, or the seed is that of the campaign; one line.
    """
    if value is None:
        return None
    if not isinstance(value, dict) or not {'seed'} <= set(value) <= {'seed', 'runs'} or not all(
            type(n) is int for n in value.values()):
        raise BadInput(f'confirm must be {{seed: N, runs: M}}, whole numbers, got {value!r}')
    wanted = value.get('runs', runs)
    again = Confirmation(value['seed'], wanted if most is None else min(wanted, most))
    if not 0 <= again.seed < 2**63:
        raise BadInput(f'confirm: seed must be from 0 to 2^63 - 1, got {again.seed}')
    if again.seed == seed:
        raise BadInput(f'confirm: seed must be another than the campaign\'s, got {seed}: the same '
                       'runs confirm nothing')
    if again.runs < 1:
        raise BadInput(f'confirm: runs must be at least 1, got {again.runs}')
    return again


def reference(label: str, row: Any) -> dict[str, Any]:
    """
    Return a row of people's data.

    Raises
    ------
    ValueError
        If it is impossible; one line that names the row and the value.
    """
    if not isinstance(row, dict) or not {'runs', 'successes'} <= set(row):
        raise BadInput(f'reference {label} must have runs and successes')
    runs, successes = row['runs'], row['successes']
    if type(runs) is not int or type(successes) is not int or not 0 <= successes <= runs > 0:
        raise BadInput(f'reference {label}: runs and successes must be whole numbers, at least 1 '
                       f'and 0 to runs, got {runs!r} and {successes!r}')
    margin, effect = row.get('margin'), row.get('design_effect', 1.0)
    if margin is not None:
        if not _number(margin) or not 0.0 < margin < 1.0:
            raise BadInput(f'reference {label}: margin must be above 0 and below 1, got {margin!r}')
        if 'condition' not in row:
            raise BadInput(f'reference {label}: margin needs condition, the one to compare with')
    if not _number(effect) or not 1.0 <= effect <= runs:
        raise BadInput(f'reference {label}: design_effect must be from 1 to its runs, got '
                       f'{effect!r}')
    return row


def effective(row: Mapping[str, Any]) -> tuple[float, float]:
    """Return successes and runs of a row as so many independent flights."""
    effect = row.get('design_effect', 1.0)
    return row['successes']/effect, row['runs']/effect


def _number(value: Any) -> bool:
    return isinstance(value, NUMBER) and not isinstance(value, bool)
