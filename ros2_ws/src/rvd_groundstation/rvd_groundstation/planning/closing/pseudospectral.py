"""
A closing by the Gauss pseudospectral method: the optimum of the task.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_groundstation.planning.closing.task import ClosingParams, Ends
from rvd_groundstation.planning.plan import Plan
from rvd_groundstation.planning.problem import Path, Problem, Quantity
from rvd_groundstation.planning.transcription import Solver


@settings
class Pseudospectral:
    """Optimal states and accelerations at Gauss nodes; the solver is built once."""

    nodes: int = param(20, 'Number of nodes.', low=4, high=100)
    task: ClosingParams = wiring(ClosingParams())

    @cached_property
    def solver(self) -> Solver:
        """The solver, built at the first use."""
        return Solver(problem(self.task), self.nodes)

    def plan(self, ends: Ends, before: 'GaussReference | None' = None) -> 'GaussReference':
        """
        Return the optimal plan between two states, beginning from an earlier one if there is one.

        Raises
        ------
        BadInput
            If there is none: names the limit in the way.
        """
        return GaussReference(self.solver.solve(
            ends.initial, ends.final, self.task.duration_s,
            guess=None if before is None else before.plan, warm=before is not None))


@dataclass(frozen=True)
class GaussReference:
    """See `task.Reference`."""

    plan: Plan

    @property
    def duration_s(self) -> float:
        """Duration [s]."""
        return self.plan.duration_s

    @property
    def cost(self) -> float:
        """Cost J."""
        return self.plan.cost

    def at(self, time_s: ArrayLike) -> tuple[NDArray, NDArray]:
        """Return states (..., 6) and accelerations (..., 3) at times (...) [s]."""
        return self.plan.state_at(time_s), self.plan.control_at(time_s)


def problem(task: ClosingParams) -> Problem:
    """Return the optimal control problem of a task."""
    def rate(t, x, u, p):
        return [*x[3:], *(a - d for a, d in zip(u, task.drift(x)))]

    most, fastest = task.max_acceleration_m_s2, task.max_speed_m_s
    nearest = task.keep_out_radius_m
    paths = [
        Path('speed', lambda t, x, u, p: task.speed_squared(x), high=fastest*fastest, unit='m/s',
             scale=fastest*fastest, shown=np.sqrt),
        Path('cone of view (squared offset beyond it)', lambda t, x, u, p: task.view(x), high=0.0,
             unit='m^2')]
    if nearest > 0.0:
        paths.append(Path('distance from the target', lambda t, x, u, p: task.distance_squared(x),
                          low=nearest*nearest, unit='m', scale=nearest*nearest, shown=np.sqrt))
    return Problem(
        states=(*(Quantity(name, 'm', 1.0) for name in 'xyz'),
                *(Quantity(f'v{name}', 'm/s', 0.05) for name in 'xyz')),
        controls=tuple(Quantity(f'acceleration {name}', 'm/s^2', 0.005, -most, most)
                       for name in 'xyz'),
        rate=rate,
        running=lambda t, x, u, p: task.effort_weight*(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]),
        end=lambda x0, xf, t0, tf, p: task.cost(tf - t0, 0.0),
        paths=tuple(paths))
