"""
Settings of the two nodes that are the true world: the motion with its start, and the sensor.

Source  Zhang, Li, Tang 2014, section 3.1: scatter of the start, 1 % noise on thrust. That an error
        lasts for a burn is ours.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion.orbit import ScatterParams, StartParams
from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.diagram.params import choice, param, settings
from rvd_dynamics.world.sensors import SENSORS
from rvd_dynamics.world.spacecraft.thrusters import ERRORS


@settings
class DynamicsParams:
    """Settings of `spacecraft_dynamics`; the YAML keys are these names."""

    truth_model: str = param(
        'cw', 'Model of the true relative motion.', choices=TRUTH_MODELS)
    execution_noise_fraction: float = param(
        0.01, 'Standard deviation of the executed thrust, as a fraction of the commanded one.',
        low=0.0, high=1.0)
    execution_noise_per: str = param(
        'step', 'For how long an error of the thrust lasts: a step, as the paper draws it, or the '
        'whole burn.', choices=ERRORS)
    thrust_fraction: float = param(
        1.0, 'Thrust that the craft gives on average, as a fraction of that of the levels, which '
        'pilot and law are not told.', low=0.0, high=2.0)
    scatter: ScatterParams = param(ScatterParams, 'Scatter of the start about its nominal state.')

    def start(self, start: StartParams, normals: ArrayLike) -> NDArray[np.float64]:
        """Return states (..., 6) about the nominal start for standard normal draws (..., 6)."""
        return start.state + self.scatter.sigma * np.asarray(normals, dtype=float)


SensorParams = choice('SensorParams', 'sensor', SENSORS, 'multiplicative',
                      'Sensor that measures the relative state.')
