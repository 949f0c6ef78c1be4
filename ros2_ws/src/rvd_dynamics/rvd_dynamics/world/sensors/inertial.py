"""
The inertial unit: angular velocity and specific force in body axes, with bias and noise.

Model   gyro: w + b + noise, b' = white noise; `integrating` gives the mean over the step, as a
        gyro that counts angle does, `sampled` the value at its end. Accelerometers alike, with a
        constant bias. The unit sits at the centre of mass.
Source  An, Qu, Wang 2015, section 2.4: w and f from the unit; no numbers. Those here are assumed.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings

Array = NDArray[np.float64]
GYROS = ('integrating', 'sampled')
DEG_H = np.radians(1.0)/3600.0          # [rad/s] in a degree an hour
DRAWS = 9                               # normals a step: gyro, accelerometer, walk
START_DRAWS = 6                         # normals a run: both biases


@settings
class InertialParams:
    """The inertial unit."""

    gyro: str = param('integrating', 'What the gyro gives: the mean over a step or the value at '
                      'its end.', choices=GYROS)
    gyro_sigma_deg_s: float = param(
        0.005, 'Standard deviation of the noise of a sample of the gyro [deg/s].', low=0.0,
        high=10.0)
    gyro_bias_deg_h: float = param(
        5.0, 'Standard deviation of the gyro\'s bias at the start [deg/h].', low=0.0, high=1e5)
    gyro_walk_rad_s: float = param(
        1e-7, 'Standard deviation by which the bias walks in a second [rad/s].', low=0.0, high=1.0)
    accel_sigma_m_s2: float = param(
        1e-3, 'Standard deviation of the noise of a sample of the accelerometer [m/s^2].', low=0.0,
        high=10.0)
    accel_bias_m_s2: float = param(
        3e-4, 'Standard deviation of the accelerometer\'s bias [m/s^2].', low=0.0, high=10.0)


class InertialUnit:
    """Inertial units of a batch of runs, and their biases."""

    def __init__(self, settings: InertialParams, step_s: float, start: ArrayLike) -> None:
        start = np.asarray(start, dtype=float)              # (..., START_DRAWS)
        self._settings, self._step_s = settings, step_s
        self.gyro_bias = settings.gyro_bias_deg_h*DEG_H*start[..., :3]
        self.accel_bias = settings.accel_bias_m_s2*start[..., 3:]
        self._walk = settings.gyro_walk_rad_s*np.sqrt(step_s)

    def measure(self, rate: ArrayLike, felt: ArrayLike, turned: ArrayLike, gained: ArrayLike,
                normals: ArrayLike) -> tuple[Array, Array]:
        """
        Return angular velocity [rad/s] and specific force [m/s^2], (..., 3) each.

        `rate`, `felt` at the end of the step and `turned`, `gained` over it, as the plant has
        them; `normals` (..., DRAWS).
        """
        s, normals = self._settings, np.asarray(normals, dtype=float)
        if s.gyro == 'integrating':
            rate, felt = turned/self._step_s, gained/self._step_s
        self.gyro_bias = self.gyro_bias + self._walk*normals[..., 6:9]
        sigma = np.radians(s.gyro_sigma_deg_s)
        return (rate + self.gyro_bias + sigma*normals[..., 0:3],
                felt + self.accel_bias + s.accel_sigma_m_s2*normals[..., 3:6])
