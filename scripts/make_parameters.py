"""
Make docs/parameters.md again: every parameter of a scenario of the lunar approach, read from the
settings classes. Pages of other missions with the marks PARAMETERS get their missions' own.

    ./rvd shell python scripts/make_parameters.py
"""

from pathlib import Path
import re
from typing import Any

from rvd_dynamics.diagram.mission import find
from rvd_dynamics.diagram.params import Bounds, default_of, leaves
from rvd_dynamics.diagram.scenario import sections_of, SHARED

PAGE = Path(__file__).resolve().parents[1] / 'docs' / 'parameters.md'
MISSIONS = PAGE.parent / 'missions'
PARAMETERS = re.compile('(?<=<!-- parameters -->\n).*?(?=<!-- end of parameters -->)', re.S)
INTRODUCTION = '''\
# Parameters

<!-- Made by `./rvd shell python scripts/make_parameters.py` from the settings classes: edit those.
-->

Every parameter that a scenario of the lunar approach can set, by section of the file. What is left
out keeps its default. Dots in a key are levels of the file: `eq25.eta` of `command_blender` is
written as

```yaml
command_blender:
  ros__parameters:
    eq25: {eta: 0.5}
```

Numbers must be finite; `1` is accepted for `1.0`. What is allowed for a list holds for each of its
elements. Some parameters must also fit each other: `uniform.high_fraction` is not below
`uniform.low_fraction`. Whatever is not allowed is refused before anything starts, in one line that
names key and value. A running node says the same about its parameters:
`ros2 param describe /command_blender eq25.eta`.
'''


def sections() -> dict[str, list[tuple[str, type]]]:
    """
    Return the settings classes of each section of a scenario, with the prefixes of their keys.
    """
    return sections_of(find('lunar_approach'))


def page() -> str:
    """Return the text of docs/parameters.md; sections with the same settings share a table."""
    parts, found = [INTRODUCTION], sections()
    parts.append(f'\n## `{SHARED}`\n\n'
                 'What several nodes must know. It stands here and nowhere else.\n')
    for prefix, cls in found.pop(SHARED):
        parts.append(f'\n{summary(cls)}\n\n{table(prefix, cls)}')
    titles: dict[type, list[str]] = {}
    for name, [(_, cls)] in found.items():
        titles.setdefault(cls, []).append(f'`{name}`')
    for cls, names in titles.items():
        parts.append(f'\n## {", ".join(names)}\n\n{summary(cls)}\n\n{table("", cls)}')
    return ''.join(parts)


def filled(path: Path) -> str:
    """Return the text of a mission's page with the parameters that only this mission has."""
    text = path.read_text(encoding='utf-8')
    if not PARAMETERS.search(text):
        return text
    there, parts = {cls for classes in sections().values() for _, cls in classes}, []
    for name, classes in sections_of(find(path.stem)).items():
        for prefix, cls in classes:
            if cls not in there:
                parts.append(f'\n`{name}`: {summary(cls)}\n\n{table(prefix, cls)}')
    return PARAMETERS.sub(lambda _: ''.join(parts) + '\n', text)


def table(prefix: str, cls: type) -> str:
    """Return the parameters of a settings class as a table."""
    rows = [f'| `{prefix}{key}` | `{spelled(default_of(field))}` '
            f'| {allowed(field.metadata["bounds"])} | {escaped(field.metadata["doc"])} |'
            for key, field in leaves(cls)]
    return '\n'.join(['| key | default | allowed | meaning |', '| --- | --- | --- | --- |',
                      *rows, ''])


def summary(cls: type) -> str:
    """Return the first paragraph of the docstring of a class in one line."""
    return ' '.join((cls.__doc__ or '').strip().split('\n\n')[0].split())


def spelled(value: Any) -> str:
    """Return a default as YAML has it."""
    if isinstance(value, tuple):
        return f'[{", ".join(map(spelled, value))}]'
    if isinstance(value, bool):
        return 'true' if value else 'false'
    return (value or "''") if isinstance(value, str) else repr(value)


def allowed(bounds: Bounds) -> str:
    """Return what a parameter may be, in words."""
    if bounds.choices:
        return ', '.join(f'`{choice}`' for choice in bounds.choices)
    kind = {bool: '`true` or `false`', int: 'whole number', float: '', str: 'text'}[bounds.kind]
    if bounds.is_list:
        return bounds.meaning or 'list of texts'
    if bounds.meaning == 'finite':
        return 'number'
    return ', '.join(filter(None, [kind, bounds.meaning]))


def escaped(text: str) -> str:
    """Return a sentence as the cell of a table."""
    return text.replace('|', r'\|')


if __name__ == '__main__':
    PAGE.write_text(page(), encoding='utf-8')
    for mission in sorted(MISSIONS.glob('*.md')):
        mission.write_text(filled(mission), encoding='utf-8')
