"""The blend law cell by cell, against the printed table and against rational arithmetic."""

from decimal import Decimal
from fractions import Fraction
from itertools import product
from math import ceil, isnan

from hypothesis import given, strategies as st
import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.commands import codes
from rvd_groundstation.sharing import decide, Eq25, SHARING, StickFilter

LEVELS = range(-3, 4)
CELLS = list(product(LEVELS, LEVELS))
MAN, AUTO = (np.array(v, dtype=np.int8)[:, None] for v in zip(*CELLS))

# Eq. 25 at eta = 0.7, worked out by hand: rows pilot -3..3, columns automatic -3..3.
TABLE = [
    [-3, -3, -3, -3, -2, -2, -2],
    [-3, -2, -2, -2, -2, -1, -1],
    [-2, -2, -1, -1, -1, -1, 1],
    [-1, -1, -1, 0, 1, 1, 1],
    [-1, 1, 1, 1, 1, 2, 2],
    [1, 1, 2, 2, 2, 2, 3],
    [2, 2, 2, 3, 3, 3, 3],
]


def cells(sharing):
    return sharing.share(MAN, AUTO)[:, 0].reshape(7, 7)


def rational(eta: str, man: int, auto: int) -> int:
    """Round away from zero in fractions, another road than the table of integers."""
    mix = Fraction(eta) * man + (1 - Fraction(eta)) * auto
    return ceil(abs(mix)) * (1 if mix > 0 else -1)


def test_table_of_the_paper_setting():
    assert_array_equal(cells(Eq25()), TABLE)


@pytest.mark.parametrize('spelling', [Decimal, float])
def test_equals_rational_arithmetic_on_the_whole_grid(spelling):            # P8, P12
    for hundredths in range(101):
        eta = f'{hundredths // 100}.{hundredths % 100:02d}'
        reference = [rational(eta, m, a) for m, a in CELLS]
        got = cells(Eq25(eta=spelling(eta))).ravel()
        assert_array_equal(got, reference, err_msg=f'eta {eta}')
        assert np.abs(got).max() <= 3


def test_floating_point_would_leave_the_range():
    floating = ceil(0.2 * 3 + (1 - 0.2) * 3)
    assert floating == 4 and Eq25(eta=0.2).share([3], [3]) == 3


@given(st.decimals(0, 1, allow_nan=False, places=17))
def test_sign_symmetry_and_order_for_any_decimal(eta):                      # P9
    table = cells(Eq25(eta=eta)).astype(int)
    exact = np.array([Fraction(eta)*m + (1 - Fraction(eta))*a for m, a in CELLS]).reshape(7, 7)
    assert_array_equal(np.sign(table), np.sign(exact).astype(int))
    assert_array_equal(table[::-1, ::-1], -table)
    assert (np.diff(table, axis=0) >= 0).all() and (np.diff(table, axis=1) >= 0).all()


@pytest.mark.parametrize('eta, alone', [(1, MAN), (0, AUTO)])
def test_full_weight_hands_over_one_source(eta, alone):                     # P9
    assert_array_equal(Eq25(eta=eta).share(MAN, AUTO), alone)


def test_truncation_never_asks_for_more_than_the_mean():
    table = cells(Eq25(rounding='truncate'))
    reference = np.array([int(Fraction('0.7')*m + Fraction('0.3')*a) for m, a in CELLS])
    assert_array_equal(table, reference.reshape(7, 7))


@pytest.mark.parametrize('bad', [-0.1, 1.01, float('nan'), float('inf'), Decimal('nan')])
def test_impossible_weight_is_refused_by_name(bad):
    with pytest.raises(ValueError, match=f'eta must be between 0 and 1, got {bad}'):
        Eq25(eta=bad)


@pytest.mark.parametrize('bad', ['much', '', '0.7', None])
def test_a_weight_that_is_no_number_is_refused_by_name(bad):
    with pytest.raises(ValueError, match=f'eta must be a number, got {bad!r}'):
        Eq25(eta=bad)


def test_unknown_rounding_is_refused_by_name():
    with pytest.raises(ValueError, match='rounding must be one of away, truncate, got up'):
        Eq25(rounding='up')


def test_filter_hands_over_the_automatic_levels():
    assert_array_equal(StickFilter().share(MAN, AUTO), AUTO)


@pytest.fixture(params=SHARING.values(), ids=SHARING.keys())
def sharing(request):
    return request.param()


@pytest.mark.parametrize('batch', [(), (1,), (7,), (1000,)])
def test_shape_type_and_rows(sharing, batch):
    rng = np.random.default_rng(3)
    pilot, auto = rng.integers(-3, 4, (2, *batch, 3), dtype=np.int8)
    got = sharing.share(pilot, auto)
    assert got.shape == (*batch, 3) and got.dtype == np.int8
    for row in np.ndindex(batch):
        assert_array_equal(got[row], sharing.share(pilot[row], auto[row]))


# decide: who decides, with what weight, and why

PILOT, MACHINE = [1, 0, -2], [-3, 3, 0]
BLENDED = [-1, 1, -2]
NAN = float('nan')
RULES = [   # mode, pilot valid, auto valid, levels, valid, decided by, weight, reason
    ('manual', True, True, PILOT, True, codes.BY_PILOT, NAN, codes.REASON_MODE),
    ('manual', False, True, [0, 0, 0], False, codes.BY_NOBODY, NAN, codes.REASON_PILOT_INVALID),
    ('auto', True, True, MACHINE, True, codes.BY_AUTO, NAN, codes.REASON_MODE),
    ('auto', True, False, [0, 0, 0], False, codes.BY_NOBODY, NAN, codes.REASON_AUTO_INVALID),
    ('shared', True, True, BLENDED, True, codes.BY_BLEND, 0.7, codes.REASON_NONE),
    ('shared', True, False, PILOT, True, codes.BY_BLEND, 0.7, codes.REASON_AUTO_INVALID),
    ('shared', False, True, MACHINE, True, codes.BY_AUTO, 0.0, codes.REASON_PILOT_INVALID),
    ('shared', False, False, [0, 0, 0], False, codes.BY_NOBODY, NAN, codes.REASON_BOTH_INVALID),
]


@pytest.mark.parametrize('rule', RULES, ids=lambda r: f'{r[0]}-{r[1]}-{r[2]}')
def test_rules_of_the_modes(rule):
    mode, pilot_valid, auto_valid, levels, valid, by, weight, reason = rule
    got = decide(mode, Eq25(), PILOT, pilot_valid, MACHINE, auto_valid)
    assert_array_equal(got.levels, levels)
    assert (bool(got.valid), int(got.decided_by), int(got.reason)) == (valid, by, reason)
    assert got.pilot_weight == weight or (isnan(weight) and np.isnan(got.pilot_weight))


def test_hands_off_gives_the_machine_its_full_levels():                     # P11
    neutral = decide('shared', Eq25(), [0, 0, 0], True, MACHINE, True)
    gone = decide('shared', Eq25(), [0, 0, 0], False, MACHINE, True)
    assert_array_equal(neutral.levels, [-1, 1, 0])
    assert_array_equal(gone.levels, MACHINE)


@pytest.mark.parametrize('wrong', [[NAN, 0, 0], [0, float('inf'), 0], [0, 0, 4], [-128, 0, 0],
                                   [0.5, 0, 0], [0, 1e308, 0]])
def test_a_command_out_of_range_is_invalid_as_a_whole(wrong):               # P10
    assert_array_equal(decide('manual', Eq25(), wrong, True, MACHINE, True).levels, 0)
    assert_array_equal(decide('auto', Eq25(), PILOT, True, wrong, True).levels, 0)
    assert_array_equal(decide('shared', Eq25(), wrong, True, MACHINE, True).levels, MACHINE)
    assert_array_equal(decide('shared', Eq25(), PILOT, True, wrong, True).levels, PILOT)


def test_filter_says_whether_the_pilot_passed():
    got = decide('shared', StickFilter(), [PILOT, PILOT], True, [PILOT, MACHINE], [True, True])
    assert_array_equal(got.decided_by, [codes.BY_PILOT, codes.BY_AUTO])
    assert np.isnan(got.pilot_weight).all()


@pytest.mark.parametrize('mode', ['manual', 'shared', 'auto'])
def test_rows_decide_alone(mode, sharing):
    rng = np.random.default_rng(5)
    pilot, auto = rng.integers(-4, 5, (2, 300, 3))
    flags = rng.random((2, 300)) < 0.7
    whole = decide(mode, sharing, pilot, flags[0], auto, flags[1])
    for i in range(300):
        row = decide(mode, sharing, pilot[i], flags[0, i], auto[i], flags[1, i])
        for name in row._fields:
            assert_array_equal(getattr(row, name), getattr(whole, name)[i])


def test_unknown_mode_is_refused():
    with pytest.raises(ValueError, match='got hover'):
        decide('hover', Eq25(), PILOT, True, MACHINE, True)
