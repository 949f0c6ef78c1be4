"""
Codecs: between the value of a signal and its message; a graph only.

A codec is made with what its constructor names (`diagram.build`), besides `signal`, `run` and
`event`, with which it may say that something happened. Its methods are `encode(k, value)`, which
returns the serialised message, or a message object, and `decode(k, message)` with `missing(k)`,
what a reader gets when nothing came; `odd(k, message)` says what cannot be in the fields that go
into no value (`boundary`). Within a process the value itself passes by hand, as `wired`
returns it: equal to what another process would decode.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from sensor_msgs.msg import Joy

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands import codes
from rvd_dynamics.commands.levels import (
    HIGHEST, stick_axes, stick_fault, stick_levels, StickParams)
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.ros.conversions import header_at, NAN, state_from_msg
from rvd_dynamics.diagram.limits import held_by
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.signal import Signal
from rvd_interfaces.msg import PredictionScore, RelativeState, ThrustCommand, Values

Event = Callable[[str, str], None]
UNKNOWN = (NAN, NAN, NAN)
NO_COVARIANCE = (NAN, *(0.0,) * 35)
MOST_AXES = 64                  # of a Joy, and as many buttons: settings name one of them at most


class Codec:
    """What codecs have in common."""

    frames = False                              # what passes by hand is a FrameOfLink, not a value
    envelope = False                            # and nobody opens it

    def __init__(self, signal: Signal, run: Run) -> None:
        self.signal, self.run = signal, run
        self.initial = signal.initial(())

    def stamp_ns(self, k: int) -> int:
        """Return the instant that the content of step k is valid for [ns]."""
        return max(k + self.signal.ahead, 0) * self.run.step_ns

    def stamp(self, k: int) -> tuple[int, int]:
        """Return that instant as seconds and nanoseconds."""
        return divmod(self.stamp_ns(k), NS_PER_S)

    def laid_out(self, kind: type, **sizes: int) -> Layout:
        """Return the layout of messages with a header in the run's frame."""
        return Layout(kind, {'header.frame_id': self.run.frame_id}, sizes)

    def wired(self, value: Any) -> Any:
        """Return what a reader in the same process gets."""
        return value

    def missing(self, k: int) -> Any:
        """Return what a reader gets when no message came in time."""
        return self.initial

    def fault(self, message: Any) -> str:
        """Return why what a message of a held input says does not count; nothing if it does."""
        return ''

    def odd(self, k: int, message: Any) -> str:
        """Return what cannot be in the fields that go into no value; nothing if all can."""
        return ''


class Parts(Codec):
    """Any signal as `Values`: its parts one after the other, as numbers."""

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = ', '.join(
            f'{part.name}[{",".join(map(str, part.shape))}]' if part.shape else part.name
            for part in signal.parts)
        self._starts = [part.filled(()) for part in signal.parts]
        sizes = [int(np.prod(part.shape, dtype=int)) for part in signal.parts]
        self._size, self._slices, at = sum(sizes), [], 0
        for size in sizes:
            self._slices.append(slice(at, at + size))
            at += size
        self._whole = [None if start.dtype.kind == 'f' else held_by(start.dtype)
                       for start in self._starts]

    def encode(self, k: int, value: Any) -> Values:
        """Return the message of a value; ValueError if a part is not of its shape."""
        parts = self.wired(value)
        for part, given in zip(self.signal.parts, parts):
            if given.shape != part.shape:
                raise BadInput(f'{part.name} must have shape {part.shape}, got {given.shape}')
        numbers = np.concatenate([np.ravel(given).astype(float) for given in parts])
        return Values(header=header_at(self.stamp_ns(k), self.run.frame_id), step=k,
                      layout=self._layout, values=numbers)

    def wired(self, value: Any) -> Any:
        """Return what a reader gets: parts of the declared types, also those left out."""
        return self.signal.type(*(
            start if given is None else np.asarray(given, dtype=start.dtype)
            for start, given in zip(self._starts, value)))

    def decode(self, k: int, message: Values) -> Any:
        """Return the value in a message; ValueError if it is of another layout."""
        if message.layout != self._layout:
            raise BadInput(f'{self.signal.name} must hold {self._layout}, got '
                           f'{message.layout[:len(self._layout) + 20]}')
        if len(message.values) != self._size:
            raise BadInput(f'{self.signal.name} must hold {self._size} numbers, got '
                           f'{len(message.values)}')
        made, numbers = [], np.array(message.values)
        for part, start, where, whole in zip(self.signal.parts, self._starts, self._slices,
                                             self._whole):
            given = numbers[where]
            if whole is not None:
                low, high = whole
                for x in given.tolist():
                    if not (low <= x <= high and x == int(x)):
                        raise BadInput(f'{part.name} must be whole numbers from {low} to {high}, '
                                       f'got {x:g}')
            made.append(given.reshape(part.shape).astype(start.dtype))
        return self.signal.type(*made)


# -- states ------------------------------------------------------------------------------------

class _State(Codec):
    """A relative state as RelativeState."""

    source = RelativeState.SOURCE_TRUTH

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = self.laid_out(RelativeState)

    def packed(self, k: int, state: Any, valid: bool, final: bool = False,
               acceleration: Any = UNKNOWN, covariance: Any = None) -> bytes:
        """Return the serialised message."""
        spread = NO_COVARIANCE if covariance is None else covariance.ravel().tolist()
        return self._layout.pack(*self.stamp(k), k, self.source, valid, final, *state.tolist(),
                                 *acceleration, *spread)

    def odd(self, k: int, message: RelativeState) -> str:
        """Return what is wrong with the source."""
        most = RelativeState.SOURCE_PREDICTION
        return '' if message.source <= most else f'source must be 0 to {most}, got {message.source}'


class Truth(_State):
    """The true state."""

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self.packed(k, value.state, bool(np.isfinite(value.state).all()),
                           bool(value.final), value.acceleration.tolist())

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message."""
        a = message.acceleration
        return self.signal(state=state_from_msg(message), acceleration=np.array((a.x, a.y, a.z)),
                           final=np.bool_(message.final))


class Measurement(_State):
    """A sensor's sample."""

    source = RelativeState.SOURCE_MEASUREMENT

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self.packed(k, value.state, bool(np.isfinite(value.state).all()))

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message."""
        return self.signal(state=state_from_msg(message))


class Estimate(_State):
    """A state that somebody believes in, with its covariance."""

    source = RelativeState.SOURCE_ESTIMATE

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self.packed(k, value.state, bool(value.valid), covariance=value.covariance)

    def decode(self, k: int, message: RelativeState) -> Any:
        """Return the value in a message; where nothing is estimated the covariance is NaN."""
        return self.signal(state=state_from_msg(message), valid=np.bool_(message.valid),
                           covariance=np.reshape(message.covariance, (6, 6)))


class Prediction(Estimate):
    """An estimate carried across the loop."""

    source = RelativeState.SOURCE_PREDICTION


class Score(Codec):
    """A prediction held against what came down later, as PredictionScore."""

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = self.laid_out(PredictionScore)

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self._layout.pack(
            *self.stamp(k), k, bool(value.valid), *value.error.tolist(), *value.sigma.tolist(),
            int(value.scored), *value.rms.tolist())

    def decode(self, k: int, message: PredictionScore) -> Any:
        """Return the value in a message."""
        p, v = message.position_error, message.velocity_error
        return self.signal(
            valid=np.bool_(message.valid), error=np.array((p.x, p.y, p.z, v.x, v.y, v.z)),
            sigma=np.array(message.sigma), scored=np.asarray(message.scored),
            rms=np.array(message.rms))


# -- commands ----------------------------------------------------------------------------------

class Stick(Codec):
    """
    Levels as `sensor_msgs/Joy`, by the axes and buttons of the stick's settings.

    A Joy has no step: its stamp is the step's instant. What a tape holds goes out as it is.
    """

    def __init__(self, signal: Signal, run: Run, stick: StickParams) -> None:
        super().__init__(signal, run)
        self._stick = stick

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        axes, buttons = value.raw or self._moved(value)
        return _stick_layout(len(axes), len(buttons)).pack(
            *divmod(k * self.run.step_ns, NS_PER_S), *axes, *buttons)

    def _moved(self, value: Any) -> tuple[list[float], list[int]]:
        """
        Return axes and buttons of a stick at these levels; of one that nobody holds if invalid.
        """
        axes, buttons = stick_axes([level / HIGHEST for level in value.command.tolist()],
                                   bool(value.valid), self._stick)
        if not value.valid and self._stick.deadman_button < 0:      # no button to say it with
            axes = [NAN] * len(axes)
        return axes, buttons

    def decode(self, k: int, message: Joy) -> Any:
        """Return the value in a message."""
        levels, valid = stick_levels(message.axes, message.buttons, self._stick)
        return self.signal(command=levels, valid=np.bool_(valid))

    def odd(self, k: int, message: Joy) -> str:
        """Return what is wrong with the numbers of axes and buttons."""
        return too_many(message)

    def fault(self, message: Joy) -> str:
        """Return why a stick is nobody's; nothing if somebody holds it."""
        return too_many(message) or stick_fault(message.axes, message.buttons, self._stick)


def too_many(message: Joy) -> str:
    """Say that a Joy has more axes or buttons than a stick can have; nothing if it has not."""
    for name, given in (('axes', message.axes), ('buttons', message.buttons)):
        if len(given) > MOST_AXES:
            return f'Joy must have {MOST_AXES} {name} at most'
    return ''


@lru_cache(maxsize=16)
def _stick_layout(axes: int, buttons: int) -> Layout:
    return Layout(Joy, {'header.frame_id': 'joy'}, {'axes': axes, 'buttons': buttons})


class _Command(Codec):
    """Levels as ThrustCommand."""

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = self.laid_out(ThrustCommand)

    def packed(self, k: int, sequence: int, kind: int, levels: Any, valid: bool, decided_by: int,
               pilot_weight: float, reason: int) -> bytes:
        """Return the serialised message."""
        return self._layout.pack(*self.stamp(k), k, sequence, kind, *levels.tolist(), valid,
                                 decided_by, pilot_weight, reason)

    def odd(self, k: int, message: ThrustCommand) -> str:
        """Return what is wrong with the fields that not every command is read for."""
        for name, most in (('sequence', k + 1), ('kind', codes.KIND_RESUME),
                           ('decided_by', codes.BY_GUARD), ('reason', codes.REASON_ABORT)):
            given = getattr(message, name)
            if given > most:
                return f'{name} must be 0 to {most}, got {given}'
        weight = message.pilot_weight
        if not 0.0 <= weight <= 1.0 and weight == weight:
            return f'pilot_weight must be 0 to 1 or NaN, got {weight:g}'
        return ''


class Automatic(_Command):
    """What the law commands."""

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        valid = bool(value.valid)
        return self.packed(k, 0, codes.KIND_THRUST, value.command, valid,
                           codes.BY_AUTO if valid else codes.BY_NOBODY, NAN,
                           codes.REASON_NONE if valid else codes.REASON_MISSING)

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(command=np.array(message.levels, dtype=np.int8),
                           valid=np.bool_(message.valid))


class Ground(_Command):
    """The command of the ground."""

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self.packed(k, k + 1, int(value.kind), value.command, True, int(value.decided_by),
                           float(value.pilot_weight), int(value.reason))

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(
            command=np.array(message.levels, dtype=np.int8), kind=np.uint8(message.kind),
            decided_by=np.uint8(message.decided_by), pilot_weight=message.pilot_weight,
            reason=np.uint8(message.reason))


class Thrusters(_Command):
    """What the guard commands."""

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self.packed(k, int(value.sequence), int(value.kind), value.command,
                           bool(value.valid), int(value.decided_by), NAN, int(value.reason))

    def decode(self, k: int, message: ThrustCommand) -> Any:
        """Return the value in a message."""
        return self.signal(
            command=np.array(message.levels, dtype=np.int8), kind=np.uint8(message.kind),
            valid=np.bool_(message.valid), reason=np.uint8(message.reason),
            sequence=message.sequence, decided_by=np.uint8(message.decided_by))


# -- the ends of the link ------------------------------------------------------------------------
