"""
The plan of the closing: made on the ground, sent up in packets, kept on board.

A plan goes up as states at equal times, KNOTS of them, one in each packet: number of the plan,
index, time [s] of the run, place [m] and velocity [m/s] of the craft's centre in LVLH. The packets
go round and round, so that one that is lost costs a round and no plan. Between two knots the way
is the cubic through both places and velocities, which is within 0.1 um of the plans themselves.

`planner: velocity_profile` needs none of this: the craft makes its profile itself.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import choice, param, settings
from rvd_groundstation.planning.closing.polynomial import Polynomial
from rvd_groundstation.planning.closing.pseudospectral import Pseudospectral
from rvd_groundstation.planning.closing.task import (
    ClosingLimits, ClosingParams, Ends, margins, Reference)
from rvd_missions.docking.markers import CHASER_PORT, TARGET_PORT
from rvd_missions.docking.settings import Aim, LATEST_S, OrbitParams, Start

Array = NDArray[np.float64]
KNOTS = 64
# By how much a limit, which holds at the nodes, may be broken between them: a part of speed or
# acceleration, and [m].
BETWEEN, BETWEEN_M = 0.05, 0.01
PACKET = 9                              # numbers in a packet
TOUCHING_M = float(CHASER_PORT[0] - TARGET_PORT[0])     # distance of the centres then


@settings
class OnBoard:
    """The velocity profile has its settings in `docking_controller`."""


PlannerParams = choice(
    'PlannerParams', 'planner', {'velocity_profile': OnBoard, 'polynomial': Polynomial,
                                 'pseudospectral': Pseudospectral}, 'velocity_profile',
    'Planner of the closing: velocity_profile on board, the others on the ground.')


@settings
class ClosingTask(ClosingLimits):
    """What a plan of the ground may do, what it costs, and when it is made anew."""

    replan_s: float = param(
        0.0, 'Instant at which the ground plans anew from what it knows of the craft; 0: never '
        '[s].', low=0.0, high=LATEST_S)


@dataclass(frozen=True)
class Preparation:
    """The plan of a scenario from its nominal start, made when it is first asked for."""

    planner: Any                        # PlannerParams
    closing: ClosingTask
    orbit: OrbitParams
    start: Start
    aim: Aim

    @property
    def on_ground(self) -> bool:
        """Whether the ground makes the plan."""
        return self.planner.planner != 'velocity_profile'

    @property
    def maker(self) -> Any:
        """The planner at work, which has its solver; kept."""
        return maker(self.planner.selected, self.closing, self.orbit, self.aim)

    @property
    def nominal(self) -> Reference:
        """The plan from the nominal start; BadInput if there is none."""
        return nominal(self.planner.selected, self.closing, self.orbit, self.start, self.aim)

    def anew(self, state: ArrayLike) -> Reference:
        """Return the plan from a state (6,) in LVLH, begun from the nominal one."""
        return self.maker.plan(Ends(state, goal(self.aim)), self.nominal)


def goal(aim: Aim) -> Array:
    """Return the state (6,) of the craft's centre in which it hovers."""
    return np.array([-TOUCHING_M - aim.distance_m, 0.0, 0.0, 0.0, 0.0, 0.0])


@lru_cache(maxsize=8)
def maker(planner: Any, closing: ClosingTask, orbit: OrbitParams, aim: Aim) -> Any:
    """Return a planner for the task of a scenario; the last eight are kept, with their solvers."""
    limits = {name: getattr(closing, name) for name in ClosingLimits.__dataclass_fields__}
    return replace(planner, task=ClosingParams(
        **limits, orbit_radius_m=orbit.radius_m, nominal_s=aim.nominal_s,
        gravitational_parameter_m3_s2=orbit.gravitational_parameter_m3_s2,
        port_to_centres_m=TOUCHING_M))


@lru_cache(maxsize=8)
def nominal(planner: Any, closing: ClosingTask, orbit: OrbitParams, start: Start,
            aim: Aim) -> Reference:
    """
    Return the plan from rest at the nominal start; the last eight are kept.

    Raises
    ------
    BadInput
        If there is none, or it breaks a limit between the points looked at while it was made:
        names the constraint in the way.
    """
    made = maker(planner, closing, orbit, aim)
    allowed = np.array([BETWEEN*closing.max_speed_m_s, BETWEEN*closing.max_acceleration_m_s2,
                        BETWEEN_M, BETWEEN_M])
    try:
        found = made.plan(Ends([*start.position_m, 0.0, 0.0, 0.0], goal(aim)))
        kept = margins(made.task, found)
        if (np.array(kept) < -allowed).any():
            kept.check(made.task)
    except BadInput as error:
        raise BadInput(f'planner: {error}') from None
    return found


def planned(planner: Any, closing: ClosingTask, orbit: OrbitParams, start: Start,
            aim: Aim) -> Preparation:
    """Return the preparation of a scenario; BadInput for an aim that the ground cannot plan."""
    made = Preparation(planner, closing, orbit, start, aim)
    low, high = closing.duration_s
    if made.on_ground and not low <= aim.nominal_s <= high:
        raise BadInput(f'aim.nominal_s must be between {low:g} and {high:g}, closing.duration_s, '
                       f'got {aim.nominal_s:g}')
    return made


# -- packets --------------------------------------------------------------------------------------

def packets(plan: Reference, begin_s: float, number: int) -> Array:
    """Return a plan as packets (KNOTS, PACKET); it begins at an instant [s] of the run."""
    since = np.linspace(0.0, plan.duration_s, KNOTS)
    state, _ = plan.at(since)
    index = np.arange(KNOTS, dtype=float)
    return np.column_stack([np.full(KNOTS, float(number)), index, begin_s + since, state])


class Memory:
    """
    Plans of N rows on board, as they come in packets.

    A plan counts from when all of its packets are there; until then the one before it does.
    """

    def __init__(self, rows: int) -> None:
        self._number = np.zeros(rows, dtype=np.int64)           # of the plan that is coming in
        self._got = np.zeros((rows, KNOTS), dtype=bool)
        self._coming = np.full((rows, KNOTS, PACKET - 2), np.nan)
        self._knots = np.full((rows, KNOTS, PACKET - 2), np.nan)
        self._waiting = np.ones(rows, dtype=bool)

    def take(self, packet: Array, received: NDArray[np.bool_]) -> None:
        """Take the packets (N, PACKET) that came in, of the rows in which one did (N,)."""
        number = np.where(received, packet[:, 0], 0.0).astype(np.int64)
        newer = number > self._number
        if newer.any():
            self._number = np.where(newer, number, self._number)
            self._got[newer] = False
            self._waiting = self._waiting | newer
        useful = self._waiting & (number == self._number) & received
        if not useful.any():
            return
        rows = np.flatnonzero(useful)
        index = packet[rows, 1].astype(np.int64)
        self._coming[rows, index] = packet[rows, 2:]
        self._got[rows, index] = True
        whole = rows[self._got[rows].all(axis=-1)]
        self._knots[whole] = self._coming[whole]
        self._waiting[whole] = False

    def at(self, t: float) -> tuple[Array, Array]:
        """Return place and velocity (N, 3) at an instant [s]; NaN where there is no plan yet."""
        begin, end = self._knots[:, 0, 0], self._knots[:, -1, 0]
        step = (end - begin)/(KNOTS - 1)
        past = np.nan_to_num((np.clip(t, begin, end) - begin)/step)
        part = np.minimum(past.astype(np.int64), KNOTS - 2)
        rows = np.arange(len(part))
        first, second = self._knots[rows, part, 1:], self._knots[rows, part + 1, 1:]
        s, h = (past - part)[:, None], step[:, None]
        r0, v0, r1, v1 = first[:, :3], h*first[:, 3:], second[:, :3], h*second[:, 3:]
        change = r1 - r0
        b, c = 3.0*change - 2.0*v0 - v1, v0 + v1 - 2.0*change
        place = r0 + s*(v0 + s*(b + s*c))
        return place, (v0 + s*(2.0*b + 3.0*s*c))/h


def shaped(rows: Sequence[Array], batch: tuple) -> Array:
    """Return packets of each row (KNOTS, PACKET) as (..., KNOTS, PACKET)."""
    return np.stack(rows).reshape((*batch, KNOTS, PACKET))
