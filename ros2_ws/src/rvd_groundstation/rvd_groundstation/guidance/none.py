"""
No guidance: the automatic controller never thrusts, as in condition 1 of the paper.
"""

from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import settings


@settings
class NoLaw:
    """Wants nothing, ever."""

    uses_stick: ClassVar[bool] = False

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None) -> NDArray[np.float64]:
        """Return zeros (..., 3) for states (..., 6)."""
        return np.zeros((*np.shape(prediction)[:-1], 3))
