"""
Scenario texts that nobody in their right mind writes: mutations of the shipped ones, by a seed.

`text_of(seed)` is one text, the same for the same seed and the same shipped scenarios; half of them
are changed as a tree (values, keys, sections), half as text (cut, flipped, tokens of YAML put in).
`fault(text)` loads one as `./rvd fly` does and says what went wrong: it must load, or be refused in
one line, within `MOST_S` of CPU time.
"""

from collections.abc import Callable
from functools import lru_cache
import gc
from random import Random
import time
from typing import Any

import yaml

from rvd_campaign import catalogue
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.given import text_of as read

MOST_S = 1.0                            # [s] of CPU time that one text may take
TRIES = 3                               # before it is said to take longer
LARGE = 500                             # of so many texts one is large: each costs a tenth second
NAME = 'hostile'

VALUES: tuple[Any, ...] = (
    None, True, False, 0, -1, 1, 2, 7, 10**6, 2**31, 2**53 + 1, 2**63 - 1, 2**63, -2**63 - 1, 2**64,
    10**308, 10**309, -10**400, 0.0, -0.0, 1e-308, 5e-324, 1e-9, 0.1, 0.3, 1e9, 1e17, 1e308, -1e308,
    float('inf'), float('-inf'), float('nan'), '', ' ', 'x', '1e999', '2e-4', 'nan', '0x10',
    'paper', '../../etc/passwd', '/dev/zero', '/dev/stdin', '.', '/', '\x00', '\x1b[2J', '\u202e',
    'a' * 5000, '\U0001f680', [], [[]], [0], [1, 2, 3], [0.0] * 100, ['a', 1, None], {}, {'a': 1},
    [float('nan')] * 3, [10**400], {'a': {'b': {'c': []}}}, 'y', 'no', 'null', '1:30', '010', '=',
    '<<', '2026-99-99', '2026-11-28')
TOKENS = ('&a ', '*a', '!!bool ', '!!timestamp x', '!!float ', '!!int ', '!!binary ', '!!set ',
          '!!python/object/apply:os.system ', '! ', '? ', ': ', '- ', '\t', '\n', '\r', '\x85',
          '\u2028', '\ufeff', '---\n', '...\n', '%YAML 9.9\n', '%TAG ! x\n', '{', '}', '[', ']',
          '|',
          '>', '"', "'", '#', '<<: ', '<<: {a: 1}\n', '=', '@', '`', ',', '0x' + 'f' * 600,
          '9' * 5000, '1' + ':5' * 300, '1' + ':5' * 300 + '.5', '0b' + '1' * 600, '1e400', '.inf',
          '2001-13-45', '~', '/**:\n', '/**', 'ros__parameters:', '\x00', '\x07', '\ud800')


@lru_cache(maxsize=1)
def shipped() -> tuple[str, ...]:
    """Return the texts of the shipped scenarios."""
    return tuple(read(path, 'scenario')
                 for path in sorted((catalogue.root() / 'scenarios').glob('*.yaml')))


def text_of(seed: int) -> str:
    """Return one hostile text."""
    rng = Random(seed)
    if rng.randrange(LARGE) == 0:
        return rng.choice(LARGE_ONES)(rng)
    base = rng.choice(shipped())
    if rng.random() < 0.5:
        tree = yaml.safe_load(base)
        for _ in range(rng.choice((1, 1, 1, 2, 5))):
            rng.choice(OF_A_TREE)(rng, tree)
        base = yaml.safe_dump(tree, sort_keys=False, allow_unicode=rng.random() < 0.5)
        if rng.random() < 0.8:
            return base
    for _ in range(rng.choice((1, 1, 2, 5))):
        base = rng.choice(OF_A_TEXT)(rng, base)
    return base


def fault(text: str) -> str:
    """Load a text; return what went wrong in a few words, empty if it did as it should."""
    for _ in range(TRIES):                      # the machine may be slow for a moment
        said, spent = _loaded(text)
        if said or spent <= MOST_S:
            return said
    return f'it took {spent:.1f} s'


def _loaded(text: str) -> tuple[str, float]:
    """Return what went wrong, and the CPU time without what all else in the process keeps alive."""
    said, collects = '', gc.isenabled()
    gc.disable()
    begun = time.thread_time()
    try:
        parse(text, NAME).diagram               # what a flight does before anything starts
    except BadInput as error:
        said = _not_one_line(str(error))
    except Exception as error:                  # noqa: B902 - that is what is looked for
        said = f'{type(error).__name__}: {error}'
    finally:
        spent = time.thread_time() - begun
        if collects:
            gc.enable()
    return said, spent


def _not_one_line(text: str) -> str:
    if not text or not text.isprintable():
        return f'the refusal is no line: {text!r}'
    return f'the refusal has {len(text)} characters' if len(text) > 2100 else ''


# -- changes of a tree -------------------------------------------------------------------------

def _places(tree: Any) -> list[tuple[Any, Any]]:
    """Return every (container, key) of a tree."""
    found = []
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in items:
        found.append((tree, key))
        if isinstance(value, (dict, list)):
            found += _places(value)
    return found


def _some(rng: Random, tree: dict) -> tuple[Any, Any]:
    places = _places(tree)
    return rng.choice(places) if places else (tree, 'x')


def _set(rng: Random, tree: dict) -> None:
    where, key = _some(rng, tree)
    where[key] = _copied(rng.choice(VALUES))


def _drop(rng: Random, tree: dict) -> None:
    where, key = _some(rng, tree)
    where.pop(key, None) if isinstance(where, dict) else where.pop(key)


def _rename(rng: Random, tree: dict) -> None:
    where, key = _some(rng, tree)
    if isinstance(where, dict):
        word = rng.choice((f'{key}x', str(key)[:-1], f'/{key}', f'{key}.{key}', '', 'run', 'nodes',
                           1, None, 1.5, True, 'seed', 'mission', 'use_sim_time'))
        where[word] = where.pop(key, None)


def _move(rng: Random, tree: dict) -> None:
    (a, key), (b, other) = _some(rng, tree), _some(rng, tree)
    b[other] = _copied(a.get(key) if isinstance(a, dict) else a[min(key, len(a) - 1)] if a else 0)


def _copied(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _copied(inner) for key, inner in value.items()}
    return [_copied(inner) for inner in value] if isinstance(value, list) else value


def _scale(rng: Random, tree: dict) -> None:
    numbers = [(w, k) for w, k in _places(tree)
               if isinstance(w[k], (int, float)) and not isinstance(w[k], bool) and
               abs(w[k]) < 1e300]
    if numbers:
        where, key = rng.choice(numbers)
        where[key] = where[key] * rng.choice((-1, 0, 0.5, 3, 1e-6, 1e6, 1e12, 1.0000001))


def _mission(rng: Random, tree: dict) -> None:
    body = tree.get('/**')
    if isinstance(body, dict) and isinstance(body.get('ros__parameters'), dict):
        body['ros__parameters']['mission'] = rng.choice((
            'lunar_approach', 'docking', 'tether', 'attitude_hold', 'obstacle_field', 'none', 3, [],
            'elliptic_rendezvous', 'tether_delay'))


OF_A_TREE: tuple[Callable[[Random, dict], None], ...] = (
    _set, _set, _set, _scale, _scale, _drop, _rename, _move, _mission)


# -- changes of a text -------------------------------------------------------------------------

def _cut(rng: Random, text: str) -> str:
    return text[:rng.randrange(len(text) + 1)]


def _flip(rng: Random, text: str) -> str:
    if not text:
        return text
    at = rng.randrange(len(text))
    return text[:at] + chr(ord(text[at]) ^ (1 << rng.randrange(8))) + text[at + 1:]


def _put(rng: Random, text: str) -> str:
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(TOKENS) + text[at:]


def _lines(rng: Random, text: str) -> str:
    lines = text.split('\n')
    at = rng.randrange(len(lines))
    change = rng.randrange(4)
    if change == 0:
        lines.insert(at, lines[at])
    elif change == 1:
        del lines[at]
    elif change == 2:
        lines[at] = ' ' * rng.choice((1, 2, 3, 8)) + lines[at]
    else:
        rng.shuffle(lines)
    return '\n'.join(lines)


def _spliced(rng: Random, text: str) -> str:
    other = rng.choice(shipped())
    return text[:rng.randrange(len(text) + 1)] + other[rng.randrange(len(other) + 1):]


def _value(rng: Random, text: str) -> str:
    """Put a token where a value stands."""
    lines = text.split('\n')
    with_values = [i for i, line in enumerate(lines) if ': ' in line]
    if with_values:
        at = rng.choice(with_values)
        head = lines[at].partition(': ')[0]
        lines[at] = f'{head}: {rng.choice(TOKENS)}{rng.choice(VALUES)!r}'
    return '\n'.join(lines)


OF_A_TEXT: tuple[Callable[[Random, str], str], ...] = (
    _cut, _flip, _flip, _put, _put, _value, _value, _lines, _spliced)


# -- large ones, each once in a while ------------------------------------------------------------

HEAD = '/**:\n  ros__parameters:\n'
LARGE_ONES: tuple[Callable[[Random], str], ...] = (
    lambda rng: HEAD + '    seed: 1\n' * 40_000,                                # one key, often
    lambda rng: HEAD + ''.join(f'    k{i}: 1\n' for i in range(40_000)),        # many keys
    lambda rng: HEAD + '    a: ' + '[' * rng.choice((50, 1000, 100_000)),
    lambda rng: HEAD + '    a: ' + '{a: ' * rng.choice((50, 1000, 100_000)),
    lambda rng: HEAD + ''.join(' ' * i + 'a:\n' for i in range(4, 700)),
    lambda rng: '- ' * 200_000,
    lambda rng: '? ' * 100_000,
    lambda rng: HEAD + '    a: &a [x, x]\n' + ''.join(
        f'    {chr(98 + i)}: &{chr(98 + i)} [*{chr(97 + i)}, *{chr(97 + i)}]\n' for i in range(20)),
    lambda rng: HEAD + '    a: "' + 'x' * 400_000 + '"\n',
    lambda rng: HEAD + '    a: ' + 'x ' * 200_000 + '\n',
    lambda rng: HEAD + '    a: |\n' + '      x\n' * 60_000,
    lambda rng: '#' * 500_000,
    lambda rng: '\n' * 500_000,
    lambda rng: ' ' * 500_000,
    lambda rng: '%' * 500_000,
    lambda rng: HEAD + '    a: ' + '1' + ':59' * 150_000 + '\n',
    lambda rng: HEAD + '    a: 0x' + 'f' * 400_000 + '\n',
    lambda rng: HEAD + '    a: [' + '1, ' * 150_000 + ']\n',
    lambda rng: HEAD + '    a: {' + ', '.join(f'"{i}": 1' for i in range(30_000)) + '}\n',
    lambda rng: HEAD + '    start: {position_m: [' + '1.0, ' * 60_000 + ']}\n',
    lambda rng: 'x' * 2_000_000)
