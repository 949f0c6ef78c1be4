"""
Damaged bags, and bags made to do harm, through report, review and tape.

What can be shown is, the rest is refused in a line. Each in a child of its own, with a limit of
memory: what is not noticed in time takes all of it.
"""

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
import shutil
import tempfile

from rvd_campaign.bench import damaged
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.limits import Hung, in_child
from rvd_campaign.exits import CannotRun

LIMIT_S = 5 * damaged.MOST_S    # [s] wall time of the four readers of one bag
EXTRA_BYTES = 3 << 30           # of address space


def attack() -> Kind:
    """Return this kind."""
    return Kind('bags', 'damaged bags through report, review and tape', 'bags', 1000, 5, _open,
                zero=('not in one line, or too slow', 'hangs', 'ended'))


@contextmanager
def _open(keep: Path) -> Iterator[Case]:
    with tempfile.TemporaryDirectory(prefix='rvd-attack-') as top:
        base = damaged.flown(Path(top) / 'base')
        if not base.is_dir():
            raise CannotRun('bench attack bags: the flight whose bag is to be damaged left none')
        with suppress(Exception):       # what every child needs is loaded once, and compiled
            damaged.faults(Path(shutil.copytree(base.parent, Path(top) / 'loaded')))
        yield lambda seed: one(seed, base, Path(top) / f'{seed}', keep)


def one(seed: int, base: Path, folder: Path, keep: Path) -> Outcome:
    """Damage one bag and read it."""
    outcome = Outcome()
    try:
        run = damaged.made(seed, base, folder)
        said = in_child(lambda: damaged.faults(run), LIMIT_S, EXTRA_BYTES)
        outcome.counts['not in one line, or too slow'] += bool(said)
    except Hung as error:
        outcome.counts['hangs'] += 1
        said = [str(error)]
    except RuntimeError as error:
        outcome.counts['ended'] += 1
        said = [str(error)]
    outcome.failures += said
    shutil.rmtree(folder, ignore_errors=True)
    return outcome
