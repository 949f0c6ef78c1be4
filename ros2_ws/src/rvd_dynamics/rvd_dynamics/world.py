"""
Settings of the two nodes that are the true world: the motion and the sensor.
"""

from dataclasses import dataclass

from rvd_dynamics.orbit.models import TRUTH_MODELS
from rvd_dynamics.params import choice, param, require
from rvd_dynamics.sensors import SENSORS
from rvd_dynamics.spacecraft.start import ScatterParams


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


SensorParams = choice('SensorParams', 'sensor', SENSORS, 'multiplicative', 'Sensor:')
