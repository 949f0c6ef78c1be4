"""
Clohessy-Wiltshire relative motion about a target on a circular orbit.

Frame   target orbital: +x along track, +y radially outward, +z opposite to orbit normal.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Valid   separation << orbit radius, eccentricity ~ 0, acceleration constant over a step
        along the rotating axes.
Source  W. H. Clohessy and R. S. Wiltshire, J. Aerospace Sci. 27(9), 1960, pp. 653-658, for
        the axes of Zhang, Li, Tang 2014, eq. 1, with u the thrust acceleration:
        x'' + 2n y' = ux,   y'' - 2n x' - 3n^2 y = uy,   z'' + n^2 z = uz.
        Eq. 4-6 of the paper are the matrices; the entry (1, 1) of its input matrix lacks
        -3/2 dt^2 and the last entry has n for the orbital rate.

With w = n dt every entry is written in c2 = (1 - cos w) / w^2 and c3 = (w - sin w) / w^3,
so that no digits cancel when n dt is small.
"""

from math import factorial

import numpy as np
from numpy.typing import ArrayLike, NDArray

Matrix = NDArray[np.float64]

# c3 = sum (-w^2)^k / (2k + 3)!; nine terms reach 1e-17 for |w| < 1.
_C3_SERIES = [(-1.0)**k / factorial(2*k + 3) for k in range(9)]


def transition(n: float, dt: ArrayLike) -> Matrix:
    """
    Return the matrix that carries a state over `dt` without thrust (eq. 4, 5).

    Parameters
    ----------
    n : float
        Mean motion of the target [rad/s], positive.
    dt : array_like, shape (...)
        Elapsed time [s]; a negative one goes back in time.

    Returns
    -------
    ndarray, shape (..., 6, 6)

    Raises
    ------
    ValueError
        If `n` is not positive.
    """
    dt, w, c2, c3 = _arguments(n, dt)
    s, c = np.sin(w), np.cos(w)
    v = w*w*c2                                      # 1 - cos w
    u = w*w*w*c3                                    # w - sin w
    o, i = np.zeros_like(w), np.ones_like(w)
    return _matrix([
        [i, -6*u,    o,    dt*(1 - 4*w*w*c3), -2*dt*w*c2,       o],
        [o, 1 + 3*v, o,    2*dt*w*c2,         dt*(1 - w*w*c3),  o],
        [o, o,       c,    o,                 o,                dt*(1 - w*w*c3)],
        [o, -6*n*v,  o,    1 - 4*v,           -2*s,             o],
        [o, 3*n*s,   o,    2*s,               c,                o],
        [o, o,       -n*s, o,                 o,                c],
    ])


def input_matrix(n: float, dt: ArrayLike) -> Matrix:
    """
    Return what an acceleration held over `dt` adds to the state (eq. 6, corrected).

    It is the integral of the right half of `transition` over 0 .. dt. Arguments and errors
    as `transition`; shape (..., 6, 3).
    """
    dt, w, c2, c3 = _arguments(n, dt)
    o = np.zeros_like(w)
    dt2 = dt*dt
    along = dt*(1 - 4*w*w*c3)                       # (4 sin w - 3w) / n
    cross = 2*dt*w*c2                               # 2 (1 - cos w) / n
    other = dt*(1 - w*w*c3)                         # sin w / n
    return _matrix([
        [dt2*(4*c2 - 1.5), -2*dt2*w*c3, o],
        [2*dt2*w*c3,       dt2*c2,      o],
        [o,                o,           dt2*c2],
        [along,            -cross,      o],
        [cross,            other,       o],
        [o,                o,           other],
    ])


def step(state: ArrayLike, accel: ArrayLike, phi: Matrix, gamma: Matrix) -> Matrix:
    """
    Return the state (..., 6) one step on: phi state + gamma accel (eq. 3).

    `accel` (..., 3) is held over the step [m/s^2]; `phi` (6, 6) and `gamma` (6, 3) are
    `transition` and `input_matrix` of that step.
    """
    return product(phi, state) + product(gamma, accel)


def product(matrix: Matrix, vectors: ArrayLike) -> NDArray[np.float64]:
    """
    Return `matrix` (i, j) times `vectors` (..., j), shape (..., i).

    Terms are added in the order of j, skipping the zeros of the matrix, which are two in three
    here. So a row has the same bits alone and in any batch or memory layout, which neither BLAS
    nor einsum promises. In memory the components of the result come first, as its users read it.
    """
    vectors = np.asarray(vectors, dtype=float)
    alone = vectors.size == vectors.shape[-1]           # ten times faster with Python floats
    components = (vectors.ravel().tolist() if alone
                  else [vectors[..., j] for j in range(vectors.shape[-1])])
    result = np.empty((len(matrix), *vectors.shape[:-1]))
    for i, row in enumerate(matrix.tolist()):
        total = None
        for entry, component in zip(row, components):
            if entry == 0.0:
                continue
            if total is None:
                total = entry*component
            else:
                total += entry*component
        result[i] = 0.0 if total is None else total
    return result.transpose(*range(1, result.ndim), 0)


def carried(covariance: ArrayLike, phi: Matrix) -> NDArray[np.float64]:
    """Return the covariance (..., 6, 6) of states one step on without noise: phi C phi'."""
    half = product(phi, covariance)                 # rows of C are its columns: (phi C)'
    return product(phi, np.swapaxes(half, -1, -2))


def propagate(state: ArrayLike, n: float, dt: ArrayLike) -> NDArray[np.float64]:
    """Coast `state` (..., 6) for `dt` (...) seconds; shapes broadcast, NaN stays NaN."""
    # contiguous: the order in which einsum adds depends on the layout of its operands
    state = np.ascontiguousarray(state, dtype=float)
    return np.einsum('...ij,...j->...i', transition(n, dt), state)


def _arguments(n: float, dt: ArrayLike) -> tuple[Matrix, Matrix, Matrix, Matrix]:
    """Return dt, w = n dt, (1 - cos w) / w^2 and (w - sin w) / w^3, each (...)."""
    if not n > 0.0:                                 # also refuses NaN
        raise ValueError(f'mean motion must be positive, got {n}')
    dt = np.asarray(dt, dtype=float)
    w = n*dt
    sinc = np.sinc(w / (2*np.pi))                   # sin(w/2) / (w/2), 1 at 0
    c2 = sinc*sinc / 2
    series = np.zeros_like(w)
    for term in reversed(_C3_SERIES):
        series = series*w*w + term
    small = np.abs(w) < 1.0
    far = np.where(small, 1.0, w)
    return dt, w, c2, np.where(small, series, (far - np.sin(far)) / (far*far*far))


def _matrix(rows: list[list[Matrix]]) -> Matrix:
    """Return nested rows of (...) entries as matrices on the last two axes."""
    return np.ascontiguousarray(np.moveaxis(np.array(rows), (0, 1), (-2, -1)))
