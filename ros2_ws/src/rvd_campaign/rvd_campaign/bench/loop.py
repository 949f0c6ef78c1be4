"""
The in-process loop of the default scenario: one run alone, the price of a run in a batch, and that
of a scenario with one key changed, of which a campaign makes thousands.
"""

import time
from collections.abc import Callable, Sequence
from typing import Any

from rvd_campaign import catalogue
from rvd_dynamics.diagram.in_process import Batch, fly
from rvd_dynamics.diagram.scenario import load, Scenario

MAX_ALONE_S = 0.2
MAX_SCENARIO_MS = 0.3
SCENARIOS = 200                 # that are made to time one
CHANGES = (('/**', 'seed', int), ('/**', 'orbit.radius_m', lambda i: 1.9e6 + i),
           ('command_blender', 'eq25.eta', lambda i: i / SCENARIOS),
           ('link_forward', 'loss_fraction', lambda i: i / SCENARIOS))
BATCH = 1000


def measure(repeats: int = 5, batch: int = BATCH) -> dict:
    """
    Fly run 0 `repeats` times after a first one, then `batch` runs at once; return the times.

    The best of the repeats counts: the loop waits for nothing, so what is above it is other work
    on the machine.
    """
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    first, flown = _timed(paper, [0])
    alone = [_timed(paper, [0])[0] for _ in range(max(repeats, 1))]
    together, _ = _timed(paper, range(batch))
    return {'steps': int(flown.end_step[0]), 'alone_s': round(min(alone), 4),
            'first_s': round(first, 3), 'batch': batch,
            'batch_ms_per_run': round(1e3 * together / batch, 3),
            'scenario_ms': max(_scenario_ms(paper, *change) for change in CHANGES)}


def _scenario_ms(scenario: Scenario, section: str, key: str, value: Callable[[int], Any]) -> float:
    """Return the time to make a checked copy of a scenario with one key changed [ms]."""
    def once() -> float:
        begun = time.perf_counter()
        for i in range(SCENARIOS):
            scenario.with_values(section, **{key: value(i)})
        return 1e3 * (time.perf_counter() - begun) / SCENARIOS
    return round(min(once() for _ in range(5)), 4)


def _timed(scenario: Scenario, runs: Sequence[int]) -> tuple[float, Batch]:
    begun = time.perf_counter()
    flown = fly(scenario, runs)
    return time.perf_counter() - begun, flown
