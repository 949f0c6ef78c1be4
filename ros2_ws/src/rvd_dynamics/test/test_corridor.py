"""The cone and its control boundary: brute force, other forms, integration, the paper's slips."""

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from rvd_dynamics.geometry import cone
from rvd_dynamics.motion.orbit import OrbitParams

CONE = cone.Cone()
D, TAN, SIN, COS = 0.3, np.tan(np.radians(3)), np.sin(np.radians(3)), np.cos(np.radians(3))
N = OrbitParams().mean_motion

stations = st.floats(-60.0, 0.0)
offsets = st.floats(-4.0, 4.0)
positions = st.tuples(stations, offsets, offsets).map(np.array)


def rho(position):
    return np.hypot(position[..., 1], position[..., 2])


def scattered(count=4000, seed=0):
    """Return positions all over the inside of the corridor, (count, 3)."""
    rng = np.random.default_rng(seed)
    x = rng.uniform(-30.0, 0.0, count)
    part, azimuth = np.sqrt(rng.random(count)), rng.uniform(0, 2*np.pi, count)
    r = part*(D - x*TAN)
    return np.stack([x, r*np.cos(azimuth), r*np.sin(azimuth)], axis=-1)


# -- the cone ---------------------------------------------------------------------------------

def test_radius_at_start_and_docking_plane():
    assert_allclose(cone.radius([-30.0, 0.0], CONE), [1.8722, 0.3], atol=5e-5)


def test_the_apex_lies_behind_the_docking_plane():
    assert cone.radius(5.724, CONE) == pytest.approx(0.0, abs=2e-5)


@given(positions)
def test_p13_the_sign_tells_inside_from_outside(position):
    inside = rho(position) < D - position[0]*TAN
    distance = cone.signed_distance(position, CONE)
    if abs(rho(position) - (D - position[0]*TAN)) > 1e-12:
        assert (distance > 0) == inside


def test_p13_it_is_zero_on_the_wall():
    p = scattered()
    p[:, 1:] *= ((D - p[:, 0]*TAN) / rho(p))[:, np.newaxis]
    assert_allclose(cone.signed_distance(p, CONE), 0.0, atol=1e-14)


@given(positions)
def test_p13_its_size_is_the_distance_to_the_nearest_point_of_the_wall(position):
    # the wall is a surface of revolution: the nearest point lies in the half plane of the
    # position; search the generator for it
    radial = rho(position)

    def away(x):
        return (x - position[0])**2 + ((D - x*TAN) - radial)**2

    best = minimize_scalar(away, bounds=(position[0] - 10.0, position[0] + 10.0),
                           method='bounded', options={'xatol': 1e-10})
    # sqrt of a minimum near zero: 1e-8 where the position is on the wall itself
    assert abs(cone.signed_distance(position, CONE)) == pytest.approx(np.sqrt(best.fun),
                                                                          abs=1e-7)


@given(positions, positions)
def test_p13_no_step_changes_it_by_more_than_its_own_length(one, other):
    change = cone.signed_distance(one, CONE) - cone.signed_distance(other, CONE)
    assert abs(change) <= np.sqrt(np.sum((one - other)**2)) + 1e-12


def test_the_printed_distance_hides_an_exit():
    inside, outside = np.array([-10.0, 0.5, 0.0]), np.array([-10.0, 1.2, 0.0])
    assert cone.signed_distance(inside, CONE) > 0 > cone.signed_distance(outside, CONE)
    assert cone.unsigned_distance(outside, CONE) > 0
    assert_allclose(cone.unsigned_distance(inside, CONE),
                    cone.signed_distance(inside, CONE))


def test_the_normal_is_the_gradient_of_the_distance():
    p, h = scattered(200), 1e-6
    gradient = np.stack([(cone.signed_distance(p + h*e, CONE)
                          - cone.signed_distance(p - h*e, CONE)) / (2*h) for e in np.eye(3)],
                        axis=-1)
    assert_allclose(-gradient, cone.outward_normal(p, CONE), atol=1e-7)


def test_the_normal_is_a_unit_vector_and_has_no_side_on_the_axis():
    normal = cone.outward_normal(scattered(), CONE)
    assert_allclose(np.sum(normal**2, axis=-1), 1.0, rtol=1e-14)
    for zero in (0.0, -0.0):
        normal = cone.outward_normal([-5.0, 0.0, zero], CONE)
        assert normal.tolist() == [pytest.approx(SIN, rel=1e-14), 0.0, 0.0]


@given(positions)
def test_the_nearest_point_is_on_the_wall_and_as_far_as_the_distance(position):
    if rho(position) < 1e-9:
        return
    q = cone.nearest_point(position, CONE)
    assert cone.signed_distance(q, CONE) == pytest.approx(0.0, abs=1e-13)
    away = np.sqrt(np.sum((q - position)**2))
    assert away == pytest.approx(abs(cone.signed_distance(position, CONE)), abs=1e-13)


def test_the_nearest_point_passes_the_docking_plane_by_16_mm_at_most():
    q = cone.nearest_point([0.0, 1e-6, 0.0], CONE)
    assert 0.0 < q[0] <= D*SIN*COS + 1e-12
    assert q[0] == pytest.approx(0.016, abs=5e-4)


def test_the_corrected_ray_form_is_the_same_point():
    p = scattered()
    assert_allclose(cone.ray_nearest_point(p, CONE), cone.nearest_point(p, CONE),
                    atol=1e-13)


def test_the_printed_ray_form_is_wrong_by_metres():
    p = scattered()
    error = cone.ray_nearest_point(p, CONE, printed=True) - cone.nearest_point(p, CONE)
    size = np.sqrt(np.sum(error**2, axis=-1))
    assert 2.0 < np.median(size) < 5.0          # where in the corridor one looks matters
    assert 10.0 < size.max() < 16.0


@pytest.mark.parametrize('point', [cone.nearest_point, cone.ray_nearest_point])
def test_the_axis_gives_finite_points(point):
    assert_allclose(point([-5.0, 0.0, 0.0], CONE)[1:], 0.0)
    q = point([-5.0, 1e-200, 0.0], CONE)
    assert np.isfinite(q).all()


def test_unknown_positions_have_no_distance():
    for p in ([np.nan, 0.0, 0.0], [-5.0, np.nan, 0.0], [-5.0, 0.0, np.nan]):
        assert np.isnan(cone.signed_distance(p, CONE))
        assert np.isnan(cone.outward_normal(p, CONE)).all()


# -- the control boundary ---------------------------------------------------------------------

def test_boundary_of_the_reference_scenario():
    x = np.array([-30.0, -2.5, 0.0])
    r = cone.control_boundary(x, CONE, N)
    assert_allclose(r, [1.3635, 0.1431, 0.3], atol=5e-5)
    assert_allclose(cone.radius(x, CONE) - r, [0.5088, 0.2879, 0.0], atol=5e-5)


def drift(x0, rate, until):
    """Integrate the free drift from rest on the axis; return its dense solution."""
    def equations(t, s):
        x, y, vx, vy = s
        return [vx, vy, -2*N*vy, 2*N*vx + 3*N*N*y]

    return solve_ivp(equations, (0.0, until), [x0, 0.0, rate, 0.0], method='DOP853',
                     rtol=1e-13, atol=1e-14, dense_output=True).sol


@pytest.mark.parametrize('rate', [0.05, 0.25, 0.3])
def test_equations_18_to_20_are_the_drift(rate):
    t = np.linspace(0.0, 500.0, 101)
    x, y, vx, vy = drift(-30.0, rate, 500.0)(t)
    w = N*t
    assert_allclose(x, -30.0 + 4*rate*np.sin(w)/N - 3*rate*t, atol=1e-9)
    assert_allclose(y, 2*rate*(1 - np.cos(w))/N, atol=1e-9)
    assert_allclose(vx, rate*(4*np.cos(w) - 3), atol=1e-11)
    # at the axis the rate is a square root: there rounding of y is magnified
    assert_allclose(cone.drift_rate(y, N, rate)[1:], vy[1:], atol=1e-10)


def test_the_drift_never_gets_further_than_four_rates_per_orbital_rate():
    assert cone.drift_rate([0.0, 4*0.25/N, 1e6, -1.0], N).tolist() == [0.0]*4
    assert cone.drift_rate(2*0.25/N, N) == pytest.approx(0.5)


def test_equation_21_is_the_rate_with_which_the_drift_meets_the_wall():
    from scipy.optimize import brentq
    sol = drift(-20.0, 0.25, 120.0)
    meet = brentq(lambda t: sol(t)[1] - (D - sol(t)[0]*TAN), 1.0, 110.0, xtol=1e-12)
    x, _, _, vy = sol(meet)
    assert cone.drift_rate(cone.radius(x, CONE), N) == pytest.approx(vy, abs=1e-10)
    literal = 2*0.25*np.sqrt(1 - ((x*N*TAN + 0.5 - N*D)/0.5)**2)
    assert cone.drift_rate(cone.radius(x, CONE), N) == pytest.approx(literal, abs=1e-12)


def test_equation_24_in_both_pieces():
    def g(x):
        return 0.5*np.sqrt(1 - ((x*N*TAN + 0.5 - N*D)/0.5)**2)

    far, near = np.linspace(-30.0, -2.5, 50), np.linspace(-2.4999, 0.0, 50)
    assert_allclose(cone.control_boundary(far, CONE, N),
                    D - far*TAN - 2.5*TAN - 10*g(far + 2.5), atol=1e-12)
    assert_allclose(cone.control_boundary(near, CONE, N), D + near/0.25*g(0.0), atol=1e-12)


def test_a_drift_that_leaves_the_boundary_meets_the_wall_before_a_command_acts():
    # what the boundary is for, by integration: from just outside it at the rate of the drift,
    # the wall is reached within the delay or a little later (g grows on the way)
    x = -15.0
    r = float(cone.control_boundary(x, CONE, N))
    vy = float(cone.drift_rate(cone.radius(x + 2.5, CONE), N))
    end = r + 10.0*vy
    assert end == pytest.approx(float(cone.radius(x + 2.5, CONE)), abs=1e-12)


@given(st.floats(-1000.0, 0.0), st.floats(0.01, 0.3), st.floats(0.0, 20.0))
def test_p14_the_boundary_lies_between_axis_and_wall(x, rate, delay):
    r = cone.control_boundary(x, CONE, N, rate, delay)
    assert 0.0 <= r <= cone.radius(x, CONE)


@given(stations, st.floats(0.05, 0.3), st.floats(0.5, 18.0))
def test_the_boundary_has_no_jump(x, rate, delay):
    near = cone.control_boundary([x - 1e-9, x + 1e-9], CONE, N, rate, delay)
    assert abs(near[0] - near[1]) < 1e-7


def test_the_printed_boundary_jumps_where_its_pieces_meet():
    before, after = cone.control_boundary([-2.5, -2.5 + 1e-9], CONE, N, at_arrival=False)
    assert before == pytest.approx(0.112, abs=5e-4) and after == pytest.approx(0.143, abs=5e-4)


def test_it_degenerates_beyond_a_delay_of_19_seconds():
    def at_its_narrowest(delay):
        return cone.control_boundary(-0.25*delay, CONE, N, delay=delay, clamp=False)

    assert at_its_narrowest(19.0) > 0 > at_its_narrowest(19.2)
    assert cone.control_boundary(-4.8, CONE, N, delay=19.2) == 0.0
    assert D / cone.drift_rate(D, N) == pytest.approx(19.1, abs=0.05)


def test_without_delay_the_boundary_is_the_wall():
    x = np.linspace(-30.0, 0.0, 7)
    assert_allclose(cone.control_boundary(x, CONE, N, delay=0.0), cone.radius(x, CONE))


def test_past_the_docking_plane_there_is_no_time_left():
    assert cone.control_boundary(0.5, CONE, N) == cone.radius(0.5, CONE)


def test_an_unknown_station_has_no_boundary():
    assert np.isnan(cone.control_boundary(np.nan, CONE, N))


@pytest.mark.parametrize('change', [{'rate': 0.009}, {'rate': 0.0}, {'rate': np.nan},
                                    {'rate': np.inf}, {'delay': -1.0}, {'delay': np.nan},
                                    {'n': 0.0}])
def test_an_impossible_boundary_is_refused_with_name_and_value(change):
    (name, value), = change.items()
    with pytest.raises(ValueError, match=f'{name} must .*, got {value}'):
        cone.control_boundary(-5.0, **{'corridor': CONE, 'n': N, **change})
