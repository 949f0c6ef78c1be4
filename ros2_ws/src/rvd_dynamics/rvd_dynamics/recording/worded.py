"""
Names as files give them, in words: what a reader of a page or a figure sees of a condition.

The names themselves stay what they are, in files and on the command line.
"""

import re

UNITS = {'_percent': '%', '_fraction': '', '_m_s2': 'm/s²', '_rad_s': 'rad/s', '_m_s': 'm/s',
         '_n_m': 'N m', '_per_s': 'per s', '_deg': 'deg', '_rad': 'rad', '_kg': 'kg', '_s': 's',
         '_m': 'm', '_n': 'N'}
CAPITALS = re.compile(r'\b(apf|pid|rrca|odrrca)\b')         # names of laws that are initials
PLAIN = re.compile(r'[-+.\d][-+.\de]*')                     # a number


def worded(name: str) -> str:
    """
    Return the name of a condition in words.

    >>> worded('corridor_apf,loop_delay_s=10,spheres=four')
    'corridor APF, loop delay 10 s, spheres: four'
    """
    return ', '.join(_part(*part.partition('=')) for part in name.split(','))


def worded_axis(name: str) -> str:
    """Return the name of an axis of a grid as an axis of a figure has it: 'loop delay [s]'."""
    bare, unit = _split(name)
    return f'{_plain(bare)} [{unit}]' if unit else _plain(bare)


def _part(name: str, is_axis: str, value: str) -> str:
    """Return a group, or an axis of the grid with its value, whose unit ends the axis's name."""
    if not is_axis:
        return _plain(name)
    if not PLAIN.fullmatch(value):
        return f'{_plain(name)}: {_plain(value)}'
    bare, unit = _split(name)
    return f'{_plain(bare)} {value} {unit}'.rstrip()


def _split(name: str) -> tuple[str, str]:
    """Return a name without the unit at its end, and that unit."""
    suffix = next((s for s in UNITS if name.endswith(s) and name != s), '')
    return name.removesuffix(suffix), UNITS.get(suffix, '')


def _plain(text: str) -> str:
    return CAPITALS.sub(lambda found: found[0].upper(), text.replace('_', ' '))
