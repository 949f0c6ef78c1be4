"""
The space segment: the exact motion of both craft, and what the chaser measures.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion import elliptic
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_missions.elliptic_rendezvous.end import ended
from rvd_missions.elliptic_rendezvous.laws import Rrca
from rvd_missions.elliptic_rendezvous.settings import ArrivalParams, StartParams
from rvd_missions.elliptic_rendezvous.signals import DOWNLINK, TRUTH


@settings
class PlantParams:
    """What the thrusters really do."""

    execution_noise_fraction: float = param(
        0.0, 'Standard deviation of the executed thrust, as a fraction of the commanded one.',
        low=0.0, high=1.0)


@settings
class SensorParams:
    """Noise of the sensor."""

    position_sigma_m: float = param(
        0.0, 'Standard deviation of a position, along each axis [m].', low=0.0)
    position_fraction: float = param(
        0.0, 'Standard deviation of a position as a fraction of the range, along each axis.',
        low=0.0, below=1.0)
    velocity_sigma_m_s: float = param(
        0.0, 'Standard deviation of a velocity, along each axis [m/s].', low=0.0)


class SpacecraftDynamics:
    """The chaser's true motion relative to the target."""

    def __init__(self, settings: PlantParams, run: Run, orbit: EllipseParams, start: StartParams,
                 arrival: ArrivalParams, law: Rrca, form: CommandForm, scatter: NDArray,
                 execution: NDArray, batch: tuple) -> None:
        self._run, self._orbit, self._form = run, orbit, form
        self._ends = (start, arrival, law.flies_around, run.last_step)
        self._noise, self._fraction = execution, settings.execution_noise_fraction
        self._state = start.state(scatter)
        self._acceleration = np.full((*batch, 3), np.nan)

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the thrust of the step before."""
        if k > 0:
            dt = self._run.step_s
            self._acceleration = self._form.effect(thrust.command)*(
                1.0 + self._fraction*self._noise[..., k - 1, :])
            self._state = elliptic.step(self._state, self._acceleration, self._orbit, (k - 1)*dt,
                                        dt)
        return {'truth': TRUTH(state=self._state, acceleration=self._acceleration,
                               final=ended(k, self._state, *self._ends))}


class RelativeSensor:
    """What the chaser measures and sends down."""

    def __init__(self, settings: SensorParams, noise: NDArray) -> None:
        self._settings, self._noise = settings, noise

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the downlink of step k."""
        s, state = self._settings, truth.state
        d = np.sqrt((state[..., :3]*state[..., :3]).sum(axis=-1, keepdims=True))
        position = np.sqrt(s.position_sigma_m**2 + (s.position_fraction*d)**2)
        velocity = np.full_like(d, s.velocity_sigma_m_s)
        sigma = np.repeat(np.concatenate([position, velocity], axis=-1), 3, axis=-1)
        return {'downlink': DOWNLINK(state=state + sigma*self._noise[..., k, :])}
