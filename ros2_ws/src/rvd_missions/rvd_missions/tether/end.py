"""
When a run ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_missions.tether.settings import ApproachParams, ArrivalParams


def collided(target: NDArray, arrival: ArrivalParams) -> NDArray[np.bool_]:
    """Return which grippers are at the target, from the vectors (..., 3) to it."""
    return _size(target) < arrival.collision_m


def lost(state: NDArray, approach: ApproachParams, arrival: ArrivalParams) -> NDArray[np.bool_]:
    """Return which grippers of states (..., 13) are far away."""
    return ~(_size(state[..., :3]) < arrival.lost_factor*approach.baseline_m)


def ended(k: int, state: NDArray, target: NDArray, approach: ApproachParams,
          arrival: ArrivalParams, last_step: int) -> NDArray[np.bool_]:
    """Return which runs end with step k: at the plan's end, collided, lost or not finite."""
    return (collided(target, arrival) | lost(state, approach, arrival) | (k >= last_step)
            | ~np.isfinite(state).all(axis=-1))


def _size(v: NDArray) -> NDArray:
    return np.sqrt(v[..., 0]*v[..., 0] + v[..., 1]*v[..., 1] + v[..., 2]*v[..., 2])
