"""
Settings: a frozen dataclass beside each algorithm is the one place a parameter exists.

`param` gives a field its default, its meaning and its bounds; scenarios, campaigns, ROS and
docs/parameters.md read them from there. `@settings` makes the class and refuses every value out
of bounds, however the object is made. Keys carry their unit as a suffix (`step_s`,
`half_angle_deg`).
"""

from dataclasses import dataclass, Field, field, fields, is_dataclass, make_dataclass
from functools import cached_property, lru_cache
from math import inf, isfinite, nextafter
from numbers import Number
import sys
from typing import Any, Callable, Iterable, Iterator

from rvd_dynamics.bad_input import BadInput

if sys.version_info >= (3, 11):
    from typing import dataclass_transform
else:
    def dataclass_transform(**_: Any) -> Callable:
        """Tell type checkers nothing: Python 3.10 has no word for it."""
        return lambda decorator: decorator

LARGEST = sys.float_info.max


class Impossible(BadInput):
    """A setting that cannot be; the text is one line that names key and value."""

    def __init__(self, key: str, meaning: str, value: Any) -> None:
        super().__init__(key, meaning, value)       # all three, so that it survives pickling
        self.key, self.meaning, self.value = key, meaning, value

    def __str__(self) -> str:
        return f'{self.key} must {self.meaning}, got {self.value}'

    def under(self, prefix: str) -> 'Impossible':
        """Return the same refusal with the dotted key of the setting."""
        if self.key.startswith(prefix):             # a class that says its own place itself
            return self
        return Impossible(prefix + self.key, self.meaning, self.value)


def require(condition: bool, key: str, meaning: str, value: Any) -> None:
    """Refuse an impossible value by key and value (`condition` is false also for NaN)."""
    if not condition:
        raise Impossible(key, meaning, value)


@dataclass(frozen=True)
class Bounds:
    """
    What a parameter may be; if it is a list, what each of its elements may be.

    `low` and `high` are themselves allowed, `above` and `below` are not. A float must be finite
    unless `low` or `high` says otherwise by being infinite.
    """

    kind: type                          # bool, int, float or str; of a list that of its elements
    is_list: bool = False
    low: float | None = None
    high: float | None = None
    above: float | None = None
    below: float | None = None
    choices: tuple = ()
    length: int | None = None           # of the list
    rising: bool = False                # each element of the list above the one before it

    @cached_property
    def least(self) -> float:
        """The smallest number allowed: next to `above` where that is the bound."""
        if self.low is not None:
            return self.low
        if self.above is not None:
            return nextafter(self.above, inf)
        return -LARGEST if self.kind is float else -inf

    @cached_property
    def most(self) -> float:
        """The largest number allowed."""
        if self.high is not None:
            return self.high
        if self.below is not None:
            return nextafter(self.below, -inf)
        return LARGEST if self.kind is float else inf

    @property
    def closed(self) -> bool:
        """Whether it is one number between two that are allowed: what ROS calls a range."""
        ends = (self.low, self.high)
        return not self.is_list and None not in ends and all(map(isfinite, ends))

    @property
    def declared(self) -> bool:
        """Whether `param` was told any bound."""
        return self != Bounds(self.kind, self.is_list)

    @property
    def meaning(self) -> str:
        """What is allowed, in words; empty if everything of its type is."""
        one = self._of_one()
        if not self.is_list or self.kind is str:
            return one
        each = f', each {one}' if one not in ('', 'finite') else ''
        words = [str(self.length or ''), 'finite' if one == 'finite' else '',
                 'rising' if self.rising else '', 'whole' if self.kind is int else '', 'numbers']
        return ' '.join(filter(None, words)) + each

    def check(self, key: str, value: Any) -> None:
        """Refuse a value, or an element of a list, that is not allowed."""
        if not self.is_list:
            if not self._holds(value):
                raise self._refusal(key, value)
            return
        if not isinstance(value, (tuple, list)):
            raise Impossible(key, 'be a list', repr(value))
        for i, element in enumerate(value):
            if not self._holds(element):
                raise self._refusal(f'{key}[{i}]', element)
        if self.length is not None and len(value) != self.length:
            raise Impossible(key, f'be {self.length} numbers', list(value))
        if self.rising and not all(a < b for a, b in zip(value, value[1:])):
            raise Impossible(key, 'be rising numbers', list(value))

    def _holds(self, value: Any) -> bool:
        if self.choices:
            return value in self.choices
        if self.kind in (bool, str):
            return True
        try:
            return self.least <= value <= self.most
        except (TypeError, ArithmeticError):
            return False

    def _refusal(self, key: str, value: Any) -> Impossible:
        if not self.choices and not isinstance(value, Number):
            return Impossible(key, 'be a number', repr(value))
        lower, upper = self._sides()
        endless = isinstance(value, float) and not isfinite(value)
        if endless and self.most < inf and not (lower and upper):
            return Impossible(key, 'be finite', value)
        words = self._of_one()
        return Impossible(key, 'not be negative' if words == 'not negative' else f'be {words}',
                          value)

    def _of_one(self) -> str:
        """Return what is allowed of one number or text, in words."""
        if self.choices:
            return f'one of {", ".join(map(str, self.choices))}'
        lower, upper = self._sides()
        if lower.startswith('at least') and upper.startswith('at most'):
            return f'between {_text(self.low)} and {_text(self.high)}'
        if lower and upper:
            return f'{lower} and {upper}'
        if self.low == 0 and not upper:
            return 'not negative'
        if self.above == 0 and not upper:
            return 'positive'
        return lower or upper or ('finite' if self.kind is float else '')

    def _sides(self) -> tuple[str, str]:
        """Return the bound on either side in words, empty where there is none."""
        lower = upper = ''
        if self.low not in (None, -inf):
            lower = f'at least {_text(self.low)}'
        elif self.above is not None:
            lower = f'above {_text(self.above)}'
        if self.high not in (None, inf):
            upper = f'at most {_text(self.high)}'
        elif self.below is not None:
            upper = f'below {_text(self.below)}'
        return lower, upper


def _text(number: float) -> str:
    """Return a number as people write it: 1 for 1.0."""
    return str(int(number)) if abs(number) < 1e9 and number == int(number) else repr(number)


def param(default: Any, doc: str, *, low: float | None = None, high: float | None = None,
          above: float | None = None, below: float | None = None, choices: Iterable = (),
          length: int | None = None, rising: bool = False) -> Any:
    """
    Return the dataclass field of a parameter.

    Parameters
    ----------
    default
        A bool, int, float or str, a tuple of one of them, or a settings class, whose parameters
        then are `name.key`.
    doc : str
        One sentence with the unit in brackets: what `ros2 param describe` shows.
    low, high, above, below, choices, length, rising
        What is allowed; see `Bounds`.

    Raises
    ------
    Impossible
        If the default itself is out of bounds.
    """
    if isinstance(default, type) or callable(default):
        return field(default_factory=default, metadata={'doc': doc})
    is_list = isinstance(default, tuple)
    kind = type(default[0] if default else '') if is_list else type(default)
    bounds = Bounds(kind, is_list, low, high, above, below, tuple(choices), length, rising)
    bounds.check('default', default)
    return field(default=default, metadata={'doc': doc, 'bounds': bounds})


def check_bounds(self: Any) -> None:
    """
    Refuse a settings object with a parameter out of its bounds.

    Raises
    ------
    Impossible
        Names the first such parameter and its value.
    """
    numbers, others = _bounds_of(type(self))
    for name, least, most, bounds in numbers:       # most are: 0.1 us each, not 0.3 us
        value = getattr(self, name)
        try:
            if least <= value <= most:
                continue
        except (TypeError, ArithmeticError):
            pass
        bounds.check(name, value)
    for name, bounds in others:
        bounds.check(name, getattr(self, name))


check_bounds.checks_bounds = True


@lru_cache(maxsize=None)
def _bounds_of(cls: type) -> tuple[list, list]:
    """Return what there is to check: (name, least, most, bounds) of numbers, (name, bounds)."""
    numbers, others = [], []
    for name, bounds in ((f.name, f.metadata.get('bounds')) for f in fields(cls)):
        if bounds is None or not bounds.meaning:
            continue
        if bounds.is_list or bounds.choices:
            others.append((name, bounds))
        else:
            numbers.append((name, bounds.least, bounds.most, bounds))
    return numbers, others


@dataclass_transform(frozen_default=True, field_specifiers=(param, field))
def settings(cls: type) -> type:
    """
    Make a settings class: a frozen dataclass whose parameters are checked against their bounds.

    What the bounds cannot say, such as how two parameters relate, is for the class's own
    `__post_init__`, which runs after the check and may rely on it.
    """
    own = getattr(cls, '__post_init__', None)
    if own is None:
        cls.__post_init__ = check_bounds
    elif not _checks_bounds(cls):
        def check_both(self: Any) -> None:
            check_bounds(self)
            own(self)
        check_both.checks_bounds = True
        cls.__post_init__ = check_both
    return dataclass(frozen=True)(cls)


def _checks_bounds(cls: type) -> bool:
    return hasattr(getattr(cls, '__post_init__', None), 'checks_bounds')


def leaves(cls: type, prefix: str = '') -> Iterator[tuple[str, Field]]:
    """
    Yield `(dotted key, field)` for each parameter of a settings class, nested ones included.

    A field that has no `doc` (a mission handed to a law, say) is wiring, not a parameter.

    Raises
    ------
    TypeError
        If the class declares bounds that nothing would check.
    """
    for f in fields(cls):
        if 'doc' not in f.metadata:
            continue
        if 'bounds' in f.metadata and f.metadata['bounds'].declared and not _checks_bounds(cls):
            raise TypeError(f'{cls.__name__} declares bounds of {f.name}: make it with @settings '
                            'in place of @dataclass')
        nested = f.default_factory if is_dataclass(f.default_factory) else None
        if nested is not None:
            yield from leaves(nested, f'{prefix}{f.name}.')
        else:
            yield prefix + f.name, f


def default_of(f: Field) -> Any:
    """Return the default of a parameter that `leaves` yielded."""
    return f.default_factory() if callable(f.default_factory) else f.default


def build(cls: type, values: dict[str, Any], prefix: str = '', label: str = '') -> Any:
    """
    Make a settings object from dotted keys; missing keys keep their defaults.

    `label` stands before the keys in what is said about them. A class with a static method
    `preset(given)` has other defaults, which depend on the values given.

    Raises
    ------
    ValueError
        If a value has the wrong type or the class refuses it; the text names key and value.
    """
    made: dict[str, Any] = {}
    for f in fields(cls):
        key = prefix + f.name
        if 'doc' not in f.metadata:
            continue
        if is_dataclass(f.default_factory):
            made[f.name] = build(f.default_factory, values, key + '.', label)
        elif key in values:
            made[f.name] = coerce(label + key, values[key], default_of(f))
    if hasattr(cls, 'preset'):
        made = {**cls.preset(made), **made}
    try:
        return cls(**made)
    except Impossible as error:
        raise error.under(label + prefix) from None


def coerce(key: str, value: Any, default: Any) -> Any:
    """
    Return `value` in the type of `default`, or refuse it by name.

    An integer is taken where a float is meant, also inside a list; nothing else is converted,
    but `2e-4`, which YAML 1.1 reads as text and ROS as a number, is read as a number.
    """
    if isinstance(default, tuple):
        if not isinstance(value, (list, tuple)) and not hasattr(value, 'tolist'):
            raise BadInput(f'{key} must be a list, got {value!r}')
        inner = default[0] if default else ''
        return tuple(coerce(f'{key}[{i}]', v, inner) for i, v in enumerate(value))
    if isinstance(default, bool):
        if not isinstance(value, bool):
            raise BadInput(f'{key} must be true or false, got {value!r}')
        return value
    if isinstance(default, float):
        if isinstance(value, str):
            try:
                return float(value)
            except ValueError:
                raise BadInput(f'{key} must be a number, got {value!r}') from None
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise BadInput(f'{key} must be a number, got {value!r}')
        try:
            return float(value)
        except OverflowError:
            raise BadInput(f'{key} must be within 1.8e308, got {value}') from None
    if isinstance(default, int):
        if isinstance(value, bool) or not isinstance(value, int):
            raise BadInput(f'{key} must be a whole number, got {value!r}')
        return value
    if not isinstance(value, str):
        raise BadInput(f'{key} must be text, got {value!r}')
    return value


def choice(name: str, key: str, table: dict[str, type], default: str, doc: str) -> type:
    """
    Return a settings class that picks one entry of a table of interchangeable parts.

    Its parameters are `key`, whose value is a name in `table`, and the settings of each entry
    under the entry's name; `selected` is the picked entry, built.
    """
    picks = [(key, str, param(default, doc, choices=table))]
    parts = [(entry, part, param(part, f'Settings of {entry}.')) for entry, part in table.items()]
    return make_dataclass(name, picks + parts, frozen=True, namespace={
        '__doc__': f'{doc}\n\n`{key}` names it; the settings of each stand under its name.',
        '__post_init__': check_bounds,
        'selected': property(lambda self: getattr(self, getattr(self, key)))})


def flatten(made: Any, prefix: str = '') -> dict[str, Any]:
    """Return the dotted keys and values of an instance: the inverse of `build`."""
    flat: dict[str, Any] = {}
    for f in fields(made):
        if 'doc' not in f.metadata:
            continue
        value = getattr(made, f.name)
        if is_dataclass(value):
            flat.update(flatten(value, f'{prefix}{f.name}.'))
        else:
            flat[prefix + f.name] = list(value) if isinstance(value, tuple) else value
    return flat


def dotted(tree: dict[str, Any], prefix: str = '') -> dict[str, Any]:
    """
    Return the nested keys of a parameter file as dotted ones, as ROS names them.

    Raises
    ------
    BadInput
        If a key is there dotted and nested: either value could be meant.
    """
    flat: dict[str, Any] = {}
    for key, value in tree.items():
        name = f'{prefix}{key}'
        more = dotted(value, f'{name}.') if isinstance(value, dict) else {name: value}
        for twice in flat.keys() & more.keys():
            raise BadInput(f'{twice} is given twice, with its dots and nested')
        flat.update(more)
    return flat


def wiring(before: Any = None) -> Any:
    """
    Return a field that is no parameter: something that `diagram.build.wired` hands over by name.

    It is `before` in a settings object that nothing has been handed to yet.
    """
    return field(default=before, metadata={'wiring': True})


def is_wiring(f: Field) -> bool:
    """Say whether a field is one that `wiring` made."""
    return f.metadata.get('wiring', False)
