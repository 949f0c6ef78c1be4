"""
What stands in the way of a plan: the same programme with every bound let go as little as will do.

Each bounded quantity and each constraint has one slack of its own, in units of its scale; the sum
of all slacks is minimised, which leaves most of them at zero. Defects are not let go.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.planning.problem import Problem

PREFERENCE = 1e-4                       # weight of small controls, which makes the answer unique
MET = 1e-5                              # [scales] a slack below it is none


class Bound(NamedTuple):
    """One bounded quantity: where it stands in the programme."""

    what: Any                           # Quantity, Path or End
    where: NDArray                      # indices
    constraint: bool                    # of the constraints; else of the unknowns


class Relaxation:
    """The relaxed programme of a transcribed problem."""

    def __init__(self, problem: Problem, count: int, programme: Any) -> None:
        n, m, paths = len(problem.states), len(problem.controls), len(problem.paths)
        nodes, defects = np.arange(count), n*(count + 1)
        self._programme = programme
        self._duration = n*(count + 2) + m*count                    # index of the end time
        self._bounds = [
            *(Bound(q, n*(np.arange(count + 1) + 1) + i, False)
              for i, q in enumerate(problem.states)),
            *(Bound(q, n*(count + 2) + m*nodes + i, False)
              for i, q in enumerate(problem.controls)),
            *(Bound(c, defects + paths*nodes + i, True) for i, c in enumerate(problem.paths)),
            *(Bound(c, np.array([defects + paths*count + i]), True)
              for i, c in enumerate(problem.ends))]
        self._bounds = [b for b in self._bounds if np.isfinite([b.what.low, b.what.high]).any()]

    def search(self, start: NDArray, lower: NDArray, upper: NDArray, given: NDArray,
               sides: tuple[NDArray, NDArray]) -> NDArray:
        """Return unknowns that meet all bounds; refuse by name what cannot be met."""
        import casadi as ca
        p, count = self._programme, len(self._bounds)
        slack = ca.SX.sym('slack', count)
        low_x, high_x, (low_g, high_g) = lower.copy(), upper.copy(), (s.copy() for s in sides)
        more, low_more, high_more, rows = [], [], [], []
        for i, bound in enumerate(self._bounds):
            values = p.constraints if bound.constraint else p.unknowns
            low, high = (low_g, high_g) if bound.constraint else (low_x, high_x)
            for j in bound.where:
                if not bound.constraint and low[j] == high[j]:      # given, not bounded
                    continue
                for side, sign in ((low, 1.0), (high, -1.0)):
                    if np.isfinite(side[j]):
                        more.append(values[int(j)] + sign*slack[i])
                        rows.append((bound.constraint, int(j), i, sign))
                        low_more.append(side[j] if sign > 0.0 else -np.inf)
                        high_more.append(side[j] if sign < 0.0 else np.inf)
                low[j], high[j] = -np.inf, np.inf
        unknowns, constraints = ca.vertcat(p.unknowns, slack), ca.vertcat(p.constraints, *more)
        slopes = ca.Function('nlp_jac_g', [unknowns, p.given],
                             [constraints, self._slopes(rows)], ['x', 'p'], ['g', 'jac_g_x'])
        solver = ca.nlpsol('relaxed', 'ipopt', {
            'x': unknowns, 'p': p.given, 'f': ca.sum1(slack) + PREFERENCE*p.guessed,
            'g': constraints}, {
                'jac_g': slopes,
                'ipopt.print_level': 0, 'ipopt.sb': 'yes', 'print_time': False,
                'ipopt.tol': 1e-7, 'ipopt.max_iter': 1000, 'error_on_fail': False,
                'ipopt.mu_strategy': 'adaptive', 'show_eval_warnings': False})
        made = solver(
            x0=np.concatenate([start, np.ones(count)]), p=given,
            lbx=np.concatenate([low_x, np.zeros(count)]),
            ubx=np.concatenate([high_x, np.full(count, np.inf)]),
            lbg=np.concatenate([low_g, low_more]), ubg=np.concatenate([high_g, high_more]))
        if not solver.stats()['success']:
            raise BadInput('no plan found, nor what is in its way: with every bound let go ipopt '
                           f'ended with {solver.stats()["return_status"]}')
        found = np.asarray(made['x']).ravel()
        slacks = found[len(start):]
        if slacks.max() > MET:
            values = np.asarray(ca.Function('g', [p.unknowns, p.given], [p.constraints])(
                found[:len(start)], given)).ravel()
            worst = self._bounds[int(slacks.argmax())]
            others = [b.what.name for b, s in zip(self._bounds, slacks)
                      if s > MET and b is not worst]
            raise BadInput(_refusal(worst, (values if worst.constraint else found)[worst.where],
                                    others))
        return found[:len(start)]

    def _slopes(self, rows: list[tuple]) -> Any:
        """
        Return the Jacobian of the constraints and of the relaxed rows below them.

        Put together of what is known: casadi's own search for its structure takes seconds. A row is
        (of the constraints or of the unknowns, index there, slack, its sign).
        """
        import casadi as ca
        p, count = self._programme, len(self._bounds)
        size = p.unknowns.shape[0]
        parts, at = [ca.horzcat(p.slopes, ca.DM(p.slopes.shape[0], count))], 0
        while at < len(rows):                   # runs of rows of one kind
            end = at
            while end < len(rows) and rows[end][0] == rows[at][0]:
                end += 1
            run, n = rows[at:end], end - at
            which = [j for _, j, _, _ in run]
            left = p.slopes[which, :] if run[0][0] else ca.DM.triplet(
                list(range(n)), which, ca.DM.ones(n), n, size)
            right = ca.DM.triplet(list(range(n)), [i for *_, i, _ in run],
                                  ca.DM([sign for *_, sign in run]), n, count)
            parts.append(ca.horzcat(left, right))
            at = end
        return ca.vertcat(*parts)


def _refusal(bound: Bound, scaled: NDArray, others: list[str]) -> str:
    """Return the line that says which bound is in the way, and how far."""
    what, values = bound.what, scaled*bound.what.scale
    shown = getattr(what, 'shown', None) or (lambda value: value)
    unit = f' {what.unit}' if what.unit else ''
    over, under = values.max() - what.high, what.low - values.min()
    word, limit, needs = (('at most', what.high, values.max()) if over >= under
                          else ('at least', what.low, values.min()))
    if what.low == what.high:
        word = 'equal to'
    also = f', with {" and ".join(others)} let go as well' if others else ''
    return (f'plan infeasible: {what.name} must be {word} {shown(limit):.6g}{unit}, and the '
            f'nearest motion reaches {shown(needs):.6g}{unit}{also}')
