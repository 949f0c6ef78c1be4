"""The pseudospectral transcription against closed forms, and what it says where no plan is."""

from dataclasses import replace
import subprocess
import sys

import casadi as ca
from hypothesis import given, strategies as st
import numpy as np
from numpy.polynomial import Polynomial
from numpy.testing import assert_allclose
import pytest
from scipy.optimize import brentq

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.planning.gauss import gauss, interpolate
from rvd_groundstation.planning.problem import End, Path, Problem, Quantity
from rvd_groundstation.planning.report import report
from rvd_groundstation.planning.transcription import FREE, Solver

MASS = Problem(
    states=(Quantity('x', 'm'), Quantity('v', 'm/s')),
    controls=(Quantity('force', 'N', 4.0),),
    rate=lambda t, x, u, p: [x[1], u[0]/p[0]],
    running=lambda t, x, u, p: u[0]*u[0],
    parameters=('mass',))


@pytest.fixture(scope='module')
def mass_solver():
    return Solver(MASS, 12)


# -- nodes ----------------------------------------------------------------------------------------

@given(st.integers(2, 60), st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=10))
def test_derivative_quadrature_and_interpolation_are_exact_for_polynomials(count, coefficients):
    poly, g = Polynomial(coefficients[:count + 1]), gauss(count)
    assert_allclose(g.derivative @ poly(g.points), poly.deriv()(g.nodes), atol=1e-10)
    assert_allclose(g.weights @ poly(g.nodes), poly.integ()(1.0) - poly.integ()(-1.0), atol=1e-13)
    at = np.concatenate([np.linspace(-1.0, 1.0, 7), g.points])
    values = np.stack([poly(g.points), -poly(g.points)], axis=-1)
    assert_allclose(interpolate(g.points, g.through_states, values, at),
                    np.stack([poly(at), -poly(at)], axis=-1), atol=1e-11)


def test_quadrature_is_exact_up_to_degree_2k_minus_1_and_not_beyond():
    g = gauss(3)
    assert g.weights @ g.nodes**4 == pytest.approx(2/5, abs=1e-15)
    assert abs(g.weights @ g.nodes**6 - 2/7) > 1e-3


def test_barycentric_weights_do_not_overflow_at_200_nodes():
    g = gauss(200)
    assert_allclose(g.derivative @ np.exp(g.points), np.exp(g.nodes), rtol=1e-9)


# -- optima with a closed form ---------------------------------------------------------------------

def test_least_effort_from_rest_to_rest(mass_solver):
    """int F^2 = 12 m^2 d^2 / T^3, F linear in time; the mass is a parameter of one solver."""
    for mass, d, duration in ((1.0, 1.0, 1.0), (3.0, -2.0, 4.0)):
        plan = mass_solver.solve([0, 0], [d, 0], (duration, duration), parameters=[mass])
        assert_allclose(plan.cost, 12*mass**2*d**2/duration**3, rtol=1e-9)
        t = np.linspace(0.0, duration, 9)
        assert_allclose(plan.control_at(t)[:, 0], 6*mass*d/duration**2*(1 - 2*t/duration),
                        atol=1e-7)
        s = t/duration
        assert_allclose(plan.state_at(t)[:, 0], d*s*s*(3 - 2*s), atol=1e-9)
        assert plan.state_s[-1] == duration


def test_brachistochrone_ends_at_the_cycloids_time():
    problem = Problem(
        states=(Quantity('x', 'm'), Quantity('y', 'm'), Quantity('v', 'm/s', low=0.0)),
        controls=(Quantity('angle', 'rad', low=0.0, high=np.pi),),
        rate=lambda t, x, u, p: [x[2]*ca.sin(u[0]), x[2]*ca.cos(u[0]), 9.81*ca.cos(u[0])],
        end=lambda x0, xf, t0, tf, p: tf - t0)
    plan = Solver(problem, 30).solve([0, 0, 0], [2, 1, FREE], (0.1, 5.0))
    turn = brentq(lambda a: (a - np.sin(a)) - 2*(1 - np.cos(a)), 1.0, 6.0)
    radius = 1.0/(1 - np.cos(turn))
    assert_allclose(plan.cost, turn*np.sqrt(radius/9.81), rtol=1e-7)
    assert_allclose(plan.cost, plan.duration_s)


def test_bryson_and_denham_ride_along_the_bound():
    """int u^2/2 = 4/(9 l) for l <= 1/6: a bound that is active over a stretch."""
    problem = replace(
        MASS, states=(Quantity('x', 'm', high=1/9), Quantity('v', 'm/s')),
        running=lambda t, x, u, p: 0.5*u[0]*u[0])
    plan = Solver(problem, 40).solve([0, 1], [0, -1], (1, 1), parameters=[1.0])
    assert_allclose(plan.cost, 4.0, rtol=1e-4)
    assert plan.states[:, 0].max() <= 1/9 + 1e-12


def test_time_counts_from_where_the_plan_begins():
    """x' = cos t + u: the least effort is a constant u, which depends on both instants."""
    problem = Problem((Quantity('x'),), (Quantity('u'),),
                      rate=lambda t, x, u, p: [ca.cos(t) + u[0]],
                      running=lambda t, x, u, p: u[0]*u[0])
    plan = Solver(problem, 15).solve([0.5], [2.0], (3.0, 3.0), begin_s=1.2)
    assert_allclose(plan.controls, (1.5 - np.sin(4.2) + np.sin(1.2))/3.0, atol=1e-8)
    assert plan.begin_s == 1.2 and plan.end_s == pytest.approx(4.2)


def test_a_path_constraint_and_an_end_condition_hold(mass_solver):
    problem = replace(
        MASS, paths=(Path('power', lambda t, x, u, p: x[1]*u[0], high=0.9, unit='W'),),
        ends=(End('meet', lambda x0, xf, t0, tf, p: xf[0] - ca.sin(tf)),))
    free = mass_solver.solve([0, 0], [FREE, 0], (1, 1), parameters=[1.0])
    assert free.cost == pytest.approx(0.0, abs=1e-12)           # it may stay where it is
    plan = Solver(problem, 25).solve([0, 0], [FREE, 0], (1, 1), parameters=[1.0])
    assert_allclose(plan.states[-1, 0], np.sin(1.0), atol=1e-9)
    assert (plan.states[1:-1, 1]*plan.controls[:, 0]).max() <= 0.9 + 1e-9
    unbound = 12*np.sin(1.0)**2
    assert plan.cost > unbound*1.0001                           # the bound costs something


def test_the_jacobian_that_is_put_together_is_the_one_that_casadi_finds():
    """Derived by hand from the nodes' own; with paths, ends, parameters and a free end time."""
    problem = replace(
        MASS, rate=lambda t, x, u, p: [x[1] + ca.sin(t*x[0]), u[0]*x[0]/p[0] + t*u[0]*u[0]],
        paths=(Path('power', lambda t, x, u, p: x[1]*u[0] + t*t, high=0.9),
               Path('place', lambda t, x, u, p: ca.cos(x[0]*p[0]))),
        ends=(End('meet', lambda x0, xf, t0, tf, p: xf[0]*x0[1] - ca.sin(tf*t0)),))
    made = Solver(problem, 7)._programme
    both = ca.Function('f', [made.unknowns, made.given], [
        ca.jacobian(made.constraints, made.unknowns), made.slopes])
    rng = np.random.default_rng(1)
    for _ in range(3):
        found = both(rng.normal(size=made.unknowns.numel()), rng.normal(size=2))
        assert_allclose(*map(np.asarray, found), atol=1e-11)


# -- again and again -------------------------------------------------------------------------------

def test_a_warm_start_finds_the_same_optimum_in_fewer_iterations():
    problem = replace(MASS, controls=(Quantity('force', 'N', 4.0, -4.5, 4.5),))
    solver = Solver(problem, 30)
    first = solver.solve([0, 0], [1, 0], (1, 1), parameters=[1.0])
    cold = solver.solve([0.01, 0.005], [1, 0], (1, 1), parameters=[1.0])
    warm = solver.solve([0.01, 0.005], [1, 0], (1, 1), parameters=[1.0], guess=first, warm=True)
    assert_allclose(warm.cost, cold.cost, rtol=1e-9)
    assert warm.iterations < cold.iterations


def test_a_plan_on_other_nodes_is_a_guess(mass_solver):
    first = mass_solver.solve([0, 0], [1, 0], (1, 1), parameters=[1.0])
    again = Solver(MASS, 20).solve([0, 0], [1, 0], (1, 1), parameters=[1.0], guess=first)
    assert_allclose(again.cost, 12.0, rtol=1e-9)


# -- report ----------------------------------------------------------------------------------------

def test_the_report_finds_a_plan_sound_and_a_spoilt_one_not():
    solver = Solver(replace(MASS, controls=(Quantity('force', 'N', 4.0, -6.5, 6.5),)), 12)
    plan = solver.solve([0, 0], [1, 0], (1, 1), parameters=[1.0])
    sound = report(solver, plan, (1.0,))
    assert sound.defect < 1e-9 and sound.bound == 0.0 and np.abs(sound.flown).max() < 1e-8
    spoilt = report(solver, replace(plan, controls=1.2*plan.controls), (1.0,))
    assert spoilt.defect > 0.1 and spoilt.bound > 0.05 and np.abs(spoilt.flown).max() > 0.1
    assert report(solver, plan, (1.0,), refined=replace(plan, cost=12.5)).refinement == (
        pytest.approx(0.5, abs=1e-8))


# -- no plan ---------------------------------------------------------------------------------------

@pytest.mark.parametrize('change, words', [
    ({'controls': (Quantity('force', 'N', 4.0, -3.0, 3.0),)}, 'force must be at most 3 N, .*3.99'),
    ({'states': (Quantity('x', 'm'), Quantity('v', 'm/s', high=0.9))},
     r'v must be at most 0.9 m/s, .*reaches 1\.0'),
    ({'paths': (Path('speed', lambda t, x, u, p: x[1]*x[1], high=0.81, unit='m/s',
                     shown=np.sqrt),)}, r'speed must be at most 0.9 m/s, .*reaches 1\.0'),
    ({'ends': (End('gap', lambda x0, xf, t0, tf, p: xf[0] - x0[0], 1.5, 1.5, 'm'),)},
     'gap must be equal to 1.5 m, .*reaches 1 m'),
], ids=['control', 'state', 'path', 'end'])
def test_an_infeasible_plan_names_what_is_in_the_way(change, words):
    with pytest.raises(BadInput, match=f'plan infeasible: {words}') as refused:
        Solver(replace(MASS, **change), 20).solve([0, 0], [1, 0], (1, 1), parameters=[1.0])
    assert '\n' not in str(refused.value)


def test_bad_arguments_are_refused(mass_solver):
    with pytest.raises(BadInput, match='duration'):
        mass_solver.solve([0, 0], [1, 0], (2, 1), parameters=[1.0])
    with pytest.raises(ValueError, match='initial'):
        mass_solver.solve([0, np.inf], [1, 0], (1, 1), parameters=[1.0])
    with pytest.raises(ValueError, match='parameters'):
        mass_solver.solve([0, 0], [1, 0], (1, 1))
    with pytest.raises(BadInput, match='nodes'):
        Solver(MASS, 1)
    with pytest.raises(ValueError, match='scale'):
        Quantity('x', scale=0.0)
    with pytest.raises(ValueError, match='low'):
        Quantity('x', low=1.0, high=0.0)


def test_nobody_waits_for_casadi_who_does_not_plan():
    script = ('import sys; import rvd_groundstation.planning.closing, '
              'rvd_groundstation.planning.report; print("casadi" in sys.modules)')
    assert subprocess.run([sys.executable, '-c', script], capture_output=True, text=True,
                          check=True).stdout.strip() == 'False'
