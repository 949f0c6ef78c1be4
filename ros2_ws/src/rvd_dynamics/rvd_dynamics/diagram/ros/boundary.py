"""
The boundary of a reader: what comes from another process is looked at once, here, or left out.

Every field that the reader uses is held against the declaration of its signal (`diagram.limits`),
against its codec, which knows the fields of the message that go into no value, and against what
steps there can be (`horizon`). What cannot be is refused: it counts as not there, is counted, and
is said once. Nothing that comes in a message ends a process.
"""

from collections.abc import Callable
import struct
from typing import Any

from rclpy.serialization import deserialize_message

from rvd_dynamics.diagram.limits import checker
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.signal import Signal

# what reading bytes or numbers of a stranger may raise; another error is one of ours
UNREADABLE = (ValueError, OverflowError, struct.error)


class Refused(Exception):
    """A message that is left out; the text says why."""


def content(signal: Signal, codec: Any, optional: tuple = ()) -> Callable[[int, Any], Any]:
    """
    Return a function of a step and a message, which returns what of it is kept.

    A value, or the message itself where only a firing can decode it (`codec.frames`). It raises
    `Refused` for what cannot be. `optional` names the optional parts that the reader uses.
    """
    complaint = checker(signal, optional)

    def taken(step: int, message: Any) -> Any:
        try:
            why = codec.odd(step, message)
            if codec.frames:
                value = message
            else:
                value = codec.decode(step, message)
                why = why or complaint(value, step)
        except UNREADABLE as error:
            raise Refused(' '.join(str(error).split())) from None
        if why:
            raise Refused(why)
        return value
    return taken


def step_of(message: Any, step_ns: int) -> int:
    """Return the step of a message: its own, or that of its stamp."""
    step = getattr(message, 'step', None)
    return ns_of(message.header.stamp)//step_ns if step is None else step


def read(data: bytes, kind: type) -> Any:
    """
    Return the message in bytes.

    Raises
    ------
    Refused
        If there is none in them.
    """
    try:
        return deserialize_message(data, kind)
    except Exception as error:              # noqa: B902 - rclpy has no class of its own for it
        raise Refused(f'{len(data)} bytes hold no {kind.__name__}: {error}') from None
