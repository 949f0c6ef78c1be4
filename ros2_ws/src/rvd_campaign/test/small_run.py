"""A small run written as the recorder writes one: known numbers in every topic."""

from pathlib import Path

import numpy as np
from rclpy.serialization import serialize_message
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy
from std_msgs.msg import String, UInt64

from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.ros.conversions import header_at, time_at, vector
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.bag_writer import BagWriter
from rvd_dynamics.recording.rosbag2 import qos_words
from rvd_interfaces.msg import (
    LinkFrame, LinkStatus, Measure, PredictionScore, RelativeState, RunEvent, ThrustCommand,
    Verdict)

STEP_NS = 500_000_000
HOLD = 10                       # [steps] of each link
LAST = 120                      # last step: x reaches 0
LOST = 40                       # the command sent at this step is never released
FRAME = 'target_lvlh'
SCENARIO = '''# Scenario small as flown, every default resolved.
/**:
  ros__parameters:
    step_s: 0.5
    mode: shared
    seed: 7
    corridor: {half_angle_deg: 3.0, docking_radius_m: 0.3}
joystick_replay:
  ros__parameters: {tape: "<script>alert(1)</script>"}
'''
ROSTER = Roster(parse(SCENARIO, 'small'))


def true_state(k: int) -> np.ndarray:
    """Return the state (6,) at step k: 0.25 m/s along x from -30 m, 0.1 m beside the axis."""
    return np.array([-30.0 + 0.25 * k, 0.1, -0.05, 0.5, 0.0, 0.0])


ERROR = np.array([0.02, -0.003, 0.004, 0.001, 0.0, -0.0005])    # of every prediction
SIGMA = np.array([0.03, 0.004, 0.004, 0.002, 0.001, 0.001])     # that it claims


def step_messages(k: int) -> dict[str, object]:
    """Return what the nodes publish in step k."""
    now = k * STEP_NS
    at = header_at(now, FRAME)
    state = true_state(k)

    def states(source, ahead, value, covariance=None, valid=True):
        known = [np.nan, *[0.0] * 35] if covariance is None else covariance.ravel()
        return RelativeState(
            header=header_at(now + ahead * STEP_NS, FRAME), step=k, source=source, valid=valid,
            final=k == LAST and source == 0, position=vector(value[:3]), velocity=vector(value[3:]),
            acceleration=vector((0.01, 0.0, 0.0) if source == 0 else (np.nan,) * 3),
            covariance=known)

    def frame(hold, lost=-1):
        sent = k - hold
        if sent < 0 or sent == lost:
            return LinkFrame(step=k, sent=-1, arrived=-1, released=-1, empty=True)
        return LinkFrame(step=k, sequence=sent, sent=sent * STEP_NS, payload=bytes(8),
                         arrived=sent * STEP_NS + 4_200_000_000 + sent * 1_000_000, released=now)

    def command(levels, by, weight=np.nan, reason=codes.REASON_NONE):
        return ThrustCommand(header=at, step=k, levels=levels, valid=True, decided_by=by,
                             pilot_weight=weight, reason=reason)

    def status(lost):
        return LinkStatus(header=at, step=k, sent=k + 1, delivered=max(k + 1 - HOLD - lost, 0),
                          late=lost, in_flight=min(k + 1, HOLD), play_out_delay=5.0,
                          delay_p50=4.2, delay_p99=4.3, delay_max=5.1 if lost else 4.3)

    known = k >= HOLD
    nothing = np.full(6, np.nan)
    pilot = [k % 7 - 3, 1, 0]
    gone = k >= LOST + HOLD
    return {
        '/clock': Clock(clock=time_at(now)),
        '/truth/relative_state': states(0, 0, state),
        '/onboard/measurement': states(1, 0, state * 1.01),
        '/onboard/downlink': LinkFrame(step=k, sequence=k, sent=now, arrived=-1, released=-1),
        '/ground/telemetry': frame(HOLD),
        '/link/back/status': status(0),
        '/ground/estimate': states(2, -HOLD, true_state(k - HOLD) if known else nothing,
                                   np.diag(SIGMA**2) if known else None, valid=known),
        '/ground/prediction': states(3, HOLD, true_state(k + HOLD) + ERROR if known else nothing,
                                     np.diag(SIGMA**2) if known else None, valid=known),
        '/ground/prediction_score': PredictionScore(
            header=header_at((k - HOLD) * STEP_NS, FRAME), step=k, valid=k >= 3 * HOLD,
            position_error=vector(ERROR[:3]), velocity_error=vector(ERROR[3:]), sigma=SIGMA,
            scored=k, rms=np.abs(ERROR)),
        '/joy': Joy(header=at, axes=[pilot[1] / 3.0, pilot[0] / 3.0, 0.0, 0.0, 0.0],
                    buttons=[0, 0, 0, 0, 1]),
        '/ground/auto_command': command([0, -1, 2], codes.BY_AUTO),
        '/ground/command': command([pilot[0], 1, 1], codes.BY_BLEND, 0.7),
        '/ground/uplink': LinkFrame(step=k, sequence=k, sent=now, arrived=-1, released=-1,
                                    payload=bytes(8)),
        '/onboard/command': frame(HOLD, LOST),
        '/link/forward/status': status(int(gone)),
        '/onboard/thruster_command': command(
            [1, 0, 0], codes.BY_NOBODY,
            reason=codes.REASON_CHECKSUM if k == 55 else codes.REASON_NONE),
        '/run/verdict': Verdict(
            header=at, step=k, final=k == LAST, success=k == LAST,
            reason='docked' if k == LAST else '', words='docked' if k == LAST else '',
            duration=k * 0.5, measures=[
                measure('x_rate_m_s', 'closing rate at docking', 'm/s', 0.25, 0.0, 0.3, k == LAST),
                measure('offset_m', 'lateral offset at docking', 'm', 0.1118, np.nan, 0.3,
                        k == LAST),
                measure('min_corridor_margin_m', 'least corridor margin', 'm', 0.188, 0.0, np.nan),
                measure('delta_v_m_s', 'delta-v', 'm/s', 0.01 * k, np.nan, np.nan),
                measure('exit_time_s', 'left the corridor at', 's', 0.0, np.nan, np.nan, False)])}


def measure(name, words, unit, value, low, high, known=True) -> Measure:
    """Return a measure that is within its limits if it is known."""
    limited = not (np.isnan(low) and np.isnan(high))
    return Measure(name=name, words=words, unit=unit, value=value if known else np.nan, low=low,
                   high=high, ok=known or not limited, digits=3 if 'margin' in name else 4)


def messages(steps: int = LAST + 1) -> list[tuple[str, int, object]]:
    """Return (topic, step, message) in the order of publication, the scenario first."""
    made = [('/run/scenario', 0, String(data=SCENARIO))]
    for k in range(steps):
        made += [(topic, k, message) for topic, message in step_messages(k).items()]
        if k == 55:
            made.append(('/run/events', k, RunEvent(
                header=header_at(k * STEP_NS, FRAME), step=k, node='onboard_guard',
                code='REFUSED', text='checksum <b>does not match</b>')))
        if k == LAST:
            made.append(('/run/end', k, UInt64(data=LAST)))
    return made


def write_run(run_dir: Path, given=None, close: bool = True, notes=None, unstored=(),
              kinds={}) -> Path:
    """Write a run folder and return it; without `close` as if the recorder had died."""
    bag = BagWriter(run_dir / 'bag')
    for topic, kind in {**ROSTER.topics, **kinds}.items():
        bag.add_topic(topic, kind, qos_words(2000, True, True))
    for i, (topic, k, message) in enumerate(messages() if given is None else given):
        assert bag.write(topic, serialize_message(message), k * STEP_NS, i, i)
    for topic in unstored:
        assert not bag.write(topic, b'', 0, 0)  # the bag has no such topic
    bag.close(notes) if close else bag._file.close()
    return run_dir


def as_state(message: RelativeState) -> list[float]:
    """Return the six numbers of a message."""
    p, v = message.position, message.velocity
    return [p.x, p.y, p.z, v.x, v.y, v.z]
