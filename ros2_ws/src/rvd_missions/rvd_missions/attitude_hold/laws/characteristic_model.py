"""
Characteristic model of an axis, identified on line by projected recursive least squares.

Model   y(k) = f1 y(k-1) + f2 y(k-2) + b v(k-1),  v = dt^2 u
        with y an angle [deg], u the acceleration asked for [deg/s^2], and b = b0/dt^2, which is 1
        for a double integrator without a gain error. One input tap: what a zero-order hold
        spreads over two steps is lumped into one.
Range   slow parameters of a stable plant that is sampled fast:
        f1 in [1.4331, 1.9975], f2 in [-0.9999, -0.5134], f1 + f2 in [0.9196, 0.9999].
Source  Theory of the characteristic model from general knowledge of the method; not checked
        against a paper. The dead zone and the bounds of b are assumptions of ours.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

F1 = 1.4331, 1.9975
F2 = -0.9999, -0.5134
SUM = 0.9196, 0.9999
ENTRIES = tuple((i, j) for i in range(3) for j in range(i, 3))     # of a symmetric matrix
PLACE = {entry: at for at, entry in enumerate(ENTRIES)}


class Estimate(NamedTuple):
    """Parameters of the model; each of the batch's shape, dimensionless."""

    f1: Array
    f2: Array
    b: Array


def projected(f1: ArrayLike, f2: ArrayLike) -> tuple[Array, Array]:
    """
    Return the point of the range that is nearest to (f1, f2), each of shape (...).

    The range is a box cut by a band of the sum. Where the nearest point of the box is outside of
    the band, the nearest point of the range is on the edge of the band, which is a segment.
    """
    f1, f2 = np.asarray(f1, dtype=float), np.asarray(f2, dtype=float)
    boxed1, boxed2 = np.clip(f1, *F1), np.clip(f2, *F2)
    total = boxed1 + boxed2
    edge = np.clip(total, *SUM)
    low, high = np.maximum(F1[0], edge - F2[1]), np.minimum(F1[1], edge - F2[0])
    along = np.clip(0.5*(f1 - f2 + edge), low, high)
    outside = total != edge
    return np.where(outside, along, boxed1), np.where(outside, edge - along, boxed2)


class Identifier:
    """
    Recursive least squares with forgetting, a dead zone and projection; rows are independent.

    A residual within the dead zone changes nothing, and one beyond it counts by what it exceeds
    the dead zone: noise alone does not move the parameters.
    """

    def __init__(self, forgetting: float, dead_zone: float, variances: tuple[float, float],
                 bounds: tuple[float, float], batch: tuple) -> None:
        """
        Take the forgetting factor, the dead zone [deg], variances of (f1 and f2, b) at the start.

        `bounds` are those of b. The variances are per deg^2 of squared residual.
        """
        self._forgetting, self._dead_zone, self._bounds = forgetting, dead_zone, bounds
        of_f, of_b = variances
        self._most = 10.0*of_f, 10.0*of_b       # forgetting must not blow them up
        f1, f2 = projected(2.0, -1.0)           # double integrator, as near as the range allows
        self.estimate = Estimate(np.full(batch, f1), np.full(batch, f2),
                                 np.full(batch, np.clip(1.0, *bounds)))
        diagonal = of_f, of_f, of_b
        self._matrix = [np.full(batch, diagonal[i] if i == j else 0.0) for i, j in ENTRIES]

    def predicted(self, past: tuple[Array, Array, Array]) -> Array:
        """Return y(k) of the model from (y(k-1), y(k-2), v(k-1))."""
        y1, y2, v = past
        return self.estimate.f1*y1 + self.estimate.f2*y2 + self.estimate.b*v

    def learn(self, y: Array, past: tuple[Array, Array, Array], allowed: Array) -> Estimate:
        """
        Take y(k) [deg] and what preceded it, in the rows where it is allowed; return the estimate.
        """
        residual = y - self.predicted(past)
        excess = residual - np.clip(residual, -self._dead_zone, self._dead_zone)
        learns = allowed & (excess != 0.0) & np.isfinite(excess)
        if not learns.any():
            return self.estimate
        p = self._full()
        weighted = [p[i][0]*past[0] + p[i][1]*past[1] + p[i][2]*past[2] for i in range(3)]
        spread = self._forgetting + (past[0]*weighted[0] + past[1]*weighted[1]
                                     + past[2]*weighted[2])
        moved = [old + w/spread*excess for old, w in zip(self.estimate, weighted)]
        f1, f2 = projected(moved[0], moved[1])
        new = f1, f2, np.clip(moved[2], *self._bounds)
        self.estimate = Estimate(*(np.where(learns, n, o) for n, o in zip(new, self.estimate)))
        self._shrink(learns, weighted, spread)
        return self.estimate

    def _full(self) -> list[list[Array]]:
        return [[self._matrix[PLACE[min(i, j), max(i, j)]] for j in range(3)] for i in range(3)]

    def _shrink(self, learns: Array, weighted: list[Array], spread: Array) -> None:
        """Update the matrix, scaled back where forgetting has let a diagonal entry grow too far."""
        made = [(self._matrix[at] - weighted[i]*weighted[j]/spread)/self._forgetting
                for at, (i, j) in enumerate(ENTRIES)]
        diagonal = made[PLACE[0, 0]], made[PLACE[1, 1]], made[PLACE[2, 2]]
        most = self._most[0], self._most[0], self._most[1]
        scale = np.fmin(1.0, np.fmin(np.fmin(most[0]/diagonal[0], most[1]/diagonal[1]),
                                     most[2]/diagonal[2]))
        self._matrix = [np.where(learns, scale*m, old) for m, old in zip(made, self._matrix)]
