"""
What the ground takes the commands for that it has sent and cannot see yet.

A command acts with probability 1 - p, for the step that it was sent for, or not at all. So an
acceleration u in flight has the mean (1 - p) u and the covariance p (1 - p) u u'; where telemetry
has told whether it acted, there is nothing to guess. `IN_FLIGHT` lists two ways to use that:

expected    predictions and estimates are means
as_sent     they are those of the paper (Zhang, Li, Tang 2014, eq. 7 and 8), which counts every
            command as it was sent. Their mean is off by p u for each; the covariance says so:
            it is about what is shown, not about the mean.

The probability is the link's, as its settings say it, and then what telemetry has told: the fate of
each of our commands whose sample came. It counts as PRIOR commands of known fate.

Limits  commands are taken to fare independently: bursts of losses are wider than is said here.
"""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.motion import cw

Array = NDArray[np.float64]
PRIOR = 50.0                            # [commands] that the link's settings count for


class Loss:
    """Probability that a command of ours does not act (...), by row."""

    def __init__(self, at_first: float, learns: bool, batch: tuple) -> None:
        self._learns = learns
        self._lost = np.full(batch, PRIOR*at_first)
        self._told = np.full(batch, PRIOR)
        self.probability = np.full(batch, at_first)

    def hear(self, acted: NDArray, told: NDArray) -> None:
        """Hear of one command: whether it acted, in the rows that were told."""
        if not self._learns:
            return
        self._told = self._told + told
        self._lost = self._lost + (told & ~acted)
        self.probability = self._lost/self._told


class InFlight(Protocol):
    """What `IN_FLIGHT` lists: made with (loss, phi, gamma, loop, batch)."""

    def mean(self, own: Array, lost: Array) -> Array:
        """Return what counts for a command (..., 3) that is `lost` (...) by chance [m/s^2]."""

    def past(self, counted: Array, own: Array, acted: NDArray, told: NDArray, lost: Array
             ) -> tuple[Array, Array | None]:
        """
        Return what acted before a sample, and its covariance (..., 4), None: nothing to add.

        `counted` is what counted for it in flight; `told` says in which rows telemetry has told
        whether it `acted`; elsewhere it is `lost` by chance.
        """

    def updated(self, own: Array, gain: Array, taken: NDArray) -> None:
        """Be told what a sample did to the estimate; only where covariances are tracked."""

    def estimate_scatter(self) -> Array | float:
        """Return what the filter's covariance leaves out (..., 6, 6)."""

    def scatter(self, own: Array) -> Array:
        """Return what commands in flight (n, ..., 3) add to the covariance of the prediction."""


class Expected:
    """Means."""

    def __init__(self, loss: Loss, phi: Array, gamma: Array, loop: int, batch: tuple) -> None:
        self._loss, self._batch = loss, batch
        self._reach = reach(phi, gamma, loop)

    def mean(self, own: Array, lost: Array) -> Array:
        """Return the mean of a command in flight."""
        return (1.0 - lost)[..., None] * own

    def past(self, counted: Array, own: Array, acted: NDArray, told: NDArray, lost: Array
             ) -> tuple[Array, Array | None]:
        """Return what acted where that is known, the mean and its covariance elsewhere."""
        p = np.where(told, 0.0, lost)
        each = [own[..., i] for i in range(3)]
        squares = np.stack([*(u*u for u in each), each[0]*each[1]], axis=-1)
        return (np.where(told[..., None], acted[..., None]*own, counted),
                (p*(1.0 - p))[..., None]*squares)

    def updated(self, own: Array, gain: Array, taken: NDArray) -> None:
        """Have nothing to follow: the filter knows all of it."""

    def estimate_scatter(self) -> float:
        """Return nothing."""
        return 0.0

    def scatter(self, own: Array) -> Array:
        """Return the sum over the commands in flight."""
        p = self._loss.probability
        return _squares(_pushed(self._reach, own), p*(1.0 - p))


class AsSent:
    """The paper's; what commands that were lost do to the filter is followed beside it."""

    def __init__(self, loss: Loss, phi: Array, gamma: Array, loop: int, batch: tuple) -> None:
        self._loss, self._phi, self._gamma = loss, phi, gamma
        self._phi_loop = np.linalg.matrix_power(phi, loop)
        self._reach = reach(phi, gamma, loop)
        self._bias, self._scatter = np.zeros((*batch, 6)), np.zeros((*batch, 6, 6))

    def mean(self, own: Array, lost: Array) -> Array:
        """Return the command."""
        return own

    def past(self, counted: Array, own: Array, acted: NDArray, told: NDArray, lost: Array
             ) -> tuple[Array, Array | None]:
        """Return what was sent."""
        return counted, None

    def updated(self, own: Array, gain: Array, taken: NDArray) -> None:
        """Carry bias and scatter of the estimate over one sample."""
        p = self._loss.probability
        pushed = cw.product(self._gamma, own)
        bias = cw.product(self._phi, self._bias) + p[..., None]*pushed
        scatter = (self._phi @ self._scatter @ self._phi.T
                   + (p*(1.0 - p))[..., None, None]*_outer(pushed))
        left = np.eye(6) - gain
        self._bias = np.where(taken[..., None], (left @ bias[..., None])[..., 0], bias)
        self._scatter = np.where(taken[..., None, None],
                                 left @ scatter @ np.swapaxes(left, -1, -2), scatter)

    def estimate_scatter(self) -> Array:
        """Return the mean square about the estimate that is shown."""
        return self._scatter + _outer(self._bias)

    def scatter(self, own: Array) -> Array:
        """Return the mean square about the prediction that is shown, besides the filter's."""
        p = self._loss.probability
        pushed = _pushed(self._reach, own)
        bias = cw.product(self._phi_loop, self._bias) + p[..., None]*pushed.sum(axis=0)
        return (self._phi_loop @ self._scatter @ self._phi_loop.T
                + _squares(pushed, p*(1.0 - p)) + _outer(bias))


IN_FLIGHT = {'expected': Expected, 'as_sent': AsSent}


def reach(phi: Array, gamma: Array, loop: int) -> Array:
    """Return what an acceleration in each step of a loop adds to the last state, (n, 6, 3)."""
    found = []
    for _ in range(loop):
        found.insert(0, phi @ found[0] if found else gamma)
    return np.array(found).reshape(loop, 6, 3)


def thrust_noise(reached: Array, own: Array, fraction: float) -> Array:
    """Return the covariance (..., 6, 6) of thrusts (n, ..., 3) that are off by a fraction."""
    each = reached.reshape(len(own), *[1]*(own.ndim - 2), 6, 3)*(fraction*own)[..., None, :]
    return sum(_outer(each[..., axis]) for axis in range(3)).sum(axis=0)


def _pushed(reached: Array, own: Array) -> Array:
    """Return what each acceleration (n, ..., 3) adds to the state at the end, (n, ..., 6)."""
    each = reached.reshape(len(own), *[1]*(own.ndim - 2), 6, 3)
    return sum(each[..., axis]*own[..., axis, None] for axis in range(3))


def _squares(pushed: Array, weight: Array) -> Array:
    """Return the weighted sum of squares (..., 6, 6) of (n, ..., 6)."""
    return weight[..., None, None]*_outer(pushed).sum(axis=0)


def _outer(vector: Array) -> Array:
    """Return v v' of vectors (..., 6); not by matmul, whose bits differ from one row to many."""
    return vector[..., :, None]*vector[..., None, :]
