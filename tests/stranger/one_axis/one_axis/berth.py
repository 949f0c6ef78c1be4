"""
The berth, and when a run ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class Berth:
    """Where and how the craft is to come to rest."""

    max_offset_m: float = param(0.05, 'Distance within which a craft is at the berth [m].',
                                above=0.0)
    max_speed_m_s: float = param(0.01, 'Speed below which it is at rest [m/s].', above=0.0)
    max_overshoot_m: float = param(0.2, 'Distance beyond the berth that must not be reached [m].',
                                   above=0.0)

    def reached(self, state: NDArray) -> NDArray[np.bool_]:
        """Return whether craft of states (..., 2) are at rest at the berth."""
        return ((np.abs(state[..., 0]) < self.max_offset_m)
                & (np.abs(state[..., 1]) < self.max_speed_m_s))


def ended(k: int, state: NDArray, berth: Berth, last_step: int) -> NDArray[np.bool_]:
    """Return which runs end with step k: at the berth, out of time, or no longer finite."""
    return berth.reached(state) | (k >= last_step) | ~np.isfinite(state).all(axis=-1)
