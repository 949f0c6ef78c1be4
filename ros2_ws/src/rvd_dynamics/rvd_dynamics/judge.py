"""
Judge of an approach: did it dock, and if not, why; from the true motion alone.

Frame, state as `orbit.cw`. Between samples the motion is a cubic Hermite arc (`arc`); the
run ends at its first root of x = 0, or at the time limit.
Source  Zhang, Li, Tang 2014, section 3.2: success means (i) inside the corridor throughout,
        (ii) at x = 0: closing rate between 0 and 0.3 m/s, offset below the docking radius,
        lateral rate below 0.3 m/s.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics import arc, corridor
from rvd_dynamics.mission import Mission

# Of several reasons the first in this order is given, and leaving the corridor before a
# time-out.
(UNDER_WAY, DOCKED, INVALID, LEFT_CORRIDOR, CLOSING_RATE, OFFSET, LATERAL_RATE,
 TIMEOUT) = range(8)
REASONS = np.array(['', 'docked', 'invalid', 'left_corridor', 'closing_rate', 'offset',
                    'lateral_rate', 'timeout'])


class Verdict(NamedTuple):
    """
    Judgement of runs, each field of the batch's shape (plain numbers for a single run).

    The fields are those of `rvd_interfaces/Verdict`.
    """

    success: Any                # [bool]  every criterion held
    reason: Any                 # [text]  one of REASONS; empty while the run goes on
    duration: Any               # [s]     from start to docking plane or end, or so far
    x_rate: Any                 # [m/s]   closing rate at x = 0; NaN before
    offset: Any                 # [m]     lateral offset at x = 0; NaN before
    lateral_rate: Any           # [m/s]   lateral rate at x = 0; NaN before
    min_corridor_margin: Any    # [m]     least signed distance to the corridor wall
    exit_time: Any              # [s]     when the corridor was first left; NaN when never
    exit_position: NDArray      # [m]     (..., 3), where; NaN when never
    delta_v: Any                # [m/s]   thrust executed, summed over the axes


class Judge:
    """
    Follows the truth of one run, or of a batch of runs, step by step.

    Call `start` with step 0, then `advance` with every step that follows. Rows do not
    influence each other; a row that has ended (`ended`) keeps its judgement whatever comes.
    """

    def __init__(self, mission: Mission, batch: tuple[int, ...] = ()) -> None:
        self._mission = mission
        self._batch = batch
        n = int(np.prod(batch, dtype=int))
        self._step = -1
        self._state = np.full((6, n), np.nan)
        self._reason = np.full(n, UNDER_WAY)
        self._live = np.ones(n, dtype=bool)
        self._end_time = np.full(n, np.nan)
        self._x_rate, self._offset, self._lateral_rate = np.full((3, n), np.nan)
        self._margin = np.full(n, np.nan)
        self._exit_time, self._exit_position = np.full(n, np.nan), np.full((3, n), np.nan)
        self._delta_v = np.zeros(n)

    @property
    def ended(self) -> NDArray[np.bool_]:
        """Whether each run has ended, shape of the batch."""
        return ~self._live.reshape(self._batch)

    def start(self, state: ArrayLike) -> None:
        """Take the state (..., 6) of step 0; one that is not before the plane is invalid."""
        self._state = self._columns(state, 6)
        self._step = 0
        x, y, z = self._state[:3]
        self._refuse(~(np.isfinite(self._state).all(axis=0) & (x < 0.0)))
        margin = self._distance(self._state[:3])
        self._margin = np.where(self._live, margin, np.nan)
        outside = self._live & (margin <= 0.0)
        self._exit_time[outside] = 0.0
        self._exit_position[:, outside] = self._state[:3, outside]

    def advance(self, step: int, state: ArrayLike, accel: ArrayLike) -> None:
        """
        Take the state (..., 6) of `step` and the acceleration (..., 3) executed since.

        Raises
        ------
        ValueError
            If `step` does not follow the last one: a run with a gap cannot be judged.
        """
        if self._step < 0 or step != self._step + 1:
            raise ValueError(f'a judge needs every step in order: got {step} '
                             f'after {self._step if self._step >= 0 else "none"}')
        self._step = step
        start, self._state = self._state, self._columns(state, 6)
        accel = np.abs(self._columns(accel, 3))
        known = np.isfinite(self._state).all(axis=0) & np.isfinite(accel).all(axis=0)
        if not known.all():
            self._refuse(~known)
        if not self._live.any():
            return
        points = arc.control_points(start, self._state, self._mission.step_s)
        docked, end = self._docking(points)
        self._follow(points, docked, end)
        np.add(self._delta_v, (accel[0] + accel[1] + accel[2]) * (end*self._mission.step_s),
               out=self._delta_v, where=self._live)
        if docked.any():
            self._judge_docking(points, docked, end)
        if step >= self._mission.last_step:
            self._time_out()

    def verdict(self, final: bool = False) -> Verdict:
        """Return the judgement so far; with `final` a run still under way has timed out."""
        reason = self._reason.copy()
        if final:
            reason[self._live] = self._failure(np.full(reason.size, TIMEOUT))[self._live]
        duration = np.where(self._live, max(self._step, 0)*self._mission.step_s, self._end_time)
        flat = (reason == DOCKED, REASONS[reason], duration, self._x_rate, self._offset,
                self._lateral_rate, self._margin, self._exit_time)
        fields = [field.reshape(self._batch) for field in flat]
        exit_position = self._exit_position.T.reshape((*self._batch, 3)).copy()
        fields += [exit_position, self._delta_v.reshape(self._batch)]
        if not self._batch:                         # plain numbers and text for a message
            fields = [field.item() if field.ndim == 0 else field for field in fields]
        else:
            fields = [field.copy() for field in fields]
        return Verdict(*fields)

    # -- the criteria ---------------------------------------------------------------------

    def _docking(self, points: arc.Array) -> tuple[NDArray[np.bool_], arc.Array]:
        """Return which live runs reach x = 0 on this arc, and the fraction that each flies."""
        end = np.ones(points.shape[2])
        docked = self._live & (points[1:, 0].max(axis=0) >= 0.0)    # hull: can reach it
        if docked.any():
            rows = np.flatnonzero(docked)
            near = points[:, :, rows]

            def to_go(s):
                return -arc.position(near[:, :1], s)[0]

            closest, least = arc.lowest(to_go, end[rows])
            # a sample behind the plane has crossed it, however the rounding falls
            closest = np.where(near[3, 0] >= 0.0, 1.0, closest)
            docked[rows] = (least <= 0.0) | (near[3, 0] >= 0.0)
            root = arc.first_not_positive(to_go, closest)
            end[rows] = np.where(docked[rows], root, 1.0)
        return docked, end

    def _follow(self, points: arc.Array, docked: NDArray[np.bool_], end: arc.Array) -> None:
        """Keep the least margin and the first exit of live runs up to fraction `end`."""
        bound = self._distance(points[1:].transpose(1, 0, 2))       # inner, inner, sample
        sampled = self._live & ~docked
        np.minimum(self._margin, bound[2], out=self._margin, where=sampled)
        lower = np.minimum(bound[0], bound[1]) < self._margin       # hull: may be lower inside
        inside = docked | (sampled & lower)
        worst = end
        if inside.any():
            rows = np.flatnonzero(inside)
            worst = end.copy()
            worst[rows], least = arc.lowest(self._along(points[:, :, rows]), end[rows])
            self._margin[rows] = np.minimum(self._margin[rows], least)
        leaving = self._live & (self._margin <= 0.0) & np.isnan(self._exit_time)
        if leaving.any():
            rows = np.flatnonzero(leaving)
            part = points[:, :, rows]
            s = arc.first_not_positive(self._along(part), worst[rows])
            self._exit_time[rows] = (self._step - 1 + s) * self._mission.step_s
            self._exit_position[:, rows] = arc.position(part, s)

    def _judge_docking(self, points: arc.Array, docked: NDArray[np.bool_],
                       end: arc.Array) -> None:
        """Close the runs that have reached x = 0."""
        rows = np.flatnonzero(docked)
        limits = self._mission.docking
        part, s = points[:, :, rows], end[rows]
        _, y, z = arc.position(part, s)
        vx, vy, vz = arc.velocity(part, s, self._mission.step_s)
        offset, lateral_rate = np.sqrt(y*y + z*z), np.sqrt(vy*vy + vz*vz)
        self._x_rate[rows], self._offset[rows], self._lateral_rate[rows] = (
            vx, offset, lateral_rate)
        reason = np.full(rows.size, DOCKED)
        reason[~(lateral_rate < limits.max_lateral_rate_m_s)] = LATERAL_RATE
        reason[~(offset < self._mission.corridor.docking_radius_m)] = OFFSET
        reason[~((vx > 0.0) & (vx < limits.max_closing_rate_m_s))] = CLOSING_RATE
        self._end(docked, self._failure(reason, rows), (self._step - 1 + s))

    def _time_out(self) -> None:
        rows = np.flatnonzero(self._live)
        reason = self._failure(np.full(rows.size, TIMEOUT), rows)
        self._end(self._live.copy(), reason, self._step)

    def _refuse(self, broken: NDArray[np.bool_]) -> None:
        """Close live runs whose truth is unknown; they were known up to the step before."""
        self._end(broken & self._live, INVALID, max(self._step - 1, 0))

    def _failure(self, reason: NDArray, rows: Any = slice(None)) -> NDArray:
        """Return `reason`, or that the corridor was left: it comes first."""
        return np.where(np.isnan(self._exit_time[rows]), reason, LEFT_CORRIDOR)

    def _end(self, which: NDArray[np.bool_], reason: ArrayLike, steps: ArrayLike) -> None:
        self._reason[which] = reason
        self._end_time[which] = np.asarray(steps) * self._mission.step_s
        self._live &= ~which

    # -- geometry -------------------------------------------------------------------------

    def _along(self, points: arc.Array) -> arc.Function:
        """Return the corridor margin as a function of the fraction of each arc."""
        return lambda s: self._distance(arc.position(points, s))

    def _distance(self, position: arc.Array) -> arc.Array:
        """Return signed distances to the wall of positions (3, ...)."""
        return corridor.signed_distance(np.moveaxis(position, 0, -1), self._mission.corridor)

    def _columns(self, rows: ArrayLike, width: int) -> arc.Array:
        """Return a private copy (width, N) of an argument (..., width)."""
        rows = np.asarray(rows, dtype=float)
        if rows.shape != (*self._batch, width):
            raise ValueError(f'expected shape {(*self._batch, width)}, got {rows.shape}')
        return np.array(rows.reshape(-1, width).T, order='C')
