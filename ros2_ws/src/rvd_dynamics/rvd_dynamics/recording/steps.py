"""
The step of a serialised message, read from its bytes without decoding it.

Source  CDR, little endian as ROS 2 writes it: 4 bytes of encapsulation, then the fields, each
        aligned to its size from there on. A header is a stamp (two 4-byte numbers) and a name
        (4-byte length, characters, a zero).
"""

import struct
from typing import Callable

from rvd_dynamics.constants import NS_PER_S

HEADER_THEN_STEP = frozenset(f'rvd_interfaces/msg/{name}' for name in (
    'RelativeState', 'ThrustCommand', 'LinkStatus', 'PredictionScore', 'Verdict', 'RunEvent',
    'Values'))
STEP_FIRST = frozenset(('rvd_interfaces/msg/LinkFrame',))
STAMP_FIRST = frozenset(('sensor_msgs/msg/Joy', 'rosgraph_msgs/msg/Clock', 'nav_msgs/msg/Odometry',
                         'sensor_msgs/msg/Imu'))
STAMP_IN_LIST = frozenset(('tf2_msgs/msg/TFMessage',))  # of its first element
_STEP = struct.Struct('<Q')
_STAMP = struct.Struct('<iI')
_LENGTH = struct.Struct('<I')


def _after_header(data: bytes) -> int:
    end = 16 + _LENGTH.unpack_from(data, 12)[0]         # of the name, from the start of `data`
    return _STEP.unpack_from(data, 4 + ((end - 4 + 7) & ~7))[0]


def _first(data: bytes) -> int:
    return _STEP.unpack_from(data, 4)[0]


def step_reader(kind: str, step_ns: int) -> Callable[[bytes], int] | None:
    """
    Return the function that reads the step of serialised messages of type `kind`.

    Joy, Clock and other standard messages carry no step: theirs is the stamp in steps of
    `step_ns`. None if messages of this type belong to no step. The function raises `struct.error`
    if there are too few bytes.
    """
    if kind in HEADER_THEN_STEP:
        return _after_header
    if kind in STEP_FIRST:
        return _first
    if kind in STAMP_FIRST or kind in STAMP_IN_LIST:
        at = 8 if kind in STAMP_IN_LIST else 4

        def stamped(data: bytes) -> int:
            seconds, nanoseconds = _STAMP.unpack_from(data, at)
            return (seconds * NS_PER_S + nanoseconds) // step_ns
        return stamped
    return None


class StepLedger:
    """Counts what never came, for topics that get one message at each firing of their writer."""

    def __init__(self) -> None:
        self.last: dict[str, int] = {}
        self.missing: dict[str, int] = {}
        self._period: dict[str, int] = {}

    def expect(self, topic: str, period: int = 1) -> None:
        """Expect one message of `topic` every `period` steps, from step 0 on."""
        self.last[topic] = -period
        self.missing[topic] = 0
        self._period[topic] = period

    def due(self, topic: str) -> int:
        """Return the step of the next message of a topic."""
        return self.last[topic] + self._period[topic]

    def saw(self, topic: str, step: int) -> None:
        """Note a message; one that comes late does not close the gap it left."""
        last = self.last[topic]
        if step > last:
            self.missing[topic] += (step - last) // self._period[topic] - 1
            self.last[topic] = step

    def reached(self, step: int) -> bool:
        """Say whether every topic has reached the last firing up to `step`."""
        return all(last + self._period[topic] > step for topic, last in self.last.items())

    def end(self, step: int) -> None:
        """Count as missing what has not come by the last step of the run."""
        for topic, last in self.last.items():
            due = max((step - last) // self._period[topic], 0)
            self.missing[topic] += due
            self.last[topic] = last + due * self._period[topic]
