"""
Limit cycles of the direction angle, against the specification's table and against scipy.

`slope` below is the equation written again, from D'' and phi'' of the line of sight; scipy's DOP853
integrates it, and central differences stand in for the variational equations.
"""

from dataclasses import replace
from math import asin, cos, degrees, exp, pi, sin, sqrt

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp

from rvd_dynamics.bad_input import BadInput
from rvd_missions.elliptic_rendezvous import limit_cycles, poincare
from rvd_missions.elliptic_rendezvous.gains import CycleCase
from rvd_missions.elliptic_rendezvous.limit_cycles import cycle, follow, node, weights

ECCENTRICITIES = (0.05, 0.1, 0.2, 0.3)
COLUMNS = {     # phi_min, phi_max [deg] at those eccentricities; at 0.3 the first two are unstable
    'R1': (CycleCase(), ((16.73, 24.88), (11.99, 28.88), (-3.27, 37.71), (-72.83, 43.11))),
    'R2': (CycleCase(form='r2', k1=0.5),
           ((16.95, 25.07), (13.06, 29.62), (4.95, 41.48), (8.63, 70.57))),
    'R1 k2': (CycleCase(k2=-0.5),
              ((19.06, 22.67), (17.11, 24.36), (12.79, 27.58), (7.66, 30.63))),
    'R2 k2': (CycleCase(form='r2', k1=0.5, k2=-0.5),
              ((19.10, 22.70), (17.28, 24.50), (13.60, 28.10), (9.84, 31.71))),
    'ODRRCA': (CycleCase(law='odrrca'),
               ((-82.81, -80.91), (-83.77, -79.91), (-85.96, -77.69), (-88.82, -75.01))),
    'ODRRCA k2': (CycleCase(law='odrrca', k2=-0.5),
                  ((-82.04, -81.65), (-82.18, -81.40), (-82.40, -80.74), (-82.73, -79.76))),
}
VARIED = [CycleCase(), CycleCase(form='r2', k1=0.5, k2=-0.2), CycleCase(form='r4', k1=0.6, k2=0.3),
          CycleCase(law='odrrca', q1=0.7, k2=-0.3),
          CycleCase(law='odrrca', ff='on', phi_d_deg=50.0),
          CycleCase(law='odrrca', form='r4', ff='full', phi_d_deg=-130.0, k2=0.2)]
IDS = [f'{c.law}-{c.form}-{c.ff}' for c in VARIED]


def slope(case):
    """Return dy/dnu of the case: the line-of-sight equation with the reference rate put in."""
    def f(nu, y):
        phi, rate = y
        c = 1.0 + case.e*cos(nu)
        orbit = -2.0*case.e*sin(nu)/c                           # nu'' / nu'^2
        if case.form == 'r1':
            closing = case.k + case.k1*rate + case.k2*orbit     # D' / D
        elif case.form == 'r2':
            closing = (case.k + case.k1*rate)/(1.0 + rate) + case.k2*orbit
        else:
            closing = (case.k + case.k1*rate + case.k2*orbit)/(1.0 + rate)
        across = 0.0
        if case.law == 'odrrca':
            off = (phi - case.phi_d + pi) % (2.0*pi) - pi
            across = -case.q*off - case.q1*rate
            if case.ff != 'off':
                across += 2.0*case.k + 1.5*sin(2.0*case.phi_d)/c
            if case.ff == 'full':
                across += (1.0 + 2.0*case.k2)*orbit
        return [rate, -orbit*(1.0 + rate) - 2.0*closing*(1.0 + rate) - 1.5*sin(2.0*phi)/c + across]
    return f


def one_orbit(case, start, **options):
    """Return phi, phi' one orbit after (phi, phi') = start, by scipy."""
    found = solve_ivp(slope(case), (0.0, 2.0*pi), start, method='DOP853', rtol=1e-12, atol=1e-13,
                      **options)
    return found.y[:, -1] if not options else found


def differences(case, start, h=1e-5):
    """Return the Jacobian of the map by central differences."""
    return np.column_stack([(one_orbit(case, start + d) - one_orbit(case, start - d))/(2.0*h)
                            for d in h*np.eye(2)])


def corridor(case):
    """Return phi_min, phi_max of the cycle in degrees."""
    found = cycle(case)
    return degrees(found.phi_min), degrees(found.phi_max)


@pytest.mark.parametrize('column', COLUMNS)
def test_the_corridors_are_those_of_the_specification(column):
    case, rows = COLUMNS[column]
    for e, expected in zip(ECCENTRICITIES, rows):
        assert_allclose(corridor(replace(case, e=e)), expected, atol=0.0101, rtol=0)


@pytest.mark.parametrize('column', COLUMNS)
def test_only_the_two_cycles_without_k2_are_unstable_at_three_tenths(column):
    case, _ = COLUMNS[column]
    unstable = [e for e in ECCENTRICITIES if not cycle(replace(case, e=e)).stable]
    assert unstable == ([0.3] if column in ('R1', 'R2') else [])


@pytest.mark.parametrize('column,multiplier', [('R1', -23.6), ('R2', -5.32)])
def test_the_unstable_cycles_have_the_multipliers_of_the_specification(column, multiplier):
    large, small = cycle(replace(COLUMNS[column][0], e=0.3)).multipliers
    assert_allclose(large, multiplier, rtol=3e-3)
    assert_allclose(large*small, exp(-2.0*pi), rtol=1e-6)


@pytest.mark.parametrize('k2,widths', [(0.0, (1.90, 3.86, 8.30, 13.94)), (-0.5, (0.0,)*4)])
def test_feed_forward_centres_the_corridor_and_leaves_these_widths(k2, widths):
    for e, width in zip(ECCENTRICITIES, widths):
        low, high = corridor(CycleCase(law='odrrca', e=e, k2=k2, ff='on'))
        assert_allclose(high - low, width, atol=0.0101)
        assert low <= -90.0 <= high


@pytest.mark.parametrize('phi_d_deg', [-90.0, 37.0, 180.0])
@pytest.mark.parametrize('k2', [0.0, -0.2])
def test_full_feed_forward_holds_any_direction_exactly(phi_d_deg, k2):
    case = CycleCase(law='odrrca', e=0.3, k2=k2, ff='full', phi_d_deg=phi_d_deg, q=12.0)
    assert_allclose(corridor(case), (phi_d_deg, phi_d_deg), atol=1e-8)


@pytest.mark.parametrize('case', VARIED, ids=IDS)
def test_a_cycle_closes_and_its_jacobian_is_that_of_scipy(case):
    found = cycle(replace(case, e=0.2))
    assert_allclose(one_orbit(replace(case, e=0.2), found.start), found.start, atol=1e-9)
    assert_allclose(found.jacobian, differences(replace(case, e=0.2), found.start),
                    atol=1e-7)


def test_an_unstable_cycle_closes_for_scipy_too():
    case = replace(COLUMNS['R1'][0], e=0.3)
    found = cycle(case)
    assert_allclose(one_orbit(case, found.start), found.start, atol=1e-8)
    assert_allclose(found.jacobian, differences(case, found.start), rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize('case', VARIED, ids=IDS)
def test_the_corridor_is_the_extremes_of_a_dense_solution(case):
    case = replace(case, e=0.2)
    found = cycle(case)
    dense = one_orbit(case, found.start, t_eval=np.linspace(0.0, 2.0*pi, 20001)).y[0]
    assert_allclose((found.phi_min, found.phi_max), (dense.min(), dense.max()), atol=1e-6)


@pytest.mark.parametrize('case', VARIED, ids=IDS)
@pytest.mark.parametrize('parameter', limit_cycles.PARAMETERS)
def test_the_derivative_by_each_parameter_is_a_difference_quotient(case, parameter):
    case, h = replace(case, e=0.15), 1e-5
    w, place = weights(case), limit_cycles.PARAMETERS[parameter][0]
    column = poincare.orbit_map(0.4, 0.1, w, place, 1e-12)[6:8]
    ends = []
    for sign in (1, -1):
        w = weights(case)
        w[place] += sign*h
        ends.append(poincare.orbit_map(0.4, 0.1, w, -1, 1e-12)[:2])
    assert_allclose(column, (ends[0] - ends[1])/(2.0*h), atol=2e-6)


@pytest.mark.parametrize('form,k1,q1', [('r1', 1.3, 0.0), ('r2', 0.5, 0.0), ('r4', 0.8, 0.0),
                                        ('r1', 1.0, 0.4), ('r2', 0.7, 0.3)])
def test_the_map_contracts_areas_as_liouville_says(form, k1, q1):
    case = CycleCase(law='odrrca', form=form, k1=k1, q1=q1, e=0.15, k=-0.4, k2=-0.1)
    damping = 2.0*((k1 + case.k) if form == 'r1' else k1) + q1
    assert_allclose(np.linalg.det(cycle(case).jacobian), exp(-2.0*pi*damping), rtol=1e-5)


def test_on_the_circle_the_cycle_is_the_equilibrium_with_its_own_exponents():
    found = cycle(CycleCase(e=0.0))
    phi = asin(2.0/3.0)/2.0
    assert_allclose((found.phi_min, found.phi_max), (phi, phi), atol=1e-12)
    assert_allclose(degrees(phi), 20.905, atol=1e-3)
    # phi'' = -2 (k + k1) phi' - 3 cos 2 phi phi, linear: -0.5 +- i sqrt(3 cos 2 phi - 0.25)
    root = -0.5 + 1j*sqrt(3.0*cos(2.0*phi) - 0.25)
    assert_allclose(sorted(found.multipliers, key=np.imag),
                    sorted(np.exp(2.0*pi*np.array([root, root.conjugate()])), key=np.imag),
                    atol=1e-8)


def test_the_same_cycle_stands_half_a_turn_on_for_rrca():
    case = CycleCase(e=0.2)
    start = cycle(case).start + [pi, 0.0]
    assert_allclose(one_orbit(case, start), start, atol=1e-9)


def test_no_cycle_where_the_circle_has_no_equilibrium_and_beyond_the_fold():
    assert node(CycleCase(k=-0.76, k1=1.3)) is None
    assert cycle(CycleCase(k=-0.76, k1=1.3)) is None
    assert cycle(CycleCase(form='r2', k1=0.5, e=0.439)) is not None
    assert cycle(CycleCase(form='r2', k1=0.5, e=0.441)) is None
    assert cycle(CycleCase(e=0.88)) is not None             # R1 goes on, unstable


@pytest.mark.parametrize('column,expected', [
    ('R1', [('period doubling', 0.264)]),
    ('R2', [('period doubling', 0.2778), ('fold', 0.4397)])])
def test_branches_lose_stability_by_period_doubling_and_r2_folds(column, expected):
    branch = follow(COLUMNS[column][0], 'e', 0.0, 0.9)
    kinds = [(event.kind, event.at) for event in branch.events]
    for kind, at in expected:
        assert min(abs(at - a) for k, a in kinds if k == kind) < 2e-4
    assert branch.stable[branch.at < 0.26].all() or column == 'R2'
    assert ('fold' in dict(kinds)) == (column == 'R2')
    assert branch.at.max() >= (0.9 if column == 'R1' else 0.4396)
    if column == 'R2':                                      # back to the saddle of the circle
        assert_allclose(branch.at[-1], 0.0, atol=1e-12)
        assert_allclose(degrees(branch.starts[-1][0]), 90.0 - 20.905, atol=1e-3)


def test_at_the_period_doubling_scipy_finds_the_multiplier_minus_one():
    event = follow(CycleCase(), 'e', 0.2, 0.3).events[0]
    case = CycleCase(e=event.at)
    assert_allclose(one_orbit(case, event.start), event.start, atol=1e-8)
    assert_allclose(np.linalg.eigvals(differences(case, event.start)).min(), -1.0, atol=1e-4)


@pytest.mark.parametrize('parameter,first,last', [
    ('k', -0.5, -0.3), ('k1', 1.0, 1.5), ('k2', 0.0, -0.5), ('e', 0.1, 0.2)])
def test_a_branch_in_any_parameter_leads_to_the_cycle_that_is_found_directly(
        parameter, first, last):
    branch = follow(CycleCase(), parameter, first, last)
    assert_allclose(branch.at[-1], last)
    direct = cycle(replace(CycleCase(), **{parameter: float(branch.at[-1])}))
    assert_allclose(branch.starts[-1], direct.start, atol=1e-8)


@pytest.mark.parametrize('parameter,first,last', [
    ('q', 10.0, 30.0), ('q1', 0.0, 4.0), ('phi_d', -1.57, -0.5)])
def test_so_does_one_in_a_gain_of_the_transverse_thruster(parameter, first, last):
    branch = follow(CycleCase(law='odrrca'), parameter, first, last)
    at = float(branch.at[-1])
    given = {'phi_d_deg': degrees(at)} if parameter == 'phi_d' else {parameter: at}
    assert_allclose(branch.starts[-1],
                    cycle(CycleCase(law='odrrca', **given)).start, atol=1e-8)


def test_the_cycle_attracts_what_starts_far_from_it():
    case = CycleCase(e=0.1)
    path = limit_cycles.settled(case, (-60.0, 0.0), orbits=8)
    turns = round((path[-1, 0] - cycle(case).start[0])/pi)  # perhaps the twin half a turn on
    assert_allclose(path[-1] - [pi*turns, 0.0], cycle(case).start, atol=1e-6)


@pytest.mark.parametrize('given,words', [
    ({'e': 1.0}, 'e must be below 1'), ({'e': -0.1}, 'e must not be negative'),
    ({'e': float('nan')}, 'e must'), ({'k': 0.1}, 'k must not be positive'),
    ({'k1': 0.5}, 'k1 must be above -k = 0.5'), ({'form': 'r2', 'k1': 0.0}, 'k1 must be above 0'),
    ({'q': 0.0}, 'q must be positive'), ({'q1': -1.0}, 'q1 must not be negative'),
    ({'law': 'pid'}, 'law must be one of rrca, odrrca')])
def test_impossible_cases_are_refused_by_name_value_and_reason(given, words):
    with pytest.raises(BadInput) as refused:
        CycleCase(**given)
    assert str(refused.value).startswith(words) and '\n' not in str(refused.value)
    assert str(list(given.values())[-1]) in str(refused.value)


def test_damping_across_makes_up_for_k1():
    CycleCase(law='odrrca', k1=0.3, q1=0.5)                 # -0.2 + 0.25 > 0
    with pytest.raises(BadInput, match=r'k1 must be above -k - q1/2 = 0.4'):
        CycleCase(law='odrrca', k1=0.3, q1=0.2)
