"""
Judge of an approach: did it dock, and if not, why; from the true motion alone.

Frame, state as `orbit.cw`. Between samples the motion is a cubic Hermite arc (`arc`); the
run ends at its first root of x = 0, or at the time limit.
Source  Zhang, Li, Tang 2014, section 3.2: success means (i) inside the corridor throughout,
        (ii) at x = 0: closing rate between 0 and 0.3 m/s, offset below the docking radius,
        lateral rate below 0.3 m/s.
Ours    among obstacles a contact ends the run, whatever came before it; a run whose time is up
        before it has passed the far side of an obstacle is a deadlock.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry import arc
from rvd_dynamics.geometry.cone import Cone
from rvd_dynamics.geometry.excursion import Excursion
from rvd_dynamics.geometry.keep_out import start_room, Stop
from rvd_dynamics.geometry.obstacles import Closest
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_missions.lunar_approach.end import ended, time_is_up
from rvd_missions.lunar_approach.settings import DockingParams, Obstacles

# Of several reasons the lowest number is given.
(UNDER_WAY, DOCKED, INVALID, LEFT_CORRIDOR, CLOSING_RATE, OFFSET, LATERAL_RATE,
 TIMEOUT, CONTACT, DEADLOCK) = range(10)
REASONS = np.array(['', 'docked', 'invalid', 'left_corridor', 'closing_rate', 'offset',
                    'lateral_rate', 'timeout', 'contact', 'deadlock'])
AMONG = {
    'contact': 'touched an obstacle',
    'deadlock': 'did not get past an obstacle in time',
}


class Judge:
    """
    Follows the truth of one run, or of a batch of runs, step by step.

    Call `start` with step 0, then `advance` with every step that follows. Rows do not
    influence each other; a row that has ended (`ended`) keeps its judgement whatever comes.
    """

    reasons = {
        'docked': 'docked',
        'left_corridor': 'left the corridor',
        'closing_rate': 'closing rate out of limits at the docking plane',
        'offset': 'lateral offset out of limits at the docking plane',
        'lateral_rate': 'lateral rate out of limits at the docking plane',
        'timeout': 'did not reach the docking plane in time',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, cone: Cone, docking: DockingParams,
                 batch: tuple[int, ...] = (), runs: Sequence[int] | None = None,
                 obstacles: Obstacles = Obstacles(), orbit: OrbitParams = OrbitParams(),
                 stop: Stop | None = None) -> None:
        self.measures = (
            Measure('x_rate_m_s', 'm/s', 'closing rate at docking', 0.0,
                    docking.max_closing_rate_m_s, digits=4),
            Measure('offset_m', 'm', 'lateral offset at docking',
                    high=cone.docking_radius_m, digits=4),
            Measure('lateral_rate_m_s', 'm/s', 'lateral rate at docking',
                    high=docking.max_lateral_rate_m_s, digits=4),
            Measure('min_corridor_margin_m', 'm', 'least corridor margin', low=0.0),
            Measure('delta_v_m_s', 'm/s', 'delta-v'),      # executed, summed over the axes
            Measure('exit_time_s', 's', 'left the corridor at', digits=1),
            Measure('exit_x_m', 'm', 'x at the exit', digits=2),
            Measure('exit_y_m', 'm', 'y at the exit', digits=2),
            Measure('exit_z_m', 'm', 'z at the exit', digits=2))
        self._among = None
        if obstacles.count:
            self.reasons = {**self.reasons, **AMONG}
            self.measures += (
                Measure('clearance_m', 'm', 'least clearance of an obstacle', low=0.0),
                Measure('start_room_m', 'm', 'room of the start, feasible from 0'))
            runs = [run.run] if runs is None else runs
            self._among = _Among(obstacles.places(run.seed, runs, batch), obstacles.radii, orbit,
                                 stop, run, int(np.prod(batch, dtype=int)))
        self._step_s, self._last_step = run.step_s, run.last_step
        self._cone, self._docking_limits = cone, docking
        self._batch = batch
        n = int(np.prod(batch, dtype=int))
        self._step = -1
        self._state = np.full((6, n), np.nan)
        self._excursion = Excursion(n, cone, run.step_s)
        self._live = np.ones(n, dtype=bool)
        self._reason = np.full(n, UNDER_WAY)
        self._end_time = np.full(n, np.nan)
        self._x_rate, self._offset, self._lateral_rate = np.full((3, n), np.nan)
        self._terminal = np.full((6, n), np.nan)
        self._delta_v = np.zeros(n)

    @property
    def ended(self) -> NDArray[np.bool_]:
        """Whether each run has ended, shape of the batch."""
        return ~self._live.reshape(self._batch)

    @property
    def terminal(self) -> NDArray[np.float64]:
        """State (..., 6) at the docking plane; NaN in runs that have not reached it."""
        return self._terminal.T.reshape(*self._batch, 6).copy()

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        if k == 0:
            self.start(truth.state)
        else:
            self.advance(k, truth.state, truth.acceleration)

    def start(self, state: ArrayLike) -> None:
        """Take the state (..., 6) of step 0; one that is not before the plane is invalid."""
        self._state = self._columns(state, 6)
        self._step = 0
        self._end(ended(0, self._state.T, self._last_step), INVALID, 0)
        self._excursion.start(self._state[:3], self._live)
        if self._among is not None:
            self._among.start(self._state)
            self._end(self._live & self._among.follow(self._state, self._live), CONTACT, 0)

    def advance(self, step: int, state: ArrayLike, accel: ArrayLike) -> None:
        """
        Take the state (..., 6) of `step` and the acceleration (..., 3) executed since.

        Raises
        ------
        ValueError
            If `step` does not follow the last one: a run with a gap cannot be judged.
        """
        if self._step < 0 or step != self._step + 1:
            raise BadInput(f'a judge needs every step in order: got {step} '
                           f'after {self._step if self._step >= 0 else "none"}')
        self._step = step
        start, self._state = self._state, self._columns(state, 6)
        accel = np.abs(self._columns(accel, 3))
        if not (np.isfinite(self._state).all() and np.isfinite(accel).all()):
            known = np.isfinite(self._state).all(axis=0) & np.isfinite(accel).all(axis=0)
            self._end(self._live & ~known, INVALID, step - 1)
            self._state[:, ~known] = np.nan         # not inf, which would only make noise
        if not self._live.any():
            return
        points = arc.control_points(start, self._state, self._step_s)
        docked, flown = self._docking(points)
        self._excursion.follow(step, points, self._live, docked, flown)
        np.add(self._delta_v, (accel[0] + accel[1] + accel[2]) * (flown*self._step_s),
               out=self._delta_v, where=self._live)
        if docked.any():
            self._judge_docking(points, docked, flown)
        if self._among is not None:             # a run that docked in this step has docked
            self._end(self._live & self._among.follow(self._state, self._live), CONTACT, step)
        if time_is_up(step, self._last_step):   # every other end has been closed above
            self._end(self._live.copy(), TIMEOUT, step)

    def verdict(self, final: bool = False) -> Verdict:
        """Return the judgement so far; with `final` a run still under way has timed out."""
        margin, exit_time, exit_position = self._excursion.result()
        reason = np.where(self._live & final, TIMEOUT, self._reason)
        more = ()
        if self._among is not None:
            reason[(reason == TIMEOUT) & self._among.short()] = DEADLOCK
            more = self._among.clearance, self._among.room
        judged = ~np.isin(reason, (UNDER_WAY, INVALID, CONTACT, DEADLOCK))
        reason[judged & ~np.isnan(exit_time)] = LEFT_CORRIDOR       # it came first
        duration = np.where(self._live, max(self._step, 0)*self._step_s, self._end_time)
        values = (self._x_rate, self._offset, self._lateral_rate, margin, self._delta_v,
                  exit_time, *exit_position, *more)
        return Verdict(
            self._shaped(reason == DOCKED), self._shaped(REASONS[reason]), self._shaped(duration),
            {m.name: self._shaped(v) for m, v in zip(self.measures, values, strict=True)},
            self._shaped(np.where(reason == LEFT_CORRIDOR, exit_time, np.nan)))

    def _shaped(self, field: NDArray) -> Any:
        """Return a private copy of a field (N,) in the batch's shape; of a single run a number."""
        field = field.reshape(self._batch).copy()
        return field if field.ndim else field.item()

    def _docking(self, points: arc.Array) -> tuple[NDArray[np.bool_], arc.Array]:
        """Return which live runs reach x = 0 on this arc, and the fraction that each flies."""
        flown = np.ones(points.shape[-1])
        docked = self._live & (points[0, 3] >= 0.0)
        touching = self._live & (points[0, 1:].max(axis=0) >= 0.0) & ~docked    # by the hull
        if touching.any():                          # there and back between two samples?
            rows = np.flatnonzero(touching)
            closest, least = arc.lowest(_to_go(points[:1, :, rows]), flown[rows])
            docked[rows] = least <= 0.0
            flown[rows] = np.where(docked[rows], closest, 1.0)
        if docked.any():
            rows = np.flatnonzero(docked)
            flown[rows] = arc.first_not_positive(_to_go(points[:1, :, rows]), flown[rows])
        return docked, flown

    def _judge_docking(self, points: arc.Array, docked: NDArray[np.bool_],
                       flown: arc.Array) -> None:
        """Close the runs that have reached x = 0."""
        rows = np.flatnonzero(docked)
        limits = self._docking_limits
        part, s = points[:, :, rows], flown[rows]
        x, y, z = arc.position(part, s)
        vx, vy, vz = arc.velocity(part, s, self._step_s)
        self._terminal[:, rows] = x, y, z, vx, vy, vz
        offset, lateral_rate = np.sqrt(y*y + z*z), np.sqrt(vy*vy + vz*vz)
        reason = np.full(rows.size, DOCKED)
        reason[~(lateral_rate < limits.max_lateral_rate_m_s)] = LATERAL_RATE
        reason[~(offset < self._cone.docking_radius_m)] = OFFSET
        reason[~((vx > 0.0) & (vx < limits.max_closing_rate_m_s))] = CLOSING_RATE
        self._x_rate[rows], self._offset[rows], self._lateral_rate[rows] = (
            vx, offset, lateral_rate)
        self._end(docked, reason, self._step - 1 + s)

    def _end(self, which: NDArray[np.bool_], reason: ArrayLike, steps: ArrayLike) -> None:
        """Close the runs `which` with a reason, `steps` (fractions too) after the start."""
        self._reason[which] = reason
        self._end_time[which] = np.asarray(steps) * self._step_s
        self._live &= ~which

    def _columns(self, rows: ArrayLike, width: int) -> arc.Array:
        """Return a private copy (width, N) of an argument (..., width)."""
        rows = np.asarray(rows, dtype=float)
        if rows.shape != (*self._batch, width):
            raise BadInput(f'expected shape {(*self._batch, width)}, got {rows.shape}')
        return np.array(rows.reshape(-1, width).T, order='C')


class _Among:
    """What runs among obstacles are judged by besides; arrays (n,)."""

    def __init__(self, places: NDArray, radii: NDArray, orbit: OrbitParams, stop: Stop, run: Run,
                 n: int) -> None:
        self._places = np.broadcast_to(places, (n, *places.shape[-2:])) if places.ndim == 2 \
            else places.reshape(n, *places.shape[-2:])
        self._radii, self._closest = radii, Closest(radii)
        self._orbit, self._stop, self._run = orbit, stop, run
        self.clearance = np.full(n, np.inf)
        self.room = np.full(n, np.nan)
        self._station = np.full(n, np.nan)

    def start(self, state: NDArray) -> None:
        """Take the states (6, n) of step 0 and say what room they leave."""
        self.room = start_room(state.T, self._places, self._radii, self._stop,
                               self._orbit.mean_motion, self._run.step_s)

    def follow(self, state: NDArray, live: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Take states (6, n) of the next step and return which have touched something."""
        gap = self._closest.follow(state[:3].T, self._places)
        np.minimum(self.clearance, gap, out=self.clearance, where=live)
        self._station = state[0]
        return ~(gap > 0.0)

    def short(self) -> NDArray[np.bool_]:
        """Return which have an obstacle whose far side they have not passed."""
        return (self._places[..., 0] + self._radii > self._station[:, None]).any(axis=-1)


def _to_go(points: arc.Array) -> arc.Function:
    """Return the way left to the docking plane as a function of the fraction of each arc."""
    return lambda s: -arc.position(points, s)[0]
