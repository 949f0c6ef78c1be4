"""
A tether with mass: the massless plant in both limits, invariants of a free chain, a taut string.
"""

from pathlib import Path

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_missions.tether import beads, motion
from rvd_missions.tether.space import DynamicsParams
from tether_cases import CRAFT, GEO, over_step, plant_start, TETHER

ROOT = Path(__file__).resolve().parents[4]
EA, RHO = TETHER.stiffness_n, 1440.0*np.pi*0.5e-3**2            # [N], [kg/m]
NOWHERE = np.zeros((3, 3))              # no gravity, no turning
H = 0.02
PULL = np.array([[0.3, 0.05, 0.03, -0.02, 1e-3, -5e-4, 2e-4]])


def paid_out(piece, density, seconds=30.0):
    """Return state, count and lengths of a gripper that pulls its tether out at 1 m/s."""
    tether = np.array([EA, 0.1, piece, density])
    parts = beads.parts_of(H, piece, EA, density)
    state, chain, count = plant_start(), np.zeros((1, 40, 6)), np.zeros(1, dtype=np.int64)
    lengths = []
    for k in range(round(seconds/H)):
        state, chain, count, found = beads.advance(
            state, chain, count, PULL, over_step(GEO, k*H, H), CRAFT[np.newaxis], tether, H, parts)
        lengths.append(found[0, 0])
    return state[0], int(count[0]), np.array(lengths)


def without_mass(seconds=30.0):
    state = plant_start()
    for k in range(round(seconds/H)):
        state = motion.advance(state, PULL, over_step(GEO, k*H, H), CRAFT[np.newaxis], H)
    return state[0]


def test_before_a_bead_is_out_it_is_the_tether_without_mass():
    state, count, _ = paid_out(81.0, RHO)
    assert count == 0
    assert_allclose(state[:6], without_mass()[:6], atol=1e-6)
    assert_allclose(state[6:], without_mass()[6:], atol=2e-5)   # attitude: first order in its parts


def test_what_mass_costs_goes_to_nothing_with_the_mass():
    """In proportion: half the density, half the difference."""
    plain = without_mass()[:3]
    whole, half = (paid_out(4.0, part*RHO)[0][:3] - plain for part in (1.0, 0.5))
    assert 1e-4 < np.linalg.norm(whole) < 0.1
    assert_allclose(whole, 2.0*half, atol=0.1*np.linalg.norm(whole))


def test_the_length_that_is_paid_out_has_no_step_where_a_bead_is_added():
    _, count, lengths = paid_out(4.0, RHO)
    assert count >= 5
    assert np.abs(np.diff(lengths, 2)).max() < 2e-3
    assert lengths[-1] == pytest.approx(lengths[0] + np.diff(lengths).sum())


def chain_of(n, piece, spread=0.0, stretch=0.0):
    """Return a gripper and n beads along x, the gripper outermost."""
    rng = np.random.default_rng(3)
    place = piece*(1.0 + stretch)*np.arange(n + 1, 0, -1)
    all_ = np.zeros((n + 1, 6))
    all_[:, 0] = place
    all_[:, 1:3] += spread*rng.normal(size=(n + 1, 2))
    all_[:, 3:] += spread*rng.normal(size=(n + 1, 3))
    state = np.zeros((1, 13))
    state[0, :6], state[0, 9] = all_[0], 1.0
    return state, np.ascontiguousarray(all_[np.newaxis, 1:])


def test_a_free_chain_keeps_momentum_angular_momentum_and_energy():
    n, piece, soft = 5, 4.0, 50.0       # soft, so that it swings through
    state, chain = chain_of(n, piece, 0.05, stretch=0.02)
    mass = np.array([36.0, *[RHO*piece]*n])
    tether = np.array([soft, 0.0, piece, RHO])
    count, craft = np.array([n]), np.array([[36.0, 0.6, 2.1, 2.2, 0.25, 0.0, 0.0, 0.0]])

    def told():
        r = np.concatenate([state[:, :3], chain[0, :, :3]])
        v = np.concatenate([state[:, 3:6], chain[0, :, 3:]])
        stretch = np.maximum(np.linalg.norm(np.diff(r, axis=0), axis=-1) - piece, 0.0)
        return (mass @ v, mass @ np.cross(r, v),
                0.5*mass @ (v*v).sum(axis=1) + 0.5*soft/piece*(stretch**2).sum())
    first = told()
    swing = []
    for _ in range(100):
        state, chain, count, _ = beads.advance(state, chain, count, np.zeros((1, 7)), NOWHERE,
                                               craft,
                                               tether, H, 40)
        swing.append(np.linalg.norm(chain[0, 0, 3:]))
    assert count[0] == n and np.ptp(swing) > 0.01
    assert_allclose(told()[0], first[0], atol=1e-12)
    assert_allclose(told()[1], first[1], atol=1e-10)
    assert told()[2] == pytest.approx(first[2], rel=1e-5)


@pytest.mark.parametrize('mode', [1, 2])
def test_a_taut_chain_swings_across_at_the_frequency_of_a_string_of_beads(mode):
    """2 sqrt(T/(m a)) sin(k pi/(2 (n + 1))), near k pi/L sqrt(T/rho)."""
    n, piece, tension = 9, 1.0, 2.0
    stretch = tension/EA
    state, chain = chain_of(n, piece, stretch=stretch)
    shape = np.sin(mode*np.pi*np.arange(n, 0, -1)/(n + 1))
    chain[0, :, 1] = 1e-4*shape
    tether, count = np.array([EA, 0.0, piece, RHO]), np.array([n])
    craft = np.array([[1e9, 1e9, 1e9, 1e9, 0.25, 0.0, 0.0, 0.0]])       # a wall
    command = np.array([[tension, *[0.0]*6]])
    omega = 2.0*np.sqrt(tension/(RHO*piece*piece*(1.0 + stretch)))*np.sin(
        mode*np.pi/(2.0*(n + 1)))
    string = mode*np.pi/((n + 1)*piece)*np.sqrt(tension/RHO)
    assert omega == pytest.approx(string, rel=0.02)
    h = 2.0*np.pi/omega/40
    parts = beads.parts_of(h, piece, EA, RHO)
    across = []
    for _ in range(60):
        state, chain, count, _ = beads.advance(state, chain, count, command, NOWHERE, craft, tether,
                                               h, parts)
        across.append(chain[0, :, 1] @ shape/(shape @ shape))
    assert_allclose(across, 1e-4*np.cos(omega*h*np.arange(1, 61)), atol=2e-6)


@pytest.mark.slow
@pytest.mark.patient
def test_a_tether_with_mass_costs_a_millimetre_and_is_slack_only_while_it_rings():
    """Eight pieces ring with commands held over 20 ms for seconds, unless they are damped."""
    scenario = load(ROOT / 'scenarios' / 'tether.yaml').with_values('gripper_dynamics', beads=8)
    for damping, rings in ((0.1, True), (10.0, False)):
        batch = fly(scenario.with_values('gripper_dynamics', reel__damping_n_s=damping), [0])
        found = {name: value[0] for name, value in batch.verdict.values.items()}
        assert batch.verdict.reason[0] == 'arrived'
        assert found['range_error_m'] == pytest.approx(-0.0105 - 0.0014, abs=3e-4)
        assert found['cross_error_m'] < 2e-4 and found['attitude_error_rad'] < 2e-4
        assert found['tension_N'] >= 0.02                           # commanded
        assert (found['slack_s'] > 0.0) == rings                    # felt


def test_an_elastic_reel_and_beads_exclude_each_other():
    with pytest.raises(BadInput, match='beads must be 0 with elastic'):
        DynamicsParams(elastic=True, beads=4)
