"""
The space segment: the true motion of chaser and obstacles, and what the chaser measures.

The chaser thrusts; an obstacle stands in the target's frame or drifts on an orbit of its own.
Clohessy-Wiltshire motion in closed form, with the acceleration held over a step.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.obstacles import rows_of
from rvd_dynamics.motion import cw
from rvd_dynamics.world.spacecraft.thrusters import execute
from rvd_missions.obstacle_field.end import ended
from rvd_missions.obstacle_field.settings import Craft, Obstacles, Orbit, STATIC, Start


@settings
class ObstacleStates:
    """Where the obstacles are at the start."""

    position_m: tuple = param(
        (35.17, -7.37, -17.58, 22.82, -5.01, -11.41, 11.39, -2.62, -5.70),
        'Position x, y, z of one obstacle after the other [m].')
    velocity_m_s: tuple = param(
        (0.0,), 'Velocity x, y, z of one obstacle after the other, where a single 0 means that '
        'none moves [m/s].')

    def states(self, obstacles: Obstacles) -> NDArray[np.float64]:
        """
        Return the states (M, 6) of the obstacles.

        Raises
        ------
        ValueError
            If the lists do not fit the obstacles, or a static one has a velocity.
        """
        listed = len(obstacles.radius_m)
        places = rows_of('position_m', self.position_m, listed, 'obstacles.radius_m')
        velocity = self.velocity_m_s if tuple(self.velocity_m_s) != (0.0,) else (0.0,)*(3*listed)
        require(len(velocity) == 3*listed, 'velocity_m_s',
                f'be {3*listed} numbers, three for each of obstacles.radius_m, or a single 0',
                list(velocity))
        made = np.concatenate([places, np.reshape(velocity, (-1, 3))], axis=1)
        for i, (state, motion) in enumerate(zip(made, obstacles.motion)):
            require(motion != STATIC or not np.any(state[3:]), 'velocity_m_s',
                    f'be 0 of obstacle {i + 1}, which is static', state[3:].tolist())
        return made[:obstacles.count]


@settings
class Scatter:
    """Standard deviations of the start about its nominal state; zero means no scatter."""

    position_m: float = param(
        0.0, 'Standard deviation of each component of the start position [m].', low=0.0, high=100.0)
    velocity_m_s: float = param(
        0.0, 'Standard deviation of each component of the start velocity [m/s].', low=0.0,
        high=10.0)
    obstacle_m: float = param(
        0.0, 'Standard deviation of each component of an obstacle\'s position [m].', low=0.0,
        high=100.0)

    @property
    def any(self) -> bool:
        """Whether anything is drawn."""
        return bool(self.position_m or self.velocity_m_s or self.obstacle_m)


@settings
class DynamicsParams:
    """Settings of `spacecraft_dynamics`."""

    execution_noise_fraction: float = param(
        0.0, 'Standard deviation of the executed thrust, as a fraction of the commanded one.',
        low=0.0, high=1.0)
    obstacles: ObstacleStates = param(ObstacleStates, 'Where the obstacles are at the start.')
    scatter: Scatter = param(Scatter, 'Scatter of the start about its nominal state.')


@settings
class SensorParams:
    """Noise of what the chaser measures of itself and of the obstacles; zero is the source's."""

    position_sigma_m: float = param(
        0.0, 'Standard deviation of each component of the own position [m].', low=0.0, high=100.0)
    velocity_sigma_m_s: float = param(
        0.0, 'Standard deviation of each component of the own velocity [m/s].', low=0.0, high=10.0)
    obstacle_position_sigma_m: float = param(
        0.0, 'Standard deviation of each component of an obstacle\'s position [m].', low=0.0,
        high=100.0)
    obstacle_velocity_sigma_m_s: float = param(
        0.0, 'Standard deviation of each component of an obstacle\'s velocity [m/s].', low=0.0,
        high=10.0)

    def sigma(self, obstacles: int) -> NDArray[np.float64]:
        """Return the deviation of each number that is sent down, (6 + 6 M,)."""
        def of(position: float, velocity: float) -> list[float]:
            return [position]*3 + [velocity]*3
        return np.array(of(self.position_sigma_m, self.velocity_sigma_m_s) + obstacles * of(
            self.obstacle_position_sigma_m, self.obstacle_velocity_sigma_m_s))


class SpacecraftDynamics:
    """The true motion relative to the target."""

    def __init__(self, settings: DynamicsParams, run: Run, orbit: Orbit, start: Start,
                 craft: Craft, obstacles: Obstacles, reach_m: NDArray, form: CommandForm,
                 batch: tuple, block: Block, scatter: NDArray | None = None,
                 execution: NDArray | None = None) -> None:
        self._truth, self._form, self._last_step = block.writes['truth'], form, run.last_step
        self._reach_m, self._arrival_m = reach_m, craft.arrival_m
        n, h = orbit.mean_motion, run.step_s
        self._phi, self._gamma = cw.transition(n, h), cw.input_matrix(n, h)
        self._state = np.broadcast_to(start.state, (*batch, 6))
        self._obstacles = settings.obstacles.states(obstacles)      # the same in all rows
        self._moving = obstacles.moving
        if scatter is not None:
            self._scatter(settings.scatter, scatter)
        self._noise, self._noise_fraction = execution, settings.execution_noise_fraction
        self._command = np.broadcast_to(form.neutral, (*batch, 3))
        self._acceleration = np.full((*batch, 3), np.nan)

    def _scatter(self, sigma: Scatter, drawn: NDArray) -> None:
        own = np.repeat([sigma.position_m, sigma.velocity_m_s], 3)
        self._state = self._state + own*drawn[..., :6]
        if sigma.obstacle_m:
            moved = np.zeros((*drawn.shape[:-1], *self._obstacles.shape))
            moved[..., :3] = sigma.obstacle_m * drawn[..., 6:].reshape(*drawn.shape[:-1], -1, 3)
            self._obstacles = self._obstacles + moved

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the thrust of the step before."""
        if k > 0:
            # thrusters that ramp do so whatever is commanded
            self._command = self._form.follow(self._command, self._form.effect(thrust.command))
            accel = self._form.effect(self._command)
            if self._noise is not None:
                accel = execute(accel, self._noise[..., k - 1, :], self._noise_fraction)
            self._acceleration = accel
            self._state = cw.step(self._state, accel, self._phi, self._gamma)
            if self._moving.any():
                moved = cw.product(self._phi, self._obstacles)
                self._obstacles = np.where(self._moving[:, None], moved, self._obstacles)
        final = ended(k, self._state, self._obstacles, self._reach_m, self._arrival_m,
                      self._last_step)
        return {'truth': self._truth(state=self._state, acceleration=self._acceleration,
                                     obstacles=self._obstacles, final=final)}


class RelativeSensor:
    """What the chaser measures of itself and of the obstacles, and sends down."""

    def __init__(self, settings: SensorParams, obstacles: Obstacles, block: Block, batch: tuple,
                 noise: NDArray | None = None) -> None:
        self._downlink, self._batch = block.writes['downlink'], batch
        self._sigma, self._noise = settings.sigma(obstacles.count), noise

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the downlink of step k."""
        seen = np.empty((len(self._sigma), *self._batch))       # components first, as users read it
        seen[:6] = np.moveaxis(truth.state, -1, 0)
        around = np.broadcast_to(truth.obstacles, (*self._batch, *truth.obstacles.shape[-2:]))
        seen[6:] = np.moveaxis(around, (-2, -1), (0, 1)).reshape(-1, *self._batch)
        measured = np.moveaxis(seen, 0, -1)
        if self._noise is not None:
            measured = measured + self._sigma*self._noise[..., k, :]
        return {'downlink': self._downlink(state=measured)}
