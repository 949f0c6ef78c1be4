"""
When a run ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_missions.elliptic_rendezvous.settings import ArrivalParams, StartParams


def range_of(state: ArrayLike) -> NDArray[np.float64]:
    """Return the range in the orbital plane of states (..., 6) [m]."""
    state = np.asarray(state)
    return np.sqrt(state[..., 0]*state[..., 0] + state[..., 1]*state[..., 1])


def ended(k: int, state: NDArray, start: StartParams, arrival: ArrivalParams, flies_around: bool,
          last_step: int) -> NDArray[np.bool_]:
    """
    Return which runs end with step k, from the states (..., 6) alone; shape (...).

    An approach ends at its range, the combined mode, which flies around there, at the time limit;
    both where the chaser is lost or its state no longer finite.
    """
    d = range_of(state)
    over = ~(d < arrival.lost_range_factor*start.range_m) | ~np.isfinite(state).all(axis=-1)
    if k >= last_step:
        over = np.ones_like(over)
    return over if flies_around else over | (d <= arrival.range_m)
