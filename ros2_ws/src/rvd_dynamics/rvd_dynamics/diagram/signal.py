"""
Signals: the named quantities that flow between blocks.

A signal's name is its topic. Its value is a named tuple of arrays, one for each part, with the
batch axes of the run in front; in a graph the batch is `()` and a codec turns a value into a
message and back. The message type and the codec are named as text, so that a diagram can be
read, checked and flown in one process where there is no ROS.
"""

from collections import namedtuple
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from rvd_dynamics.bad_input import BadInput

INITIAL = {'f': np.nan, 'i': 0, 'u': 0, 'b': False}     # by kind of dtype: nothing is known yet
FITS = {'f': 'fiub', 'i': 'iub', 'u': 'iub', 'b': 'b'}  # kinds of numbers that a part takes
VALUES = 'rvd_interfaces/msg/Values'                    # carries any signal, part after part


@dataclass(frozen=True)
class Part:
    """
    One part of a signal.

    Attributes
    ----------
    name : str
        Attribute of the value.
    shape : tuple of int
        Shape behind the batch axes.
    unit : str
        Units, comma-separated where the components differ.
    dtype : str
        NumPy type: 'f8', 'i1', 'u1', 'i8' or '?'.
    initial : float
        Value before the first firing of the writer, and of a message that never came; unknown
        (NaN), zero or false unless given.
    optional : bool
        Computed only where a block or a recording asks for it; None elsewhere.
    low, high : float
        [unit] Between these every number lies; see `diagram.limits` for what holds where they are
        not given.
    codes : tuple of int
        The only values there are, of a part that is a code.
    counts : bool
        It rises by one per step at most, from 0 or below: never above step + 1.
    spread : bool
        A covariance (..., n, n): symmetric and positive semi-definite; its first element is NaN
        where nothing is estimated.
    """

    name: str
    shape: tuple = ()
    unit: str = ''
    dtype: str = 'f8'
    initial: float | None = None
    optional: bool = False
    low: float | None = None
    high: float | None = None
    codes: tuple = ()
    counts: bool = False
    spread: bool = False

    def filled(self, batch: tuple) -> np.ndarray:
        """Return the initial value for a batch."""
        kind = np.dtype(self.dtype)
        start = INITIAL[kind.kind] if self.initial is None else self.initial
        return np.full((*batch, *self.shape), start, dtype=kind)


@dataclass(frozen=True)
class Signal:
    """
    A named quantity that flows.

    Attributes
    ----------
    name : str
        Topic, beginning with a slash.
    parts : tuple of Part
        Layout of a value.
    message : str
        Message type, 'package/msg/Type'.
    codec : str
        'module:Class' with `encode` and `decode`; see `diagram.ros.codecs`.
    ahead : int
        Steps by which the instant that the content is valid for lies ahead of the step in which
        it is emitted; negative for what is known late. Instants before the start count as 0.
    truth : bool
        The true state of the world, which only the world and the watchers may read.
    still : bool
        It never changes, and no block reads it: a graph publishes it once, for readers that come
        late too.
    """

    name: str
    parts: tuple[Part, ...]
    message: str = VALUES
    codec: str = 'rvd_dynamics.diagram.ros.codecs:Parts'
    ahead: int = 0
    truth: bool = False
    still: bool = False

    def __post_init__(self) -> None:
        if not self.name.startswith('/'):
            raise BadInput(f'signal {self.name!r}: the name is a topic and begins with a slash')
        names = [part.name for part in self.parts]
        if len(set(names)) != len(names):
            raise BadInput(f'signal {self.name}: two parts have one name: {", ".join(names)}')
        optional = [part.optional for part in self.parts]
        if optional != sorted(optional):
            raise BadInput(f'signal {self.name}: optional parts come last: {", ".join(names)}')

    @cached_property
    def type(self) -> type:
        """The named tuple that a value of this signal is."""
        title = ''.join(word.title() for word in self.name.replace('_', '/').split('/'))
        return namedtuple(title, [part.name for part in self.parts],
                          defaults=[None for part in self.parts if part.optional])

    def __call__(self, **values: Any) -> tuple:
        """Return a value; optional parts may be left out."""
        return self.type(**values)

    def initial(self, batch: tuple = ()) -> tuple:
        """
        Return what readers get before the writer has fired, and for a message that is missing.
        """
        return self.type(*(None if part.optional else part.filled(batch) for part in self.parts))

    def shifted(self, ahead: int) -> 'Signal':
        """Return this signal with another `ahead`."""
        return replace(self, ahead=ahead)

    def complaint(self, value: Any, batch: tuple) -> str:
        """
        Say in a few words what is wrong with the form of a value; nothing when it is right.

        A part may leave out batch axes that are the same in all rows (a tape, for instance).
        """
        if not isinstance(value, tuple) or not hasattr(value, '_fields') \
                or value._fields != self.type._fields:
            return f'must be a value of {self.name}, got {type(value).__name__}'
        for part in self.parts:
            given = getattr(value, part.name)
            if part.optional and (given is None or part.dtype == 'O'):
                continue
            shape, wanted = np.shape(given), (*batch, *part.shape)
            if shape != wanted and shape != part.shape:
                return f'{part.name} must have shape {wanted}, got {shape}'
            kind = np.asarray(given).dtype
            if kind.kind not in FITS[np.dtype(part.dtype).kind]:
                return f'{part.name} must be {np.dtype(part.dtype)}, got {kind}'
        return ''
