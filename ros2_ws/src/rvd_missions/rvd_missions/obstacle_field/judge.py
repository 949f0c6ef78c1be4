"""
The judge: did the chaser arrive without touching anything? From the truth alone.

Propellant, of three independent pairs of thrusters: m (1 - exp(-dv / (Isp g0))), dv the sum over
the axes of |a| dt. Clearance is followed between samples (`geometry.obstacles`).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.obstacles import Closest
from rvd_dynamics.geometry.speed_corridor import SpeedCorridor
from rvd_missions.obstacle_field.end import distance
from rvd_missions.obstacle_field.settings import Craft

G0 = 9.80665                            # [m/s^2] standard gravity
NEAR_M = 10.0                           # [m] where speed is to fall without swinging
TOLERANCE = 1.02                        # of the speed limit, which the law meets in steps
NAN = float('nan')


class Judge:
    """Follows the truth of one run, or of a batch of runs, step by step."""

    reasons = {
        'arrived': 'arrived at the target',
        'contact': 'touched an obstacle',
        'timeout': 'did not arrive in time',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, craft: Craft, speed_corridor: SpeedCorridor, reach_m: NDArray,
                 batch: tuple = ()) -> None:
        limit = TOLERANCE if speed_corridor.kept else NAN
        self.measures = (
            Measure('propellant_kg', 'kg', 'propellant', digits=4),
            Measure('clearance_m', 'm', 'least clearance of an obstacle', low=0.0),
            Measure('speed_limit_ratio', '', 'greatest speed over its limit', high=limit),
            Measure('arrival_speed_m_s', 'm/s', 'speed at arrival', digits=4),
            Measure('propellant_2norm_kg', 'kg', 'propellant of one engine that turns', digits=4),
            Measure('delta_v_m_s', 'm/s', 'delta-v, summed over the axes', digits=4),
            Measure('arrival_time_s', 's', 'time of arrival', digits=0),
            Measure('switches', '', 'engines that went on or off', digits=0),
            Measure('final_swing_m_s', 'm/s',
                    f'variation of the speed beyond its fall, within {NEAR_M:g} m', digits=4))
        self._step_s, self._craft, self._corridor = run.step_s, craft, speed_corridor
        self._reach_m = reach_m
        self._ended = np.zeros(batch, dtype=bool)
        self._reason = np.full(batch, '', dtype='U8')
        self._duration, self._delta_v, self._one_engine, self._ratio = np.zeros((4, *batch))
        self._engines = np.zeros((3, *batch))
        self._switches, self._variation = np.zeros((2, *batch))
        self._first, self._last = np.full((2, *batch), NAN)     # speeds within NEAR_M
        self._clearance = np.full(batch, np.inf if len(reach_m) else NAN)
        self._arrival = np.full(batch, NAN)
        self._closest = Closest(reach_m)

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live = ~self._ended
        everyone = live.all()

        def put(values: NDArray, old: NDArray) -> NDArray:
            return values if everyone else np.where(live, values, old)

        state = truth.state
        self._duration = put(np.full_like(self._duration, k*self._step_s), self._duration)
        if k > 0:
            self._count_switches(truth.acceleration, put)
            x, y, z = (np.abs(truth.acceleration[..., i]) for i in range(3))
            self._delta_v = put(self._delta_v + self._step_s*(x + y + z), self._delta_v)
            self._one_engine = put(self._one_engine + self._step_s*np.sqrt(x*x + y*y + z*z),
                                   self._one_engine)
        touched = np.zeros_like(self._ended)
        if len(self._reach_m):
            least = self._closest.follow(state, truth.obstacles)
            self._clearance = put(np.minimum(self._clearance, least), self._clearance)
            touched = live & ~(least > 0.0)
        r = distance(state)
        u, v, w = (state[..., i] for i in range(3, 6))
        speed = np.sqrt(u*u + v*v + w*w)
        near = live & (r < NEAR_M)
        if near.any():
            change = np.abs(speed - self._last)
            self._variation = np.where(near & (change >= 0.0), self._variation + change,
                                       self._variation)
            self._first = np.where(near & np.isnan(self._first), speed, self._first)
            self._last = np.where(near, speed, self._last)
        ratio = speed / self._corridor.limit(r - self._craft.contact_m)
        self._ratio = put(np.maximum(self._ratio, ratio), self._ratio)
        over = live & (truth.final | touched)
        if np.count_nonzero(over):
            arrived = r <= self._craft.arrival_m
            why = np.where(arrived, 'arrived', 'timeout')
            why = np.where(touched, 'contact', why)
            why = np.where(np.isfinite(state).all(axis=-1), why, 'invalid')
            self._reason = np.where(over, why, self._reason)
            self._arrival = np.where(over & (why == 'arrived'), speed, self._arrival)
            self._ended = self._ended | over

    def _count_switches(self, acceleration: NDArray, put: Callable) -> None:
        """Count the changes between off and on of each axis; a change of sign is two."""
        engines = np.sign(np.moveaxis(acceleration, -1, 0))
        x, y, z = np.abs(engines - self._engines)
        self._switches = put(self._switches + (x + y + z), self._switches)
        self._engines = engines

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has timed out."""
        reason = np.where((self._reason == '') & final, 'timeout', self._reason)
        exhaust = self._craft.specific_impulse_s * G0
        values = {
            'propellant_kg': self._craft.mass_kg * -np.expm1(-self._delta_v / exhaust),
            'clearance_m': self._clearance, 'speed_limit_ratio': self._ratio,
            'arrival_speed_m_s': self._arrival,
            'propellant_2norm_kg': self._craft.mass_kg * -np.expm1(-self._one_engine / exhaust),
            'delta_v_m_s': self._delta_v,
            'arrival_time_s': np.where(reason == 'arrived', self._duration, NAN),
            'switches': self._switches, 'final_swing_m_s': np.maximum(
                self._variation - np.abs(self._last - self._first), 0.0)}
        return Verdict(reason == 'arrived', reason, self._duration, values)
