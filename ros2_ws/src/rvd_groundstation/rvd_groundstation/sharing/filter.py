"""
The automatic controller as a filter on the stick: its levels are the command.

For laws that see the stick (`uses_stick`) and return the nearest command that they consider safe.
A law that does not see it leaves the pilot without a say.
"""

from math import nan

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import settings

@settings
class StickFilter:
    """Take the automatic command in place of a blend; it has no settings."""

    @property
    def pilot_weight(self) -> float:
        """NaN: nothing is weighted."""
        return nan

    def share(self, pilot: ArrayLike, auto: ArrayLike) -> NDArray[np.int8]:
        """Return the automatic levels, shape (..., 3), in the common shape of both."""
        return np.add(np.zeros_like(pilot), auto, dtype=np.int8)
