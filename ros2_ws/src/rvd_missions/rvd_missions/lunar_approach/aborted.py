"""
The way of an aborted approach, for the console: what the guard does from the ABORT on.

Frame   target orbital, state (x, y, z, vx, vy, vz) [m, m/s], as `motion.cw`.
What    the mean over the steps at which the ABORT may come into force (`prediction.abort`), as the
        predictor has it: commands in flight until then, the burn, the coast.
Limits  an ABORT that skipped some steps and was never sent again is not foreseen.
"""

from collections import deque
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_groundstation.prediction.abort import AbortProfile, Acting

POINT_S = 0.5                   # [s] between two points of the way, about


class AbortedWay:
    """Hears each command that is sent; there is a way once one of them is an ABORT."""

    def __init__(self, profile: AbortProfile, form: CommandForm, orbit: OrbitParams, legs: Legs,
                 run: Run) -> None:
        self._form, self._n = form, orbit.mean_motion
        self._forward, self._step_s = legs.forward, run.step_s
        self._phi, self._gamma = cw.transition(self._n, run.step_s), \
            cw.input_matrix(self._n, run.step_s)
        self._retreat = form.effect(np.asarray(form.retreat))
        self._sent: deque[tuple[int, NDArray]] = deque(maxlen=legs.loop + 1)
        self._acting = Acting(profile, form)
        # (j,) [s] mean of what is left of the burn 0, 1, 2, ... steps after the ABORT was sent
        last = len(profile.waiting) + profile.burn_steps
        burning = np.array([profile.burning(after) for after in range(last)] + [0.0])
        self._burn_left = burning[::-1].cumsum()[::-1] * run.step_s

    @property
    def abort_step(self) -> int | None:
        """Step in which the first ABORT was sent; None before."""
        return self._acting.abort_step

    def sent(self, step: int, command: Sequence[float], is_abort: bool) -> None:
        """Take a command that was sent in `step`."""
        self._acting.sent(step, is_abort)
        if self.abort_step is None or step <= self.abort_step:
            self._sent.append((step, self._form.effect(np.asarray(command))))

    def ahead(self, state: NDArray, begin: int, end: int) -> list[list[float]]:
        """
        Return rows (x, y, z) [m] of the way from `state` (6,) at step `begin` to step `end`.

        Begin and end are left out.
        """
        in_flight = {step + self._forward: accel for step, accel in self._sent}
        every, rows = max(1, round(POINT_S / self._step_s)), []
        for step in range(begin, end - 1):
            accel = self._acting.mean(step, in_flight.get(step, np.zeros(3)))
            state = cw.step(state, accel, self._phi, self._gamma)
            if (step + 1 - begin) % every == 0:
                rows.append(state[:3].round(3).tolist())
        return rows

    def push(self, step: int, times: NDArray) -> NDArray:
        """
        Return what the rest of the burn adds to an unpowered drift, rows (x, y, z) [m].

        Parameters
        ----------
        step : int
            In which the drift begins.
        times : ndarray, shape (T,)
            Instants after that [s].
        """
        after = max(step - self.abort_step, 0)
        left = self._burn_left[min(after, len(self._burn_left) - 1)]
        since = np.maximum(times - left, 0.0)
        during = cw.input_matrix(self._n, times) - cw.input_matrix(self._n, since)
        return np.stack([during[:, i, 0]*self._retreat[0] + during[:, i, 1]*self._retreat[1]
                         + during[:, i, 2]*self._retreat[2] for i in range(3)], axis=-1)
