"""
Thrusters of the docking chaser: their layout, how they fire, and who fires for which command.
"""

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.thruster_set import require_control, ThrusterSet
from rvd_dynamics.onboard.control.allocation import Allocation, WAYS
from rvd_dynamics.world.spacecraft.reaction_control import (
    DRAWS, Failure, G0, ReactionControl, ThrusterParams)
from rvd_missions.docking.thruster_layout import layout

ALL = layout()
AUTHORITY = np.array([40.0, 40.0, 40.0, 16.0, 16.0, 16.0])
H, K = 0.01, 4                      # [s] base step, sub-steps
STILL = ThrusterParams(amplitude_sigma=0.0, direction_sigma=0.0)


def test_groups_push_and_turn_as_the_specification_says():
    b = ALL.nominal
    assert [int(ALL.of(g).sum()) for g in ('J1', 'J2', 'J3', 'J4')] == [1, 12, 12, 12]
    assert_allclose(b[:, ALL.of('J1')][:, 0], [490, 0, 0, 0, 0, 0])
    brake = ALL.of('J4') & (ALL.force == 60.0)
    assert_allclose(b[:, brake].sum(axis=1), [-240, 0, 0, 0, 0, 0], atol=1e-12)
    couples = ALL.of('J4') & (ALL.force == 10.0)
    assert_allclose(b[:3, couples].reshape(3, 4, 2).sum(axis=2), 0.0, atol=1e-12)
    torques = b[3:, couples].reshape(3, 4, 2).sum(axis=2)
    assert_allclose(np.linalg.norm(torques, axis=0), 16.0)
    assert_allclose(torques.sum(axis=1), 0.0, atol=1e-12)


def test_effectiveness_about_another_centre_moves_torques_by_the_lever():
    c = np.array([0.03, -0.02, 0.01])
    b0, b = ALL.nominal, ALL.effectiveness(c)
    assert_allclose(b[:3], b0[:3])
    assert_allclose(b[3:], b0[3:] - np.cross(c, b0[:3].T).T)
    assert ALL.effectiveness(np.zeros((5, 3))).shape == (5, 6, 37)


# -- allocation -----------------------------------------------------------------------------------

@pytest.mark.parametrize('way', WAYS)
def test_every_signed_axis_gets_its_authority_and_nothing_else(way):
    allocation = Allocation(ALL, way, AUTHORITY, ('J2',), ('J3',))
    for axis in range(6):
        for sign in (1, -1):
            command = np.zeros(6)
            command[axis] = sign
            u = allocation(command)
            assert_allclose(ALL.nominal @ u, command*AUTHORITY, atol=1e-9)
            assert np.all(u[ALL.of('J1', 'J4')] == 0.0)


@pytest.mark.parametrize('way', WAYS)
def test_no_command_fires_nothing(way):
    assert not np.any(Allocation(ALL, way, AUTHORITY, ('J2',), ('J3',))(np.zeros((3, 6))))


@pytest.fixture(scope='module')
def allocations():
    return {way: Allocation(ALL, way, AUTHORITY, ('J2',), ('J3',)) for way in WAYS}


@given(st.lists(st.sampled_from([-1, 0, 1]), min_size=6, max_size=6))
@settings(max_examples=60)
def test_any_command_of_six_axes_is_met(allocations, command):
    """Least squares know no upper bound: they may keep the direction and give less of it."""
    for way, allocation in allocations.items():
        u = allocation(command)
        assert np.all((u >= 0.0) & (u <= 1.0))
        got = ALL.nominal @ u / AUTHORITY
        share = np.abs(got).max() if way == 'nnls' and np.any(command) else 1.0
        assert share > 0.5
        assert_allclose(got, share*np.array(command), atol=1e-7)


@pytest.mark.parametrize('way', ['nnls', 'programme'])
@pytest.mark.parametrize('failed', [1, 4, 13, 20])
def test_a_failed_thruster_is_replaced_by_others(way, failed):
    """The direction of each wrench is kept; its size may shrink to what the others can give."""
    allocation = Allocation(ALL, way, AUTHORITY, ('J2',), ('J3', 'J4'))
    mask = np.arange(37) == failed
    allocation.fail(mask)
    for command in np.concatenate([np.eye(6), -np.eye(6)]):
        u = allocation(command)
        assert u[failed] == 0.0
        got = ALL.nominal @ u / AUTHORITY
        assert got @ command > (0.2 if way == 'nnls' else 0.4)
        assert_allclose(got - (got @ command)*command, 0.0, atol=1e-7)


def test_the_programme_spends_least():
    """Its propellant is not above that of the other ways, nor of a mix of what they found."""
    rng = np.random.default_rng(2)
    mask = np.isin(np.arange(37), [1, 15])
    ways = [Allocation(ALL, way, AUTHORITY, ('J2',), ('J3', 'J4')) for way in ('nnls', 'programme')]
    less = 0
    for way in ways:
        way.fail(mask)
    for command in rng.integers(-1, 2, (60, 6)):
        nnls, programme = (way(command) for way in ways)
        if np.allclose(ALL.nominal @ nnls, ALL.nominal @ programme, atol=1e-6):
            assert ALL.force @ programme <= ALL.force @ nnls + 1e-6
            less += ALL.force @ programme < ALL.force @ nnls - 1e-3
    assert less


def test_thrusters_that_cannot_make_a_wrench_are_refused_by_axis_and_rank():
    with pytest.raises(BadInput, match=r'cannot produce \+torque x alone: 13 of them are left, '
                                       r'their wrenches have rank 3 of 6') as refused:
        Allocation(ALL, 'table', AUTHORITY, ('J2',), ('J1',))
    assert '\n' not in str(refused.value)
    with pytest.raises(BadInput, match=r'cannot produce \-force x .* rank 1 of 6'):
        Allocation(ALL, 'nnls', AUTHORITY, ('J1',), ('J1',))
    allocation = Allocation(ALL, 'table', AUTHORITY, ('J2',), ('J3',))
    with pytest.raises(BadInput, match=r'cannot produce \-force z'):
        allocation.fail(np.isin(np.arange(37), [11, 12]))
    with pytest.raises(BadInput, match='one of table, nnls, programme'):
        Allocation(ALL, 'guess', AUTHORITY, ('J2',), ('J3',))


def test_rank_six_is_not_enough_if_thrusters_only_push_one_way():
    with pytest.raises(BadInput, match=r'cannot produce \-force x'):
        require_control(np.eye(6), np.ones(6, dtype=bool))


@pytest.mark.parametrize('changed, words', [
    ({'directions': [[1, 1, 0]]}, 'direction of thruster 0 must have length 1, got 1.41'),
    ({'force': [-2.0]}, 'thrust of thruster 0 must be positive, got -2 N'),
    ({'groups': ('J1', 'J2')}, 'got 1, 1, 1 and 2')])
def test_impossible_thrusters_are_refused(changed, words):
    with pytest.raises(BadInput, match=words):
        ThrusterSet(**{'places': [[0, 0, 0]], 'directions': [[1, 0, 0]], 'force': [1.0],
                       'groups': ('J1',), **changed})


# -- firing ---------------------------------------------------------------------------------------

def fired(commands, settings=STILL, rows=1, thruster=0, normals=None, **more):
    """Fire one thruster by a list of booleans; return the unit and what it did, step by step."""
    normals = np.zeros((rows, 37*DRAWS)) if normals is None else normals
    unit = ReactionControl(ALL, settings, H, K, normals, **more)
    made = []
    for k, on in enumerate(commands):
        command = np.zeros((rows, 37), dtype=bool)
        command[:, thruster] = on
        made.append(unit.step(k, command))
    return unit, made


@pytest.mark.parametrize('delay', [0.0, 0.004, 0.01, 0.015])
def test_thrust_follows_a_command_as_a_delayed_first_order_lag(delay):
    settings = ThrusterParams(amplitude_sigma=0.0, direction_sigma=0.0, delay_s=delay)
    on = [True]*6 + [False]*8
    _, made = fired(on, settings)

    def slope(t, f):
        k = int(np.floor((t - delay)/H + 1e-9))
        return (float(0 <= k < len(on) and on[k]) - f)/settings.lag_s
    expected = solve_ivp(slope, (0, len(on)*H), [0.0], max_step=1e-4, rtol=1e-9, atol=1e-12,
                         dense_output=True).sol
    for k, step in enumerate(made):
        times = k*H + np.arange(2*K + 1)*H/(2*K)
        assert_allclose(step.wrench[0, :, 0]/490.0, expected(times)[0], atol=1e-5)


def test_thrust_is_continuous_from_step_to_step():
    _, made = fired([True, False]*10)
    for a, b in zip(made, made[1:]):
        assert_allclose(a.wrench[:, -1], b.wrench[:, 0], atol=1e-12)


@given(st.integers(1, 20), st.floats(0.0, 0.05))
@settings(max_examples=25)
def test_a_pulse_has_the_impulse_and_the_propellant_of_its_length(steps, delay):
    params = ThrusterParams(amplitude_sigma=0.0, direction_sigma=0.0, delay_s=delay)
    unit, made = fired([True]*steps + [False]*60, params, thruster=1)
    length = max(steps*H, 0.04)                     # the least on-time
    assert sum(float(m.mean[0, 1]) for m in made)*H == pytest.approx(length, rel=1e-7)
    assert sum(float(m.spent[0]) for m in made) == pytest.approx(20.0*length/(290.0*G0), rel=1e-7)
    assert unit.pulses[0, 1] == 1 and unit.pulses.sum() == 1


def test_a_valve_that_is_open_long_enough_closes_at_once():
    unit, made = fired([True]*4 + [False] + [True] + [False]*20)
    assert unit.pulses[0, 0] == 2
    assert sum(float(m.mean[0, 0]) for m in made)*H == pytest.approx(0.08, rel=1e-6)


def test_pulses_scatter_by_the_given_fraction_and_directions_by_the_given_angle():
    rng = np.random.default_rng(4)
    params = ThrusterParams(amplitude_sigma=0.025, direction_sigma=0.01, lag_s=0.001, delay_s=0.0)
    normals = np.zeros((2000, 37*DRAWS))
    normals[:, :DRAWS] = rng.normal(size=(2000, DRAWS))     # of the one that fires
    _, made = fired([True]*6, params, rows=2000, normals=normals)
    force = made[-1].wrench[:, -1, :3]
    size = np.linalg.norm(force, axis=1)/490.0
    assert size.mean() == pytest.approx(1.0, abs=0.002)
    assert size.std() == pytest.approx(0.025, rel=0.06)
    for axis in (1, 2):
        assert (force[:, axis]/490.0/size).std() == pytest.approx(0.01, rel=0.06)


def test_a_pulse_keeps_its_amplitude_and_the_next_has_another():
    normals = np.random.default_rng(6).normal(size=(1, 37*DRAWS))
    _, made = fired([True]*30 + [False]*10 + [True]*30, ThrusterParams(lag_s=0.001),
                    normals=normals)
    level = np.array([m.mean[0, 0] for m in made])
    assert np.ptp(level[5:30]) < 1e-9 and np.ptp(level[45:70]) < 1e-9
    assert abs(level[10] - level[60]) > 1e-4


def test_failures_hold_from_their_step_on():
    off, made = fired([True]*40, failures=(Failure(0, 'stuck_off', 20),))
    assert made[15].mean[0, 0] > 0.99 and made[39].mean[0, 0] < 1e-4
    stuck, made = fired([False]*40, failures=(Failure(0, 'stuck_on', 20),))
    assert made[15].mean[0, 0] == 0.0 and made[39].mean[0, 0] > 0.99
    weak, made = fired([True]*40, failures=(Failure(0, 'weak', 0, 0.3),))
    assert made[39].mean[0, 0] == pytest.approx(0.3, rel=1e-3)
    assert made[39].wrench[0, -1, 0] == pytest.approx(0.3*490.0, rel=1e-3)


@pytest.mark.parametrize('failure, words', [
    (Failure(37, 'weak'), 'between 0 and 36, got 37'),
    (Failure(3, 'loud'), "one of sound, stuck_off, stuck_on, weak, got 'loud'")])
def test_an_impossible_failure_is_refused(failure, words):
    with pytest.raises(BadInput, match=words):
        fired([True], failures=(failure,))


def test_rows_have_the_bits_of_a_row_alone():
    rng = np.random.default_rng(9)
    normals, scale = rng.normal(size=(4, 37*DRAWS)), rng.uniform(0.9, 1.1, 4)
    centre = 0.03*rng.normal(size=(4, 3))
    together = ReactionControl(ALL, ThrusterParams(), H, K, normals, centre, scale)
    alone = [ReactionControl(ALL, ThrusterParams(), H, K, normals[i:i + 1], centre[i:i + 1],
                             scale[i]) for i in range(4)]
    for k in range(30):
        command = rng.random((4, 37)) < 0.3
        whole = together.step(k, command)
        for i, unit in enumerate(alone):
            for part, one in zip(whole, unit.step(k, command[i:i + 1])):
                assert np.array_equal(part[i], one[0])
