"""
Flying by hand: controllers, clicks and rates, the predictor, retreat and abort, whole flights.
"""

import json
import os
from pathlib import Path
from types import SimpleNamespace

from hypothesis import given, settings, strategies as st
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands import hand as hands
from rvd_dynamics.commands.hand import HandForm, HandParams, Hands, Hold
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.diagram.scenario import load, parse
from rvd_dynamics.motion import attitude
from rvd_groundstation.prediction.six_dof import (
    CraftModel, LoopModel, SixDofParams, SixDofPredictor)
from rvd_missions.docking.columns import Columns
from rvd_missions.docking.safety import ABORT, HOLD, NOMINAL, RETREAT, Safety, SafetyParams
from rvd_missions.docking.scatter import PROPERTIES, Scatter

N = 8.1478e-4                           # [rad/s]
CRAFT = CraftModel(N, 1947.4e3, (LoopModel(12.0, 3.5, 0.3, 0.25), LoopModel(50.0, 3.0, 0.3, 0.25)),
                   -6.0, 0.1, 0.01)
BOTH = hands.HELD | hands.TURN_HELD
TRUTH, ESTIMATE, GUIDANCE = '/truth/spacecraft', '/onboard/estimate', '/onboard/guidance'


def commanded(deflections, flags=BOTH, **params):
    """Return the wishes of one row for a list of six deflections in percent."""
    logic = Hands(HandParams(**params), 0.01, 1)
    return [logic.step(np.array([[*d, flags]])) for d in deflections]


# -- controllers ----------------------------------------------------------------------------------

@pytest.mark.parametrize('pressed', [1, 5, 10, 40])
def test_one_click_is_one_pulse_however_long_it_is_held(pressed):
    """40 N for 0.1 s are 4 N s: 2 mm/s of 2000 kg."""
    stick = [(100, 0, 0, 0, 0, 0)]*pressed + [(0,)*6]*40
    push = np.array([wish.push[0] for wish in commanded(stick)])
    assert push[:, 0].sum() == 10 and not push[:, 1:].any()
    assert 40.0*push[:, 0].sum()*0.01 == pytest.approx(4.0)


def test_a_stick_that_does_not_come_back_to_neutral_does_not_click_again():
    wobble = [(100, 0, 0, 0, 0, 0)]*20 + [(20, 0, 0, 0, 0, 0)]*20
    assert sum(w.push[0, 0] for w in commanded(wobble*3)) == 10
    clicks = [(100, 0, 0, 0, 0, 0)]*20 + [(5, 0, 0, 0, 0, 0)]*20
    assert sum(w.push[0, 0] for w in commanded(clicks*3)) == 30
    other = [(-100, 0, 0, 0, 0, 0)]*20 + [(0,)*6]*20
    assert sum(w.push[0, 0] for w in commanded(other)) == -10


def test_rates_are_in_proportion_outside_of_the_dead_zone():
    wish = commanded([(100, -40, 5, 6, -100, 0)], BOTH | hands.SWITCHED)[0]
    assert_allclose(wish.speed[0], [0.05, -0.02, 0.0])
    assert_allclose(np.degrees(wish.spin[0]), [0.018, -0.3, 0.0])
    assert not wish.push.any() and not wish.drifts.any()


def test_a_controller_that_nobody_holds_holds_the_place():
    assert commanded([(0,)*6])[0].drifts.tolist() == [[True, False]]
    assert commanded([(0,)*6], 0)[0].drifts.tolist() == [[False, False]]


def test_resume_counts_once_for_each_press():
    logic = Hands(HandParams(), 0.01, 1)
    row = [np.array([[0]*6 + [BOTH | hands.RESUME*down]]) for down in (1, 1, 0, 1)]
    assert [bool(logic.step(command).resume[0]) for command in row] == [True, False, False, True]


@given(st.lists(st.integers(-100, 100), min_size=3, max_size=3), st.booleans(), st.booleans(),
       st.booleans(), st.booleans())
@settings(max_examples=60)
def test_a_controller_survives_its_joy_and_both_the_wire(deflection, switched, resume, valid,
                                                         deadman):
    hand = HandParams(deadman=deadman)
    hold = Hold(np.array(deflection, dtype=np.int8), np.bool_(switched), np.bool_(resume),
                np.bool_(valid))
    axes, buttons = hands.joy(hold, hand)
    back = hands.read(np.asarray(axes, dtype=np.float32).tolist(), buttons, hand)
    assert back.valid == valid
    if valid:
        assert all(np.array_equal(a, b) for a, b in zip(back, hold))
    form, command = HandForm(hand), hands.together(back, back)
    there = form.wire.unpack(form.wire.pack(*command.tolist()))
    assert list(there) == command.tolist() and form.legal(there)
    assert not form.legal([101, 0, 0, 0, 0, 0, 0]) and not form.legal([0]*6 + [32])


@pytest.mark.parametrize('axes, buttons, words', [
    ([0.0, 0.0], [1], 'three axes: Joy has 2'), ([0.0, np.nan, 0.0], [1], r'axis 1 \(y\) is not a'),
    ([0.0, 0.0, 1.2], [1], r'axis 2 \(z\) is beyond'), ([0.0]*3, [0], 'dead-man button 0'),
    ([0.0]*3, [], 'dead-man button 0')])
def test_a_joy_that_is_nobodys_says_why_and_is_neutral(axes, buttons, words):
    import re
    assert re.search(words, hands.fault(axes, buttons, HandParams()))
    hold = hands.read(axes, buttons, HandParams())
    assert not hold.valid and not hold.deflection.any()


# -- the predictor --------------------------------------------------------------------------------

def telemetry(position=(-6.0, 0.2, -0.1), velocity=(0.02, -0.01, 0.01), turn=(0.02, -0.01, 0.03),
              rate=(0.0, 0.0, 0.0), safety=0):
    """Return a row of telemetry; what is held is where it is."""
    q = attitude.from_rotation_vector(np.array(turn))
    return np.array([[*position, *velocity, *q, *rate, *position, *q, safety]])


def predicted(row, commands, forward=100, back=160, rows=1, step_s=0.01):
    """Return what is predicted after commands (K, 7) have been sent, with telemetry of a row."""
    predictor = SixDofPredictor(SixDofParams(), CRAFT, HandParams(), Legs(forward, back, step_s),
                                rows)
    row, yes = np.repeat(row, rows, axis=0), np.ones(rows, dtype=bool)
    for sent in [None, *commands]:
        sent = None if sent is None else np.broadcast_to(sent, (rows, 7))
        known = predictor.advance(row, yes, sent)
    return known


NEUTRAL = np.array([0]*6 + [BOTH])
LOOSE = np.array([0]*6 + [BOTH | hands.TURN_SWITCHED])          # both by pulses: the craft is free


def test_a_free_craft_is_carried_as_gravity_and_euler_have_it():
    """Against Runge-Kutta of order 8 on Clohessy-Wiltshire and Euler's equations with scipy."""
    w, inertia = np.array([0.01, -0.02, 0.015]), np.array([2200.0, 3000.0, 2800.0])
    start = telemetry(velocity=(0.2, -0.1, 0.1), rate=w)
    found = predicted(start, [LOOSE]*300).predicted[0]

    def slope(t, s):
        x, y, z, vx, vy, vz = s[:6]
        q, rate = s[6:10], s[10:]
        rel = rate - Rotation.from_quat(q).inv().apply([0.0, -N, 0.0])
        a, b, c, d = q
        turn = 0.5*np.array([[d, -c, b], [c, d, -a], [-b, a, d], [-a, -b, -c]]) @ rel
        return [vx, vy, vz, 2*N*vz, -N*N*y, -2*N*vx + 3*N*N*z, *turn,
                *(-np.cross(rate, inertia*rate)/inertia)]
    true = solve_ivp(slope, (0.0, 2.6), start[0, :13], 'DOP853', rtol=1e-11, atol=1e-13).y[:, -1]
    assert_allclose(found[:3], true[:3], atol=1e-7)
    assert_allclose(found[3:6], true[3:6], atol=1e-7)
    assert_allclose(found[6:10], true[6:10], atol=1e-5)
    assert_allclose(found[10:], true[10:], atol=2e-6)


def test_clicks_that_are_under_way_are_in_the_prediction_alone():
    """Three clicks of 4 N s in the last 2.6 s; what the telemetry shows is as it was."""
    click = [np.array([100] + [0]*5 + [BOTH])]*10 + [NEUTRAL]*30
    known = predicted(telemetry(velocity=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0)),
                      [NEUTRAL]*260 + click*3)
    assert known.predicted[0, 3] == pytest.approx(3*4.0/2000.0, rel=1e-3)
    assert known.estimate[0, 3] == 0.0
    # pulses of 0.1 s that began 1.2, 0.8 and 0.4 s before
    way = 0.002*(1.15 + 0.75 + 0.35)
    assert known.predicted[0, 0] + 6.0 == pytest.approx(way, rel=1e-2)


def test_a_rate_that_is_under_way_moves_the_craft_by_what_was_asked():
    fast = np.array([100, 0, 0, 0, 0, 0, BOTH | hands.SWITCHED])
    known = predicted(telemetry(velocity=(0.05, 0.0, 0.0), turn=(0.0, 0.0, 0.0)), [fast]*300)
    assert known.predicted[0, 0] + 6.0 == pytest.approx(0.05*2.6, rel=0.05)
    still = telemetry(velocity=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0), rate=(0.0, -N, 0.0))
    turning = np.array([0, 0, 0, 0, 100, 0, BOTH])
    found = predicted(still, [turning]*600, forward=250, back=250).predicted[0]
    angle = np.degrees(attitude.rotation_vector(found[6:10]))
    # the rate comes with the time constant I/(T K T_d) of its loop
    assert angle[1] == pytest.approx(0.3*(5.0 - 3000.0/(16.0*50.0*3.0)), abs=0.05)
    assert np.abs(angle[[0, 2]]).max() < 0.05


def test_a_retreat_is_predicted_to_slow_down_before_its_end():
    """From 0.2 m before it at (2 x 0.01 x 0.2)^0.5 m/s: at rest there, where 0.1 m/s would pass."""
    row = telemetry(position=(-5.8, 0.0, 0.0), velocity=(-0.0632, 0.0, 0.0), turn=(0, 0, 0),
                    safety=RETREAT)
    x = [predicted(row, [NEUTRAL]*(2*leg + 1), leg, leg).predicted[0, 0]
         for leg in (150, 350, 450)]
    assert x[0] == pytest.approx(-5.8 - 0.0632*3.0 + 0.5*0.01*9.0, abs=0.04)   # dead band
    assert x[1:] == pytest.approx([-6.0, -6.0], abs=0.07)      # the craft flies 0.06 m past


def test_without_delay_the_prediction_is_the_telemetry():
    row = telemetry()
    assert_allclose(predicted(row, [NEUTRAL]*5, 0, 0).predicted, row[:, :13], rtol=0, atol=1e-15)


def test_rows_of_the_predictor_are_independent_and_gaps_are_bridged():
    rng = np.random.default_rng(3)
    row = telemetry() + 0.0
    sent = [np.array([*rng.integers(-100, 101, 6), BOTH | hands.SWITCHED]) for _ in range(300)]
    many, one = predicted(row, sent, rows=3), predicted(row, sent)
    assert np.array_equal(many.predicted, np.repeat(one.predicted, 3, axis=0))
    predictor = SixDofPredictor(SixDofParams(), CRAFT, HandParams(), Legs(100, 160, 0.01), 1)
    gone, here = np.zeros(1, dtype=bool), np.ones(1, dtype=bool)
    free = telemetry(velocity=(0.1, 0.0, 0.0))
    for k in range(500):
        predictor.advance(free, here, LOOSE[None] if k else None)
    for _ in range(200):
        known = predictor.advance(np.full_like(free, np.nan), gone, LOOSE[None])
    # 2.6 s of the loop and 2 s without telemetry
    assert known.valid[0] and known.predicted[0, 0] + 6.0 == pytest.approx(0.1*4.6, abs=1e-3)
    assert not predictor.advance(free*np.nan, gone, LOOSE[None]).valid[0]
    assert not predictor.advance(telemetry(safety=ABORT), here, LOOSE[None]).valid[0]


# -- safety ---------------------------------------------------------------------------------------

def test_an_operator_resumes_from_hold_and_retreat_but_not_from_abort():
    safety = Safety(SafetyParams(), 0.01, 4)
    safety.state = np.array([NOMINAL, HOLD, RETREAT, ABORT], dtype=np.uint8)
    safety.resume(np.array([False, True, True, True]))
    assert safety.state.tolist() == [NOMINAL, NOMINAL, NOMINAL, ABORT]
    safety.state[:] = HOLD
    safety.resume(np.zeros(4, dtype=bool))
    assert safety.state.tolist() == [HOLD]*4


# -- standard messages ----------------------------------------------------------------------------

def test_frames_are_what_rosbags_reads_and_ros_serialises():
    """The message that is packed in one go, against a message object; rosbags knows tf2_msgs."""
    from types import SimpleNamespace
    from rclpy.serialization import deserialize_message, serialize_message
    from rosbags.typesys import get_typestore, Stores
    from rvd_dynamics.diagram.ros.standard_codecs import StillTransforms, Transforms
    from rvd_dynamics.recording.steps import step_reader
    from rvd_missions.docking import standard
    from tf2_msgs.msg import TFMessage
    flown = scenario(1.0, 'steering: profile')
    run, store, kind = flown.run, get_typestore(Stores.ROS2_JAZZY), 'tf2_msgs/msg/TFMessage'
    q = attitude.from_rotation_vector(np.array([0.1, 0.2, 0.3]))
    craft = SimpleNamespace(position=np.array([-6.0, 0.2, -0.1]), attitude=q,
                            target_attitude=np.array([0.0, 0.0, 0.0, 1.0]))
    unknown = SimpleNamespace(position=craft.position, attitude=np.full(4, np.nan))
    still = StillTransforms(standard.TF_STATIC, run, standard.still_frames())
    moving = Transforms(standard.TF, run, standard.frames(run))
    for codec, value, names in (
            (moving, standard.moving(craft, craft), standard.frames(run)),
            (moving, standard.moving(craft, unknown), standard.frames(run)[:2]),
            (still, standard.still(flown.part('camera'), ()), standard.still_frames())):
        data = codec.encode(250, value)
        again = serialize_message(deserialize_message(data, TFMessage))
        assert len(data) == len(again)
        made = store.deserialize_cdr(data, kind).transforms
        assert [(t.header.frame_id, t.child_frame_id) for t in made] == list(names)
        assert str(made) == str(store.deserialize_cdr(again, kind).transforms)
        for t, place, turn in zip(made, value.place, value.turn):
            r, v = t.transform.rotation, t.transform.translation
            assert [v.x, v.y, v.z, r.x, r.y, r.z, r.w] == [*place, *turn]
            assert (t.header.stamp.sec, t.header.stamp.nanosec) == divmod(250*run.step_ns, 10**9)
        assert step_reader(kind, run.step_ns)(data) == 250


def test_the_message_of_frames_is_the_one_of_ros():
    """The hash is that in the header that an installed ROS 2 has: only then do readers match."""
    from tf2_msgs.msg import TFMessage
    assert TFMessage.get_fields_and_field_types() == {
        'transforms': 'sequence<geometry_msgs/TransformStamped>'}
    prefixes = map(Path, os.environ['AMENT_PREFIX_PATH'].split(':'))
    made = next(p for p in (prefix / 'share/tf2_msgs/msg/TFMessage.json' for prefix in prefixes)
                if p.exists())
    assert json.loads(made.read_text())['type_hashes'][0]['hash_string'] == \
        'RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087'


def test_the_twist_of_an_odometry_is_how_the_pose_changes_at_any_attitude():
    """By scipy: LVLH turns at (0, -n, 0), the body at its inertial rate; n made large."""
    from types import SimpleNamespace
    from rvd_missions.docking.standard import motion
    n, dt, rate = 0.05, 1e-5, np.array([0.02, -0.03, 0.04])
    q, v = attitude.from_rotation_vector(np.array([0.7, -1.1, 0.4])), np.array([0.3, -0.2, 0.1])
    twist = motion(SimpleNamespace(position=np.zeros(3), velocity=v, attitude=q, rate=rate), n)
    body = Rotation.from_quat(q)
    frame = Rotation.from_rotvec([0.0, -n*dt, 0.0])
    later = frame.inv()*body*Rotation.from_rotvec(dt*rate)
    assert_allclose(twist['angular'], (body.inv()*later).as_rotvec()/dt, atol=1e-6)
    assert_allclose(twist['linear'], body.inv().apply(v), atol=1e-15)


# -- flights --------------------------------------------------------------------------------------

def scenario(seconds, shared, **sections):
    """Return a scenario of some length with the simple camera."""
    text = ('/**: {ros__parameters: {mission: docking, seeing: {camera: simple}, '
            f'timeout_s: {seconds}, limits: {{from_s: 0.5}}, {shared}}}}}\n')
    for name, told in {'onboard_guard': 'abort_burn_s: 2.0', **sections}.items():
        text += f'{name}: {{ros__parameters: {{{told}}}}}\n'
    return parse(text, 'test')


def away(truth):
    """Return the distance of the faces in each step, the craft taken to be straight."""
    return -truth.position[:, 0, 0] - 3.0


def test_through_the_link_the_operator_sees_the_craft_as_it_will_be_and_can_abort():
    """9 s with the model pilot, 1 s each way; at 7 s an ABORT goes up, which skips the buffer."""
    flown = fly(scenario(9.0, 'steering: remote, operator: model, forward_delay_s: 1.0, '
                         'back_delay_s: 1.0'), range(1), schedule=[Change(700, abort=True)],
                record=[TRUTH, '/ground/prediction', '/ground/estimate',
                        '/onboard/thruster_command'])
    truth, seen, shown = (flown.history[name] for name in (
        TRUTH, '/ground/prediction', '/ground/estimate'))
    assert not seen.valid[:100].any() and seen.valid[120:700].all()
    at = np.arange(300, 600)                # what was predicted acts 1 s later, before the ABORT
    predicted_off = truth.position[at + 100, 0] - seen.position[at, 0]
    delayed_off = truth.position[at + 100, 0] - shown.position[at, 0]
    assert np.sqrt((predicted_off**2).mean()) < 0.2*np.sqrt((delayed_off**2).mean())
    assert np.abs(predicted_off).max() < 0.012
    turn = Rotation.from_quat(truth.attitude[at + 100, 0])
    lag = (turn.inv()*Rotation.from_quat(shown.attitude[at, 0])).magnitude()
    ahead = (turn.inv()*Rotation.from_quat(seen.attitude[at, 0])).magnitude()
    assert np.sqrt((ahead**2).mean()) < 0.3*np.sqrt((lag**2).mean())
    kind = flown.history['/onboard/thruster_command'].kind
    first = int(np.flatnonzero(np.ravel(kind) == 3)[0])
    assert 700 < first <= 800              # the transit, and not the whole buffer
    assert not seen.valid[701:].any()       # what an ABORT does is not predicted


def coasting(place, v):
    """Return how near a craft that coasts comes within an orbit, and how near it is [m]: CW."""
    x, y, z = place                         # z to the Moon: backwards, it falls below and passes by
    nt = N*np.arange(0.0, 7711.5, 10.0)
    xs = x + v[0]/N*(4*np.sin(nt) - 3*nt) + 6*z*(nt - np.sin(nt)) + 2*v[2]/N*(1 - np.cos(nt))
    ys = y*np.cos(nt) + v[1]/N*np.sin(nt)
    zs = (4 - 3*np.cos(nt))*z + v[2]/N*np.sin(nt) - 2*v[0]/N*(1 - np.cos(nt))
    away = np.sqrt(xs**2 + ys**2 + zs**2)
    return away.min(), away[0]


def test_a_craft_that_comes_in_too_fast_aborts_and_coasting():
    """J4 for 2 s, 240 N on 2000 kg; then it coasts, and in an orbit does not come back."""
    flown = fly(scenario(9.0, 'steering: profile', docking_controller='safety: {brake_m_s2: 1e-5}'),
                range(1), record=[TRUTH, GUIDANCE])
    truth, state = flown.history[TRUTH], np.ravel(flown.history[GUIDANCE].safety)
    begin = int(np.flatnonzero(state == ABORT)[0])
    assert truth.velocity[begin, 0, 0] == pytest.approx(0.02, abs=0.002)
    assert np.all(state[begin:] == ABORT)
    brake = truth.thrust[:, 0, 25:29]
    assert np.all(brake[begin + 10:begin + 195] > 0.8) and brake[begin + 220:].max() < 1e-3
    assert truth.thrust[begin + 220:, 0].max() < 1e-3
    v = truth.velocity[-1, 0]
    assert v[0] == pytest.approx(0.02 - 2.0*240.0/2000.0, abs=0.02)
    least, now = coasting(truth.position[-1, 0], v)
    assert least >= 0.99*now


def test_a_craft_too_far_aside_retreats_to_three_metres_with_its_brake_and_stays():
    flown = fly(scenario(16.0, 'steering: profile, start: {position_m: [-5.2, 0.2, -0.15]}',
                         docking_controller='safety: {near_m: 2.9, near_lateral_m: 0.1}'),
                range(1), record=[TRUTH, GUIDANCE])
    truth, state = flown.history[TRUTH], np.ravel(flown.history[GUIDANCE].safety)
    assert state[5] == NOMINAL and np.all(state[15:] == RETREAT)
    assert truth.thrust[:, 0, 25:29].max() > 0.8
    assert away(truth)[-1] == pytest.approx(3.0, abs=0.1) and away(truth).max() < 3.1
    assert truth.velocity[:, 0, 0].min() < -0.1 and np.abs(truth.velocity[-200:, 0]).max() < 0.05
    assert np.abs(truth.position[-1, 0, 1:] - [0.2, -0.15]).max() < 0.05


HEAD = ('t_s,axis_0,axis_1,axis_2,axis_3,axis_4,axis_5,button_0,button_1,button_2,button_3,'
        'button_4,button_5')
SHORT = 'attitude_deg: [0.0, 0.0, 0.0]'


def watched(flown):
    """Return distance, speed along x, state of the safety strategy, J4's brake: one run's steps."""
    truth, guidance = flown.history[TRUTH], flown.history[GUIDANCE]
    return (away(truth), truth.velocity[:, 0, 0], np.ravel(guidance.safety),
            truth.thrust[:, 0, 25:29].max(axis=-1))


def pushed(tmp_path, axis, x, seconds):
    """Fly by hand, by rates, with full deflection on an axis from x on, all bounds as shipped."""
    row = ','.join('1' if i == axis else '0' for i in range(6)) + ',1,1,0,1,0,0'
    (tmp_path / 'tape.csv').write_text(f'{HEAD}\n0,{row}\n100,{row}\n')
    return fly(scenario(seconds, 'steering: aboard, operator: replay, start: {position_m: '
                        f'[{x}, 0.0, 0.0], {SHORT}}}',
                        joystick_replay=f'tape: "{tmp_path}/tape.csv"'), range(1),
               record=[TRUTH, GUIDANCE])


@pytest.mark.slow
@pytest.mark.patient
def test_a_pilot_who_goes_aside_near_the_port_is_taken_back_to_three_metres(tmp_path):
    """At 5 cm/s from 0.25 m away; 8 cm aside J4 takes it back, and it does not pass the 3 m."""
    flown = pushed(tmp_path, 1, -3.25, 36.0)
    distance, speed, state, brake = watched(flown)
    begin = int(np.flatnonzero(state)[0])
    assert np.all(state[begin:] == RETREAT)
    assert flown.history[TRUTH].position[begin, 0, 1] == pytest.approx(0.08, abs=0.01)
    assert brake[begin:begin + 100].max() > 0.8 and brake[:begin].max() == 0.0
    assert speed.min() == pytest.approx(-0.1, abs=0.02)
    assert 2.9 < distance[-1] < 3.1 and distance.max() < 3.1 and distance.min() > 0.2
    assert np.isnan(flown.columns['coast_least_m'][0])


def test_a_pilot_who_is_too_fast_near_the_port_is_aborted_in_time(tmp_path):
    """At 5 to 6 cm/s: it must stop at 0.02 m/s^2 before 3 cm, so at v^2/0.04 m from there."""
    flown = pushed(tmp_path, 0, -3.4, 11.0)
    distance, speed, state, brake = watched(flown)
    begin = int(np.flatnonzero(state)[0])
    assert np.all(state[begin:] == ABORT)
    assert distance[begin] - 0.03 == pytest.approx(speed[begin]**2/0.04, abs=0.01)
    assert (brake > 0.5).sum() == pytest.approx(200, abs=5)
    assert distance.min() > 0.08
    assert speed[-1] == pytest.approx(speed[begin] - 2.0*240.0/2000.0, abs=0.02)
    truth = flown.history[TRUTH]
    least, now = coasting(truth.position[-1, 0], truth.velocity[-1, 0])
    assert least >= 0.99*now
    assert flown.columns['coast_least_m'][0] == pytest.approx(least, rel=1e-9)


def test_a_craft_that_would_drift_back_is_told_from_one_that_would_not():
    """Columns alone, of two aborted craft 4 m behind: one falls back, one drifts towards it."""
    made = scenario(1.0, 'steering: profile')
    run = made.run
    columns = Columns(Scatter(), made.part('craft'), made.part('chaser'),
                      PROPERTIES.of_runs(run.seed, range(2), 1), made.part('preparation'), run,
                      made.part('orbit'), (2,))
    place = np.array([[-4.0, 0.1, 0.2]]*2)
    speed = np.array([[-0.2, 0.01, 0.0], [-3.0*N*0.2/2.0 + 0.0012, 0.001, 0.0005]])
    still = np.zeros((2, 3))
    known = SimpleNamespace(position=place, velocity=speed, rate=still,
                            attitude=np.tile([0.0, 0.0, 0.0, 1.0], (2, 1)), nis=np.ones((2, 2)))
    truth = SimpleNamespace(**vars(known), target_attitude=known.attitude,
                            final=np.ones(2, dtype=bool))
    columns.step(100, truth, known, SimpleNamespace(safety=np.full(2, ABORT, dtype=np.uint8)))
    found = columns.table(None, np.array([100, 100]))['coast_least_m']
    expected = [coasting(*of)[0] for of in zip(place, speed)]
    assert found == pytest.approx(expected, rel=1e-3)
    assert found[0] == pytest.approx(np.linalg.norm(place[0])) and found[1] < 3.0


def stuck(number, at, seconds, start, nominal, fast, dock):
    """Fly a short approach by itself; a thruster sticks open; all bounds as shipped."""
    return watched(fly(scenario(
        seconds, f'steering: profile, aim: {{nominal_s: {nominal}}}, start: {{position_m: '
        f'[{start}, 0.0, 0.0], {SHORT}}}',
        docking_dynamics=f'failure: stuck_on, failed_thruster: {number}, failure_at_s: {at}',
        docking_controller=f'profile: {{fast_m_s: {fast}, dock_m_s: {dock}}}'), range(1),
        record=[TRUTH, GUIDANCE]))


@pytest.mark.slow
@pytest.mark.patient
def test_a_thruster_across_that_sticks_open_near_the_port_ends_in_a_retreat():
    """20 N aside and 16 N m, all that J3 has: it turns, and its port leaves the 8 cm."""
    distance, _, state, brake = stuck(9, 12.0, 50.0, -3.35, 20.0, 0.02, 0.01)
    begin = int(np.flatnonzero(state == RETREAT)[0])
    assert 1200 < begin < 2400 and np.all(state[:1200] == NOMINAL)
    assert np.all(state[begin:] == RETREAT) and brake[begin:begin + 200].max() > 0.8
    assert distance.min() > 0.03 and 2.9 < distance[-1] and distance.max() < 3.15


def test_a_couple_that_sticks_open_is_known_by_what_its_loop_demands():
    """
    8 of 16 N m: half of the time on; 30 s ln(0.5/0.3) later, with all bounds kept, it retreats.
    """
    distance, speed, state, brake = stuck(13, 12.0, 32.0, -3.35, 20.0, 0.02, 0.01)
    begin = int(np.flatnonzero(state)[0])
    assert begin == pytest.approx(1200 + 1532, abs=150) and np.all(state[begin:] == RETREAT)
    assert distance[begin:].min() > 0.03 and speed[-1] == pytest.approx(-0.1, abs=0.02)
    assert brake[begin:].max() > 0.8


def test_a_thruster_ahead_that_sticks_open_before_the_port_ends_in_an_abort():
    """20 N ahead: too fast at 4 cm; J4 takes it out, and the faces never meet."""
    distance, speed, state, brake = stuck(1, 16.0, 28.0, -3.5, 24.0, 0.03, 0.02)
    begin = int(np.flatnonzero(state == ABORT)[0])
    assert 1600 < begin < 2300 and np.all(state[:1600] == NOMINAL)
    assert speed[begin] > 0.018 and (brake > 0.5).sum() == pytest.approx(200, abs=5)
    assert distance.min() > 0.03 and distance[-1] > 1.0 and speed[-1] < -0.1


TAPE = HEAD + '''
0,1,0,0,0,0,0,1,1,0,1,0,0
26,0,0,0,0,0,0,1,1,1,1,0,0
26.5,1,0,0,0,0,0,1,1,0,1,0,0
60,0,0,0,0,0,0,1,1,0,1,0,0
'''


@pytest.mark.slow
@pytest.mark.patient
def test_after_a_retreat_the_operator_resumes_and_flies_on(tmp_path):
    """From 1.8 m, 10 cm aside: J4 takes it to 3 m; hands are not heard until button 2."""
    (tmp_path / 'tape.csv').write_text(TAPE)
    flown = fly(scenario(31.0, 'steering: aboard, operator: replay, start: {position_m: [-4.8, 0.1,'
                         ' 0.0], attitude_deg: [0.0, 0.0, 0.0]}',
                         joystick_replay=f'tape: "{tmp_path}/tape.csv"',
                         docking_controller='safety: {near_m: 1.9}'), range(1),
                record=[TRUTH, GUIDANCE])
    truth, state = flown.history[TRUTH], np.ravel(flown.history[GUIDANCE].safety)
    assert np.all(state[20:2600] == RETREAT) and np.all(state[2602:] == NOMINAL)
    assert truth.thrust[:, 0, 25:29].max() > 0.8
    assert away(truth)[2550] == pytest.approx(3.0, abs=0.06)
    # braked by J2 in time; at full speed up to 3 m it would pass by v^2/2a = 0.25 m
    assert away(truth).max() < 3.1
    assert np.abs(truth.velocity[2550:2600, 0]).max() < 0.025
    assert truth.velocity[-50:, 0, 0].mean() == pytest.approx(0.05, abs=0.02)
    assert away(truth)[-1] < away(truth)[2650] - 0.1


@pytest.mark.slow
@pytest.mark.patient
def test_the_tape_of_two_hands_docks():
    """Rates alone, from 3 m into the band, with panels, tanks, both filters and safety."""
    shipped = load(_shipped('scenarios', 'docking_manual.yaml')).with_values(
        '/**', operator='replay', timeout_s=82.0, **{'limits.from_s': 76.0,
                                                     'seeing.camera': 'simple'})
    flown = fly(shipped.with_values('joystick_replay', tape=str(_shipped('tapes',
                                                                         'docking_hands.csv'))),
                range(1))
    assert flown.verdict.success.all(), (flown.verdict.reason, flown.verdict.values)
    assert flown.verdict.values['settled_s'][0] < 76.0
    assert flown.columns['safety_state'][0] == NOMINAL


def _shipped(folder, name):
    from pathlib import Path
    return Path(__file__).resolve().parents[4] / folder / name


@pytest.mark.parametrize('shared, sections, words', [
    ('operator: model', {}, 'operator model needs steering aboard or remote, got profile'),
    ('steering: aboard', {}, 'steering aboard needs an operator: model, replay, console or joy'),
    ('steering: remote, operator: model, planner: polynomial', {}, 'polynomial needs steering'),
    ('steering: remote, operator: console, joy_input: held', {}, 'held needs pace realtime'),
    ('steering: aboard, operator: joy, joy_input: held', {}, 'joy_input held needs pace realtime'),
    ('steering: aboard, operator: replay', {}, 'operator replay needs a tape'),
    ('steering: aboard, operator: model, hand: {pulse_s: 0.02}', {}, 'pulse_s'),
    ('steering: aboard, operator: model, hand: {pulse_s: 0.105}', {}, 'hand.pulse_s'),
    ('steering: aboard, operator: model, hand: {click: 0.04}', {}, 'click must be above dead_zone'),
    ('steering: remote, operator: model, forward_delay_s: 1.333', {}, 'forward_delay_s')])
def test_who_cannot_steer_is_refused_in_one_line(shared, sections, words):
    with pytest.raises(BadInput, match=words) as refused:
        fly(scenario(1.0, shared, **sections), range(1))
    assert '\n' not in str(refused.value)


def test_a_tape_of_one_stick_is_refused_with_what_it_has(tmp_path):
    (tmp_path / 'one.csv').write_text('t_s,axis_0,axis_1,axis_2,button_0\n0,0,0,0,1\n9,0,0,0,1\n')
    with pytest.raises(BadInput, match='have 6 axes and 6 buttons on a tape, got 3 and 1'):
        fly(scenario(1.0, 'steering: aboard, operator: replay',
                     joystick_replay=f'tape: "{tmp_path}/one.csv"'), range(1))
