"""
A warm flight of the default scenario as a user starts it, and where its wall time goes: with a
process for each block, and with one for all.

The parts are read from what the run leaves: the first and the last truth in the bag carry the wall
time at which they were published, and `verdict.json` is written when every node has ended.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.recording.messages import files_of, MessageFile

TRUTH = '/truth/relative_state'
COMMAND = ('fly', '--headless', '--pace', 'lockstep')
ONE = (*COMMAND, '--processes', 'one')
MAX_WALL_S = {COMMAND: 10.0, ONE: 4.0}
PARTS = {'start_up_s': 'start-up', 'flight_s': 'flight', 'ending_s': 'ending',
         'report_s': 'report'}


def measure(repeats: int = 3) -> dict:
    """
    Fly each command `repeats` times after once to warm the machine up; return the figures.

    Raises
    ------
    ValueError
        If a flight cannot be flown; names what it said.
    """
    apart, together = (_timed(command, max(repeats, 1)) for command in (COMMAND, ONE))
    return {**apart, 'one': together}


def _timed(command: tuple[str, ...], repeats: int) -> dict:
    flights = [fly_once(command) for _ in range(1 + repeats)][1:]
    return {'command': ' '.join(('./rvd', *command)), 'flights': flights,
            'wall_s': median(f['wall_s'] for f in flights), 'limit_s': MAX_WALL_S[command]}


def fly_once(command: tuple[str, ...] = COMMAND) -> dict:
    """Fly once in a folder of its own; return the wall times [s]."""
    with tempfile.TemporaryDirectory(prefix='rvd-bench-') as top:
        run = Path(top) / 'run'
        begun, clock = time.time(), time.monotonic()
        done = subprocess.run(
            [sys.executable, '-m', 'rvd_campaign.cli', *command, '--out', str(run)],
            capture_output=True, text=True)
        wall, ended = time.monotonic() - clock, time.time()
        if done.returncode not in (0, 1):
            raise BadInput(f'the flight ended with code {done.returncode}: '
                           f'{done.stderr.strip()}')
        truths = published(run)
        judged = (run / 'verdict.json').stat().st_mtime
    return {'wall_s': round(wall, 2), 'steps': len(truths),
            'start_up_s': round(truths[0] - begun, 2),
            'flight_s': round(truths[-1] - truths[0], 2),
            'ending_s': round(judged - truths[-1], 2), 'report_s': round(ended - judged, 2)}


def published(run: Path) -> list[float]:
    """Return the wall times at which the truths of a run were published [s]."""
    return sorted(stored.publish_ns / NS_PER_S for file in files_of(run)
                  for stored in MessageFile(file, {TRUTH}))
