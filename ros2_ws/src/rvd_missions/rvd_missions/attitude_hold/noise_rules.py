"""
How a gain should fall with the noise of the measurement: the two theorems of the paper, by formula.

Plant   x(k+1) = A x(k) + b u(k) + w(k),  y(k) = c x(k) + v(k),  E w w^T = W,  E v^2 = Q
P       u(k) = kp y(k):  J = E|x(k+1)|^2 is least, for X = E x x^T, at
        kp* = -b^T A X c^T / (b^T b (c X c^T + Q))
I       u(k) = u(k-1) + ki y(k):  x(k+1) = (A + b ki c) x + b u(k-1) + ki b v; for S = E u(k-1) x^T
        ki* = -b^T (A X c^T + b S c^T) / (b^T b (c X c^T + Q))

X and S are those of the loop that the gain itself closes, so each is the root of an equation. The
theorems say ~ 1/Q. `stationary` gives J itself over the gain, whose minimum is another matter: see
`best_gain`.

Source  Theorem 2 and the statement of theorem 1 of Xie, He and Wu; the first proof is lost, and
        both formulas are derived here.
"""

from dataclasses import dataclass
from math import cos, exp, sin, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
P, I = RULES = 'proportional', 'integral'
LEAST, TIMES, SCANNED = 1e-8, 100, 200  # of search and bisection
SETTLED = 1e-3


@dataclass(frozen=True)
class Plant:
    """A stable plant with one input and one output."""

    a: Array                            # (n, n)
    b: Array                            # (n,)
    c: Array                            # (n,)
    w: Array                            # (n, n) covariance of the process noise in one step


class Point(NamedTuple):
    """A gain and what the loop is like with it."""

    gain: float
    x: Array                            # (n, n) E x x^T
    s: Array                            # (n,)   E u(k-1) x^T; zero for P


def axis(natural_rad_s: float = 0.65, damping: float = 0.6, step_s: float = 0.5,
         sigma_deg_s2: float = 0.02, drift_sigma_deg_s2: float = 0.02,
         drift_pole: float = 0.98) -> Plant:
    """
    Return an axis on a spring with a damper, sampled behind a zero-order hold, and its disturbance.

    State (angle, rate, disturbance) [deg, deg/s, deg/s^2], input acceleration [deg/s^2], output the
    angle. The disturbance, an acceleration with the given standard deviation, goes by its pole from
    step to step; on top of it is one that is white, constant over each step.
    """
    w, z, h = natural_rad_s, damping, step_s
    d = w*sqrt(1.0 - z*z)
    e, c, s = exp(-z*w*h), cos(d*h), sin(d*h)
    free = np.array([[e*(c + z*w/d*s), e*s/d], [-w*w*e*s/d, e*(c - z*w/d*s)]])
    rest = np.array([1.0/(w*w), 0.0])           # where a unit acceleration leads
    pushed = rest - free @ rest
    a = np.zeros((3, 3))
    a[:2, :2], a[:2, 2], a[2, 2] = free, pushed, drift_pole
    b = np.append(pushed, 0.0)
    noise = sigma_deg_s2**2*np.outer(b, b)
    noise[2, 2] = (1.0 - drift_pole**2)*drift_sigma_deg_s2**2
    return Plant(a, b, np.array([1.0, 0.0, 0.0]), noise)


def covariance(m: Array, n: Array) -> Array:
    """
    Return the X of X = M X M^T + N by doubling.

    Raises
    ------
    ValueError
        If M is not stable, so that there is none.
    """
    if not np.abs(np.linalg.eigvals(m)).max() < 1.0:
        raise ValueError('the loop is not stable: it has no stationary covariance')
    x = n.copy()
    while np.abs(m).max() > 1e-18:
        x, m = x + m @ x @ m.T, m @ m
    return x


def loop(plant: Plant, rule: str, gain: float) -> tuple[Array, Array]:
    """Return (M, g): the loop goes by M and takes the noise v in by g; of I on (x, u(k-1))."""
    closed = plant.a + gain*np.outer(plant.b, plant.c)
    if rule == P:
        return closed, gain*plant.b
    m = np.block([[closed, plant.b[:, None]], [gain*plant.c[None, :], np.ones((1, 1))]])
    return m, gain*np.append(plant.b, 1.0)


def stationary(plant: Plant, rule: str, gain: float, q: float) -> Point:
    """Return the stationary loop at a gain; ValueError where there is none."""
    m, g = loop(plant, rule, gain)
    n, size = q*np.outer(g, g), len(plant.b)
    n[:size, :size] += plant.w
    x = covariance(m, n)
    return Point(gain, x[:size, :size], np.zeros(size) if rule == P else x[size, :size])


def one_step(plant: Plant, point: Point, q: float) -> float:
    """Return the gain that is best for the next step, in a loop that is like this now."""
    b, c = plant.b, plant.c
    carried = plant.a @ point.x @ c + b*(point.s @ c)
    return float(-(b @ carried) / ((b @ b)*(c @ point.x @ c + q)))


def consistent_gain(plant: Plant, rule: str, q: float) -> Point:
    """
    Return the loop whose own gain is the best for the next step: the gain of the theorem.

    Raises
    ------
    ValueError
        If there is none between zero and the end of the stable range, on the side that the best
        gain for the next step of the open loop has.
    """
    side = np.sign(one_step(plant, stationary(plant, P, 0.0, q), q))
    widest = _widest(plant, rule, side)

    def excess(gain: float) -> float:
        return side*(gain - one_step(plant, stationary(plant, rule, gain, q), q))

    sizes = side*np.geomspace(1e-9*widest, widest, SCANNED)
    above = np.flatnonzero([excess(gain) > 0.0 for gain in sizes])
    if not above.size or above[0] == 0:
        raise ValueError(f'no {rule} gain is the best for the next step of its own loop')
    near, far = sizes[above[0] - 1], sizes[above[0]]
    for _ in range(TIMES):
        middle = 0.5*(near + far)
        near, far = (middle, far) if excess(middle) < 0.0 else (near, middle)
    return stationary(plant, rule, 0.5*(near + far), q)


def best_gain(plant: Plant, rule: str, q: float) -> Point:
    """
    Return the loop whose stationary J = E|x|^2 is least, by search over the stable range.

    The search is over the logarithm of the gain, so that zero itself is the lower end: a gain of
    LEAST times the stable range stands for none.
    """
    side = np.sign(one_step(plant, stationary(plant, P, 0.0, q), q))
    widest = _widest(plant, rule, side)

    def cost(share: float) -> float:
        return float(np.trace(stationary(plant, rule, side*widest*exp(share), q).x))

    shares = np.linspace(np.log(LEAST), 0.0, 161)
    at = int(np.argmin([cost(share) for share in shares]))
    low, high = shares[max(at - 1, 0)], shares[min(at + 1, len(shares) - 1)]
    section = (sqrt(5.0) - 1.0)/2.0
    for _ in range(80):
        left, right = high - section*(high - low), low + section*(high - low)
        low, high = (low, right) if cost(left) < cost(right) else (left, high)
    return stationary(plant, rule, side*widest*exp(0.5*(low + high)), q)


def _widest(plant: Plant, rule: str, side: float) -> float:
    """Return (almost) the size of the gain at which the loop ceases to be stable on one side."""
    def is_stable(size: float) -> bool:
        return bool(np.abs(np.linalg.eigvals(loop(plant, rule, side*size)[0])).max() < 1.0)

    if not is_stable(LEAST):
        raise ValueError(f'the loop is stable at no {rule} gain of sign {side:+.0f}')
    low, high = LEAST, 1.0
    while is_stable(high):
        low, high = high, 2.0*high
    for _ in range(TIMES):
        middle = 0.5*(low + high)
        low, high = (middle, high) if is_stable(middle) else (low, middle)
    return 0.999*low


# -- by experiment ----------------------------------------------------------------------------

class Found(NamedTuple):
    """A number of an experiment with its 95 % interval."""

    value: float
    low: float
    high: float


def experiment(plant: Plant, rule: str, gain: float, q: float, rng: np.random.Generator,
               groups: int = 20, runs: int = 50, steps: int = 1000) -> Found:
    """
    Fly the loop and return which gain would have been best for the next step, with its interval.

    No formula for the covariances goes in: |x(k+1)|^2 is a parabola in the gain of step k, whose
    minimum is read from sums over runs and steps. The interval is that of Student's t over groups.
    """
    n = len(plant.b)
    x, u = np.zeros((groups*runs, n)), np.zeros(groups*runs)
    root, settle = _root(plant.w), settling(plant, rule, gain)
    top, below = np.zeros((2, groups*runs))
    for k in range(settle + steps):
        y = x @ plant.c + sqrt(q)*rng.standard_normal(len(u))
        kept = u if rule == I else np.zeros_like(u)
        if k >= settle:
            ahead = x @ plant.a.T + kept[:, None]*plant.b
            top += (ahead @ plant.b)*y
            below += (plant.b @ plant.b)*y*y
        u = kept + gain*y
        x = x @ plant.a.T + u[:, None]*plant.b + rng.standard_normal((len(u), n)) @ root.T
    return interval(-top.reshape(groups, -1).sum(1)/below.reshape(groups, -1).sum(1))


def minimum(plant: Plant, rule: str, gains: Array, q: float, rng: np.random.Generator,
            groups: int = 20, runs: int = 50, steps: int = 1000) -> Found:
    """
    Fly the loop at several gains and return the one with the least mean |x|^2, with its interval.

    All gains meet the same noise. In each group the minimum is that of a parabola through the means
    over the gains.
    """
    n = len(plant.b)
    x = np.zeros((len(gains), groups*runs, n))
    u = np.zeros(x.shape[:2])
    root, total = _root(plant.w), np.zeros(x.shape[:2])
    settle = max(settling(plant, rule, gain) for gain in gains)
    for k in range(settle + steps):
        noise = sqrt(q)*rng.standard_normal(groups*runs)
        y = x @ plant.c + noise
        u = (u if rule == I else 0.0) + np.asarray(gains)[:, None]*y
        push = rng.standard_normal((groups*runs, n)) @ root.T
        x = x @ plant.a.T + u[..., None]*plant.b + push
        if k >= settle:
            total += (x*x).sum(-1)
    means = total.reshape(len(gains), groups, runs).mean(-1)
    curved, slope, _ = np.polyfit(np.asarray(gains)/gains[0], means, 2)
    found = interval(-slope/(2.0*curved))
    low, high = sorted((float(gains[0])*found.low, float(gains[0])*found.high))
    return Found(float(gains[0])*found.value, low, high)


def settling(plant: Plant, rule: str, gain: float) -> int:
    """Return after how many steps what a loop remembers of its start is below SETTLED."""
    slowest = np.abs(np.linalg.eigvals(loop(plant, rule, gain)[0])).max()
    return int(np.ceil(np.log(SETTLED)/np.log(slowest)))


def interval(values: Array) -> Found:
    """Return mean and 95 % interval of independent values (groups,)."""
    from scipy.stats import t
    mean, spread = float(values.mean()), float(values.std(ddof=1)/sqrt(len(values)))
    reach = float(t.ppf(0.975, len(values) - 1))*spread
    return Found(mean, mean - reach, mean + reach)


def _root(w: Array) -> Array:
    """Return a square root of a covariance that may be singular."""
    values, vectors = np.linalg.eigh(w)
    return vectors*np.sqrt(np.maximum(values, 0.0))


def slope(q: Array, gain: Array) -> float:
    """Return the slope of log |gain| over log Q by least squares."""
    return float(np.polyfit(np.log(q), np.log(np.abs(gain)), 1)[0])
