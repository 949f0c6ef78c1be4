"""
Codecs: between the value of a signal and its message; a graph only.

A codec is made with what its constructor names (`diagram.build`), besides `signal`, `run` and
`event`, with which it may say that something happened. Its methods are `encode(k, value)`,
`decode(k, message)` and `missing(k)`, what a reader gets when nothing came; `wired(value)` is what
a reader in the same process gets, equal to what another would decode.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from sensor_msgs.msg import Joy

from rvd_dynamics.commands import codes
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.commands.levels import HIGHEST, stick_axes, stick_levels, StickParams
from rvd_dynamics.diagram.ros.conversions import (
    header_at, NAN, state_from_msg, state_to_msg, vector)
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.link.frame import Downlink as Measured
from rvd_dynamics.link.frame import pack_command, pack_downlink, Refusal, unpack_downlink
from rvd_dynamics.onboard.guard.gate import Gate
from rvd_interfaces.msg import LinkFrame, PredictionScore, RelativeState, ThrustCommand, Values

Event = Callable[[str, str], None]
REFUSALS = frozenset(Refusal)


class Codec:
    """What codecs have in common."""

    def __init__(self, signal: Signal, run: Run) -> None:
        self.signal, self.run = signal, run
        self.initial = signal.initial(())

    def stamp_ns(self, k: int) -> int:
        """Return the instant that the content of step k is valid for [ns]."""
        return max(k + self.signal.ahead, 0) * self.run.step_ns

    def header(self, k: int) -> Any:
        """Return a header with that instant."""
        return header_at(self.stamp_ns(k), self.run.frame_id)

    def wired(self, value: Any) -> Any:
        """Return what a reader in the same process gets."""
        return value

    def missing(self, k: int) -> Any:
        """Return what a reader gets when no message came in time."""
        return self.initial


class Parts(Codec):
    """Any signal as `Values`: its parts one after the other, as numbers."""

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = ', '.join(
            f'{part.name}[{",".join(map(str, part.shape))}]' if part.shape else part.name
            for part in signal.parts)

    def encode(self, k: int, value: Any) -> Values:
        """Return the message of a value."""
        numbers = np.concatenate([np.ravel(part).astype(float) for part in value])
        return Values(header=self.header(k), step=k, layout=self._layout, values=numbers)

    def decode(self, k: int, message: Values) -> Any:
        """Return the value in a message; ValueError if it is of another layout."""
        if message.layout != self._layout:
            raise ValueError(f'{self.signal.name} must hold {self._layout}, got {message.layout}')
        made, at = [], 0
        for part in self.signal.parts:
            size = int(np.prod(part.shape, dtype=int))
            made.append(np.asarray(message.values[at:at + size]).reshape(part.shape).astype(
                part.dtype))
            at += size
        return self.signal.type(*made)


# -- states ------------------------------------------------------------------------------------

class Truth(Codec):
    """The true state as RelativeState."""

    def encode(self, k: int, value: Any) -> RelativeState:
        """Return the message of a value."""
        return state_to_msg(
            k, self.stamp_ns(k), self.run.frame_id, RelativeState.SOURCE_TRUTH, value.state,
            valid=bool(np.isfinite(value.state).all()), final=bool(value.final),
            acceleration=value.acceleration)

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message."""
        a = message.acceleration
        return self.signal(state=state_from_msg(message), acceleration=np.array((a.x, a.y, a.z)),
                           final=np.bool_(message.final))


class Measurement(Codec):
    """A sensor's sample as RelativeState."""

    def encode(self, k: int, value: Any) -> RelativeState:
        """Return the message of a value."""
        return state_to_msg(k, self.stamp_ns(k), self.run.frame_id,
                            RelativeState.SOURCE_MEASUREMENT, value.state,
                            bool(np.isfinite(value.state).all()))

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message."""
        return self.signal(state=state_from_msg(message))


class Estimate(Codec):
    """A state that somebody believes in, with its covariance, as RelativeState."""

    source = RelativeState.SOURCE_ESTIMATE

    def encode(self, k: int, value: Any) -> RelativeState:
        """Return the message of a value."""
        return state_to_msg(k, self.stamp_ns(k), self.run.frame_id, self.source, value.state,
                            bool(value.valid), covariance=value.covariance)

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message, without the covariance, which no block reads."""
        return self.signal(state=state_from_msg(message), valid=np.bool_(message.valid))


class Prediction(Estimate):
    """An estimate carried across the loop."""

    source = RelativeState.SOURCE_PREDICTION


class Score(Codec):
    """A prediction held against what came down later, as PredictionScore."""

    def encode(self, k: int, value: Any) -> PredictionScore:
        """Return the message of a value."""
        return PredictionScore(
            header=self.header(k), step=k, valid=bool(value.valid),
            position_error=vector(value.error[:3]), velocity_error=vector(value.error[3:]),
            sigma=value.sigma, scored=int(value.scored), rms=value.rms)


# -- commands ----------------------------------------------------------------------------------

class Stick(Codec):
    """
    Levels as `sensor_msgs/Joy`, by the axes and buttons of the stick's settings.

    A Joy has no step: its stamp is the step's instant. What a tape holds goes out as it is.
    """

    def __init__(self, signal: Signal, run: Run, stick: StickParams) -> None:
        super().__init__(signal, run)
        self._stick = stick

    def encode(self, k: int, value: Any) -> Joy:
        """Return the message of a value."""
        axes, buttons = value.raw or stick_axes(
            [level / HIGHEST for level in value.command.tolist()], True, self._stick)
        return Joy(header=header_at(k * self.run.step_ns, 'joy'), axes=axes, buttons=buttons)

    def decode(self, k: int, message: Joy) -> Any:
        """Return the value in a message."""
        levels, valid = stick_levels(message.axes, message.buttons, self._stick)
        return self.signal(command=levels, valid=np.bool_(valid))


class Automatic(Codec):
    """What the law commands, as ThrustCommand."""

    def encode(self, k: int, value: Any) -> ThrustCommand:
        """Return the message of a value."""
        valid = bool(value.valid)
        return ThrustCommand(
            header=self.header(k), step=k, levels=value.command, valid=valid, pilot_weight=NAN,
            decided_by=codes.BY_AUTO if valid else codes.BY_NOBODY,
            reason=codes.REASON_NONE if valid else codes.REASON_MISSING)

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(command=np.array(message.levels, dtype=np.int8),
                           valid=np.bool_(message.valid))


class Ground(Codec):
    """The command of the ground, as ThrustCommand."""

    def encode(self, k: int, value: Any) -> ThrustCommand:
        """Return the message of a value."""
        return ThrustCommand(
            header=self.header(k), step=k, sequence=k + 1, kind=int(value.kind),
            levels=value.command, valid=True, decided_by=int(value.decided_by),
            pilot_weight=float(value.pilot_weight), reason=int(value.reason))

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(
            command=np.array(message.levels, dtype=np.int8), kind=np.uint8(message.kind),
            decided_by=np.uint8(message.decided_by), pilot_weight=message.pilot_weight,
            reason=np.uint8(message.reason))


class Thrusters(Codec):
    """What the guard commands, as ThrustCommand."""

    def encode(self, k: int, value: Any) -> ThrustCommand:
        """Return the message of a value."""
        return ThrustCommand(
            header=self.header(k), step=k, sequence=int(value.sequence), kind=int(value.kind),
            levels=value.command, valid=bool(value.valid), pilot_weight=NAN,
            reason=int(value.reason), decided_by=int(value.decided_by))

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(
            command=np.array(message.levels, dtype=np.int8), kind=np.uint8(message.kind),
            valid=np.bool_(message.valid), reason=np.uint8(message.reason),
            sequence=message.sequence, decided_by=np.uint8(message.decided_by))


# -- the ends of the link ------------------------------------------------------------------------

class _Sender(Codec):
    """Packs a value into the frame of its step."""

    def _frame(self, k: int, payload: bytes, expedited: bool = False) -> LinkFrame:
        return LinkFrame(step=k, sequence=k + 1, sent=k * self.run.step_ns, arrived=-1,
                         released=-1, expedited=expedited, payload=payload)


class Downlink(_Sender):
    """What the craft sends down, as LinkFrame."""

    def encode(self, k: int, value: Any) -> LinkFrame:
        """Return the frame of a value."""
        return self._frame(k, pack_downlink(
            sequence=k + 1, generated_ns=k * self.run.step_ns, state=value.state,
            accepted_sequence=value.accepted, refusal=value.refusal))


class Telemetry(Codec):
    """What came down, from a LinkFrame."""

    def __init__(self, signal: Signal, run: Run, event: Event) -> None:
        super().__init__(signal, run)
        self._event, self._width = event, signal.parts[0].shape[0]

    def decode(self, k: int, message: LinkFrame) -> Any:
        """Return what the frame of step k holds; nothing received if it holds nothing intact."""
        if message.empty:
            return self.initial
        content = unpack_downlink(bytes(message.payload), self._width)
        if not isinstance(content, Measured):
            self._event('REFUSED', f'telemetry refused: {content.name}')
            return self.initial
        state = np.array(content.state)
        return self.signal(state=state, received=np.isfinite(state).all())


class Uplink(_Sender):
    """What the ground sends up, as LinkFrame."""

    def __init__(self, signal: Signal, run: Run, form: CommandForm) -> None:
        super().__init__(signal, run)
        self._form = form

    def encode(self, k: int, value: Any) -> LinkFrame:
        """Return the frame of a value."""
        return self._frame(k, pack_command(
            sequence=k + 1, generated_ns=k * self.run.step_ns, command=value.command.tolist(),
            kind=int(value.kind), form=self._form), bool(value.expedited))


class Arrival(Codec):
    """What came up, through the guard's gate, from a LinkFrame."""

    def __init__(self, signal: Signal, run: Run, form: CommandForm, legs: Legs, event: Event
                 ) -> None:
        super().__init__(signal, run)
        self._event, self._neutral = event, form.neutral
        self._gate = Gate(form, legs.forward * run.step_ns, run.step_ns)

    def decode(self, k: int, message: LinkFrame) -> Any:
        """Return what the gate makes of the frame of step k."""
        return self._passed(k, None if message.empty else bytes(message.payload))

    def missing(self, k: int) -> Any:
        """Return what the gate makes of no frame."""
        return self._passed(k, None)

    def _passed(self, k: int, payload: bytes | None) -> Any:
        passed = self._gate.advance(k, payload)
        if passed.reason in REFUSALS:
            name = Refusal(passed.reason).name
            self._event('REFUSED', f'command refused: {name}, '
                        f'{passed.counts[name.lower()]} so far')
        return self.signal(
            command=np.array(passed.command, dtype=self._neutral.dtype),
            kind=np.uint8(passed.kind), received=np.bool_(passed.received),
            reason=np.uint8(passed.reason), sequence=passed.sequence)
