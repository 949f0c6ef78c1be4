"""
Finished runs for the page's review: their list, and the reader that is run for one of them.

A run's bag holds the truth, which the ground must not know: it is read by a process of its own,
`python -m rvd_campaign.report.replay`, whose output goes to the page as it is.
"""

import asyncio
from contextlib import suppress
from functools import lru_cache
import os
import sys
from pathlib import Path
from typing import Any

from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.given import has_shape, object_of
from rvd_groundstation.console.counted import BESIDE
from rvd_groundstation.console.reports import report_of

READER = (sys.executable, '-m', 'rvd_campaign.report.replay')
MOST_RUNS = 200                 # rows of the list, newest first
DEEPEST = 3                     # folders below the runs folder that are looked through
MAX_VERDICT_BYTES = 1 << 20      # [B] of a verdict.json: a few kilobytes
SHOWN = ('reason', 'success', 'mode', 'seed', 'operator', 'scenario', 'duration_s')
FLOWN = {'modes': {'': (int, float)}}   # of what was really flown, what is shown


def listing(runs: Path | None) -> list[dict[str, Any]]:
    """
    Return a row per finished run below `runs`, newest first.

    `ended` is when its verdict was written [s since 1970], `report` whether it has one, `modes`
    the share of the steps that was flown in each; the rest is what `verdict.json` says.
    """
    files = []
    if runs is None:
        return files
    for depth in range(1, DEEPEST + 1):
        for file in runs.glob('/'.join(['*'] * depth + ['verdict.json'])):
            with suppress(OSError):             # a link that leads nowhere, or gone meanwhile
                found = file.stat()
                files.append((found.st_mtime_ns, found.st_size, file))
    made = []
    for written_ns, size, file in sorted(files, reverse=True)[:MOST_RUNS]:
        said = _said(file, written_ns, size)
        if said is not None:
            name = str(file.parent.relative_to(runs))
            made.append({'name': name, 'ended': written_ns / 1e9,
                         'report': report_of(runs, name) is not None, **said})
    return made


@lru_cache(maxsize=2 * MOST_RUNS)
def _said(file: Path, written_ns: int, size: int) -> dict[str, Any] | None:
    """Return what is shown of a verdict; one that has not changed is not read again."""
    try:
        content = object_of(file, 'verdict', MAX_VERDICT_BYTES)
    except BadInput:
        return None
    flown = content.get('flown')
    modes = flown['modes'] if has_shape(flown, FLOWN) else {}
    return {**{key: content.get(key) for key in SHOWN},
            'modes': {mode: share for mode, share in modes.items() if mode not in BESIDE}}


async def load(runs: Path | None, name: str) -> bytes:
    """
    Return a finished run as JSON: run message, frames with truth, events, verdict.

    Raises
    ------
    FileNotFoundError
        If there is no such finished run below `runs`.
    BadInput
        If its bag holds nothing that can be shown.
    """
    if runs is None or name.startswith('-') or '\0' in name:
        raise FileNotFoundError(name)
    reader = await asyncio.create_subprocess_exec(
        *READER, str(runs), name, stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
        env={**os.environ, lifeline.PARENT: str(os.getpid())})  # it ends with this process
    try:
        body, complaint = await reader.communicate()
    finally:
        with suppress(ProcessLookupError):
            if reader.returncode is None:       # nobody waits for it any more
                reader.kill()
    if reader.returncode == 1:
        raise FileNotFoundError(name)
    if reader.returncode != 0:
        words = complaint.decode(errors='replace').strip().rsplit('\n', 1)[-1]
        raise BadInput(words if reader.returncode > 0 and words else
                       f'its reader was ended by signal {-reader.returncode}: the bag takes too '
                       'long or too much memory')
    return body
