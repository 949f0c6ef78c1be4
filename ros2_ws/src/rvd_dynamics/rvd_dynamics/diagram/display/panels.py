"""Panels of a display: instruments, cross-section, camera, commands, controller, charts."""

from dataclasses import dataclass
from math import tan

from rvd_dynamics.diagram.display.cockpit import Pixels
from rvd_dynamics.diagram.display.parts import (
    DIRECTIONS, is_real, MARKS, MODES, MOST_AXES, MOST_BUTTONS, Number, PAGE_KEYS, Point, Ref,
    require_digits, require_finite, require_place, require_plane, require_point, require_positive,
    require_role, TRUTH)
from rvd_dynamics.diagram.display.pilot import Digits
from rvd_dynamics.diagram.display.readings import Reading
from rvd_dynamics.diagram.params import require


# -- numbers that are read ----------------------------------------------------------------

@dataclass(frozen=True)
class Instrument:
    """A row of numbers of one kind; the limits shown are those of its last reading."""

    label: str
    unit: str
    readings: tuple[Reading, ...]
    digits: int = 2

    def __post_init__(self) -> None:
        require(bool(self.label), 'instrument.label', 'not be empty', repr(self.label))
        roles = [reading.role for reading in self.readings]
        require(len(roles) > 0 and len(set(roles)) == len(roles),
                f'instrument {self.label}: readings', 'be one or more, each of another role',
                roles)
        require_digits(f'instrument {self.label}: digits', self.digits)


@dataclass(frozen=True)
class Instruments:
    """The panel of instruments."""

    title: str
    rows: tuple[Instrument, ...]


@dataclass(frozen=True)
class Readout:
    """A line of words; its part is a pair: the words, and whether they are an alarm."""

    label: str
    words: Ref


@dataclass(frozen=True)
class Ring:
    """A circle about the middle of a cross-section."""

    role: str
    radius_m: float | Number
    dashed: bool = False
    written: bool = False       # its radius stands beside it

    def __post_init__(self) -> None:
        require_role('ring.role', self.role)
        if not isinstance(self.radius_m, Number):
            require_positive('ring.radius_m', self.radius_m)


@dataclass(frozen=True)
class Spot:
    """A mark in a cross-section, where a place lies in its plane."""

    role: str
    place: Ref
    mark: str = 'dot'
    spread: Number | None = None            # radius [m] of a ring, which is never too small to see
    rate: Ref | None = None     # a stroke shows where it goes within `ahead_s`
    ahead_s: float = 10.0
    origin: Ref | None = None   # a dashed line leads here from that place

    def __post_init__(self) -> None:
        require_role('spot.role', self.role)
        require(self.mark in MARKS, 'spot.mark', f'be one of {", ".join(MARKS)}', repr(self.mark))
        require_positive('spot.ahead_s', self.ahead_s)


@dataclass(frozen=True)
class Section:
    """A cut across the scene: rings about its middle, and where things lie in its plane."""

    title: str
    alt: str                    # what it shows, for who cannot see it
    extent_m: float | Number    # what must fit between its middle and its edge
    right: str = '+z'
    up: str = '+y'
    names: tuple[str, str] | None = None    # what the two are called, if not by the scene's axes
    note: Ref | None = None     # words beside the title
    rings: tuple[Ring, ...] = ()
    spots: tuple[Spot, ...] = ()
    foot: Readout | None = None

    def __post_init__(self) -> None:
        require_plane('section', self.right, self.up)
        if not isinstance(self.extent_m, Number):
            require_positive('section.extent_m', self.extent_m)


# -- the camera ---------------------------------------------------------------------------

@dataclass(frozen=True)
class CameraMark:
    """
    A mark over the picture of the camera.

    A ring of `radius_m` about a point, with the line of sight to it; or a square at a point.
    """

    role: str
    at: Ref | Point
    radius_m: float | None = None           # None: a square

    def __post_init__(self) -> None:
        require_role('camera mark: role', self.role)
        require_place('camera mark: at', self.at)
        if self.radius_m is not None:
            require_positive('camera mark: radius_m', self.radius_m)


@dataclass(frozen=True)
class Gauge:
    """
    A vertical scale with an arrow for each reading, hollow for a predicted one.

    Where the truth is known, it stands in the place of what was measured.
    """

    unit: str
    low: float
    high: float
    tick: float
    long_ticks: int             # every so many ticks one is long and has its number
    readings: tuple[Reading, ...]
    limit: float | None = None
    digits: int = 1

    def __post_init__(self) -> None:
        require(is_real(self.low) and is_real(self.high) and self.low < self.high, 'gauge.high',
                f'be above {self.low}', self.high)
        require_positive('gauge.tick', self.tick)
        require((self.high - self.low) / self.tick <= 200, 'gauge.tick', 'make at most 200 ticks',
                self.tick)
        require(self.long_ticks >= 1, 'gauge.long_ticks', 'be 1 or more', self.long_ticks)
        require_digits('gauge.digits', self.digits)


@dataclass(frozen=True)
class Camera:
    """
    What a camera sees that one of the bodies carries: what stands still, and no moving body.

    `carried_by` names bodies; the first whose place is known carries it, and before any is, it
    shows nothing. It looks along `look`. Its field of view is that of a lens with fixed steps,
    each twice as wide as the one before, between the two tangents of half the field of view
    `half_field`: the narrowest that shows `half_height_m` at the distance of `aim_m`. The page
    writes the angle and says when it changes. Marks with role predicted are left out while the
    truth carries it.
    """

    title: str
    review_title: str           # of a review, where the truth may carry it
    carried_by: tuple[str, ...]
    at_m: Point = (0.0, 0.0, 0.0)           # where it is on that body, in its axes
    turns: bool = False         # with the body's attitude; else `look` and `up` stand
    aim_m: Point = (0.0, 0.0, 0.0)
    look: str = '+x'
    up: str = '+y'
    half_height_m: float = 1.35
    half_field: tuple[float, float] = (0.085, 0.9)
    marks: tuple[CameraMark, ...] = ()
    pixels: Pixels | None = None            # what its image was found to hold
    gauge: Gauge | None = None
    distance: tuple[Reading, ...] = ()    # written in a corner: the first that is known
    unit: str = 'm'
    digits: int = 1
    numbers: Digits | None = None           # large, over its picture, instead of that distance

    def __post_init__(self) -> None:
        require(len(self.carried_by) > 0, 'camera.carried_by', 'name a body', self.carried_by)
        for name in ('at_m', 'aim_m'):
            require_point(f'camera.{name}', getattr(self, name))
        require_plane('camera', self.look, self.up)
        require_positive('camera.half_height_m', self.half_height_m)
        low, high = self.half_field
        require(0.0 < low <= high < tan(1.5), 'camera.half_field',
                'be two tangents, the smaller first', self.half_field)
        require_digits('camera.digits', self.digits)


# -- commands and the hand controller -----------------------------------------------------

@dataclass(frozen=True)
class CommandAxis:
    """One component of a command: its name, and the value at which its bar is full."""

    name: str
    highest: float

    def __post_init__(self) -> None:
        require(bool(self.name), 'command axis: name', 'not be empty', repr(self.name))
        require_positive(f'command axis {self.name}: highest', self.highest)


@dataclass(frozen=True)
class CommandRow:
    """Who says which command; its part holds a value for each axis."""

    label: str
    role: str
    value: Ref

    def __post_init__(self) -> None:
        require_role(f'command row {self.label}: role', self.role)


@dataclass(frozen=True)
class Commands:
    """
    How commands are shown, as bars and on the command ladder.

    `sent` is the signal of the command that leaves the ground; `rows` are those that led to it
    and itself. A value is written with `digits`, in `unit`.
    """

    title: str
    axes: tuple[CommandAxis, ...]
    sent: str
    rows: tuple[CommandRow, ...] = ()
    digits: int = 0
    unit: str = ''

    def __post_init__(self) -> None:
        require(len(self.axes) > 0, 'commands.axes', 'be one or more', self.axes)
        require(bool(self.sent), 'commands.sent', 'not be empty', repr(self.sent))
        require_digits('commands.digits', self.digits)


@dataclass(frozen=True)
class Axis:
    """
    One axis of the hand controller, as the person at it sees it.

    `keys` are pairs of KeyboardEvent codes: the one that deflects it towards + and the one
    towards -. `pad_axis` is the axis of a gamepad that it hangs on until somebody chooses; in its
    place a standard gamepad may have two buttons, `pad_pair`, of which triggers count by degrees.
    """

    name: str
    positive: str               # what a deflection towards + does, in words
    negative: str
    keys: tuple[tuple[str, str], ...]
    pad_axis: int = 0
    pad_inverted: bool = False
    pad_pair: tuple[int, int] | None = None     # buttons towards + and -
    along: str = ''             # direction of the scene into which + pushes; '' where it turns

    def __post_init__(self) -> None:
        require(self.along in ('', *DIRECTIONS), f'axis {self.name}: along',
                f'be empty or one of {", ".join(DIRECTIONS)}', repr(self.along))
        require(self.name.isidentifier(), 'axis.name', 'be a plain word', repr(self.name))
        for pair in self.keys:
            require(len(pair) == 2 and all(isinstance(code, str) and code for code in pair),
                    f'axis {self.name}: keys', 'be pairs of key codes', pair)
            for code in pair:
                require(code not in PAGE_KEYS and not code.startswith('Digit'),
                        f'axis {self.name}: keys', 'leave the page its own keys', code)
        require(0 <= self.pad_axis < 16, f'axis {self.name}: pad_axis', 'be 0 to 15',
                self.pad_axis)
        require(self.pad_pair is None or (len(self.pad_pair) == 2 and all(
            isinstance(b, int) and 0 <= b < 32 for b in self.pad_pair)),
            f'axis {self.name}: pad_pair', 'be two buttons, 0 to 31', self.pad_pair)


@dataclass(frozen=True)
class Button:
    """A button of the hand controller beside the dead-man: its key, its place on a standard pad."""

    name: str
    words: str                  # what it does while it is held
    key: str
    pad_button: int

    def __post_init__(self) -> None:
        require(self.name.isidentifier(), 'button.name', 'be a plain word', repr(self.name))
        require(bool(self.key) and self.key not in PAGE_KEYS and not self.key.startswith('Digit'),
                f'button {self.name}: key', 'be a key code that the page leaves free',
                repr(self.key))
        require(0 <= self.pad_button < 32, f'button {self.name}: pad_button', 'be 0 to 31',
                self.pad_button)


@dataclass(frozen=True)
class Hand:
    """One of several hand controllers: its Joy has these axes, the dead-man, these buttons."""

    topic: str
    axes: tuple[str, ...]       # by name, in the order of the Joy
    buttons: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        require(self.topic.startswith('/'), 'hand.topic', 'begin with a slash', repr(self.topic))
        require(len(self.axes) > 0, f'hand {self.topic}: axes', 'be one or more', self.axes)


@dataclass(frozen=True)
class Controller:
    """
    The hand controller; `key_deflections` are chosen by the keys 1, 2, ... in turn.

    With `hands` it stands for several, each with a Joy of its own; without, all is one Joy.
    """

    axes: tuple[Axis, ...]
    key_deflections: tuple[float, ...] = (1.0,)
    step_name: str = 'level'    # what the keys 1, 2, ... choose
    verb: str = 'push'          # what an axis does: "push forward"
    buttons: tuple[Button, ...] = ()
    hands: tuple[Hand, ...] = ()

    def __post_init__(self) -> None:
        require(0 < len(self.axes) <= MOST_AXES, 'controller.axes', f'be 1 to {MOST_AXES}',
                len(self.axes))
        names = [axis.name for axis in self.axes]
        require(len(set(names)) == len(names), 'controller.axes', 'have names of their own', names)
        codes = self.keys
        require(len(self.buttons) <= MOST_BUTTONS, 'controller.buttons',
                f'be {MOST_BUTTONS} at most', len(self.buttons))
        for hand in self.hands:
            for kind, known in (('axes', names), ('buttons', [b.name for b in self.buttons])):
                strange = set(getattr(hand, kind)) - set(known)
                require(not strange, f'hand {hand.topic}: {kind}', 'be those of the controller',
                        ', '.join(sorted(strange)))
        twice = sorted({code for code in codes if codes.count(code) > 1})
        require(not twice, 'controller.axes', 'share no key', ', '.join(twice))
        require(0 < len(self.key_deflections) <= 9 and all(
            is_real(v) and 0.0 < v <= 1.0 for v in self.key_deflections),
            'controller.key_deflections', 'be 1 to 9 numbers above 0 and up to 1',
            self.key_deflections)

    @property
    def keys(self) -> list[str]:
        """Key codes of the axes and the buttons."""
        codes = [code for axis in self.axes for pair in axis.keys for code in pair]
        return codes + [button.key for button in self.buttons]


# -- modes --------------------------------------------------------------------------------

@dataclass(frozen=True)
class Mode:
    """
    A mode of the mission as a button of the page.

    Modes without a key are gone through in turn with M; one with a key is chosen by that alone.
    """

    name: str                   # as /run/control knows it
    label: str                  # of the button
    key: str = ''
    words: str = ''             # what it does, for the list of keys

    def __post_init__(self) -> None:
        require(self.name.isidentifier(), 'mode.name', 'be a plain word', repr(self.name))
        require(bool(self.label), f'mode {self.name}: label', 'not be empty', repr(self.label))
        require(self.key not in PAGE_KEYS and not self.key.startswith('Digit'),
                f'mode {self.name}: key', 'be a key code that the page leaves free',
                repr(self.key))


PILOTED = tuple(Mode(name, name.capitalize()) for name in MODES)


# -- charts -------------------------------------------------------------------------------

@dataclass(frozen=True)
class Chart:
    """
    A strip of curves against the stamp of their signal, about zero if it is `centred`.

    `spread`, times `spread_factor`, is drawn as a band on both sides of zero; `levels` are dashed
    lines that stand. Curves of the truth may be among others, and are empty but in a review.
    """

    title: str                  # with its unit
    curves: tuple[Number, ...]
    spread: Number | None = None
    spread_factor: float = 2.0
    least: float = 1.0          # the scale reaches at least as far as this
    names: tuple[str, ...] = ()             # of the curves, written in their colours
    centred: bool = True        # else the scale holds what there is, and the levels
    levels: tuple[float, ...] = ()
    wide: bool = False          # takes a whole line where several stand side by side

    def __post_init__(self) -> None:
        require(0 < len(self.curves) <= 6, f'chart {self.title}: curves', 'be 1 to 6',
                len(self.curves))
        signals = {number.signal for number in (*self.curves, *filter(None, (self.spread,)))}
        require(len(signals - {TRUTH}) <= 1, f'chart {self.title}: curves',
                'be of one signal, and the truth', ', '.join(sorted(signals)))
        require(len(self.names) in (0, len(self.curves)), f'chart {self.title}: names',
                'be as many as the curves, or none', self.names)
        require_finite(f'chart {self.title}: spread_factor', self.spread_factor)
        require_positive(f'chart {self.title}: least', self.least)

    @property
    def signal(self) -> str:
        """The signal whose stamps are the abscissa: not the truth where there is another."""
        signals = [number.signal for number in (*self.curves, *filter(None, (self.spread,)))]
        return next((signal for signal in signals if signal != TRUTH), TRUTH)


@dataclass(frozen=True)
class Charts:
    """
    The panel of charts; `note` is words beside its title.

    `columns` of them stand side by side. `curve` and `band` say what a line and a band are.
    """

    title: str
    strips: tuple[Chart, ...]
    note: Ref | None = None
    window_s: float = 60.0
    columns: int = 1
    curve: str = ''
    band: str = ''

    def __post_init__(self) -> None:
        require(len(self.strips) > 0, 'charts.strips', 'be one or more', self.strips)
        require(self.columns in (1, 2, 3), 'charts.columns', 'be 1 to 3', self.columns)
        require_positive('charts.window_s', self.window_s)
