"""
The space segment: the true motion of the axis, and its sensors.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_missions.attitude_hold.end import ended
from rvd_missions.attitude_hold.settings import Attitude, Craft, Faults, Limits
from rvd_missions.attitude_hold.signals import DOWNLINK, MEASUREMENT, TRUTH


@settings
class DynamicsParams:
    """Where a run starts, and what disturbs it."""

    angle_deg: float = param(0.0, 'Mean angle at the start [deg].', low=-90.0, high=90.0)
    rate_deg_s: float = param(0.0, 'Mean rate at the start [deg/s].', low=-10.0, high=10.0)
    angle_sigma_deg: float = param(
        0.05, 'Standard deviation of the angle at the start [deg].', low=0.0, high=90.0)
    rate_sigma_deg_s: float = param(
        0.002, 'Standard deviation of the rate at the start [deg/s].', low=0.0, high=10.0)
    disturbance_n_m: float = param(
        0.0, 'Constant disturbance torque [N m].', low=-1e6, high=1e6)


@settings
class SensorParams:
    """Noise of the sensors, and how they are combined."""

    horizon_sigma_deg: float = param(
        0.002, 'Standard deviation of the horizon sensor [deg].', low=0.0, high=90.0)
    sun_sigma_deg: float = param(
        0.002, 'Standard deviation of the sun sensor [deg].', low=0.0, high=90.0)
    gyro_sigma_deg: float = param(
        0.002, 'Standard deviation of the angle that the gyro adds up in one step [deg].',
        low=0.0, high=90.0)
    gyro_weight: float = param(
        0.5, 'Share of the attitude carried on by the gyro in the measured attitude; the mean of '
        'horizon and sun sensor has the rest.', low=0.0, below=1.0)


class AttitudeDynamics:
    """The true motion: J angle'' = gain * torque + disturbance, constant over each step."""

    def __init__(self, settings: DynamicsParams, run: Run, craft: Craft, faults: Faults,
                 attitude: Attitude, limits: Limits, scatter: NDArray, batch: tuple) -> None:
        self._run, self._craft, self._faults = run, craft, faults
        self._attitude, self._limits = attitude, limits
        self._disturbance = settings.disturbance_n_m
        mean = np.radians([settings.angle_deg, settings.rate_deg_s])
        sigma = np.radians([settings.angle_sigma_deg, settings.rate_sigma_deg_s])
        self._state = mean + sigma*scatter
        self._torque = np.full((*batch, 1), np.nan)

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the torque commanded in the step before."""
        h = self._run.step_s
        if k > 0:
            self._torque = self._faults.actuator(k - 1, h)*thrust.command
            a = (self._torque + self._disturbance) / self._craft.inertia_kg_m2
            angle, rate = self._state[..., 0:1], self._state[..., 1:2]
            self._state = np.concatenate([angle + h*rate + 0.5*h*h*a, rate + h*a], axis=-1)
        error = self._state[..., 0] - self._attitude.at(k, h)
        return {'truth': TRUTH(state=self._state, torque=self._torque, final=ended(
            k, error, self._limits, self._run.last_step))}


class AttitudeSensors:
    """
    Horizon sensor, sun sensor and gyro, and their combination with fixed weights.

    The three share one gain. The combination carries the last measured attitude on by the gyro and
    mixes it with the mean of the other two: it is exact for a true motion at a constant gain, so
    that it shapes the noise and adds no lag.
    """

    def __init__(self, settings: SensorParams, run: Run, faults: Faults, noise: NDArray) -> None:
        self._run, self._faults, self._noise = run, faults, noise
        self._sigma = np.radians([settings.horizon_sigma_deg, settings.sun_sigma_deg,
                                  settings.gyro_sigma_deg])
        self._weight = settings.gyro_weight
        self._before = self._attitude = None

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the measurement of step k and the downlink that carries it."""
        gain, angle = self._faults.sensor(k, self._run.step_s), truth.state[..., 0]
        moved = np.zeros_like(angle) if self._before is None else angle - self._before
        noise = self._sigma*self._noise[..., k, :]
        horizon, sun = gain*angle + noise[..., 0], gain*angle + noise[..., 1]
        turned = gain*moved + noise[..., 2]
        seen = 0.5*(horizon + sun)
        self._attitude = seen if self._attitude is None else (
            self._weight*(self._attitude + turned) + (1.0 - self._weight)*seen)
        self._before = angle
        state = np.stack([self._attitude, turned/self._run.step_s], axis=-1)
        return {'measurement': MEASUREMENT(state=state, sensors=np.stack(
                    [horizon, sun, turned], axis=-1)),
                'downlink': DOWNLINK(state=state)}
