"""
Thrusters: what is commanded becomes acceleration along the axes of the target orbital frame.

Valid   attitude held, thrusters aligned with the axes, mass constant, no rise time.
Source  Zhang, Li, Tang 2014, section 3.2: executed = U (1 + 0.01 N(0, 1)), each axis apart.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray


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
