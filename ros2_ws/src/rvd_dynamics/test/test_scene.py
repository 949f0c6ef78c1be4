"""Shapes for viewers, by geometry."""

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.geometry import surfaces
from rvd_dynamics.geometry.cone import Cone, radius, signed_distance


def rotation_of(q):
    """Return the matrix that turns by a quaternion (x, y, z, w), by its action on a vector."""
    u, w = q[:3], q[3]
    return np.array([e + 2.0 * np.cross(u, np.cross(u, e) + w * e) for e in np.eye(3)]).T


def test_corners_of_the_drawn_corridor_lie_on_its_wall():
    cone = Cone()
    x = np.linspace(-32.0, 0.0, 9)
    corners = surfaces.revolved(x, radius(x, cone), sectors=12).reshape(-1, 3)
    assert_allclose(signed_distance(corners, cone), 0.0, atol=1e-12)


def test_triangles_cover_the_surface_once():
    """The area of a many-sided prism comes near that of the cylinder, from below."""
    triangles = surfaces.revolved([0.0, 1.0, 5.0], [2.0, 2.0, 2.0], sectors=200)
    a, b, c = np.moveaxis(triangles, 1, 0)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum()
    assert 0.999 * 2 * np.pi * 2.0 * 5.0 < area < 2 * np.pi * 2.0 * 5.0


@pytest.mark.parametrize('variances', [(1, 2, 3), (2, 1, 3), (3, 2, 1), (2, 3, 1), (3, 1, 2),
                                       (1, 3, 2), (1, 1, 1), (2, 2, 1), (1, 0, 0)])
def test_quaternion_turns_the_axes_into_those_of_the_ellipsoid(variances):
    """Along the axes in any order, where the turn is none, a quarter, a third or a half."""
    half, q = surfaces.ellipsoid(np.diag(variances), 3.0)
    turn = rotation_of(q)
    assert_allclose(np.linalg.norm(q), 1.0, rtol=1e-15)
    assert_allclose(turn @ np.diag(half**2) @ turn.T, 9.0 * np.diag(variances), atol=1e-14)


def test_ellipsoid_is_the_surface_of_constant_mahalanobis_distance():
    rng = np.random.default_rng(5)
    for _ in range(50):
        a = rng.normal(size=(3, 3))
        covariance = a @ a.T + 1e-3 * np.eye(3)
        half, q = surfaces.ellipsoid(covariance, 2.0)
        directions = rng.normal(size=(20, 3))
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        points = (half * directions) @ rotation_of(q).T
        assert_allclose(np.einsum('ni,ij,nj->n', points, np.linalg.inv(covariance), points), 4.0,
                        rtol=1e-9)


def test_covariance_that_rounding_made_indefinite_draws_a_flat_ellipsoid():
    half, _ = surfaces.ellipsoid(np.diag([1.0, 1.0, -1e-18]), 1.0)
    assert_allclose(np.sort(half), [0.0, 1.0, 1.0])
