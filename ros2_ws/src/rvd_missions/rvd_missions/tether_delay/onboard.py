"""
The tracker on board: flies the plans that come up the link, and stands still when it is told to.

HOLD    is no cut-off and no coasting: the gripper would go on to the target. It comes to rest along
        the tether at a constant deceleration and then stands on a taut tether, bearing and
        attitude going over to pointing along the line from platform to target,
            l* = l_h + v_h t - a t^2/2 until at rest,   y* = y_e + (y_h - y_e) exp(-t/ease),
            T* = T_min + m a while it brakes outward motion,   F_l* = T_min,
        with the thrusters against the least tension. The plan that was flown is void: its times
        have passed.
ABORT   the same, harder, and for good. An opened latch cannot be closed again; a closed one stays.
Law     `rvd_missions.tether.onboard.Feedback` on the error against what is followed.
Source  assumed: the paper knows neither link nor operator.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.onboard.guard import block as house
from rvd_dynamics.onboard.guard.modes import GuardParams
from rvd_groundstation.planning.plan import Plan
from rvd_missions.tether import geometry
from rvd_missions.tether.commands import TetherForm
from rvd_missions.tether.inputs import InputParams, reference
from rvd_missions.tether.onboard import Feedback, seen, TrackerParams
from rvd_missions.tether_delay.planning import Preparation
from rvd_missions.tether_delay.settings import StandingParams
from rvd_missions.tether_delay.signals import (
    ABORTED, ARRIVED, BRAKING, CRAFT, DOWNLINK, FLYING, GO, HOLD, LATCHED, NO_PLAN, STANDING,
    TRACKING, WANTED)

LATE_S = 1.0                            # a plan whose begin is further back is not begun
NEAREST_M = 1.0                         # the range that is believed in, at least


class TetherGuard(house.Guard):
    """The guard of the house, with the limits of tension, force and torque."""

    def __init__(self, settings: GuardParams, tether_form: TetherForm, run: Run, block: Block,
                 batch: tuple) -> None:
        super().__init__(settings, tether_form, run, block, batch)


class Store:
    """The plan that comes up, point by point, of N rows."""

    def __init__(self, rows: int, nodes: int) -> None:
        self.number = np.zeros(rows, dtype=int)
        self._span = np.zeros((rows, 2))
        self._states = np.zeros((rows, nodes + 2, 12))
        self._controls = np.zeros((rows, nodes + 2, 7))
        self._have = np.zeros((rows, nodes + 2), dtype=bool)

    def take(self, received: NDArray, sent: NDArray) -> NDArray[np.int64]:
        """Take the points in frames (N, 24) that were received; return rows now complete."""
        number, point = sent[:, 1].astype(int), sent[:, 2].astype(int)
        fits = received & (number > 0) & (point < self._have.shape[1])
        newer = fits & (number > self.number)
        if newer.any():
            self.number = np.where(newer, number, self.number)
            self._have[newer] = False
        rows = np.flatnonzero(fits & (number == self.number))
        was = self._have[rows].all(axis=-1)
        self._span[rows] = sent[rows, 3:5]
        self._states[rows, point[rows]] = sent[rows, 5:17]
        self._controls[rows, point[rows]] = sent[rows, 17:]
        self._have[rows, point[rows]] = True
        return rows[self._have[rows].all(axis=-1) & ~was]

    def plan(self, row: int) -> Plan:
        """Return the plan of a row that is complete."""
        begin, end = self._span[row]
        return Plan(begin, end, self._states[row].copy(), self._controls[row, 1:-1].copy())


class OrderedTracker:
    """Fires on each measurement; of what came up in the step before it takes orders and plans."""

    def __init__(self, settings: TrackerParams, inputs: InputParams, preparation: Preparation,
                 tether_form: TetherForm, standing: StandingParams, run: Run, batch: tuple) -> None:
        if settings.observer.on:
            raise BadInput('gripper_tracker.observer.on must be false: the observer follows one '
                           'plan from its release, and here there may be more')
        p = self._prepared = preparation
        self._settings, self._form, self._batch = settings, tether_form, batch
        self._standing, self._spline, self._h = standing, inputs.spline, run.step_s
        n = self._rows = int(np.prod(batch, dtype=int))
        self._feedback = Feedback(settings, p.gripper, run.step_s, (n,))
        self._store = Store(n, p.planner.nodes)
        # of the plan that is flown, and of the newest complete one: seen, inputs, range
        self._table: NDArray = np.zeros((n, 1, 14))
        self._next: NDArray = np.zeros((n, 1, 14))
        self._begin, self._last, self._flown = np.zeros((3, n), dtype=int)
        self._opens, self._closes, self._ready = np.zeros((3, n), dtype=int)
        self._doing, self._was = np.full((2, n), LATCHED)       # now, and in the step before
        self._followed = np.zeros(n, dtype=int)                 # plan of the step before
        # what is held from: step, what was seen, speed along the tether, deceleration
        self._since = np.zeros(n, dtype=int)
        self._from, self._speed, self._brakes = np.zeros((n, 6)), np.zeros(n), np.ones(n)
        self._measured, self._rate = np.full((n, 6), np.nan), np.zeros(n)

    # -- a step -----------------------------------------------------------------------------------

    def step(self, k: int, measurement: Any, arrival: Any) -> dict[str, Any]:
        """Return the command of step k, for the guard, what the gripper does, and the downlink."""
        measured = np.reshape(seen(measurement), (self._rows, 6))
        self._watch_length(measured)
        self._obey(k, arrival)
        # another reference is followed than before; one that stands has been braking
        anew = ((self._doing != self._was) & (self._doing != STANDING)) | (
            (self._doing == FLYING) & (self._flown != self._followed))
        self._was, self._followed = self._doing.copy(), self._flown.copy()
        followed, fed, far = self._reference(k)
        error = measured - followed
        # blind: bearing is not what it seems, length and attitude still are
        blind = ~np.reshape(measurement.in_view, -1) & np.isfinite(measured[:, 0])
        error[blind, 1:3] = 0.0
        answer = self._feedback.answer(error, far, anew)
        latched = self._doing == LATCHED
        wanted = np.concatenate([fed[:, :1], fed[:, 1:] + answer], axis=-1)
        wanted = np.where(latched[:, np.newaxis], self._form.neutral, wanted)
        command = self._form.quantise(wanted)
        def shaped(v: NDArray) -> NDArray:
            return np.reshape(v, (*self._batch, *v.shape[1:]))
        state = np.concatenate([measured, followed, np.stack(
            [far, command[:, 0], self._doing, self._ready, self._flown], axis=-1),
            command[:, 1:]], axis=-1)
        if self._settings.aborts_blind:
            self._stop(k, blind & (self._doing == FLYING), ABORTED)     # from the next step on
        return {
            'wanted': WANTED(command=shaped(command), kind=np.uint8(KIND_THRUST),
                             received=np.ones(self._batch, dtype=bool)),
            'tracking': TRACKING(planned=shaped(followed), measured=shaped(measured),
                                 feedforward=shaped(fed), range=shaped(far)),
            'craft': CRAFT(doing=shaped(self._doing.astype(np.uint8)), released=shaped(~latched),
                           plan=shaped(self._flown.astype(np.uint8))),
            'downlink': DOWNLINK(state=shaped(state))}

    def _watch_length(self, measured: NDArray) -> None:
        """Follow how fast the tether pays out: filtered as the tracker's differences are."""
        change = (measured[:, 0] - self._measured[:, 0])/self._h
        blend = self._h/(self._settings.filter_s + self._h)
        self._rate = self._rate + blend*(np.where(np.isfinite(change), change, self._rate)
                                         - self._rate)
        self._measured = np.where(np.isfinite(measured), measured, self._measured)

    # -- orders -----------------------------------------------------------------------------------

    def _obey(self, k: int, arrival: Any) -> None:
        """Do what has come up."""
        received = np.broadcast_to(arrival.received, self._batch).reshape(-1)
        kind = np.broadcast_to(arrival.kind, self._batch).reshape(-1)
        sent = np.reshape(arrival.command, (self._rows, -1))
        for row in self._store.take(received & (kind == KIND_THRUST), sent):
            self._tabulate(row)
        self._stop(k, received & (kind == KIND_ABORT), ABORTED)
        told = received & (kind == KIND_THRUST)
        self._stop(k, told & (sent[:, 0] == HOLD) & (self._doing == FLYING), BRAKING)
        going = (told & (sent[:, 0] == GO) & (sent[:, 1] == self._ready)
                 & (self._ready > self._flown) & (k >= self._opens)
                 & (k <= self._opens + round(LATE_S/self._h))
                 & ((self._doing == LATCHED) | (self._doing == STANDING)
                    | (self._doing == FLYING)))
        if going.any():
            self._doing = np.where(going, FLYING, self._doing)
            self._flown = np.where(going, self._ready, self._flown)
            self._begin = np.where(going, self._opens, self._begin)
            self._last = np.where(going, self._closes, self._last)
            self._table = np.where(going[:, np.newaxis, np.newaxis], self._next, self._table)
        over = (self._doing == FLYING) & (k > self._last)
        self._doing = np.where(over, ARRIVED, self._doing)
        age = (k - self._since)*self._h
        rested = age > np.abs(self._speed)/self._brakes + self._standing.settle_s
        self._doing = np.where((self._doing == BRAKING) & rested, STANDING, self._doing)

    def _stop(self, k: int, rows: NDArray, to: int) -> None:
        """Bring rows to rest from what is measured now; one on the latch stays there for good."""
        rows = rows & (self._doing != ABORTED)
        if not rows.any():
            return
        moving = rows & (self._doing != LATCHED)
        self._since = np.where(moving, k, self._since)
        self._from = np.where(moving[:, np.newaxis], self._measured, self._from)
        self._speed = np.where(moving, self._rate, self._speed)
        s = self._standing
        self._brakes = np.where(moving, s.abort_m_s2 if to == ABORTED else s.braking_m_s2,
                                self._brakes)
        self._doing = np.where(moving, to, self._doing)
        if to == ABORTED:                               # no plan will open that latch
            self._flown = np.where(rows, NO_PLAN, self._flown)

    def _tabulate(self, row: int) -> None:
        """Work out what the complete plan of a row says of each step."""
        p, plan = self._prepared, self._store.plan(row)
        begin = round(plan.begin_s/self._h)
        last = begin + round(plan.duration_s/self._h)
        made = reference(plan, self._spline, np.arange(begin, last + 1)*self._h, p.orbit, p.gripper,
                         p.tether, p.approach, self._settings.knows_stretch)
        more = last - begin + 1 - self._next.shape[1]
        if more > 0:
            self._table, self._next = (np.pad(table, ((0, 0), (0, more), (0, 0)))
                                       for table in (self._table, self._next))
        self._next[row, :last - begin + 1] = np.concatenate(
            [made.seen, made.inputs, made.range_m[:, np.newaxis]], axis=-1)
        self._opens[row], self._closes[row] = begin, last
        self._ready[row] = self._store.number[row]

    # -- what is followed -------------------------------------------------------------------------

    def _reference(self, k: int) -> tuple[NDArray, NDArray, NDArray]:
        """Return what is to be seen (N, 6), inputs (N, 7), and the range (N,) of step k."""
        p, n = self._prepared, self._rows
        at = np.clip(k - self._begin, 0, self._table.shape[1] - 1)
        planned = self._table[np.arange(n), at]
        flying = (self._doing == FLYING)[:, np.newaxis]
        still, fed = self._still(k)
        place = geometry.baseline(p.orbit, p.approach.baseline_m, k*self._h).place
        arrived = geometry.line(place - [p.approach.final_range_m, 0.0, 0.0])
        there = np.array([arrived.length, 0.0, 0.0, 0.0, 0.0, 0.0])
        still = np.where((self._doing == ARRIVED)[:, np.newaxis], there, still)
        idle = np.where((self._doing == LATCHED)[:, np.newaxis], self._measured, still)
        far = np.maximum(np.linalg.norm(place) - idle[:, 0], NEAREST_M)
        return (np.where(flying, planned[:, :6], idle), np.where(flying, planned[:, 6:13], fed),
                np.where(flying[:, 0], planned[:, 13], far))

    def _still(self, k: int) -> tuple[NDArray, NDArray]:
        """Return what is to be seen and the inputs of rows that brake or stand."""
        s, p, n = self._standing, self._prepared, self._rows
        age = (k - self._since)*self._h
        stops = np.abs(self._speed)/self._brakes
        t = np.minimum(age, stops)
        along = self._from[:, 0] + np.sign(self._speed)*(np.abs(self._speed)*t
                                                         - 0.5*self._brakes*t*t)
        turned = p.orbit.at(k*self._h).anomaly - p.orbit.at(0.0).anomaly
        end = np.array([0.0, turned, 0.0, 0.0, 0.0, turned])
        still = end + (self._from - end)*np.exp(-age/s.ease_s)[:, np.newaxis]
        still[:, 0] = along
        push = np.where(age < stops, p.gripper.mass_kg*self._brakes, 0.0)
        fed = np.zeros((n, 7))
        fed[:, 0] = p.tether.least_n + np.where(
            self._speed > 0.0, np.minimum(push, p.tether.abort_n), 0.0)
        fed[:, 1] = p.tether.least_n + np.where(
            self._speed > 0.0, np.minimum(p.tether.abort_n - push, 0.0), push)
        return still, fed
