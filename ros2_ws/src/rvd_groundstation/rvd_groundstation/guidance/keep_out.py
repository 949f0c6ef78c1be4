"""
Laws among keep-out spheres: the barrier made to stop short of them, the potential field of a
sphere.

Frame   target orbital; states (..., 6) and places of obstacles (..., M, 3), the known map.
Method  Ours; docs/cluttered.md has derivation and limits. `among` gives a law the map:
        Barrier     sends the command nearest to what it would send from which the chaser can still
                    stop outside all bodies (`geometry.keep_out`), after one step at that command
        CorridorApf, DampedApf      add to their wall the same field about each sphere
        SafeApproach                adds its own repulsion by obstacles that alarm
        any other   has no term for obstacles and flies as if there were none
"""

from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.levels import HIGHEST
from rvd_dynamics.geometry.cone import radius
from rvd_dynamics.geometry.keep_out import beyond, SLACK_M, Stop, stopping, times
from rvd_dynamics.motion import cw
from rvd_groundstation.guidance.barrier import (
    Barrier, LEVELS, Levels, SLOWEST_M_S, THRUST_WEIGHT)
from rvd_groundstation.guidance.corridor_apf import CorridorApf
from rvd_groundstation.guidance.safe_approach import SafeApproach

Array = NDArray[np.float64]
CONTACT_WEIGHT = 1e9            # [m/s^2 per m] a body outweighs any corridor
SPARE_M = 0.05                  # [m] by which a way round misses what must be missed
AT_EASE_M = 0.1                 # [m] beyond the least room, for thrust that nobody asked for
BEARINGS = 16                   # ways round an obstacle that are looked at
AHEAD_M = 10.0                  # [m] nearer than this an obstacle in the way is led round
HORIZON_S = 20.0                # [s] for which a drift is believed
TURN_S = 2.0                    # [s] in which a wrong lateral rate is put right
EARLY_S, LEAST_S = 4.0, 4.0     # [s] before it, and at least, to be beside the body


class Map(NamedTuple):
    """The obstacles as the ground knows them."""

    places: Array                       # (..., M, 3) [m]
    radii: Array                        # (M,) [m]
    stop: Stop


def among(law: Any, known: Map) -> Any:
    """Return a law that knows of obstacles, or the law as it is where it has no term for them."""
    if isinstance(law, Barrier):
        return BarrierAmong(law, known)
    if isinstance(law, CorridorApf):
        return FieldAmong(law, known)
    if isinstance(law, SafeApproach):
        return ApproachAmong(law, known)
    return law


def uses_covariance(law: Any) -> bool:
    """Say whether a law among obstacles asks how well the state is predicted."""
    return isinstance(law, Barrier) or (
        isinstance(law, SafeApproach) and law.obstacles.alarm == 'probability')


class BarrierAmong:
    """The barrier that also stays out of spheres."""

    uses_stick: ClassVar[bool] = True

    def __init__(self, law: Barrier, known: Map) -> None:
        self._law, self._stop, self._radii = law, known.stop, known.radii
        places = known.places
        self._places = np.moveaxis(places.reshape(-1, *places.shape[-2:]), 0, -1)   # (M, 3, n)
        n, dt = law.orbit.mean_motion, law.run.step_s
        self._phi, self._dt = cw.transition(n, dt), dt
        self._accel = law.form.effect(np.repeat(LEVELS[:, None], 3, axis=1))        # (7, 3)

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None,
               covariance: ArrayLike) -> Array:
        """Return the effect (..., 3) of the automatic command; `covariance` is (..., 6, 6)."""
        prediction = np.asarray(prediction, dtype=float)
        neutral = np.zeros((*prediction.shape[:-1], 3), dtype=np.int8)
        outcome = self.outcome(prediction, neutral if stick is None else stick, covariance)
        return self._law.told(outcome, stick)

    def outcome(self, prediction: Array, stick: ArrayLike, covariance: ArrayLike) -> Levels:
        """Return the command (..., 3) that shall come out; 0 where the state is unknown."""
        state = np.ascontiguousarray(prediction.reshape(-1, 6).T)
        stick = np.array(np.reshape(stick, (-1, 3)).T)
        variance = np.diagonal(np.reshape(covariance, (-1, 6, 6)), axis1=1, axis2=2)
        known = np.isfinite(state).all(axis=0) & np.isfinite(variance).all(axis=1)
        state = np.where(known, state, 0.0)
        sigma = np.sqrt(np.where(known, np.maximum(variance.T, 0.0), 0.0))
        box = self._stop.box(sigma, state[3:])
        if self._law.around_m_s > 0.0:
            self._lead_round(state, stick, box)
        along, cost = self._law.wishes(state, stick)
        levels = np.empty(stick.shape, dtype=np.int8)
        levels[0] = along
        levels[1:] = cost.argmin(axis=0) - HIGHEST
        near = np.flatnonzero(known & self._near(state, box))
        if near.size:
            self._keep_out(near, state[:, near], box[:, near], levels, cost, stick)
        return (levels * known).T.reshape(*prediction.shape[:-1], 3)

    # -- stopping short ---------------------------------------------------------------------

    def _near(self, state: Array, box: Array) -> NDArray[np.bool_]:
        """Return which rows could, after the strongest thrust, stop as far as a body."""
        strongest = self._accel[-1][:, None]
        speed = np.abs(state[3:]) + strongest*self._dt
        reach = speed*self._dt + speed*speed / (2.0*self._stop.decelerations[:, None])
        reach = np.sqrt((reach*reach).sum(axis=0)) + SLACK_M
        near = np.zeros(state.shape[1], dtype=bool)
        for place, r in zip(self._rows(np.arange(state.shape[1])), self._radii):
            square = sum(beyond(state[i], place[i], box[i]) for i in range(3))
            near |= np.sqrt(square) - r <= reach
        return near

    def _rows(self, rows: Array) -> Array:
        """Return the places (M, 3, len(rows)) of the obstacles of rows."""
        one = self._places.shape[-1] == 1       # the same map in all rows
        return np.broadcast_to(self._places, (*self._places.shape[:2], len(rows))) if one \
            else self._places[..., rows]

    def _keep_out(self, rows: NDArray, state: Array, box: Array, levels: Levels, cost: Array,
                  stick: Levels) -> None:
        """Replace the levels from which a stop would end in a body, in place."""
        path = self._paths(state)
        places = self._rows(rows)
        squares = [[beyond(path[i], place[i], box[i]) for i in range(3)] for place in places]
        index = levels[:, rows].astype(int) + HIGHEST
        gap = self._gap(squares, index)
        # thrust ahead that the pilot has not asked for must not be braked away at once
        pushes = (index[0] - HIGHEST > np.maximum(stick[0, rows], 0)) & (gap < SLACK_M + AT_EASE_M)
        if pushes.any():
            index[0] = np.where(pushes, HIGHEST + np.maximum(stick[0, rows], 0), index[0])
            levels[0, rows] = index[0] - HIGHEST
            gap = self._gap(squares, index)
        bad = np.flatnonzero(gap < SLACK_M)
        if not bad.size:
            return
        a = self._accel[:, 0]
        price = np.empty((LEVELS.size, 3, bad.size))
        price[:, 0] = np.abs(a[:, None] - a[index[0][bad]]) + THRUST_WEIGHT*np.abs(a)[:, None]
        price[:, 1:] = cost[..., rows[bad]]
        some = [[axis[..., bad] for axis in axes] for axes in squares]
        # the weaker a command, the less is lost with it
        best, least = self._best(some, price, self._stop.brake_level)
        hard = np.flatnonzero(least > 0.0)
        if hard.size:
            best[:, hard], _ = self._best(
                [[axis[..., hard] for axis in axes] for axes in some], price[..., hard], HIGHEST)
        levels[:, rows[bad]] = best

    def _best(self, squares: list, price: Array, most: int) -> tuple[NDArray, Array]:
        """Return the best commands (3, n) of levels up to `most`, and how far in they end [m]."""
        used = slice(HIGHEST - most, HIGHEST + most + 1)
        n, size = price.shape[-1], 2*most + 1
        inside = np.zeros((size, size, size, n))
        least = np.empty_like(inside)
        for axes, r in zip(squares, self._radii):
            x, y, z = (np.ascontiguousarray(axis[used]) for axis in axes)
            least.fill(np.inf)
            for j in range(x.shape[1]):
                lateral = y[:, j][:, None] + z[:, j]
                np.minimum(least, x[:, j][:, None, None] + lateral, out=least)
            np.maximum(inside, r + SLACK_M - np.sqrt(least), out=inside)
        along, lateral, across = (price[used, i] for i in range(3))
        total = CONTACT_WEIGHT*inside + (
            along[:, None, None] + lateral[None, :, None] + across[None, None])
        best = total.reshape(-1, n).argmin(axis=0)
        chosen = inside.reshape(-1, n)[best, np.arange(n)]
        return np.stack(np.unravel_index(best, inside.shape[:3])) - most, chosen

    def _gap(self, squares: list, index: NDArray) -> Array:
        """
        Return how far outside all bodies the stops (n,) after the commands `index` (3, n) stay.
        """
        gap = np.full(index.shape[1], np.inf)
        for axes, r in zip(squares, self._radii):
            square = sum(np.take_along_axis(axes[i], index[i][None, None], axis=0)[0]
                         for i in range(3))
            np.minimum(gap, np.sqrt(square.min(axis=0)) - r, out=gap)
        return gap

    def _paths(self, state: Array) -> list[Array]:
        """Return the stops after one step at each level: for each axis (7, SAMPLES + 1, n)."""
        dt, free = self._dt, cw.product(self._phi, state.T).T
        p = free[:3] + (self._accel*(dt*dt/2.0))[..., None]             # (7, 3, n)
        v = free[3:] + (self._accel*dt)[..., None]
        at_s = times(np.abs(v).max(axis=0), self._stop.decelerations)   # (SAMPLES + 1, n)
        return [stopping(p[:, None, i], v[:, None, i], self._stop.decelerations[i], at_s)
                for i in range(3)]

    # -- leading round ----------------------------------------------------------------------

    def _lead_round(self, state: Array, stick: Levels, box: Array) -> None:
        """
        Put lateral levels that lead past the nearest obstacle in the way in place of the pilot's.

        They are only what the rest is asked to come near to: nothing here makes a state unsafe.
        """
        law, n = self._law, state.shape[1]
        places = self._rows(np.arange(n))
        closing = np.maximum(state[3], SLOWEST_M_S)
        drift = law.drift(state)
        wide = np.sqrt(box[1]*box[1] + box[2]*box[2]) + SLACK_M + SPARE_M
        soonest, which = np.full(n, np.inf), np.zeros(n, dtype=int)
        for k, (place, r) in enumerate(zip(places, self._radii)):
            ahead = place[0] - state[0]
            t = np.minimum(np.maximum(ahead - r - box[0], 0.0)/closing, HORIZON_S)
            off = state[1:3] + state[4:6]*t + drift*(0.5*t*t) - place[1:]
            hits = (np.sqrt((off*off).sum(axis=0)) < r + wide) & (ahead > -r) & (ahead < AHEAD_M)
            sooner = hits & (ahead < soonest)
            soonest, which = np.where(sooner, ahead, soonest), np.where(sooner, k, which)
        rows = np.flatnonzero(np.isfinite(soonest))
        if not rows.size:
            return
        way = self._way(state[:, rows], places[..., rows], which[rows], wide[rows], box[0, rows])
        clear = np.isfinite(way).all(axis=0)
        rows, way = rows[clear], way[:, clear]
        if not rows.size:
            return
        near = soonest[rows] - self._radii[which[rows]] - box[0, rows]
        left = np.minimum(np.maximum(near/closing[rows] - EARLY_S, LEAST_S), HORIZON_S)
        most = law.around_m_s
        rate = np.minimum(np.maximum((way - state[1:3, rows])/left, -most), most)
        push = (rate - state[4:6, rows])/TURN_S - drift[:, rows]
        wish = np.concatenate([np.zeros((1, rows.size)), push])
        stick[1:, rows] = law.form.quantise(wish.T).T[1:]

    def _way(self, state: Array, places: Array, which: NDArray, wide: Array, deep: Array) -> Array:
        """Return the nearest place (2, n) [m] beside the obstacles `which`; NaN: none is free."""
        rows = np.arange(state.shape[1])
        r, body = self._radii[which], places[which, :, rows].T              # (n,), (3, n)
        angle = np.arange(BEARINGS) * (2.0*np.pi/BEARINGS)
        beside = np.stack([np.cos(angle), np.sin(angle)])[..., None]        # (2, 16, 1)
        spot = body[1:, None] + (r + wide + SPARE_M)*beside
        bound = self._law.margin_fraction/np.sqrt(2.0)*radius(
            np.minimum(body[0] + r, 0.0), self._law.cone)
        free = np.abs(spot).max(axis=0) <= bound
        for k, (place, other) in enumerate(zip(places, self._radii)):
            abreast = np.abs(place[0] - body[0]) < r + other + 2.0*deep
            off = spot - place[1:, None]
            gap = np.sqrt((off*off).sum(axis=0)) - other - wide
            free &= (gap > 0.0) | ~abreast | (which == k)
        away = spot - state[1:3, None]
        cost = np.where(free, (away*away).sum(axis=0), np.inf)
        best = cost.argmin(axis=0)
        return np.where(np.isfinite(cost[best, rows]), spot[:, best, rows], np.nan)


class FieldAmong:
    """A potential field of the corridor that is repelled by spheres as it is by the wall."""

    uses_stick: ClassVar[bool] = False

    def __init__(self, law: CorridorApf, known: Map) -> None:
        self._law, self._places, self._radii = law, known.places, known.radii

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None) -> Array:
        """Return the acceleration (..., 3) that wall and spheres ask for; see `Law.wanted`."""
        state, law = np.asarray(prediction, dtype=float), self._law
        total = law.wanted(state, stick)
        for k, r in enumerate(self._radii):
            total = total + law.from_sphere(state, self._places[..., k, :], r)
        return total


class ApproachAmong:
    """`safe_apf` with its repulsion by spheres; called once a step: it keeps which alarm."""

    uses_stick: ClassVar[bool] = False

    def __init__(self, law: SafeApproach, known: Map) -> None:
        self._law, self._radii = law, known.radii
        self._places = np.concatenate([known.places, np.zeros_like(known.places)], axis=-1)
        self._on = np.zeros((), dtype=bool)

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None,
               covariance: Array | None = None) -> Array:
        """Return the acceleration (..., 3) wanted; `covariance` (..., 6, 6) of the prediction."""
        state, field = np.asarray(prediction, dtype=float), self._law.obstacles
        met = field.encounter(state, self._places, self._radii)
        spread = None if covariance is None else np.asarray(covariance)[..., None, :3, :3]
        self._on, _ = field.alarmed(met, spread, self._on)
        total, pushes = self._law.wanted(state, stick), field.repulsion(met, self._on)
        if not len(pushes):
            return total
        return total + np.stack(pushes, axis=-1) / self._law.time_s
