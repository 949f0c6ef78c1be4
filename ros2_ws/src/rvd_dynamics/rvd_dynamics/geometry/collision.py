"""
Instantaneous collision probability: a Gaussian relative position within a ball.

Frame   any Cartesian frame, the same for offset and covariance.
Shapes  offsets (..., 3) [m], covariances (..., 3, 3) [m^2]; leading axes are batch axes that
        broadcast.
Source  P = integral over |x| <= R of the normal density with mean `offset` and covariance C, the
        probability that the centres of two spheres with sum of radii R are nearer than R (Xu,
        Zhang, Chinese J. Theor. Appl. Mech. 52(6), form of the alarm; the ball and the closed
        form are derived). For C = s^2 I, d = |offset|:
        P = 1/2 [erf((R+d)/(s sqrt2)) + erf((R-d)/(s sqrt2))]
            - s/(d sqrt(2 pi)) [exp(-(R-d)^2/2s^2) - exp(-(R+d)^2/2s^2)].
        Any other C: rotated to its principal axes, erf along the longest of them, Gauss-Legendre
        along the other two; see `collision_compiled`.

scipy and numba are imported where they are used: who asks for no probability waits for neither.
"""

from collections.abc import Callable
from functools import lru_cache
from math import pi, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput

Array = NDArray[np.float64]
SQRT2 = sqrt(2.0)
NEAR = 1e-2                             # d R / s^2 below which the difference is a series


class Decided(NamedTuple):
    """Whether probabilities reach a threshold, and which of them took a quadrature."""

    above: NDArray[np.bool_]
    integrated: NDArray[np.bool_]


def sphere_probability(distance: ArrayLike, sigma: ArrayLike, radius: ArrayLike) -> Array:
    """
    Return the collision probability for the covariance sigma^2 I, in closed form.

    Parameters
    ----------
    distance : array_like, shape (...)
        Distance of the centres [m], not negative.
    sigma : array_like, shape (...)
        Standard deviation of each component of the relative position [m], positive.
    radius : array_like, shape (...)
        Sum of the radii [m], not negative.

    Returns
    -------
    ndarray, shape (...)
        Between 0 and 1, absolute error below 1e-14; NaN where an argument is.
    """
    erf = _erf()
    d, s, r = (np.asarray(a, dtype=float) for a in (distance, sigma, radius))
    near, far = (r - d) / s, (r + d) / s
    within = 0.5 * (erf(near / SQRT2) + erf(far / SQRT2))
    edge, other = np.exp(-0.5*near*near), np.exp(-0.5*far*far)
    x = d * r / (s*s)                       # the exponents differ by 2 x
    close = x < NEAR
    # near the centre: exp(-(R^2 + d^2)/2s^2) 2 sinh(x) s/d, without the cancellation
    centre = 2.0 * (r/s) * np.exp(-0.5*(r*r + d*d)/(s*s)) * (1.0 + x*x/6.0 * (1.0 + x*x/20.0))
    away = (edge - other) * s / np.where(close, 1.0, d)
    return np.clip(within - np.where(close, centre, away) / sqrt(2.0*pi), 0.0, 1.0)


def probability(offset: ArrayLike, covariance: ArrayLike, radius: ArrayLike) -> Array:
    """
    Return the collision probability for any covariance.

    Parameters
    ----------
    offset : array_like, shape (..., 3)
        Mean relative position [m].
    covariance : array_like, shape (..., 3, 3)
        Covariance of the relative position [m^2], positive definite.
    radius : array_like, shape (...)
        Sum of the radii [m], not negative.

    Returns
    -------
    ndarray, shape (...)
        Absolute error below 1e-6 for standard deviations of 0.1 to 1 m, ratios of the axes up
        to 5 and radii up to 3 m; NaN where an argument is.

    Raises
    ------
    ValueError
        If a covariance is not positive definite.
    """
    rows, shape = _rows(offset, covariance, radius)
    return _compiled().probabilities(*rows).reshape(shape)


def reaches(offset: ArrayLike, covariance: ArrayLike, radius: ArrayLike, threshold: float
            ) -> Decided:
    """
    Return where the collision probability reaches a threshold.

    Boxes and slabs around and within the ball bound the probability; only rows between the
    bounds are integrated. Arguments and errors as `probability`.
    """
    rows, shape = _rows(offset, covariance, radius)
    above, integrated = _compiled().reach(*rows, float(threshold))
    return Decided(above.reshape(shape), integrated.reshape(shape))


def require_definite(covariance: ArrayLike, what: str = 'covariance') -> Array:
    """
    Return a covariance (..., n, n), or refuse one that is none.

    Raises
    ------
    ValueError
        If one is not symmetric or has an eigenvalue that is not positive; NaN passes.
    """
    given = np.asarray(covariance, dtype=float)
    known = given[np.isfinite(given).all(axis=(-2, -1))]
    if not known.size:
        return given
    if not np.allclose(known, np.swapaxes(known, -1, -2), rtol=1e-9, atol=0.0):
        first = known.reshape(-1, *known.shape[-2:])[0]
        raise BadInput(f'{what} must be symmetric, got {first.tolist()}')
    least = float(np.linalg.eigvalsh(known).min())
    if not least > 0.0:
        raise BadInput(f'{what} must be positive definite, got a least eigenvalue of {least:.3g}')
    return given


def _rows(offset: ArrayLike, covariance: ArrayLike, radius: ArrayLike
          ) -> tuple[tuple[Array, Array, Array], tuple[int, ...]]:
    """Return the arguments as contiguous rows, and the shape of the result."""
    offset, radius = np.asarray(offset, dtype=float), np.asarray(radius, dtype=float)
    covariance = require_definite(covariance)
    shape = np.broadcast_shapes(offset.shape[:-1], covariance.shape[:-2], radius.shape)
    n = int(np.prod(shape, dtype=int))
    made = (np.broadcast_to(offset, (*shape, 3)).reshape(n, 3),
            np.broadcast_to(covariance, (*shape, 3, 3)).reshape(n, 3, 3),
            np.broadcast_to(radius, shape).reshape(n))
    return tuple(np.ascontiguousarray(a) for a in made), shape


@lru_cache(maxsize=1)
def _erf() -> Callable[[Array], Array]:
    from scipy.special import erf           # 0.1 s
    return erf


@lru_cache(maxsize=1)
def _compiled() -> Any:
    from rvd_dynamics.geometry import collision_compiled        # 1 s, and compiling once
    return collision_compiled
