"""
Settings of the true world: model of motion, start scatter, execution noise.

Source  Zhang, Li, Tang 2014, section 3.1: scatter of the start, 1 % noise on thrust.
"""

from dataclasses import dataclass
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.mission import Mission
from rvd_dynamics.orbit.models import TRUTH_MODELS
from rvd_dynamics.params import param, require


@dataclass(frozen=True)
class DynamicsParams:
    """Settings of `spacecraft_dynamics`; the YAML keys are these names."""

    truth_model: str = param('cw', f'Model of the true motion: {", ".join(TRUTH_MODELS)}.')
    execution_noise_fraction: float = param(0.01, 'Standard deviation of thrust, of its value.')
    start_position_sigma_m: tuple = param((0.0, 0.5, 0.5), 'Start scatter of x, y, z [m].')
    start_velocity_sigma_m_s: tuple = param((0.0, 0.01, 0.01), 'Start scatter of rates [m/s].')

    def __post_init__(self) -> None:
        require(self.truth_model in TRUTH_MODELS, 'truth_model',
                f'be one of {", ".join(TRUTH_MODELS)}', self.truth_model)
        require(0.0 <= self.execution_noise_fraction <= 1.0, 'execution_noise_fraction',
                'be between 0 and 1', self.execution_noise_fraction)
        for name in ('start_position_sigma_m', 'start_velocity_sigma_m_s'):
            sigma = getattr(self, name)
            require(len(sigma) == 3 and all(isfinite(s) and s >= 0.0 for s in sigma), name,
                    'be three numbers, none negative', list(sigma))

    def start(self, mission: Mission, normals: NDArray) -> NDArray[np.float64]:
        """Return the scattered start state (..., 6) for standard normals (..., 6)."""
        nominal = np.array(mission.start.position_m + mission.start.velocity_m_s)
        sigma = np.array(self.start_position_sigma_m + self.start_velocity_sigma_m_s)
        return nominal + sigma * normals
