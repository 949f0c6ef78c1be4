"""The test of landings above and below: other software, false alarms, and what it says."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import chi2_contingency

from rvd_missions.lunar_approach.campaign_figures import _skew, skew_z

COUNTS = [((8557, 15261), (9826, 18237)), ((30, 40), (10, 45)), ((1, 50), (3, 20))]


@pytest.mark.parametrize('a, b', COUNTS)
def test_the_square_is_pearsons_of_the_table_of_four(a, b):
    pearson = chi2_contingency([[a[0], a[1] - a[0]], [b[0], b[1] - b[0]]], correction=False)
    assert_allclose(skew_z(a, b)**2, pearson.statistic, rtol=1e-10)
    assert np.sign(skew_z(a, b)) == np.sign(a[0]/a[1] - b[0]/b[1]) == -np.sign(skew_z(b, a))


def test_landings_without_difference_alarm_as_often_as_is_said():
    upper = np.random.default_rng(3).binomial([400, 700], 0.55, (4000, 2))
    z = np.array([skew_z((int(a), 400), (int(b), 700)) for a, b in upper])
    # of 4,000 draws .05 has a standard error of .0034
    assert abs((np.abs(z) > 1.96).mean() - 0.05) < 0.014


def test_failed_runs_do_not_count_and_all_alike_is_not_a_number():
    table = {'success': np.array([True]*100 + [False]*50), 'y_m': np.array([.1]*60 + [-.1]*90)}
    made = SimpleNamespace(tables={'a': table, 'b': {**table, 'success': np.zeros(150, bool)}},
                           campaign=SimpleNamespace(compare=[('b', 'a'), ('a', 'a')]))
    assert _skew(made) == (' z of the share at y > 0 against a half: a +2.0.'
                           ' z of the difference of two such shares: a minus a +0.0.')
    assert np.isnan(skew_z((5, 5), (7, 7)))
