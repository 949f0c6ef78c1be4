"""
Spherical obstacles: what is said of them before a flight, and how near a chaser comes to them.

Frame   any; positions (x, y, z) [m] on the last axis of states, obstacles on the axis before it.
"""

from math import dist

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, require, settings

Array = NDArray[np.float64]


@settings
class Spheres:
    """How many obstacles there are, and how large."""

    number: int = param(
        -1, 'Number of obstacles, the first ones of those listed, where -1 means all.', low=-1,
        high=64)
    radius_m: tuple = param((0.6, 0.6, 0.6), 'Radius of each obstacle [m].', above=0.0, high=1000.0)

    def __post_init__(self) -> None:
        require(self.number <= len(self.radius_m), 'number',
                f'be at most the {len(self.radius_m)} that radius_m lists', self.number)

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.radius_m) if self.number < 0 else self.number

    @property
    def radii(self) -> Array:
        """Radii (M,) [m]."""
        return np.array(self.radius_m[:self.count])


def rows_of(key: str, flat: tuple, count: int, of: str = 'radius_m') -> Array:
    """
    Return numbers listed one obstacle after the other as rows (count, 3).

    Raises
    ------
    ValueError
        If there are not three for each; names `key` and the list `of` which they must fit.
    """
    require(len(flat) == 3*count, key, f'be {3*count} numbers, three for each of {of}', list(flat))
    return np.reshape(np.array(flat, dtype=float), (-1, 3))


def require_apart(key: str, place: Array, other: Array, least_m: float, what: str) -> None:
    """Refuse a place (3,) not more than `least_m` from another; `what` says what is there."""
    require(dist(place, other) > least_m, key, f'be more than {least_m:g} m from {what}',
            place.tolist())


def clearance(state: Array, obstacles: Array, reach_m: Array) -> Array:
    """
    Return the gaps (..., M) between chaser (..., 3 or 6) and obstacles (..., M, 3 or 6) [m].

    `reach_m` (M,) are the distances of the centres at contact.
    """
    x, y, z = (state[..., i, None] - obstacles[..., i] for i in range(3))
    return np.sqrt(x*x + y*y + z*z) - reach_m


class Closest:
    """
    The least gap between two samples, along the chord of the relative motion.

    The arc departs from the chord by at most |a| dt^2 / 8.
    """

    def __init__(self, reach_m: Array) -> None:
        self._reach_m = reach_m
        self._before: list[Array] | None = None

    def follow(self, state: Array, obstacles: Array) -> Array:
        """Return the least gap (...) to any obstacle since the sample before [m]."""
        away = [state[..., i, None] - obstacles[..., i] for i in range(3)]
        x, y, z = away
        square = x*x + y*y + z*z
        if self._before is not None:
            a, b, c = self._before
            u, v, w = x - a, y - b, z - c
            length = u*u + v*v + w*w
            s = -(a*u + b*v + c*w) / np.where(length > 0.0, length, 1.0)
            s = np.minimum(np.maximum(s, 0.0), 1.0)
            p, q, r = a + s*u, b + s*v, c + s*w
            square = np.minimum(square, p*p + q*q + r*r)
        self._before = away
        return (np.sqrt(square) - self._reach_m).min(axis=-1)
