"""
When a run ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.geometry.obstacles import clearance


def distance(state: NDArray) -> NDArray[np.float64]:
    """Return the distance (...) of states (..., 6) from the target [m]."""
    x, y, z = state[..., 0], state[..., 1], state[..., 2]
    return np.sqrt(x*x + y*y + z*z)


def ended(k: int, state: NDArray, obstacles: NDArray, reach_m: NDArray, arrival_m: float,
          last_step: int) -> NDArray[np.bool_]:
    """
    Return which runs end with step k, from the truth of that step alone; shape (...).

    A run ends with arrival, with contact, at the time limit, or where the truth is not finite. A
    contact between two samples is known to the judge alone.
    """
    over = ~(distance(state) > arrival_m) | (k >= last_step)
    if len(reach_m):
        over = over | ~(clearance(state, obstacles, reach_m) > 0.0).all(axis=-1)
    return over | ~np.isfinite(state).all(axis=-1)
