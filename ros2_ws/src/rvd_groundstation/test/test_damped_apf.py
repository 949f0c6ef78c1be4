"""Potential field with fixed band and damping: what damping does to energy, and where it acts."""

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.geometry.cone import outward_normal, signed_distance
from rvd_groundstation.guidance.corridor_apf import CorridorApf
from rvd_groundstation.guidance.damped_apf import DampedApf

PAPER = Paper()


def states(rows, seed):
    rng = np.random.default_rng(seed)
    x, angle = rng.uniform(-30.0, -3.0, rows), rng.uniform(0, 2*np.pi, rows)
    rho = (0.3 - x*np.tan(np.radians(3.0))) * rng.uniform(0.02, 0.98, rows)
    return np.column_stack([x, rho*np.cos(angle), rho*np.sin(angle), np.full(rows, 0.25),
                            rng.normal(0.0, 0.03, (rows, 2))])


def test_is_the_corridor_field_without_damping_and_with_the_paper_s_band():
    state = states(1000, 1)
    assert_array_equal(PAPER.law(DampedApf, damping_per_s=0.0, band_m=0.0).repulsion(state),
                       PAPER.law(CorridorApf).repulsion(state))


def test_acts_within_half_a_metre_of_the_wall_and_nowhere_else():
    state = states(4000, 2)
    state[:, 4:] = 0.0
    acts = np.abs(PAPER.law(DampedApf).repulsion(state)).max(axis=-1) > 0.0
    assert_array_equal(acts, signed_distance(state[:, :3], PAPER.cone) < 0.5)


@pytest.mark.parametrize('both_ways', [True, False])
def test_damping_is_minus_gain_times_the_rate_along_the_normal(both_ways):
    state = states(4000, 3)
    undamped = PAPER.law(DampedApf, damping_per_s=0.0).repulsion(state)
    damped = PAPER.law(DampedApf, damping_per_s=0.3, damp_return=both_ways).repulsion(state)
    normal = outward_normal(state[:, :3], PAPER.cone)
    rate = np.sum(normal*state[:, 3:], axis=-1)
    braked = rate if both_ways else np.clip(rate, 0.0, None)
    acts = signed_distance(state[:, :3], PAPER.cone) < 0.5
    expected = np.where(acts[:, None], -0.3*braked[:, None]*normal, 0.0)
    assert_allclose((damped - undamped)[:, 1:], expected[:, 1:], atol=1e-15)


def test_damping_only_ever_takes_energy_out():
    """Without motion along x the rate along the normal is lateral, and so is all power."""
    state = states(4000, 4)
    state[:, 3] = 0.0
    undamped = PAPER.law(DampedApf, damping_per_s=0.0).repulsion(state)
    extra = PAPER.law(DampedApf).repulsion(state) - undamped
    power = extra[:, 1]*state[:, 4] + extra[:, 2]*state[:, 5]
    assert power.max() <= 1e-18 and power.min() < -1e-5
