"""
What a page may say: a binary stick frame at 50 Hz, and a few requests as JSON text.

Stick frame, 36 bytes little-endian: kind u8 = 1, held u8 (bit 0 the dead-man, then the other
buttons in the order of the mission's controller), sequence u16, deflection of six axes
as f32 in [-1, 1] (0 where a mission has fewer), instant of sampling f64 [ms since 1970, for
benchmarks only].
Whatever else comes is refused by name and never guessed at.
"""

import json
import math
from collections.abc import Collection
from dataclasses import dataclass
from struct import Struct
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import MODES, MOST_AXES, MOST_BUTTONS

STICK = Struct(f'<BBH{MOST_AXES}fd')
STICK_KIND = 1
MAX_FRAME = 64 * 1024           # [bytes]
MOST_SETTINGS, LONGEST_SETTING = 100, 200       # of a wish, characters
PAGE_RATE = 60.0                # [1/s] frames a page may send
PAGE_BURST = 300.0              # at once: what a page says while this process is held up for 5 s

REQUESTS = ('take', 'drop', 'mode', 'pause', 'resume', 'abort', 'fly', 'stop', 'quit', 'desk',
            'ping')
OF_WATCHERS = ('ping',)         # all that a page with a watcher's token may ask for
NEEDS_LEASE = ('mode', 'pause', 'resume', 'fly', 'stop', 'quit', 'desk')


class Refused(ValueError):
    """A frame that is not obeyed; the text is a short code."""


@dataclass(frozen=True, slots=True)
class Stick:
    """One sample of a stick, along the axes of the mission's hand controller."""

    held: bool
    sequence: int
    deflection: tuple[float, ...]
    buttons: tuple[bool, ...] = (False,) * MOST_BUTTONS     # beside the dead-man


RELEASED = Stick(False, 0, (0.0,) * MOST_AXES)


@dataclass(frozen=True, slots=True)
class Request:
    """One request; `id` comes back with the reply."""

    do: str
    id: int
    content: dict[str, Any]


def stick_of(data: bytes) -> Stick:
    """
    Return the stick sample in a binary frame.

    Raises
    ------
    Refused
        If the length, the kind or a deflection is wrong; the whole sample is refused.
    """
    if len(data) != STICK.size:
        raise Refused('LENGTH')
    kind, held, sequence, *deflection, _ = STICK.unpack(data)
    if kind != STICK_KIND:
        raise Refused('KIND')
    if not all(math.isfinite(a) and -1.0 <= a <= 1.0 for a in deflection):
        raise Refused('RANGE')
    return Stick(held & 1 == 1, sequence, tuple(deflection),
                 tuple(held >> bit & 1 == 1 for bit in range(1, 1 + MOST_BUTTONS)))


def request_of(text: str, modes: Collection[str] = MODES) -> Request:
    """
    Return the request in a text frame; `modes` are those that may be chosen.

    Raises
    ------
    Refused
        If it is no JSON object, or asks for what is not offered.
    """
    try:
        content = json.loads(text, parse_constant=_no_constant)
    except (ValueError, RecursionError):
        raise Refused('JSON') from None
    if not isinstance(content, dict):
        raise Refused('JSON')
    do, number = content.get('do'), content.get('id', 0)
    if do not in REQUESTS:
        raise Refused('REQUEST')
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < 1 << 53:
        raise Refused('ID')
    if do == 'mode' and content.get('mode') not in modes:
        raise Refused('MODE')
    return Request(do, number, content)


def flight_wish(content: dict[str, Any], modes: Collection[str] = MODES) -> dict[str, Any]:
    """
    Return the checked wish for a new run: `mode`, `seed` and `settings`, each if given.

    `settings` are texts by 'section key'; whether they make sense is found out by who starts it.

    Raises
    ------
    Refused
        If a value is of the wrong kind.
    """
    wish: dict[str, Any] = {}
    if content.get('mode') is not None:
        if content['mode'] not in modes:
            raise Refused('MODE')
        wish['mode'] = content['mode']
    seed = content.get('seed')
    if seed is not None:
        if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 1 << 32:
            raise Refused('SEED')
        wish['seed'] = seed
    changed = content.get('settings')
    if changed is not None:
        if not isinstance(changed, dict) or len(changed) > MOST_SETTINGS or not all(
                isinstance(text, str) and len(text) <= LONGEST_SETTING
                for text in (*changed, *changed.values())):
            raise Refused('SETTINGS')
        wish['settings'] = changed
    return wish


def encode(message: Any) -> str:
    """Return a message as JSON text; what is unknown (NaN) is null."""
    return json.dumps(_known(message), separators=(',', ':'), allow_nan=False)


def _known(value: Any) -> Any:
    if isinstance(value, float):
        return round(value, 6) if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: _known(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_known(inner) for inner in value]
    return value


def _no_constant(name: str) -> None:
    raise BadInput(name)
