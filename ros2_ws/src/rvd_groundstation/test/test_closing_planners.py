"""Three planners of a closing: against the specification, yapss and the motion itself."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.planning.closing import PLANNERS
from rvd_groundstation.planning.closing.polynomial import Polynomial
from rvd_groundstation.planning.closing.pseudospectral import Pseudospectral
from rvd_groundstation.planning.closing.task import ClosingParams, Ends, margins
from rvd_groundstation.planning.closing.velocity_profile import VelocityProfile
from rvd_groundstation.planning.report import report

START = np.array([-6.0, 0.20, -0.15, 0.0, 0.0, 0.0])        # faces 3 m apart
END = np.array([-3.07, 0.0, 0.0, 0.0, 0.0, 0.0])            # faces 7 cm apart
ENDS = Ends(START, END)
TASK = ClosingParams()
J, TF = 0.0201371647, 80.37307707                           # of the specification, section 6


@pytest.fixture(scope='module')
def optimum():
    planner = Pseudospectral()
    return planner, planner.plan(ENDS)


@pytest.fixture(params=PLANNERS)
def planner(request):
    return PLANNERS[request.param]()


def two_body(state, accel, duration):
    """Fly an acceleration, a function of time along the turning axes, about the Moon itself."""
    n, a = TASK.mean_motion, TASK.orbit_radius_m
    mu = TASK.gravitational_parameter_m3_s2

    def axes(t):
        c, s = np.cos(n*t), np.sin(n*t)
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T    # columns x, y, z in H at t = 0

    def rate(t, y):
        # the target at (0, 0, -a) from the centre in H at 0: z is to nadir
        return [*y[3:], *(-mu*y[:3]/np.linalg.norm(y[:3])**3 + axes(t) @ accel(t))]

    def inertial(t, x):
        centre, turn = np.array([0, 0, -a]), np.array([0, -n, 0])
        r = centre + x[:3]
        return np.concatenate([axes(t) @ r, axes(t) @ (x[3:] + np.cross(turn, r))])

    # the axes turn about -y: x goes towards z, nadir
    end = solve_ivp(rate, (0, duration), inertial(0.0, state), method='DOP853', rtol=1e-13,
                    atol=1e-9).y[:, -1]
    r = axes(duration).T @ end[:3]
    v = axes(duration).T @ end[3:] - np.cross([0, -n, 0], r)
    return np.concatenate([r - np.array([0, 0, -a]), v])


@pytest.mark.parametrize('nodes', [10, 20, 30])
def test_the_pseudospectral_optimum_is_that_of_the_specification(nodes):
    found = Pseudospectral(nodes).plan(ENDS)
    assert found.duration_s == pytest.approx(TF, abs=1e-7)
    assert found.cost == pytest.approx(J, abs=1e-10)


def test_the_optimum_agrees_with_a_double_integrator_where_gravity_is_slight(optimum):
    """12 |dr|^2 / tf^3 without gravity, which changes the effort by parts in a thousand."""
    _, found = optimum
    effort = (found.cost - 1e-3*(found.duration_s - 80.0)**2)/100.0
    assert effort == pytest.approx(12*np.sum((END - START)**2)/found.duration_s**3, rel=2e-3)
    assert effort == pytest.approx(2.000e-4, abs=5e-8)
    state, _ = found.at(np.linspace(0.0, found.duration_s, 500))
    assert state[:, 3].max() == pytest.approx(0.0547, abs=1e-4)


def test_the_report_on_the_optimum(optimum):
    planner, found = optimum
    refined = Pseudospectral(30).plan(ENDS)
    said = report(planner.solver, found.plan, refined=refined.plan)
    assert said.defect < 1e-8 and said.bound == 0.0 and said.refinement < 1e-12
    assert np.abs(said.flown).max() < 1e-8


@pytest.mark.parametrize('order', [5, 7, 9])
def test_polynomials_come_within_a_thousandth_of_the_optimum(order):
    found = Polynomial(order).plan(ENDS)
    assert J - 1e-10 <= found.cost < 1.001*J
    assert found.duration_s == pytest.approx(TF, abs=0.01)


def test_each_plan_flies_to_its_end_about_the_moon(planner):
    """In two-body motion, of which the task knows gravity to second order."""
    found = planner.plan(ENDS)
    flown = two_body(START, lambda t: found.at(np.array(t))[1], found.duration_s)
    assert_allclose(flown[:3], END[:3], atol=3e-5)
    assert_allclose(flown[3:], END[3:], atol=2e-6)


def test_each_plan_meets_its_ends_and_keeps_the_limits(planner):
    found = planner.plan(ENDS)
    ends, _ = found.at(np.array([0.0, found.duration_s]))
    assert_allclose(ends, [START, END], atol=1e-9)
    assert min(margins(TASK, found)) > 0.0
    assert found.cost >= J - 1e-10


def test_yapss_finds_the_same_optimum(optimum):
    import yapss                                # seconds
    _, found = optimum
    problem = yapss.Problem(name='closing', nx=[6], nu=[3], nq=[1])

    def objective(arg):
        arg.objective = TASK.cost(arg.phase[0].final_time, arg.phase[0].integral[0])

    def continuous(arg):
        phase = arg.phase[0]
        x, u = phase.state, phase.control
        phase.dynamics[:] = [*x[3:], *(a - d for a, d in zip(u, TASK.drift(x)))]
        phase.integrand[0] = u[0]**2 + u[1]**2 + u[2]**2

    problem.functions.objective, problem.functions.continuous = objective, continuous
    bounds = problem.bounds.phase[0]
    bounds.initial_time.lower = bounds.initial_time.upper = 0.0
    bounds.final_time.lower, bounds.final_time.upper = TASK.duration_s
    bounds.initial_state.lower[:] = bounds.initial_state.upper[:] = START
    bounds.final_state.lower[:] = bounds.final_state.upper[:] = END
    guess = problem.guess.phase[0]
    guess.time = [0.0, 80.0]
    guess.state = np.stack([START, END], axis=1)
    guess.control = np.zeros((3, 2))
    problem.mesh.phase[0].collocation_points = [20]
    problem.mesh.phase[0].fraction = [1.0]
    problem.spectral_method = 'lg'
    problem.derivatives.method = 'auto'
    problem.derivatives.order = 'second'
    problem.ipopt_options.print_level = 0
    problem.ipopt_options.tol = 1e-12
    assert problem.solve().objective == pytest.approx(found.cost, abs=1e-10)


def test_replanning_from_a_plan_takes_fewer_iterations(optimum):
    planner, found = optimum
    moved = Ends(START + [0.01, 0.01, -0.01, 0.01, -0.01, 0.01], END)
    again, cold = planner.plan(moved, found), planner.plan(moved)
    assert again.cost == pytest.approx(cold.cost, rel=1e-10)
    assert again.plan.iterations < cold.plan.iterations


def test_an_active_speed_limit_is_kept_and_costs_time():
    task = replace(TASK, max_speed_m_s=0.035)
    slow = Pseudospectral(30, task=task).plan(ENDS)
    assert slow.duration_s > TF + 5.0
    speed = np.linalg.norm(slow.plan.states[:, 3:], axis=1)
    assert speed.max() == pytest.approx(0.035, abs=1e-9)        # at the nodes, and nearly between
    assert margins(task, slow).speed_m_s > -0.02*task.max_speed_m_s


@pytest.mark.parametrize('change, optimal, word', [
    ({'max_acceleration_m_s2': 0.0005}, 'acceleration x', 'acceleration'),
    ({'view_half_angle_deg': 3.0}, 'cone of view', 'cone of view'),
    ({'keep_out_radius_m': 3.5}, 'distance from the target', 'keep-out'),
    ({'max_speed_m_s': 0.02}, 'speed', 'speed')])
def test_what_cannot_be_kept_is_named(planner, change, optimal, word):
    planner = replace(planner, task=replace(TASK, **change))
    name = optimal if isinstance(planner, Pseudospectral) else word
    with pytest.raises(BadInput, match=f'plan infeasible: {name}'):
        planner.plan(ENDS)


def test_a_profile_refuses_what_it_cannot_do():
    with pytest.raises(BadInput, match='at rest, got a speed of 0.01'):
        VelocityProfile().plan(Ends(START + [0, 0, 0, 0.01, 0, 0], END))
    with pytest.raises(BadInput, match='way along x must be at least 0.66 m, got 0.43'):
        VelocityProfile().plan(Ends([-3.5, 0, 0, 0, 0, 0], END))
    with pytest.raises(BadInput, match='duration must be between 60 and 120 s'):
        VelocityProfile(fast_m_s=0.02, dock_m_s=0.01).plan(ENDS)
    with pytest.raises(BadInput, match='dock_m'):
        VelocityProfile(dock_m=0.01)
    with pytest.raises(BadInput, match='final must be 6 finite numbers'):
        Ends(START, END[:5])
