"""
Prediction of the state at the instant at which a command sent now will act.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Steps   at step k the telemetry is that of step m = k - back_steps and a command sent now acts
        on step k + forward_steps; the loop delay between them is n = forward_steps + back_steps.
Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, eq. 7 and 8:
        dX_p(k + nf) = Phi^n (X^(m) - X_p(m)),   X~_p(k + nf) = X_p(k + nf) + dX_p(k + nf),
        where X^ is the filtered telemetry and X_p the open-loop model, driven by the commands
        sent. For the linear model this equals X^ propagated over the loop with the commands in
        flight. X_p is never overwritten by X~_p: a correction fed back would be counted again
        in each of the n steps until telemetry shows it.
"""

from collections import deque
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.commands.form import CommandForm
from rvd_groundstation.prediction.filter import FilterParams, FILTERS

Array = NDArray[np.float64]


@settings
class PredictorParams:
    """Settings of the predictor; the YAML keys are these names."""

    filter: str = param('scheduled', 'Filter of the telemetry.', choices=FILTERS)
    kalman: FilterParams = param(
        FilterParams, 'Process and measurement noise assumed by the filter.')


class Prediction(NamedTuple):
    """What the ground knows in one step; NaN in rows that are not valid."""

    estimate: Array                     # (..., 6)    state at k - back_steps
    estimate_covariance: Array | None   # (..., 6, 6) of it; None when not tracked
    predicted: Array                    # (..., 6)    state at k + forward_steps
    covariance: Array | None            # (..., 6, 6) of it, no command lost on the way
    valid: NDArray[np.bool_]            # (...)       some telemetry has been received


class Predictor:
    """
    Filter, open-loop model and correction; called once per step, in order.

    The covariance depends on which samples were lost, so each row needs its own. A node, which has
    one row, tracks it; a campaign does not, and its states are the same to the last bit.
    """

    def __init__(self, params: PredictorParams, run: Run, legs: Legs, orbit: OrbitParams,
                 start: StartParams, form: CommandForm, batch: tuple = (),
                 track: bool = True) -> None:
        """Start at the nominal state; `batch` is the shape of the leading axes."""
        n, dt = orbit.mean_motion, run.step_s
        self._back, self._form, self._batch = legs.back, form, batch
        self._phi, self._gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
        loop = legs.loop
        self._phi_loop = cw.transition(n, loop * dt)
        self._process_loop = _accumulated(
            params.kalman.process_covariance(self._gamma, dt), self._phi, loop)
        self._filter = FILTERS[params.filter](params.kalman, run, orbit, start, batch, track)
        self._track = track
        self._valid = np.zeros(batch, dtype=bool)
        self._next_step = 0
        # [-1] is the newest: the model at k + forward_steps, the command sent at k - 1; [0] is
        # the oldest still needed: the model at m, the command that acted on [m-1, m).
        self._model = deque([self._filter.estimate], maxlen=loop + 1)
        for _ in range(legs.forward):
            self._model.append(cw.step(self._model[-1], np.zeros((*batch, 3)),
                                       self._phi, self._gamma))
        while len(self._model) < loop + 1:              # before the start: never compared
            self._model.appendleft(self._model[0])
        self._sent = deque([np.zeros((*batch, 3))] * (loop + 1), maxlen=loop + 1)

    def advance(self, step: int, measured: ArrayLike | None, received: ArrayLike,
                sent: ArrayLike | None) -> Prediction:
        """
        Process what arrived in this step, and predict.

        Parameters
        ----------
        step : int
            0, 1, 2, ... in order.
        measured : array_like, shape (..., 6), or None
            Sample of step - back_steps; a row that is not finite counts as not received.
        received : array_like of bool, shape (...)
            Rows whose sample came.
        sent : array_like, shape (..., n), or None
            Command emitted at step - 1; None when there was none.

        Returns
        -------
        Prediction

        Raises
        ------
        ValueError
            If a step was left out or repeated.
        """
        if step != self._next_step:
            raise ValueError(f'step must be {self._next_step}, got {step}')
        self._next_step += 1
        if step > 0:
            self._remember(sent)
        m = step - self._back
        if m >= 0:
            measured, received = self._sample(measured, received)
            self._filter.advance(m, self._sent[0], measured, received)
            self._valid = self._valid | received
        return self._predict()

    def _remember(self, sent: ArrayLike | None) -> None:
        """Move the open-loop model on by the command of the last step."""
        if sent is None:
            sent = np.broadcast_to(self._form.neutral, (*self._batch, len(self._form.neutral)))
        self._sent.append(self._form.effect(sent))
        self._model.append(cw.step(self._model[-1], self._sent[-1], self._phi, self._gamma))

    def _sample(self, measured: ArrayLike | None, received: ArrayLike) -> tuple[Array, NDArray]:
        """Return the sample, and the rows in which it has arrived and is finite."""
        if measured is None:
            return np.full((*self._batch, 6), np.nan), np.zeros(self._batch, dtype=bool)
        measured = np.asarray(measured, dtype=float)
        return measured, np.asarray(received, dtype=bool) & np.isfinite(measured).all(axis=-1)

    def _predict(self) -> Prediction:
        estimate = self._filter.estimate
        correction = cw.product(self._phi_loop, estimate - self._model[0])      # (7)
        predicted = self._model[-1] + correction                                # (8)
        if not self._valid.all():
            known = self._valid[..., None]
            estimate, predicted = (np.where(known, s, np.nan) for s in (estimate, predicted))
        p, p_loop = self._covariances()
        return Prediction(estimate, p, predicted, p_loop, self._valid)

    def _covariances(self) -> tuple[Array | None, Array | None]:
        if not self._track:
            return None, None
        p = self._filter.covariance
        p_loop = self._phi_loop @ p @ self._phi_loop.T + self._process_loop
        known = self._valid[..., None, None]
        return np.where(known, p, np.nan), np.where(known, p_loop, np.nan)


def _accumulated(process: Array, phi: Array, steps: int) -> Array:
    """Return the process noise accumulated over `steps` steps: sum of Phi^i Q Phi^i'."""
    total = np.zeros((6, 6))
    for _ in range(steps):
        total = phi @ total @ phi.T + process
    return total
