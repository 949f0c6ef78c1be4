"""
Is a plan what it says? Checks that do not trust the solver.

The optimum itself is checked without costates, by mesh refinement: solved again on more nodes, the
cost must stay.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rvd_groundstation.planning.plan import Plan
from rvd_groundstation.planning.transcription import Solver

STEPS = 4000                            # of Runge-Kutta over a plan


@dataclass(frozen=True)
class PlanReport:
    """
    What was found; errors of states are in units of each state's scale.

    Attributes
    ----------
    defect : float
        Greatest error of the dynamics at the nodes and of the quadrature to the end.
    bound : float
        Greatest violation of a bound or constraint at the nodes; 0: none.
    flown : ndarray, shape (n,)
        End state when the dynamics are integrated under the plan's controls, minus the planned
        one, in the states' own units.
    cost, refined_cost : float
        Of the plan, and of one on more nodes; NaN where none was solved.
    """

    defect: float
    bound: float
    flown: NDArray
    cost: float
    refined_cost: float = np.nan

    @property
    def refinement(self) -> float:
        """How far the cost moves on more nodes."""
        return abs(self.refined_cost - self.cost)


def report(solver: Solver, plan: Plan, parameters: tuple = (),
           refined: Plan | None = None) -> PlanReport:
    """Return the report on a plan of this solver; `refined` is the same plan on more nodes."""
    problem, g, half = solver.problem, plan.gauss, 0.5*plan.duration_s
    x_scale = np.array([q.scale for q in problem.states])
    mapped = solver.functions.map(plan.count)
    rate, _, paths = (np.asarray(v) for v in mapped(
        plan.node_s, plan.states[1:-1].T, plan.controls.T,
        np.tile(np.reshape(parameters, (-1, 1)), plan.count)))
    slope = half*rate.T/x_scale
    states = plan.states/x_scale
    defect = max(np.abs(g.derivative @ states[:-1] - slope).max(),
                 np.abs(states[-1] - states[0] - g.weights @ slope).max())
    over = [_outside(plan.states[1:-1], problem.states), _outside(plan.controls, problem.controls)]
    if problem.paths:
        over.append(_outside(paths.T*np.array([c.scale for c in problem.paths]), problem.paths))
    return PlanReport(defect, max(over), _flown(solver, plan, parameters) - plan.states[-1],
                      plan.cost, np.nan if refined is None else refined.cost)


def _outside(values: NDArray, bounded: tuple) -> float:
    """Return how far values (K, n) leave their bounds, in units of the scales; 0: nowhere."""
    low, high, scale = (np.array([getattr(b, name) for b in bounded])
                        for name in ('low', 'high', 'scale'))
    return max(0.0, float((np.maximum(low - values, values - high)/scale).max()))


def _flown(solver: Solver, plan: Plan, parameters: tuple) -> NDArray:
    """Integrate the dynamics under the plan's controls, by classical Runge-Kutta."""
    import casadi as ca
    n, m, h = plan.states.shape[1], plan.controls.shape[1], plan.duration_s/STEPS
    x, t, q = ca.SX.sym('x', n), ca.SX.sym('t'), ca.DM(list(parameters))
    u = ca.SX.sym('u', m, 3)                    # at the start, in the middle, at the end of a step

    def rate(state: ca.SX, part: int) -> ca.SX:
        return solver.functions(t + 0.5*h*part, state, u[:, part], q)[0]

    k1 = rate(x, 0)
    k2 = rate(x + 0.5*h*k1, 1)
    k3 = rate(x + 0.5*h*k2, 1)
    step = ca.Function('step', [x, t, u], [
        x + h/6.0*(k1 + 2.0*(k2 + k3) + rate(x + h*k3, 2))])
    at = plan.begin_s + 0.5*h*np.arange(2*STEPS + 1)
    controls = plan.control_at(at)
    held = np.stack([controls[:-2:2], controls[1::2], controls[2::2]], axis=1)
    states = step.mapaccum(STEPS)(plan.states[0], at[:-2:2], held.reshape(-1, m).T)
    return np.asarray(states)[:, -1]
