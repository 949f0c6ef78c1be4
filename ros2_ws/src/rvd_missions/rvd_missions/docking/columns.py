"""
Columns of a campaign's table beyond the measures: navigation error, innovations, safety.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion import attitude, cw
from rvd_missions.docking.plan_columns import FlownMargins
from rvd_missions.docking.planning import Preparation
from rvd_missions.docking.safety import ABORT
from rvd_missions.docking.scatter import drawn, Scatter
from rvd_missions.docking.settings import Chaser, OrbitParams

COASTS = 400                            # instants of an orbit at which a coasting craft is sought


class Columns:
    """
    Root mean squares over each run, from the first estimate on; nothing is judged by them.

    `gyro_drift_deg_h` is the mean error of the rate: what is left of the gyro's bias.
    `coast_least_m` is how near the centres would come within an orbit if an aborted craft went on
    coasting from where the run ends, by Clohessy and Wiltshire; NaN without an ABORT.
    """

    def __init__(self, scatter: Scatter, craft: Any, chaser: Chaser, properties: NDArray,
                 preparation: Preparation, run: Run, orbit: OrbitParams, batch: tuple) -> None:
        self._redrawn = drawn(scatter, craft, chaser, properties).redrawn.reshape(batch)
        self._margins = FlownMargins(preparation, run, batch)
        self._ended = np.zeros(batch, dtype=bool)
        self._n, self._last = orbit.mean_motion, np.full((*batch, 6), np.nan)
        self._place, self._speed, self._angle, self._count = np.zeros((4, *batch))
        self._drift = np.zeros((*batch, 3))
        self._nis, self._views = np.zeros((*batch, 2)), np.zeros(batch)
        self._safety = np.zeros(batch, dtype=np.uint8)

    def step(self, k: int, truth: Any, estimate: Any, guidance: Any) -> dict[str, Any]:
        """Add step k; the target is taken to be at rest in LVLH, as the filters do."""
        known = ~self._ended & np.isfinite(estimate.position[..., 0])
        turn = attitude.rotation_vector(attitude.multiply(
            attitude.conjugate(estimate.attitude), truth.attitude))
        for name, error in (('_place', estimate.position - truth.position),
                            ('_speed', estimate.velocity - truth.velocity), ('_angle', turn)):
            square = error[..., 0]**2 + error[..., 1]**2 + error[..., 2]**2
            setattr(self, name, getattr(self, name) + np.where(known, square, 0.0))
        self._count = self._count + known
        error = np.where(known[..., np.newaxis], estimate.rate - truth.rate, 0.0)
        self._drift = self._drift + error
        seen = known & np.isfinite(estimate.nis[..., 0])
        self._nis = self._nis + np.where(seen[..., np.newaxis], estimate.nis, 0.0)
        self._views = self._views + seen
        self._safety = np.where(self._ended, self._safety,
                                np.maximum(self._safety, guidance.safety))
        self._margins.step(k, truth, ~self._ended)
        ends = truth.final & ~self._ended
        if np.count_nonzero(ends):
            self._last = np.where(ends[..., np.newaxis], np.concatenate(
                [truth.position, truth.velocity], axis=-1), self._last)
        self._ended = self._ended | truth.final
        return {}

    def table(self, judge: Any, end_step: NDArray[np.int64]) -> dict[str, NDArray]:
        """Return the columns of N runs; rms of one axis of the three."""
        with np.errstate(invalid='ignore', divide='ignore'):
            n = 3.0*self._count
            drift = np.degrees(self._drift)*3600.0/self._count[..., np.newaxis]
            drift = np.sqrt((drift[..., 0]**2 + drift[..., 1]**2 + drift[..., 2]**2)/3.0)
            return {'nav_error_m': np.sqrt(self._place/n), 'nav_speed_m_s': np.sqrt(self._speed/n),
                    'nav_attitude_error_deg': np.degrees(np.sqrt(self._angle/n)),
                    'gyro_drift_deg_h': drift, 'nis_attitude': self._nis[..., 0]/self._views,
                    'nis_position': self._nis[..., 1]/self._views,
                    'safety_state': self._safety.astype(np.int64), 'redrawn': self._redrawn,
                    'coast_least_m': self._coast(), 'steps': end_step, **self._margins.table()}

    def _coast(self) -> NDArray:
        """Return how near the centres of aborted rows come within an orbit [m]."""
        least, rows = np.full(self._safety.shape, np.nan), self._safety == ABORT
        if np.count_nonzero(rows):
            # our z is to the Moon, the y of cw away from it; our y is its z
            start = self._last[rows][:, [0, 2, 1, 3, 5, 4]]*[1.0, -1.0, 1.0, 1.0, -1.0, 1.0]
            way = cw.propagate(start[:, np.newaxis], self._n,
                               np.linspace(0.0, 2*np.pi/self._n, COASTS))
            least[rows] = np.sqrt((way[..., :3]**2).sum(axis=-1)).min(axis=-1)
        return least
