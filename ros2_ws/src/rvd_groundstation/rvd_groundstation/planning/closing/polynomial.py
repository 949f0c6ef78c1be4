"""
A closing by one polynomial in time for each axis, optimised by SLSQP.

Each axis is the cubic through both ends plus s^2 (1 - s)^2 times a free polynomial, s = t / tf, so
that the ends are met whatever the coefficients are. Acceleration follows from the motion. Gradients
are exact (casadi); the effort is summed, and limits hold, at Gauss nodes.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import Polynomial as Poly
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_groundstation.planning.closing.task import ClosingParams, Ends, margins
from rvd_groundstation.planning.gauss import gauss

NODES = 30
BUMP = Poly([0.0, 0.0, 1.0, -2.0, 1.0])                 # s^2 (1 - s)^2
# Hermite's cubics in s: value and slope at the start, value and slope at the end
CUBICS = (Poly([1.0, 0.0, -3.0, 2.0]), Poly([0.0, 1.0, -2.0, 1.0]),
          Poly([0.0, 0.0, 3.0, -2.0]), Poly([0.0, 0.0, -1.0, 1.0]))


@settings
class Polynomial:
    """Order of the polynomial, and when the search ends."""

    order: int = param(7, 'Order of the polynomial of each axis.', low=4, high=15)
    tolerance: float = param(1e-12, 'Change of the cost at which the search ends.', above=0.0)
    task: ClosingParams = wiring(ClosingParams())

    @property
    def basis(self) -> list[Poly]:
        """Hermite's cubics, then s^2 (1 - s)^2 times each power."""
        return [*CUBICS, *(BUMP*Poly.basis(i) for i in range(self.order - 3))]

    def plan(self, ends: Ends, before: 'PolynomialReference | None' = None
             ) -> 'PolynomialReference':
        """
        Return the best polynomial between two states, beginning from an earlier one if given.

        Raises
        ------
        BadInput
            If none is found that keeps the limits: names the one in the way.
        """
        from scipy.optimize import minimize
        given = np.concatenate([ends.initial, ends.final])
        low, high = self.task.duration_s
        free = 3*(self.order - 3)
        start = (np.concatenate([np.zeros(free), [np.clip(self.task.nominal_s, low, high)]])
                 if before is None else before.found)
        cost, slope, limits, limits_slope = (
            lambda z, f=f: np.squeeze(np.asarray(f(z, given))) for f in self._functions)
        made = minimize(
            cost, start, jac=slope, method='SLSQP', bounds=[(None, None)]*free + [(low, high)],
            constraints={'type': 'ineq', 'fun': limits, 'jac': limits_slope},
            options={'maxiter': 500, 'ftol': self.tolerance})
        reference = PolynomialReference(self, ends, made.x, float(made.fun))
        if not made.success:
            margins(self.task, reference).check(self.task)
            raise BadInput(f'no polynomial found: SLSQP says {made.message!r}')
        return reference

    @cached_property
    def _functions(self) -> tuple:
        """Cost, its gradient, limits (not negative where kept), and theirs, by casadi."""
        import casadi as ca
        task, g = self.task, gauss(NODES)
        free = 3*(self.order - 3)
        z, given = ca.SX.sym('z', free + 1), ca.SX.sym('given', 12)
        tf, s = z[-1], 0.5*(g.nodes + 1.0)
        at, slope, bend = (self._motion(d, s, z, given, tf) for d in (0, 1, 2))
        x = [*at, *(v/tf for v in slope)]
        accel = [b/(tf*tf) + d for b, d in zip(bend, task.drift(x))]
        effort = 0.5*tf*sum(ca.dot(g.weights, a*a) for a in accel)
        cost, most = task.cost(tf, effort), task.max_acceleration_m_s2
        limits = ca.vertcat(
            *(1.0 - a/most for a in accel), *(1.0 + a/most for a in accel),
            1.0 - task.speed_squared(x)/task.max_speed_m_s**2, -task.view(x),
            task.distance_squared(x) - task.keep_out_radius_m**2)
        return tuple(ca.Function('f', [z, given], [f]) for f in (
            cost, ca.gradient(cost, z), limits, ca.densify(ca.jacobian(limits, z))))

    def _motion(self, derivative: int, s: Any, z: Any, given: Any, tf: Any) -> list:
        """Return a derivative by s of each axis at places s (m,): casadi or numpy."""
        values = [(b.deriv(derivative) if derivative else b)(s) for b in self.basis]
        more = self.order - 3
        motion = []
        for i in range(3):
            factors = [given[i], given[3 + i]*tf, given[6 + i], given[9 + i]*tf,
                       *(z[more*i + j] for j in range(more))]
            motion.append(sum(f*v for f, v in zip(factors, values)))
        return motion


@dataclass(frozen=True)
class PolynomialReference:
    """See `task.Reference`."""

    planner: Polynomial
    ends: Ends
    found: NDArray                      # coefficients and duration
    cost: float

    @property
    def duration_s(self) -> float:
        """Duration [s]."""
        return float(self.found[-1])

    def at(self, time_s: ArrayLike) -> tuple[NDArray, NDArray]:
        """Return states (..., 6) and accelerations (..., 3) at times (...) [s]."""
        tf = self.duration_s
        s = np.asarray(time_s, dtype=float)/tf
        given = np.concatenate([self.ends.initial, self.ends.final])
        at, slope, bend = (self.planner._motion(d, s, self.found, given, tf) for d in (0, 1, 2))
        x = [*at, *(v/tf for v in slope)]
        accel = [b/(tf*tf) + d for b, d in zip(bend, self.planner.task.drift(x))]
        return np.stack(x, axis=-1), np.stack(accel, axis=-1)
