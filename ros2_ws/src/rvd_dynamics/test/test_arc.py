"""Hermite arcs and the searches on them, against scipy and closed forms."""

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.interpolate import CubicHermiteSpline

from rvd_dynamics.geometry import arc, cone

DT = 0.5
RNG = np.random.default_rng(8)
START, END = RNG.normal(size=(2, 6, 40))
POINTS = arc.control_points(START, END, DT)


def test_an_arc_is_the_cubic_hermite_spline():
    s = np.linspace(0.0, 1.0, 11)
    got = arc.position(POINTS, np.broadcast_to(s, (40, 11)))
    rates = np.stack([arc.velocity(POINTS, np.full(40, v), DT) for v in s], axis=-1)
    for k in range(40):
        spline = CubicHermiteSpline([0.0, DT], [START[:3, k], END[:3, k]],
                                    [START[3:, k], END[3:, k]])
        assert_allclose(got[:, k], spline(s*DT).T, atol=1e-14)
        assert_allclose(rates[:, k], spline(s*DT, 1).T, atol=1e-13)


def test_an_arc_meets_its_samples_to_the_bit():
    for s, state in ((0.0, START), (1.0, END)):
        assert np.array_equal(arc.position(POINTS, np.full(40, s)), state[:3])


states = st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6)


@given(states, states)
def test_no_arc_comes_nearer_to_the_wall_than_its_control_points(start, end):
    points = arc.control_points(np.array(start)[:, np.newaxis], np.array(end)[:, np.newaxis], DT)
    shape = cone.Cone()
    hull = cone.signed_distance(points[..., 0].T, shape).min()
    path = arc.position(points, np.linspace(0.0, 1.0, 101)[np.newaxis])[:, 0].T
    assert cone.signed_distance(path, shape).min() >= hull - 1e-14


@pytest.mark.parametrize('valley', [0.0, 0.01, 0.3, 0.5, 0.777, 1.0])
def test_the_lowest_point_of_a_valley(valley):
    s, least = arc.lowest(lambda s: 0.04*(s - valley)**2 + 1.0, np.ones(3))
    assert_allclose(least, 1.0, atol=0.04/1024**2)      # half a cell of 1/512 away at most
    assert_allclose(s, valley, atol=1/1024)


def test_the_lowest_point_is_sought_up_to_the_end_only():
    end = np.array([0.1, 0.6, 1.0])
    s, least = arc.lowest(lambda s: -s, end)
    assert np.array_equal(s, end) and np.array_equal(least, -end)


@pytest.mark.parametrize('root', [0.0, 1e-3, 0.25, 0.6180339887, 0.999, 1.0])
def test_the_first_root_of_a_curved_function(root):
    s = arc.first_not_positive(lambda s: (root - s)*(1.0 + 0.3*s), np.ones(2))
    assert_allclose(s, root, atol=1e-7)


def test_the_first_of_several_roots():
    s = arc.first_not_positive(lambda s: (0.2 - s)*(0.5 - s)*(0.7 - s), np.ones(1))
    assert_allclose(s, 0.2, atol=2e-6)                  # curvature over a cell of 1/1024


def test_a_root_at_the_end_is_found_though_rounding_has_lost_it():
    assert arc.first_not_positive(lambda s: 1.0 - s + 1e-16, np.ones(1)).item() == 1.0


def test_a_search_of_nothing_finds_nothing():
    assert arc.lowest(lambda s: s, np.ones(0))[0].shape == (0,)
    assert arc.first_not_positive(lambda s: s, np.ones(0)).shape == (0,)
