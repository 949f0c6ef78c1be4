"""
What the numbers of a run depend on besides its settings: our sources, and versions of libraries.

A mission's own sources are those of the package that its diagram stands in, and those of every
package beside it that they name. Other missions of the same distribution do not count.
"""

import ast
import hashlib
import importlib.metadata
import importlib.util
import re
from functools import lru_cache
from pathlib import Path

from rvd_campaign.campaign import results
from rvd_dynamics.diagram.mission import Mission

MATTERS = ('numpy', 'scipy', 'filterpy', 'numba')   # packages whose version may move a last bit
SOURCES = ('.py', '.c', '.h')
# What a run in process loads of ours, by package; nodes, console and reports change no number.
LOOP = {
    'rvd_dynamics': (
        'bad_input.py', 'commands', 'compiled.py', 'compiling.py', 'constants.py', 'diagram',
        'frames.py', 'geometry', 'given.py', 'link', 'motion', 'onboard', 'world',
        *(f'recording/{name}.py' for name in (          # reads tapes
            '__init__', 'limits', 'mcap_records', 'messages', 'params', 'sqlite_file', 'whole'))),
    'rvd_groundstation': (
        'guidance', 'joystick/__init__.py', 'joystick/params.py', 'operators', 'prediction',
        'settings.py', 'sharing')}
NO_LOOP = ('diagram/display', 'diagram/ros', 'diagram/roster.py')   # left out of the above


def software(mission: Mission) -> tuple[str, ...]:
    """Return what must be equal in every process that flies runs of a mission."""
    return code_hash(mission), *versions().values()


def versions() -> dict[str, str]:
    """Return the versions of the packages that a run's last bits depend on."""
    return {name: importlib.metadata.version(name) for name in MATTERS}


def code_hash(mission: Mission) -> str:
    """Return the hash of the sources that the numbers of a run of a mission depend on."""
    return _code_hash(*_places(mission))


def sources(mission: Mission) -> list[tuple[str, Path]]:
    """Return names and paths of the ground loop's sources and those of a mission."""
    return _sources(*_places(mission))


def _places(mission: Mission) -> tuple[str, frozenset[str]]:
    """Return the package of a mission, and the files that it names for showing something."""
    shown = (mission.figures, mission.campaign_figures, mission.campaign_notes, mission.display,
             *mission.short_words.values())
    module = mission.diagram.partition(':')[0]
    return module.rpartition('.')[0] or module, frozenset(
        word.partition(':')[0].replace('.', '/') + '.py' for word in shown)


@lru_cache(maxsize=None)
def _code_hash(package: str, shown: frozenset[str]) -> str:
    made = hashlib.sha256(Path(results.__file__).read_bytes())
    for name, path in _sources(package, shown):
        made.update(f'{name}\0'.encode() + path.read_bytes())
    return made.hexdigest()


def _sources(package: str, shown: frozenset[str]) -> list[tuple[str, Path]]:
    found = [(name, path) for package_name in LOOP for name, path in _files(package_name)
             if _in_loop(package_name, name.partition('/')[2])]
    if package.partition('.')[0] not in LOOP:
        own = _own(package)
        found += [(name, path) for name, path in own
                  if not (name in shown and _used_by_none(name, own, shown))]
    return found


def _own(package: str) -> list[tuple[str, Path]]:
    """Return the files of a mission's package, and of those beside it that they name."""
    top = package.partition('.')[0]
    beside = re.compile(rf'\b{re.escape(top)}\.(\w+)')
    words = package.split('.')
    above = ['.'.join(words[:n]) for n in range(1, len(words))]      # loaded before the package is
    found = [(name, path) for outer in above for name, path in _files(outer)
             if name == f'{outer.replace(".", "/")}/__init__.py']
    packages = [package]
    for name in packages:                       # grows while it is gone through
        files = _files(name)
        found += [file for file in files if file not in found]
        for _, path in files:
            text = path.read_text(encoding='utf-8')
            named = {f'{top}.{word}' for word in beside.findall(text)}
            if re.search(r'^\s*from \.\.', text, re.MULTILINE):     # as good as any of them
                named.add(top)
            packages += [other for other in sorted(named)
                         if not any(f'{other}.'.startswith(f'{taken}.') for taken in packages)
                         and importlib.util.find_spec(other) is not None]
    return found


def _files(package: str) -> list[tuple[str, Path]]:
    spec, place = importlib.util.find_spec(package), package.replace('.', '/')
    if spec.submodule_search_locations is None:             # a module by itself
        return [(f'{place}.py', Path(spec.origin))]
    return [(f'{place}/{path.relative_to(folder)}', path)
            for folder in sorted(map(Path, spec.submodule_search_locations))
            for path in sorted(folder.rglob('*')) if path.suffix in SOURCES]


def _in_loop(package: str, name: str) -> bool:
    def within(places: tuple[str, ...]) -> bool:
        return any(name == place or name.startswith(f'{place}/') for place in places)
    return name == '__init__.py' or within(LOOP[package]) and not within(NO_LOOP)


def _used_by_none(name: str, own: list[tuple[str, Path]], shown: frozenset[str]) -> bool:
    """Say whether no file of a package that makes numbers imports one that shows something."""
    module = _module(name)
    return not any(module in _imported(other, path) for other, path in own if other not in shown)


def _module(name: str) -> str:
    return name.removesuffix('.py').removesuffix('/__init__').replace('/', '.')


def _imported(name: str, path: Path) -> set[str]:
    """Return all that a file imports, relative names resolved: modules, and what is in them."""
    if path.suffix != '.py':
        return set()
    package = [*_module(name).split('.'), *(['__init__'] if path.stem == '__init__' else [])]
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding='utf-8'))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package[:-node.level] if node.level else []
            base = '.'.join([*above, *([node.module] if node.module else [])])
            found |= {base, *(f'{base}.{alias.name}' for alias in node.names)}
    return found
