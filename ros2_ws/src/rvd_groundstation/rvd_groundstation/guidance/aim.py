"""
Where a law heads that was made to stop at its target: a point beyond the docking plane.

Frame   target orbital, docking plane at x = 0, the chaser comes from x < 0.
Method  Ours. A law whose speed dies away with the range never reaches the point it heads for; one
        that heads for (b, 0, 0) crosses x = 0 with the speed that it has b metres before its end.
        A least closing speed does the same without moving the point.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class AimParams:
    """The point that a law heads for, and the speed it keeps."""

    beyond_m: float = param(
        0.0, 'Distance beyond the docking plane of the point that the law heads for [m].', low=0.0,
        high=1000.0)
    least_closing_m_s: float = param(
        0.0, 'Closing speed below which the law does not go [m/s].', low=0.0, high=1.0)

    def seen(self, state: ArrayLike) -> NDArray[np.float64]:
        """Return states (..., 6) [m, m/s] as seen from the point."""
        state = np.array(state, dtype=float)
        state[..., 0] -= self.beyond_m
        return state
