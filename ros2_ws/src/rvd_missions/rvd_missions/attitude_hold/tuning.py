"""
Tune the laws, each with the same care: one cost, one budget, the same runs.

    ./rvd shell python -m rvd_missions.attitude_hold.tuning [LAW ...]

Cost        mean over the nine pairs of faults, with and without a constant disturbance of
            DISTURBANCE_N_M, and over all runs, of
            overshoot/0.5 deg + final rms/0.01 deg + settling time/60 s;
            a run that is not held costs 10, one that never settles has taken until its end. Without
            the disturbance no cost would ask for an integral.
Search      random points, uniform in the logarithm of each parameter over its range, then rounds of
            points around the best so far in a range that shrinks, all of that from several starts.
            The number of points is the same for each law, however many parameters it has.
Range       the dead zone starts at five deviations of the residual that noise alone makes: runs of
            300 s would not punish a smaller one, with which the gain drifts within the hour.
Chance      seeds of their own: no campaign uses SEED.
"""

import sys
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.diagram.scenario import Scenario
from rvd_missions.attitude_hold import MISSION
from rvd_missions.attitude_hold.control import Control
from rvd_missions.attitude_hold.judge import Judge
from rvd_missions.attitude_hold.laws import Law, LAWS
from rvd_missions.attitude_hold.settings import Faults, first_step
from rvd_missions.attitude_hold.signals import THRUST
from rvd_missions.attitude_hold.space import AttitudeDynamics, AttitudeSensors

SEED = 101
RUNS = 12
DISTURBANCE_N_M = 0.001
STARTS, FIRST, ROUNDS, EACH = 2, 160, 8, 30        # points: at random, then about the best
SHRINK = 0.6                            # of the range in each round
ACTUATOR, SENSOR = (0.4, 1.0, 2.5), (0.5, 1.0, 2.0)
NOT_HELD = 10.0
RANGES = {                              # lowest and highest value of each parameter
    'golden_section': {
        'softening': (1e-3, 10.0), 'derivative_per_s': (1e-4, 3.0), 'dead_zone_deg': (0.01, 0.2),
        'f_variance': (1e-7, 1.0), 'b_variance': (1e-2, 1e5), 'lowest_gain': (0.05, 1.0),
        'forgetting': (0.9, 0.9999)},
    'pid': {
        'proportional_per_s2': (3e-3, 2.0), 'integral_per_s3': (1e-6, 0.2),
        'derivative_per_s': (0.02, 4.0), 'filter_s': (1e-3, 5.0),
        'integral_limit_deg_s': (0.05, 50.0)},
}
FROM_ONE = {'forgetting'}               # searched as the distance from 1


class Case(NamedTuple):
    """What one block of rows meets."""

    actuator_gain: float
    sensor_gain: float
    disturbance_n_m: float = 0.0


CASES = tuple(Case(a, s, torque) for a in ACTUATOR for s in SENSOR
              for torque in (0.0, DISTURBANCE_N_M))


class FaultsOfRows:
    """Faults whose gains differ from row to row; their instants are those of `faults`."""

    def __init__(self, faults: Faults, actuator: NDArray, sensor: NDArray) -> None:
        self._faults, self._actuator, self._sensor = faults, actuator, sensor
        self.first_at_s = faults.first_at_s

    def actuator(self, k: int, step_s: float) -> NDArray:
        """Return the gain (N, 1) of the actuator in step k."""
        faulty = k >= first_step(self._faults.actuator_at_s, step_s)
        return np.where(faulty, self._actuator, 1.0)[:, np.newaxis]

    def sensor(self, k: int, step_s: float) -> NDArray:
        """Return the gain (N,) of the sensors in step k."""
        return np.where(k >= first_step(self._faults.sensor_at_s, step_s), self._sensor, 1.0)


class Bench:
    """
    All cases in one batch, a block of rows for each: the blocks of the mission strung together.

    A row is equal to the same run of the case flown by `diagram.in_process`, a law on board.
    """

    def __init__(self, base: Scenario, cases: tuple[Case, ...] = CASES, runs: int = RUNS) -> None:
        self._base, self._runs, self._rows = base, runs, len(cases)*runs
        part, seed, steps = base.part, base.run.seed, base.run.last_step + 1
        draws = base.diagram.by_name
        self._scatter = np.tile(draws['attitude_dynamics'].draws['scatter'].of_runs(
            seed, range(runs), steps), (len(cases), 1))
        self._noise = np.tile(draws['attitude_sensors'].draws['noise'].of_runs(
            seed, range(runs), steps), (len(cases), 1, 1))
        actuator, sensor, torque = (np.repeat(column, runs) for column in np.array(cases).T)
        self._faults: Any = FaultsOfRows(part('faults'), actuator, sensor)
        given = base.settings('attitude_dynamics')
        self._start: Any = SimpleNamespace(**{**vars(given), 'disturbance_n_m': torque[:, None]})

    def fly(self, law: Law) -> Verdict:
        """Return the verdict on all rows with a law."""
        part, run, batch = self._base.part, self._base.run, (self._rows,)
        plant = AttitudeDynamics(self._start, run, part('craft'), self._faults, part('attitude'),
                                 part('limits'), self._scatter, batch)
        sensors = AttitudeSensors(self._base.settings('attitude_sensors'), run, self._faults,
                                  self._noise)
        control = Control(law, part('form'), part('attitude'), run.step_s, 0, batch)
        judge = Judge(run, part('attitude'), self._faults, part('limits'), batch)
        always, thrust = np.ones(batch, dtype=bool), THRUST.initial(batch)
        for k in range(run.last_step + 1):
            truth = plant.step(k, thrust)['truth']
            judge.follow(k, truth)
            angle = sensors.step(k, truth)['measurement'].state[..., 0]
            thrust = THRUST(command=control.command(k, angle, always))
        return judge.verdict()

    def cost(self, law: Law) -> float:
        """Return the mean cost of a law over all rows."""
        verdict = self.fly(law)
        v, run = verdict.values, self._base.run
        left = run.timeout_s - self._base.part('attitude').step_at_s
        settling = np.where(np.isfinite(v['settling_s']), v['settling_s'], left)
        each = v['overshoot_deg']/0.5 + v['rms_final_deg']/0.01 + settling/60.0
        return float(np.mean(np.where(verdict.success, each, NOT_HELD)))


def values(law: str, place: NDArray) -> dict[str, float]:
    """Return the parameters at a place of the unit cube."""
    made = {}
    for x, (name, (low, high)) in zip(place, RANGES[law].items(), strict=True):
        if name in FROM_ONE:
            low, high = 1.0 - low, 1.0 - high
        value = float(np.exp(np.log(low) + x*(np.log(high) - np.log(low))))
        made[name] = 1.0 - value if name in FROM_ONE else value
    return made


def tuned(law: str, bench: Bench, start: int, first: int = FIRST, rounds: int = ROUNDS,
          each: int = EACH) -> tuple[dict[str, float], float]:
    """Return the best parameters of a law from one start, and their cost."""
    chance = streams.generator(SEED, start, f'attitude_hold/tuning/{law}')
    size = len(RANGES[law])
    best, least = np.full(size, 0.5), np.inf
    for stage in range(rounds + 1):
        width, middle = (SHRINK**stage, best) if stage else (1.0, np.full(size, 0.5))
        for _ in range(each if stage else first):
            place = np.clip(middle + width*(chance.random(size) - 0.5), 0.0, 1.0)
            found = bench.cost(LAWS[law](**values(law, place)))
            if found < least:
                best, least = place, found
    return values(law, best), least


def base() -> Scenario:
    """Return the scenario that is tuned on."""
    return Scenario('tuning', MISSION, {'/**': {
        'timeout_s': 300.0, 'seed': SEED, 'law_runs': 'onboard'}}).check()


if __name__ == '__main__':
    everything = Bench(base())
    for asked in sys.argv[1:] or RANGES:
        for at in range(STARTS):
            parameters, cost = tuned(asked, everything, at)
            print(f'{asked}: start {at}, {FIRST + ROUNDS*EACH} points, cost {cost:.4f}: '
                  + ', '.join(f'{n} {v:.4g}' for n, v in parameters.items()), flush=True)
