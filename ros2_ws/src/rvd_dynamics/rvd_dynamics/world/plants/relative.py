"""
Truth models: how the chaser really moves over one step.

Each is a frozen dataclass, made with the target's orbit and the step, with
`advance(state, accel)`; to add one, write it and list it in TRUTH_MODELS.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion import cw, two_body
from rvd_dynamics.motion.orbit import OrbitParams


class TruthModel(Protocol):
    """What the world asks of a truth model."""

    orbit: OrbitParams
    step_s: float

    def advance(self, state: ArrayLike, accel: ArrayLike) -> NDArray[np.float64]:
        """Return the state (..., 6) one step on, under `accel` (..., 3) [m/s^2] held over it."""


@dataclass(frozen=True)
class Cw:
    """Exact discrete Clohessy-Wiltshire motion."""

    orbit: OrbitParams
    step_s: float

    @cached_property
    def phi(self) -> NDArray[np.float64]:
        """Transition matrix of one step, (6, 6)."""
        return cw.transition(self.orbit.mean_motion, self.step_s)

    @cached_property
    def gamma(self) -> NDArray[np.float64]:
        """Input matrix of one step, (6, 3)."""
        return cw.input_matrix(self.orbit.mean_motion, self.step_s)

    def advance(self, state: ArrayLike, accel: ArrayLike) -> NDArray[np.float64]:
        """Return the state (..., 6) one step on, under `accel` (..., 3) [m/s^2] held over it."""
        return cw.step(state, accel, self.phi, self.gamma)


@dataclass(frozen=True)
class TwoBody:
    """Chaser and target each in the central field of the Moon; see `two_body`."""

    orbit: OrbitParams
    step_s: float

    def advance(self, state: ArrayLike, accel: ArrayLike) -> NDArray[np.float64]:
        """Return the state (..., 6) one step on, under `accel` (..., 3) [m/s^2] held over it."""
        return two_body.step(state, accel, self.orbit.mean_motion, self.orbit.radius_m,
                             self.step_s)


TRUTH_MODELS = {'cw': Cw, 'two_body': TwoBody}
