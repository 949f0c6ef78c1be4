"""
`./rvd calibrate`: fits the pilot to condition 1 and says what condition 1 can tell.

Target  the paper's condition 1 (manual, 100 runs): its success rate and, over successes, its
        means (`lunar_approach.campaigns`). Nothing of condition 2 is looked at.
Fit     the first free number makes the success rate the paper's (a root); a second one, if asked
        for, then brings the means closest (least squares in the paper's standard errors).
        Every look at a pilot flies the same runs with the same draws, so that looks differ
        by the pilot alone.
Limits  the paper prints no deviations: standard errors of the means are taken from the model's
        scatter over 76 runs, and ten people's runs are not independent.
Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, Table 3.
"""

import argparse
import re
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from math import exp, log, sqrt
from pathlib import Path
from typing import NamedTuple

import joblib
import numpy as np
from numpy.typing import NDArray

from rvd_campaign import catalogue
from rvd_campaign.campaign import engine, stats
from rvd_campaign.campaign.results import Stretch, Table
from rvd_campaign.campaign.software import software
from rvd_campaign.campaign.standstill import Standstill, STOPPED_S
from rvd_campaign.exits import CannotRun, check_file, EXIT_DONE
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import load, nearest, Scenario
from rvd_dynamics.recording import whole
from rvd_groundstation.operators.pilot import form_of, keys_of, PERSONS, PilotForm
from rvd_missions.lunar_approach import MISSION
from rvd_missions.lunar_approach.campaigns import PAPER_MEANS, PAPER_RUNS, PAPER_SUCCESSES

MEASURES = tuple(PAPER_MEANS)                   # whose means the paper gives
STATISTICS = ('success', *MEASURES)
TARGET = np.array([PAPER_SUCCESSES / PAPER_RUNS, *PAPER_MEANS.values()])
WIDTH = max(14, *map(len, STATISTICS))          # of a column, in characters
SPREADS = (0.0, 0.1, 0.2, 0.35, 0.5)            # of the profile
STEP = 0.1                                      # relative, of the derivatives
FAR = 1e3                                       # [standard errors] of what cannot be fitted
BLOCKS = 20                                     # of runs, for the noise of a derivative
BATCH = 500


class Look(NamedTuple):
    """What a pilot did in the runs that every pilot flies."""

    success: NDArray[np.bool_]          # (runs,)
    values: NDArray[np.float64]         # (measures, runs) of `MEASURES`; NaN where not reached

    def statistics(self, part: slice = slice(None)) -> NDArray[np.float64]:
        """Return the success rate and the means over successes, shape (1 + measures,)."""
        good = self.success[part]
        means = [v[part][good].mean() if good.any() else np.nan for v in self.values]
        return np.array([good.mean(), *means])

    def errors(self) -> NDArray[np.float64]:
        """Return the standard errors of the paper's statistics, shape (1 + measures,)."""
        p, good = PAPER_SUCCESSES / PAPER_RUNS, self.success
        return np.array([sqrt(p*(1 - p)/PAPER_RUNS),
                         *(v[good].std() / sqrt(PAPER_SUCCESSES) for v in self.values)])


@dataclass
class Bench:
    """Flies pilots by hand, all with the same draws."""

    scenario: Scenario
    runs: int
    pool: joblib.Parallel

    def look(self, *pilots: PilotForm) -> list[Look]:
        """Return what each pilot does."""
        code = software(self.scenario.mission)
        parts = [Stretch(0, first, min(BATCH, self.runs - first))
                 for first in range(0, self.runs, BATCH)]
        scenarios = [self._with(pilot) for pilot in pilots]
        flown = self.pool(
            joblib.delayed(engine.fly_together)([(s, part) for s in some], code, 0)
            for part in parts for some in _handfuls(scenarios))
        tables = [table for made in flown for _, table, _ in made]      # by part, then pilot
        return [_look(tables[i::len(pilots)]) for i in range(len(pilots))]

    def _with(self, pilot: PilotForm) -> Scenario:
        values = {k.replace('.', '__'): v for k, v in keys_of(pilot).items()}
        return self.scenario.with_values('operator_model', **values)


def _handfuls(scenarios: list[Scenario]) -> list[list[Scenario]]:
    """Return the scenarios in groups that share their draws."""
    return [scenarios[i:i + engine.TOGETHER]
            for i in range(0, len(scenarios), engine.TOGETHER)]


def _look(tables: list[Table]) -> Look:
    def column(name: str) -> NDArray:
        return np.concatenate([t[name] for t in tables])
    return Look(column('success'), np.array([column(name) for name in MEASURES]))


# -- the fit ---------------------------------------------------------------------------------

def fit(bench: Bench, pilot: PilotForm, free: list[str]) -> tuple[PilotForm, Look]:
    """
    Return the pilot whose statistics are those of condition 1, and what he does.

    Raises
    ------
    ValueError
        If no value of the first free number gives the success rate.
    """
    if len(free) == 1:
        return fit_success(bench, pilot, free[0])
    best: list[tuple[float, PilotForm, Look]] = []

    def misfit(value: float) -> float:
        try:
            fitted, look = fit_success(bench, _with(pilot, free[1], value), free[0])
        except BadInput as error:
            print(f'  {free[1]} {value:.4g}: {error}', flush=True)
            return FAR
        best.append((distance(look), fitted, look))
        print(f'  {free[1]} {value:.4g}: {free[0]} {getattr(fitted, free[0]):.4g}, the means '
              f'miss by {best[-1][0]:.2f} standard errors', flush=True)
        return best[-1][0]

    from scipy.optimize import minimize_scalar
    low, high = bounds(pilot, free[1])
    minimize_scalar(misfit, bounds=(low, high), method='bounded',
                    options={'maxiter': 9, 'xatol': 0.02*(high - low)})
    if not best:
        raise BadInput(f'no {free[0]} gives a success rate of {TARGET[0]:g}, whatever {free[1]} '
                       f'between {low:.3g} and {high:.3g}')
    _, fitted, look = min(best, key=lambda made: made[0])
    return fitted, look


def distance(look: Look) -> float:
    """Return how far the means are from the paper's [standard errors]."""
    miss = ((look.statistics() - TARGET) / look.errors())[1:]
    return float(sqrt(sum(m*m for m in miss)))


def fit_success(bench: Bench, pilot: PilotForm, name: str) -> tuple[PilotForm, Look]:
    """Return the pilot with the value of `name` at which the success rate is the paper's."""
    seen: dict[float, Look] = {}

    def excess(at: float) -> float:
        if at not in seen:
            seen[at], = bench.look(_with(pilot, name, exp(at)))
        return float(seen[at].success.mean() - TARGET[0])

    low, high = map(log, bounds(pilot, name))
    at = root(excess, min(max(log(getattr(pilot, name)), low), high), low, high,
              0.5 / bench.runs)
    if at is None:
        raise BadInput(f'no {name} between {exp(low):.3g} and {exp(high):.3g} gives a success '
                       f'rate of {TARGET[0]:g}')
    return _with(pilot, name, exp(at)), seen[at]


def root(f: Callable[[float], float], start: float, low: float, high: float, small: float
         ) -> float | None:
    """Return where |f| is at most `small`, or as small as its steps allow; None: no root."""
    a, fa, reach = start, f(start), 0.08
    if abs(fa) <= small:
        return a
    while True:                                 # a neighbour on the other side of zero
        sides = [(x, f(x)) for x in (max(start - reach, low), min(start + reach, high))]
        across = [(x, fx) for x, fx in sides if fx*fa <= 0.0]
        if across:
            b, fb = across[0]
            break
        if sides[0][0] <= low and sides[1][0] >= high:
            return None
        reach *= 2.5
    for _ in range(8):                          # Illinois: regula falsi that cannot stick
        if abs(fb) <= small or abs(b - a) < 1e-3:
            break
        c = b - fb*(b - a)/(fb - fa)
        fc = f(c)
        if fc*fb <= 0.0:
            a, fa = b, fb
        else:
            fa *= 0.5
        b, fb = c, fc
    return b if abs(fb) <= abs(f(a)) else a


def bounds(pilot: PilotForm, name: str) -> tuple[float, float]:
    """Return between which values a number is looked for."""
    value = getattr(pilot, name)
    if name == 'skill_spread':
        return 0.02, 0.7
    limit = 1.0 if name.endswith(('_trust', '_fraction')) else 4.0*value
    return value/4.0, min(4.0*value, limit)


# -- what it can tell ------------------------------------------------------------------------

class Sensitivity(NamedTuple):
    """How the statistics answer to one number, in the paper's standard errors per 100 %."""

    name: str
    answer: NDArray[np.float64]         # (statistics,)
    noise: NDArray[np.float64]          # (statistics,) standard error of `answer`


def sensitivities(bench: Bench, pilot: PilotForm, errors: NDArray) -> list[Sensitivity]:
    """Return the answers to every number of the pilot that is not zero, largest first."""
    names = numbers(pilot)
    pilots = [_with(pilot, name, getattr(pilot, name) * (1.0 + sign*STEP))
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
            _with(pilot, name, getattr(pilot, name) * (1.0 + sign*STEP))
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


def _with(pilot: PilotForm, name: str, value: float) -> PilotForm:
    return replace(pilot, **{name: value})
