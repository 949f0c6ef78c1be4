"""
Intervals against published tables, and against what they promise.
"""

from fractions import Fraction
from functools import lru_cache
from math import comb, nan

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import binom, binomtest, norm

from rvd_campaign.campaign import stats
from rvd_campaign.campaign.stats import Paired

# R. G. Newcombe, Stat. Med. 17, 1998, 857-872, Table I, method 3 (score, no continuity
# correction), to the four decimals that are printed.
WILSON = {(81, 263): (.2553, .3662), (15, 148): (.0624, .1605), (0, 20): (.0000, .1611),
          (1, 29): (.0061, .1718)}
# R. G. Newcombe, Stat. Med. 17, 1998, 873-890, Table II, method 10.
UNPAIRED = {(56, 70, 48, 80): (.0524, .3339), (9, 10, 3, 10): (.1705, .8090),
            (6, 7, 2, 7): (.0582, .8062), (5, 56, 0, 29): (-.0381, .1926),
            (0, 10, 0, 20): (-.1611, .2775), (10, 10, 0, 10): (.6075, 1.0)}
# R. G. Newcombe, Stat. Med. 17, 1998, 2635-2650, method 10.
PAIRED = {(36, 12, 2, 0): (.0569, .3404)}


@pytest.mark.parametrize('counts', WILSON)
def test_wilson_as_in_the_published_table(counts):
    assert_allclose(stats.wilson(*counts), WILSON[counts], atol=5e-5)


@pytest.mark.parametrize('counts', [(0, 1), (1, 1), (3, 7), (76, 100), (91, 100), (9945, 10000)])
def test_wilson_ends_are_where_the_score_test_just_refuses(counts):
    # Wilson's equation, (k/n - p)^2 = z^2 p (1 - p) / n, as a polynomial in p.
    successes, runs = counts
    seen, zz = successes/runs, norm.ppf(0.975)**2 / runs
    ends = np.sort(np.roots([1 + zz, -2*seen - zz, seen**2]).real)
    assert_allclose(stats.wilson(*counts), ends, rtol=1e-12, atol=1e-12)


def test_wilson_stays_inside_and_does_not_collapse_at_the_ends():
    assert stats.wilson(0, 50).low == 0.0 < stats.wilson(0, 50).high
    assert stats.wilson(50, 50).high == 1.0 > stats.wilson(50, 50).low


@pytest.mark.parametrize('p', [0.76, 0.91, 0.9945])
def test_wilson_covers_about_95_of_100(p):
    # Exact: the probability of every count whose interval holds p. Newcombe finds .93 to .97.
    n = 10_000
    holds = [k for k, (low, high) in enumerate(every_interval(n)) if low <= p <= high]
    assert 0.94 < binom.pmf(holds, n, p).sum() < 0.96


@lru_cache
def every_interval(runs):
    return [stats.wilson(k, runs) for k in range(runs + 1)]


@pytest.mark.parametrize('counts', [(-1, 5), (6, 5), (0, 0)])
def test_impossible_counts_are_refused(counts):
    with pytest.raises(ValueError, match=str(counts[0])):
        stats.wilson(*counts)


@pytest.mark.parametrize('counts', UNPAIRED)
def test_difference_as_in_the_published_table(counts):
    assert_allclose(stats.newcombe(*counts), UNPAIRED[counts], atol=5e-5)


@pytest.mark.parametrize('counts', PAIRED)
def test_paired_difference_as_published(counts):
    assert_allclose(stats.newcombe_paired(Paired(*counts)), PAIRED[counts], atol=5e-5)


def test_paired_difference_changes_sign_when_the_conditions_change_places():
    low, high = stats.newcombe_paired(Paired(60, 25, 5, 10))
    assert_allclose(stats.newcombe_paired(Paired(60, 5, 25, 10)), (-high, -low))


def test_paired_interval_covers_where_the_unpaired_one_is_too_wide():
    # 2,000 experiments of 300 pairs. A coverage of .95 is seen outside .93 to .97 with a
    # probability below 1e-4 (binomial deviation .0049); the seed is fixed.
    rng, truth, covered, narrower = np.random.default_rng(5), 0.15, 0, 0
    for _ in range(2000):
        b = rng.random(300) < 0.76
        a = b | (rng.random(300) < truth/0.24)
        table = stats.pair(a, b)
        low, high = stats.newcombe_paired(table)
        covered += low <= truth <= high
        loose = stats.newcombe(int(a.sum()), 300, int(b.sum()), 300)
        narrower += high - low < loose.high - loose.low
    assert 0.93 < covered/2000 < 0.97
    assert narrower == 2000


def test_pair_counts_the_four_cells():
    a, b = [1, 1, 1, 0, 0, 0, 0], [1, 0, 0, 1, 0, 0, 0]
    assert stats.pair(a, b) == Paired(1, 2, 1, 3)
    assert stats.pair(a, b).difference == pytest.approx(1/7)
    with pytest.raises(ValueError, match='same runs'):
        stats.pair(a, b[:-1])


@pytest.mark.parametrize('only', [(0, 0), (3, 1), (9, 1), (0, 8), (450, 520), (600, 700),
                                  (2000, 2100)])
def test_sign_test_counts_the_coin_tosses_that_are_as_uneven_or_more(only):
    n, k = sum(only), min(only)
    exact = min(Fraction(2*sum(comb(n, i) for i in range(k + 1)), 2**n), Fraction(1))
    assert_allclose(stats.sign_test(Paired(5, *only, 5)), float(exact), rtol=1e-10)


def test_mean_leaves_out_what_is_unknown():
    assert_allclose(stats.mean([1.0, nan, 3.0]), (2.0, 1.0))
    assert np.isnan(stats.mean([nan])).all()


# -- of people, whose flights come in clusters -----------------------------------------------------

def test_of_many_clusters_that_are_all_alike_the_exact_interval_is_left():
    found = stats.clustered([(4, 5)] * 400)
    exact = binomtest(1600, 2000).proportion_ci(0.95, 'exact')
    assert_allclose(found, exact, atol=2e-4)


def test_a_single_cluster_says_nothing_of_others_and_two_say_little():
    assert stats.clustered([(7, 10)]) is None
    low, high = stats.clustered([(10, 10), (9, 10)])
    assert low < 0.2 and high > 0.999
    assert stats.clustered([(10, 10)] * 3).high == 1.0 and stats.clustered([(0, 9)] * 3).low == 0.0


@pytest.mark.parametrize('people', [3, 6, 12])
def test_it_covers_the_rate_of_the_population_where_wilson_does_not(people):
    rng, flights, rate = np.random.default_rng(5), 10, 2.0/3.0
    own = rng.beta(4.0*rate, 4.0*(1.0 - rate), (1500, people))      # people differ
    made = rng.binomial(flights, own)
    covered = [low <= rate <= high for low, high in (
        stats.clustered([(int(s), flights) for s in row]) for row in made)]
    pooled = [low <= rate <= high for low, high in (
        stats.wilson(int(total), people*flights) for total in made.sum(axis=1))]
    assert np.mean(covered) > 0.94
    assert np.mean(pooled) < 0.85
