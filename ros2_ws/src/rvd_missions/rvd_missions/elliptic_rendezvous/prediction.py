"""
Prediction across the loop for a target on an ellipse, by a linear model that varies in time.

Steps   at step k the telemetry is that of step k - back and a command sent now acts on step
        k + forward.
Model   Yamanaka and Ankersen's matrix and what held thrust adds (`motion.yamanaka_ankersen`),
        from step to step, with the commands in flight. Where no sample came, the last state is
        carried on by the model. There is no filter: a sample is taken as it is.
ABORT   from the first one sent on, what acts is what the guard makes of it (`prediction.abort`).
"""

from collections import deque

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.motion import cw, yamanaka_ankersen
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_groundstation.prediction.abort import AbortProfile, Acting

Array = NDArray[np.float64]


class VaryingPredictor:
    """Called once per step, in order."""

    def __init__(self, orbit: EllipseParams, legs: Legs, form: CommandForm, batch: tuple,
                 abort: AbortProfile | None = None) -> None:
        self._orbit, self._legs, self._form = orbit, legs, form
        self._aborted = None if abort is None else Acting(abort, form)
        neutral = form.effect(np.broadcast_to(form.neutral, (*batch, len(form.neutral))))
        self._state = np.full((*batch, 6), np.nan)
        # what acted, or will act, on the steps from the sample's to the one predicted; [0] is on
        # the step before the sample's
        self._acting = deque([neutral]*(legs.loop + 1), maxlen=legs.loop + 1)
        self._matrices: dict[int, tuple[Array, Array]] = {}

    def advance(self, k: int, measured: ArrayLike, received: ArrayLike, sent: ArrayLike,
                abort: bool = False) -> tuple[Array, Array]:
        """
        Return the newest known state and the one at which a command sent now acts, both (..., 6).

        `measured` (..., 6) is the sample of step k - back, `received` (...) where it came, `sent`
        (..., n) the command of step k - 1, `abort` whether that was an ABORT.
        """
        if k > 0:
            self._acting.append(self._form.effect(sent))
            if self._aborted is not None:
                self._aborted.sent(k - 1, abort)
        m = k - self._legs.back
        if m < 0:
            return self._state, self._state
        received = np.asarray(received)
        before = self._state
        if not received.all():
            before = self._carried(before, m - 1, self._acting[0])
        self._state = np.where(received[..., None], measured, before)
        ahead = self._state
        for i in range(self._legs.loop):
            ahead = self._carried(ahead, m + i, self._acting[i + 1])
        self._matrices.pop(m - 1, None)
        return self._state, ahead

    def _carried(self, state: Array, step: int, accel: Array) -> Array:
        """Return the state one step on from `step`, for which `accel` was sent."""
        if self._aborted is not None:
            accel = self._aborted.mean(step, accel)
        if step not in self._matrices:
            begin, end = step*self._legs.step_s, (step + 1)*self._legs.step_s
            self._matrices[step] = (yamanaka_ankersen.transition(self._orbit, begin, end),
                                    yamanaka_ankersen.input_matrix(self._orbit, begin, end))
        return cw.step(state, accel, *self._matrices[step])
