"""
The digital spacecraft: how many times real time its plant, its closed loop and its graph are, in
few rows and in many, and how long the optimal plan takes. Compilation and imports do not count.
"""

import time
from itertools import product

import numpy as np

from rvd_campaign import catalogue
from rvd_campaign.bench import basilisk, pace
from rvd_campaign.bench.laws import Goal
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario

BATCH = 400                     # rows of a closed loop
PLANT_STEPS, PASSES = 100, 5     # the best pass counts: what others take away is not the plant's
NODES = 20
SPEED_M_S, ANGLE_RAD = 0.01, 0.005      # changes after which the plan is made again
FACES_M = 3.0                           # distance of the docking faces at the start
RUNS, RUN_S, CORES = 1000, 300.0, 2     # of the campaign that is estimated

GOALS = {
    'plant': Goal('plant alone, sub-steps of 2.5 ms, times real time', low=1500),
    'plant_one': Goal('  one row at a time'),
    'step_us': Goal('plant of two modes and two tanks, a row\'s step in a batch', 'us'),
    'basilisk_us': Goal('  the same craft in Basilisk', 'us'),
    'basilisk_ratio': Goal('  times as fast as Basilisk', low=10),
    'pinhole': Goal(f'closed loop, pinhole camera and PnP, batch of {BATCH}', low=100),
    'pinhole_one': Goal('  one run alone'),
    'simple': Goal(f'closed loop, simple camera, batch of {BATCH}', low=250),
    'simple_one': Goal('  one run alone'),
    'campaign_min': Goal(f'{RUNS:,} runs of {RUN_S:g} s on {CORES} cores by that rate', 'min',
                         high=15),
    'gauss_s': Goal(f'Gauss plan, K = {NODES}, cold', 's', high=0.3),
    'gauss_again_s': Goal('  again after 1 cm/s and 5 mrad, slowest of eight', 's', high=0.1),
    'one_real_time': Goal('fly docking in one process, times real time, start included', low=5),
    **pace.goals(300),
}


def measure(quick: bool = False) -> dict[str, float]:
    """Return all figures by name; times of the processor but for plans and flights."""
    scenario = load(catalogue.find('scenarios', 'docking', ('.yaml',)))
    made = _plant(scenario) | _basilisk(quick)
    for camera in ('pinhole', 'simple'):
        made |= {camera: _rate(scenario, camera, 20 if quick else BATCH, 1.0 if quick else 5.0),
                 f'{camera}_one': _rate(scenario, camera, 1, 2.0 if quick else 20.0)}
    made['campaign_min'] = RUNS*RUN_S/(CORES*made['simple']*60.0)
    made |= _plans()
    if not quick:
        made['one_real_time'] = pace.times_real_time('docking', scenario.run.timeout_s, 'one')
        made |= pace.in_real_time('docking')
    return {name: made[name] for name in GOALS if name in made}


def _plant(scenario: Scenario) -> dict[str, float]:
    """Return how many times real time the plant alone is, many rows and one."""
    craft, step = scenario.part('craft'), scenario.run.step_s
    sub_steps = scenario.settings('docking_dynamics').sub_steps
    made = {}
    for name, rows in (('plant', BATCH), ('plant_one', 1)):
        state = craft.state(rows, position=(-6.0, 0.2, -0.15))
        wrench = np.zeros((rows, 2*sub_steps + 1, 6))
        wrench[..., 0], wrench[..., 4] = 10.0, 0.1
        craft.advance(state, wrench, step)
        took = []
        for _ in range(PASSES):
            begun = time.process_time()
            for _ in range(PLANT_STEPS):
                state = craft.advance(state, wrench, step).state
            took.append(time.process_time() - begun)
        made[name] = rows*PLANT_STEPS*step/min(took)
    return made


def _basilisk(quick: bool) -> dict[str, float]:
    """Return the race against Basilisk; nothing, and say why, where it cannot be had."""
    try:
        return basilisk.race(1 if quick else 3)
    except basilisk.Unavailable as error:
        print(f'not raced: {error}', flush=True)
        return {}


def _rate(scenario: Scenario, camera: str, rows: int, seconds: float) -> float:
    """Return how many seconds of runs a second of the processor flies, draws included."""
    scenario = scenario.with_values('/**', seeing__camera=camera, timeout_s=seconds,
                                    limits__from_s=0.5*seconds)
    fly(scenario.with_values('/**', timeout_s=0.2, limits__from_s=0.1), [0])
    begun = time.process_time()
    fly(scenario, range(rows))
    return rows*seconds/(time.process_time() - begun)


def _plans() -> dict[str, float]:
    """Return times [s] of the Gauss plan from nothing with its solver built, and of others."""
    from rvd_groundstation.planning.closing.pseudospectral import Pseudospectral
    from rvd_groundstation.planning.closing.task import Ends
    start = np.array([-6.0, 0.20, -0.15, 0.0, 0.0, 0.0])
    end = np.array([-3.07, 0.0, 0.0, 0.0, 0.0, 0.0])
    planner = Pseudospectral(NODES)
    planner.plan(Ends(start, end))              # builds the solver
    begun = time.perf_counter()
    plan = planner.plan(Ends(start, end))
    made = {'gauss_s': time.perf_counter() - begun}

    def again(signs: tuple) -> float:
        other = start.copy()
        other[3:] = SPEED_M_S*np.array(signs)
        other[1:3] += ANGLE_RAD*FACES_M*np.array(signs[1:])     # seen from the port under an angle
        begun = time.perf_counter()
        planner.plan(Ends(other, end), plan)
        return time.perf_counter() - begun
    again((0, 0, 0))                            # builds the solver for starts from a plan
    return made | {'gauss_again_s': max(again(signs) for signs in product((-1, 1), repeat=3))}
