"""What the thrusters give for a command."""

import numpy as np
import pytest

from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.world.spacecraft.thrusters import execute

EFFECT = LevelForm().effect


def test_without_noise_table_2_is_executed():
    assert execute(EFFECT([3, -1, 2]), np.ones(3), 0.0).tolist() == [0.03, -0.005, 0.01]


def test_noise_is_one_percent_of_the_thrust():
    normals = np.random.default_rng(3).standard_normal((40_000, 3))
    accel = execute(EFFECT(np.broadcast_to([3, -2, 1], (40_000, 3))), normals, 0.01)
    nominal = np.array([0.03, -0.01, 0.005])
    # 5 standard errors of a deviation and of a mean of 40,000 draws
    np.testing.assert_allclose(accel.std(axis=0), 0.01*np.abs(nominal), rtol=0.018)
    assert np.all(np.abs(accel.mean(axis=0) - nominal) < 5 * 0.01*np.abs(nominal) / 200)


def test_a_draw_of_one_deviation_is_one_percent_more():
    assert execute(EFFECT([1, 0, -3]), [1.0, 1.0, 1.0], 0.01) == pytest.approx([.0101, 0, -.0202])


def test_nothing_commanded_is_nothing_executed():
    assert execute(EFFECT([0, 0, 0]), [3.0, -4.0, 5.0], 0.01).tolist() == [0.0, 0.0, 0.0]


def test_an_unknown_draw_is_an_unknown_thrust():
    accel = execute(EFFECT([0, 1, 1]), [np.nan, np.nan, 0.0], 0.01)
    assert np.isnan(accel).tolist() == [True, True, False]


def test_an_impossible_level_fires_nothing():
    with pytest.raises(ValueError, match='levels must be -3 to 3'):
        execute(EFFECT([0, 0, 4]), np.zeros(3), 0.01)
