"""
Quaternions against scipy's rotations, and the sense in which they turn.
"""

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.spatial.transform import Rotation

from rvd_dynamics.motion import attitude

RNG = np.random.default_rng(3)
P, Q = (Rotation.random(50, random_state=seed) for seed in (1, 2))
V = RNG.normal(size=(50, 3))


def same_turn(a, b):
    """Assert that quaternions are equal but for their sign."""
    assert_allclose(np.abs(np.sum(a*b, axis=-1)), 1.0, atol=1e-12)


def test_products_vectors_and_matrices_agree_with_scipy():
    p, q = P.as_quat(), Q.as_quat()
    same_turn(attitude.multiply(p, q), (P*Q).as_quat())
    assert_allclose(attitude.matrix(q), Q.as_matrix(), atol=1e-14)
    assert_allclose(attitude.rotate(q, V), Q.apply(V), atol=1e-14)
    assert_allclose(attitude.rotate_back(q, V), Q.inv().apply(V), atol=1e-14)


def test_rotation_vectors_and_angles_agree_with_scipy():
    q = Q.as_quat()
    assert_allclose(attitude.rotation_vector(q), Q.as_rotvec(), atol=1e-13)
    same_turn(attitude.from_rotation_vector(V), Rotation.from_rotvec(V).as_quat())
    assert_allclose(attitude.euler(q), Q.as_euler('ZYX')[:, ::-1], atol=1e-12)
    same_turn(attitude.from_euler(attitude.euler(q)), q)


@given(st.floats(1e-12, 1e-2), st.sampled_from([1.0, -1.0]))
def test_small_turns_keep_their_digits(size, sign):
    vector = size*np.array([0.6, 0.0, -0.8])
    q = sign*attitude.from_rotation_vector(vector)
    assert_allclose(attitude.rotation_vector(q), vector, rtol=1e-12)


def test_a_body_that_turns_about_its_z_carries_its_x_axis_towards_y_of_the_reference():
    q = attitude.from_rotation_vector([0.0, 0.0, 0.1])
    assert_allclose(attitude.rotate(q, [1.0, 0.0, 0.0]), [np.cos(0.1), np.sin(0.1), 0.0])


@pytest.mark.parametrize('batch', [(), (7,), (2, 3)])
def test_a_row_of_a_batch_has_the_bits_of_the_row_alone(batch):
    q = attitude.normalised(RNG.normal(size=(*batch, 4)))
    v = RNG.normal(size=(*batch, 3))
    for function, arguments in ((attitude.multiply, (q, q[..., ::-1])), (attitude.rotate, (q, v)),
                                (attitude.matrix, (q,)), (attitude.rotation_vector, (q,)),
                                (attitude.from_rotation_vector, (v,)), (attitude.euler, (q,))):
        whole = function(*arguments)
        for at in np.ndindex(*batch):
            assert np.array_equal(function(*(a[at] for a in arguments)), whole[at])
