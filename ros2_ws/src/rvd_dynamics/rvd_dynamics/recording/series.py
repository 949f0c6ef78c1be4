"""
What a topic carried over a run, as arrays; a row per message.

There is one class for each message type, whatever the topic: `SERIES` lists them. `of` takes
decoded messages, of ROS or of a bag, which have the same fields.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.recording.messages import stamp_ns

LINK_DELAYS = ('play_out_delay', 'delay_p50', 'delay_p99', 'delay_max')
PART = re.compile(r'(\w+)(?:\[([\d,]+)\])?')        # of a layout: 'state[6]', 'final'
Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Series:
    """What all series have in common."""

    def __len__(self) -> int:
        return len(getattr(self, fields(self)[0].name))

    def without(self, names: Iterable[str]) -> 'Series':
        """Return the series with None for columns that nobody recorded."""
        mine = {f.name for f in fields(self)}
        return replace(self, **{name: None for name in names if name in mine})


@dataclass(frozen=True)
class States(Series):
    """RelativeState."""

    step: Ints                                  # (N,)   step it was emitted in
    t: Floats                                   # (N,)   [s] instant the state is valid for
    valid: Flags                                # (N,)
    state: Floats                               # (N, 6) [m, m/s], NaN when unknown
    accel: Floats                               # (N, 3) [m/s^2] truth only, else NaN
    covariance: Floats                          # (N, 6, 6), NaN when not estimated

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'States':
        """Return the series of messages."""
        covariance = _table(lambda m: m.covariance, messages, 36)
        covariance[np.isnan(covariance[:, 0])] = np.nan     # element 0 says that all is unknown
        return cls(
            step=_steps(messages), t=_stamps(messages),
            valid=_column(lambda m: m.valid, messages, bool),
            state=_table(lambda m: (*_xyz(m.position), *_xyz(m.velocity)), messages, 6),
            accel=_table(lambda m: _xyz(m.acceleration), messages, 3),
            covariance=covariance.reshape(-1, 6, 6))


@dataclass(frozen=True)
class Commands(Series):
    """
    ThrustCommand; numbers as in ThrustCommand.msg.

    Columns of an in-process history are None where nobody recorded them.
    """

    step: Ints                                  # (N,)
    t: Floats                                   # (N,) [s] instant from which it is meant to act
    levels: NDArray[np.int8]                    # (N, 3)
    valid: Flags                                # (N,)
    kind: Ints                                  # (N,)
    sequence: Ints                              # (N,)
    decided_by: Ints                            # (N,)
    pilot_weight: Floats                        # (N,) NaN when nothing was blended
    reason: Ints                                # (N,)

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'Commands':
        """Return the series of messages."""
        return cls(
            step=_steps(messages), t=_stamps(messages),
            levels=_table(lambda m: m.levels, messages, 3, np.int8),
            valid=_column(lambda m: m.valid, messages, bool),
            kind=_column(lambda m: m.kind, messages, np.int64),
            sequence=_column(lambda m: m.sequence, messages, np.int64),
            decided_by=_column(lambda m: m.decided_by, messages, np.int64),
            pilot_weight=_column(lambda m: m.pilot_weight, messages, np.float64),
            reason=_column(lambda m: m.reason, messages, np.int64))


@dataclass(frozen=True)
class Frames(Series):
    """LinkFrame; instants [s], NaN when they have not happened."""

    step: Ints                                  # (N,)
    sequence: Ints                              # (N,)
    empty: Flags                                # (N,) nothing was due
    expedited: Flags                            # (N,)
    sent: Floats                                # (N,)
    arrived: Floats                             # (N,)
    released: Floats                            # (N,)

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'Frames':
        """Return the series of messages."""
        return cls(
            step=_steps(messages), sequence=_column(lambda m: m.sequence, messages, np.int64),
            empty=_column(lambda m: m.empty, messages, bool),
            expedited=_column(lambda m: m.expedited, messages, bool),
            sent=_instants('sent', messages), arrived=_instants('arrived', messages),
            released=_instants('released', messages))


@dataclass(frozen=True)
class LinkHistory(Series):
    """LinkStatus: what one direction of the link counted."""

    step: Ints                                  # (N,)
    counts: dict[str, Ints]                     # name in LinkStatus.msg -> (N,)
    delays: dict[str, Floats]                   # name in LinkStatus.msg -> (N,) [s]

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'LinkHistory':
        """Return the series of messages."""
        return cls(
            step=_steps(messages),
            counts={n: _column(lambda m: getattr(m, n), messages, np.int64) for n in LINK_COUNTS},
            delays={n: _column(lambda m: getattr(m, n), messages, np.float64)
                    for n in LINK_DELAYS})

    @property
    def last(self) -> dict[str, float]:
        """The last counts and delays; empty if the link reported none."""
        if not len(self.step):
            return {}
        return ({name: int(column[-1]) for name, column in self.counts.items()}
                | {name: float(column[-1]) for name, column in self.delays.items()})


@dataclass(frozen=True)
class Scores(Series):
    """PredictionScore: predictions compared with what came down the link later."""

    step: Ints                                  # (N,)
    t: Floats                                   # (N,)   [s] instant the prediction was made for
    valid: Flags                                # (N,)
    error: Floats                               # (N, 6) [m, m/s] predicted minus received
    sigma: Floats                               # (N, 6) [m, m/s] what the prediction claimed
    scored: Ints                                # (N,)   predictions compared so far
    rms: Floats                                 # (N, 6) [m, m/s] so far

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'Scores':
        """Return the series of messages."""
        return cls(
            step=_steps(messages), t=_stamps(messages),
            valid=_column(lambda m: m.valid, messages, bool),
            error=_table(lambda m: (*_xyz(m.position_error), *_xyz(m.velocity_error)), messages,
                         6),
            sigma=_table(lambda m: m.sigma, messages, 6),
            scored=_column(lambda m: m.scored, messages, np.int64),
            rms=_table(lambda m: m.rms, messages, 6))


@dataclass(frozen=True)
class Sticks(Series):
    """Joy."""

    t: Floats                                   # (N,) [s]
    axes: Floats                                # (N, most axes), NaN where a message had fewer
    buttons: Ints                               # (N, most buttons), 0 likewise

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'Sticks':
        """Return the series of messages."""
        axes = np.full((len(messages), max((len(m.axes) for m in messages), default=0)), np.nan)
        buttons = np.zeros((len(messages), max((len(m.buttons) for m in messages), default=0)),
                           int)
        for i, m in enumerate(messages):
            axes[i, :len(m.axes)] = m.axes
            buttons[i, :len(m.buttons)] = m.buttons
        return cls(t=_stamps(messages), axes=axes, buttons=buttons)


@dataclass(frozen=True)
class Table(Series):
    """Values: the parts of a signal that has no message of its own; `table['state']`."""

    step: Ints                                  # (N,)
    t: Floats                                   # (N,) [s] instant that the values are valid for
    parts: dict[str, Floats] = field(default_factory=dict)      # name -> (N, *shape); flags 0, 1

    @classmethod
    def of(cls, messages: Sequence[Any]) -> 'Table':
        """Return the series of messages; ValueError if they are not of one layout."""
        parts: dict[str, Floats] = {}
        if messages:
            layout = messages[0].layout
            shapes = {name: tuple(int(n) for n in shape.split(',') if n)
                      for name, shape in PART.findall(layout)}
            width = sum(int(np.prod(shape, dtype=int)) for shape in shapes.values())
            for m in messages:
                if m.layout != layout or len(m.values) != width:
                    raise BadInput(f'step {m.step}: {len(m.values)} values of layout '
                                   f'{m.layout!r} where {width} of {layout!r} began')
            numbers, at = _table(lambda m: m.values, messages, width), 0
            for name, shape in shapes.items():
                size = int(np.prod(shape, dtype=int))
                parts[name] = numbers[:, at:at + size].reshape(len(messages), *shape)
                at += size
        return cls(step=_steps(messages), t=_stamps(messages), parts=parts)

    def __getitem__(self, name: str) -> Floats:
        if name not in self.parts:
            raise LookupError(f'no part {name!r} was recorded; there are: '
                              f'{", ".join(self.parts) or "none"}')
        return self.parts[name]

    def without(self, names: Iterable[str]) -> 'Table':
        """Return the table without some of its parts."""
        gone = set(names)
        return replace(self, parts={n: p for n, p in self.parts.items() if n not in gone})


SERIES: dict[str, type] = {f'rvd_interfaces/msg/{name}': kind for name, kind in {
    'RelativeState': States, 'ThrustCommand': Commands, 'LinkFrame': Frames,
    'LinkStatus': LinkHistory, 'PredictionScore': Scores, 'Values': Table}.items()}
SERIES['sensor_msgs/msg/Joy'] = Sticks


def _column(of: Callable, messages: Sequence[Any], dtype: Any) -> NDArray:
    return np.array([of(m) for m in messages], dtype=dtype)


def _table(of: Callable, messages: Sequence[Any], width: int, dtype: Any = np.float64) -> NDArray:
    return np.array([of(m) for m in messages], dtype=dtype).reshape(len(messages), width)


def _instants(name: str, messages: Sequence[Any]) -> Floats:
    ns = _column(lambda m: getattr(m, name), messages, np.float64)
    return np.where(ns < 0, np.nan, ns / NS_PER_S)


def _xyz(vector: Any) -> tuple[float, float, float]:
    return vector.x, vector.y, vector.z


def _stamps(messages: Sequence[Any]) -> Floats:
    return _column(lambda m: stamp_ns(m.header.stamp) / NS_PER_S, messages, np.float64)


def _steps(messages: Sequence[Any]) -> Ints:
    return _column(lambda m: m.step, messages, np.int64)
