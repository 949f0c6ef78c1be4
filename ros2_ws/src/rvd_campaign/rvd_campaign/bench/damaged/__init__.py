"""
Bags that are damaged or made to do harm: changes of a real small bag, by a seed.

`made(seed, base, folder)` leaves a run folder with a changed copy of the bag `base`; the same seed
makes the same one. `faults(run)` gives it to everything that reads bags, as `./rvd report`, the
console's review and `--tape` do, and returns what went wrong: each has to show what it can, or to
refuse it in one line, within `MOST_S` of CPU time. A bomb that is not noticed takes all memory:
call it in a process with a limit (`limited`).
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
import resource
import shutil
import subprocess
import sys

from rvd_campaign.bench.damaged import bombs, of_bytes, of_places, of_records, of_tables
from rvd_campaign.bench.damaged.readers import faults, MOST_S

__all__ = ['cases', 'faults', 'flown', 'limited', 'made', 'MOST_S']
MEMORY = 3 << 30                        # [B] of address space that all of them may take
SHORT = '/**: {ros__parameters: {timeout_s: 15.0}}\n'   # what `flown` flies: 30 steps
DAMAGE: tuple[Callable[[Random, Path, Path], None], ...] = (
    of_bytes.damage, of_bytes.damage, of_bytes.damage, of_records.damage, of_records.damage,
    of_records.damage, of_records.damage, of_tables.damage, of_tables.damage, of_places.damage,
    bombs.damage, of_places.damage_beside)


def flown(folder: Path) -> Path:
    """Fly a short run into a new folder; return its bag."""
    scenario = folder.with_suffix('.yaml')
    scenario.write_text(SHORT, encoding='utf-8')
    subprocess.run([sys.executable, '-m', 'rvd_campaign.cli', 'fly', str(scenario), '--pace',
                    'lockstep', '--processes', 'one', '--headless', '--out', str(folder)],
                   capture_output=True, check=False)
    return folder / 'bag'


def limited() -> None:
    """Give this process a limit of memory, as a bomb needs it."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def made(seed: int, base: Path, folder: Path) -> Path:
    """
    Leave the run folder `folder` with a damaged copy of the bag `base`; return the folder.

    What was in the folder is removed.
    """
    rng = Random(seed)
    shutil.rmtree(folder, ignore_errors=True)
    (folder / 'bag').mkdir(parents=True)
    (folder / 'verdict.json').write_text('{}', encoding='utf-8')
    rng.choice(DAMAGE)(rng, base, folder / 'bag')
    return folder


def cases(seed: int, count: int, base: Path, folder: Path) -> Iterator[tuple[int, Path]]:
    """Yield `count` damaged run folders with their seeds, each in place of the one before."""
    for each in range(seed, seed + count):
        yield each, made(each, base, folder)
