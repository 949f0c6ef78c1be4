"""
Tune the laws, each with the same care: one cost, one budget, the same runs.

    ./rvd shell python -m rvd_missions.attitude_hold.tuning [LAW ...]

Cost        mean over the nine pairs of faults, with and without a constant disturbance of
            DISTURBANCE_N_M, and over all runs, of
            overshoot/0.5 deg + final rms/0.01 deg + settling time/60 s;
            a run that is not held costs 10, one that never settles has taken until its end. Without
            the disturbance no cost would ask for an integral.
Search      random points, uniform in the logarithm of each parameter over its range, then rounds of
            points around the best so far in a range that shrinks. The number of points is the same
            for each law, however many parameters it has.
Chance      seeds of their own: no campaign uses SEED.
"""

import sys

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.in_process import draw, fly
from rvd_dynamics.diagram.scenario import Scenario
from rvd_missions.attitude_hold import MISSION

SEED = 101
RUNS = 6
DISTURBANCE_N_M = 0.001
FIRST, ROUNDS, EACH = 160, 5, 40        # points: at random, then rounds around the best
SHRINK = 0.5                            # of the range in each round
ACTUATOR, SENSOR = (0.4, 1.0, 2.5), (0.5, 1.0, 2.0)
NOT_HELD = 10.0
RANGES = {                              # lowest and highest value of each parameter
    'golden_section': {
        'softening': (0.01, 10.0), 'derivative_per_s': (1e-3, 3.0), 'dead_zone_deg': (5e-4, 0.2),
        'f_variance': (1e-6, 1.0), 'b_variance': (1e-2, 1e5), 'lowest_gain': (0.05, 1.0),
        'forgetting': (0.9, 0.9995)},
    'pid': {
        'proportional_per_s2': (3e-3, 2.0), 'integral_per_s3': (1e-6, 0.2),
        'derivative_per_s': (0.02, 4.0), 'filter_s': (1e-3, 5.0),
        'integral_limit_deg_s': (0.05, 50.0)},
}
FROM_ONE = {'forgetting'}               # searched as the distance from 1


def cases(scenario: Scenario) -> list[Scenario]:
    """Return the scenario with each pair of faults, undisturbed and disturbed."""
    return [scenario.with_values('/**', faults__actuator_gain=a, faults__sensor_gain=s).with_values(
                'attitude_dynamics', disturbance_n_m=torque)
            for a in ACTUATOR for s in SENSOR for torque in (0.0, DISTURBANCE_N_M)]


def cost(scenario: Scenario, runs: int = RUNS) -> float:
    """Return the cost of a scenario's law over all cases."""
    chosen, found, draws = range(runs), [], None
    for case in cases(scenario):
        draws = draw(case, chosen, whole=True) if draws is None else draws
        verdict = fly(case, chosen, draws=draws).verdict
        v = verdict.values
        settling = np.where(np.isfinite(v['settling_s']), v['settling_s'],
                            scenario.run.timeout_s - scenario.part('attitude').step_at_s)
        each = v['overshoot_deg']/0.5 + v['rms_final_deg']/0.01 + settling/60.0
        found.append(np.where(verdict.success, each, NOT_HELD))
    return float(np.mean(found))


def values(law: str, place: NDArray) -> dict[str, float]:
    """Return the parameters at a place of the unit cube."""
    made = {}
    for x, (name, (low, high)) in zip(place, RANGES[law].items(), strict=True):
        if name in FROM_ONE:
            low, high = 1.0 - low, 1.0 - high
        value = float(np.exp(np.log(low) + x*(np.log(high) - np.log(low))))
        made[name] = 1.0 - value if name in FROM_ONE else value
    return made


def tuned(law: str, first: int = FIRST, rounds: int = ROUNDS, each: int = EACH
          ) -> tuple[dict[str, float], float, int]:
    """Return the best parameters of a law, their cost, and how many points were looked at."""
    base = Scenario('tuning', MISSION, {
        '/**': {'timeout_s': 300.0, 'seed': SEED}, 'attitude_controller': {'law': law}}).check()
    chance = streams.generator(SEED, 0, f'attitude_hold/tuning/{law}')
    size = len(RANGES[law])
    best, least, looked = np.full(size, 0.5), np.inf, 0
    for stage in range(rounds + 1):
        width = 1.0 if stage == 0 else SHRINK**stage
        middle = np.full(size, 0.5) if stage == 0 else best
        for _ in range(first if stage == 0 else each):
            place = np.clip(middle + width*(chance.random(size) - 0.5), 0.0, 1.0)
            found = cost(base.with_values('attitude_controller', **{
                f'{law}.{name}': value for name, value in values(law, place).items()}))
            looked += 1
            if found < least:
                best, least = place, found
        print(f'{law}: {looked} points, cost {least:.4f}: ' + ', '.join(
            f'{name} {value:.4g}' for name, value in values(law, best).items()), flush=True)
    return values(law, best), least, looked


if __name__ == '__main__':
    for asked in sys.argv[1:] or RANGES:
        tuned(asked)
