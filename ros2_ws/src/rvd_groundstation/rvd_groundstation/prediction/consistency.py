"""
Whether predictions are as good as they say: held against the truth of their instant.

NEES        normalised estimation error squared, e' P^-1 e: its mean is 6, the number of states,
            where the covariance P is that of the error e.
Coverage    share of components that lie within two of the deviations that are claimed; 95.4 % of
            a normal distribution. Errors that come of few lost commands are not normal: mostly
            small, and large at times.

Source      Bar-Shalom, Li, Kirubarajan, Estimation with Applications to Tracking and Navigation,
            2001, section 5.4.
Limits      Predictions of one run that follow each other hold the same lost commands: a run says
            as much as a few independent predictions. Intervals go from run to run.
"""

from collections import deque

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SIGMAS = 2.0                            # half width of the band, in deviations


def nees(error: Array, covariance: Array) -> Array:
    """Return e' P^-1 e (...) of errors (..., 6) and covariances (..., 6, 6); NaN where unknown."""
    known = np.isfinite(error).all(axis=-1) & np.isfinite(covariance).all(axis=(-2, -1))
    found = np.full(known.shape, np.nan)
    e, p = error[known], covariance[known]
    scale = np.sqrt(np.diagonal(p, axis1=-2, axis2=-1))         # metres beside mm/s
    e = e / scale
    p = p / (scale[:, :, None] * scale[:, None, :])
    found[known] = (e * np.linalg.solve(p, e[..., None])[..., 0]).sum(axis=-1)
    return found


def within(error: Array, covariance: Array) -> NDArray[np.bool_]:
    """Return which components (..., 6) lie within SIGMAS deviations; none does that is unknown."""
    sigma = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    return np.abs(error) <= SIGMAS*sigma


class Consistency:
    """Follows runs in one process and keeps what their predictions were worth, (N,)."""

    def __init__(self, ahead: int, batch: tuple) -> None:
        """Predictions are for `ahead` steps later."""
        self._made: deque = deque(maxlen=ahead + 1)
        self._count, self._nees, self._within = np.zeros((3, *batch))

    def follow(self, predicted: Array, covariance: Array, truth: Array, live: NDArray) -> None:
        """Take the prediction and the truth of a step; rows that are not `live` have ended."""
        self._made.append((predicted, covariance))
        if len(self._made) < self._made.maxlen:
            return
        predicted, covariance = self._made[0]
        error = predicted - truth
        found = nees(error, covariance)
        counts = live & np.isfinite(found)
        self._count += counts
        self._nees += np.where(counts, found, 0.0)
        self._within += np.where(counts, within(error, covariance).mean(axis=-1), 0.0)

    @property
    def mean_nees(self) -> Array:
        """Mean over the predictions of a run; NaN where there was none."""
        return self._nees / np.where(self._count > 0, self._count, np.nan)

    @property
    def coverage(self) -> Array:
        """The share that lay within the band; NaN where there was no prediction."""
        return self._within / np.where(self._count > 0, self._count, np.nan)
