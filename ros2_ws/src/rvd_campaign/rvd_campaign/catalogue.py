"""
What there is to choose from: installed missions; laws, scenarios, tapes and campaigns as shipped.
"""

import os
from pathlib import Path
from typing import Iterator

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.given import MAX_TABLE_BYTES, text_of


def root() -> Path:
    """
    Return the project folder: `RVD_ROOT`, which `./rvd` sets, or the folder above this file.

    Raises
    ------
    ValueError
        If neither holds the shipped scenarios.
    """
    given = os.environ.get('RVD_ROOT')
    candidates = [Path(given)] if given else list(Path(__file__).resolve().parents)
    for folder in candidates:
        if (folder / 'scenarios').is_dir() and (folder / 'scripts' / 'bringup.sh').is_file():
            return folder
    raise BadInput('cannot find the project folder: set RVD_ROOT to it')


def find(kind: str, name: str, suffixes: tuple[str, ...]) -> Path:
    """
    Return the file that `name` means: a path as it is, or a shipped one by its bare name.

    Raises
    ------
    ValueError
        If there is no such file; the text lists what is shipped.
    """
    path = Path(name)
    if os.path.isfile(path) or '' in suffixes and os.path.isdir(path):      # a tape may be a folder
        return path
    for suffix in suffixes:
        shipped = root() / kind / f'{name}{suffix}'
        if os.path.exists(shipped):
            return shipped
    names = ', '.join(n for n, _ in entries(kind))
    raise BadInput(f'no {kind[:-1]} {name[:200]!r}: give a file or one of {names}')


def entries(what: str) -> Iterator[tuple[str, str]]:
    """Yield (name, meaning) of the missions, laws, scenarios, tapes or campaigns."""
    if what == 'missions':
        from rvd_dynamics.diagram import mission
        for name in mission.installed():
            try:
                yield name, mission.find(name).title.rstrip('.')
            except BadInput as error:         # one that is broken hides no other
                yield name, f'({error})'
        return
    if what == 'laws':
        from rvd_groundstation.guidance import LAWS
        from rvd_missions.attitude_hold.laws import LAWS as HOLDING
        for name, law in LAWS.items():
            yield name, _first_paragraph(law.__doc__)
        for name, law in HOLDING.items():
            yield name, f'{_first_paragraph(law.__doc__)} (attitude_hold)'
        return
    for path in sorted((root() / what).iterdir()):
        if path.suffix in ('.yaml', '.csv') or (path / 'metadata.yaml').exists():
            yield path.stem, _first_comment(path)


def _first_paragraph(doc: str | None) -> str:
    return ' '.join((doc or '').strip().split('\n\n')[0].split()).rstrip('.')


def _first_comment(path: Path) -> str:
    if path.is_dir():
        return 'rosbag2 bag'
    try:
        line = text_of(path, 'list entry', MAX_TABLE_BYTES).partition('\n')[0]
    except BadInput as error:
        return f'({error})'
    return line.lstrip('# ').strip() if line.startswith('#') else ''
