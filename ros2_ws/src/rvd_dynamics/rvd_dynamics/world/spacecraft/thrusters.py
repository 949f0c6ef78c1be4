"""
Thrusters: levels become acceleration along the axes of the target orbital frame.

Valid   attitude held, thrusters aligned with the axes, mass constant, no rise time.
Source  Zhang, Li, Tang 2014, section 3.2: executed = U (1 + 0.01 N(0, 1)), each axis apart.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.mission import ThrustParams
from rvd_dynamics.commands.levels import acceleration


def execute(levels: ArrayLike, thrust: ThrustParams, normals: ArrayLike,
            noise_fraction: float) -> NDArray[np.float64]:
    """
    Return the acceleration (..., 3) [m/s^2] that the thrusters really give.

    Parameters
    ----------
    levels : array_like of int, shape (..., 3)
        Levels, -3 to 3; anything else is a ValueError.
    thrust : ThrustParams
        Table 2.
    normals : array_like, shape (..., 3)
        Standard normal draws; a NaN gives NaN thrust on its axis, also at level 0.
    noise_fraction : float
        Deviation of the executed thrust as a fraction of the commanded one.
    """
    nominal = acceleration(levels, thrust)
    return nominal * (1.0 + noise_fraction * np.asarray(normals, dtype=float))
