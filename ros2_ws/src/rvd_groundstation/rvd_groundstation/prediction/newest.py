"""
No prediction at all: what the ground shows and uses is the newest sample, as it came.

An ablation, and the loop as it was before predictive displays: the state is old by the delay of
the link back when it comes, and by the whole loop when a command for it acts.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.news import News
from rvd_groundstation.prediction.predictor import FAR, Prediction


class Newest:
    """Stands in for `Predictor`: estimate and prediction are the newest sample (..., 6)."""

    def __init__(self, batch: tuple = (), track: bool = True) -> None:
        """Start with nothing received; `track` asks for covariances, which are unknown."""
        self._state = np.full((*batch, 6), np.nan)
        self._covariance = np.full((*batch, 6, 6), np.nan) if track else None

    def advance(self, step: int, measured: ArrayLike | None, received: ArrayLike,
                *_: object) -> Prediction:
        """Take what arrived in this step; parameters as those of `Predictor.advance`."""
        if measured is not None:
            measured = np.asarray(measured, dtype=float)
            came = np.asarray(received, dtype=bool) & (np.abs(measured) <= FAR).all(axis=-1)
            self._state = np.where(came[..., None], measured, self._state)
        valid: NDArray[np.bool_] = np.isfinite(self._state).all(axis=-1)
        return Prediction(self._state, self._covariance, self._state, self._covariance, valid)

    def news(self) -> News:
        """Have nothing to tell: no filter begins anew."""
        return []
