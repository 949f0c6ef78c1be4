"""
The space segment: the true motion, and what the craft measures of it.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run

from one_axis.berth import Berth, ended
from one_axis.commands import AccelerationForm
from one_axis.signals import DOWNLINK, TRUTH


@settings
class PlantParams:
    """Where a run starts."""

    position_m: float = param(-10.0, 'Mean position at the start [m].', high=0.0)
    velocity_m_s: float = param(0.0, 'Mean velocity at the start [m/s].')
    position_sigma_m: float = param(
        0.5, 'Standard deviation of the position at the start [m].', low=0.0)
    velocity_sigma_m_s: float = param(
        0.02, 'Standard deviation of the velocity at the start [m/s].', low=0.0)


@settings
class SensorParams:
    """Noise of the sensor."""

    position_sigma_m: float = param(0.003, 'Standard deviation of a position [m].', low=0.0)
    velocity_sigma_m_s: float = param(0.001, 'Standard deviation of a velocity [m/s].', low=0.0)


class Plant:
    """The true motion: x'' = a, with a constant over each step."""

    def __init__(self, settings: PlantParams, run: Run, berth: Berth, form: AccelerationForm,
                 scatter: NDArray, batch: tuple) -> None:
        self._run, self._berth, self._form = run, berth, form
        mean = np.array([settings.position_m, settings.velocity_m_s])
        sigma = np.array([settings.position_sigma_m, settings.velocity_sigma_m_s])
        self._state = mean + sigma*scatter
        self._acceleration = np.full((*batch, 1), np.nan)

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the thrust of the step before."""
        if k > 0:
            h, a = self._run.step_s, self._form.effect(thrust.command)
            x, v = self._state[..., 0:1], self._state[..., 1:2]
            self._state = np.concatenate([x + h*v + 0.5*h*h*a, v + h*a], axis=-1)
            self._acceleration = a
        return {'truth': TRUTH(
            state=self._state, acceleration=self._acceleration,
            final=ended(k, self._state, self._berth, self._run.last_step))}


class Sensor:
    """What the craft measures and sends down."""

    def __init__(self, settings: SensorParams, noise: NDArray) -> None:
        self._sigma = np.array([settings.position_sigma_m, settings.velocity_sigma_m_s])
        self._noise = noise

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the downlink of step k."""
        return {'downlink': DOWNLINK(state=truth.state + self._sigma*self._noise[..., k, :])}
