"""Percentiles of lateness in memory that does not grow."""

import math
import sys

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest

from rvd_dynamics.diagram.ros.lateness import Lateness


@given(st.lists(st.floats(0.0, 1e4), min_size=1, max_size=60), st.sampled_from((50, 99, 100)))
def test_percentiles_are_nearest_ranks_to_ten_microseconds_or_one_percent(late, percent):
    counted = Lateness()
    for one in late:
        counted.add(one)
    right = np.percentile(late, percent, method='inverted_cdf')
    assert counted.percentile(percent) == pytest.approx(right, rel=0.011, abs=1.1e-5)
    assert counted.percentile(100) == max(late) and len(counted) == len(late)


def test_its_memory_is_that_of_the_first():
    counted = Lateness()
    assert math.isnan(counted.percentile(50))
    size = sys.getsizeof(counted._counts)
    for k in range(20_000):
        counted.add(1e-6*k)
    assert sys.getsizeof(counted._counts) == size < 100_000
