"""
Intervals for what a campaign counts and averages; all are 95 %.

Proportions     E. B. Wilson, J. Am. Stat. Assoc. 22, 1927, 209-212: the score interval, which
                neither leaves 0..1 nor collapses where every run succeeds. scipy's.
Differences     R. G. Newcombe, Stat. Med. 17, 1998: of independent proportions pp. 873-890,
                method 10; of paired ones pp. 2635-2650, method 10, with its correction of phi.
                Conditions of a campaign share their random draws run by run, so they are paired.
Of people       E. L. Korn, B. I. Graubard, Survey Methodology 24, 1998, 193-201: Clopper's and
                Pearson's interval of a proportion of flights that come in clusters, here of
                volunteers, for the effective number of flights, corrected for the few degrees
                of freedom.
Means           normal approximation; runs are counted in hundreds and more. Of paired differences
                Student's t: the runs that succeed in both conditions may be few.

`scipy.stats` takes most of a second to import, so that only what calls it does.
"""

from collections.abc import Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rvd_dynamics.bad_input import BadInput


class Interval(NamedTuple):
    """A range that covers the true value in 95 of 100 experiments."""

    low: float
    high: float


class Paired(NamedTuple):
    """Two conditions flown with the same draws."""

    both: int
    only_a: int
    only_b: int
    neither: int

    @property
    def runs(self) -> int:
        """Runs that both conditions have."""
        return self.both + self.only_a + self.only_b + self.neither

    @property
    def difference(self) -> float:
        """Success rate of a minus that of b."""
        return (self.only_a - self.only_b) / self.runs


def wilson(successes: int, runs: int) -> Interval:
    """
    Return the score interval of a proportion.

    Raises
    ------
    ValueError
        If there are no runs, or more successes than runs.
    """
    if not 0 <= successes <= runs or runs < 1:
        raise BadInput(f'successes must be 0 to runs, runs at least 1, got {successes} of '
                       f'{runs}')
    from scipy.stats import binomtest
    found = binomtest(successes, runs).proportion_ci(confidence_level=0.95, method='wilson')
    return Interval(float(found.low), float(found.high))


def clustered(counts: Sequence[tuple[int, int]]) -> Interval | None:
    """
    Return the interval of a proportion whose trials come in clusters, of volunteers for example.

    Parameters
    ----------
    counts : sequence of (int, int)
        Successes and trials of each cluster, at least one trial.

    Returns
    -------
    Interval or None
        For other clusters like these; a single one says nothing of others.
    """
    clusters = len(counts)
    if clusters < 2:
        return None
    from scipy.stats import t
    successes, trials = np.array(counts, dtype=float).T
    n = trials.sum()
    p = successes.sum() / n
    variance = clusters / (clusters - 1) * float(
        ((trials / n)**2 * (successes / trials - p)**2).sum())
    effective = min(n, p*(1 - p)/variance) if variance > 0.0 else n
    return _exact(p, effective*(t.ppf(0.975, n - 1) / t.ppf(0.975, clusters - 1))**2)


def of_design_effect(successes: int, runs: int, effect: float) -> Interval:
    """Return that interval of runs which are worth as many independent ones as runs/effect."""
    return _exact(successes/runs, runs/effect)


def _exact(p: float, flights: float) -> Interval:
    """Return Clopper's and Pearson's interval; flights need not be whole."""
    from scipy.stats import beta
    good, bad = p*flights, (1 - p)*flights
    return Interval(float(beta.ppf(0.025, good, bad + 1)) if good > 0.0 else 0.0,
                    float(beta.ppf(0.975, good + 1, bad)) if bad > 0.0 else 1.0)


def design_effect(rates: ArrayLike, runs: int) -> float:
    """
    Return by how much success rates of experiments scatter more than independent runs would.

    The variance of `rates`, of `runs` runs each, over that of a binomial (Kish, Survey Sampling,
    1965); NaN where all runs end alike.
    """
    rates = np.asarray(rates, dtype=float)
    mean = rates.mean()
    independent = mean*(1.0 - mean)/runs
    return float(rates.var(ddof=1)/independent) if independent > 0.0 else float('nan')


def mean_interval(values: ArrayLike) -> Interval:
    """Return Student's interval of the mean of two or more values."""
    return mean_difference(values, np.zeros(len(values)))[1]


def newcombe(successes_a: int, runs_a: int, successes_b: int, runs_b: int) -> Interval:
    """Return the interval of the difference a - b of independent proportions (method 10)."""
    return _combined(successes_a/runs_a, wilson(successes_a, runs_a),
                     successes_b/runs_b, wilson(successes_b, runs_b), 0.0)


def pair(a: ArrayLike, b: ArrayLike) -> Paired:
    """Count successes of two conditions, run by run, shapes (runs,)."""
    a, b = np.asarray(a, dtype=bool), np.asarray(b, dtype=bool)
    if a.shape != b.shape:
        raise BadInput(f'paired conditions must have the same runs, got {a.size} and {b.size}')
    return Paired(int((a & b).sum()), int((a & ~b).sum()), int((~a & b).sum()),
                  int((~a & ~b).sum()))


def newcombe_paired(table: Paired) -> Interval:
    """Return the interval of the difference a - b of paired proportions (method 10)."""
    n = table.runs
    a, b = table.both + table.only_a, table.both + table.only_b
    return _combined(a/n, wilson(a, n), b/n, wilson(b, n), _phi(table))


def _phi(table: Paired) -> float:
    """Return the correlation of both outcomes, corrected for continuity where positive."""
    e, f, g, h = table.both, table.only_a, table.only_b, table.neither
    spread = (e + f) * (g + h) * (e + g) * (f + h)
    if spread == 0:
        return 0.0
    excess = e*h - f*g
    if excess > 0:
        excess = max(excess - table.runs/2, 0)
    return excess / sqrt(spread)


def _combined(a: float, of_a: Interval, b: float, of_b: Interval, phi: float) -> Interval:
    below_a, above_a = a - of_a.low, of_a.high - a
    below_b, above_b = b - of_b.low, of_b.high - b
    down = below_a*below_a - 2*phi*below_a*above_b + above_b*above_b
    up = above_a*above_a - 2*phi*above_a*below_b + below_b*below_b
    return Interval(a - b - sqrt(max(down, 0.0)), a - b + sqrt(max(up, 0.0)))


def sign_test(table: Paired) -> float:
    """
    Return the two-sided p of the exact test that a and b succeed equally often.

    McNemar's test on the runs that differ.
    """
    n = table.only_a + table.only_b
    if n == 0:
        return 1.0
    from scipy.stats import binomtest
    return float(binomtest(table.only_a, n).pvalue)


def mean(values: ArrayLike) -> tuple[float, float]:
    """Return mean and standard error of the known values; NaN where there are too few."""
    values = np.asarray(values, dtype=float)
    values = values[~np.isnan(values)]
    if values.size == 0:
        return float('nan'), float('nan')
    error = float(values.std(ddof=1) / sqrt(values.size)) if values.size > 1 else float('nan')
    return float(values.mean()), error


def mean_difference(a: ArrayLike, b: ArrayLike) -> tuple[float, Interval]:
    """Return the mean of a - b, run by run, and its interval; NaN where too few are known."""
    difference = np.asarray(a, dtype=float) - np.asarray(b, dtype=float)
    middle, error = mean(difference)
    if np.isnan(error):
        return middle, Interval(error, error)
    from scipy.stats import t
    reach = float(t.ppf(0.975, int((~np.isnan(difference)).sum()) - 1)) * error
    return middle, Interval(middle - reach, middle + reach)
