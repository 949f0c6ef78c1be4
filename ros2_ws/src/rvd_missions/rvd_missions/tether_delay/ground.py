"""
The ground segment: plans, orders and what the telemetry tells; and a stand-in for the operator.

A plan is asked for when GO is ordered and none is under way: from the latch, or from where the
gripper stands after a HOLD. It is used `solve_s` after that, whether or not the solver took so
long, so that a run does not depend on the machine; meanwhile a thread solves it. It begins on a
full second, late enough to be on board by then.

After a HOLD only a gripper that stands is planned for: its place is then the same however old the
telemetry is, so that the delay costs time, but not accuracy. With `replan_m` one under way that has
strayed from its plan is planned for too, from where it is predicted to be when the new plan begins
(`prediction`); it flies its plan on until then.
"""

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.news import News
from rvd_dynamics.diagram.run import Legs, Run
from rvd_groundstation.planning.plan import Plan
from rvd_missions.tether import geometry
from rvd_missions.tether.commands import TetherForm
from rvd_missions.tether.inputs import InputParams, reference
from rvd_missions.tether.onboard import TrackerParams
from rvd_missions.tether_delay.planning import Preparation, turn, turned
from rvd_missions.tether_delay.prediction import Follower, Made
from rvd_missions.tether_delay.settings import DirectorParams, GroundParams
from rvd_missions.tether_delay.signals import (
    ABORTED, COMMAND, DECISION, FLYING, GO, HOLD, LATCHED, ORDER_WIDTH, SITUATION, STANDING,
    TELEMETRY, UPLINK, WAIT)

RETRY_S = 10.0                          # from a refused plan in flight until another is asked for
LATER = 10                              # seconds by which its begin is put off, at most


class FlightDirector:
    """
    A scripted stand-in for the operator, who sees what mission control shows.

    GO at its time; HOLD when the shown distance falls to `hold_range_m`; GO again when the gripper
    has been seen to stand for `look_s`; ABORT at `abort_range_m`. Each takes a reaction time.
    """

    DECISIONS = 4

    def __init__(self, settings: DirectorParams, run: Run, reaction: NDArray, batch: tuple) -> None:
        self._settings, self._h, self._batch = settings, run.step_s, batch
        drawn = np.reshape(reaction, (-1, self.DECISIONS))
        wait = settings.reaction_s*np.exp(settings.reaction_spread*drawn)
        self._wait = np.maximum(np.round(wait/run.step_s), 0).astype(int)
        self._seen = np.full(self._wait.shape, -1)              # step in which each cause was seen

    def step(self, k: int, situation: Any) -> dict[str, Any]:
        """Return what is ordered in step k; `situation` is of the step before."""
        s = self._settings
        shown = np.reshape(situation.ahead if s.predicts else situation.range, -1)
        doing = np.reshape(situation.doing, -1)
        near = np.where(np.isfinite(shown) & (doing == FLYING), shown, np.inf)
        stands = (doing == STANDING) & (self._seen[:, 1] >= 0)
        causes = (np.full(len(doing), s.go_s > 0.0 and k*self._h >= s.go_s), near <= s.hold_range_m,
                  stands, near <= s.abort_range_m)
        for i, cause in enumerate(causes):
            self._seen[:, i] = np.where((self._seen[:, i] < 0) & cause, k, self._seen[:, i])
        since = k - self._seen - self._wait
        done = (self._seen >= 0) & (since >= 0)
        look = round(s.look_s/self._h)
        again = done[:, 2] & (since[:, 2] >= look)
        order = np.where(done[:, 1] & ~again, HOLD, np.where(done[:, 0], GO, WAIT))
        return {'decision': DECISION(order=order.astype(np.uint8).reshape(self._batch),
                                     abort=done[:, 3].reshape(self._batch))}


class Row:
    """What the ground knows of one run: the plan it made last, and what it waits for."""

    def __init__(self) -> None:
        self.number = 0                 # of the plan that goes up; 0: none yet
        self.points: NDArray | None = None      # (K + 2, 24) of that plan, as they go up
        self.first = 0                  # step in which the first point goes up
        self.made: Made | None = None   # that plan, and the one that was flown before it began
        self.before: Made | None = None
        self.asked: tuple[int, Future] | None = None    # step from which the plan is used
        self.under_way = False          # whether it was asked for in flight
        self.rests = 0                  # step until which none is asked for in flight
        self.refused = 0
        self.void = False               # the plan that goes up is not to be flown any more
        self.seen: list[NDArray] = []   # where it stood, turned back to the start


class MissionControl:
    """Fires on each telemetry frame, empty ones too."""

    def __init__(self, preparation: Preparation, ground_work: GroundParams, inputs: InputParams,
                 tether_form: TetherForm, tracker: TrackerParams, run: Run, legs: Legs,
                 batch: tuple) -> None:
        self._prepared, self._work, self._batch = preparation, ground_work, batch
        self._form, self._spline = tether_form, inputs.spline
        self._legs, self._h = legs, run.step_s
        self._rows = [Row() for _ in range(int(np.prod(batch, dtype=int)))]
        self._state = np.reshape(TELEMETRY.initial(batch).state, (len(self._rows), -1))
        self._at = np.zeros(len(self._rows), dtype=int)     # step that the state is of
        points = preparation.planner.nodes + 2
        # from order to begin: the solver, one turn of the plan's points, the way up, some rest
        self._ahead = (round(ground_work.solve_s/run.step_s) + points + legs.forward
                       + round(ground_work.lead_s/run.step_s))
        self._second = max(1, round(1.0/run.step_s))
        self._solver = ThreadPoolExecutor(1, 'planner')
        self._stretched = tracker.knows_stretch
        self._follower = Follower(preparation, tracker, tether_form, run, len(
            self._rows)) if ground_work.replan_m > 0.0 else None

    def step(self, k: int, telemetry: Any, decision: Any, control: Control) -> dict[str, Any]:
        """Return the situation of step k, and the order and the point of a plan that go up."""
        received = np.reshape(telemetry.received, -1)
        state = np.reshape(telemetry.state, (len(self._rows), -1))
        self._state = np.where(received[:, np.newaxis], state, self._state)
        self._at = np.where(received, max(k - self._legs.back, 0), self._at)
        if self._follower is not None and k >= self._legs.back:
            self._follower.take(k - self._legs.back, received, self._state)
        wanted = np.reshape(decision.order, -1)
        if control.mode in ('hold', 'go'):
            wanted = np.full_like(wanted, HOLD if control.mode == 'hold' else GO)
        abort = np.reshape(decision.abort, -1) | control.abort
        sent, ahead, fed = np.zeros((len(self._rows), ORDER_WIDTH)), *(
            np.full((len(self._rows), *shape), value) for shape, value in (
                ((), np.nan), ((7,), 0.0)))
        fed[:] = self._form.neutral
        for i, row in enumerate(self._rows):
            self._work_on(i, k, int(wanted[i]), bool(received[i]))
            self._fill(row, k, int(wanted[i]), sent[i])
            acts = k + self._legs.forward
            made = row.before if row.before and acts < row.made.begin else row.made
            if made and made.begin <= acts and not row.void:
                at = min(acts - made.begin, len(made.places) - 1)
                ahead[i], fed[i] = made.said.range_m[at], made.said.inputs[at]
        kind = np.where(abort, np.uint8(KIND_ABORT), np.uint8(KIND_THRUST)).reshape(self._batch)
        return {'command': COMMAND(command=self._shaped(self._form.quantise(fed)), kind=kind),
                'uplink': UPLINK(command=self._shaped(sent), kind=kind,
                                 expedited=np.bool_(control.abort)),
                'situation': self._situation(ahead)}

    def news(self) -> News:
        """Return what the filter of the gripper's flight has taken against its gate."""
        return [] if self._follower is None else self._follower.news()

    def _shaped(self, v: NDArray) -> NDArray:
        return np.reshape(v, (*self._batch, *v.shape[1:]))

    # -- plans ------------------------------------------------------------------------------------

    def _work_on(self, i: int, k: int, order: int, received: bool) -> None:
        """Follow what is done on board; ask for a plan where one is wanted."""
        row, state, at = self._rows[i], self._state[i], int(self._at[i])
        if not np.isfinite(state[14]):
            doing = LATCHED                             # nothing has come down yet: as it began
        else:
            doing = int(state[14])
        if order == HOLD:
            row.void = row.void or doing != LATCHED
            if row.under_way:
                row.asked, row.under_way = None, False
        if doing != STANDING:
            row.seen.clear()
        elif received:
            row.seen.append(self._place(state, at))
        if row.asked is not None:
            self._use(row, k)
            return
        from_latch = doing == LATCHED and (row.number == 0 or self._missed(row, k))
        onward = doing == STANDING and (row.void or self._missed(row, k))
        if order == GO and (from_latch or onward):
            begin = -(-(k + self._ahead)//self._second)*self._second
            begin_s, made = begin*self._h, self._prepared
            if doing == LATCHED:
                call = made.from_latch, begin_s
            else:
                call = made.onward, self._start(row, begin_s), begin_s
            row.asked = (k + round(self._work.solve_s/self._h), self._solver.submit(*call))
        elif order == GO and doing == FLYING:
            self._in_flight(i, k, int(state[16]))

    def _in_flight(self, i: int, k: int, flown: int) -> None:
        """Ask for a plan in flight where the gripper has strayed from the one that it flies."""
        row = self._rows[i]
        if self._follower is None or row.void or k < row.rests or row.made is None:
            return
        made = row.made
        if made.number != flown:                        # on its way, or never begun
            if not self._missed(row, k) or row.before is None or row.before.number != flown:
                return
            made = row.before
        if self._follower.off(i, made) < self._work.replan_m:
            return
        first = -(-(k + self._ahead)//self._second)*self._second
        # not where the plan before is at a bound: there is no room, or only for a detour
        for begin in range(first, first + (LATER + 1)*self._second, self._second):
            if made.plan.end_s - begin*self._h < self._work.least_s:
                break
            start = self._follower.onward(i, made, begin)
            if self._prepared.within(start, begin*self._h):
                row.under_way = True
                row.asked = (k + round(self._work.solve_s/self._h), self._solver.submit(
                    self._prepared.in_flight, start, begin*self._h, made.plan))
                return
        row.rests = k + self._second

    def _missed(self, row: Row, k: int) -> bool:
        """Return whether the plan should have begun long ago, and the craft did not begin it."""
        return row.number > 0 and k - self._legs.loop > row.made.begin + 2*self._second

    def _use(self, row: Row, k: int) -> None:
        """Send a plan up from the step on for which it was asked."""
        ready, solving = row.asked
        if k < ready:
            return
        row.asked, under_way, row.under_way = None, row.under_way, False
        try:
            plan: Plan = solving.result()
        except BadInput:
            if row.number == 0:
                raise                                   # there is no approach at all
            row.refused += 1                            # it flies or stands on
            row.void, row.rests = not under_way, k + round(RETRY_S/self._h)
            return
        p, points = self._prepared, len(plan.states)
        row.number, row.first, row.void = row.number + 1, k, False
        begin = round(plan.begin_s/self._h)
        times = self._h*(begin + np.arange(round(plan.duration_s/self._h) + 1))
        said = reference(plan, self._spline, times, p.orbit, p.gripper, p.tether, p.approach,
                         self._stretched)
        flown = row.before if under_way and self._missed(row, k) else row.made
        row.before = flown if under_way else None
        row.made = Made(row.number, begin, plan, said, plan.state_at(
            np.clip(times, plan.begin_s, plan.end_s))[:, :3])
        row.points = np.zeros((points, ORDER_WIDTH))
        row.points[:, 1], row.points[:, 2] = row.number, np.arange(points)
        row.points[:, 3], row.points[:, 4] = plan.begin_s, plan.end_s
        row.points[:, 5:17], row.points[1:-1, 17:] = plan.states, plan.controls

    def _fill(self, row: Row, k: int, order: int, sent: NDArray) -> None:
        """Write the frame of a row: the order in force, and the next point of its plan."""
        if row.points is not None:
            sent[:] = row.points[(k - row.first) % len(row.points)]
        sent[0] = WAIT if order == GO and (row.void or row.number == 0) else order

    def _place(self, state: NDArray, at: int) -> NDArray[np.float64]:
        """Return place and attitude (6,) that a telemetry state tells, turned back to the start."""
        p, t = self._prepared, at*self._h
        length, alpha, beta = state[:3]
        d = geometry.baseline(p.orbit, p.approach.baseline_m, t).place
        x = np.array([np.cos(beta)*np.cos(alpha), np.cos(beta)*np.sin(alpha), np.sin(beta)])
        # |D - l0 x| = l1
        l0 = d @ x - np.sqrt(max(length*length - d @ d + (d @ x)**2, 0.0))
        angle = turn(p.orbit, t)
        return np.concatenate([turned(-angle, d - l0*x), state[3:6] - [0.0, 0.0, angle]])

    def _start(self, row: Row, begin_s: float) -> NDArray[np.float64]:
        """Return the state (12,) of a gripper that stands, at the begin of a plan."""
        orbit = self._prepared.orbit
        angle, rate = turn(orbit, begin_s), float(orbit.at(begin_s).rate)
        stood = np.mean(row.seen, axis=0)
        place = turned(angle, stood[:3])
        return np.concatenate([place, [-rate*place[1], rate*place[0], 0.0],
                               stood[3:] + [0.0, 0.0, angle], [0.0, 0.0, rate]])

    # -- what is shown ----------------------------------------------------------------------------

    def _situation(self, ahead: NDArray) -> Any:
        """Return what the newest telemetry tells, as of the step in which it was measured."""
        p, state = self._prepared, self._state
        target = np.stack([geometry.baseline(p.orbit, p.approach.baseline_m, at*self._h).place
                           for at in self._at])
        alpha, beta = state[:, 1], state[:, 2]
        towards = np.stack([np.cos(beta)*np.cos(alpha), np.cos(beta)*np.sin(alpha), np.sin(beta)],
                           axis=-1)
        attitude = geometry.quaternion(state[:, 3:6])
        far = state[:, 12]
        followed = np.stack([np.cos(state[:, 8])*np.cos(state[:, 7]),
                             np.cos(state[:, 8])*np.sin(state[:, 7]), np.sin(state[:, 8])], axis=-1)
        doing = np.where(np.isfinite(state[:, 14]), state[:, 14], LATCHED)
        rows = self._rows
        parts = {
            'gripper': target - far[:, np.newaxis]*towards,
            'planned': target - far[:, np.newaxis]*followed, 'target': target,
            'attitude': attitude, 'error': state[:, :6] - state[:, 6:12], 'range': far,
            'sight_angle': geometry.sight_angle(attitude, towards), 'tension': state[:, 13],
            'ahead': np.where(np.isfinite(ahead) & (doing != ABORTED), ahead, far),
            'doing': doing.astype(np.uint8),
            'plans': np.array([row.number for row in rows], dtype=np.uint8),
            'refused': np.array([row.refused for row in rows], dtype=np.uint8)}
        return SITUATION(**{name: self._shaped(v) for name, v in parts.items()})
