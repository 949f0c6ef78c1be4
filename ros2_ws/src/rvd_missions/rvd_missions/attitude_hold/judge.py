"""
The judge: was the axis held, how exactly, and how did it come through step and faults?

From the truth alone. The error is the true angle minus the reference of the step.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_missions.attitude_hold.end import ended
from rvd_missions.attitude_hold.settings import Attitude, Faults, first_step, Limits

DEG = float(np.degrees(1.0))                    # [deg/rad]


class Judge:
    """
    Follows the truth of one run, or of a batch of runs, step by step.

    'After' counts from the first of step and faults on, whatever the gains are then, so that runs
    with and without a fault are compared over the same time.
    """

    reasons = {
        'held': 'held',
        'restless': 'error above the limit at the end',
        'lost': 'lost: the error grew out of bounds',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, attitude: Attitude, faults: Faults, limits: Limits,
                 batch: tuple = ()) -> None:
        self.measures = (
            Measure('rms_final_deg', 'deg', 'rms of the error at the end',
                    high=limits.max_rms_deg, digits=5),
            Measure('rms_after_deg', 'deg', 'rms of the error after step and fault', digits=4),
            Measure('overshoot_deg', 'deg', 'overshoot after the step', digits=3),
            Measure('overshoot_first_deg', 'deg', 'overshoot at the start', digits=3),
            Measure('peak_after_deg', 'deg', 'greatest error after step and fault',
                    high=limits.lost_deg, digits=3),
            Measure('settling_s', 's', 'time to settle after the step', digits=1),
            Measure('impulse_N_m_s', 'N m s', 'angular impulse spent after step and fault',
                    digits=3))
        h = self._step_s = run.step_s
        self._attitude, self._limits, self._last_step = attitude, limits, run.last_step
        self._stepped = first_step(attitude.step_at_s, h)
        self._after = min(self._stepped, first_step(faults.first_at_s, h))
        self._window = run.last_step - first_step(limits.window_s, h) + 1
        # Without a step, neither of the reference nor at the start, there is nothing to overshoot.
        self._steps = attitude.reference_deg != 0.0 or self._stepped == 0
        self._live = np.ones(batch, dtype=bool)
        self._reason = np.full(batch, '', dtype='U8')
        self._duration = np.zeros(batch)
        self._sign = np.zeros(batch)                        # of the error when the last step came
        (self._final, self._square, self._over, self._over_first, self._peak, self._impulse
         ) = np.zeros((6, *batch))
        self._out = np.full(batch, -1)                      # last step outside of the settled band

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live = self._live & np.isfinite(truth.state[..., 0])
        offset = truth.state[..., 0] - self._attitude.at(k, self._step_s)
        error = DEG*offset
        size = np.abs(error)
        self._duration = np.where(self._live, k*self._step_s, self._duration)
        if k in (0, self._stepped):
            self._sign = np.sign(error)
        self._grow('_over_first' if k < self._stepped else '_over', live, -self._sign*error)
        if k >= self._stepped:
            self._out = np.where(live & ~(size < self._limits.settled_deg), k, self._out)
        if k >= self._after:
            self._grow('_peak', live, size)
            self._square = self._square + np.where(live, error*error, 0.0)
        if k >= self._window:
            self._final = self._final + np.where(live, error*error, 0.0)
        if k > self._after:                                 # what acted since the step before
            spent = np.abs(truth.torque[..., 0])*self._step_s
            self._impulse = self._impulse + np.where(live, spent, 0.0)
        over = self._live & ended(k, offset, self._limits, self._last_step)
        if np.count_nonzero(over):
            self._reason = np.where(over, self._why(truth.state, offset), self._reason)
            self._live = self._live & ~over

    def _grow(self, name: str, live: NDArray, value: NDArray) -> None:
        old = getattr(self, name)
        setattr(self, name, np.where(live, np.fmax(old, value), old))

    def _why(self, state: NDArray, offset: NDArray) -> NDArray:
        """Return the reason for which runs would end here."""
        rms = np.sqrt(self._final/(self._last_step - self._window + 1))
        why = np.where(rms < self._limits.max_rms_deg, 'held', 'restless')
        why = np.where(np.abs(offset) < np.radians(self._limits.lost_deg), why, 'lost')
        return np.where(np.isfinite(state).all(axis=-1), why, 'invalid')

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way is not held."""
        reason = np.where((self._reason == '') & final, 'restless', self._reason)
        whole = (reason == 'held') | (reason == 'restless')
        last = np.rint(self._duration/self._step_s)
        after = np.maximum(last - self._after + 1, 1)
        known_after, known_step = last >= self._after, last >= self._stepped
        settled = np.where(self._out < 0, self._stepped, self._out + 1)
        values = {
            'rms_final_deg': np.where(whole, np.sqrt(
                self._final/(self._last_step - self._window + 1)), np.nan),
            'rms_after_deg': np.where(known_after, np.sqrt(self._square/after), np.nan),
            'overshoot_deg': np.where(known_step & self._steps, self._over, np.nan),
            'overshoot_first_deg': np.where(self._stepped > 0, self._over_first, np.nan),
            'peak_after_deg': np.where(known_after, self._peak, np.nan),
            'settling_s': np.where(known_step & (settled <= last),
                                   (settled - self._stepped)*self._step_s, np.nan),
            'impulse_N_m_s': np.where(known_after, self._impulse, np.nan)}
        return Verdict(reason == 'held', reason, self._duration, values)
