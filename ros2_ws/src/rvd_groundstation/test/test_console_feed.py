"""What a page is shown: geometry, outlook, and never the truth."""

from pathlib import Path

import numpy as np
import pytest

from rvd_dynamics.geometry.cone import signed_distance
from rvd_dynamics.mission import Mission
from rvd_dynamics.motion.cw import propagate
from rvd_dynamics.diagram.ros.graph import NODES
from rvd_groundstation.console import feed as feed_module
from rvd_groundstation.console.feed import Feed

MISSION = Mission()
SOURCES = Path(feed_module.__file__).parent


def test_the_console_watches_no_topic_that_carries_the_truth():
    watches = NODES['console'].watches
    assert not [t for t in watches if t.startswith(('/truth', '/onboard'))]


def test_the_reference_drift_leaves_the_corridor_where_the_paper_s_does():
    outlook = Feed(MISSION).outlook(np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0]))
    assert outlook['leave'] == pytest.approx(68.9, abs=0.1)
    assert outlook['plane'] == pytest.approx(120.0, abs=2.0)


@pytest.mark.parametrize('state', [
    [-20.0, 0.3, -0.2, 0.25, 0.01, -0.005], [-5.0, -0.2, 0.1, 0.24, 0.02, 0.03],
    [-12.0, 0.0, 0.5, 0.26, -0.03, 0.0]])
def test_the_time_left_is_where_the_drift_meets_the_wall(state):
    state = np.array(state)
    outlook = Feed(MISSION).outlook(state)
    times = np.linspace(0.0, 240.0, 24001)
    path = propagate(state, MISSION.orbit.mean_motion, times)
    outside = times[signed_distance(path[:, :3], MISSION.corridor) < 0.0]
    plane = times[path[:, 0] >= 0.0][0]
    assert outlook['plane'] == pytest.approx(plane, abs=0.05)
    if outside.size and outside[0] <= plane:
        assert outlook['leave'] == pytest.approx(outside[0], abs=0.1)
    else:
        assert outlook['leave'] is None


def test_who_is_outside_is_told_so():
    outlook = Feed(MISSION).outlook(np.array([-10.0, 2.0, 0.0, 0.25, 0.0, 0.0]))
    assert outlook['d'] < 0.0 and outlook['leave'] == 0.0


def test_the_geometry_of_a_run_is_the_shared_mathematics():
    made = Feed(MISSION).run_message('x')
    g = made['geometry']
    at = dict(zip(np.round(g['x'], 6), zip(g['wall'], g['boundary'])))
    assert at[-30.0][0] == pytest.approx(1.872, abs=1e-3)
    assert at[-30.0][1] == pytest.approx(1.364, abs=1e-3)
    assert at[0.0] == (pytest.approx(0.3), pytest.approx(0.3))


def test_a_frame_carries_its_three_clocks():
    feed = Feed(MISSION)
    ns = MISSION.step_ns
    feed.telemetry(30, 20 * ns, 28 * ns, 20 * ns, (-25.0, 0, 0, .25, 0, 0), 0, 0)
    state = np.array([-22.0, 0.0, 0.0, 0.25, 0.0, 0.0])
    feed.state('pred', 30, 40 * ns, state, np.full(6, 0.01), True)
    feed.command(30, 31, 0, [0, 0, 0], 3, 0.7, 0)
    frame = feed.frame()
    assert (frame['tm']['gen'], frame['tm']['rx'], frame['pred']['t']) == (10.0, 15.0, 20.0)
    assert frame['tm']['transit'] == 4.0
    assert 'truth' not in frame and frame['margin']['d'] > 0
