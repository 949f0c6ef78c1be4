"""
Live score of the predictor: each prediction compared with the sample of the same instant.

State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Steps   a prediction made at step k is for k + forward_steps; the sample of that instant
        reaches the ground a whole loop later, at k + forward_steps + back_steps.
Limits  the score includes the sample's own noise (1 % of each component); a command lost on
        the way shows as prediction error, as it should.
"""

from collections import deque
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.run import Legs
from rvd_groundstation.prediction.predictor import Prediction

Array = NDArray[np.float64]


class Scored(NamedTuple):
    """Comparison made in one step; the fields of PredictionScore.msg."""

    valid: NDArray[np.bool_]            # (...)    prediction and sample of the same instant exist
    error: Array                        # (..., 6) predicted minus received; NaN when not valid
    sigma: Array                        # (..., 6) deviation the prediction claimed; NaN if none
    scored: NDArray[np.int64]           # (...)    predictions scored so far
    rms: Array                          # (..., 6) so far; NaN when none


class Score:
    """Keeps the predictions of one loop delay and the sums; called once per step, in order."""

    def __init__(self, legs: Legs, batch: tuple = ()) -> None:
        """Start with nothing scored; `batch` is the shape of the leading axes."""
        nothing = np.full((*batch, 6), np.nan)
        self._made = deque([(nothing, nothing)] * (legs.loop + 1), maxlen=legs.loop + 1)
        self._count = np.zeros(batch, dtype=np.int64)
        self._squares = np.zeros((*batch, 6))

    def advance(self, prediction: Prediction, measured: ArrayLike | None,
                received: ArrayLike) -> Scored:
        """
        Keep the prediction of this step, and score the one for the instant of its sample.

        Parameters
        ----------
        prediction : Prediction
            What the predictor returned in this step.
        measured, received
            The sample of this step, as given to the predictor.

        Returns
        -------
        Scored
        """
        self._made.append((prediction.predicted, _deviation(prediction)))
        predicted, sigma = self._made[0]
        sample = np.full_like(predicted, np.nan) if measured is None else np.asarray(measured)
        difference = predicted - sample
        valid = np.isfinite(difference).all(axis=-1) & np.asarray(received, dtype=bool)
        error = np.where(valid[..., None], difference, np.nan)
        self._count = self._count + valid
        self._squares = self._squares + np.where(valid[..., None], difference*difference, 0.0)
        some = np.where(self._count > 0, self._count, np.nan)
        return Scored(valid, error, np.where(valid[..., None], sigma, np.nan), self._count,
                      np.sqrt(self._squares / some[..., None]))


def _deviation(prediction: Prediction) -> Array:
    if prediction.covariance is None:
        return np.full_like(prediction.predicted, np.nan)
    return np.sqrt(np.diagonal(prediction.covariance, axis1=-2, axis2=-1))
