"""
Laws of the missions: how many run-steps of a batch a core flies in a second, and what the compiled
parts of them cost. Compilation does not count.

A mission adds a function that returns its figures to MEASURES, and their targets to GOALS.
"""

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from rvd_campaign import catalogue
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario

BATCH = 1000
ROWS = 2000                     # of random covariances
POINTS = 60                     # of a branch


class Goal(NamedTuple):
    """What a figure is called, and the bound that it is to keep."""

    words: str
    unit: str = ''
    low: float | None = None
    high: float | None = None


def measure(quick: bool = False) -> dict[str, float]:
    """Return all figures by name."""
    return {name: value for part in MEASURES for name, value in part(quick).items()}


def obstacles(quick: bool) -> dict[str, float]:
    """Fly three static obstacles with the spherical alarm; time one probability, and one flight."""
    scenario = load(catalogue.find('scenarios', 'obstacles', ('.yaml',)))
    scattered = scenario.with_values('spacecraft_dynamics', scatter__position_m=0.5)
    repeats, batch = (1, BATCH // 4) if quick else (3, BATCH)
    fly(scattered, [0])
    made = {'obstacle_steps_per_core_s': max(_rate(scattered, batch) for _ in range(repeats))}
    made |= _probability(repeats)
    if not quick:
        made['obstacle_flight_s'] = min(_flight_s() for _ in range(repeats))
    return made


def _rate(scenario: Scenario, batch: int) -> float:
    """Return run-steps per second of CPU, draws included."""
    begun = time.process_time()
    flown = fly(scenario, range(batch))
    return float((flown.end_step + 1).sum()) / (time.process_time() - begun)


def _probability(repeats: int) -> dict[str, float]:
    """Return the time of a probability [us], and the share of alarms that bounds decide."""
    from rvd_dynamics.geometry import collision
    offsets, covariances = _sample(ROWS)
    collision.probability(offsets[:1], covariances[:1], 1.6)
    collision.reaches(offsets[:1], covariances[:1], 1.6, 1e-4)

    def once(call: Callable[[], Any]) -> float:
        begun = time.process_time()
        call()
        return 1e6 * (time.process_time() - begun) / ROWS
    # within reach, where every row takes the whole quadrature
    near = offsets * (1.6 / np.linalg.norm(offsets, axis=1))[:, None]
    decided = collision.reaches(offsets, covariances, 1.6, 1e-4)
    return {
        'collision_us': min(once(lambda: collision.probability(near, covariances, 1.6))
                            for _ in range(repeats + 1)),
        'alarm_us': min(once(lambda: collision.reaches(offsets, covariances, 1.6, 1e-4))
                        for _ in range(repeats + 1)),
        'alarm_decided_by_bounds': 1.0 - float(decided.integrated.mean())}


def _sample(rows: int) -> tuple[np.ndarray, np.ndarray]:
    """Return offsets to 10 m and covariances of 0.1 to 1 m with ratios up to 5."""
    rng = np.random.default_rng(1)
    offsets = rng.normal(size=(rows, 3))
    offsets *= (rng.uniform(0.0, 10.0, rows) / np.linalg.norm(offsets, axis=1))[:, None]
    shortest = rng.uniform(0.1, 1.0, rows)
    longest = np.minimum(shortest * rng.uniform(1.0, 5.0, rows), 1.0)
    sigma = np.stack([shortest, rng.uniform(shortest, longest), longest], axis=1)
    axes, _ = np.linalg.qr(rng.normal(size=(rows, 3, 3)))
    made = (axes * sigma[:, None, :]**2) @ np.swapaxes(axes, 1, 2)
    return offsets, 0.5 * (made + np.swapaxes(made, 1, 2))


def _flight_s() -> float:
    """Return the wall time [s] of a whole flight over DDS in one process."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, '-m', 'rvd_campaign.cli', 'fly', 'obstacles', '--headless',
                   '--pace', 'lockstep', '--processes', 'one', '--out', str(Path(folder) / 'run')]
        begun = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - begun


def cycles(quick: bool) -> dict[str, float]:
    """Time limit cycles over eccentricities and gains, and a branch of POINTS points."""
    from rvd_missions.elliptic_rendezvous.gains import CycleCase
    from rvd_missions.elliptic_rendezvous.limit_cycles import cycle, follow
    cases = [CycleCase(law=law, e=e, k2=k2) for law in ('rrca', 'odrrca') for k2 in (0.0, -0.5)
             for e in ((0.1, ) if quick else (0.05, 0.1, 0.2, 0.3))]
    cycle(cases[0])
    follow(cases[0], 'e', 0.0, 0.01, 3)
    each = []
    for case in cases:
        begun = time.process_time()
        cycle(case)
        each.append(1e3 * (time.process_time() - begun))
    begun = time.process_time()
    branch = follow(CycleCase(form='r2', k1=0.5), 'e', 0.0, 0.9)    # through its fold
    spent = time.process_time() - begun
    return {'cycle_ms': float(np.mean(each)), 'cycle_slowest_ms': max(each),
            'branch_s': POINTS * spent / len(branch.at)}


def batches(quick: bool) -> dict[str, float]:
    """Fly the laws of the other missions in batches."""
    made = {}
    for name, section, keys in (
            ('ellipse', '/**', {'start__range_sigma_m': 100.0, 'timeout_s': 600.0}),
            ('attitude', 'attitude_controller', {})):
        scenario = load(catalogue.find('scenarios', name, ('.yaml',))).with_values(section, **keys)
        fly(scenario, [0])
        made[f'{name}_steps_per_core_s'] = _rate(scenario, BATCH // 4 if quick else BATCH)
    return made


MEASURES: tuple[Callable[[bool], dict[str, float]], ...] = (obstacles, batches, cycles)
GOALS = {
    'obstacle_steps_per_core_s': Goal(
        f'obstacles: run-steps per core-second, batch of {BATCH}', low=240_000),
    'ellipse_steps_per_core_s': Goal(f'ellipse: run-steps per core-second, batch of {BATCH}'),
    'attitude_steps_per_core_s': Goal(f'attitude: run-steps per core-second, batch of {BATCH}'),
    'collision_us': Goal('collision probability, any covariance', 'us', high=120),
    'alarm_us': Goal('  an alarm by it, with bounds first', 'us'),
    'alarm_decided_by_bounds': Goal('  share of alarms that bounds decide'),
    'obstacle_flight_s': Goal('fly obstacles --headless --pace lockstep --processes one', 's',
                              high=8),
    'cycle_ms': Goal('one limit cycle, mean over cases', 'ms', high=10),
    'cycle_slowest_ms': Goal('  the slowest of them', 'ms', high=10),
    'branch_s': Goal(f'a branch of limit cycles through a fold, for {POINTS} points', 's', high=2),
}
