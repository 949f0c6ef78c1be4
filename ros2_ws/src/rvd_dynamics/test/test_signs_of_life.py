"""A process beats by the turns of its loop: when idle, too, and not while its work holds it."""

import time

import pytest
import rclpy
from test_firing import arguments, ros      # noqa: F401 - a fixture
import toy_mission

from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.main import make

HELD_S = 1.5                    # [s] three times as long as an idle process is silent


@pytest.mark.parametrize('held', [False, True])
def test_a_process_is_silent_for_as_long_as_its_work_takes_and_no_longer(held, ros):    # noqa: F811
    host = Host(arguments(toy_mission.scenario(nodes=('law',))))
    make(host, ('law',))
    node, beats, begun = host.nodes['law'], [], time.monotonic()
    plain = host._pulse.beat
    host._pulse.beat = lambda place, now_ns: (beats.append(now_ns/1e9), plain(place, now_ns))

    def work():
        timer.cancel()
        time.sleep(HELD_S if held else 0.0)
    timer = node.create_timer(0.6, work)
    try:
        host.spin(lambda: time.monotonic() - begun > 2.6)
    finally:
        node.destroy_node()
    gaps = [later - sooner for sooner, later in zip(beats, beats[1:])]
    assert rclpy.ok() and len(beats) > 3
    assert (max(gaps) > HELD_S) if held else max(gaps) < HELD_S
    assert host._pulse.beaten_s(0) is None      # it has left: what it does is nobody's concern
    assert host._pulse.left_early(0)            # stopped by the test, before a run had begun
