"""
Start of a run: the nominal state of the mission plus a random scatter.

Frame, state as `orbit.cw`.
Source  Zhang, Li, Tang 2014, section 3.1: independent zero-mean normal components.
"""

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.mission import StartParams
from rvd_dynamics.params import param, require


@dataclass(frozen=True)
class ScatterParams:
    """Deviations of the start scatter; zero means no scatter."""

    sigma_position_m: tuple = param((0.0, 0.5, 0.5), 'Scatter of the start x, y, z [m].')
    sigma_velocity_m_s: tuple = param((0.0, 0.01, 0.01),
                                      'Scatter of the start velocity x, y, z [m/s].')

    def __post_init__(self) -> None:
        for name in ('sigma_position_m', 'sigma_velocity_m_s'):
            value = getattr(self, name)
            require(len(value) == 3 and all(0.0 <= v < inf for v in value), name,
                    'be three numbers, not negative', list(value))


def start_state(start: StartParams, scatter: ScatterParams,
                normals: ArrayLike) -> NDArray[np.float64]:
    """Return start states (..., 6) from standard normal draws (..., 6)."""
    nominal = np.array(start.position_m + start.velocity_m_s, dtype=float)
    sigma = np.array(scatter.sigma_position_m + scatter.sigma_velocity_m_s, dtype=float)
    return nominal + sigma * np.asarray(normals, dtype=float)
