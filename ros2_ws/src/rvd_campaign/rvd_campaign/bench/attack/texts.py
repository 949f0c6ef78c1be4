"""
Hostile scenario texts through the loader, as `./rvd fly` loads one: read, or refused in one line.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rvd_campaign.bench import hostile_texts
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.limits import Hung, within

LIMIT_S = 10.0                  # [s] wall time for one text; `hostile_texts` judges CPU time


def attack() -> Kind:
    """Return this kind."""
    return Kind('texts', 'hostile scenario texts through the loader', 'texts', 100_000, 1000, _open,
                zero=('not in one line, or too slow', 'hangs'))


@contextmanager
def _open(_: Path) -> Iterator[Case]:
    hostile_texts.fault(hostile_texts.shipped()[0])     # what is imported once is no text's time
    yield one


def one(seed: int) -> Outcome:
    """Load one text."""
    outcome = Outcome()
    try:
        with within(LIMIT_S):
            said = hostile_texts.fault(hostile_texts.text_of(seed))
    except Hung as error:
        outcome.counts['hangs'] += 1
        outcome.failures.append(str(error))
        return outcome
    if said:
        outcome.counts['not in one line, or too slow'] += 1
        outcome.failures.append(said)
    return outcome
