"""
The judge: did the chaser arrive, along which corridor, at what cost? From the truth alone.

Source  Yu, Yang 1998: the approach ends at a range, 50 m, where the closing speed is near zero; the
        direction then lies in the approach corridor, which is judged over the last orbit. The
        combined mode holds the range and flies around to the direction wanted.
"""

from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_groundstation.guidance.range_rate import line_of_sight, wrap
from rvd_missions.elliptic_rendezvous.end import range_of
from rvd_missions.elliptic_rendezvous.laws import Rrca
from rvd_missions.elliptic_rendezvous.settings import ArrivalParams, StartParams

BINS = 64                       # of an orbit, in which extremes of the direction are kept
# Of several reasons the first that holds is given.
REASONS = np.array(['', 'arrived', 'held', 'invalid', 'lost', 'drifted', 'unsettled', 'timeout'])


class Judge:
    """Follows the truth of one run, or of a batch of runs, step by step."""

    reasons = {
        'arrived': 'arrived at the range where the approach ends',
        'held': 'held the range and settled at the direction wanted',
        'lost': 'went away from the target',
        'drifted': 'did not hold the range',
        'unsettled': 'did not settle at the direction wanted',
        'timeout': 'did not arrive in time',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, orbit: EllipseParams, start: StartParams, arrival: ArrivalParams,
                 law: Rrca, batch: tuple = ()) -> None:
        around = law.flies_around
        tolerance, off = arrival.hold_tolerance_m, arrival.direction_tolerance_deg
        self.measures = (
            Measure('arrival_s', 's', 'time of the arrival', digits=0),
            Measure('arrival_orbits', '', 'orbits to the arrival', digits=3),
            Measure('arrival_rate_m_s', 'm/s', 'range rate at the arrival', digits=4),
            Measure('direction_low_deg', 'deg', 'least direction in the last orbit before the '
                    'arrival', digits=2),
            Measure('direction_high_deg', 'deg', 'greatest direction in the last orbit before '
                    'the arrival', digits=2),
            Measure('delta_v_m_s', 'm/s', 'delta-v', digits=2),
            Measure('along_delta_v_m_s', 'm/s', 'delta-v along the line of sight', digits=2),
            Measure('across_delta_v_m_s', 'm/s', 'delta-v across the line of sight', digits=2),
            Measure('peak_acceleration_m_s2', 'm/s^2', 'greatest acceleration', digits=4),
            *((Measure('hold_error_m', 'm', 'greatest error of the held range', high=tolerance),
               Measure('settling_s', 's', 'settling of the direction after the arrival', digits=0),
               Measure('final_direction_error_deg', 'deg', 'direction error at the end',
                       high=off, digits=4),
               Measure('around_delta_v_m_s', 'm/s', 'delta-v across, after the arrival'))
              if around else ()))
        self._step_s, self._orbit, self._batch, self._around = run.step_s, orbit, batch, around
        self._arrival, self._lost_range = arrival, arrival.lost_range_factor*start.range_m
        # the combined mode comes to rest at the range, which it may never cross
        self._reached_m = arrival.range_m + (tolerance/2.0 if around else 0.0)
        self._phi_d = np.radians(law.fly_around.phi_d_deg) if around else 0.0
        self._ended, self._near = np.zeros((2, *batch), dtype=bool)
        self._reason, self._duration = np.zeros(batch, dtype=int), np.zeros(batch)
        self._values = {m.name: np.full(batch, np.nan) for m in self.measures}
        for name in self._values:
            if 'delta_v' in name or name.startswith(('peak', 'hold')):
                self._values[name] = np.zeros(batch)
        self._low, self._high = np.full((BINS, *batch), np.inf), np.full((BINS, *batch), -np.inf)
        self._bin = -1
        self._drifted_at = np.full(batch, np.nan)   # [s] when the range was not held first
        self._state: NDArray | None = None
        self._direction = np.zeros(batch)           # counted on over turns [rad]

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live, t = ~self._ended, k*self._step_s
        los = line_of_sight(truth.state)
        if k > 0:
            self._count(live, truth.acceleration)
            self._direction = self._direction + wrap(los.direction - self._direction)
        else:
            self._direction = los.direction
        self._state = truth.state
        self._duration = np.where(live, t, self._duration)
        arriving = live & ~self._near & (los.range <= self._reached_m)
        self._keep_direction(self._orbit.at(t).anomaly, live & ~self._near)
        if arriving.any():
            self._arrive(arriving, t, los)
        if self._around:
            self._hold(live & self._near, t, los)
        if np.any(truth.final):
            self._reason = np.where(live & truth.final, self._why(truth.state), self._reason)
        self._ended = self._ended | truth.final

    def _count(self, live: NDArray, accel: NDArray) -> None:
        """Add up the delta-v of the step just made, along and across its first line of sight."""
        phi = line_of_sight(self._state).direction
        s, side = np.sin(phi), np.cos(phi)
        along = accel[..., 0]*s + accel[..., 1]*side
        across = accel[..., 0]*side - accel[..., 1]*s
        size = np.sqrt(along*along + across*across + accel[..., 2]*accel[..., 2])
        spent = {'delta_v_m_s': size, 'along_delta_v_m_s': np.abs(along),
                 'across_delta_v_m_s': np.abs(across)}
        if self._around:
            spent['around_delta_v_m_s'] = np.where(self._near, np.abs(across), 0.0)
        for name, rate in spent.items():
            self._values[name] = self._values[name] + np.where(live, rate*self._step_s, 0.0)
        peak = self._values['peak_acceleration_m_s2']
        self._values['peak_acceleration_m_s2'] = np.where(live, np.fmax(peak, size), peak)

    def _keep_direction(self, anomaly: float, live: NDArray) -> None:
        """Keep the extremes of the direction over the last orbit, in bins of it."""
        number = int(anomaly/(2.0*pi)*BINS)
        at = number % BINS
        if number != self._bin:
            self._low[at] = np.where(live, np.inf, self._low[at])
            self._high[at] = np.where(live, -np.inf, self._high[at])
            self._bin = number
        self._low[at] = np.where(live, np.fmin(self._low[at], self._direction), self._low[at])
        self._high[at] = np.where(live, np.fmax(self._high[at], self._direction), self._high[at])

    def _arrive(self, now: NDArray, t: float, los: Any) -> None:
        turns = 2.0*pi*np.floor(self._low.min(axis=0)/(2.0*pi) + 0.5)    # from the least one
        orbits = (self._orbit.at(t).anomaly - self._orbit.at(0.0).anomaly)/(2.0*pi)
        found = {'arrival_s': t, 'arrival_orbits': orbits, 'arrival_rate_m_s': los.range_rate,
                 'direction_low_deg': np.degrees(self._low.min(axis=0) - turns),
                 'direction_high_deg': np.degrees(self._high.max(axis=0) - turns)}
        for name, value in found.items():
            self._values[name] = np.where(now, value, self._values[name])
        self._near = self._near | now

    def _hold(self, now: NDArray, t: float, los: Any) -> None:
        off = np.degrees(np.abs(wrap(los.direction - self._phi_d)))
        values = self._values
        error = np.abs(los.range - self._arrival.range_m)
        off_range = now & ~(error < self._arrival.hold_tolerance_m)
        self._drifted_at = np.where(off_range, np.fmin(self._drifted_at, t), self._drifted_at)
        settling = np.where(off > self._arrival.direction_tolerance_deg, t - values['arrival_s'],
                            np.fmax(values['settling_s'], 0.0))
        found = {'hold_error_m': np.fmax(values['hold_error_m'], error), 'settling_s': settling,
                 'final_direction_error_deg': off}
        for name, value in found.items():
            values[name] = np.where(now, value, values[name])

    def _why(self, state: NDArray) -> NDArray:
        """Return the number of the reason for which runs would end here."""
        def code(name: str) -> int:
            return int(np.flatnonzero(REASONS == name)[0])
        why = np.where(self._near, code('arrived'), code('timeout'))
        if self._around:
            values, limits = self._values, self._arrival
            settled = values['final_direction_error_deg'] < limits.direction_tolerance_deg
            held = values['hold_error_m'] < limits.hold_tolerance_m
            why = np.where(self._near, np.where(held, np.where(
                settled, code('held'), code('unsettled')), code('drifted')), why)
        why = np.where(range_of(state) < self._lost_range, why, code('lost'))
        return np.where(np.isfinite(state).all(axis=-1), why, code('invalid'))

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has timed out."""
        reason = REASONS[self._reason]
        reason = np.where((reason == '') & final, 'timeout', reason)
        success = (reason == 'arrived') | (reason == 'held')
        return Verdict(success, reason, self._duration, dict(self._values),
                       np.where(reason == 'drifted', self._drifted_at, np.nan))
