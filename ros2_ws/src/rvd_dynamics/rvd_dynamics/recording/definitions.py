"""
What a reader of a bag must know about a message type, from the installed interface packages.

Source  `share/PKG/msg/Type.msg` and `share/PKG/msg/Type.json`, which every interface package
        installs; layout of the text: MCAP specification, schema encoding `ros2msg`.
"""

import json
import re
from functools import lru_cache
from pathlib import Path

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

SEPARATOR = '=' * 80
_FIELD = re.compile(r'^\s*([A-Za-z]\w*(?:/[A-Za-z]\w*)*)(?:<=\d+)?(?:\[[^\]]*\])?\s+[A-Za-z]')
_PRIMITIVES = frozenset((
    'bool', 'byte', 'char', 'float32', 'float64', 'int8', 'uint8', 'int16', 'uint16', 'int32',
    'uint32', 'int64', 'uint64', 'string', 'wstring'))


def _source(kind: str, suffix: str) -> str:
    package, folder, name = kind.split('/')
    try:
        return Path(get_package_share_directory(package), folder, name + suffix).read_text()
    except (PackageNotFoundError, OSError) as error:
        raise LookupError(f'no definition of {kind} is installed: {error}') from None


def _needs(kind: str, text: str) -> list[str]:
    """Return the message types that the fields of `kind` name, in order of appearance."""
    package, needed = kind.split('/')[0], []
    for line in text.splitlines():
        match = _FIELD.match(line.split('#')[0])
        if match and match[1] not in _PRIMITIVES:
            parts = match[1].split('/')
            needed.append(f'{parts[0] if len(parts) > 1 else package}/msg/{parts[-1]}')
    return needed


@lru_cache(maxsize=None)
def schema_text(kind: str) -> str:
    """
    Return the `ros2msg` definition of `kind` (`pkg/msg/Type`), each dependency once.

    Raises
    ------
    LookupError
        If the type or one it needs is not installed.
    """
    texts = {kind: _source(kind, '.msg')}
    pending = _needs(kind, texts[kind])
    while pending:
        needed = pending.pop(0)
        if needed not in texts:
            texts[needed] = _source(needed, '.msg')
            pending += _needs(needed, texts[needed])
    root = texts.pop(kind)
    return root + ''.join(f'\n{SEPARATOR}\nMSG: {name.replace("/msg/", "/")}\n{text}'
                          for name, text in texts.items())


@lru_cache(maxsize=None)
def type_hash(kind: str) -> str:
    """
    Return the RIHS01 hash of `kind`, by which ROS tells whether two definitions agree.

    Raises
    ------
    LookupError
        If the type is not installed.
    """
    for entry in json.loads(_source(kind, '.json'))['type_hashes']:
        if entry['type_name'] == kind:
            return entry['hash_string']
    raise LookupError(f'{kind}: its description has no hash')
