"""
`./rvd bench attack`: hostile frames, messages, files and signals, counted, each with its seed.

A kind of attack is a module with `attack() -> Kind`. What it does is split into cases, each from a
seed of its own, so that a failure is repeated alone: `--seed SEED --count 1`. Nothing here says
how fast anything is.
"""

import argparse
from collections import Counter
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
import importlib
import json
from pathlib import Path
import statistics
import time
from typing import Any

from rvd_dynamics.bad_input import one_line
from rvd_campaign.bench import processes
from rvd_campaign.exits import (
    CannotRun, check_file, EXIT_DONE, EXIT_FAILED, EXIT_INTERRUPTED)
from rvd_campaign.interrupts import all_like_ctrl_c

KINDS = ('frames', 'messages', 'dds', 'bags', 'texts', 'kills', 'flights')
SHOW_S = 10.0                   # [s] wall time between two lines of progress
SHOWN = 5                       # failures of a kind that are printed; all are in the file


@dataclass
class Outcome:
    """
    What came of a case: how often what happened, and what should not have.

    `attacked` is how many of the kind's unit it was; None: as many as every case is.
    """

    counts: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)       # one line each
    values: dict[str, list[float]] = field(default_factory=dict)
    attacked: int | None = None


Case = Callable[[int], Outcome]


@dataclass(frozen=True)
class Kind:
    """
    One kind of attack.

    `open` sets up what all cases need and gives the case, a function of its seed; it may depend on
    where failing runs are kept. `zero` names the counts that must be 0, `all` those that must be
    as many as were attacked. `per_case` counts as one in `--count`: frames come by the thousand.
    """

    name: str
    words: str                  # what is attacked with what
    unit: str                   # of the count
    whole: int
    quick: int
    open: Callable[[Path], AbstractContextManager[Case]]
    per_case: int = 1
    zero: tuple[str, ...] = ()
    all: tuple[str, ...] = ()


def kind(name: str) -> Kind:
    """Return a kind of attack by its name."""
    return importlib.import_module(f'rvd_campaign.bench.attack.{name}').attack()


def main(args: argparse.Namespace) -> int:
    """Attack as asked, print the table, write the JSON; return the exit code."""
    wanted = args.kinds or list(KINDS)
    unknown = [name for name in wanted if name not in KINDS]
    if unknown:
        raise CannotRun(f'bench attack: no kind {unknown[0]!r}, there are: {", ".join(KINDS)}')
    if args.count is not None and args.count < 1:
        raise CannotRun(f'--count must be 1 or more, got {args.count}')
    if args.seed is not None and not 0 <= args.seed < 1 << 32:
        raise CannotRun(f'--seed must be from 0 to {(1 << 32) - 1}, got {args.seed}')
    if args.out:
        check_file('--out', args.out, new=False)
    content: dict[str, Any] = {
        'machine': processes.machine(),
        'time': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'attack': {}}
    all_like_ctrl_c()                           # what flies is ended, then
    held, interrupted = True, False
    for name in dict.fromkeys(wanted):
        chosen = kind(name)
        count = args.count or (chosen.quick if args.quick else chosen.whole)
        print(f'\n{name}: {chosen.words}', flush=True)
        result = run(chosen, count, args.seed or 0, Path.cwd())
        content['attack'][name] = result
        for text in table(chosen, result):
            print(text, flush=True)
        held = held and not result['failures']
        interrupted = result['interrupted']
        if interrupted:
            break
    if args.out:
        Path(args.out).write_text(json.dumps(content, indent=2) + '\n', encoding='utf-8')
        print(f'\n{args.out}')
    return EXIT_INTERRUPTED if interrupted else EXIT_DONE if held else EXIT_FAILED


def run(chosen: Kind, count: int, seed: int, keep: Path) -> dict[str, Any]:
    """
    Attack `count` times, from a seed on; runs that fail are kept in the folder `keep`.

    A Ctrl-C ends it with what there is.
    """
    counts: Counter[str] = Counter()
    failures: list[dict[str, Any]] = []
    values: dict[str, list[float]] = {}
    begun = shown = time.monotonic()
    done, interrupted = 0, False
    try:
        with chosen.open(keep) as case:
            while done < count:
                outcome = case(seed)
                done += chosen.per_case if outcome.attacked is None else outcome.attacked
                counts.update(outcome.counts)
                for name, some in outcome.values.items():
                    values.setdefault(name, []).extend(some)
                failures += [{'seed': seed, 'what': one_line(what), 'again':
                              f'./rvd bench attack {chosen.name} --seed {seed} --count 1'}
                             for what in outcome.failures]
                seed += 1
                if time.monotonic() - shown > SHOW_S:
                    shown = time.monotonic()
                    print(f'  {done:,} of {count:,} {chosen.unit} in {shown - begun:.0f} s, '
                          f'{len(failures)} failures', flush=True)
    except KeyboardInterrupt:
        interrupted = True
    return {'count': done, 'unit': chosen.unit, 'next_seed': seed,
            'counts': dict(counts), 'failures': failures, 'interrupted': interrupted,
            'values': {name: _spread(some) for name, some in values.items()},
            'wall_s': round(time.monotonic() - begun, 1)}


def _spread(values: list[float]) -> dict[str, float]:
    return {'median': round(statistics.median(values), 3), 'longest': round(max(values), 3),
            'number': len(values)}


def table(chosen: Kind, result: dict[str, Any]) -> list[str]:
    """Return the lines that say how it went."""
    counts, done = Counter(result['counts']), result['count']
    rows = [(f'{chosen.unit}{" (interrupted)" * result["interrupted"]}', f'{done:,}', '', None)]
    rows += [(name, f'{counts[name]:,}', '0', counts[name] == 0) for name in chosen.zero]
    rows += [(name, f'{counts[name]:,}', f'{done:,}', counts[name] == done)
             for name in chosen.all]
    rows += [(name, f'{counts[name]:,}', '', None) for name in sorted(counts)
             if name not in {*chosen.zero, *chosen.all}]
    rows += [(f'{name}: {which}', f'{spread[which]:.2f}', '', None)
             for name, spread in result['values'].items() for which in ('median', 'longest')]
    lines = [f'  {what:<44} {figure:>12}   {target:<10} '
             f'{ {True: "held", False: "NOT held", None: ""}[met]}'.rstrip()
             for what, figure, target, met in rows]
    failures = result['failures']
    for failure in failures[:SHOWN]:
        lines += [f'  seed {failure["seed"]}: {failure["what"]}', f'    {failure["again"]}']
    if len(failures) > SHOWN:
        lines.append(f'  and {len(failures) - SHOWN} more failures; --out FILE has them all')
    return lines

