"""
The filters of the tether, of docking and of obstacles leave outliers out, and are not locked out.
"""

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.onboard.navigation.filters import FilterParams, Navigation
from rvd_missions.tether.observer import Observer, ObserverParams
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams

@pytest.fixture
def observer():
    return Observer(ObserverParams(), OrbitParams(), GripperParams(), TetherParams(),
                    ApproachParams(),
                    0.1, 2)


@pytest.mark.parametrize('bad', [1e308, -1e15, 1e4])
def test_the_observer_of_the_tether_leaves_an_outlier_out(observer, bad):
    said = observer.take(0, np.full((2, 3), np.nan))
    for k in range(1, 20):
        z = said.copy()
        if k == 9:
            z[0], z[1] = np.nan, bad            # the other row has lost it
        with np.errstate(over='ignore'):
            said = observer.take(k, z)
        assert np.isfinite(observer.state).all() and np.isfinite(said).all()
    assert_array_equal(observer.state[0], observer.state[1])


def test_the_observer_is_not_locked_out(observer):
    said = observer.take(0, np.full((2, 3), np.nan))
    z = said + [30.0, 0.0, 0.0]                 # the encoder says 30 m more, for good
    off, news = [], []
    for k in range(1, 40):
        said = observer.take(k, z)
        news += [(k, text) for _, text in observer.news()]
        off.append(np.abs(z - said)[0, 0])
    assert min(off[:10]) > 20.0 and off[-1] < 3.0 and observer._missed.max() <= 10
    assert np.isfinite(observer.covariance).all()
    assert news[0][0] == 11 and news[0][1].startswith('length of the tether: 10 in a row')
    observer.take(40, np.full((2, 3), np.nan))
    assert not observer.news()                  # of a step in which nothing was measured



# -- docking ---------------------------------------------------------------------------------------

PORT = np.array([-1.0, 0.0, 0.0])


def navigation(rows):
    return Navigation(FilterParams(), 0.02, 1, 0.1, 1e-3, PORT, rows)


def view(place, turn=(0.0, 0.0, 0.0, 1.0), rows=1):
    return (np.tile(np.asarray(place, float), (rows, 1)),
            np.tile(np.asarray(turn, float), (rows, 1)),
            np.tile(np.diag([1e-4]*3 + [1e-5]*3), (rows, 1, 1)))


def fly(made, views, rows=1):
    still = np.zeros((rows, 3))
    return [made.step(still, still, seen) for seen in views]


@pytest.mark.parametrize('place, turn', [
    ((1e308, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)), ((1e15, 1e15, 1e15), (0.0, 0.0, 0.0, 1.0)),
    ((50.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)), ((9.0, 0.0, 0.0), (1e15, 0.0, 0.0, 1.0))])
def test_a_view_that_cannot_be_is_as_good_as_none(place, turn):
    usual = [view((9.0, 0.0, 0.0)) if k % 5 == 0 else None for k in range(60)]
    hostile, without = list(usual), list(usual)
    hostile[30], without[30] = view(place, turn), None
    with np.errstate(all='ignore'):
        ours, theirs = fly(navigation(1), hostile), fly(navigation(1), without)
    for a, b in zip(ours, theirs):              # an attitude that can be is taken
        np.testing.assert_allclose(a.position, b.position, atol=1e-2)
        np.testing.assert_allclose(a.attitude, b.attitude, atol=1e-4)
    assert np.isfinite(ours[-1].position).all() and max(np.nanmax(n.nis) for n in ours[29:34]
                                                        if np.isfinite(n.nis).any()) > 1e4


def test_navigation_is_not_locked_out():
    made = navigation(1)
    seen = [view((9.0, 0.0, 0.0)) if k % 5 == 0 else None for k in range(50)]
    seen += [view((3.0, 0.0, 0.0)) if k % 5 == 0 else None for k in range(50, 150)]
    assert not made.news()
    got, news = [], []
    for k, one in enumerate(seen):
        got += fly(made, [one])
        news += [(k, text) for _, text in made.news()]
    assert [k for k, _ in news] == [100] and 'views of the camera: 10 in a row' in news[0][1]
    assert abs(got[95].position[0, 0] - got[45].position[0, 0]) < 0.1       # ten are left out
    assert got[-1].position[0, 0] - got[45].position[0, 0] == pytest.approx(6.0, abs=0.1)


def test_a_first_view_that_is_no_attitude_is_not_begun_with():
    made = navigation(1)
    got = fly(made, [view((9.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)), view((9.0, 0.0, 0.0))])
    assert np.isnan(got[0].position).all() and np.isfinite(got[1].position).all()
