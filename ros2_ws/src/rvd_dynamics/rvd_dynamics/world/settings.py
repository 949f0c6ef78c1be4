"""
Settings of the two nodes that are the true world: the motion with its start, and the sensor.

Source  Zhang, Li, Tang 2014, section 3.1: scatter of the start, 1 % noise on thrust.
"""

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion.orbit import StartParams
from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.diagram.params import choice, param, require
from rvd_dynamics.world.sensors import SENSORS


@dataclass(frozen=True)
class ScatterParams:
    """Deviations of the start scatter; zero means no scatter."""

    sigma_position_m: tuple = param((0.0, 0.5, 0.5), 'Scatter of the start x, y, z [m].')
    sigma_velocity_m_s: tuple = param((0.0, 0.01, 0.01), 'Scatter of the start rates [m/s].')

    def __post_init__(self) -> None:
        for name in ('sigma_position_m', 'sigma_velocity_m_s'):
            value = getattr(self, name)
            require(len(value) == 3 and all(0.0 <= v < inf for v in value), f'scatter.{name}',
                    'be three numbers, none negative', list(value))


@dataclass(frozen=True)
class DynamicsParams:
    """Settings of `spacecraft_dynamics`; the YAML keys are these names."""

    truth_model: str = param('cw', f'Model of the true motion: {", ".join(TRUTH_MODELS)}.')
    execution_noise_fraction: float = param(
        0.01, 'Deviation of the executed thrust as a fraction of the commanded one.')
    scatter: ScatterParams = param(ScatterParams, 'Scatter of the start.')

    def __post_init__(self) -> None:
        require(self.truth_model in TRUTH_MODELS, 'truth_model',
                f'be one of {", ".join(TRUTH_MODELS)}', self.truth_model)
        require(0.0 <= self.execution_noise_fraction <= 1.0, 'execution_noise_fraction',
                'be between 0 and 1', self.execution_noise_fraction)

    def start(self, start: StartParams, normals: ArrayLike) -> NDArray[np.float64]:
        """Return states (..., 6) about the nominal start for standard normal draws (..., 6)."""
        sigma = np.array(self.scatter.sigma_position_m + self.scatter.sigma_velocity_m_s)
        return start.state + sigma * np.asarray(normals, dtype=float)


SensorParams = choice('SensorParams', 'sensor', SENSORS, 'multiplicative', 'Sensor:')
