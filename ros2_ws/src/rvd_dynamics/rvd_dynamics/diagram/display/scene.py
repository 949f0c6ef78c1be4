"""Parts of a display that stand in its scene: bodies, surfaces, lines, sky, views."""

from dataclasses import dataclass
from math import isfinite
from typing import Any

from rvd_dynamics.diagram.display.parts import (
    AXES, is_real, Number, Point, Ref, require_axes, require_colour, require_direction,
    require_finite, require_place, require_plane, require_point, require_positive, require_role)
from rvd_dynamics.diagram.params import require


# -- bodies -------------------------------------------------------------------------------

@dataclass(frozen=True)
class Box:
    """A box, its edges along the axes of its body."""

    size_m: Point
    centre_m: Point = (0.0, 0.0, 0.0)
    colour: str = '#c3cad2'
    lit: bool = True            # false: as bright at night, for what is a mark and not a thing

    def __post_init__(self) -> None:
        require_point('box.size_m', self.size_m)
        require(min(self.size_m) > 0.0, 'box.size_m', 'be positive', self.size_m)
        require_point('box.centre_m', self.centre_m)
        require_colour('box.colour', self.colour)


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
                require(is_real(radius) and 0.0 <= radius < float('inf'), f'cylinder.{name}',
                        'not be negative', radius)
        require(is_real(self.length_m) and 0.0 < self.length_m < float('inf'),
                'cylinder.length_m', 'be positive', self.length_m)
        require_point('cylinder.centre_m', self.centre_m)
        require_direction('cylinder.along', self.along)
        require_colour('cylinder.colour', self.colour)


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
            require_positive(f'torus.{name}', getattr(self, name))
        require_point('torus.centre_m', self.centre_m)
        require_direction('torus.along', self.along)
        require_colour('torus.colour', self.colour)


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
        require_role(f'{where}: role', self.role)
        require(len(self.shape) > 0 and all(isinstance(s, Solid) for s in self.shape),
                f'{where}: shape', 'be one or more solids', self.shape)
        require_place(f'{where}: place', self.place)
        require_axes(f'{where}: axes', self.axes)


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
        require_role(f'{where}: role', self.role)
        stations, radii = self.stations_m, self.radii_m
        require(len(stations) >= 2 and all(is_real(s) for s in stations) and all(
            a < b for a, b in zip(stations, stations[1:])), f'{where}: stations_m',
            'be two or more rising numbers', stations)
        require(len(radii) == len(stations), f'{where}: radii_m', 'be as many as the stations',
                len(radii))
        require(all(is_real(r) and 0.0 <= r < float('inf') for r in radii), f'{where}: radii_m',
                'be finite and not negative', radii)
        require_point(f'{where}: origin_m', self.origin_m)
        require_direction(f'{where}: along', self.along)
        for name in ('meridians', 'faint_meridians'):
            require(0 <= getattr(self, name) <= 96, f'{where}: {name}', 'be 0 to 96',
                    getattr(self, name))
        for name in ('rings', 'faint_rings'):
            for ring in getattr(self, name):
                require(len(ring) == 2 and all(is_real(v) and isfinite(v) for v in ring),
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
        require_role(f'sphere {self.name}: role', self.role)
        require_positive(f'sphere {self.name}: radius_m', self.radius_m)
        require_place(f'sphere {self.name}: place', self.place)
        require_axes(f'sphere {self.name}: axes', self.axes)


Surface = Revolved | Sphere


@dataclass(frozen=True)
class Spheres:
    """Spheres that move: their places are the first three numbers of the rows of a part."""

    name: str
    role: str
    rows: Ref
    radii_m: tuple[float, ...]

    def __post_init__(self) -> None:
        require(bool(self.name), 'spheres.name', 'not be empty', repr(self.name))
        require_role(f'spheres {self.name}: role', self.role)
        for radius in self.radii_m:
            require_positive(f'spheres {self.name}: radii_m', radius)


@dataclass(frozen=True)
class Field:
    """What markers draw of a field: spheres that stand still, spheres that move, the craft."""

    still: tuple[Sphere, ...]
    moving: tuple[Spheres, ...]
    craft_radius_m: float
    corridor: bool = False      # with the corridor and the control boundary of an approach

    def __post_init__(self) -> None:
        require_positive('field.craft_radius_m', self.craft_radius_m)


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
        require_role(f'line {self.name}: role', self.role)
        if not isinstance(self.points, Ref):
            require(len(self.points) >= 2, f'line {self.name}: points', 'be two or more',
                    len(self.points))
            for point in self.points:
                require_point(f'line {self.name}: points', point)


@dataclass(frozen=True)
class Trail:
    """
    A line through where a signal has been, which the page remembers.

    With `since`, a place of another signal, it is the way ahead: it begins there and holds what
    was said for later instants than that signal's newest. `spread` is a radius [m] about the
    line, drawn as a tube; `since_spread` the one at its beginning. Where `anew` is known, rows of
    points, they are the way ahead in place of what was said before: other commands act now.
    """

    name: str
    role: str
    place: Ref
    axes: str = AXES
    spread: Number | None = None
    since: Ref | None = None
    since_spread: Number | None = None
    anew: Ref | None = None

    def __post_init__(self) -> None:
        require(bool(self.name), 'trail.name', 'not be empty', repr(self.name))
        require_role(f'trail {self.name}: role', self.role)
        require_axes(f'trail {self.name}: axes', self.axes)


@dataclass(frozen=True)
class Label:
    """Words that stand at a point of the scene."""

    text: str
    at_m: Point

    def __post_init__(self) -> None:
        require(bool(self.text), 'label.text', 'not be empty', repr(self.text))
        require_point(f'label {self.text}: at_m', self.at_m)


@dataclass(frozen=True)
class Legend:
    """What a kind of line in the scene means."""

    role: str
    words: str
    dashed: bool = False

    def __post_init__(self) -> None:
        require_role('legend.role', self.role)


# -- sky and views ------------------------------------------------------------------------

@dataclass(frozen=True)
class Ball:
    """A celestial body: so far away that only its direction and its size in the sky count."""

    direction: Point
    half_angle_rad: float
    colour: str = '#e0ecff'

    def __post_init__(self) -> None:
        require_point('ball.direction', self.direction)
        require(any(self.direction), 'ball.direction', 'not be zero', self.direction)
        require(is_real(self.half_angle_rad) and 0.0 < self.half_angle_rad < 1.55,
                'ball.half_angle_rad', 'be between 0 and 1.55', self.half_angle_rad)
        require_colour('ball.colour', self.colour)


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
        require_point(f'{where}: centre_m', self.centre_m)
        require_positive(f'{where}: distance_m', self.distance_m)
        require_direction(f'{where}: along', self.along)
        for name in ('share', 'least_m', 'growth', 'start_m', 'azimuth_rad', 'height_rad'):
            require_finite(f'{where}: {name}', getattr(self, name))


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
        require_plane(where, self.right, self.up)
        require_point(f'{where}: centre_m', self.centre_m)
        require_positive(f'{where}: span_m', self.span_m)
        require_positive(f'{where}: stretch', self.stretch)


View = Perspective | Flat
