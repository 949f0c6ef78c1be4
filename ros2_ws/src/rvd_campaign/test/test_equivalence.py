"""Tests of a difference against a margin: the likelihood itself, false alarms, symmetry."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import minimize_scalar
from scipy.stats import binom, norm

from rvd_campaign.campaign.equivalence import equivalence, most_likely, score

COUNTS = [(83, 88, 69, 76), (76, 100, 91, 100), (7790, 10_000, 76, 100), (9, 10, 3, 10),
          (0, 20, 1, 30)]


def deviation(a, n, b, m, difference):
    """Return the score statistic at the maximum of the likelihood, searched on a grid."""
    low, high = max(0.0, difference), min(1.0, 1.0 + difference)
    for _ in range(12):                             # each time ten points either way of the best
        p = np.linspace(low, high, 2001)
        best = p[np.argmax(binom.logpmf(a, n, p) + binom.logpmf(b, m, p - difference))]
        reach = (high - low)/200
        low, high = max(low, best - reach), min(high, best + reach)
    q = best - difference
    return (a/n - b/m - difference)/np.sqrt(best*(1 - best)/n + q*(1 - q)/m)


@pytest.mark.parametrize('counts', COUNTS)
def test_statistic_and_p_are_those_at_the_maximum_of_the_likelihood(counts):
    """
    The likelihood settles it: statsmodels 0.15.0 differs in the second digit of the statistic.

    Its cubic has successes times difference where the equation of Miettinen and Nurminen has runs.
    """
    a, n, b, m = counts
    differences = (-0.1, 0.1, 0.2)
    assert_allclose([score(a/n, n, b/m, m, d) for d in differences],
                    [deviation(*counts, d) for d in differences], rtol=1e-6)
    found = equivalence(*counts, 0.1)
    below, above = norm.sf(deviation(*counts, -0.1)), norm.cdf(deviation(*counts, 0.1))
    assert_allclose([found.p_not_inferior, found.p_equivalent], [below, max(below, above)],
                    rtol=1e-5)


@pytest.mark.parametrize('counts', COUNTS)
@pytest.mark.parametrize('difference', [-0.3, -0.05, 0.0, 0.15])
def test_the_cubic_has_the_maximum_of_the_likelihood(counts, difference):
    a, n, b, m = counts

    def unlikely(p):
        return -binom.logpmf(a, n, p) - binom.logpmf(b, m, p - difference)
    low, high = max(0.0, difference) + 1e-9, min(1.0, 1.0 + difference) - 1e-9
    best = minimize_scalar(unlikely, bounds=(low, high), method='bounded',
                           options={'xatol': 1e-10}).x
    assert_allclose(most_likely(a/n, n, b/m, m, difference), best, atol=1e-5)


@pytest.mark.parametrize('people, p', [(100, 0.76), (100, 0.91), (40, 0.9)])
@pytest.mark.parametrize('margin', [0.05, 0.1])
def test_false_alarms_are_as_rare_as_is_said(people, p, margin):
    """
    Exact: the true difference is the margin, and each outcome counts with its probability.

    4,000 runs against people's few; a score test may exceed its 5 % a little.
    """
    runs, known = 4000, np.arange(people + 1)
    weight = binom.pmf(known, people, p)
    k = np.unique(binom.ppf(np.linspace(0.001, 0.999, 41), runs, p - margin))
    share = np.diff(np.concatenate([[0.0], 0.5*(binom.cdf(k, runs, p - margin)[1:]
                                                + binom.cdf(k, runs, p - margin)[:-1]), [1.0]]))
    alarms = both = 0.0
    for successes, w in zip(k, share):
        for mine, v in zip(known, weight):
            if w*v > 1e-7:
                found = equivalence(float(successes), runs, float(mine), people, margin)
                alarms += w*v*(found.p_not_inferior < 0.05)
                both += w*v*(found.p_equivalent < 0.05)
    assert 0.02 < alarms < 0.08
    assert both <= alarms


def test_equal_rates_are_found_equivalent_by_enough_runs_and_not_by_few():
    assert equivalence(9000, 10_000, 9000, 10_000, 0.05).p_equivalent < 1e-20
    assert equivalence(45, 50, 45, 50, 0.05).p_equivalent > 0.05


def test_clusters_weigh_less_by_their_design_effect():
    """Against so many runs that only people scatter, z falls as the root of their number."""
    whole = score(0.8, 1e9, 0.85, 100, -0.1)
    assert_allclose(whole, 0.05/np.sqrt(0.9*0.1/100), rtol=1e-5)
    assert_allclose(score(0.8, 1e9, 0.85, 100/3.6, -0.1), whole/np.sqrt(3.6), rtol=1e-5)
    found = equivalence(8e8, 1e9, 85/3.6, 100/3.6, 0.1)
    assert_allclose(found.p_not_inferior, norm.sf(whole/np.sqrt(3.6)), rtol=1e-4)


def test_turned_around_the_difference_has_the_other_sign_and_equivalence_is_the_same():
    one, other = equivalence(76, 100, 70, 90, 0.15), equivalence(70, 90, 76, 100, 0.15)
    assert_allclose(one.difference, -other.difference)
    assert_allclose(one.p_equivalent, other.p_equivalent, rtol=1e-10)
