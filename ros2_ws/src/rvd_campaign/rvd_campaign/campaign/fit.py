"""
Fits a pilot's free numbers to condition 1 of the paper.

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

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import exp, log, sqrt
from typing import NamedTuple

import joblib
import numpy as np
from numpy.typing import NDArray

from rvd_campaign.campaign import engine
from rvd_campaign.campaign.results import Stretch, Table
from rvd_campaign.campaign.software import software
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import Scenario
from rvd_groundstation.operators.pilot import keys_of, PilotForm
from rvd_missions.lunar_approach.campaigns import PAPER_MEANS, PAPER_RUNS, PAPER_SUCCESSES

MEASURES = tuple(PAPER_MEANS)                   # whose means the paper gives
STATISTICS = ('success', *MEASURES)
TARGET = np.array([PAPER_SUCCESSES / PAPER_RUNS, *PAPER_MEANS.values()])
FAR = 1e3                                       # [standard errors] of what cannot be fitted
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
            fitted, look = fit_success(bench, changed(pilot, free[1], value), free[0])
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
            seen[at], = bench.look(changed(pilot, name, exp(at)))
        return float(seen[at].success.mean() - TARGET[0])

    low, high = map(log, bounds(pilot, name))
    at = root(excess, min(max(log(getattr(pilot, name)), low), high), low, high,
              0.5 / bench.runs)
    if at is None:
        raise BadInput(f'no {name} between {exp(low):.3g} and {exp(high):.3g} gives a success '
                       f'rate of {TARGET[0]:g}')
    return changed(pilot, name, exp(at)), seen[at]


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


def changed(pilot: PilotForm, name: str, value: float) -> PilotForm:
    """Return the pilot with another value of one number."""
    return replace(pilot, **{name: value})
