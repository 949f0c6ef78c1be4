"""The law safe_apf along a docking axis: its speeds by closed form, its pull by symmetry."""

from math import exp

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_allclose
from paper import Paper
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.guidance.safe_approach import ApproachAim, ApproachCorridor, SafeApproach

PAPER = Paper()
HERE = {'aim': ApproachAim(beyond_m=0.0), 'response_s': 0.0}
PUBLISHED = {**HERE, 'max_speed_m_s': 1.0, 'slowing_per_m': 0.0045,
             'speed_corridor': ApproachCorridor(contact_speed_m_s=5e-4, slope_per_s=0.005)}
offsets, rates = st.floats(-0.5, 0.5), st.floats(-0.3, 0.3)


def speed_m_s(law, x):
    """Return the closing speed that a chaser at rest on the axis is asked for."""
    response = law.response_s or PAPER.step_s
    return law.wanted([x, 0.0, 0.0, 0.0, 0.0, 0.0], None)[0] * response


def test_published_speeds_at_30_m_with_and_without_the_corridor():
    free = PAPER.law(SafeApproach, **{**PUBLISHED, 'speed_corridor': ApproachCorridor(form='none')})
    assert speed_m_s(free, -30.0) == pytest.approx(1.0 - exp(-0.0045*30.0), rel=1e-12)
    kept = PAPER.law(SafeApproach, **{**PUBLISHED, 'max_speed_m_s': 2.0})
    assert speed_m_s(kept, -30.0) == pytest.approx(5e-4 + 0.005*30.0, rel=1e-12)


def test_the_tuned_law_wants_a_quarter_of_a_metre_per_second_at_30_m_and_crosses_the_plane():
    law = PAPER.law(SafeApproach)
    assert speed_m_s(law, -30.0) == pytest.approx(0.25, abs=5e-4)
    assert 0.05 < speed_m_s(law, 0.0) < 0.3


def test_without_an_aim_point_the_speed_dies_at_the_plane_unless_a_least_one_is_kept():
    assert speed_m_s(PAPER.law(SafeApproach, **PUBLISHED), -0.01) < 1e-4
    floor = {**PUBLISHED, 'aim': ApproachAim(beyond_m=0.0, least_closing_m_s=0.1)}
    assert speed_m_s(PAPER.law(SafeApproach, **floor), -0.01) == pytest.approx(0.1)
    assert speed_m_s(PAPER.law(SafeApproach, **floor), -30.0) == pytest.approx(
        speed_m_s(PAPER.law(SafeApproach, **PUBLISHED), -30.0))      # above the floor: untouched


@given(offsets, offsets, rates, rates, rates, st.floats(0.5, 50.0))
def test_an_aim_point_is_a_shift_of_the_whole_law(y, z, u, v, w, beyond):
    far = PAPER.law(SafeApproach, aim=ApproachAim(beyond_m=beyond))
    near = PAPER.law(SafeApproach, aim=ApproachAim(beyond_m=0.0))
    assert_allclose(far.wanted([-20.0, y, z, u, v, w], None),
                    near.wanted([-20.0 - beyond, y, z, u, v, w], None), rtol=1e-12, atol=1e-15)


@given(offsets, offsets, rates, rates, st.floats(0.0, 6.3))
def test_it_knows_no_direction_round_the_axis(y, z, v, w, angle):
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s], [s, c]])
    law = PAPER.law(SafeApproach)
    straight = law.wanted([-12.0, y, z, 0.2, v, w], None)
    turned = law.wanted([-12.0, *(turn @ [y, z]), 0.2, *(turn @ [v, w])], None)
    assert_allclose(turned, [straight[0], *(turn @ straight[1:])], atol=1e-14)


def test_an_error_of_velocity_is_removed_in_the_response_time():
    law = PAPER.law(SafeApproach, response_s=4.0)
    one = law.wanted([-20.0, 0.3, 0.0, 0.2, 0.01, 0.0], None)
    other = law.wanted([-20.0, 0.3, 0.0, 0.1, 0.05, 0.02], None)
    assert_allclose(other - one, [0.1/4, -0.04/4, -0.02/4], rtol=1e-12)


@pytest.mark.parametrize('given_, said', [
    ({'attraction': -1.0}, 'attraction must be above 0 and at most 100, got -1.0'),
    ({'max_speed_m_s': -0.25}, 'max_speed_m_s must be above 0'),
    ({'slowing_per_m': 0.0}, 'slowing_per_m must be above 0'),
    ({'contact_m': -2.0}, 'contact_m must be between 0 and 1000, got -2.0'),
    ({'response_s': -1.0}, 'response_s must be between 0 and 1000, got -1.0'),
    ({'contact_m': 5.0, 'target_repulsion': 'empirical'}, 'target_range_m must be above')])
def test_gains_of_the_wrong_sign_are_refused(given_, said):
    with pytest.raises(BadInput) as refused:
        SafeApproach(**given_)
    assert str(refused.value).startswith(said)
