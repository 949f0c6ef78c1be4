"""
When an approach ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.obstacles import clearance


def ended(step: int, state: ArrayLike, last_step: int, places: NDArray | None = None,
          radii: NDArray | None = None) -> NDArray[np.bool_]:
    """
    Return which runs end with this step, from the states (..., 6) alone; shape (...).

    A run ends where the chaser has reached the docking plane x = 0 or an obstacle (`places`
    (..., M, 3), `radii` (M,)), at the time limit, or where the truth is no longer finite. Leaving
    the corridor does not end a run. The judge's own `Judge.ended` remembers, and also knows of a
    plane or an obstacle that was reached and left between samples.
    """
    state = np.asarray(state)
    over = ~(state[..., 0] < 0.0)
    if time_is_up(step, last_step):
        over = np.ones_like(over)
    if places is not None and len(radii):
        over = over | ~(clearance(state, places, radii) > 0.0).all(axis=-1)
    finite = np.isfinite(state)
    return over if finite.all() else over | ~finite.all(axis=-1)


def time_is_up(step: int, last_step: int) -> bool:
    """Say whether every run that is still under way ends with this step."""
    return step >= last_step
