"""
What a mission shows on the console, as data; the page draws it and knows no mission.

A display says where numbers come from (`Ref`, `Number`: a part of a signal) and how they look:
bodies made of simple solids, surfaces, lines, views, a camera, instruments, a cross-section,
commands, the axes of the hand controller, charts. Whatever has to be computed from signals (a
distance to a wall, a path of free drift, words) is computed by the mission in Python and reaches
the page as a part of the signal `DERIVED`. `as_data` turns a display into plain JSON values.

Frame   points and directions are in the frame of the mission's positions, [m].
Errors  a value that cannot be drawn raises ValueError with the name of its field and the value.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from math import isfinite, tan
from numbers import Real
import re
from typing import Any

from rvd_dynamics.diagram.params import require

DERIVED = 'derived'             # signal of what the mission derives for the page
TRUTH = 'truth'                 # signal that a review alone has: never in what a live page gets

# Who says it; the page picks colour and line from this and from nothing else.
ROLES = (
    'measured',                 # came down the link, as old as its stamp says
    'predicted',                # for the instant at which a command sent now acts
    'truth',                    # of a review
    'target',                   # what is approached
    'pilot', 'automatic', 'sent',
    'limit',                    # a wall, a bound that must not be passed
    'guide',                    # a bound that is advised
    'goal',                     # where one wants to be
    'plain',                    # none of these
)
COLUMNS = ('measured', 'predicted', 'truth', 'plain')       # that an instrument may have, in order
AXES = 'xyz'
DIRECTIONS = ('+x', '-x', '+y', '-y', '+z', '-z')
MODES = ('manual', 'shared', 'auto')
MARKS = ('dot', 'ring', 'cross', 'square')
SENT_PARTS = ('value', 'kind', 'by', 'weight', 'reason')    # of the command that is sent
MOST_AXES = 6                   # of a hand controller: three to push, three to turn

# Keys that the page itself listens to, as KeyboardEvent.code says them.
PAGE_KEYS = frozenset({
    'KeyT', 'KeyP', 'KeyX', 'KeyN', 'KeyV', 'KeyL', 'KeyG', 'KeyM', 'Slash', 'Equal', 'Minus',
    'BracketLeft', 'BracketRight', 'Space', 'Escape', 'Enter', 'Tab'})

Point = tuple[float, float, float]
COLOUR = re.compile('#[0-9a-f]{6}')


# -- checks -------------------------------------------------------------------------------

def _is_real(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)


def _require_finite(name: str, value: Any) -> None:
    require(_is_real(value) and isfinite(value), name, 'be a finite number', value)


def _require_positive(name: str, value: Any) -> None:
    require(_is_real(value) and 0.0 < value < float('inf'), name, 'be positive and finite', value)


def _require_point(name: str, value: Any) -> None:
    require(isinstance(value, (tuple, list)) and len(value) == 3
            and all(_is_real(v) and isfinite(v) for v in value), name, 'be three finite numbers',
            value)


def _require_place(name: str, value: Any) -> None:
    if not isinstance(value, Ref):
        _require_point(name, value)


def _require_direction(name: str, value: Any) -> None:
    require(value in DIRECTIONS, name, f'be one of {", ".join(DIRECTIONS)}', repr(value))


def _require_plane(where: str, one: str, other: str) -> None:
    for direction in (one, other):
        _require_direction(f'{where}: directions', direction)
    require(one[1] != other[1], f'{where}: directions', 'be along two axes', f'{one} and {other}')


def _require_axes(name: str, value: str) -> None:
    require(0 < len(value) <= 3 and len(set(value)) == len(value) and set(value) <= set(AXES),
            name, 'be some of x, y, z', repr(value))


def _require_role(name: str, value: str) -> None:
    require(value in ROLES, name, f'be one of {", ".join(ROLES)}', repr(value))


def _require_colour(name: str, value: Any) -> None:
    require(isinstance(value, str) and COLOUR.fullmatch(value) is not None, name,
            'be like #c3cad2', repr(value))


def _require_digits(name: str, value: Any) -> None:
    require(isinstance(value, int) and 0 <= value <= 9, name, 'be 0 to 9', value)


def _require_known(name: str, wanted: tuple[str, ...], known: set[str]) -> None:
    for one in wanted:
        require(one in known, name, f'name bodies of the display ({", ".join(sorted(known))})',
                repr(one))


# -- where numbers come from --------------------------------------------------------------

@dataclass(frozen=True)
class Ref:
    """A whole part of a signal: a point, a row of points, a quaternion, or words."""

    signal: str
    part: str

    def __post_init__(self) -> None:
        require(bool(self.signal), 'ref.signal', 'not be empty', repr(self.signal))
        require(bool(self.part), 'ref.part', 'not be empty', repr(self.part))


@dataclass(frozen=True)
class Number:
    """One number of a signal: a component of a part, or the length of several components."""

    signal: str
    part: str
    index: tuple[int, ...] = (0,)
    factor: float = 1.0         # into the unit that is shown

    def __post_init__(self) -> None:
        require(bool(self.signal), 'number.signal', 'not be empty', repr(self.signal))
        require(bool(self.part), 'number.part', 'not be empty', repr(self.part))
        require(len(self.index) > 0 and all(isinstance(i, int) and i >= 0 for i in self.index),
                'number.index', 'name components from 0', self.index)
        _require_finite('number.factor', self.factor)


# -- bodies -------------------------------------------------------------------------------

@dataclass(frozen=True)
class Box:
    """A box, its edges along the axes of its body."""

    size_m: Point
    centre_m: Point = (0.0, 0.0, 0.0)
    colour: str = '#c3cad2'
    lit: bool = True            # false: as bright at night, for what is a mark and not a thing

    def __post_init__(self) -> None:
        _require_point('box.size_m', self.size_m)
        require(min(self.size_m) > 0.0, 'box.size_m', 'be positive', self.size_m)
        _require_point('box.centre_m', self.centre_m)
        _require_colour('box.colour', self.colour)


@dataclass(frozen=True)
class Cylinder:
    """A cylinder or a truncated cone about an axis of its body."""

    radius_m: float             # at its end in the direction of `along`
    length_m: float
    other_radius_m: float | None = None     # at the other end; None: the same
    centre_m: Point = (0.0, 0.0, 0.0)
    along: str = '+x'
    colour: str = '#c3cad2'
    lit: bool = True

    def __post_init__(self) -> None:
        for name in ('radius_m', 'other_radius_m'):
            radius = getattr(self, name)
            if radius is not None:
                require(_is_real(radius) and 0.0 <= radius < float('inf'), f'cylinder.{name}',
                        'not be negative', radius)
        require(_is_real(self.length_m) and 0.0 < self.length_m < float('inf'),
                'cylinder.length_m', 'be positive', self.length_m)
        _require_point('cylinder.centre_m', self.centre_m)
        _require_direction('cylinder.along', self.along)
        _require_colour('cylinder.colour', self.colour)


@dataclass(frozen=True)
class Torus:
    """A ring about an axis of its body."""

    radius_m: float
    thickness_m: float
    centre_m: Point = (0.0, 0.0, 0.0)
    along: str = '+x'
    colour: str = '#c3cad2'
    lit: bool = True

    def __post_init__(self) -> None:
        for name in ('radius_m', 'thickness_m'):
            _require_positive(f'torus.{name}', getattr(self, name))
        _require_point('torus.centre_m', self.centre_m)
        _require_direction('torus.along', self.along)
        _require_colour('torus.colour', self.colour)


Solid = Box | Cylinder | Torus


@dataclass(frozen=True)
class Body:
    """
    Something solid that stands where a signal says, or where it always stands.

    A body with role predicted or truth is drawn as a transparent figure with bright edges, any
    other as a solid one.
    """

    name: str
    role: str
    shape: tuple[Solid, ...]
    place: Ref | Point = (0.0, 0.0, 0.0)
    axes: str = AXES            # the axes that the numbers of `place` are along
    attitude: Ref | None = None             # quaternion x, y, z, w of the body's axes
    label: str = ''             # written above it

    def __post_init__(self) -> None:
        require(bool(self.name), 'body.name', 'not be empty', repr(self.name))
        where = f'body {self.name}'
        _require_role(f'{where}: role', self.role)
        require(len(self.shape) > 0 and all(isinstance(s, Solid) for s in self.shape),
                f'{where}: shape', 'be one or more solids', self.shape)
        _require_place(f'{where}: place', self.place)
        _require_axes(f'{where}: axes', self.axes)


# -- surfaces -----------------------------------------------------------------------------

@dataclass(frozen=True)
class Revolved:
    """
    A surface of revolution about an axis through `origin_m`, drawn as a net.

    `stations_m` (n) rise along the axis and `radii_m` (n) are the radii there. `rings` and
    `faint_rings` are (station, radius) pairs at which it is cut across.
    """

    name: str
    role: str
    stations_m: tuple[float, ...]
    radii_m: tuple[float, ...]
    origin_m: Point = (0.0, 0.0, 0.0)
    along: str = '+x'
    meridians: int = 4
    faint_meridians: int = 0
    rings: tuple[tuple[float, float], ...] = ()
    faint_rings: tuple[tuple[float, float], ...] = ()
    skin: bool = False          # with a skin that can be seen through
    axis: bool = False          # with its axis
    dashed: bool = False

    def __post_init__(self) -> None:
        require(bool(self.name), 'revolved.name', 'not be empty', repr(self.name))
        where = f'revolved {self.name}'
        _require_role(f'{where}: role', self.role)
        stations, radii = self.stations_m, self.radii_m
        require(len(stations) >= 2 and all(_is_real(s) for s in stations) and all(
            a < b for a, b in zip(stations, stations[1:])), f'{where}: stations_m',
            'be two or more rising numbers', stations)
        require(len(radii) == len(stations), f'{where}: radii_m', 'be as many as the stations',
                len(radii))
        require(all(_is_real(r) and 0.0 <= r < float('inf') for r in radii), f'{where}: radii_m',
                'be finite and not negative', radii)
        _require_point(f'{where}: origin_m', self.origin_m)
        _require_direction(f'{where}: along', self.along)
        for name in ('meridians', 'faint_meridians'):
            require(0 <= getattr(self, name) <= 96, f'{where}: {name}', 'be 0 to 96',
                    getattr(self, name))
        for name in ('rings', 'faint_rings'):
            for ring in getattr(self, name):
                require(len(ring) == 2 and all(_is_real(v) and isfinite(v) for v in ring),
                        f'{where}: {name}', 'be pairs of station and radius', ring)


def cone(name: str, role: str, from_m: float, to_m: float, from_radius_m: float,
         to_radius_m: float, **look: Any) -> Revolved:
    """Return a cone or a truncated cone: the surface of revolution with two stations."""
    return Revolved(name, role, (from_m, to_m), (from_radius_m, to_radius_m), **look)


@dataclass(frozen=True)
class Sphere:
    """A sphere that can be seen through, with circles on it: something to stay out of, say."""

    name: str
    role: str
    radius_m: float
    place: Ref | Point = (0.0, 0.0, 0.0)
    axes: str = AXES

    def __post_init__(self) -> None:
        require(bool(self.name), 'sphere.name', 'not be empty', repr(self.name))
        _require_role(f'sphere {self.name}: role', self.role)
        _require_positive(f'sphere {self.name}: radius_m', self.radius_m)
        _require_place(f'sphere {self.name}: place', self.place)
        _require_axes(f'sphere {self.name}: axes', self.axes)


Surface = Revolved | Sphere


# -- lines --------------------------------------------------------------------------------

@dataclass(frozen=True)
class Line:
    """A line through points that stand still, or through the rows of a part."""

    name: str
    role: str
    points: Ref | tuple[Point, ...]
    dashed: bool = False

    def __post_init__(self) -> None:
        require(bool(self.name), 'line.name', 'not be empty', repr(self.name))
        _require_role(f'line {self.name}: role', self.role)
        if not isinstance(self.points, Ref):
            require(len(self.points) >= 2, f'line {self.name}: points', 'be two or more',
                    len(self.points))
            for point in self.points:
                _require_point(f'line {self.name}: points', point)


@dataclass(frozen=True)
class Trail:
    """
    A line through where a signal has been, which the page remembers.

    With `since`, a place of another signal, it is the way ahead: it begins there and holds what
    was said for later instants than that signal's newest. `spread` is a radius [m] about the
    line, drawn as a tube; `since_spread` the one at its beginning.
    """

    name: str
    role: str
    place: Ref
    axes: str = AXES
    spread: Number | None = None
    since: Ref | None = None
    since_spread: Number | None = None

    def __post_init__(self) -> None:
        require(bool(self.name), 'trail.name', 'not be empty', repr(self.name))
        _require_role(f'trail {self.name}: role', self.role)
        _require_axes(f'trail {self.name}: axes', self.axes)


@dataclass(frozen=True)
class Label:
    """Words that stand at a point of the scene."""

    text: str
    at_m: Point

    def __post_init__(self) -> None:
        require(bool(self.text), 'label.text', 'not be empty', repr(self.text))
        _require_point(f'label {self.text}: at_m', self.at_m)


@dataclass(frozen=True)
class Legend:
    """What a kind of line in the scene means."""

    role: str
    words: str
    dashed: bool = False

    def __post_init__(self) -> None:
        _require_role('legend.role', self.role)


# -- sky, views, camera -------------------------------------------------------------------

@dataclass(frozen=True)
class Ball:
    """A celestial body: so far away that only its direction and its size in the sky count."""

    direction: Point
    half_angle_rad: float
    colour: str = '#e0ecff'

    def __post_init__(self) -> None:
        _require_point('ball.direction', self.direction)
        require(any(self.direction), 'ball.direction', 'not be zero', self.direction)
        require(_is_real(self.half_angle_rad) and 0.0 < self.half_angle_rad < 1.55,
                'ball.half_angle_rad', 'be between 0 and 1.55', self.half_angle_rad)
        _require_colour('ball.colour', self.colour)


@dataclass(frozen=True)
class Perspective:
    """
    A view that can be turned and zoomed.

    It looks at `centre_m`; with `follow` (names of bodies, the first whose place is known
    counts) at a point between centre and body, `share` of the way along the axis `along` and
    never nearer to the centre than `least_m` of the body's. The eye is `distance_m` away, and
    `growth` times as far again as that point is from the centre.
    """

    label: str
    centre_m: Point = (0.0, 0.0, 0.0)
    distance_m: float = 10.0
    follow: tuple[str, ...] = ()
    along: str = '+x'
    share: float = 0.5
    least_m: float = 1.0
    growth: float = 2.25
    start_m: float = 1.0        # where on the axis the body is before its place is known
    azimuth_rad: float = 2.35
    height_rad: float = 0.34

    def __post_init__(self) -> None:
        where = f'view {self.label}'
        require(bool(self.label), 'view.label', 'not be empty', repr(self.label))
        _require_point(f'{where}: centre_m', self.centre_m)
        _require_positive(f'{where}: distance_m', self.distance_m)
        _require_direction(f'{where}: along', self.along)
        for name in ('share', 'least_m', 'growth', 'start_m', 'azimuth_rad', 'height_rad'):
            _require_finite(f'{where}: {name}', getattr(self, name))


@dataclass(frozen=True)
class Flat:
    """A view without perspective; `stretch` exaggerates what is up in it."""

    label: str
    right: str
    up: str
    centre_m: Point = (0.0, 0.0, 0.0)
    span_m: float = 10.0        # from its left to its right edge
    stretch: float = 1.0

    def __post_init__(self) -> None:
        where = f'view {self.label}'
        require(bool(self.label), 'view.label', 'not be empty', repr(self.label))
        _require_plane(where, self.right, self.up)
        _require_point(f'{where}: centre_m', self.centre_m)
        _require_positive(f'{where}: span_m', self.span_m)
        _require_positive(f'{where}: stretch', self.stretch)


View = Perspective | Flat


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
        _require_role('camera mark: role', self.role)
        _require_place('camera mark: at', self.at)
        if self.radius_m is not None:
            _require_positive('camera mark: radius_m', self.radius_m)


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
    readings: tuple['Reading', ...]
    limit: float | None = None
    digits: int = 1

    def __post_init__(self) -> None:
        require(_is_real(self.low) and _is_real(self.high) and self.low < self.high, 'gauge.high',
                f'be above {self.low}', self.high)
        _require_positive('gauge.tick', self.tick)
        require((self.high - self.low) / self.tick <= 200, 'gauge.tick', 'make at most 200 ticks',
                self.tick)
        require(self.long_ticks >= 1, 'gauge.long_ticks', 'be 1 or more', self.long_ticks)
        _require_digits('gauge.digits', self.digits)


@dataclass(frozen=True)
class Camera:
    """
    What a camera sees that one of the bodies carries: what stands still, and no moving body.

    `carried_by` names bodies; the first whose place is known carries it. It looks along
    `look`; at the distance of `aim_m` half its picture's height is `half_height_m`, within the
    two tangents of half the field of view `half_field`. Before any place is known it is at
    `start_m`. Marks with role predicted are left out while the truth carries it.
    """

    title: str
    review_title: str           # of a review, where the truth may carry it
    carried_by: tuple[str, ...]
    start_m: Point
    aim_m: Point = (0.0, 0.0, 0.0)
    look: str = '+x'
    up: str = '+y'
    half_height_m: float = 1.35
    half_field: tuple[float, float] = (0.085, 0.9)
    marks: tuple[CameraMark, ...] = ()
    gauge: Gauge | None = None
    distance: tuple['Reading', ...] = ()    # written in a corner: the first that is known
    unit: str = 'm'
    digits: int = 1

    def __post_init__(self) -> None:
        require(len(self.carried_by) > 0, 'camera.carried_by', 'name a body', self.carried_by)
        for name in ('start_m', 'aim_m'):
            _require_point(f'camera.{name}', getattr(self, name))
        _require_plane('camera', self.look, self.up)
        _require_positive('camera.half_height_m', self.half_height_m)
        low, high = self.half_field
        require(0.0 < low <= high < tan(1.5), 'camera.half_field',
                'be two tangents, the smaller first', self.half_field)
        _require_digits('camera.digits', self.digits)


# -- numbers that are read ----------------------------------------------------------------

@dataclass(frozen=True)
class Reading:
    """A number in the column of its role; one at or beyond `low` or `high` is marked."""

    role: str
    value: Number
    low: float | Number | None = None
    high: float | Number | None = None

    def __post_init__(self) -> None:
        require(self.role in COLUMNS, 'reading.role', f'be one of {", ".join(COLUMNS)}',
                repr(self.role))
        for name in ('low', 'high'):
            limit = getattr(self, name)
            if limit is not None and not isinstance(limit, Number):
                _require_finite(f'reading.{name}', limit)


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
        _require_digits(f'instrument {self.label}: digits', self.digits)


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
        _require_role('ring.role', self.role)
        if not isinstance(self.radius_m, Number):
            _require_positive('ring.radius_m', self.radius_m)


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
        _require_role('spot.role', self.role)
        require(self.mark in MARKS, 'spot.mark', f'be one of {", ".join(MARKS)}', repr(self.mark))
        _require_positive('spot.ahead_s', self.ahead_s)


@dataclass(frozen=True)
class Section:
    """A cut across the scene: rings about its middle, and where things lie in its plane."""

    title: str
    alt: str                    # what it shows, for who cannot see it
    extent_m: float | Number    # what must fit between its middle and its edge
    right: str = '+z'
    up: str = '+y'
    note: Ref | None = None     # words beside the title
    rings: tuple[Ring, ...] = ()
    spots: tuple[Spot, ...] = ()
    foot: Readout | None = None

    def __post_init__(self) -> None:
        _require_plane('section', self.right, self.up)
        if not isinstance(self.extent_m, Number):
            _require_positive('section.extent_m', self.extent_m)


# -- commands and the hand controller -----------------------------------------------------

@dataclass(frozen=True)
class CommandAxis:
    """One component of a command: its name, and the value at which its bar is full."""

    name: str
    highest: float

    def __post_init__(self) -> None:
        require(bool(self.name), 'command axis: name', 'not be empty', repr(self.name))
        _require_positive(f'command axis {self.name}: highest', self.highest)


@dataclass(frozen=True)
class CommandRow:
    """Who says which command; its part holds a value for each axis."""

    label: str
    role: str
    value: Ref

    def __post_init__(self) -> None:
        _require_role(f'command row {self.label}: role', self.role)


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
        _require_digits('commands.digits', self.digits)


@dataclass(frozen=True)
class Axis:
    """
    One axis of the hand controller, as the person at it sees it.

    `keys` are pairs of KeyboardEvent codes: the one that deflects it towards + and the one
    towards -. `pad_axis` is the axis of a gamepad that it hangs on until somebody chooses.
    """

    name: str
    positive: str               # what a deflection towards + does, in words
    negative: str
    keys: tuple[tuple[str, str], ...]
    pad_axis: int = 0
    pad_inverted: bool = False

    def __post_init__(self) -> None:
        require(self.name.isidentifier(), 'axis.name', 'be a plain word', repr(self.name))
        for pair in self.keys:
            require(len(pair) == 2 and all(isinstance(code, str) and code for code in pair),
                    f'axis {self.name}: keys', 'be pairs of key codes', pair)
            for code in pair:
                require(code not in PAGE_KEYS and not code.startswith('Digit'),
                        f'axis {self.name}: keys', 'leave the page its own keys', code)
        require(0 <= self.pad_axis < 16, f'axis {self.name}: pad_axis', 'be 0 to 15',
                self.pad_axis)


@dataclass(frozen=True)
class Controller:
    """The hand controller; `key_deflections` are chosen by the keys 1, 2, ... in turn."""

    axes: tuple[Axis, ...]
    key_deflections: tuple[float, ...] = (1.0,)
    step_name: str = 'level'    # what the keys 1, 2, ... choose
    verb: str = 'push'          # what an axis does: "push forward"

    def __post_init__(self) -> None:
        require(0 < len(self.axes) <= MOST_AXES, 'controller.axes', f'be 1 to {MOST_AXES}',
                len(self.axes))
        names = [axis.name for axis in self.axes]
        require(len(set(names)) == len(names), 'controller.axes', 'have names of their own', names)
        codes = [code for axis in self.axes for pair in axis.keys for code in pair]
        twice = sorted({code for code in codes if codes.count(code) > 1})
        require(not twice, 'controller.axes', 'share no key', ', '.join(twice))
        require(0 < len(self.key_deflections) <= 9 and all(
            _is_real(v) and 0.0 < v <= 1.0 for v in self.key_deflections),
            'controller.key_deflections', 'be 1 to 9 numbers above 0 and up to 1',
            self.key_deflections)


# -- charts -------------------------------------------------------------------------------

@dataclass(frozen=True)
class Chart:
    """
    A strip of curves against the stamp of their signal, about zero.

    `spread`, times `spread_factor`, is drawn dashed on both sides of zero.
    """

    title: str                  # with its unit
    curves: tuple[Number, ...]
    spread: Number | None = None
    spread_factor: float = 2.0
    least: float = 1.0          # the scale reaches at least as far as this

    def __post_init__(self) -> None:
        require(0 < len(self.curves) <= 6, f'chart {self.title}: curves', 'be 1 to 6',
                len(self.curves))
        signals = {number.signal for number in (*self.curves, *filter(None, (self.spread,)))}
        require(len(signals) == 1, f'chart {self.title}: curves', 'be of one signal',
                ', '.join(sorted(signals)))
        _require_finite(f'chart {self.title}: spread_factor', self.spread_factor)
        _require_positive(f'chart {self.title}: least', self.least)

    @property
    def signal(self) -> str:
        """The signal whose stamps are the abscissa."""
        return self.curves[0].signal


@dataclass(frozen=True)
class Charts:
    """The panel of charts; `note` is words beside its title."""

    title: str
    strips: tuple[Chart, ...]
    note: Ref | None = None
    window_s: float = 60.0

    def __post_init__(self) -> None:
        require(len(self.strips) > 0, 'charts.strips', 'be one or more', self.strips)
        _require_positive('charts.window_s', self.window_s)


# -- the whole ----------------------------------------------------------------------------

@dataclass(frozen=True)
class Display:
    """
    All that the console shows of a mission.

    `measured` is the signal whose instants the first two clocks show, `predicted` that of the
    third; without a prediction there is no third. Panels that are None are not there.
    """

    commands: Commands
    measured: str
    predicted: str = ''
    bodies: tuple[Body, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    lines: tuple[Line | Trail, ...] = ()
    labels: tuple[Label, ...] = ()
    views: tuple[View, ...] = (Perspective('Orbit'),)
    stars: bool = True
    sky: tuple[Ball, ...] = ()
    camera: Camera | None = None
    instruments: Instruments | None = None
    section: Section | None = None
    controller: Controller | None = None
    charts: Charts | None = None
    legend: tuple[Legend, ...] = ()
    modes: tuple[str, ...] = MODES          # those that a pilot may choose
    abort: str = ''             # what the craft does under ABORT: "braking and backing away"
    goal: str = 'success'       # what a good flight is: "docking within the limits"
    hint: str = ''              # what a pilot is told before a flight

    def __post_init__(self) -> None:
        require(bool(self.measured), 'display.measured', 'name a signal', repr(self.measured))
        require(len(self.views) > 0, 'display.views', 'be one or more', self.views)
        require(set(self.modes) <= set(MODES), 'display.modes', f'be some of {", ".join(MODES)}',
                self.modes)
        names = [item.name for item in (*self.bodies, *self.surfaces, *self.lines)]
        twice = sorted({name for name in names if names.count(name) > 1})
        require(not twice, 'display: bodies, surfaces and lines', 'have names of their own',
                ', '.join(twice))
        bodies = {body.name for body in self.bodies}
        for view in self.views:
            if isinstance(view, Perspective):
                _require_known(f'view {view.label}: follow', view.follow, bodies)
        if self.camera is not None:
            _require_known('camera.carried_by', self.camera.carried_by, bodies)
        labels = [view.label for view in self.views]
        require(len(set(labels)) == len(labels), 'display.views', 'have labels of their own',
                labels)
        for part in walk(self):
            source = getattr(part, 'value', None) or getattr(part, 'place', None)
            if isinstance(source, Ref | Number) and source.signal == TRUTH:
                require(part.role == 'truth', f'{type(part).__name__.lower()}: role',
                        'be truth where the truth is shown', repr(part.role))

    def parts(self) -> dict[str, frozenset[str]]:
        """Return the signals that are shown, each with the names of its parts that are."""
        wanted: dict[str, set[str]] = {self.measured: set(),
                                       self.commands.sent: set(SENT_PARTS)}
        if self.predicted:
            wanted[self.predicted] = set()
        for part in walk(self):
            if isinstance(part, Ref | Number):
                wanted.setdefault(part.signal, set()).add(part.part)
        return {signal: frozenset(names) for signal, names in wanted.items()}

    def trails(self) -> tuple[Trail, ...]:
        """Return the lines that the page remembers."""
        return tuple(line for line in self.lines if isinstance(line, Trail))


def walk(value: Any) -> Iterator[Any]:
    """Yield a part of a display and all parts in it."""
    if is_dataclass(value):
        yield value
        for f in fields(value):
            yield from walk(getattr(value, f.name))
    elif isinstance(value, tuple):
        for inner in value:
            yield from walk(inner)


def as_data(value: Any, where: str = 'display') -> Any:
    """
    Return a display, or a part of one, as values that JSON knows.

    A part becomes an object with its fields and its kind, the name of its class in lower case.

    Raises
    ------
    ValueError
        If a value is none that JSON knows; the text names the field.
    """
    if is_dataclass(value):
        return {'kind': type(value).__name__.lower(),
                **{f.name: as_data(getattr(value, f.name), f'{where}.{f.name}')
                   for f in fields(value)}}
    if isinstance(value, (tuple, list)):
        return [as_data(inner, f'{where}[{i}]') for i, inner in enumerate(value)]
    if isinstance(value, Mapping):
        return {str(key): as_data(inner, f'{where}.{key}') for key, inner in value.items()}
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, int):
        return value
    if _is_real(value):
        require(isfinite(value), where, 'be finite', value)
        return float(value)
    raise ValueError(f'{where} must be a number, words or a part of a display, got {value!r}')
