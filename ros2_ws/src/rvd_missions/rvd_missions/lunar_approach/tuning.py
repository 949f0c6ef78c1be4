"""
Tune the laws that fly the approach, each with the same care: one cost, one budget, the same runs.

    ./rvd shell python -m rvd_missions.lunar_approach.tuning [LAW ...]

Cost        mean over all runs, flown with pilot A in eq. 25 and by the law alone, of
            delta-v/0.5 m/s + duration/120 s + offset at docking/0.3 m;
            a run that fails costs 10.
Search      random points, uniform in the logarithm of each number over its range, then rounds of
            points around the best so far in a range that shrinks, all of that from several starts.
            The number of points is the same for each law, however many numbers it has.
Tied        safe_apf and odrrca want CLOSING_M_S at the start, START_M before the docking plane:
            that fixes the slope of the speed corridor, and k. Other numbers are as in FIXED.
Chance      seeds of their own: no campaign uses SEED.
"""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.in_process import draw, fly
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_missions.lunar_approach import MISSION

SEED = 109
RUNS = 200                              # with the pilot, and as many without
STARTS, FIRST, ROUNDS, EACH = 2, 60, 6, 15          # points: at random, then about the best
SHRINK = 0.6                            # of the range in each round
FAILED = 10.0
CLOSING_M_S, START_M = 0.25, 30.0
PAPER = {'in_flight': 'as_sent', 'filter': 'scheduled', 'prior': 'kalman'}      # its predictor
RANGES = {                              # lowest and highest value of each number
    'corridor_apf': {
        'lambda_1_m3_s2': (1e-5, 1e-2), 'lambda_2_m_s2': (1e-4, 0.05),
        'least_distance_m': (0.01, 0.3)},
    'damped_apf': {
        'lambda_1_m3_s2': (1e-5, 1e-2), 'lambda_2_m_s2': (1e-4, 0.05), 'band_m': (0.1, 2.0),
        'damping_per_s': (0.03, 3.0)},
    'barrier': {'margin_fraction': (0.05, 1.0), 'coast_s': (1.0, 60.0)},
    'safe_apf': {
        'aim.beyond_m': (1.0, 60.0), 'speed_corridor.contact_speed_m_s': (0.01, 0.245),
        'response_s': (0.1, 10.0)},
    'odrrca': {
        'aim.beyond_m': (3.0, 300.0), 'q': (1e3, 3e5), 'q1': (30.0, 3e3),
        'rate_gain_per_s': (0.02, 2.0)},
}
FIXED: dict[str, dict[str, Any]] = {
    'safe_apf': {'max_speed_m_s': CLOSING_M_S, 'slowing_per_m': 1.0,
                 'speed_corridor.form': 'linear', 'contact_m': 0.0},
    'odrrca': {'form': 'r1', 'k1': 0.0, 'ff': 'on'},
}


def settings_at(law: str, place: NDArray) -> dict[str, Any]:
    """Return the settings of a law at a place of the unit cube, those that are tied included."""
    found = {name: _rounded(low * (high/low)**x) for x, (name, (low, high)) in
             zip(place, RANGES[law].items(), strict=True)}
    return tied(law, {**FIXED.get(law, {}), **found})


def tied(law: str, found: dict[str, Any]) -> dict[str, Any]:
    """Return settings with those that follow from them."""
    if law == 'barrier':
        return {'margin_fraction': found['margin_fraction'], 'coasts_s': [0.0, found['coast_s']]}
    if law == 'safe_apf':
        rest = CLOSING_M_S - found['speed_corridor.contact_speed_m_s']
        slope = rest / (START_M + found['aim.beyond_m'])
        return {**found, 'speed_corridor.slope_per_s': _rounded(slope)}
    if law == 'odrrca':
        n = OrbitParams().mean_motion
        return {**found, 'k': _rounded(-CLOSING_M_S / (n * (START_M + found['aim.beyond_m'])))}
    return found


def _rounded(value: float) -> float:
    """Return a number with three digits: what is flown is what is written down."""
    return float(f'{value:.3g}')


def base() -> tuple[Scenario, Scenario]:
    """Return the scenarios that are tuned on: with the pilot, and the law alone."""
    link = {'model': 'gamma'}
    shared = Scenario('tuning', MISSION, {
        '/**': {'seed': SEED, 'mode': 'shared', 'operator': 'model'},
        'link_forward': link, 'link_back': link, 'state_predictor': PAPER}).check()
    return shared, shared.with_values('/**', mode='auto', operator='none')


class Bench:
    """The same runs for every law; what chance does in them is drawn once."""

    def __init__(self, scenarios: tuple[Scenario, ...], runs: int = RUNS) -> None:
        self._runs = range(runs)
        self._flown = [(s, draw(s, self._runs, whole=True)) for s in scenarios]

    def costs(self, law: str, found: dict[str, Any]) -> list[NDArray]:
        """Return the costs (runs,) of a law in each scenario."""
        return [self._cost(with_law(s, law, found), draws) for s, draws in self._flown]

    def cost(self, law: str, found: dict[str, Any]) -> float:
        """Return the mean cost of a law."""
        return float(np.mean(self.costs(law, found)))

    def _cost(self, scenario: Scenario, draws: Any) -> NDArray:
        v = fly(scenario, self._runs, draws=draws).verdict
        each = (v.values['delta_v_m_s']/0.5 + v.duration/120.0 + v.values['offset_m']/0.3)
        return np.where(v.success, each, FAILED)


def with_law(scenario: Scenario, law: str, found: dict[str, Any]) -> Scenario:
    """Return a scenario that is flown with a law and its settings by dotted key."""
    keys = {f'{law}__{key.replace(".", "__")}': value for key, value in found.items()}
    return scenario.with_values('auto_controller', law=law, **keys)


def search(cost: Callable[[NDArray], float], size: int, chance: np.random.Generator) -> NDArray:
    """Return the best place found in the unit cube."""
    best, least = np.full(size, 0.5), np.inf
    for stage in range(ROUNDS + 1):
        width, middle = (SHRINK**stage, best) if stage else (1.0, np.full(size, 0.5))
        for _ in range(EACH if stage else FIRST):
            place = np.clip(middle + width*(chance.random(size) - 0.5), 0.0, 1.0)
            found = cost(place)
            if found < least:
                best, least = place, found
    return best


def tuned(law: str, bench: Bench, start: int) -> dict[str, Any]:
    """Return the best settings of a law from one start."""
    chance = streams.generator(SEED, start, f'lunar_approach/tuning/{law}')
    best = search(lambda place: bench.cost(law, settings_at(law, place)), len(RANGES[law]), chance)
    return settings_at(law, best)


def main(laws: list[str]) -> None:
    """Tune laws; print, for the settings before and after, the costs and the failures."""
    bench = Bench(base())
    for law in laws or RANGES:
        _say(bench, law, 'defaults', {})
        for start in range(STARTS):
            what = f'start {start}, {FIRST + ROUNDS*EACH} points'
            _say(bench, law, what, tuned(law, bench, start))


def _say(bench: Bench, law: str, what: str, found: dict[str, Any]) -> None:
    costs = bench.costs(law, found)
    each = ', '.join(f'{name} {cost.mean():.3f} ({int((cost == FAILED).sum())} fail)'
                     for name, cost in zip(('with pilot', 'alone'), costs))
    print(f'{law}: {what}: cost {np.mean(costs):.4f}: {each}: '
          + ', '.join(f'{name} {value}' for name, value in found.items()), flush=True)


if __name__ == '__main__':
    main(sys.argv[1:])
