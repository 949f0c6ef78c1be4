"""
Legendre-Gauss nodes on [-1, 1] and polynomials through values at them.

The Gauss pseudospectral method knows the states at -1 and at the K nodes, a polynomial of degree K,
and the controls at the K nodes, one of degree K - 1; the state at +1 comes by quadrature.

Source  D. A. Benson, A Gauss pseudospectral transcription for optimal control, thesis, MIT, 2005;
        barycentric form: J.-P. Berrut, L. N. Trefethen, SIAM Review 46(3), 2004, equations
        (4.2) and (9.4).
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Gauss(NamedTuple):
    """What the method needs of K nodes."""

    nodes: NDArray                      # (K,) in (-1, 1), rising
    weights: NDArray                    # (K,) of the quadrature; their sum is 2
    points: NDArray                     # (K + 1,) -1 and the nodes, where the states are known
    derivative: NDArray                 # (K, K + 1) of that polynomial, at the nodes
    through_states: NDArray             # (K + 1,) barycentric weights of `points`
    through_controls: NDArray           # (K,) barycentric weights of `nodes`


@lru_cache(maxsize=None)
def gauss(count: int) -> Gauss:
    """
    Return nodes, weights and matrices for a number of nodes.

    Raises
    ------
    ValueError
        If there is not at least one node.
    """
    if count < 1:
        raise ValueError(f'there must be at least one node, got {count}')
    nodes, weights = np.polynomial.legendre.leggauss(count)
    points = np.concatenate([[-1.0], nodes])
    states = barycentric(points)
    made = Gauss(nodes, weights, points, _derivative(points, states)[1:], states,
                 barycentric(nodes))
    for array in made:
        array.setflags(write=False)     # it is shared by all who ask
    return made


def barycentric(points: ArrayLike) -> NDArray[np.float64]:
    """Return the barycentric weights of distinct points (n,), the largest of size 1."""
    points = np.asarray(points, dtype=float)
    gaps = points[:, np.newaxis] - points
    np.fill_diagonal(gaps, 1.0)
    # by logarithms: the product of 100 gaps leaves the range of a float64 otherwise
    size = -np.log(np.abs(gaps)).sum(axis=1)
    return np.sign(gaps).prod(axis=1)*np.exp(size - size.max())


def _derivative(points: NDArray, weights: NDArray) -> NDArray[np.float64]:
    """Return the matrix that turns values at the points into derivatives there."""
    gaps = points[:, np.newaxis] - points
    np.fill_diagonal(gaps, 1.0)
    matrix = weights/weights[:, np.newaxis]/gaps
    np.fill_diagonal(matrix, 0.0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))       # constants have no derivative
    return matrix


def interpolate(points: NDArray, weights: NDArray, values: NDArray,
                at: ArrayLike) -> NDArray[np.float64]:
    """
    Return the polynomial through `values` (n, m) at `points` (n,), at places `at` (...).

    The shape is (..., m). It extrapolates where a place lies outside of the points.
    """
    at = np.asarray(at, dtype=float)
    gaps = at[..., np.newaxis] - points
    hit = gaps == 0.0
    terms = weights/np.where(hit, 1.0, gaps)
    terms = np.where(hit.any(axis=-1, keepdims=True), hit, terms)
    return (terms @ values)/terms.sum(axis=-1)[..., np.newaxis]
