"""
Gauss pseudospectral transcription: a `Problem` as a nonlinear programme, solved by ipopt.

Unknowns are the states at the start, at the K nodes and at the end, the controls at the nodes, and
the end time; those that are given are fixed by their bounds, so that one solver serves every start,
every end and every duration. Derivatives are exact (casadi, expanded to scalars).

    sum_i D_ki X_i = (tf - t0)/2 rate(t_k, X_k, U_k, p)
    X_f = X_0 + (tf - t0)/2 sum_k w_k rate_k,   J = end + (tf - t0)/2 sum_k w_k running_k

Source  D. A. Benson, G. T. Huntington, T. P. Thorvaldsen, A. V. Rao, J. Guidance 29(6), 2006,
        equations (12) to (18).
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.planning.gauss import gauss
from rvd_groundstation.planning.plan import Plan
from rvd_groundstation.planning.problem import Problem

FREE = np.nan                           # of an initial or final value: to be found
TOLERANCE = 1e-10                       # of ipopt, on the scaled programme
MOST_ITERATIONS = 400
# What can be found from a straight line takes up to 100 iterations; what cannot uses up all it
# gets.
# So the search for what is in the way begins after these, and a feasible point gets all of them.
FIRST_ITERATIONS = 150
# A start from a plan that is nearly right: the barrier begins small, and nothing is pushed away
# from its bound.
WARM = {'warm_start_init_point': 'yes', 'mu_init': 1e-6, 'warm_start_bound_push': 1e-7,
        'warm_start_bound_frac': 1e-7, 'warm_start_slack_bound_push': 1e-7,
        'warm_start_slack_bound_frac': 1e-7, 'warm_start_mult_bound_push': 1e-7}


class Programme(NamedTuple):
    """The symbols of a transcribed problem, all scaled."""

    unknowns: Any                       # X0, X1..XK, Xf, U1..UK, tf
    given: Any                          # t0, parameters
    cost: Any
    constraints: Any                    # defects, quadrature, paths by node, ends
    slopes: Any                         # of the constraints, by the unknowns
    guessed: Any                        # a mild preference, for the search of a feasible point


class Multipliers(NamedTuple):
    """Where a solver left off."""

    unknowns: NDArray
    bounds: NDArray
    constraints: NDArray


class Solver:
    """
    A problem on K nodes, built once and solved as often as wanted.

    Building takes most of the time of a first plan. It imports casadi.
    """

    def __init__(self, problem: Problem, count: int) -> None:
        if count < 2:
            raise BadInput(f'nodes must be at least 2, got {count}')
        self.problem, self.count, self._gauss = problem, count, gauss(count)
        self._n, self._m = len(problem.states), len(problem.controls)
        self._x_scale = np.array([q.scale for q in problem.states])
        self._u_scale = np.array([q.scale for q in problem.controls])
        self._programme = self._transcribed()
        self._cold = self._built('cold', self._programme, {'max_iter': FIRST_ITERATIONS})

    # -- solving ----------------------------------------------------------------------------------

    def solve(self, initial: ArrayLike, final: ArrayLike, duration: tuple[float, float],
              begin_s: float = 0.0, parameters: Sequence[float] = (), guess: Plan | None = None,
              warm: bool = False) -> Plan:
        """
        Return the optimal plan.

        Parameters
        ----------
        initial, final : array_like, shape (n,)
            States at the ends; FREE where they are to be found.
        duration : (float, float)
            Least and greatest time from start to end [s]; equal: it is fixed.
        begin_s : float
            Time of the start [s].
        parameters : sequence of float
            Values of the problem's parameters.
        guess : Plan, optional
            Where to begin; without it a straight line between the ends.
        warm : bool
            Whether the guess is nearly right and a plan of this solver, whose multipliers are
            taken on, too.

        Raises
        ------
        BadInput
            If there is no such plan: names the constraint that is in the way.
        """
        lower, upper = self._bounds(initial, final, duration, begin_s, parameters)
        start = self._packed(guess) if guess is not None else self._line(lower, upper, begin_s)
        given = np.array([begin_s, *parameters], dtype=float)
        before = guess.multipliers if warm and guess is not None else None
        if before is not None and len(before.bounds) == len(start):     # of these nodes
            found = self._run(self._warm, start, lower, upper, given, before)
            if found is not None:
                return found
        found = self._run(self._cold, start, lower, upper, given)
        if found is None:               # nothing to satisfy, or only a bad place to begin?
            start = self._feasible(start, lower, upper, given)
            found = self._run(self._patient, start, lower, upper, given)
        if found is None:
            raise BadInput(f'no plan found on {self.count} nodes: every constraint can be met, but '
                           f'ipopt ended with {self._status}; another number of nodes may help')
        return found

    def _run(self, solver: Any, start: NDArray, lower: NDArray, upper: NDArray, given: NDArray,
             before: Multipliers | None = None) -> Plan | None:
        low, high = self._sides
        more = {} if before is None else {'lam_x0': before.bounds, 'lam_g0': before.constraints}
        made = solver(x0=start, p=given, lbx=lower, ubx=upper, lbg=low, ubg=high, **more)
        stats = solver.stats()
        self._status = stats['return_status']
        if not stats['success'] or self._status == 'Solved_To_Acceptable_Level':
            return None
        z = np.asarray(made['x']).ravel()
        states, controls, end_s = self._unpacked(z)
        return Plan(float(given[0]), end_s, states, controls, float(made['f']),
                    int(stats['iter_count']), float(stats['t_wall_total']),
                    Multipliers(z, np.asarray(made['lam_x']).ravel(),
                                np.asarray(made['lam_g']).ravel()))

    def _bounds(self, initial: ArrayLike, final: ArrayLike, duration: tuple[float, float],
                begin_s: float, parameters: Sequence[float]) -> tuple[NDArray, NDArray]:
        """Return the least and greatest values of the unknowns, scaled."""
        shortest, longest = duration
        if not 0.0 < shortest <= longest:
            raise BadInput(f'duration must be positive and its least not above its greatest, got '
                           f'{shortest:g} and {longest:g} s')
        if len(parameters) != len(self.problem.parameters):
            raise ValueError(f'parameters must be {self.problem.parameters}, got {parameters}')
        low, high = self._box(self.problem.states)
        first, last = (np.asarray(v, dtype=float)/self._x_scale for v in (initial, final))
        for name, v in (('initial', first), ('final', last)):
            if v.shape != (self._n,) or np.isinf(v).any():
                raise ValueError(f'{name} must be {self._n} finite numbers or FREE, got {v}')
        free_first, free_last = np.isnan(first), np.isnan(last)
        u_low, u_high = self._box(self.problem.controls)
        k = self.count
        return tuple(np.concatenate([
            np.where(free_first, x, first), np.tile(x, k), np.where(free_last, x, last),
            np.tile(u, k), [begin_s + t]]) for x, u, t in (
                (low, u_low, shortest), (high, u_high, longest)))

    @staticmethod
    def _box(quantities: tuple) -> tuple[NDArray, NDArray]:
        return (np.array([q.low/q.scale for q in quantities]),
                np.array([q.high/q.scale for q in quantities]))

    @cached_property
    def _sides(self) -> tuple[NDArray, NDArray]:
        """Least and greatest values of the constraints, scaled."""
        p, zeros = self.problem, np.zeros(self._n*(self.count + 1))
        return tuple(np.concatenate([
            zeros, np.tile([getattr(c, side)/c.scale for c in p.paths], self.count),
            [getattr(c, side)/c.scale for c in p.ends]]) for side in ('low', 'high'))

    def _line(self, lower: NDArray, upper: NDArray, begin_s: float) -> NDArray:
        """Return a straight line between the ends, with controls amid their bounds or at zero."""
        bounded = np.isfinite(lower) & np.isfinite(upper)
        middle = np.clip(0.0, lower, upper)
        middle[bounded] = 0.5*(lower[bounded] + upper[bounded])
        n, k = self._n, self.count
        first, last = middle[:n], middle[n*(k + 1):n*(k + 2)]
        part = 0.5*(np.concatenate([self._gauss.points, [1.0]]) + 1.0)[:, np.newaxis]
        line = first + part*(last - first)
        return np.concatenate([line.ravel(), middle[n*(k + 2):]])

    def _packed(self, plan: Plan) -> NDArray:
        """Return the unknowns, scaled, of a plan on any number of nodes."""
        states, controls = plan.states, plan.controls
        if plan.count != self.count:
            at = plan.begin_s + 0.5*plan.duration_s*(self._gauss.nodes + 1.0)
            states = np.concatenate([states[:1], plan.state_at(at), states[-1:]])
            controls = plan.control_at(at)
        return np.concatenate([(states/self._x_scale).ravel(), (controls/self._u_scale).ravel(),
                               [plan.end_s]])

    def _unpacked(self, z: NDArray) -> tuple[NDArray, NDArray, float]:
        cut = self._n*(self.count + 2)
        return (z[:cut].reshape(-1, self._n)*self._x_scale,
                z[cut:-1].reshape(-1, self._m)*self._u_scale, float(z[-1]))

    # -- building ---------------------------------------------------------------------------------

    @cached_property
    def functions(self) -> Any:
        """A casadi function (t, x, u, p) -> rate, running cost, path constraints; not scaled."""
        import casadi as ca
        p = self.problem
        t, x, u = ca.SX.sym('t'), ca.SX.sym('x', self._n), ca.SX.sym('u', self._m)
        q = ca.SX.sym('p', len(p.parameters))
        args = t, ca.vertsplit(x), ca.vertsplit(u), ca.vertsplit(q)
        rate = p.rate(*args)
        if len(rate) != self._n:
            raise ValueError(f'rate must return {self._n} scalars, got {len(rate)}')
        running = p.running(*args) if p.running else ca.SX(0)
        return ca.Function('functions', [t, x, u, q], [
            ca.vertcat(*rate), running, ca.vertcat(*(c.of(*args)/c.scale for c in p.paths))])

    def _transcribed(self) -> Programme:
        import casadi as ca
        p, n, m, k = self.problem, self._n, self._m, self.count
        z, given = ca.SX.sym('z', n*(k + 2) + m*k + 1), ca.SX.sym('given', 1 + len(p.parameters))
        t0, q, tf = given[0], given[1:], z[-1]
        states = ca.reshape(z[:n*(k + 2)], n, k + 2)                    # scaled, a column a point
        controls = ca.reshape(z[n*(k + 2):-1], m, k)
        at_node, by_node = self._of_a_node()
        slopes, costs, paths, blocks = [], [], [], []
        for i, node in enumerate(self._gauss.nodes):
            args = node, states[:, i + 1], controls[:, i], t0, tf, q
            slope, cost, path = at_node(*args)
            slopes.append(slope)
            costs.append(cost)
            paths.append(path)
            blocks.append(by_node(*args))
        weights = ca.DM(self._gauss.weights)
        slope = ca.horzcat(*slopes)
        defects = ca.mtimes(states[:, :k + 1], ca.DM(self._gauss.derivative).T) - slope
        end = states[:, -1] - states[:, 0] - ca.mtimes(slope, weights)
        scale = ca.DM(self._x_scale)
        both = *(ca.vertsplit(states[:, i]*scale) for i in (0, k + 1)), t0, tf, ca.vertsplit(q)
        ends = ca.vertcat(*(e.of(*both)/e.scale for e in p.ends))
        cost = ca.dot(weights, ca.vertcat(*costs)) + (p.end(*both) if p.end else 0.0)
        return Programme(
            z, given, cost, ca.vertcat(ca.vec(defects), end, *paths, ends),
            ca.vertcat(self._slopes(blocks), ca.jacobian(ends, z)), ca.sumsqr(controls)/k)

    def _of_a_node(self) -> tuple:
        """Return casadi functions of one node: slope of the states, cost, paths; Jacobian."""
        import casadi as ca
        node, t0, tf = (ca.SX.sym(name) for name in ('node', 't0', 'tf'))
        x, u = ca.SX.sym('x', self._n), ca.SX.sym('u', self._m)
        q = ca.SX.sym('q', len(self.problem.parameters))
        half, scale = 0.5*(tf - t0), ca.DM(self._x_scale)
        rate, running, path = self.functions(
            t0 + half*(node + 1.0), x*scale, u*ca.DM(self._u_scale), q)
        slope, args = half*rate/scale, [node, x, u, t0, tf, q]
        return (ca.Function('node', args, [slope, half*running, path]),
                ca.Function('slopes', args, [ca.jacobian(ca.vertcat(slope, path),
                                                         ca.vertcat(x, u, tf))]))

    def _slopes(self, blocks: list) -> Any:
        """
        Return the Jacobian of defects, quadrature and paths, put together of those of the nodes.

        casadi's own search for its structure takes seconds: the defects are dense in the nodes.
        """
        import casadi as ca
        n, m, k, g = self._n, self._m, self.count, self._gauss
        x, u = slice(0, n), slice(n, n + m)
        rates, paths = [b[:n, :] for b in blocks], [b[n:, :] for b in blocks]
        eye, none = ca.DM.eye(n), ca.DM(n*k, n)
        rest = paths[0].shape[0]*k
        spread = ca.DM(np.kron(g.derivative, np.eye(n)))
        return ca.vertcat(
            ca.horzcat(ca.sparsify(spread)
                       - ca.horzcat(none, ca.diagcat(*(r[:, x] for r in rates))),
                       none, -ca.diagcat(*(r[:, u] for r in rates)),
                       -ca.vertcat(*(r[:, -1] for r in rates))),
            ca.horzcat(-eye, *(-w*r[:, x] for w, r in zip(g.weights, rates)), eye,
                       *(-w*r[:, u] for w, r in zip(g.weights, rates)),
                       -sum(w*r[:, -1] for w, r in zip(g.weights, rates))),
            ca.horzcat(ca.DM(rest, n), ca.diagcat(*(b[:, x] for b in paths)), ca.DM(rest, n),
                       ca.diagcat(*(b[:, u] for b in paths)),
                       ca.vertcat(*(b[:, -1] for b in paths))))

    def _built(self, name: str, programme: Programme, more: dict | None = None,
               of: dict | None = None) -> Any:
        import casadi as ca
        given = {'x': programme.unknowns, 'p': programme.given}
        slopes = ca.Function('nlp_jac_g', list(given.values()),
                             [programme.constraints, programme.slopes], list(given),
                             ['g', 'jac_g_x'])
        # bound_relax_factor 0: bounds are bounds.
        options = {'ipopt.print_level': 0, 'ipopt.sb': 'yes', 'print_time': False,
                   'record_time': True, 'ipopt.tol': TOLERANCE, 'ipopt.max_iter': MOST_ITERATIONS,
                   'ipopt.bound_relax_factor': 0.0, 'ipopt.constr_viol_tol': 1e-10,
                   'ipopt.nlp_scaling_method': 'none', 'ipopt.mu_strategy': 'adaptive',
                   'error_on_fail': False, 'show_eval_warnings': False, 'jac_g': slopes,
                   **(of or {}), **{f'ipopt.{key}': v for key, v in (more or {}).items()}}
        return ca.nlpsol(name, 'ipopt', {
            **given, 'f': programme.cost, 'g': programme.constraints}, options)

    @cached_property
    def _warm(self) -> Any:
        """The same programme for a start from a plan that is nearly right."""
        return self._built('warm', self._programme, {**WARM, 'mu_strategy': 'monotone'},
                           self._derived)

    @cached_property
    def _patient(self) -> Any:
        """The same programme with all iterations there are."""
        return self._built('patient', self._programme, of=self._derived)

    @property
    def _derived(self) -> dict:
        """Derivatives that are built already, by option."""
        derived = {'grad_f': 'nlp_grad_f', 'hess_lag': 'nlp_hess_l'}
        return {option: self._cold.get_function(name) for option, name in derived.items()}

    # -- what is in the way -----------------------------------------------------------------------

    def _feasible(self, start: NDArray, lower: NDArray, upper: NDArray,
                  given: NDArray) -> NDArray:
        """
        Return unknowns that meet every constraint, for a solver that found none.

        Each bound and each constraint is let go by as little as will do.

        Raises
        ------
        BadInput
            If there are none: names the constraint that must give way.
        """
        from rvd_groundstation.planning.relaxation import Relaxation
        return Relaxation(self.problem, self.count, self._programme).search(
            start, lower, upper, given, self._sides)
