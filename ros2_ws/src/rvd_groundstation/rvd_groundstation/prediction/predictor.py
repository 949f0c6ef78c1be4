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
ABORT   from the first ABORT sent on, what acts is the mean over the steps at which one may come
        into force (`abort`): commands in flight until then, the burn, the coast. The covariances
        get what these possibilities differ by.
Late    a command of ours that comes late counts as neutral until it comes; then the model, and
        the filter over the last LATE_STEPS samples, are as if it had been there.
"""

from collections import deque
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.news import begun_anew, News
from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.commands.form import CommandForm
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_groundstation.prediction.filter import FilterParams, FILTERS

Array = NDArray[np.float64]
FAR = 1e8                               # [m, m/s] beyond which a state is none of an approach
LATE_STEPS = 200                        # samples over which a late command is made up for


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
    valid: NDArray[np.bool_]            # (...)       some telemetry has been received, and what is
                                        #             made of it is finite and no larger than FAR


class Predictor:
    """
    Filter, open-loop model and correction; called once per step, in order.

    The covariance depends on which samples were lost, so each row needs its own. A node, which has
    one row, tracks it; a campaign does not, and its states are the same to the last bit.
    """

    def __init__(self, params: PredictorParams, run: Run, legs: Legs, orbit: OrbitParams,
                 start: StartParams, form: CommandForm, batch: tuple = (),
                 track: bool = True, abort: AbortProfile | None = None) -> None:
        """
        Start at the nominal state; `batch` is the shape of the leading axes.

        Without an `abort`, what is sent as an ABORT counts as any other command.
        """
        n, dt = orbit.mean_motion, run.step_s
        self._legs, self._form, self._batch = legs, form, batch
        self._back = legs.back
        self._neutral = form.effect(np.broadcast_to(form.neutral, (*batch, len(form.neutral))))
        self._retreat = form.effect(np.asarray(form.retreat))
        self._abort, self._abort_step = abort, None     # the step of the first ABORT sent
        self._spread: Array | None = None       # (h, ..., 6) of the estimate, by arrival
        self._phi, self._gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
        loop = legs.loop
        self._phi_loop = cw.transition(n, loop * dt)
        self._process_loop = _accumulated(
            params.kalman.process_covariance(self._gamma, dt), self._phi, loop)
        self._filter = FILTERS[params.filter](params.kalman, run, orbit, start, batch, track)
        self._track, self._patience = track, params.kalman.gate_patience
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
        self._own = deque(self._sent, maxlen=loop + 1)      # the same, but for an ABORT
        self._updates: deque = deque(maxlen=LATE_STEPS)     # (gain, received) of each sample

    def advance(self, step: int, measured: ArrayLike | None, received: ArrayLike,
                sent: ArrayLike | None, abort: bool = False,
                late: Mapping[int, tuple[ArrayLike, bool]] | None = None) -> Prediction:
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
        abort : bool
            Whether it was an ABORT, in all rows.
        late : mapping of int to (sent, abort)
            Commands of steps before that one, which were None when they were due.

        Returns
        -------
        Prediction

        Raises
        ------
        ValueError
            If a step was left out or repeated.
        """
        if step != self._next_step:
            raise BadInput(f'step must be {self._next_step}, got {step}')
        self._next_step += 1
        if step > 0:
            self._remember(step - 1, sent, abort)
        for emitted, (command, was_abort) in (late or {}).items():
            self._make_up_for(emitted, command, was_abort)
        m = step - self._back
        if m >= 0:
            measured, received = self._sample(measured, received)
            self._filter.advance(m, self._sent[0], measured, received)
            received = self._filter.gate.taken          # outliers apart
            self._updates.append((self._filter.gain(m), received))
            if self._spread is not None:
                self._spread = self._updated(cw.step(
                    self._spread, self._differences(0), self._phi, self._gamma),
                    *self._updates[-1])
            self._valid = self._valid | received
        return self._predict()

    def news(self) -> News:
        """Return whether the filter of any row has begun anew in the last step."""
        return [begun_anew('telemetry', self._patience)] if self._filter.gate.anew.any() else []

    # -- what acts --------------------------------------------------------------------------

    def _remember(self, emitted: int, sent: ArrayLike | None, abort: bool) -> None:
        """Move the open-loop model on by the command of the last step."""
        own = self._neutral if sent is None else self._form.effect(sent)
        if abort:
            self._learn_of_abort(emitted)
        self._own.append(own)
        self._sent.append(self._acting(emitted + self._legs.forward, own))
        self._model.append(cw.step(self._model[-1], self._sent[-1], self._phi, self._gamma))
        if abort and self._abort_step == emitted:
            self._act_again()

    def _acting(self, step: int, own: Array) -> Array:
        """Return the mean acceleration in `step`, for which we have sent `own`."""
        if self._abort_step is None:
            return own
        after = step - self._abort_step
        return (self._abort.still_waiting(after) * own
                + self._abort.burning(after) * self._retreat)

    def _learn_of_abort(self, emitted: int) -> None:
        if self._abort is None or (self._abort_step is not None and self._abort_step <= emitted):
            return
        self._abort_step = emitted
        self._filter.stand_still(emitted)
        if self._track:
            arrivals = len(self._abort.arrivals[0])
            self._spread = np.zeros((arrivals, *self._batch, 6))

    def _act_again(self) -> None:
        """Run the model again from its oldest state, by what is known now."""
        first = self._next_step - 1 - self._back - 1        # the step in which _own[0] acted
        for i, own in enumerate(self._own):
            self._sent[i] = self._acting(first + i, own)
            if i:
                self._model[i] = cw.step(self._model[i - 1], self._sent[i], self._phi, self._gamma)

    def _make_up_for(self, emitted: int, sent: ArrayLike, abort: bool) -> None:
        """Put in a command of ours that comes late, wherever it has acted since."""
        if abort:
            self._learn_of_abort(emitted)
        own = self._form.effect(sent)
        acts = emitted + self._legs.forward
        m = self._next_step - 1 - self._back                # the sample that comes next
        i = acts + 1 - m                                    # place in _own
        if i >= 0:
            self._own[i] = own
        else:
            self._shift_estimate(-i, self._acting(acts, own) - self._acting(acts, self._neutral))
        self._act_again()

    def _shift_estimate(self, samples: int, accel: Array) -> None:
        """Move the estimate by an acceleration that acted just before the last `samples` ones."""
        if samples > len(self._updates):
            return                                          # forgotten: telemetry has shown it
        moved = cw.step(np.zeros((*self._batch, 6)), accel, self._phi, self._gamma)
        for n, update in enumerate(list(self._updates)[-samples:]):
            moved = self._updated(cw.product(self._phi, moved) if n else moved, *update)
        self._filter.shift(moved)

    def _updated(self, difference: Array, gain: Array, received: NDArray) -> Array:
        """Return what a sample leaves of a difference (..., 6) of the estimate."""
        kept = difference - (gain @ difference[..., None])[..., 0]
        return np.where(received[..., None], kept, difference)

    def _differences(self, i: int) -> Array:
        """
        Return by how much what acts at place i of `_own` may differ from the mean, (h, ..., 3).
        """
        after = self._next_step - 2 - self._back + i - self._abort_step
        arrivals = self._abort.arrivals[0].reshape(-1, *[1] * (len(self._batch) + 1))
        burning = (arrivals <= after) & (after < arrivals + self._abort.burn_steps)
        acts = np.where(after < arrivals, self._own[i],
                        np.where(burning, self._retreat, self._neutral))
        return acts - self._sent[i]

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
        valid, fits = self._valid, np.abs(predicted) <= FAR     # NaN does not
        if not fits.all():
            valid = valid & fits.all(axis=-1)
        if not valid.all():
            known = valid[..., None]
            estimate, predicted = (np.where(known, s, np.nan) for s in (estimate, predicted))
        p, p_loop = self._covariances(valid)
        return Prediction(estimate, p, predicted, p_loop, valid)

    def _covariances(self, valid: NDArray) -> tuple[Array | None, Array | None]:
        if not self._track:
            return None, None
        p = self._filter.covariance
        p_loop = self._phi_loop @ p @ self._phi_loop.T + self._process_loop
        if self._spread is not None:
            ahead = self._spread
            for i in range(1, len(self._own)):
                ahead = cw.step(ahead, self._differences(i), self._phi, self._gamma)
            p, p_loop = p + self._scatter(self._spread), p_loop + self._scatter(ahead)
        known = valid[..., None, None]
        return np.where(known, p, np.nan), np.where(known, p_loop, np.nan)

    def _scatter(self, differences: Array) -> Array:
        """Return the covariance (..., 6, 6) of differences (h, ..., 6) by arrival of an ABORT."""
        weight = self._abort.arrivals[1].reshape(-1, *[1] * (len(self._batch) + 2))
        return (weight * differences[..., :, None] * differences[..., None, :]).sum(axis=0)


def _accumulated(process: Array, phi: Array, steps: int) -> Array:
    """Return the process noise accumulated over `steps` steps: sum of Phi^i Q Phi^i'."""
    total = np.zeros((6, 6))
    for _ in range(steps):
        total = phi @ total @ phi.T + process
    return total
