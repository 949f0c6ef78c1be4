"""
Short flights in a row, in each form of processes: all end by themselves.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
import tempfile
import time

from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.flying import Flying
from rvd_dynamics.diagram.diagram import GROUPINGS

LIMIT_S = 60.0                  # [s] wall time after which a flight does not end any more
SHORT = '/**: {ros__parameters: {timeout_s: 20.0}}'


def attack() -> Kind:
    """Return this kind."""
    return Kind('flights', 'short undisturbed flights in a row, of each form of processes',
                'flights', 500, 3, _open, all=('ended by themselves',), zero=('orphans',))


@contextmanager
def _open(keep: Path) -> Iterator[Case]:
    with tempfile.TemporaryDirectory(prefix='rvd-attack-') as top:
        short = Path(top) / 'short.yaml'
        short.write_text(SHORT, encoding='utf-8')
        yield lambda seed: one(seed, short, Path(top) / f'{seed}', keep)


def one(seed: int, scenario: Path, folder: Path, keep: Path) -> Outcome:
    """Fly one."""
    outcome, form = Outcome(), GROUPINGS[seed % len(GROUPINGS)]
    with Flying(folder, str(scenario), '--pace', 'lockstep', '--processes', form) as flying:
        code = flying.wait(LIMIT_S)
        outcome.values[f'wall time, {form} [s]'] = [time.monotonic() - flying.begun]
        left = flying.orphans() if code is not None else []
        outcome.counts['orphans'] += len(left)
        if code in (0, 1):
            outcome.counts['ended by themselves'] += 1
        if code not in (0, 1) or left:
            what = ('no end' if code is None else f'exit {code}: {last_line(flying.said())}'
                    if code not in (0, 1) else f'left: {"; ".join(left)}')
            place = flying.kept(keep / f'attack-flights-{seed}')
            outcome.failures.append(f'{form}: {what} (kept in {place})')
    return outcome


def last_line(text: str) -> str:
    """Return the last line that says anything."""
    return next((line for line in reversed(text.splitlines()) if line.strip()), 'nothing said')
