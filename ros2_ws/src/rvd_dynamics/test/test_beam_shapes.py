"""The shapes of a cantilever, against their closed forms and against each other."""

import numpy as np
from numpy.testing import assert_allclose
from scipy.integrate import simpson

from rvd_dynamics.world.spacecraft.effectors import beam_shapes, beam_sums

ALONG = np.linspace(0.0, 1.0, 2001)


def test_the_tip_moves_by_twice_the_root_mean_square_and_the_root_is_clamped():
    shapes = beam_shapes(5, [0.0, 1e-4, 1.0])
    assert_allclose(shapes[0], 0.0, atol=1e-12)
    assert_allclose(shapes[1]/1e-4, 0.0, atol=0.05)     # no slope either
    assert_allclose(shapes[2], [2.0, -2.0, 2.0, -2.0, 2.0], rtol=1e-6)


def test_shapes_are_orthonormal_and_have_the_sums_of_the_equations_of_motion():
    shapes = beam_shapes(5, ALONG)
    product = simpson(shapes[:, :, None]*shapes[:, None, :], x=ALONG, axis=0)
    assert_allclose(product, np.eye(5), atol=1e-6)
    a, d = beam_sums(5)
    assert_allclose(simpson(shapes, x=ALONG, axis=0), a, rtol=1e-6)
    assert_allclose(simpson(ALONG[:, None]*shapes, x=ALONG, axis=0), d, rtol=1e-6)
