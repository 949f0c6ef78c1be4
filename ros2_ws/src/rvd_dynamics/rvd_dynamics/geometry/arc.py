"""
Motion between two samples: the cubic Hermite arc, in Bernstein form.

Arrays  control points (3, 4, K) [m]: axis, point, arc; fraction s in [0, 1] of the arc.
Valid   error h^4/384 max|x''''|: below 1e-10 m for orbital motion under thrust that is
        constant over a step of at most 1 s.

An arc lies in the convex hull of its control points, so a concave function of position (such as
the signed distance to a cone) is nowhere on the arc below its least value at these points. All
searches take a fixed number of passes and treat every arc independently of its neighbours.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Function = Callable[[Array], Array]     # of fractions (K, CELLS + 1), same shape

CELLS = 32                              # per pass; two passes resolve 1 / 512 of an arc
GRID = np.linspace(0.0, 1.0, CELLS + 1)
PASSES = 2


def control_points(start: Array, end: Array, dt: float) -> Array:
    """Return the control points (3, 4, K) between states (6, K) that lie `dt` [s] apart."""
    third = dt / 3.0
    points = np.empty((3, 4, start.shape[1]))
    points[:, 0], points[:, 3] = start[:3], end[:3]
    np.add(start[:3], third*start[3:], out=points[:, 1])
    np.subtract(end[:3], third*end[3:], out=points[:, 2])
    return points


def position(points: Array, s: Array) -> Array:
    """Return positions (3, K, ...) at fractions `s` (K, ...) of the arcs; exact at 0 and 1."""
    t = 1.0 - s
    p = points.reshape(points.shape + (1,) * (s.ndim - 1))
    return t*t*t*p[:, 0] + (3.0*t*t*s)*p[:, 1] + (3.0*t*s*s)*p[:, 2] + s*s*s*p[:, 3]


def velocity(points: Array, s: Array, dt: float) -> Array:
    """Return velocities (3, K) [m/s] at fractions `s` (K,) of arcs of duration `dt` [s]."""
    t = 1.0 - s
    legs = points[:, 1:] - points[:, :-1]
    return (3.0/dt) * (t*t*legs[:, 0] + 2.0*t*s*legs[:, 1] + s*s*legs[:, 2])


def lowest(value: Function, end: Array) -> tuple[Array, Array]:
    """Return where in 0 .. `end` (K,) a function is least, and its value there."""
    low, high = np.zeros_like(end), end
    rows = np.arange(end.size)
    for _ in range(PASSES):
        s = low[:, np.newaxis] + (high - low)[:, np.newaxis] * GRID
        f = value(s)
        j = f.argmin(axis=1)
        low, high = s[rows, np.maximum(j - 1, 0)], s[rows, np.minimum(j + 1, CELLS)]
    return s[rows, j], f[rows, j]


def first_not_positive(value: Function, end: Array) -> Array:
    """Return the first root in 0 .. `end` (K,) of a function that is not positive at `end`."""
    low, high = np.zeros_like(end), end
    rows = np.arange(end.size)
    for _ in range(PASSES):
        s = low[:, np.newaxis] + (high - low)[:, np.newaxis] * GRID
        f = value(s)
        reached = f <= 0.0
        reached[:, -1] = True               # by the premise; rounding must not undo it
        j = reached.argmax(axis=1)
        i = np.maximum(j - 1, 0)
        low, high, above, below = s[rows, i], s[rows, j], f[rows, i], f[rows, j]
    drop = above - below
    part = np.divide(above, drop, out=np.zeros_like(drop), where=drop > 0.0)
    return low + (high - low) * np.clip(part, 0.0, 1.0)
