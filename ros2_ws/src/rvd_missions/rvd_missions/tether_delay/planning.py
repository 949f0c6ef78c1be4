"""
Plans that begin at any time: from the latch, or from where the gripper stands.

Frame   I of the start of the run. The target's orbit turns the baseline in it, so a plan depends on
        when it begins, a little.
"""

from dataclasses import dataclass, field
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.run import Run
from rvd_groundstation.planning.plan import Plan, straight
from rvd_missions.tether import geometry, optimum
from rvd_missions.tether.settings import ApproachParams, OrbitParams
from rvd_missions.tether_delay.settings import GroundParams

MOST_ROLL = 0.5                         # [rad] the law on board takes Euler angles for body axes
WITHIN = 0.95                           # of the bounds of the plan's angles, where one may begin


@dataclass(frozen=True)
class Preparation(optimum.Preparation):
    """
    What is known before the run.

    `plan` is the one for a release at its start, which is shown and whose defect is judged; those
    that are flown are made in the run. The run takes as long as its `timeout_s`.
    """

    ground_work: GroundParams = field(default_factory=GroundParams)

    def last_step(self, run: Run) -> int:
        """Return the last step: the operator decides how long an approach takes."""
        return run.last_step

    @cached_property
    def _all(self) -> tuple:
        return self.orbit, self.gripper, self.tether, self.approach, self.planner

    def from_latch(self, begin_s: float) -> Plan:
        """Return the plan for a release at a time; BadInput if there is none."""
        return _from_latch(self._all, begin_s)

    def onward(self, start: NDArray, begin_s: float) -> Plan:
        """Return a plan from a state (12,) at a time [s], at rest or nearly; BadInput if none."""
        work = self.ground_work
        goal = geometry.goal(self.orbit, self.approach, begin_s)
        way = float(np.linalg.norm(goal[:3] - start[:3]))
        took = max(work.least_s, way/work.speed_m_s)
        return _solved(self._all, start, begin_s, (took, took))


    def in_flight(self, start: NDArray, begin_s: float, before: Plan) -> Plan:
        """
        Return a plan from a state (12,) under way at a time [s] to the end of the plan before.

        Raises
        ------
        BadInput
            If there is none, or only one that rolls further than the law on board follows.
        """
        took = before.end_s - begin_s
        found = optimum.solver(*self._all).solve(start, optimum.ENDS, (took, took), begin_s,
                                                 guess=rest_of(before, begin_s, start))
        roll = float(np.abs(found.states[:, 6]).max())
        if roll > MOST_ROLL:
            raise BadInput(f'plan must roll by at most {MOST_ROLL:g} rad, and rolls by {roll:.3g}')
        return found

    def within(self, start: NDArray, begin_s: float) -> bool:
        """Say whether sight, pitch and yaw of a state (12,) leave a plan from there some room."""
        place = geometry.baseline(self.orbit, self.approach.baseline_m, begin_s).place
        sight = geometry.line(place - start[:3])
        angles = np.abs([sight.alpha, sight.beta, start[7], start[8]])
        return bool((angles <= WITHIN*self.approach.angle_limit).all())


def rest_of(plan: Plan, begin_s: float, start: NDArray) -> Plan:
    """Return what is left of a plan from a time on [s], on as many nodes, from a state (12,)."""
    rest = Plan(begin_s, plan.end_s, plan.states, plan.controls)
    return Plan(begin_s, plan.end_s, np.concatenate(
        [start[np.newaxis], plan.state_at(rest.state_s[1:])]), np.clip(
            plan.control_at(rest.node_s), plan.controls.min(axis=0), plan.controls.max(axis=0)))


@lru_cache(maxsize=64)
def _from_latch(parts: tuple, begin_s: float) -> Plan:
    orbit, *_, approach, _ = parts
    return _solved(parts, release(orbit, approach, begin_s), begin_s, approach.duration_s)


def _solved(parts: tuple, start: NDArray, begin_s: float, duration: tuple[float, float]) -> Plan:
    orbit, gripper, tether, approach, planner = parts
    took = 0.5*sum(duration)
    goal = geometry.goal(orbit, approach, begin_s + took)
    speed = np.linalg.norm(goal[:3] - start[:3])/took
    guess = straight(start, goal, [np.clip(gripper.mass_kg*speed/took, tether.least_n,
                                           tether.most_n), *np.zeros(6)],
                     begin_s, begin_s + took, planner.nodes)
    return optimum.solver(*parts).solve(start, optimum.ENDS, duration, begin_s, guess=guess)


def turn(orbit: OrbitParams, time_s: float) -> float:
    """Return the angle nu - nu0 by which the baseline has turned in I [rad]."""
    return float(orbit.at(time_s).anomaly - orbit.at(0.0).anomaly)


def turned(angle: float, vectors: NDArray) -> NDArray[np.float64]:
    """Return vectors (..., 3) turned by `angle` about z."""
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = np.moveaxis(np.asarray(vectors, dtype=float), -1, 0)
    return np.stack([c*x - s*y, s*x + c*y, z], axis=-1)


def release(orbit: OrbitParams, approach: ApproachParams, time_s: float) -> NDArray[np.float64]:
    """Return the planned state (12,) of a release at a time: that of the start, turned along."""
    start = approach.initial(orbit.at(0.0).rate)
    angle = turn(orbit, time_s)
    return np.concatenate([turned(angle, start[:3]), turned(angle, start[3:6]),
                           start[6:9] + [0.0, 0.0, angle], start[9:]])
