"""
The judge: did the craft come to rest at the berth without going too far? From the truth alone.
"""

from typing import Any

import numpy as np

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run

from one_axis.berth import Berth


class Judge:
    """Follows the truth of one run, or of a batch of runs, step by step."""

    reasons = {
        'berthed': 'at rest at the berth',
        'overshot': 'went too far beyond the berth',
        'timeout': 'not at rest at the berth in time',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, berth: Berth, batch: tuple = ()) -> None:
        self.measures = (
            Measure('overshoot_m', 'm', 'farthest beyond the berth', high=berth.max_overshoot_m),
            Measure('delta_v_m_s', 'm/s', 'delta-v'))
        self._step_s, self._berth = run.step_s, berth
        self._ended = np.zeros(batch, dtype=bool)
        self._reason = np.full(batch, '', dtype='U8')
        self._duration, self._overshoot, self._delta_v = np.zeros((3, *batch))

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live = ~self._ended
        self._duration = np.where(live, k*self._step_s, self._duration)
        self._overshoot = np.where(live, np.fmax(self._overshoot, truth.state[..., 0]),
                                   self._overshoot)
        if k > 0:
            spent = np.abs(truth.acceleration[..., 0]) * self._step_s
            self._delta_v = np.where(live, self._delta_v + spent, self._delta_v)
        self._reason = np.where(live & truth.final, self._why(truth.state), self._reason)
        self._ended = self._ended | truth.final

    def _why(self, state: np.ndarray) -> np.ndarray:
        """Return the reason for which runs would end here."""
        why = np.where(self._berth.reached(state), 'berthed', 'timeout')
        why = np.where(self._overshoot < self._berth.max_overshoot_m, why, 'overshot')
        return np.where(np.isfinite(state).all(axis=-1), why, 'invalid')

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has timed out."""
        reason = np.where((self._reason == '') & final, 'timeout', self._reason)
        return Verdict(reason == 'berthed', reason, self._duration,
                       {'overshoot_m': self._overshoot, 'delta_v_m_s': self._delta_v})
