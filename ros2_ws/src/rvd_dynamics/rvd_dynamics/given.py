"""
Files that people write, read with limits: the one way in for scenarios, campaigns, tapes and JSON.

Whatever lies at a path, reading it ends soon and with little memory: a regular file that is not
too large (a pipe or a device has no end), text in UTF-8, and in YAML and JSON not too many values,
not nested too deeply, and no key twice. All else is refused in one line.

Mission code and tests that read a file of their own use it, too; `tests/test_given_files.py` keeps
it the only place that does.
"""

from collections.abc import Iterator
import csv
from io import StringIO
import json
import os
from pathlib import Path
import re
import stat
from typing import Any, BinaryIO

import yaml

from rvd_dynamics.bad_input import BadInput

MAX_BYTES = 512 << 10           # [B] of YAML: a scenario is a page; 1 MB of it takes seconds
MAX_JSON_BYTES = 64 << 20       # [B] a campaign keeps the scenario of each of 1000 conditions
MAX_TABLE_BYTES = 64 << 20      # [B] of a tape or a list of numbers: a day at 100 Hz
MAX_DEPTH = 20
MAX_VALUES = 10_000             # of YAML, keys included; half a second
MAX_DIGITS = 400                # of a number: the largest float has 309
NOT_YAML = (yaml.YAMLError, ValueError, LookupError, ArithmeticError)


# -- files -----------------------------------------------------------------------------------

def opened(path: Path) -> BinaryIO:
    """
    Open a regular file for reading; what has no end, or waits for a writer, is refused at once.

    Raises
    ------
    BadInput
        If it is a pipe, a device, a socket or a folder.
    OSError
        If it cannot be opened.
    """
    handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)      # does not wait
    try:
        mode = os.fstat(handle).st_mode
        if stat.S_ISDIR(mode):
            raise IsADirectoryError(21, 'Is a directory')
        if not stat.S_ISREG(mode):
            raise BadInput(f'{path} is a pipe or a device: give a file')
        return os.fdopen(handle, 'rb')
    except BaseException:
        os.close(handle)
        raise


def bytes_of(path: str | Path, what: str, most: int = MAX_TABLE_BYTES) -> bytes:
    """
    Return the content of a file.

    Parameters
    ----------
    path : str or Path
        Of the file.
    what : str
        What it is to be, for a refusal: 'scenario'.
    most : int
        Largest size [B].

    Raises
    ------
    BadInput
        If it cannot be read, is no regular file or too large.
    """
    path = Path(path)
    try:
        with opened(path) as file:
            data = file.read(most + 1)
    except (OSError, ValueError) as error:      # a name with a zero in it is a ValueError
        if isinstance(error, BadInput):
            raise BadInput(f'{path} is a pipe or a device: give the {what} as a file') from None
        why = getattr(error, 'strerror', None) or error
        raise BadInput(f'cannot read {what} {path}: {why}') from None
    if len(data) > most:
        raise BadInput(f'{path} is larger than {size_in_words(most)}: that is no {what}')
    return data


def size_in_words(size: int) -> str:
    """Return a size [B] as people say it."""
    return f'{size >> 20} MiB' if size >= 1 << 20 else f'{size >> 10} KiB'


def text_of(path: str | Path, what: str, most: int = MAX_BYTES) -> str:
    """Return a text file in UTF-8; parameters and errors as `bytes_of`."""
    try:
        return bytes_of(path, what, most).decode('utf-8')
    except UnicodeDecodeError:
        raise BadInput(f'{path} is not a text file: save it as UTF-8') from None


# -- JSON ------------------------------------------------------------------------------------

def json_of(path: str | Path, what: str, most: int = MAX_JSON_BYTES) -> Any:
    """Return what a JSON file holds; parameters and errors as `bytes_of`."""
    return json_in(text_of(path, what, most), str(path))


def object_of(path: str | Path, what: str, most: int = MAX_JSON_BYTES) -> dict[str, Any]:
    """Return the object that a JSON file holds; parameters and errors as `bytes_of`."""
    content = json_of(path, what, most)
    if not isinstance(content, dict):
        raise BadInput(f'{path} is damaged: it holds no object')
    return content


def json_in(text: str, where: str) -> Any:
    """Return what a JSON text holds, or refuse it by `where` it was."""
    try:
        return json.loads(text, object_pairs_hook=_unique)
    except RecursionError:
        raise BadInput(f'{where} is damaged: it is nested too deeply') from None
    except ValueError as error:                 # of JSON or of numbers that nobody can mean
        raise BadInput(f'{where} is damaged: {error}') from None


def has_shape(content: Any, shape: Any) -> bool:
    """
    Say whether what JSON holds has a shape.

    Parameters
    ----------
    content : object
        As `json_of` returns it.
    shape : type, tuple of types, list or dict
        A list has what each element is, and how many there are if that is given; a dict has what
        its keys hold, of which those that end in `?` may be missing, and `''` stands for all
        others.
    """
    if isinstance(shape, dict):
        known = {key.removesuffix('?'): value for key, value in shape.items()}
        return isinstance(content, dict) and all(
            key in content for key in shape if key and not key.endswith('?')) and all(
            has_shape(value, known[key] if key in known else known['']) for key, value in
            content.items() if key in known or '' in known)
    if isinstance(shape, list):
        return (isinstance(content, list) and (len(shape) == 1 or len(content) == shape[1])
                and all(has_shape(element, shape[0]) for element in content))
    return isinstance(content, shape) and not (isinstance(content, bool) and shape != bool)


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made = dict(pairs)
    if len(made) < len(pairs):
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))
        raise ValueError(f'key given twice: {twice}')
    return made


# -- tables ----------------------------------------------------------------------------------

def rows_of(text: str, where: str) -> Iterator[tuple[int, list[str]]]:
    """Yield the number of the line and the cells of each row of a CSV text, or refuse it."""
    rows = csv.reader(StringIO(text, newline=''))
    try:
        for row in rows:
            yield rows.line_num, row
    except csv.Error as error:
        raise BadInput(f'{where}, line {rows.line_num}: not CSV: {error}') from None


# -- YAML ------------------------------------------------------------------------------------

class NotYaml(BadInput):
    """A text that is no YAML at all."""


class _Loader(yaml.SafeLoader):
    """
    Refuses what a file of ours never needs: anchors (bombs), tags, keys given twice, and numbers
    that YAML 1.1 does not take as they are written: 1:30 is 90 to it, and 010 is 8.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._values = self._depth = 0

    def compose_node(self, parent: Any, index: Any) -> Any:
        event = self.peek_event()
        if isinstance(event, yaml.events.AliasEvent) or event.anchor is not None:
            raise BadInput('anchors and aliases are not allowed')
        if event.tag not in (None, '!'):
            raise yaml.constructor.ConstructorError(
                None, None, f'tags such as {event.tag} are not allowed', event.start_mark)
        self._values += 1
        if self._values > MAX_VALUES:
            raise BadInput(f'more than {MAX_VALUES} keys and values')
        if self._depth > MAX_DEPTH + 3:         # three lead to the keys of a node
            raise BadInput(f'nested deeper than {MAX_DEPTH}')
        self._depth += 1
        made = super().compose_node(parent, index)
        self._depth -= 1
        return made

    def construct_mapping(self, node: Any, deep: bool = False) -> dict:
        seen, twice = set(), set()
        for key, _ in node.value:
            if isinstance(key, yaml.ScalarNode):
                (twice if key.value in seen else seen).add(key.value)
        if twice:
            raise BadInput(f'line {node.start_mark.line + 1}: key given twice: '
                           f'{", ".join(sorted(twice))}')
        return super().construct_mapping(node, deep)

    def construct_number(self, node: Any) -> int | float:
        if len(node.value) > MAX_DIGITS:
            raise BadInput(f'line {node.start_mark.line + 1}: a number of {len(node.value)} '
                           f'characters; {MAX_DIGITS} are the most')
        plain = node.tag.endswith(':int')
        value = self.construct_yaml_int(node) if plain else self.construct_yaml_float(node)
        if ':' in node.value or plain and re.match(r'[-+]?0[0-9_]', node.value):
            raise BadInput(f'line {node.start_mark.line + 1}: {node.value} would be read as '
                           f'{value}: write the number in decimal')
        return value


for _tag in ('int', 'float'):
    _Loader.add_constructor(f'tag:yaml.org,2002:{_tag}', _Loader.construct_number)


def value_of(text: str) -> Any:
    """
    Return the value that a text is as YAML, read as in a scenario file.

    Raises
    ------
    BadInput
        If it is none; the text says why in a few words.
    """
    if len(text) > MAX_BYTES:
        raise BadInput(f'larger than {size_in_words(MAX_BYTES)}')
    try:
        return yaml.load(text, Loader=_Loader)  # noqa: S506 - a SafeLoader
    except BadInput:
        raise
    except RecursionError:
        raise BadInput(f'nested deeper than {MAX_DEPTH}') from None
    except NOT_YAML as error:
        raise NotYaml(f'not valid YAML: {" ".join(str(error).split())}') from None


def mapping_of(text: str, what: str) -> dict:
    """Return the mapping that a YAML text holds, or refuse it in one line."""
    try:
        tree = value_of(text)
    except NotYaml as error:
        raise BadInput(f'{what} is {error}') from None
    except BadInput as error:
        raise BadInput(f'{what}: {error}') from None
    if not isinstance(tree, dict):
        raise BadInput(f'{what} is empty or not a mapping')
    return tree
