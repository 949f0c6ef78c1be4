"""
The judge: did the gripper arrive, how exactly, in view of the target, at what cost? From the truth.

Only the defect of the plan comes from elsewhere: it is the plan's own.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_missions.tether import geometry
from rvd_missions.tether.end import collided, lost
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.settings import ApproachParams, ArrivalParams, TetherParams

MAX_DEFECT = 1e-8
SLACK_N = 1e-9                          # a tether without this tension is slack


class Judge:
    """Follows the truth of one run, or of a batch of runs, step by step."""

    reasons = {
        'arrived': 'arrived before the target',
        'missed': 'ended away from the planned place or attitude',
        'blind': 'lost the target out of the field of view',
        'collided': 'collided with the target',
        'lost': 'went away',
        'timeout': 'ended before the plan did',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, tether: TetherParams, approach: ApproachParams,
                 arrival: ArrivalParams, preparation: Preparation, batch: tuple = ()) -> None:
        far, cross = arrival.range_tolerance_m, arrival.cross_tolerance_m
        self.measures = (
            Measure('range_error_m', 'm', 'distance to the target at the end, minus the planned '
                    'one', low=-far, high=far, digits=4),
            Measure('cross_error_m', 'm', 'offset across the line of sight at the end', high=cross,
                    digits=5),
            Measure('cross_y_m', 'm', 'that offset to nadir', digits=5),
            Measure('cross_z_m', 'm', 'that offset along the orbit normal', digits=5),
            Measure('closing_speed_m_s', 'm/s', 'speed against the planned one at the end',
                    digits=4),
            Measure('attitude_error_rad', 'rad', 'greatest of roll, pitch and yaw at the end',
                    high=arrival.attitude_tolerance_rad, digits=5),
            Measure('roll_rad', 'rad', 'roll at the end', digits=6),
            Measure('pitch_rad', 'rad', 'pitch at the end', digits=6),
            Measure('yaw_rad', 'rad', 'yaw at the end', digits=6),
            Measure('sight_angle_rad', 'rad', 'greatest angle between boresight and sight',
                    high=approach.view_rad, digits=4),
            Measure('sight_peak_s', 's', 'when it was greatest', digits=1),
            Measure('pitch_peak_rad', 'rad', 'greatest pitch, either way', digits=4),
            Measure('tension_N', 'N', 'least tension commanded', digits=4),
            Measure('slack_s', 's', 'time without tension', high=run.step_s/2, digits=2),
            Measure('fuel_N_s', 'N s', 'impulse of the thrusters', digits=2),
            Measure('tether_N_s', 'N s', 'impulse of the tether', digits=2),
            Measure('plan_defect', '', 'greatest defect of the plan', high=MAX_DEFECT, digits=12))
        self._run, self._approach, self._arrival = run, approach, arrival
        self._preparation, self._last = preparation, preparation.last_step(run)
        self._ended = np.zeros(batch, dtype=bool)
        self._reason = np.full(batch, '', dtype='U8')
        self._duration = np.zeros(batch)
        self._values = {m.name: np.zeros(batch) for m in self.measures}
        self._values['tension_N'] = np.full(batch, np.inf)
        self._before: NDArray | None = None
        self._defect = np.nan
        self._blind_at = np.full(batch, np.nan)         # [s] when the target left the view first

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live, v, h = ~self._ended, self._values, self._run.step_s
        self._duration = np.where(live, k*h, self._duration)
        gamma = geometry.sight_angle(truth.state[..., 6:10], truth.target)
        higher = live & (gamma > v['sight_angle_rad'])
        v['sight_peak_s'] = np.where(higher, k*h, v['sight_peak_s'])
        v['sight_angle_rad'] = np.where(higher, gamma, v['sight_angle_rad'])
        out = live & ~(gamma < self._approach.view_rad)
        self._blind_at = np.where(out, np.fmin(self._blind_at, k*h), self._blind_at)
        angles = geometry.euler(truth.state[..., 6:10])
        pitch = np.abs(angles[..., 1])
        v['pitch_peak_rad'] = np.where(live, np.fmax(v['pitch_peak_rad'], pitch),
                                       v['pitch_peak_rad'])
        if k > 0:
            u = truth.applied
            force = np.abs(u[..., 1]) + np.abs(u[..., 2]) + np.abs(u[..., 3])
            v['tension_N'] = np.where(live, np.fmin(v['tension_N'], u[..., 0]), v['tension_N'])
            for name, part in (('fuel_N_s', force), ('tether_N_s', truth.tension),
                               ('slack_s', truth.tension < SLACK_N)):
                v[name] = v[name] + np.where(live, h*part, 0.0)
        over = live & truth.final
        if np.count_nonzero(over):
            self._defect = self._preparation.report.defect
            self._end(over, truth, angles)
            self._reason = np.where(over, self._why(k, truth), self._reason)
        self._before = truth.target
        self._ended = self._ended | truth.final

    def _end(self, now: NDArray, truth: Any, angles: NDArray) -> None:
        """Note the last state of rows that end."""
        t, before = truth.target, self._before if self._before is not None else truth.target
        slide = (t - before)/self._run.step_s               # the plan ends at rest
        found = {
            'range_error_m': t[..., 0] - self._approach.final_range_m,
            'cross_error_m': np.sqrt(t[..., 1]*t[..., 1] + t[..., 2]*t[..., 2]),
            'cross_y_m': t[..., 1], 'cross_z_m': t[..., 2],
            'closing_speed_m_s': np.sqrt((slide*slide).sum(axis=-1)),
            'attitude_error_rad': np.abs(angles).max(axis=-1),
            'roll_rad': angles[..., 0], 'pitch_rad': angles[..., 1], 'yaw_rad': angles[..., 2]}
        for name, value in found.items():
            self._values[name] = np.where(now, value, self._values[name])

    def _why(self, k: int, truth: Any) -> NDArray:
        """Return the reason for which runs would end here."""
        v, a = self._values, self._arrival
        hit = ((np.abs(v['range_error_m']) < a.range_tolerance_m)
               & (v['cross_error_m'] < a.cross_tolerance_m)
               & (v['attitude_error_rad'] < a.attitude_tolerance_rad))
        why = np.where(hit, 'arrived', 'missed')
        why = np.where(v['sight_angle_rad'] < self._approach.view_rad, why, 'blind')
        why = np.where(k >= self._last, why, 'timeout')
        why = np.where(collided(truth.target, a), 'collided', why)
        why = np.where(lost(truth.state, self._approach, a), 'lost', why)
        return np.where(np.isfinite(truth.state).all(axis=-1), why, 'invalid')

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has timed out."""
        reason = np.where((self._reason == '') & final, 'timeout', self._reason)
        over = reason != ''
        at_end = ('range_error_m', 'cross_error_m', 'cross_y_m', 'cross_z_m', 'closing_speed_m_s',
                  'attitude_error_rad', 'roll_rad', 'pitch_rad', 'yaw_rad')
        values = {name: np.where(over, v, np.nan) if name in at_end else v
                  for name, v in self._values.items()}
        values['plan_defect'] = np.where(over, self._defect, np.nan)
        return Verdict(reason == 'arrived', reason, self._duration, values,
                       np.where(reason == 'blind', self._blind_at, np.nan))
