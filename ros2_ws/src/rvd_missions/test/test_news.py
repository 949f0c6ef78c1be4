"""A filter that begins anew says so: it is in `news` of its block, and on /run/events."""

import numpy as np
import pytest
import rclpy

from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.main import make, wanted
from rvd_dynamics.diagram.run import Legs, Run
from rvd_missions.lunar_approach.signals import COMMAND, TELEMETRY
from rvd_missions.obstacle_field.navigation import NavigationParams, Tracker
from rvd_missions.obstacle_field.settings import Obstacles, Orbit


@pytest.fixture
def predictor(own_domain, monkeypatch):
    """Return the node of the predictor, made and not started, and the events that it sends."""
    monkeypatch.setenv('RVD_LEAN', '1')
    words = ['/x/state_predictor', '--ros-args', '-p', 'seed:=7']
    rclpy.init(args=words)
    host, events = Host(parsed(words)), []
    monkeypatch.setattr(host, 'event', lambda node, code, text: events.append((code, text)))
    make(host, wanted(host, host.arguments))
    yield host.nodes['state_predictor'], events
    for node in host.nodes.values():
        node.destroy_node()
    rclpy.try_shutdown()


@pytest.mark.parametrize('off_m, expected', [(0.0, []), (300.0, ['OUTLIERS'])])
def test_a_node_tells_once_that_its_filter_began_anew(predictor, off_m, expected):
    node, events = predictor
    node.make()
    state, told = node.scenario.part('start').state, []
    for k in range(40):
        sample = state.copy()
        sample[0] += off_m if k >= 20 else 0.0
        node.on_step(k, {'telemetry': TELEMETRY(state=sample, received=np.bool_(True)),
                         'command': COMMAND.initial(())})
        told.append(len(events))
    assert [code for code, _ in events] == expected
    if expected:
        assert told.index(1) == 30 and events[0][1].startswith('telemetry: 10 in a row')


def test_the_obstacle_is_named_whose_filter_began_anew_and_no_other():
    obstacles = Obstacles()
    made = Tracker(NavigationParams(), Orbit(), Run(), Legs(0, 0, 1.0), obstacles, ())
    there = np.zeros((obstacles.count, 6))
    said = []
    for k in range(40):
        seen = there.copy()
        if k >= 10:
            seen[1, :3] += 1e4
        made.advance(k, seen, np.bool_(True))
        said.append(made.news())
    assert [k for k, news in enumerate(said) if news] == [20]
    assert 'obstacle 1: 10 in a row' in said[20][0][1]
