"""
Settings: a frozen dataclass beside each algorithm is the one place a parameter exists.

`param` gives a field its default and its meaning; ROS, YAML and campaigns read both from
there. Keys carry their unit as a suffix (`step_s`, `half_angle_deg`).
"""

from dataclasses import Field, field, fields, is_dataclass, make_dataclass
from typing import Any, Iterator


def param(default: Any, doc: str) -> Any:
    """Return a dataclass field with its default and the sentence `ros2 param describe` shows."""
    if isinstance(default, type) or callable(default):
        return field(default_factory=default, metadata={'doc': doc})
    return field(default=default, metadata={'doc': doc})


def leaves(settings: type, prefix: str = '') -> Iterator[tuple[str, Field]]:
    """
    Yield `(dotted key, field)` for each parameter of a settings class, nested ones included.

    A field that has no `doc` (a mission handed to a law, say) is wiring, not a parameter.
    """
    for f in fields(settings):
        if 'doc' not in f.metadata:
            continue
        nested = f.default_factory if is_dataclass(f.default_factory) else None
        if nested is not None:
            yield from leaves(nested, f'{prefix}{f.name}.')
        else:
            yield prefix + f.name, f


def default_of(f: Field) -> Any:
    """Return the default of a parameter that `leaves` yielded."""
    return f.default_factory() if callable(f.default_factory) else f.default


def build(settings: type, values: dict[str, Any], prefix: str = '', label: str = '') -> Any:
    """
    Make `settings` from dotted keys; missing keys keep their defaults.

    `label` stands before the keys in what is said about them.

    Raises
    ------
    ValueError
        If a value has the wrong type or the class refuses it; the text names key and value.
    """
    made: dict[str, Any] = {}
    for f in fields(settings):
        key = prefix + f.name
        if 'doc' not in f.metadata:
            continue
        if is_dataclass(f.default_factory):
            made[f.name] = build(f.default_factory, values, key + '.', label)
        elif key in values:
            made[f.name] = coerce(label + key, values[key], default_of(f))
    return settings(**made)


def coerce(key: str, value: Any, default: Any) -> Any:
    """
    Return `value` in the type of `default`, or refuse it by name.

    An integer is taken where a float is meant, also inside a list; nothing else is converted,
    but `2e-4`, which YAML 1.1 reads as text and ROS as a number, is read as a number.
    """
    if isinstance(default, tuple):
        if not isinstance(value, (list, tuple)) and not hasattr(value, 'tolist'):
            raise ValueError(f'{key} must be a list, got {value!r}')
        inner = default[0] if default else ''
        return tuple(coerce(f'{key}[{i}]', v, inner) for i, v in enumerate(value))
    if isinstance(default, bool):
        if not isinstance(value, bool):
            raise ValueError(f'{key} must be true or false, got {value!r}')
        return value
    if isinstance(default, float):
        if isinstance(value, str):
            try:
                return float(value)
            except ValueError:
                raise ValueError(f'{key} must be a number, got {value!r}') from None
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ValueError(f'{key} must be a number, got {value!r}')
        return float(value)
    if isinstance(default, int):
        if isinstance(value, bool) or not isinstance(value, int):
            raise ValueError(f'{key} must be a whole number, got {value!r}')
        return value
    if not isinstance(value, str):
        raise ValueError(f'{key} must be text, got {value!r}')
    return value


def choice(name: str, key: str, table: dict[str, type], default: str, doc: str) -> type:
    """
    Return a settings class that picks one entry of a table of interchangeable parts.

    Its parameters are `key`, whose value is a name in `table`, and the settings of each entry
    under the entry's name; `selected` is the picked entry, built.
    """
    def check(self: Any) -> None:
        picked = getattr(self, key)
        require(picked in table, key, f'be one of {", ".join(table)}', picked)

    picks = [(key, str, param(default, f'{doc} {", ".join(table)}.'))]
    parts = [(entry, part, param(part, f'Settings of {entry}.')) for entry, part in table.items()]
    return make_dataclass(name, picks + parts, frozen=True, namespace={
        '__doc__': f'{doc} `{key}` names it, its settings stand under its name.',
        '__post_init__': check,
        'selected': property(lambda self: getattr(self, getattr(self, key)))})


def flatten(settings: Any, prefix: str = '') -> dict[str, Any]:
    """Return the dotted keys and values of an instance: the inverse of `build`."""
    flat: dict[str, Any] = {}
    for f in fields(settings):
        if 'doc' not in f.metadata:
            continue
        value = getattr(settings, f.name)
        if is_dataclass(value):
            flat.update(flatten(value, f'{prefix}{f.name}.'))
        else:
            flat[prefix + f.name] = list(value) if isinstance(value, tuple) else value
    return flat


def dotted(tree: dict[str, Any], prefix: str = '') -> dict[str, Any]:
    """Return the nested keys of a parameter file as dotted ones, as ROS names them."""
    flat: dict[str, Any] = {}
    for key, value in tree.items():
        if isinstance(value, dict):
            flat.update(dotted(value, f'{prefix}{key}.'))
        else:
            flat[f'{prefix}{key}'] = value
    return flat


def require(condition: bool, name: str, meaning: str, value: Any) -> None:
    """Refuse an impossible setting with its name and value (`condition` false also for NaN)."""
    if not condition:
        raise ValueError(f'{name} must {meaning}, got {value}')


def wiring() -> Any:
    """
    Return a field that is no parameter: something that `diagram.build.wired` hands over by name.

    It is None in a settings object that nothing has been handed to yet.
    """
    return field(default=None, metadata={'wiring': True})


def is_wiring(f: Field) -> bool:
    """Say whether a field is one that `wiring` made."""
    return f.metadata.get('wiring', False)


def whole_steps(name: str, seconds: float, step_s: float) -> int:
    """
    Return a duration in steps.

    Raises
    ------
    ValueError
        If it is not a whole number of steps; the text names the two nearest.
    """
    steps = round(seconds / step_s)
    if abs(steps * step_s - seconds) > 1e-9:
        below = int(seconds / step_s)
        raise ValueError(
            f'{name} must be a whole number of steps of {step_s:g} s, got {seconds:g}: the two '
            f'nearest are {below * step_s:g} and {(below + 1) * step_s:g}')
    return steps
