"""Panels for a craft with six axes: attitude indicator, lamps, image; and forms for settings."""

from dataclasses import dataclass

from rvd_dynamics.diagram.display.parts import (
    is_real, Number, Ref, require_digits, require_positive, require_role)
from rvd_dynamics.diagram.params import require


@dataclass(frozen=True)
class Needles:
    """
    Three angles as cross needles: roll turns the ring's mark, pitch and yaw move the needles.

    `rates`, if given, are what the small arrows at the edge show, of the same three axes.
    """

    role: str
    angles: tuple[Number, Number, Number]       # roll, pitch, yaw, in the indicator's unit
    rates: tuple[Number, Number, Number] | None = None      # in that unit per second

    def __post_init__(self) -> None:
        require_role('needles.role', self.role)
        for name in ('angles', 'rates'):
            of = getattr(self, name)
            require(of is None or len(of) == 3, f'needles.{name}', 'be three', of)


@dataclass(frozen=True)
class Attitude:
    """
    The attitude indicator: how far the craft is turned from where it should be.

    The ring is full at the first of `scales` that holds all angles of its first needles, and of
    `rate_scales` likewise; both are written beside it. A dashed ring stands at `limit`.
    """

    title: str
    alt: str                    # what it shows, for who cannot see it
    needles: tuple[Needles, ...]
    scales: tuple[float, ...] = (1.0, 5.0, 20.0, 60.0, 180.0)
    rate_scales: tuple[float, ...] = (0.1, 1.0, 10.0)
    limit: float | None = None
    unit: str = 'deg'
    digits: int = 2

    def __post_init__(self) -> None:
        require(len(self.needles) > 0, 'attitude.needles', 'be one or more', self.needles)
        for name in ('scales', 'rate_scales'):
            of = getattr(self, name)
            require(len(of) > 0 and all(is_real(v) and v > 0.0 for v in of)
                    and all(a < b for a, b in zip(of, of[1:])), f'attitude.{name}',
                    'be rising numbers above 0', of)
        if self.limit is not None:
            require_positive('attitude.limit', self.limit)
        require_digits('attitude.digits', self.digits)


@dataclass(frozen=True)
class LampGroup:
    """Lamps in a row; neighbours of one label share it."""

    name: str
    words: str                  # what the group is for
    labels: tuple[str, ...]     # one for each lamp

    def __post_init__(self) -> None:
        require(bool(self.name), 'lamp group: name', 'not be empty', repr(self.name))
        require(len(self.labels) > 0, f'lamp group {self.name}: labels', 'be one or more',
                self.labels)


@dataclass(frozen=True)
class Lamps:
    """
    Things that are on or off, in groups, in the order of the numbers of both parts.

    `on` says which are on now; `glow`, from 0 to 1, how much of the last second each was on, so
    that what is short can be seen. `counts` has a number for each group: how often one of it came
    on so far.
    """

    title: str
    alt: str
    groups: tuple[LampGroup, ...]
    on: Ref
    glow: Ref
    counts: Ref | None = None
    note: Ref | None = None     # words beside the title
    role: str = 'sent'

    def __post_init__(self) -> None:
        require(len(self.groups) > 0, 'lamps.groups', 'be one or more', self.groups)
        require_role('lamps.role', self.role)


@dataclass(frozen=True)
class Pixels:
    """
    Points of the image of a camera, over what is rendered of its view.

    `points` is a flat part, u and v [px] of each, unknown where it is not seen, from the upper left
    corner of a square image; `used` has for each 0 or 1: whether what is worked out uses it.
    """

    points: Ref
    used: Ref
    width_px: float
    half_view: float            # tangent of half the field of view
    role: str = 'measured'

    def __post_init__(self) -> None:
        require_role('pixels.role', self.role)
        require_positive('pixels.width_px', self.width_px)
        require_positive('pixels.half_view', self.half_view)


@dataclass(frozen=True)
class Setting:
    """One field of a form: a key of a section of the scenario, and what it is now."""

    section: str                # '/**' or a node
    key: str                    # dotted
    label: str
    value: str                  # as it would be written in a scenario
    unit: str = ''
    choices: tuple[str, ...] = ()
    hint: str = ''

    def __post_init__(self) -> None:
        for name in ('section', 'key', 'label'):
            require(bool(getattr(self, name)), f'setting.{name}', 'not be empty',
                    repr(getattr(self, name)))


@dataclass(frozen=True)
class Form:
    """Settings that may be changed before a run, together under a title."""

    title: str
    fields: tuple[Setting, ...]

    def __post_init__(self) -> None:
        require(bool(self.title), 'form.title', 'not be empty', repr(self.title))
        require(len(self.fields) > 0, f'form {self.title}: fields', 'be one or more', self.fields)
