"""
Makes what a diagram names: classes by their text, and constructor arguments by their names.

A constructor says with its parameters what it needs, and gets that and nothing else:

    def __init__(self, settings: SensorParams, run: Run, noise, batch) -> None
"""

import inspect
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass, replace
from functools import lru_cache
from importlib import import_module
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import is_wiring


@lru_cache(maxsize=None)
def loaded(name: str) -> Any:
    """
    Return what 'module:NAME' names.

    Raises
    ------
    ValueError
        If the text has not that form, the module cannot be imported or lacks the name; one line.
    """
    module, _, attribute = name.partition(':')
    if not attribute:
        raise BadInput(f'{name!r} must be of the form module:NAME')
    try:
        imported = import_module(module)
    except (ImportError, SyntaxError) as error:
        raise BadInput(f'{name} cannot be loaded: {error}') from error
    try:
        return getattr(imported, attribute)
    except AttributeError:
        raise BadInput(f'module {module} has no {attribute}') from None


def needs(name: str, owner: str) -> Mapping[str, inspect.Parameter]:
    """Return the parameters by name of what 'module:NAME' names; errors as `made`."""
    try:
        return _parameters(name)
    except BadInput as error:
        raise BadInput(f'{owner}: {error}') from error.__cause__


@lru_cache(maxsize=None)
def _parameters(name: str) -> Mapping[str, inspect.Parameter]:
    return inspect.signature(loaded(name)).parameters


def made(name: str, available: Callable[[str], Any], owner: str) -> Any:
    """
    Call what 'module:NAME' names with the arguments that its parameters name.

    Raises
    ------
    ValueError
        If it cannot be loaded or nothing of a name is available; the text names `owner`.
    """
    arguments = {}
    for parameter in needs(name, owner).values():
        try:
            arguments[parameter.name] = available(parameter.name)
        except LookupError:
            if parameter.default is inspect.Parameter.empty:
                raise BadInput(f'{owner}: {name} needs {parameter.name!r}, which neither the '
                               'scenario nor the mission has') from None
    return loaded(name)(**arguments)


def wired(part: Any, available: Callable[[str], Any]) -> Any:
    """Return a settings object with its fields that are no parameters filled in by name."""
    if not is_dataclass(part):
        return part
    return replace(part, **{f.name: available(f.name) for f in fields(part) if is_wiring(f)})
