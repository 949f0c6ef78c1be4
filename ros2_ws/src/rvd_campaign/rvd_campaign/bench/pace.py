"""How fast a flight over DDS is in lock step, and how well one in real time keeps the pace."""

import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from rvd_campaign.bench.laws import Goal
from rvd_dynamics.bad_input import BadInput

# What the plant says of itself at the end of a run: `PlantNode._pace_kept`.
KEPT = re.compile(r'(\d+) commands missing in (\d+) steps; .* ([\d.]+) ms at the 99th percentile')
SAID_CHARACTERS = 500


def goals(seconds: float) -> dict[str, Goal]:
    """Return what `in_real_time` measures in a mission that flies for so long."""
    return {'missed_steps': Goal(f'real time, segments: commands missed in {seconds:g} s', high=1),
            'late_p99_ms': Goal('  lateness of steps, 99th percentile', 'ms', high=5)}


def times_real_time(scenario: str, timeout_s: float, processes: str) -> float:
    """Return how many times real time a whole flight of `timeout_s` in lock step is."""
    begun = time.perf_counter()
    _flown(scenario, 'lockstep', processes)
    return timeout_s/(time.perf_counter() - begun)


def in_real_time(scenario: str) -> dict[str, float]:
    """Fly in real time with a process for each segment; return how well the pace was kept."""
    said = _flown(scenario, 'realtime', 'segments')
    kept = KEPT.search(said)
    if kept is None:
        raise BadInput(f'the flight did not say how it kept the pace: {said[-SAID_CHARACTERS:]}')
    return {'missed_steps': float(kept[1]), 'late_p99_ms': float(kept[3])}


def _flown(scenario: str, pace: str, processes: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, '-m', 'rvd_campaign.cli', 'fly', scenario, '--headless', '--pace',
             pace, '--processes', processes, '--out', str(Path(folder) / 'run')],
            stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1):           # 1: flown, without success
        done.check_returncode()
    return done.stdout
