"""
Codecs of what goes over the link: frames of bytes, with an envelope that its legs read.

Source  docs/models/link.md: the layout of both frames, and what refuses them.
"""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from rvd_dynamics.commands import codes
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.limits import checker
from rvd_dynamics.diagram.ros.codecs import Codec, Event
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.link.frame import Downlink as Measured
from rvd_dynamics.link.frame import (
    pack_command, pack_downlink, Refusal, ReplayWindow, unpack_downlink)
from rvd_dynamics.onboard.guard.gate import Gate
from rvd_interfaces.msg import LinkFrame

REFUSALS = frozenset(Refusal)
MOST_BYTES = 4096               # of a frame's payload: ours have less than 400


class FrameOfLink(NamedTuple):
    """A LinkFrame that passes by hand; the fields of the message."""

    step: int
    sequence: int = 0
    sent: int = -1
    arrived: int = -1
    released: int = -1
    empty: bool = False
    expedited: bool = False
    payload: bytes = b''

    def serialised(self) -> bytes:
        """Return the message as bytes."""
        return _frame_layout(len(self.payload)).pack(*self)


@lru_cache(maxsize=64)
def _frame_layout(size: int) -> Layout:
    return Layout(LinkFrame, sizes={'payload': size})


def frame_fault(k: int, frame: LinkFrame, step_ns: int) -> str:
    """Return what is wrong with the envelope of a frame that was emitted in step k."""
    size, now_ns = len(frame.payload), k * step_ns
    if size > MOST_BYTES:
        return f'payload must be {MOST_BYTES} bytes at most, got {size}'
    if frame.empty:
        return f'payload of an empty frame must have no bytes, got {size}' if size else ''
    if frame.sequence > k + 1:
        return f'sequence must be {k + 1} at most, got {frame.sequence}'
    for name in ('sent', 'arrived', 'released'):
        if not -1 <= getattr(frame, name) <= now_ns:
            return f'{name} must be from -1 to the {now_ns} ns of its step, got ' \
                f'{getattr(frame, name)}'
    return ''


class Envelope(Codec):
    """What a leg of the link sees of a frame that it is to carry; the payload is bytes to it."""

    frames = envelope = True

    def odd(self, k: int, message: LinkFrame) -> str:
        """Return what is wrong with a frame that was handed over in step k."""
        now_ns = k * self.run.step_ns
        if not message.empty and message.sent != now_ns:
            return f'sent must be the {now_ns} ns of its step, got {message.sent}'
        return frame_fault(k, message, self.run.step_ns)


class _Sender(Codec):
    """Packs a value into the frame of its step, which is what passes by hand."""

    frames = True

    def _frame(self, k: int, payload: bytes, expedited: bool = False) -> FrameOfLink:
        return FrameOfLink(step=k, sequence=k + 1, sent=k * self.run.step_ns, expedited=expedited,
                           payload=payload)


class Downlink(_Sender):
    """What the craft sends down, as LinkFrame."""

    def encode(self, k: int, value: Any) -> FrameOfLink:
        """Return the frame of a value."""
        return self._frame(k, pack_downlink(
            sequence=k + 1, generated_ns=k * self.run.step_ns, state=value.state,
            accepted_sequence=value.accepted or 0, refusal=value.refusal or 0))


class Telemetry(Codec):
    """What came down, each frame once, from a LinkFrame."""

    frames = True

    def __init__(self, signal: Signal, run: Run, event: Event) -> None:
        super().__init__(signal, run)
        self._event, self._width = event, signal.parts[0].shape[0]
        self._acknowledges = any(part.name == 'accepted' for part in signal.parts)
        self._complaint = checker(signal)
        self._window = ReplayWindow()
        self._counts = dict.fromkeys(Refusal, 0)
        self._newest: tuple[LinkFrame | None, Any] = None, self.initial

    def odd(self, k: int, message: LinkFrame) -> str:
        """Return what is wrong with the envelope."""
        return frame_fault(k, message, self.run.step_ns)

    def decode(self, k: int, message: LinkFrame) -> Any:
        """
        Return what the frame of step k holds; the same if it is asked for again.

        Nothing is received if it holds nothing intact, numbers that the signal cannot have, or what
        has been received before.
        """
        if message.empty:
            return self.initial
        if message is not self._newest[0]:      # a fast reader looks at it more than once
            self._newest = message, self._received(k, bytes(message.payload))
        return self._newest[1]

    def _received(self, k: int, payload: bytes) -> Any:
        content = unpack_downlink(payload, self._width)
        if not isinstance(content, Measured):
            return self._refused(content)
        state = np.array(content.state)
        told = {'accepted': np.int64(content.accepted_sequence)} if self._acknowledges else {}
        found = self.signal(state=state, received=np.isfinite(state).all(), **told)
        why = self._complaint(found, k)
        if why:
            return self._refused(Refusal.RANGE, f': {why}')
        if content.sequence > k + 1 or not self._window.takes(content.sequence):
            return self._refused(Refusal.ORDER)
        return found

    def _refused(self, refusal: Refusal, why: str = '') -> Any:
        self._counts[refusal] += 1
        self._event('REFUSED', f'telemetry refused: {refusal.name}{why}, '
                    f'{self._counts[refusal]} so far')
        return self.initial


class Uplink(_Sender):
    """What the ground sends up, as LinkFrame."""

    def __init__(self, signal: Signal, run: Run, form: CommandForm) -> None:
        super().__init__(signal, run)
        self._form = form

    def encode(self, k: int, value: Any) -> FrameOfLink:
        """Return the frame of a value."""
        return self._frame(k, pack_command(
            sequence=k + 1, generated_ns=k * self.run.step_ns, command=value.command.tolist(),
            kind=int(value.kind), form=self._form), bool(value.expedited))


class Arrival(Codec):
    """What came up, through the guard's gate, from a LinkFrame."""

    frames = True

    def __init__(self, signal: Signal, run: Run, form: CommandForm, legs: Legs, event: Event
                 ) -> None:
        super().__init__(signal, run)
        self._event, self._neutral = event, form.neutral
        self._aborted = False
        self._gate = Gate(form, legs.forward * run.step_ns, run.step_ns)

    def odd(self, k: int, message: LinkFrame) -> str:
        """Return what is wrong with the envelope."""
        return frame_fault(k, message, self.run.step_ns)

    def decode(self, k: int, message: LinkFrame) -> Any:
        """Return what the gate makes of the frame of step k."""
        return self._passed(k, None if message.empty else bytes(message.payload))

    def missing(self, k: int) -> Any:
        """Return what the gate makes of no frame."""
        return self._passed(k, None)

    def _passed(self, k: int, payload: bytes | None) -> Any:
        passed = self._gate.advance(k, payload)
        self._aborted |= passed.received and passed.kind == codes.KIND_ABORT
        # ABORT frames overtake each other on their way: one that comes after a later one is no news
        overtaken = self._aborted and passed.reason == Refusal.ORDER
        if passed.reason in REFUSALS and not overtaken:
            name = Refusal(passed.reason).name
            self._event('REFUSED', f'command refused: {name}, '
                        f'{passed.counts[name.lower()]} so far')
        return self.signal(
            command=np.array(passed.command, dtype=self._neutral.dtype),
            kind=np.uint8(passed.kind), received=np.bool_(passed.received),
            reason=np.uint8(passed.reason), sequence=passed.sequence)
