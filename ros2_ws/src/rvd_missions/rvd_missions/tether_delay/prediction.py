"""
Where the gripper will be when a plan made in flight begins, by what the telemetry has told.

Filter  the observer of mission `tether` on the ground, driven by the commands that come down with
        each measurement, the baseline taken as known; the rate of the attitude is that of the plan
        and of a line through the error of the last second.
Onward  the plant of mission `tether` under the law on board and the plan that is flown, from the
        step of the newest telemetry to that in which the new plan begins: the way down, the
        solver's time and the way up. What else acts on the gripper in that time is not foreseen.
Source  ours; the paper plans once.
"""

from collections import deque
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.news import News
from rvd_dynamics.diagram.run import Run
from rvd_groundstation.planning.plan import Plan
from rvd_missions.tether import geometry
from rvd_missions.tether.commands import TetherForm
from rvd_missions.tether.inputs import Reference
from rvd_missions.tether.observer import Observer
from rvd_missions.tether.onboard import Feedback, TrackerParams
from rvd_missions.tether_delay.planning import Preparation, release
from rvd_missions.tether_delay.signals import FLYING

# standard deviations with which the filter begins at the release: place [m], speed [m/s], baseline,
# mass; the speed is left to the measurements, since an error of it is what there is to be told
SPREAD = np.array([*[0.05]*3, *[0.3]*3, 0.0, 0.01])
KNOWN_M_S = 0.02                        # standard deviation of the speed that is good enough
WINDOW_S = 1.0                          # of the line through the error of the attitude
FEWEST = 5                              # measurements for that line


class Made(NamedTuple):
    """A plan that was made in the run, and what it says of each step from its begin on."""

    number: int
    begin: int                          # step
    plan: Plan
    said: Reference
    places: NDArray                     # (n, 3) [m]


class Follower:
    """The filter of N rows; called once per step with what has come down, in order."""

    def __init__(self, preparation: Preparation, tracker: TrackerParams, tether_form: TetherForm,
                 run: Run, rows: int) -> None:
        p = self._prepared = preparation
        self._tracker, self._form, self._h = tracker, tether_form, run.step_s
        self._observer = Observer(
            replace(tracker.observer, baseline_sigma_m=0.0), p.orbit, p.gripper, p.tether,
            p.approach, run.step_s, rows)
        self._free = np.zeros(rows, dtype=bool)         # released, by what has come down
        self._told: deque = deque(maxlen=max(2, round(WINDOW_S/run.step_s)))
        self._at = 0

    def take(self, at: int, received: NDArray, state: NDArray) -> None:
        """Take telemetry states (N, 23) of step `at`; those not received are of an earlier one."""
        self._at = at
        self._observer.take(at, np.where(received[:, np.newaxis], state[:, :3], np.nan))
        flies = received & (state[:, 14] == FLYING)
        waits = ~self._free
        if waits.any():
            p = self._prepared
            there = release(p.orbit, p.approach, at*self._h)
            self._observer.state[waits] = [*there[:6], 0.0, 0.0]
            self._observer.covariance[waits] = np.diag(SPREAD*SPREAD)
            self._free |= flies
        asked = np.where(np.isfinite(state[:, 13:14]), self._commands(state), self._form.neutral)
        self._observer.sent(asked)
        self._told.append((at, flies, state))

    def news(self) -> News:
        """Return what the observer has taken against its gate in the last step."""
        return self._observer.news()

    @staticmethod
    def _commands(state: NDArray) -> NDArray:
        return np.concatenate([state[:, 13:14], state[:, 17:23]], axis=-1)

    def off(self, row: int, made: Made) -> float:
        """Return how far a row is from where its plan has it [m]; 0 until its speed is known."""
        spread = np.diagonal(self._observer.covariance[row])[3:6]
        if not self._free[row] or spread.max() > KNOWN_M_S*KNOWN_M_S:
            return 0.0
        at = min(max(self._at - made.begin, 0), len(made.places) - 1)
        return float(np.linalg.norm(self._observer.state[row, :3] - made.places[at]))

    def onward(self, row: int, made: Made, until: int) -> NDArray[np.float64]:
        """Return the state (12,) of a row at step `until`, if it flies its plan till then."""
        from rvd_missions.tether import motion
        p, h, at, said = self._prepared, self._h, self._at, made.said
        feedback = Feedback(self._tracker, p.gripper, h, (1,))
        state = self._begin(row, made)[np.newaxis]
        craft = np.array([[p.gripper.mass_kg, *p.gripper.inertia_kg_m2, p.gripper.attachment_m,
                           *[0.0]*3]])
        command = self._commands(self._told[-1][2][[row]])
        first = None
        for k in range(at, until):
            i = min(max(k - made.begin, 0), len(said.range_m) - 1)
            error = self._seen(state, command[:, 0], k) - said.seen[i]
            if k == at:
                first = error                           # that command has come down
            else:
                if k == at + 1:
                    feedback.resume(first, (error - first)/h)
                answer = feedback.answer(error, said.range_m[[i]])
                fed = said.inputs[[i]]
                command = self._form.quantise(
                    np.concatenate([fed[:, :1], fed[:, 1:] + answer], axis=-1))
            state = motion.advance(state, command, self._orbit(k), craft, h)
        return np.concatenate([state[0, :6], geometry.euler(state[0, 6:10]), state[0, 10:]])

    def _begin(self, row: int, made: Made) -> NDArray[np.float64]:
        """Return the state (13,) at the newest step: filtered, and the attitude by a line."""
        told = [(at, state[row]) for at, flies, state in self._told
                if flies[row] and int(state[row, 16]) == made.number]
        at, said = self._at, made.said
        i = min(max(at - made.begin, 1), len(said.range_m) - 1)
        planned, before = said.seen[i, 3:], said.seen[i - 1, 3:]
        error, slope = np.zeros((2, 3))
        if len(told) >= FEWEST:
            since = self._h*np.array([t - at for t, _ in told])
            off = np.array([s[3:6] - s[9:12] for _, s in told])
            slope, error = np.polyfit(since, off, 1)
        angles, rates = planned + error, (planned - before)/self._h + slope
        sf, cf, st, ct = (f(a) for a in angles[:2] for f in (np.sin, np.cos))
        body = [rates[0] - st*rates[2], cf*rates[1] + sf*ct*rates[2],
                -sf*rates[1] + cf*ct*rates[2]]
        return np.concatenate([self._observer.state[row, :6], geometry.quaternion(angles), body])

    def _seen(self, state: NDArray, tension: NDArray, k: int) -> NDArray[np.float64]:
        """Return what is measured (1, 6) without noise."""
        p = self._prepared
        target = geometry.baseline(p.orbit, p.approach.baseline_m, k*self._h).place
        sight, out = geometry.line(target - state[:, :3]), geometry.line(state[:, :3])
        return np.stack([out.length/(1.0 + tension/p.tether.stiffness_n), sight.alpha, sight.beta,
                         *geometry.euler(state[:, 6:10]).T], axis=-1)

    def _orbit(self, k: int) -> NDArray[np.float64]:
        """Return mu / r^3, and the sine and cosine of the turn, over step k (3, 3)."""
        orbit, found = self._prepared.orbit, []
        for t in (k, k + 0.5, k + 1.0):
            now = orbit.at(t*self._h)
            turn = now.anomaly - orbit.at(0.0).anomaly
            found.append([orbit.gravitational_parameter_m3_s2/now.radius**3, np.sin(turn),
                          np.cos(turn)])
        return np.array(found)
