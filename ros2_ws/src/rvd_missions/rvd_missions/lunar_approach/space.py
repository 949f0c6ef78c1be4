"""
The space segment of the approach: the true motion, and the sensor.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import REASON_EMPTY
from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.world.settings import DynamicsParams, SensorParams
from rvd_dynamics.world.spacecraft.thrusters import execute, OfBurns
from rvd_missions.lunar_approach.end import ended
from rvd_missions.lunar_approach.settings import Obstacles
from rvd_missions.lunar_approach.signals import DOWNLINK, MEASUREMENT, TRUTH


class SpacecraftDynamics:
    """The chaser's true motion relative to the target."""

    def __init__(self, settings: DynamicsParams, run: Run, orbit: OrbitParams, start: StartParams,
                 form: LevelForm, obstacles: Obstacles, runs: Sequence[int], scatter: NDArray,
                 execution: NDArray, batch: tuple) -> None:
        self._model = TRUTH_MODELS[settings.truth_model](orbit, run.step_s)
        self._form, self._last_step = form, run.last_step
        self._noise, self._noise_fraction = execution, settings.execution_noise_fraction
        self._burns = OfBurns(batch) if settings.execution_noise_per == 'burn' else None
        self._thrust_fraction = settings.thrust_fraction
        self._state = settings.start(start, scatter)
        self._places, self._radii = obstacles.places(run.seed, runs, batch), obstacles.radii
        self._acceleration = np.full((*batch, 3), np.nan)

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the thrust of the step before."""
        if k > 0:
            self._acceleration = self._thrust_fraction*self._executed(
                self._form.effect(thrust.command), self._noise[..., k - 1, :])
            self._state = self._model.advance(self._state, self._acceleration)
        final = ended(k, self._state, self._last_step, self._places, self._radii)
        return {'truth': TRUTH(state=self._state, acceleration=self._acceleration, final=final)}

    def _executed(self, nominal: NDArray, normals: NDArray) -> NDArray[np.float64]:
        if self._burns is not None:
            normals = self._burns.of(nominal, normals)
        return execute(nominal, normals, self._noise_fraction)


class RelativeSensor:
    """What the chaser measures, and what it sends down."""

    def __init__(self, settings: SensorParams, legs: Legs, noise: NDArray, batch: tuple,
                 wanted: frozenset[str], added: NDArray | None = None,
                 bias: NDArray | None = None) -> None:
        self._sensor, self._noise = settings.selected, noise
        self._added, self._bias = added, bias
        self._acknowledges = 'downlink.accepted' in wanted
        self._accepted = np.zeros(batch, dtype=np.int64)
        self._forward = legs.forward

    def step(self, k: int, truth: Any, thrust: Any) -> dict[str, Any]:
        """Return the measurement of step k and the downlink that carries it."""
        more = () if self._added is None else (self._added[..., k, :], self._bias)
        measured = self._sensor.measure(truth.state, self._noise[..., k, :], *more)
        told = self._acknowledged(k, thrust) if self._acknowledges else {}
        return {'measurement': MEASUREMENT(state=measured),
                'downlink': DOWNLINK(state=measured, **told)}

    def _acknowledged(self, k: int, thrust: Any) -> dict[str, Any]:
        """
        Return the last command that the guard accepted, and why it refused one just now.

        In one process frames have no numbers: a command that acts was sent a leg before, for the
        step before this one, and the frame of step j has number j + 1.
        """
        if thrust.sequence is None:
            if thrust.valid is not None:
                self._accepted = np.where(thrust.valid, max(k - self._forward, 0), self._accepted)
            return {'accepted': self._accepted}
        refusal = 0 if thrust.sequence else int(thrust.reason)          # none was accepted: why
        self._accepted = np.maximum(self._accepted, thrust.sequence)
        return {'accepted': self._accepted, 'refusal': 0 if refusal == REASON_EMPTY else refusal}
