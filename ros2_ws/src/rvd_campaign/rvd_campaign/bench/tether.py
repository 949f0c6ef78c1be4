"""
The tethered gripper: how long a plan takes, how many closed-loop runs a core flies, and how fast
the graph is. Compilation and imports do not count.
"""

import time
from itertools import product

from rvd_campaign import catalogue
from rvd_campaign.bench import pace
from rvd_campaign.bench.laws import Goal
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario

BATCH = 400
SPEED_M_S, ANGLE_RAD = 0.01, 0.005      # changes after which the plan is made again

GOALS = {
    'plan_s': Goal('plan on 40 nodes, solver built', 's', high=2.0),
    'plan_build_s': Goal('  of it building the solver', 's'),
    'replan_s': Goal('again after 1 cm/s and 5 mrad, slowest of eight', 's', high=0.3),
    'replan_mean_s': Goal('  their mean', 's'),
    'runs_per_core_s': Goal(f'closed-loop runs of 100 s per core-second, batch of {BATCH}',
                            low=60),
    'one_real_time': Goal('fly tether in one process, times real time, start included', low=5),
    'segments_real_time': Goal('fly tether in segments, times real time, start included', low=1),
    **pace.goals(100),
}


def measure(quick: bool = False) -> dict[str, float]:
    """Return all figures by name."""
    scenario = load(catalogue.find('scenarios', 'tether', ('.yaml',)))
    fly(scenario.with_values('/**', step_s=0.1), [0])
    made = {**_plans(scenario), 'runs_per_core_s': _rate(scenario, 50 if quick else BATCH)}
    if not quick:
        made |= {f'{processes}_real_time': pace.times_real_time(
            'tether', scenario.run.timeout_s, processes) for processes in ('one', 'segments')}
        made |= pace.in_real_time('tether')
    return made


def _plans(scenario: Scenario) -> dict[str, float]:
    """Return times [s] of a plan from nothing, and of others from it."""
    from rvd_missions.tether import optimum
    p = scenario.part('preparation')
    parts = p.orbit, p.gripper, p.tether, p.approach, p.planner
    optimum.solver.cache_clear()
    optimum.plan.cache_clear()
    begun = time.perf_counter()
    solver = optimum.solver(*parts)
    built = time.perf_counter() - begun
    plan = optimum.plan(*parts)
    whole = time.perf_counter() - begun

    def again(signs: tuple) -> float:
        start = p.approach.initial(p.orbit.at(0.0).rate)
        start[3:6] += [SPEED_M_S*sign for sign in signs]
        start[6:9] += [ANGLE_RAD*sign for sign in reversed(signs)]
        begun = time.perf_counter()
        solver.solve(start, optimum.ENDS, p.approach.duration_s, guess=plan, warm=True)
        return time.perf_counter() - begun
    again((0, 0, 0))                            # builds the solver for starts from a plan
    times = [again(signs) for signs in product((-1, 1), repeat=3)]
    return {'plan_s': whole, 'plan_build_s': built, 'replan_s': max(times),
            'replan_mean_s': sum(times)/len(times)}


def _rate(scenario: Scenario, batch: int) -> float:
    """Return closed-loop runs per second of CPU, draws included."""
    begun = time.process_time()
    fly(scenario, range(batch))
    return batch/(time.process_time() - begun)
