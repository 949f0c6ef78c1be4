"""
Limit cycles of the direction angle: found, judged and followed.

A cycle is a fixed point of the map over one orbit, y -> P(y), y = (phi, phi') at nu = 0, in
unwrapped angles. It is found by Newton's method with the exact Jacobian, which the variational
equations give; its Floquet multipliers are the eigenvalues of that Jacobian. Branches of cycles
are followed in one parameter by pseudo-arclength, through folds.

Source  Yu, Yang 1998, with `poincare`; H. B. Keller, in Applications of Bifurcation Theory, 1977
        (pseudo-arclength); E. Doedel, H. B. Keller, J. P. Kernevez, Int. J. Bifurcation and Chaos
        1(3), 1991 (tests along a branch). det P' = exp(-4 pi (k + k1) - 2 pi q1) for form R1 and
        exp(-4 pi k1 - 2 pi q1) for R2 and R4: Liouville's theorem.
"""

from dataclasses import dataclass, replace
from math import asin, inf, pi, radians
from typing import Callable, Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from rvd_missions.elliptic_rendezvous import poincare
from rvd_missions.elliptic_rendezvous.gains import CycleCase, FEED_FORWARDS

TOLERANCE = 1e-11                       # of the integration, relative
ON_THE_WAY = 1e-8                       # the same for cycles that are only passed on the way
SAMPLES = 360                           # of a cycle
# Parameters that a branch can be followed in, their place in the compiled code and a typical size.
PARAMETERS = {'e': (poincare.E, 1.0), 'k': (poincare.K, 1.0), 'k1': (poincare.K1, 1.0),
              'k2': (poincare.K2, 1.0), 'q': (poincare.Q, 10.0), 'q1': (poincare.Q1, 10.0),
              'phi_d': (poincare.PHI_D, 1.0)}
# What changes sign where a branch changes, of P' and the tangent of the branch.
TESTS: dict[str, Callable] = {
    'fold': lambda jacobian, tangent: tangent[2],
    'period doubling': lambda jacobian, tangent: 1.0 + _trace(jacobian) + _det(jacobian),
    'torus': lambda jacobian, tangent: _det(jacobian) - 1.0}
EVENTS = tuple(TESTS)
FIRST_STEP, LEAST_STEP, MOST_STEP = 0.05, 1e-6, 0.2     # along a branch
POINTS = 400                            # of a branch, at most


@dataclass(frozen=True)
class Cycle:
    """
    A limit cycle.

    Attributes
    ----------
    start : ndarray, shape (2,)
        phi and phi' at perigee [rad].
    jacobian : ndarray, shape (2, 2)
        Derivative of the map over one orbit.
    path : ndarray, shape (SAMPLES + 1, 2)
        phi and phi' over one orbit, at even true anomalies from perigee [rad].
    phi_min, phi_max : float
        The approach corridor [rad], unwrapped.
    """

    start: NDArray
    jacobian: NDArray
    path: NDArray
    phi_min: float
    phi_max: float

    @property
    def multipliers(self) -> NDArray:
        """Floquet multipliers, complex, the one of greater modulus first."""
        return multipliers(self.jacobian)

    @property
    def stable(self) -> bool:
        """Whether both multipliers are inside the unit circle."""
        return bool(np.abs(self.multipliers).max() < 1.0)


@dataclass(frozen=True)
class Event:
    """Where a branch changes: `kind` is fold, period doubling or torus; `at` the parameter."""

    kind: str
    at: float
    start: NDArray
    jacobian: NDArray


@dataclass(frozen=True)
class Branch:
    """
    A branch of cycles, in the order in which it was followed.

    Attributes
    ----------
    parameter : str
        One of PARAMETERS.
    at : ndarray, shape (n,)
        Its values.
    starts : ndarray, shape (n, 2)
        phi and phi' at perigee [rad].
    jacobians : ndarray, shape (n, 2, 2)
        Derivatives of the map over one orbit.
    events : tuple of Event
        Folds and changes of stability, in order.
    """

    parameter: str
    at: NDArray
    starts: NDArray
    jacobians: NDArray
    events: tuple[Event, ...]

    @property
    def stable(self) -> NDArray:
        """Which cycles are stable, shape (n,)."""
        return np.array([np.abs(multipliers(j)).max() < 1.0 for j in self.jacobians])


def multipliers(jacobian: NDArray) -> NDArray:
    """Return the eigenvalues of (2, 2), complex, the one of greater modulus first."""
    half, det = _trace(jacobian)/2, _det(jacobian)
    root = np.sqrt(complex(half*half - det))
    large = half + root if half >= 0.0 else half - root
    # the other one from the product, which keeps its digits
    return np.array([large, det/large if large else 0.0])


def _trace(jacobian: NDArray) -> float:
    return jacobian[0, 0] + jacobian[1, 1]


def _det(jacobian: NDArray) -> float:
    return jacobian[0, 0]*jacobian[1, 1] - jacobian[0, 1]*jacobian[1, 0]


def weights(case: CycleCase) -> NDArray:
    """Return the parameters as the compiled code takes them."""
    w = np.zeros(10)
    w[poincare.E], w[poincare.K], w[poincare.K1], w[poincare.K2] = case.e, case.k, case.k1, case.k2
    w[poincare.FORM] = float(case.form[1])
    if case.law == 'odrrca':
        w[poincare.TRANSVERSE] = 1.0
        w[poincare.Q], w[poincare.Q1], w[poincare.PHI_D] = case.q, case.q1, case.phi_d
        w[poincare.FF] = FEED_FORWARDS.index(case.ff)
    return w


def node(case: CycleCase) -> NDArray | None:
    """
    Return where the branch begins on the circular orbit, (phi, 0) [rad]; None if nowhere.

    For rrca sin 2 phi = -4 k / 3 with phi in (-90, 90) degrees, the one of two that is no saddle;
    for odrrca the restoring equilibrium next to phi_d.
    """
    if case.law == 'rrca':
        lean = -4.0*case.k/3.0
        return np.array([asin(lean)/2.0, 0.0]) if abs(lean) < 1.0 else None
    w = weights(case)
    w[poincare.E] = 0.0
    offsets = np.linspace(-pi, pi, 1441)[1:-1]
    pulls = [poincare.acceleration(0.0, case.phi_d + d, 0.0, w) for d in offsets]
    found = [brentq(lambda d: poincare.acceleration(0.0, case.phi_d + d, 0.0, w), a, b, xtol=1e-14)
             for a, b, f, g in zip(offsets, offsets[1:], pulls, pulls[1:]) if f >= 0.0 > g]
    return np.array([case.phi_d + min(found, key=abs), 0.0]) if found else None


def cycle(case: CycleCase) -> Cycle | None:
    """
    Return the cycle of a case, stable or not, or None if there is none.

    It is the one that is reached first on the branch which begins at the `node` of the circular
    orbit and is followed in the eccentricity.
    """
    begin = node(case)
    if begin is None:
        return None
    follower = _Follower(weights(case), 'e')
    x = np.append(begin, 0.0)
    if case.e > 0.0:
        x = follower.reach(x, case.e)
    return None if x is None else follower.whole(x)


def follow(case: CycleCase, parameter: str, first: float, last: float,
           points: int = POINTS) -> Branch:
    """
    Return the branch through the cycle of `case` at parameter = `first`, followed towards `last`.

    It ends at `last`, back at `first`, where cycles can no longer be found, or after `points`.
    phi_d is in radians here.

    Raises
    ------
    ValueError
        If there is no cycle at `first`, or no such parameter.
    """
    if parameter not in PARAMETERS:
        raise ValueError(f'parameter must be one of {", ".join(PARAMETERS)}, got {parameter!r}')
    name, value = (parameter, first) if parameter != 'phi_d' else ('phi_d_deg', first*180.0/pi)
    at_first = cycle(replace(case, **{name: value}))
    if at_first is None:
        raise ValueError(f'there is no cycle at {parameter} = {first:g}')
    follower = _Follower(weights(case), parameter)
    x = np.append(at_first.start, first/follower.size)
    track, events = [], []
    low, high = min(first, last)/follower.size, max(first, last)/follower.size
    for x, jacobian, event in follower.along(x, np.sign(last - first)):
        over = bool(track) and not low <= x[2] <= high
        if over:                                        # end on the bound
            x, jacobian, _ = follower.between(track[-1][0], x, low if x[2] < low else high)
        events += event
        track.append((x, jacobian))
        if over or len(track) == points:
            break
    at = np.array([x[2]*follower.size for x, _ in track])
    starts, jacobians = np.array([x[:2] for x, _ in track]), np.array([j for _, j in track])
    return Branch(parameter, at, starts, jacobians, tuple(events))


class _Follower:
    """Newton and pseudo-arclength for x = (phi, phi', parameter / size)."""

    def __init__(self, w: NDArray, parameter: str) -> None:
        self.place, self.size = PARAMETERS[parameter]
        self._w, self._tolerance = w.copy(), TOLERANCE

    def map(self, x: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Return P(y) - y, P' and dP by the scaled parameter."""
        self._w[self.place] = x[2]*self.size
        z = poincare.orbit_map(x[0], x[1], self._w, self.place, self._tolerance)
        return z[:2] - x[:2], z[2:6].reshape(2, 2).T, z[6:8]*self.size

    def correct(self, x: NDArray, row: NDArray, s: float, base: NDArray
                ) -> tuple[NDArray, NDArray, NDArray, int]:
        """
        Return the cycle with row . (x - base) = s next to x, its P', dP and the iterations.

        ArithmeticError if Newton's method does not find it.
        """
        matrix = np.empty((3, 3))
        last = inf
        for i in range(12):
            off, jacobian, by_parameter = self.map(x)
            matrix[:2, :2], matrix[:2, 2] = jacobian - np.eye(2), by_parameter
            matrix[2] = row
            residual = np.append(off, row @ (x - base) - s)
            if not np.isfinite(matrix).all():
                break
            try:
                step = np.linalg.solve(matrix, -residual)
            except np.linalg.LinAlgError:
                break
            length = np.abs(step).max()
            x = x + step
            if length < 1e-7 or (length < 1e-5 and length > last/4.0):   # squared: below rounding
                return x, jacobian, by_parameter, i + 1
            if length > 3.0:
                break
            last = length
        raise ArithmeticError('no cycle here')

    def correct_at(self, start: NDArray, value: float) -> tuple[NDArray, NDArray, NDArray]:
        """Return the cycle at this value of the scaled parameter next to `start`."""
        x = np.append(start, value)
        return self.correct(x, np.array([0.0, 0.0, 1.0]), 0.0, x)[:3]

    def between(self, before: NDArray, after: NDArray, value: float
                ) -> tuple[NDArray, NDArray, NDArray]:
        """Return the cycle between two neighbours of a branch at a scaled parameter."""
        part = (value - before[2])/(after[2] - before[2])
        return self.correct_at((before + part*(after - before))[:2], value)

    def tangent(self, jacobian: NDArray, by_parameter: NDArray) -> NDArray:
        """Return the direction of the branch, one of two."""
        a, b = np.column_stack([jacobian - np.eye(2), by_parameter])
        t = np.array([a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]])
        return t / np.sqrt(t @ t)

    def along(self, x: NDArray, direction: float, kinds: tuple[str, ...] = EVENTS
              ) -> Iterator[tuple[NDArray, NDArray, list[Event]]]:
        """Yield x, P' and the events since the one before, along the branch from x."""
        _, jacobian, by_parameter = self.map(x)
        t = self.tangent(jacobian, by_parameter)
        t = t if t[2]*direction > 0.0 else -t
        yield x, jacobian, []
        ds = FIRST_STEP
        while ds > LEAST_STEP:
            try:
                ahead, jacobian_ahead, by_parameter, count = self.correct(x + ds*t, t, ds, x)
            except ArithmeticError:
                ds /= 2.0
                continue
            t_ahead = self.tangent(jacobian_ahead, by_parameter)
            t_ahead = t_ahead if t_ahead @ t > 0.0 else -t_ahead
            if t_ahead @ t < 0.9 and ds > 100.0*LEAST_STEP:             # too sharp a turn
                ds /= 2.0
                continue
            yield ahead, jacobian_ahead, self._events(x, t, jacobian, ahead, t_ahead,
                                                      jacobian_ahead, kinds)
            x, t, jacobian = ahead, t_ahead, jacobian_ahead
            ds = min(MOST_STEP, ds*(1.6 if count <= 4 else 1.0 if count <= 6 else 0.5))

    def _events(self, x: NDArray, t: NDArray, jacobian: NDArray, ahead: NDArray,
                t_ahead: NDArray, jacobian_ahead: NDArray, kinds: tuple[str, ...]
                ) -> list[Event]:
        """Return what happens between two neighbours of a branch."""
        found = []
        for kind in kinds:
            test = TESTS[kind]
            if test(jacobian, t)*test(jacobian_ahead, t_ahead) >= 0.0:
                continue
            last = {}

            def value(s: float) -> float:
                y, j, by, _ = self.correct(x + s/span*(ahead - x), t, s, x)
                tangent = self.tangent(j, by)
                last['x'], last['j'] = y, j
                return test(j, tangent if tangent @ t > 0.0 else -tangent)
            span = t @ (ahead - x)
            brentq(value, 0.0, span, xtol=1e-9)
            if kind == 'torus' and abs(_trace(last['j'])) >= 2.0:
                continue                            # real multipliers: no circle is crossed
            found.append((t @ (last['x'] - x), Event(kind, last['x'][2]*self.size, last['x'][:2],
                                                     last['j'])))
        return [event for _, event in sorted(found, key=lambda pair: pair[0])]

    def reach(self, x: NDArray, value: float) -> NDArray | None:
        """Return the first x on the branch from x upwards at which the parameter is `value`."""
        goal, before, self._tolerance = value/self.size, x, ON_THE_WAY
        for n, (after, _, events) in enumerate(self.along(x, 1.0, ('fold',))):
            folds = [e for e in events if e.kind == 'fold' and e.at >= value]
            if after[2] >= goal or folds:
                end = after if after[2] >= goal else np.append(folds[0].start,
                                                               folds[0].at/self.size)
                self._tolerance = TOLERANCE
                return self.between(before, end, goal)[0]
            if after[2] < 0.0 or n == POINTS:
                return None
            before = after
        return None

    def whole(self, x: NDArray) -> Cycle:
        """Return the cycle through x with its path and its extremes."""
        _, jacobian, _ = self.map(x)
        path = poincare.trace(x[0], x[1], self._w, SAMPLES, 1.0, TOLERANCE)
        return Cycle(x[:2], jacobian, path, *_extremes(path, self._w))


def _extremes(path: NDArray, w: NDArray) -> tuple[float, float]:
    """Return the least and the greatest phi: where phi' = 0 between two samples, by Hermite."""
    h = 2.0*pi/(len(path) - 1)
    phi, rate = path.T
    turning = np.flatnonzero(rate[:-1]*rate[1:] < 0.0)
    values = [phi.min(), phi.max()]
    for i in turning:
        a, b = (poincare.acceleration(h*j, phi[j], rate[j], w) for j in (i, i + 1))
        # phi' is a cubic in u between the samples, with both ends and both slopes right
        d = rate[i + 1] - rate[i]
        cubic = np.array([h*(a + b) - 2.0*d, 3.0*d - h*(2.0*a + b), h*a, rate[i]])
        u = brentq(lambda u: np.polyval(cubic, u), 0.0, 1.0)
        values.append(phi[i] + h*np.polyval(np.polyint(cubic), u))
    return min(values), max(values)


def settled(case: CycleCase, start_deg: tuple[float, float], orbits: int = 8) -> NDArray:
    """Return (phi, phi') over so many orbits from (phi, phi') in degrees, 90 samples an orbit."""
    return poincare.trace(radians(start_deg[0]), radians(start_deg[1]), weights(case),
                          90*orbits, float(orbits), TOLERANCE)
