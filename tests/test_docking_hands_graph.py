"""
Docking by hand over DDS through the link, and its standard messages as other readers find them.
"""

import os
import threading

from conftest import Flown
from mcap_ros2.reader import read_ros2_messages
from nav_msgs.msg import Odometry
import numpy as np
import pytest
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from runs import messages, ROOT
from scipy.spatial.transform import Rotation
from test_by_hand import Hand
from tf2_msgs.msg import TFMessage

from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.codecs import Parts
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.reader import read
from rvd_interfaces.msg import Values
from rvd_missions.docking import hand_signals as hands
from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, INERTIAL, THRUST, TRUTH

SHORT = '''
/**: {ros__parameters: {mission: docking, steering: remote, operator: model, timeout_s: 3.0,
                        forward_delay_s: 0.3, back_delay_s: 0.2, limits: {from_s: 1.0},
                        seeing: {camera: simple}}}
standard_messages: {ros__parameters: {active: true}}
'''
SIGNALS = (TRUTH, ESTIMATE, GUIDANCE, THRUST, hands.STEERING, hands.TRANSLATION, hands.ROTATION,
           hands.COMMAND, hands.ESTIMATE, hands.PREDICTION)


# as a tf2 listener takes them
TF = QoSProfile(depth=100)
STILL = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Listener:
    """A ROS program that knows nothing of ours: a node with tf2's subscriptions and an odometry."""

    def __init__(self, domain: int) -> None:
        self.heard = {'/tf': [], '/tf_static': [], '/chaser/odometry': []}
        self.context = Context()
        self.context.init(domain_id=domain)
        self.node = Node('viewer', context=self.context, enable_rosout=False)
        for topic, kind, profile in (('/tf', TFMessage, TF), ('/tf_static', TFMessage, STILL),
                                     ('/chaser/odometry', Odometry, TF)):
            self.node.create_subscription(kind, topic, self.heard[topic].append, profile)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self.executor.spin)
        self.thread.start()

    def close(self) -> None:
        self.executor.shutdown()
        self.thread.join()
        self.node.destroy_node()
        self.context.try_shutdown()


def flown(folder, pace):
    """Return a flight's run folder and what a listener heard meanwhile."""
    (folder / 'short.yaml').write_text(SHORT)
    with reserved_domain() as number:
        pass                                    # nobody has it, and the flight may take it
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr('runs.environment', lambda: {
            **os.environ, 'RVD_ROOT': str(ROOT), 'ROS_DOMAIN_ID': str(number)})
        listener = Listener(int(number))
        try:
            flown = Flown(folder / 'run', str(folder / 'short.yaml'), '--seed', '5', '--headless',
                          '--pace', pace, '--processes', 'segments')
        finally:
            listener.close()
    assert flown.code in (0, 1), flown.err
    return flown.run, listener.heard


@pytest.fixture(scope='module')
def flight(tmp_path_factory):
    """Return the run folder of a flight in lock step."""
    return flown(tmp_path_factory.mktemp('hands'), 'lockstep')[0]


def xyz(vector):
    return [vector.x, vector.y, vector.z]


def xyzw(q):
    return [q.x, q.y, q.z, q.w]


@pytest.mark.slow
def test_a_flight_by_hand_through_the_link_is_the_loop_in_one_process_to_the_last_bit(flight):
    run = read(flight / 'bag')
    alone = fly(parse((flight / 'scenario.yaml').read_text(), 'flown'), [0], record=True)
    for signal in SIGNALS:
        if signal.message.endswith('/Joy'):
            sticks = messages(flight, signal.name)
            here = alone.history[signal.name]
            assert [np.rint(100*np.array(m.axes)).astype(int).tolist() for m in sticks] \
                == here.deflection[:, 0].tolist()
            assert all(m.buttons[0] for m in sticks)
            continue
        there, here = run.of(signal), alone.history[signal.name]
        for part in (p.name for p in signal.parts if not p.optional):
            np.testing.assert_array_equal(np.asarray(there[part]), getattr(here, part)[:, 0],
                                          err_msg=f'{signal.name} {part}')
    assert np.isfinite(run.of(hands.PREDICTION)['position'][100:]).all()
    assert run.of(hands.STEERING)['command'][-100:, :6].any()


@pytest.mark.slow
def test_odometry_and_imu_say_what_our_messages_say(flight):
    run = read(flight / 'bag')
    for topic, signal, child in (('/chaser/odometry', TRUTH, 'chaser_base'),
                                 ('/chaser/odometry/estimate', ESTIMATE, 'chaser_base_estimate')):
        found, ours = messages(flight, topic), run.of(signal)
        assert len(found) == 31 and {m.child_frame_id for m in found} == {child}
        assert {m.header.frame_id for m in found} == {'target_lvlh'}
        place = np.array([xyz(m.pose.pose.position) for m in found])
        turn = np.array([xyzw(m.pose.pose.orientation) for m in found])
        np.testing.assert_array_equal(place, ours['position'][::10])
        np.testing.assert_array_equal(turn, ours['attitude'][::10])
        at = [round((m.header.stamp.sec + 1e-9*m.header.stamp.nanosec)/0.01) for m in found]
        assert at == list(range(0, 301, 10))
    # the twist is how the pose changes, in the body's axes
    found = messages(flight, '/chaser/odometry')
    turn = Rotation.from_quat([xyzw(m.pose.pose.orientation) for m in found])
    place = np.array([xyz(m.pose.pose.position) for m in found])
    linear = np.array([xyz(m.twist.twist.linear) for m in found])
    angular = np.array([xyz(m.twist.twist.angular) for m in found])
    assert np.linalg.norm(angular, axis=-1).max() > np.radians(0.1)
    middle = turn[:-1].inv().apply(np.diff(place, axis=0))/0.1
    np.testing.assert_allclose(0.5*(linear[1:] + linear[:-1]), middle, atol=4e-4)
    spun = (turn[:-1].inv()*turn[1:]).as_rotvec()/0.1
    np.testing.assert_allclose(0.5*(angular[1:] + angular[:-1]), spun, atol=np.radians(0.03))
    imu, ours = messages(flight, '/chaser/imu'), run.of(INERTIAL)
    np.testing.assert_array_equal([xyz(m.angular_velocity) for m in imu], ours['rate'][::10])
    np.testing.assert_array_equal([xyz(m.linear_acceleration) for m in imu], ours['force'][::10])
    assert all(m.orientation_covariance[0] == -1 for m in imu)


def at(message):
    """Return the step of a transform or an odometry."""
    return round((message.header.stamp.sec + 1e-9*message.header.stamp.nanosec)/0.01)


@pytest.mark.slow
def test_frames_lead_from_the_target_to_the_camera(flight):
    """In the bag, by mcap_ros2: the target's port is ahead of the camera, where truth has it."""
    bag, = (flight / 'bag').glob('*.mcap')
    truth = read(flight / 'bag').of(TRUTH)
    still, = (m.ros_msg for m in read_ros2_messages(str(bag), topics=['/tf_static']))
    found = [m.ros_msg for m in read_ros2_messages(str(bag), topics=['/tf'])]
    assert [at(message.transforms[0]) for message in found] == list(range(0, 301, 10))
    assert len(found[-1].transforms) == 3 and len(still.transforms) == 2
    for message, i in ((found[-1], 300), (found[10], 100)):
        frames = {t.child_frame_id: t for t in (*message.transforms, *still.transforms)}
        chain, name = [], 'chaser_camera_optical'
        while name != 'target_lvlh':
            chain.append(frames[name].transform)
            name = frames[name].header.frame_id
        assert len(chain) == 3
        port = np.array([-1.5, 0.0, 0.0])
        for t in reversed(chain):           # into the next frame
            port = Rotation.from_quat(xyzw(t.rotation)).inv().apply(port - xyz(t.translation))
        straight = Rotation.from_quat(truth['attitude'][i]).inv().apply(
            np.array([-1.5, 0.0, 0.0]) - truth['position'][i])
        np.testing.assert_allclose(port, [straight[1], straight[2], straight[0] - 0.9], atol=1e-12)
        assert port[2] > 3.0 and np.abs(port[:2]).max() < 0.4


@pytest.mark.slow
def test_who_listens_during_the_flight_hears_frames_that_are_truth_and_odometry(tmp_path):
    run, heard = flown(tmp_path, 'realtime')    # lock step is over before DDS has matched them
    bag, truth, believed = read(run / 'bag'), {}, {}
    for name, series in ((TRUTH, truth), (ESTIMATE, believed)):
        given = bag.of(name)
        series |= {int(k): (place.tolist(), turn.tolist()) for k, place, turn in zip(
            given.step, given['position'], given['attitude'])}
    odometry = {at(m): (xyz(m.pose.pose.position), xyzw(m.pose.pose.orientation))
                for m in heard['/chaser/odometry']}
    assert len(heard['/tf']) > 20               # of 31; one without memory may miss the first
    both, missed = 0, []
    for message in heard['/tf']:
        k = at(message.transforms[0])
        assert {at(t) for t in message.transforms} == {k}
        assert {t.header.frame_id for t in message.transforms} == {'target_lvlh'}
        frames = {t.child_frame_id: (xyz(t.transform.translation), xyzw(t.transform.rotation))
                  for t in message.transforms}
        known = {'chaser_base': truth[k]}
        if np.isfinite(np.concatenate(believed[k])).all():
            known['chaser_base_estimate'] = believed[k]
        missed += [k for name in known if name not in frames]
        for name, there in known.items():
            assert frames.get(name, there) == there
        assert frames.get('target_base', ([0.0, 0.0, 0.0],))[0] == [0.0, 0.0, 0.0]
        if k in odometry and 'chaser_base' in frames:
            both += 1
            assert frames['chaser_base'] == odometry[k]
    assert both > 20
    late = [event for event in messages(run, '/run/events')
            if event.code == 'LATE' and event.node == 'standard_messages']
    # in real time a machine that does not keep up leaves out what is not there, and says so
    assert len(missed) < len(heard['/tf']) / 2 and bool(missed) <= bool(late), (missed, late)
    still, = heard['/tf_static']
    assert [(t.header.frame_id, t.child_frame_id) for t in still.transforms] == [
        ('chaser_base', 'chaser_camera'), ('chaser_camera', 'chaser_camera_optical')]


def test_frames_that_are_not_known_are_left_out_and_still_ones_wait_for_who_comes_late(tmp_path):
    """The node alone, fed by the test: no estimate at first, and a listener at the end."""
    (tmp_path / 'short.yaml').write_text(SHORT)
    scenario = parse(SHORT, 'short')
    hand = Hand(tmp_path / 'short.yaml')
    try:
        heard = hand.listen('/tf', TFMessage)
        feeds = {signal: hand.node.create_publisher(Values, signal.name, qos.of(signal.name))
                 for signal in (TRUTH, ESTIMATE, INERTIAL)}
        hand.start('standard_messages', '-p', 'nodes:=[standard_messages]', package='rvd_missions')
        place = np.array([-6.0, 0.2, -0.1])
        for k in (0, 10, 20):
            for signal, feed in feeds.items():
                value = {part.name: np.zeros(part.shape, dtype=part.dtype) for part in signal.parts}
                if signal is not INERTIAL:
                    value |= {'position': place + k, 'attitude': np.array([0.0, 0.6, 0.0, 0.8])}
                if signal is ESTIMATE and k < 20:
                    value['attitude'] = np.full(4, np.nan)
                feed.publish(Parts(signal, scenario.run).encode(k, signal(**value)))
        hand.until(lambda: len(heard) == 3, heard)
        late = []
        hand.node.create_subscription(TFMessage, '/tf_static', late.append, STILL)
        hand.until(lambda: late, 'the still frames')
    finally:
        hand.close()
    known = [{t.child_frame_id for t in message.transforms} for message in heard]
    assert known == [{'target_base', 'chaser_base'}]*2 + [
        {'target_base', 'chaser_base', 'chaser_base_estimate'}]
    believed = heard[2].transforms[2].transform
    assert xyz(believed.translation) == [14.0, 20.2, 19.9]
    assert xyzw(believed.rotation) == [0.0, 0.6, 0.0, 0.8]
    mount, optical = (t.transform for t in late[0].transforms)
    assert xyz(mount.translation) == [0.9, 0.0, 0.0] and xyzw(optical.rotation) == [0.5]*4
