"""Two laws compared run by run: on tables whose means and intervals are known beforehand."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy import stats

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording.worded import worded
from rvd_missions.attitude_hold import comparison
from rvd_missions.attitude_hold.campaign_figures import comparison as drawn, DRAWN

RUNS = np.arange(40)


def tables(effect=1.0, cell='faults=a,world=x1', **changed):
    chance = np.random.default_rng(3)
    base = {name: chance.uniform(5.0, 9.0, RUNS.size) for name in comparison.MEASURES}
    noise = chance.normal(0.0, 0.1, RUNS.size)
    other = {name: values + effect + noise for name, values in base.items()}
    return {f'golden_section,{cell}': {'run': RUNS, **base, **changed},
            f'pid,{cell}': {'run': RUNS, **other}, f'golden_section,{cell} alone': {'run': RUNS}}


def test_a_difference_is_paired_and_its_interval_is_that_of_scipy():
    found = {row.measure: row for row in comparison.rows(tables())}
    assert set(found) == set(comparison.MEASURES)
    one, both = found['overshoot_deg'], tables()
    pair = [both[f'{law},faults=a,world=x1']['overshoot_deg'] for law in comparison.LAWS]
    low, high = stats.ttest_rel(*pair).confidence_interval(0.95)
    assert (one.difference.low, one.difference.high) == pytest.approx((low, high))
    assert one.difference.sign == -1 and one.difference.value == pytest.approx(-1.0, abs=0.06)
    # each mean by itself scatters far more than the difference does
    assert one.first.high - one.first.low > 5.0*(high - low)
    assert 'smaller with golden_section in 1 cells' in comparison.in_words(list(found.values()))


def test_runs_in_which_a_measure_is_unknown_are_left_out_and_counted():
    unknown = np.where(RUNS < 10, np.nan, 7.0)
    row, = comparison.rows(tables(settling_s=unknown), ('settling_s',))
    assert row.difference.runs == 30 and row.first == comparison.Mean(7.0, 7.0, 7.0, 30)
    row, = comparison.rows(tables(settling_s=np.full(RUNS.size, np.nan)), ('settling_s',))
    assert row.difference.runs == 0 and row.difference.sign == 0


def test_conditions_of_a_pair_with_other_runs_are_refused():
    with pytest.raises(BadInput, match='the same runs'):
        comparison.rows(tables(run=RUNS[::-1]))


def test_the_figure_draws_every_cell_with_both_laws_and_the_difference():
    figure, words = drawn(SimpleNamespace(tables={
        **tables(), **tables(-1.0, 'faults=b,world=x1'), **tables(0.0, 'faults=b,world=x5')}))
    left, right = figure.axes[:2]
    assert len(figure.axes) == 2*len(DRAWN)
    assert [line.get_label() for line in left.lines] == [worded(law) for law in comparison.LAWS]
    assert all(len(line.get_xdata()) == 3 for line in left.lines)
    middles = [line.get_ydata()[0] for line in right.lines if line.get_marker() == 'o']
    assert middles == pytest.approx([-1.0, 1.0, 0.0], abs=0.06)
    assert 'smaller with golden section in 1 of 3 cells, with PID in 1' in words
