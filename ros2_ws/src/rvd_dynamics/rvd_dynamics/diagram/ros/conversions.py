"""
Between messages and arrays: the one place where fields are copied.
"""

import numpy as np
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Vector3
from numpy.typing import NDArray
from std_msgs.msg import Header

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.judge import Judgement
from rvd_interfaces.msg import LinkFrame, Measure, RelativeState, ThrustCommand, Verdict

NAN = float('nan')


def time_at(ns: int) -> Time:
    """Return the stamp of an instant in integer nanoseconds."""
    return Time(sec=ns // NS_PER_S, nanosec=ns % NS_PER_S)


def ns_of(stamp: Time) -> int:
    """Return the instant of a stamp in integer nanoseconds."""
    return stamp.sec * NS_PER_S + stamp.nanosec


def header_at(ns: int, frame_id: str) -> Header:
    """Return a header for an instant and a frame."""
    return Header(stamp=time_at(ns), frame_id=frame_id)


def vector(values) -> Vector3:
    """Return a Vector3 of three numbers."""
    x, y, z = values
    return Vector3(x=float(x), y=float(y), z=float(z))


UNKNOWN = (NAN, NAN, NAN)
NO_COVARIANCE = np.zeros(36)
NO_COVARIANCE[0] = NAN


def state_to_msg(step: int, stamp_ns: int, frame_id: str, source: int, state: NDArray,
                 valid: bool = True, final: bool = False, acceleration=UNKNOWN,
                 covariance: NDArray | None = None) -> RelativeState:
    """Return a RelativeState; `state` (6,), `covariance` (6, 6) or None when not estimated."""
    numbers = state.tolist()
    return RelativeState(
        header=header_at(stamp_ns, frame_id), step=step, source=source, valid=valid, final=final,
        position=vector(numbers[:3]), velocity=vector(numbers[3:]),
        acceleration=vector(acceleration),
        covariance=NO_COVARIANCE if covariance is None else covariance.reshape(36))


def state_from_msg(message: RelativeState) -> NDArray[np.float64]:
    """Return position and velocity as an array of shape (6,)."""
    p, v = message.position, message.velocity
    return np.array((p.x, p.y, p.z, v.x, v.y, v.z))


def levels_of(message: ThrustCommand | None) -> NDArray[np.int8]:
    """Return the levels (3,) of a command; a missing or invalid one counts as level 0."""
    if message is None or not message.valid:
        return np.zeros(3, dtype=np.int8)
    return np.array(message.levels, dtype=np.int8)


def empty_frame(step: int) -> LinkFrame:
    """Return the frame that says that nothing was due."""
    return LinkFrame(step=step, sent=-1, arrived=-1, released=-1, empty=True)


def verdict_to_msg(header: Header, step: int, final: bool, judged: Judgement) -> Verdict:
    """Return a Verdict; its way back is `diagram.judge.from_message`."""
    fields = judged._asdict() | {'measures': [Measure(**m._asdict()) for m in judged.measures]}
    return Verdict(header=header, step=step, final=final, **fields)
