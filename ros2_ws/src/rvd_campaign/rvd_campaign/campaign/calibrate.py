"""
`./rvd calibrate`: fits the pilot to condition 1 (`fit`) and says what condition 1 can tell.

Answers of the statistics to each number are derivatives by central differences, their noise that
of blocks of runs; combinations that can be told apart are singular values of the answers.
"""

import argparse
import re
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from dataclasses import fields, replace
from math import sqrt
from pathlib import Path
from typing import NamedTuple

import joblib
import numpy as np
from numpy.typing import NDArray

from rvd_campaign import catalogue
from rvd_campaign.campaign import engine, stats
from rvd_campaign.campaign.fit import (
    Bench, changed, distance, fit, fit_success, Look, STATISTICS, TARGET)
from rvd_campaign.campaign.standstill import Standstill, STOPPED_S
from rvd_campaign.exits import CannotRun, check_file, EXIT_DONE
from rvd_dynamics.diagram.scenario import load, nearest, Scenario
from rvd_dynamics.recording import whole
from rvd_groundstation.operators.pilot import form_of, keys_of, PERSONS, PilotForm
from rvd_missions.lunar_approach import MISSION

WIDTH = max(14, *map(len, STATISTICS))          # of a column, in characters
SPREADS = (0.0, 0.1, 0.2, 0.35, 0.5)            # of the profile
STEP = 0.1                                      # relative, of the derivatives
BLOCKS = 20                                     # of runs, for the noise of a derivative


# -- what it can tell ------------------------------------------------------------------------

class Sensitivity(NamedTuple):
    """How the statistics answer to one number, in the paper's standard errors per 100 %."""

    name: str
    answer: NDArray[np.float64]         # (statistics,)
    noise: NDArray[np.float64]          # (statistics,) standard error of `answer`


def sensitivities(bench: Bench, pilot: PilotForm, errors: NDArray) -> list[Sensitivity]:
    """Return the answers to every number of the pilot that is not zero, largest first."""
    names = numbers(pilot)
    pilots = [changed(pilot, name, getattr(pilot, name) * (1.0 + sign*STEP))
              for name in names for sign in (1, -1)]
    looks = bench.look(*pilots)
    made = []
    for i, name in enumerate(names):
        up, down = looks[2*i], looks[2*i + 1]
        scale = 2.0*STEP*errors
        size = max(bench.runs // BLOCKS, 1)
        parts = [slice(at, at + size) for at in range(0, bench.runs, size)]
        blocks = np.array([up.statistics(p) - down.statistics(p) for p in parts])
        made.append(Sensitivity(
            name, (up.statistics() - down.statistics()) / scale,
            np.nanstd(blocks, axis=0, ddof=1) / sqrt(len(parts)) / scale))
    return sorted(made, key=lambda s: -float(np.abs(s.answer).max()))


def numbers(pilot: PilotForm) -> list[str]:
    """Return the numbers that can be moved by a tenth and matter for this pilot."""
    return [f.name for f in fields(pilot)
            if isinstance(getattr(pilot, f.name), float) and getattr(pilot, f.name) > 0.0
            and f.name not in pilot.idle and _movable(pilot, f.name)]


def _movable(pilot: PilotForm, name: str) -> bool:
    try:
        for sign in (1, -1):
            changed(pilot, name, getattr(pilot, name) * (1.0 + sign*STEP))
    except ValueError:
        return False
    return True


def combinations(found: list[Sensitivity]) -> tuple[NDArray, NDArray]:
    """
    Return the singular values (statistics,) of the answers, and what noise alone makes of each.

    A value below 1 says: the best combination of numbers, moved by 100 % in all, moves the
    statistics by less than one standard error of the paper's experiment. Noise never cancels in
    a singular value: that of many blind numbers adds up.
    """
    matrix = np.array([s.answer for s in found]).T
    left, values, _ = np.linalg.svd(matrix, full_matrices=False)
    noise = np.array([s.noise for s in found])
    return values, np.sqrt(np.einsum('ik,ji->k', left*left, noise*noise))


def seen(values: NDArray, floor: NDArray, count: int) -> int:
    """Return how many combinations stand out of the noise of `count` answers and matter."""
    beyond = values*values - floor*floor
    clear = beyond > 3.0*sqrt(2.0/count) * floor*floor      # three deviations of a noise sum
    return int((clear & (beyond > 1.0)).sum())


# -- the command -----------------------------------------------------------------------------

def main(args: argparse.Namespace) -> int:
    """Fit a pilot as the command line asks; return the exit code."""
    pilot, free, scenario = _asked(args)
    out = Path(args.out or f'pilot_{Path(args.pilot).stem}.yaml')
    check_file('--out', str(out))
    count = args.workers or engine.default_workers()
    with _workers_alive(), joblib.parallel_config('loky', inner_max_num_threads=1), \
            joblib.Parallel(n_jobs=count) as pool:
        bench = Bench(scenario, args.runs, pool)
        print(f'fitting {", ".join(free)} of pilot {args.pilot}: {args.runs:,} manual runs each '
              f'look, seed {args.seed}', flush=True)
        fitted, look = fit(bench, pilot, free)
        lines = fit_in_words(fitted, look, free)
        print('\n'.join(lines), flush=True)
        if not args.quick:
            more = study(bench, fitted, look, free[0])
            print('\n'.join(more), flush=True)
            lines += more
    print(whole.save(out, pilot_file(fitted, args, free, lines)))
    return EXIT_DONE


@contextmanager
def _workers_alive() -> Iterator[None]:
    """Say in one line that a worker was killed, or stopped for good."""
    with Standstill() as standstill:
        try:
            yield
        except BrokenExecutor as error:
            how = (f'was stopped for {STOPPED_S:g} s' if standstill.ended
                   else engine.how_it_ended(error))
            raise CannotRun(f'a worker {how}: nothing is kept, calibrate again') from None


def _asked(args: argparse.Namespace) -> tuple[PilotForm, list[str], Scenario]:
    if not 100 <= args.runs <= 1_000_000:
        raise CannotRun(f'--runs must be 100 to 1000000, got {args.runs}')
    if args.workers is not None and args.workers < 1:
        raise CannotRun(f'--workers must be at least 1, got {args.workers}')
    scenario = load(catalogue.find('scenarios', args.scenario, ('.yaml',)))
    if scenario.mission.name != MISSION.name:
        raise CannotRun(f'--scenario {args.scenario}: only pilots of {MISSION.name} can be fitted, '
                        f'and this is mission {scenario.mission.name}')
    scenario = scenario.with_values('/**', seed=args.seed, run=0, mode='manual', operator='model')
    pilot = _pilot(args.pilot)
    if not numbers(pilot):
        raise CannotRun(f'pilot {args.pilot}: form {form_of(pilot)} has no number to fit')
    free = (args.free or pilot.fitted_first).split(',')
    for name in free:
        if name not in numbers(pilot):
            raise CannotRun(f'--free: no number {name} in this pilot'
                            + nearest(name, numbers(pilot)))
    if len(set(free)) != len(free) or len(free) > 2:
        raise CannotRun(f'--free takes one number or two different ones: {len(STATISTICS)} '
                        'statistics tell no more')
    return pilot, free, scenario


def _pilot(given: str) -> PilotForm:
    """Return the pilot of a name or a file."""
    if given in PERSONS:
        return PERSONS[given]
    if Path(given).is_file():
        return load(Path(given)).settings('operator_model').selected
    raise CannotRun(f'no pilot {given!r}: give a file or one of {", ".join(PERSONS)}')


def fit_in_words(pilot: PilotForm, look: Look, free: list[str]) -> list[str]:
    """Return what was fitted and how close it comes."""
    found, errors = look.statistics(), look.errors()
    fitted = ' and '.join(f'{name} = {getattr(pilot, name):.4g}' for name in free)
    lines = [f'fitted to condition 1: {fitted}',
             f'  {"":<{WIDTH}} {"here":>8} {"paper":>8}  paper\'s standard error']
    for name, value, target, error in zip(STATISTICS, found, TARGET, errors):
        lines.append(f'  {name:<{WIDTH}} {value:8.4f} {target:8.4f} {error:8.4f}')
    low, high = stats.wilson(int(look.success.sum()), len(look.success))
    lines.append(f'  success here has a 95 % interval of [{low:.4f}, {high:.4f}]')
    return lines


def study(bench: Bench, pilot: PilotForm, look: Look, name: str) -> list[str]:
    """Return in words what condition 1 identifies and what it does not."""
    errors = look.errors()
    found = sensitivities(bench, pilot, errors)
    still = [s.name for s in found if not (s.answer.any() or s.noise.any())]
    found = [s for s in found if s.name not in still]
    values, floor = combinations(found)
    visible = seen(values, floor, len(found))
    own = next(s for s in found if s.name == name)
    lines = [
        '', f'{name} by itself: known to {100/abs(own.answer[0]):.0f} % (one standard error of '
            f'the paper\'s 100 runs) from the success rate',
        f'{len(found)} numbers against {len(STATISTICS)} statistics. Combinations of numbers '
        'that the statistics answer to,', 'strongest first, in standard errors per 100 % (in '
        'brackets: what noise alone would make): '
        + ', '.join(f'{v:.1f} ({n:.1f})' for v, n in zip(values, floor)),
        f'These runs see {visible} of them; of the other {len(found) - visible} combinations '
        'condition 1 tells nothing that they could see.',
        *([f'A tenth more or less moves nothing, as time goes in whole steps: {", ".join(still)}']
          if still else []),
        '', f'{"answer to +100 % of":<24} {_heads()}  (standard errors, +- noise)']
    for s in found:
        cells = '  '.join(f'{f"{a:.1f} +- {n:4.1f}":>{WIDTH}}'
                          for a, n in zip(s.answer, s.noise))
        lines.append(f'  {s.name:<22} {cells}')
    return lines + (profile(bench, pilot, name) if hasattr(pilot, 'skill_spread') else [])


def profile(bench: Bench, pilot: PilotForm, name: str) -> list[str]:
    """Return the valley: every spread of skill fits the success rate with its own `name`."""
    lines = ['', f'skill_spread  {name:<17} {_heads()}  the means miss by']
    for spread in SPREADS:
        try:
            fitted, look = fit_success(bench, replace(pilot, skill_spread=spread), name)
        except ValueError:
            lines.append(f'  {spread:<11g} cannot reach {TARGET[0]:g}')
            continue
        cells = '  '.join(f'{value:>{WIDTH}.4f}' for value in look.statistics())
        lines.append(f'  {spread:<11g} {getattr(fitted, name):<17.4g} {cells}  '
                     f'{distance(look):.1f} standard errors')
    return lines


def _heads() -> str:
    return '  '.join(f'{name:>{WIDTH}}' for name in STATISTICS)


def pilot_file(pilot: PilotForm, args: argparse.Namespace, free: list[str], lines: list[str]
               ) -> str:
    """Return the text of a pilot file: a scenario section, and what was fitted as comment."""
    head = [f'Pilot {Path(args.pilot).stem}, {", ".join(free)} fitted by rvd calibrate '
            '(condition 1 of the paper only).',
            f'{args.runs} manual runs of scenario {args.scenario}, seed {args.seed}.', *lines]
    body = [f'    {key}: {_yaml(value)}'
            + ('     # fitted' if key.rpartition('.')[2] in free else '')
            for key, value in keys_of(pilot).items()]
    return '\n'.join([*(f'# {line}'.rstrip() for line in head), 'operator_model:',
                      '  ros__parameters:', *body, ''])


def _yaml(value: object) -> str:
    text = (value if isinstance(value, str) and value else
            str(value).lower() if isinstance(value, bool) else repr(value))
    return re.sub(r'^(\d+)e', r'\1.0e', text)
