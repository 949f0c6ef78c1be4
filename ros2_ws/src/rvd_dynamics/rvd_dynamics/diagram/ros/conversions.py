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
from rvd_interfaces.msg import Measure, RelativeState, Verdict

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


def state_from_msg(message: RelativeState) -> NDArray[np.float64]:
    """Return position and velocity as an array of shape (6,)."""
    p, v = message.position, message.velocity
    return np.array((p.x, p.y, p.z, v.x, v.y, v.z))


def verdict_to_msg(header: Header, step: int, final: bool, judged: Judgement) -> Verdict:
    """Return a Verdict; its way back is `diagram.judge.from_message`."""
    fields = judged._asdict() | {'measures': [Measure(**m._asdict()) for m in judged.measures]}
    return Verdict(header=header, step=step, final=final, **fields)
