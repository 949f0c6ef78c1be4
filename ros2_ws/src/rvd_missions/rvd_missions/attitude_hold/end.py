"""
When a run ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_missions.attitude_hold.settings import Limits


def ended(k: int, error: NDArray, limits: Limits, last_step: int) -> NDArray[np.bool_]:
    """Return which runs end with step k: out of time, lost, or no longer finite."""
    return ~(np.abs(error) < np.radians(limits.lost_deg)) | (k >= last_step)
