"""
A plan: states and controls over time, as a planner left them.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_groundstation.planning.gauss import Gauss, gauss, interpolate


@dataclass(frozen=True)
class Plan:
    """
    States at the start, at K Legendre-Gauss nodes and at the end, controls at the nodes.

    Between them both are the polynomials of the method, which are exact where the plan is: the
    controls have no value of their own at the ends and are extrapolated there.
    """

    begin_s: float
    end_s: float
    states: NDArray                     # (K + 2, n)
    controls: NDArray                   # (K, m)
    cost: float = np.nan
    iterations: int = 0
    solve_s: float = np.nan             # wall time of the solver
    multipliers: Any = None             # of the solver, from which it starts again

    @property
    def count(self) -> int:
        """Number of nodes K."""
        return len(self.controls)

    @property
    def gauss(self) -> Gauss:
        """Nodes and matrices."""
        return gauss(self.count)

    @property
    def duration_s(self) -> float:
        """Time from start to end [s]."""
        return self.end_s - self.begin_s

    @property
    def node_s(self) -> NDArray[np.float64]:
        """Times of the nodes (K,) [s]."""
        return self.begin_s + 0.5*self.duration_s*(self.gauss.nodes + 1.0)

    @property
    def state_s(self) -> NDArray[np.float64]:
        """Times of the states (K + 2,) [s]."""
        return np.concatenate([[self.begin_s], self.node_s, [self.end_s]])

    def state_at(self, time_s: ArrayLike) -> NDArray[np.float64]:
        """Return the states (..., n) at times (...) [s] of the plan."""
        g = self.gauss
        return interpolate(g.points, g.through_states, self.states[:-1], self._place(time_s))

    def control_at(self, time_s: ArrayLike) -> NDArray[np.float64]:
        """Return the controls (..., m) of the polynomial at times (...) [s] of the plan."""
        g = self.gauss
        return interpolate(g.nodes, g.through_controls, self.controls, self._place(time_s))

    def _place(self, time_s: ArrayLike) -> NDArray[np.float64]:
        return 2.0*(np.asarray(time_s, dtype=float) - self.begin_s)/self.duration_s - 1.0


def straight(initial: ArrayLike, final: ArrayLike, controls: ArrayLike, begin_s: float,
             end_s: float, count: int) -> Plan:
    """Return a straight line between two states (n,) under constant controls (m,): a guess."""
    first, last = np.asarray(initial, dtype=float), np.asarray(final, dtype=float)
    part = 0.5*(np.concatenate([gauss(count).points, [1.0]]) + 1.0)[:, np.newaxis]
    return Plan(begin_s, end_s, first + part*(last - first),
                np.tile(np.asarray(controls, dtype=float), (count, 1)))
