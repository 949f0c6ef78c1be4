"""Markers, and the RViz and Foxglove files that show them."""

import json
import os
from pathlib import Path
import re
import subprocess
import sys
import time

import numpy as np
import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
import yaml

from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.ros import markers, qos
from rvd_dynamics.diagram.ros.codecs import Parts
from rvd_dynamics.diagram.ros.conversions import header_at, vector
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load, parse
from rvd_interfaces.msg import RelativeState, Values
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

CONFIG = Path(__file__).resolve().parents[4] / 'config'
SCENARIO = parse('/**: {ros__parameters: {}}', 'viewed')
TOPICS = Roster(SCENARIO).topics | {
    t: f'{k.__module__.split(".")[0]}/msg/{k.__name__}' for t, k in markers.TOPICS.items()}
# of a mission with standard messages
DOCKING = Roster(load(CONFIG.parent / 'scenarios' / 'docking_manual.yaml')).topics
ODOMETRY = {topic: kind for topic, kind in DOCKING.items() if kind.endswith('Odometry')}
LATCHED = ('/viz/corridor', '/viz/control_boundary', '/viz/target')
MARKERS = [sys.executable, '-c', 'from rvd_dynamics.diagram.ros.main import main; main()',
           '--ros-args', '-r', '__node:=markers']


def inside(value, wanted):
    """Yield every dict inside nested data that `wanted` accepts."""
    if isinstance(value, dict):
        if wanted(value):
            yield value
        for inner in value.values():
            yield from inside(inner, wanted)
    elif isinstance(value, list):
        for inner in value:
            yield from inside(inner, wanted)


# -- configuration files ------------------------------------------------------------------------

def test_rviz_shows_topics_that_are_published_with_their_types_and_qualities():
    config = yaml.safe_load((CONFIG / 'rvd.rviz').read_text())
    displays = [d for d in config['Visualization Manager']['Displays'] if 'Topic' in d]
    assert {d['Topic']['Value'] for d in displays} == {*markers.TOPICS, *ODOMETRY}
    for display in displays:
        topic = display['Topic']
        kind = (TOPICS | ODOMETRY)[topic['Value']]
        assert display['Class'].split('/')[1] == kind.split('/')[-1]
        latched = topic['Durability Policy'] == 'Transient Local'
        assert latched == (topic['Value'] in LATCHED)
    assert config['Visualization Manager']['Global Options']['Fixed Frame'] == \
        SCENARIO.run.frame_id


def field_type(kind: str, path: str) -> str:
    """Return the type of a field path such as `position.x`; KeyError if there is none."""
    for part in path.split('.'):
        name, index = re.fullmatch(r'(\w+)((?:\[\d+\])?)', part).groups()
        package, _, short = kind.split('/')
        module = __import__(f'{package}.msg', fromlist=[short])
        found = getattr(module, short).get_fields_and_field_types()[name]
        kind = re.sub(r'\[\d*\]$', '', found) if index else found
        kind = kind.replace('/', '/msg/') if '/' in kind else kind
    return kind


def test_foxglove_shows_topics_and_fields_that_are_published():
    layout = json.loads((CONFIG / 'foxglove_layout.json').read_text())
    named = [p['value'] for p in inside(layout, lambda d: str(d.get('value', '')).startswith('/'))]
    assert len(named) > 10
    for path in named:
        topic, _, field = path.partition('.')
        assert field_type(TOPICS[topic], field) in (
            'double', 'int8', 'uint8', 'uint64'), path
    shown = {t for d in inside(layout, lambda d: 'topics' in d) for t in d['topics']}
    shown |= {d['topicPath'] for d in inside(layout, lambda d: 'topicPath' in d)}
    assert shown <= {*TOPICS, *ODOMETRY} and set(ODOMETRY) <= shown
    panels = set(re.findall(r'"(?:first|second)": "([^"]+)"', json.dumps(layout['layout'])))
    assert panels == set(layout['configById'])


# -- what is drawn -----------------------------------------------------------------------------

def state(covariance=None) -> RelativeState:
    unknown = np.full((6, 6), np.nan)
    return RelativeState(
        header=header_at(1_500_000_000, 'target_lvlh'), step=3, valid=True,
        source=RelativeState.SOURCE_PREDICTION, position=vector([-20.0, 0.5, -0.25]),
        velocity=vector([0.25, 0.01, 0.0]),
        covariance=(unknown if covariance is None else covariance).reshape(36))


def test_body_stands_where_the_message_says_with_its_ellipsoid():
    drawn = {m.ns: m for m in markers.body(
        state(np.diag([0.04, 0.01, 0.09, 1, 1, 1])), 'ghost', (0, 0, 1), 2.0).markers}
    box, sphere = drawn['ghost'], drawn['ghost uncertainty']
    assert (box.pose.position.x, box.pose.position.y, box.pose.position.z) == (-20.0, 0.5, -0.25)
    assert sorted([sphere.scale.x, sphere.scale.y, sphere.scale.z]) == pytest.approx(
        [0.4, 0.8, 1.2])                        # diameters of 2 sigma
    arrow = drawn['ghost velocity, 10 s']
    assert arrow.points[1].x - arrow.points[0].x == pytest.approx(2.5)


def test_without_a_covariance_there_is_no_ellipsoid():
    assert len(markers.body(state(), 'ghost', (0, 0, 1), 2.0).markers) == 2


def test_every_marker_of_a_topic_has_its_own_name_and_can_be_seen():
    still = markers.still_scene(SCENARIO, 0.25)
    for array in (*still.values(), markers.body(state(np.eye(6)), 'ghost', (0, 0, 1), 2.0)):
        names = [(m.ns, m.id) for m in array.markers]
        assert len(names) == len(set(names))
        for marker in array.markers:
            assert marker.header.frame_id == 'target_lvlh' and marker.color.a > 0.0
            assert marker.action == Marker.ADD and marker.scale.x > 0.0


# -- the process ---------------------------------------------------------------------------------

FIELD = load(CONFIG.parent / 'scenarios' / 'obstacles_moving.yaml')
SHOWN = {'/viz/chaser', '/viz/ghost', '/viz/trail/estimate', '/viz/trail/prediction'}


def around(step) -> Values:
    signal = FIELD.diagram.signals['/ground/obstacles']
    return Parts(signal, FIELD.run).encode(step, signal(
        obstacles=np.array([[14.0, -3.0, -7.0, 0, 0, 0]]), valid=True, covariance=np.eye(3)[None]))


def test_what_stands_still_in_a_scene_is_drawn_where_it_is():
    field = loaded(FIELD.mission.scene)(FIELD)
    target, arrival = markers.still_spheres(field, 'target_lvlh').markers
    assert (target.scale.x, arrival.scale.x, target.pose.position.x) == (2.0, 3.0, 0.0)
    assert target.color.a > 0.5 > arrival.color.a and target.header.frame_id == 'target_lvlh'


def test_obstacles_that_stand_still_have_the_colour_of_obstacles_beside_the_corridor():
    scenario = load(CONFIG.parent / 'scenarios' / 'cluttered.yaml')
    field = loaded(scenario.mission.scene)(scenario)
    assert field.corridor
    places = scenario.part('obstacles').places(scenario.run.seed, [scenario.run.run], ())
    balls = markers.still_spheres(field, 'target_lvlh').markers
    centres = [b.pose.position for b in balls]
    assert [[p.x, p.y, p.z] for p in centres] == places.tolist()
    assert [b.scale.x for b in balls] == pytest.approx([0.8, 0.6])
    for b in balls:
        assert (b.color.r, b.color.g, b.color.b) == pytest.approx(markers.OBSTACLE)


@pytest.mark.parametrize('name, shown', [
    ('paper', {'/viz/corridor', '/viz/control_boundary'}),
    ('obstacles_moving', {'/viz/target', '/viz/obstacles'})])
def test_markers_follow_a_run_and_end_with_it(name, shown, monkeypatch):
    monkeypatch.setenv('ROS_DOMAIN_ID', str(20 + os.getpid() % 80))
    context = rclpy.Context()
    rclpy.init(context=context)
    node = rclpy.create_node('loop', context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    seen: dict[str, list] = {}
    for topic, kind in markers.TOPICS.items():
        profile = qos.LATCHED if topic in LATCHED else qos.VIEW
        node.create_subscription(
            kind, topic, lambda m, t=topic: seen.setdefault(t, []).append(m), profile)
    node.create_subscription(TFMessage, '/tf_static', lambda m: seen.setdefault(
        '/tf_static', []).append(m), qos.LATCHED)
    from std_msgs.msg import UInt64
    scenario = CONFIG.parent / 'scenarios' / f'{name}.yaml'
    topics = Roster(load(scenario)).topics
    feeds = {t: node.create_publisher(RelativeState, t, qos.of(t))
             for t in markers.SOURCES if t in topics}
    if '/ground/obstacles' in topics:
        feeds['/ground/obstacles'] = node.create_publisher(
            Values, '/ground/obstacles', qos.of('/ground/obstacles'))
    end = node.create_publisher(UInt64, '/run/end', qos.of('/run/end'))
    process = subprocess.Popen([*MARKERS, '--params-file', str(scenario), '-p',
                                'nodes:=[markers]'],
                               env={**os.environ, 'RVD_LEAN': '1'}, stderr=subprocess.PIPE)
    try:
        limit = time.monotonic() + 20
        while not all(f.get_subscription_count() for f in (*feeds.values(), end)):
            assert time.monotonic() < limit
            executor.spin_once(timeout_sec=0.05)
        begin = time.monotonic()
        for k in range(300):                    # 2 s at 150 steps a second
            for topic, feed in feeds.items():
                message = around(k) if topic == '/ground/obstacles' else state(np.eye(6))
                message.step = k
                feed.publish(message)
            executor.spin_once(timeout_sec=0.0)
            time.sleep(max(0.0, begin + k / 150 - time.monotonic()))
        end.publish(UInt64(data=299))
        while process.poll() is None:
            assert time.monotonic() < limit + 20
            executor.spin_once(timeout_sec=0.05)
        assert process.returncode == 0, process.stderr.read()
    finally:
        process.kill() if process.poll() is None else None
        node.destroy_node()
        rclpy.try_shutdown(context=context)
    frame, = (t for message in seen.pop('/tf_static') for t in message.transforms)
    assert frame.header.frame_id == 'target_lvlh' and frame.transform.rotation.w == 1.0
    assert set(seen) == SHOWN | shown
    took = time.monotonic() - begin
    assert 3 <= len(seen['/viz/ghost']) <= 10 * took + 2        # at most ten a second
    still, = (seen[topic] for topic in ('/viz/corridor', '/viz/target') if topic in seen)
    assert len(still) == 1 and isinstance(still[0], MarkerArray)
    if '/viz/obstacles' in seen:
        ball, = seen['/viz/obstacles'][-1].markers
        assert (ball.pose.position.x, ball.scale.x) == (14.0, pytest.approx(1.2))
    assert len(seen['/viz/trail/estimate'][-1].poses) <= 200
