"""
No guidance: the automatic controller never thrusts, as in condition 1 of the paper.
"""

from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import settings


@settings
class NoLaw:
    """Level 0 always."""

    mission: Mission
    uses_stick: ClassVar[bool] = False

    def levels(self, prediction: ArrayLike, stick_levels: ArrayLike | None) -> NDArray[np.int8]:
        """Return zeros (..., 3) for states (..., 6)."""
        return np.zeros((*np.shape(prediction)[:-1], 3), dtype=np.int8)
