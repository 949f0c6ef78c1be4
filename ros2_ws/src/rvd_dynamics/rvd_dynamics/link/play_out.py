"""
The play-out buffer: turns a random transit into a constant delay of n steps plus erasures.

A frame sent at kT leaves at (k + n)T, never sooner; one that arrives after that instant is
refused, because a stale thrust command is worse than none. There is one slot for each future
instant of release, n + 1 in all, so the buffer cannot grow. It owns no clock: instants are
integer ns of simulation time.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, section 1.3: a frame with transit
        lT < delta <= (l + 1)T enters position l + 1 of n and moves one position per T.
        That shift register and these slots release the same frames at the same instants.
"""

from enum import Enum
from typing import NamedTuple

from rvd_dynamics.diagram.params import require


class Frame(NamedTuple):
    """What a link may know about a frame; instants are -1 until they have happened."""

    sequence: int                   # given by the sender, rising by one per frame
    sent_ns: int                    # [ns] handed to the link
    arrived_ns: int = -1            # [ns] reached the receiving end
    released_ns: int = -1           # [ns] handed on
    expedited: bool = False         # skips the play-out buffer
    payload: bytes = b''            # opaque to the link


class Outcome(Enum):
    """What became of a copy that arrived at the buffer."""

    QUEUED = 'queued'
    LATE = 'late'
    DUPLICATE = 'duplicate'


class PlayOut:
    """
    Slots for frames that wait for their instant of release.

    Call `insert` for each arrival since the last step, in order of arrival, then `pop` once per
    step; steps rise by one.
    """

    def __init__(self, hold_steps: int, step_ns: int) -> None:
        require(hold_steps >= 0, 'hold_steps', 'not be negative', hold_steps)
        require(step_ns >= 1, 'step_ns', 'be positive', step_ns)
        self._hold_steps = hold_steps
        self._step_ns = step_ns
        self._slots: list[Frame | None] = [None] * (hold_steps + 1)
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def insert(self, frame: Frame) -> Outcome:
        """Store `frame` unless its release instant has passed or a copy of it is already here."""
        due_step = frame.sent_ns // self._step_ns + self._hold_steps
        if frame.arrived_ns > due_step * self._step_ns:
            return Outcome.LATE
        slot = due_step % len(self._slots)
        if self._slots[slot] is not None:       # only a frame of the same step has this slot
            return Outcome.DUPLICATE
        self._slots[slot] = frame
        self._count += 1
        return Outcome.QUEUED

    def pop(self, step: int) -> Frame | None:
        """Return the frame due in `step`, if it is here, and free its slot."""
        slot = step % len(self._slots)
        frame, self._slots[slot] = self._slots[slot], None
        self._count -= frame is not None
        return frame
