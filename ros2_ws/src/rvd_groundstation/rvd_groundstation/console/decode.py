"""
From messages to what a page can be shown: named parts of signals, as plain lists and numbers.

The live node hands in what rclpy decoded, the reader of bags what mcap decoded; both have the
fields of the `.msg` files, and this is the one place where these are read for the console.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
import math
import re
from typing import Any

from rvd_dynamics.commands.codes import KIND_THRUST, REASON_NONE
from rvd_dynamics.diagram.limits import LARGEST
from rvd_dynamics.diagram.signal import VALUES
from rvd_dynamics.link.frame import Downlink, Refusal, ReplayWindow, unpack_downlink

NS_PER_S = 1_000_000_000
COUNTS = ('sent', 'delivered', 'late', 'lost', 'outage', 'corrupted', 'in_flight', 'queued')
EMPTY = 'EMPTY'                 # why nothing came: the link had nothing due
DELAYS = ('delay_p50', 'delay_p99', 'delay_max')
PART = re.compile(r'(\w+)(?:\[([\d,]*)\])?')         # of a layout: 'state[2], final'


@dataclass(slots=True)
class Sample:
    """The newest of one signal."""

    step: int                   # in which it was emitted
    t: float                    # [s] simulated: the instant it is valid for
    ok: bool                    # false: nothing is known and the parts say nothing
    parts: dict[str, Any] = field(default_factory=dict)     # name: number or list of numbers
    received: float | None = None           # [s] simulated: when the ground had it
    transit: float | None = None            # [s] how long it was on the link


@dataclass(frozen=True, slots=True)
class Heard:
    """An intact downlink: what it measured, and what it says of commands."""

    sample: Sample
    generated_ns: int           # [ns] instant of the measurement
    accepted: int               # sequence of the last command that the craft accepted
    refusal: int                # its last refusal code


@dataclass(frozen=True, slots=True)
class Lost:
    """A step in which nothing intact came down."""

    step: int
    why: str


def telemetry_of(frame: Any, step_s: float, width: int,
                 named: Callable[[list[float]], dict[str, Any]],
                 window: ReplayWindow | None = None) -> Heard | Lost:
    """
    Return what a LinkFrame brought down.

    `step_s` [s] is the base step, `width` how many numbers the measured state has, and
    `named(state)` returns it as parts. `window` remembers what has come down before.
    """
    if frame.empty:
        return Lost(frame.step, EMPTY)
    content = unpack_downlink(bytes(frame.payload), width)
    if not isinstance(content, Downlink):
        return Lost(frame.step, content.name)
    if not all(abs(number) <= LARGEST for number in content.state):
        return Lost(frame.step, 'NAN' if any(map(math.isnan, content.state)) else 'RANGE')
    if window is not None and not (content.sequence <= frame.step + 1
                                   and window.takes(content.sequence)):
        return Lost(frame.step, Refusal.ORDER.name)
    sample = Sample(frame.step, content.generated_ns / NS_PER_S, True, named(list(content.state)),
                    received=frame.step * step_s,
                    transit=(frame.arrived - frame.sent) / NS_PER_S)
    return Heard(sample, content.generated_ns, content.accepted_sequence, content.refusal)


def state_of(message: Any) -> Sample:
    """Return a RelativeState: position, velocity, final; sigma (6) where it is estimated."""
    parts = {'position': _vector(message.position), 'velocity': _vector(message.velocity),
             'final': bool(message.final)}
    covariance = message.covariance
    if not math.isnan(covariance[0]):
        parts['sigma'] = [math.sqrt(max(float(v), 0.0)) for v in covariance[::7]]
    return Sample(message.step, _instant(message), bool(message.valid), parts)


def score_of(message: Any) -> Sample | None:
    """
    Return a PredictionScore: error (6), the sigma (6) it was claimed with, rms (6) so far.

    None when nothing could be scored in its step: what was said before still holds.
    """
    if not message.valid:
        return None
    return Sample(message.step, _instant(message), True, {
        'error': [*_vector(message.position_error), *_vector(message.velocity_error)],
        'sigma': _floats(message.sigma), 'rms': _floats(message.rms)})


def command_of(message: Any) -> Sample:
    """Return a ThrustCommand: value (one number per axis), kind, by, weight, reason, sequence."""
    return Sample(message.step, _instant(message), bool(message.valid), {
        'value': [int(level) for level in message.levels], 'kind': message.kind,
        'by': message.decided_by, 'weight': message.pilot_weight, 'reason': message.reason,
        'sequence': message.sequence})


def values_of(message: Any) -> Sample:
    """
    Return the parts of any signal as `Values`, by the names in its layout.

    A part with a shape becomes a flat list, one without a number. Nothing is known where the
    part `valid` says so or, without such a part, where no number is finite.
    """
    parts, at = {}, 0
    for name, shape in PART.findall(message.layout):
        size = math.prod(int(n) for n in shape.split(',') if n)
        numbers = _floats(message.values[at:at + size])
        parts[name] = numbers if shape else numbers[0]
        at += size
    ok = parts['valid'] if 'valid' in parts else any(map(math.isfinite, message.values))
    return Sample(message.step, _instant(message), bool(ok), parts)


def command_of_values(message: Any) -> Sample:
    """
    Return a command as `Values` with the parts of `command_of`, as far as it has them.

    `by` is None where the command does not tell who decided it.
    """
    sample = values_of(message)
    given = sample.parts
    sample.parts = {
        'value': given.get('command', []), 'kind': int(given.get('kind', KIND_THRUST)),
        'by': int(given['decided_by']) if 'decided_by' in given else None,
        'weight': given.get('pilot_weight', math.nan),
        'reason': int(given.get('reason', REASON_NONE)), 'sequence': message.step + 1}
    return sample


def link_of(message: Any) -> dict[str, float]:
    """Return the counts and delays of a LinkStatus that the page shows."""
    return {name: getattr(message, name) for name in COUNTS + DELAYS}


# Message types that are shown, by the names that ROS gives them.
SAMPLES: dict[str, Callable[[Any], Sample | None]] = {
    'rvd_interfaces/msg/RelativeState': state_of,
    'rvd_interfaces/msg/PredictionScore': score_of,
    'rvd_interfaces/msg/ThrustCommand': command_of,
    VALUES: values_of,
}
# Those that a command which is sent may have.
COMMANDS: dict[str, Callable[[Any], Sample]] = {
    'rvd_interfaces/msg/ThrustCommand': command_of,
    VALUES: command_of_values,
}


def _vector(v: Any) -> list[float]:
    return [v.x, v.y, v.z]


def _floats(values: Any) -> list[float]:
    return [float(v) for v in values]


def _instant(message: Any) -> float:
    stamp = message.header.stamp
    return (stamp.sec * NS_PER_S + stamp.nanosec) / NS_PER_S
