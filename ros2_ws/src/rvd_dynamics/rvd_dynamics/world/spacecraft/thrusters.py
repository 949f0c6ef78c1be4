"""
Thrusters: what is commanded becomes acceleration along the axes of the target orbital frame.

Valid   attitude held, thrusters aligned with the axes, mass constant, no rise time.
Source  Zhang, Li, Tang 2014, section 3.2: executed = U (1 + 0.01 N(0, 1)), each axis apart.
Errors  `step`: drawn anew in each step, so that what a pulse gives is the more exact the shorter
        the steps are, by their square root. `burn`: valves open once and stay open, so one error lasts
        while a command does; what a pulse gives does not depend on the step.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

ERRORS = ('step', 'burn')               # for how long one lasts


def execute(nominal: ArrayLike, normals: ArrayLike, noise_fraction: float) -> NDArray[np.float64]:
    """
    Return the acceleration (..., 3) [m/s^2] that the thrusters really give.

    Parameters
    ----------
    nominal : array_like, shape (..., 3)
        Acceleration commanded, the effect of the command [m/s^2].
    normals : array_like, shape (..., 3)
        Standard normal draws; a NaN gives NaN thrust on its axis, also where none is commanded.
    noise_fraction : float
        Deviation of the executed thrust as a fraction of the commanded one.
    """
    return nominal * (1.0 + noise_fraction * np.asarray(normals, dtype=float))


class OfBurns:
    """
    Errors that last as long as a burn: the command of an axis, not neutral and unchanged.

    A burn has the error that is drawn for its first step.
    """

    def __init__(self, batch: tuple) -> None:
        self._commanded = np.zeros((*batch, 3))
        self._errors = np.zeros((*batch, 3))

    def of(self, nominal: ArrayLike, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the normals (..., 3) that act in a step, out of those drawn for it (..., 3)."""
        goes_on = (nominal == self._commanded) & (nominal != 0.0)
        self._errors = np.where(goes_on, self._errors, normals)
        self._commanded = nominal
        return self._errors
