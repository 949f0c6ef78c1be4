"""
Whether two success rates are the same within a margin that was stated before: what an interval
that includes 0 does not say.

Score test      C. P. Farrington, G. Manning, Stat. Med. 9, 1990, 1447-1454: the difference of two
                independent proportions against one that is not 0, with the variance at the most
                likely proportions that differ by it.
Equivalence     D. J. Schuirmann, J. Pharmacokinet. Biopharm. 15, 1987, 657-680: two one-sided
                tests, each at 5 %; both refuse, or nothing is shown. Non-inferiority is one of
                them.
Clusters        flights of the same people are worth fewer than they are: n over the design effect.
                L. Kish, Survey Sampling, 1965.
"""

from math import acos, copysign, cos, pi, sqrt
from typing import NamedTuple


class Equivalence(NamedTuple):
    """How a difference of success rates stands to a margin."""

    difference: float
    margin: float
    p_not_inferior: float               # of a true difference of -margin or less
    p_equivalent: float                 # of one that is not inside of the margin


def equivalence(successes_a: float, runs_a: float, successes_b: float, runs_b: float,
                margin: float) -> Equivalence:
    """
    Test a - b against a margin, from below and from both sides; numbers may be effective ones.

    Parameters
    ----------
    successes_a, runs_a, successes_b, runs_b : float
        Divided by the design effect where they come in clusters.
    margin : float
        Largest difference that counts as none, above 0 and below 1.
    """
    from scipy.stats import norm
    a, b = successes_a/runs_a, successes_b/runs_b
    below = float(norm.sf(score(a, runs_a, b, runs_b, -margin)))
    above = float(norm.cdf(score(a, runs_a, b, runs_b, margin)))
    return Equivalence(a - b, margin, below, max(below, above))


def score(a: float, runs_a: float, b: float, runs_b: float, difference: float) -> float:
    """Return the deviation of a - b from `difference`, in its standard errors there."""
    most_a = most_likely(a, runs_a, b, runs_b, difference)
    most_b = most_a - difference
    variance = most_a*(1.0 - most_a)/runs_a + most_b*(1.0 - most_b)/runs_b
    off = a - b - difference
    return off/sqrt(variance) if variance > 0.0 else copysign(float('inf'), off)


def most_likely(a: float, runs_a: float, b: float, runs_b: float, difference: float) -> float:
    """
    Return the most likely first proportion where the second one is less by `difference`.

    The root of a cubic (Farrington and Manning, appendix).
    """
    ratio = runs_b/runs_a
    third = 1.0 + ratio
    second = -(1.0 + ratio + a + ratio*b + difference*(ratio + 2.0))
    first = difference**2 + difference*(2.0*a + ratio + 1.0) + a + ratio*b
    constant = -a*difference*(1.0 + difference)
    v = (second/(3.0*third))**3 - second*first/(6.0*third**2) + constant/(2.0*third)
    u = copysign(sqrt(max((second/(3.0*third))**2 - first/(3.0*third), 0.0)), v)
    angle = (pi + acos(min(max(v/u**3, -1.0), 1.0) if u else 1.0))/3.0
    found = 2.0*u*cos(angle) - second/(3.0*third)
    return min(max(found, 0.0, difference), 1.0, 1.0 + difference)
