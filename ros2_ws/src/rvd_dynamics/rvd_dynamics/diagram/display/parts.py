"""Where the numbers of a display come from, and the checks that its parts share."""

from dataclasses import dataclass
from math import isfinite
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
MOST_BUTTONS = 7                # beside the dead-man
MOST_AXES = 6                   # of a hand controller: three to push, three to turn

# Keys that the page itself listens to, as KeyboardEvent.code says them.
PAGE_KEYS = frozenset({
    'KeyT', 'KeyP', 'KeyX', 'KeyN', 'KeyV', 'KeyL', 'KeyG', 'KeyM', 'Slash', 'Equal', 'Minus',
    'KeyK', 'KeyO', 'BracketLeft', 'BracketRight', 'Space', 'Escape', 'Enter', 'Tab'})

Point = tuple[float, float, float]
COLOUR = re.compile('#[0-9a-f]{6}')


# -- checks -------------------------------------------------------------------------------

def is_real(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)


def require_finite(name: str, value: Any) -> None:
    require(is_real(value) and isfinite(value), name, 'be a finite number', value)


def require_positive(name: str, value: Any) -> None:
    require(is_real(value) and 0.0 < value < float('inf'), name, 'be positive and finite', value)


def require_point(name: str, value: Any) -> None:
    require(isinstance(value, (tuple, list)) and len(value) == 3
            and all(is_real(v) and isfinite(v) for v in value), name, 'be three finite numbers',
            value)


def require_place(name: str, value: Any) -> None:
    if not isinstance(value, Ref):
        require_point(name, value)


def require_direction(name: str, value: Any) -> None:
    require(value in DIRECTIONS, name, f'be one of {", ".join(DIRECTIONS)}', repr(value))


def require_plane(where: str, one: str, other: str) -> None:
    for direction in (one, other):
        require_direction(f'{where}: directions', direction)
    require(one[1] != other[1], f'{where}: directions', 'be along two axes', f'{one} and {other}')


def require_axes(name: str, value: str) -> None:
    require(0 < len(value) <= 3 and len(set(value)) == len(value) and set(value) <= set(AXES),
            name, 'be some of x, y, z', repr(value))


def require_role(name: str, value: str) -> None:
    require(value in ROLES, name, f'be one of {", ".join(ROLES)}', repr(value))


def require_colour(name: str, value: Any) -> None:
    require(isinstance(value, str) and COLOUR.fullmatch(value) is not None, name,
            'be like #c3cad2', repr(value))


def require_digits(name: str, value: Any) -> None:
    require(isinstance(value, int) and 0 <= value <= 9, name, 'be 0 to 9', value)


def require_known(name: str, wanted: tuple[str, ...], known: set[str]) -> None:
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
    """
    One number of a signal: a component of a part, or the length of several components.

    A length has a sign where `past` names a component of the part: it is negative where that one
    is positive, past a plane, say.
    """

    signal: str
    part: str
    index: tuple[int, ...] = (0,)
    factor: float = 1.0         # into the unit that is shown
    past: int | None = None

    def __post_init__(self) -> None:
        require(bool(self.signal), 'number.signal', 'not be empty', repr(self.signal))
        require(bool(self.part), 'number.part', 'not be empty', repr(self.part))
        require(len(self.index) > 0 and all(isinstance(i, int) and i >= 0 for i in self.index),
                'number.index', 'name components from 0', self.index)
        require_finite('number.factor', self.factor)
        require(self.past is None or isinstance(self.past, int) and self.past >= 0,
                'number.past', 'name a component from 0', self.past)
