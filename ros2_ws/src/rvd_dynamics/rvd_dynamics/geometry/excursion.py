"""
How near runs came to the corridor wall, and where they first left it.

Samples are taken as they come. An arc between two samples is searched only if, by its control
points, it may hold a lower margin than every sample so far, or the first exit. Such arcs wait
until the result is asked for, because later samples make most searches needless.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.geometry import arc
from rvd_dynamics.geometry.cone import Cone, distance_at

Mask = NDArray[np.bool_]

WAITING = 20_000        # arcs that may wait: bounds memory
SLACK = 1e-9            # [m] above rounding: the result must not depend on when arcs are searched


class Excursion:
    """Least margin and first exit of N runs; positions are (3, N) [m], times [s]."""

    def __init__(self, n: int, corridor: Cone, step_s: float) -> None:
        self._corridor = corridor
        self._step_s = step_s
        self._sampled = np.full(n, np.nan)              # least margin at the samples
        self._outside = np.zeros(n, dtype=bool)         # judged by the samples
        self._margin = np.full(n, np.inf)               # least margin on the searched arcs
        self._exit_time = np.full(n, np.nan)
        self._exit_position = np.full((3, n), np.nan)
        self._waiting: list[tuple] = []
        self._count = 0

    def start(self, position: arc.Array, live: Mask) -> None:
        """Take the first sample of the runs `live`."""
        self._sampled[live] = self._distance(position)[live]
        self._outside = self._sampled <= 0.0
        self._exit_time[self._outside] = 0.0
        self._exit_position[:, self._outside] = position[:, self._outside]

    def follow(self, step: int, points: arc.Array, live: Mask, cut: Mask,
               flown: arc.Array) -> None:
        """Take the arcs (3, 4, N) up to `step`; those in `cut` end at fraction `flown` (N,)."""
        inner, outer, sample = self._distance(points[:, 1:])
        np.minimum(self._sampled, sample, out=self._sampled, where=live > cut)
        bound = np.minimum(inner, outer)
        search = (bound < self._sampled) | cut
        outside = self._sampled <= 0.0
        search |= outside > self._outside               # the first sample outside
        self._outside = outside
        rows = np.flatnonzero(search & live)
        if rows.size:
            self._waiting.append((rows, points[:, :, rows], flown[rows],
                                  np.full(rows.size, step - 1),
                                  np.minimum(bound[rows], sample[rows])))
            self._count += rows.size
            if self._count > WAITING:
                self._search()

    def result(self) -> tuple[arc.Array, arc.Array, arc.Array]:
        """Return least margin (N,), time (N,) and position (3, N) of the first exit, or NaN."""
        self._search()
        return np.minimum(self._sampled, self._margin), self._exit_time, self._exit_position

    def _search(self) -> None:
        """Search the waiting arcs, which are in order of time, if they can still matter."""
        if not self._waiting:
            return
        waiting = [np.concatenate(part, axis=-1) for part in zip(*self._waiting)]
        self._waiting, self._count = [], 0
        rows, _, _, _, bound = waiting
        matters = (bound < self._sampled[rows] + SLACK) | (bound <= SLACK)
        rows, points, end, step, _ = (part[..., matters] for part in waiting)
        where, least = arc.lowest(self._along(points), end)
        np.minimum.at(self._margin, rows, least)
        out = np.flatnonzero((least <= 0.0) & np.isnan(self._exit_time[rows]))
        _, first = np.unique(rows[out], return_index=True)      # the earliest arc of each run
        out = out[first]
        s = arc.first_not_positive(self._along(points[:, :, out]), where[out])
        self._exit_time[rows[out]] = (step[out] + s) * self._step_s
        self._exit_position[:, rows[out]] = arc.position(points[:, :, out], s)

    def _along(self, points: arc.Array) -> arc.Function:
        """Return the margin as a function of the fraction of each arc."""
        return lambda s: self._distance(arc.position(points, s))

    def _distance(self, position: arc.Array) -> arc.Array:
        x, y, z = position
        return distance_at(x, np.sqrt(y*y + z*z), self._corridor)
