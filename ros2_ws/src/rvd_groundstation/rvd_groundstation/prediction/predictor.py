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
Lost    what commands in flight count for, and what they add to the covariances: `in_flight`.
Late    a command of ours that comes late counts as the one before until it comes, and as neutral
        `as_sent`; then the model, and the filter over the last LATE_STEPS samples, are as if it
        had been there.
"""

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

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
from rvd_groundstation.prediction.believed import believed
from rvd_groundstation.prediction.filter import FILTERS
from rvd_groundstation.prediction.filter_params import FilterParams
from rvd_groundstation.prediction.in_flight import IN_FLIGHT, Loss, reach, thrust_noise

Array = NDArray[np.float64]
FAR = 1e8                               # [m, m/s] beyond which a state is none of an approach
LATE_STEPS = 200                        # samples over which a late command is made up for


@settings
class PredictorParams:
    """Settings of the predictor; the YAML keys are these names."""

    prediction: bool = param(
        True, 'Predict over the loop; without, the newest sample is shown and used as it came.')
    in_flight: str = param(
        'expected', 'What commands in flight count for: their mean, by the probability that they '
        'get lost, or what was sent, as in the paper.', choices=IN_FLIGHT)
    filter: str = param('learned', 'Filter of the telemetry.', choices=FILTERS)
    prior: str = param(
        'scatter', 'What is known of the start: the scatter of the scenario, or the deviations '
        'that are set for the filter.', choices=('scatter', 'kalman'))
    loss_probability: float = param(
        -1.0, 'Probability that a command gets lost; -1 begins with that of the link as it is set, '
        'and learns from the acknowledgements.', low=-1.0, high=1.0)
    use_acknowledgements: bool = param(
        True, 'Use what telemetry tells of commands: which ones have acted, and how many do.')
    kalman: FilterParams = param(
        FilterParams, 'Process and measurement noise assumed by the filter.')
    predictor_bias: float = param(
        1.0, 'Thrust acceleration that the predictor takes a command for, as a multiple of that of '
        'its levels.', low=0.7, high=1.3)

    @property
    def learns_loss(self) -> bool:
        """Whether the probability follows the acknowledgements; one that is given stays."""
        return self.use_acknowledgements and self.loss_probability < 0.0

    def loss(self, link: AbortProfile | None) -> float:
        """Return the probability that a command gets lost; on a link that is not given, 0."""
        if self.loss_probability >= 0.0:
            return self.loss_probability
        return 0.0 if link is None else 1.0 - link.reaching

    def beginning_with(self, scatter: ArrayLike) -> 'PredictorParams':
        """Return these settings for a start that scatters by these deviations (6,)."""
        position, velocity = np.reshape(np.asarray(scatter, dtype=float), (2, 3)).tolist()
        return replace(self, kalman=replace(
            self.kalman, start_position_sigma_m=tuple(position),
            start_velocity_sigma_m_s=tuple(velocity)))


class Prediction(NamedTuple):
    """What the ground knows in one step; NaN in rows that are not valid."""

    estimate: Array                     # (..., 6)    state at k - back_steps
    estimate_covariance: Array | None   # (..., 6, 6) of it; None when not tracked
    predicted: Array                    # (..., 6)    state at k + forward_steps
    covariance: Array | None            # (..., 6, 6) of it, no command lost on the way
    valid: NDArray[np.bool_]            # (...)       some telemetry has been received, and what is
                                        #             made of it is finite and no larger than FAR


@dataclass
class _Sample:
    """What the filter is given of one sample, and what it was before (`before`)."""

    m: int
    own: Array                          # (..., 3) our command that was due in the step before
    measured: Array
    received: NDArray
    acted: NDArray                      # whether that acted, in the rows that were told
    told: NDArray
    lost: Array | None = None           # how probable that was, as was known then
    before: Any = None


class Predictor:
    """
    Filter, open-loop model and correction; called once per step, in order.

    The covariance depends on which samples were lost, so each row needs its own. A node, which has
    one row, tracks it; a campaign does not, and its states are the same to the last bit.
    """

    def __init__(self, params: PredictorParams, run: Run, legs: Legs, orbit: OrbitParams,
                 start: StartParams, form: CommandForm, batch: tuple = (),
                 track: bool = True, abort: AbortProfile | None = None,
                 scatter: ArrayLike | None = None) -> None:
        """
        Start at the nominal state; `batch` is the shape of the leading axes.

        Without an `abort`, what is sent as an ABORT counts as any other command, and where no
        probability of loss is set, none gets lost. `scatter` are the standard deviations of the
        start (6,) [m, m/s], if they are known.
        """
        n, dt = orbit.mean_motion, run.step_s
        form = believed(form, params.predictor_bias)
        self._run, self._legs, self._form, self._batch = run, legs, form, batch
        self._back = legs.back
        self._neutral = form.effect(np.broadcast_to(form.neutral, (*batch, len(form.neutral))))
        self._retreat = form.effect(np.asarray(form.retreat))
        self._abort, self._abort_step = abort, None     # the step of the first ABORT sent
        self._spread: Array | None = None       # (h, ..., 6) of the estimate, by arrival
        self._phi, self._gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
        loop = legs.loop
        self._phi_loop = cw.transition(n, loop * dt)
        self._kalman, self._learns = params.kalman, params.filter == 'learned'
        self._process_loop = _accumulated(self._process(), self._phi, loop)
        if scatter is not None and params.prior == 'scatter':
            params = params.beginning_with(scatter)
        self._filter = FILTERS[params.filter](params.kalman, run, orbit, start, batch, track)
        self.loss = Loss(params.loss(abort), params.learns_loss, batch)
        self._reach = reach(self._phi, self._gamma, loop)
        self._in_flight = IN_FLIGHT[params.in_flight](self.loss, self._phi, self._gamma, loop,
                                                      batch)
        self._uses_told = params.use_acknowledgements
        self._stands_in = params.in_flight == 'expected'
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
        self._lost = deque([self.loss.probability] * (loop + 1), maxlen=loop + 1)   # when sent
        # what the filter was given, for commands that come late: to a single run alone
        self._past: deque[_Sample] = deque(maxlen=0 if batch else LATE_STEPS)

    def advance(self, step: int, measured: ArrayLike | None, received: ArrayLike,
                sent: ArrayLike | None, abort: bool = False,
                late: Mapping[int, tuple[ArrayLike, bool]] | None = None,
                acted: ArrayLike | None = None) -> Prediction:
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
        acted : array_like of bool, shape (...), or None
            Whether the command that was due in the step before the sample's has acted, in the
            rows whose sample came; None where telemetry does not tell.

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
            sample = _Sample(m, self._own[0], measured, received, *self._told(m, received, acted))
            self.loss.hear(sample.acted, sample.told)
            sample.lost = self.loss.probability
            self._take(sample)
            if self._track:
                self._follow(m)
            self._valid = self._valid | self._filter.gate.taken     # outliers apart
        return self._predict()

    def news(self) -> News:
        """Return whether the filter of any row has begun anew in the last step."""
        return [begun_anew('telemetry', self._patience)] if self._filter.gate.anew.any() else []

    def _told(self, m: int, received: NDArray, acted: ArrayLike | None
              ) -> tuple[NDArray, NDArray]:
        """Return whether the command acted that was due before sample m, and where that is told."""
        due = m - self._legs.forward                # number of its frame
        if acted is None or due <= 0 or not self._uses_told or (
                self._abort_step is not None and m - 1 >= self._abort_step):
            return tuple(np.zeros((2, *self._batch), dtype=bool))
        return np.broadcast_to(acted, self._batch), received

    def _take(self, sample: '_Sample') -> None:
        """Hand a sample to the filter, and keep it for commands that come late."""
        if self._past.maxlen:
            sample.before = self._filter.state()
            self._past.append(sample)
        counted = self._acting(sample.m - 1, sample.own, sample.lost)
        accel, spread = self._in_flight.past(counted, sample.own, sample.acted, sample.told,
                                             sample.lost)
        self._filter.advance(sample.m, accel, sample.measured, sample.received, spread)

    def _follow(self, m: int) -> None:
        """Carry what the filter leaves out over sample m."""
        gain, taken = self._filter.gain(m), self._filter.gate.taken
        self._in_flight.updated(self._own[0], gain, taken)
        if self._spread is not None:
            ahead = cw.step(self._spread, self._differences(0), self._phi, self._gamma)
            left = ahead - (gain @ ahead[..., None])[..., 0]
            self._spread = np.where(taken[..., None], left, ahead)

    # -- what acts --------------------------------------------------------------------------

    def _remember(self, emitted: int, sent: ArrayLike | None, abort: bool) -> None:
        """Move the open-loop model on by the command of the last step."""
        own = self._instead() if sent is None else self._form.effect(sent)
        if abort:
            self._learn_of_abort(emitted)
        self._own.append(own)
        self._lost.append(self.loss.probability)
        self._sent.append(self._acting(emitted + self._legs.forward, own, self._lost[-1]))
        self._model.append(cw.step(self._model[-1], self._sent[-1], self._phi, self._gamma))
        if abort and self._abort_step == emitted:
            self._act_again()

    def _instead(self) -> Array:
        """Return what counts for a command of ours that has not come yet."""
        return self._own[-1] if self._stands_in else self._neutral

    def _acting(self, step: int, own: Array, lost: Array) -> Array:
        """Return what counts for the acceleration in `step`, for which we have sent `own`."""
        own = self._in_flight.mean(own, lost)
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
        for i, (own, lost) in enumerate(zip(self._own, self._lost, strict=True)):
            self._sent[i] = self._acting(first + i, own, lost)
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
            self._filter_again(-i, own)
        self._act_again()

    def _filter_again(self, samples: int, own: Array) -> None:
        """Run the filter again over the last samples: `own` had acted just before the first."""
        if samples > len(self._past):
            return                                          # forgotten: telemetry has shown it
        again = [self._past.pop() for _ in range(samples)][::-1]
        again[0].own = own
        self._filter.restore(again[0].before)
        for sample in again:
            self._take(sample)

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
        p_loop = self._phi_loop @ p @ self._phi_loop.T
        if not self._learns:
            p_loop = p_loop + self._process_loop
        flying = np.array(self._own)[1:]
        p = p + self._in_flight.estimate_scatter()
        p_loop = p_loop + self._in_flight.scatter(flying)
        if self._learns:
            p_loop = (p_loop + self._filter.unknown[..., None, None]*self._process_loop
                      + thrust_noise(self._reach, np.array(self._sent)[1:],
                                     self._kalman.execution_fraction))
        if self._spread is not None:
            ahead = self._spread
            for i in range(1, len(self._own)):
                ahead = cw.step(ahead, self._differences(i), self._phi, self._gamma)
            p, p_loop = p + self._scatter(self._spread), p_loop + self._scatter(ahead)
        known = valid[..., None, None]
        return np.where(known, p, np.nan), np.where(known, p_loop, np.nan)

    def _process(self) -> Array:
        """Return the process noise (6, 6) of a step, but for what depends on the commands."""
        if self._learns:                    # of an acceleration of 1 m/s^2, which the filter scales
            return self._gamma @ self._gamma.T
        return self._kalman.process_covariance(self._gamma, self._run.step_s)

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
