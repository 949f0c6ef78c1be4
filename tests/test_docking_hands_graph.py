"""
Docking by hand over DDS through the link, and its standard messages as other readers find them.
"""

from conftest import Flown
from mcap_ros2.reader import read_ros2_messages
import numpy as np
import pytest
from runs import messages
from scipy.spatial.transform import Rotation

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.reader import read
from rvd_missions.docking import hand_signals as hands
from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, INERTIAL, THRUST, TRUTH
from rvd_missions.docking.standard import write

SHORT = '''
/**: {ros__parameters: {mission: docking, steering: remote, operator: model, timeout_s: 3.0,
                        forward_delay_s: 0.3, back_delay_s: 0.2, limits: {from_s: 1.0},
                        seeing: {camera: simple}}}
standard_messages: {ros__parameters: {active: true}}
'''
SIGNALS = (TRUTH, ESTIMATE, GUIDANCE, THRUST, hands.STEERING, hands.TRANSLATION, hands.ROTATION,
           hands.COMMAND, hands.ESTIMATE, hands.PREDICTION)


@pytest.fixture(scope='module')
def flight(tmp_path_factory):
    folder = tmp_path_factory.mktemp('hands')
    (folder / 'short.yaml').write_text(SHORT)
    flown = Flown(folder / 'run', str(folder / 'short.yaml'), '--seed', '5', '--headless', '--pace',
                  'lockstep', '--processes', 'segments')
    assert flown.code in (0, 1), flown.err
    return flown.run


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


@pytest.mark.slow
def test_frames_lead_from_the_target_to_the_camera(flight):
    """Read by mcap_ros2: the target's port lies ahead of the camera, where the truth has it."""
    out = write(flight)
    truth = read(flight / 'bag').of(TRUTH)
    found = [m.ros_msg for m in read_ros2_messages(str(next(out.glob('*.mcap'))))]
    assert len(found) == 31 and len(found[-1].transforms) == 5
    for message, i in ((found[-1], 300), (found[10], 100)):
        frames = {t.child_frame_id: t for t in message.transforms}
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
