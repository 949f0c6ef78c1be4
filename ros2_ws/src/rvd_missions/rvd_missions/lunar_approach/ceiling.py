"""
The physical ceilings: how many runs commands could have brought home at all.

There are two, for a ground that begins at t = 0 with a link that has not been running:
silent      it says nothing before it has seen telemetry: commands act from the loop delay on;
any         whatever it says, from t = 0 on: commands act one forward delay later. So what leaves
            the corridor between the two may be saved by a command that nobody has a reason for.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; one row per run.
Method  No guidance law, pilot, filter or prediction is asked. Each run has its true start, its
        true thrust noise and its true losses on the way up; before `first_step` no command
        can act. Then each run is decided by proof:
        outside   the start lies outside the corridor;
        left      it leaves the corridor while no command can act yet;
        refuted   a linear programme over thrust that may take any value up to the largest, on
                  all axes at once, finds no history that stays inside: it maximises the least
                  margin, with fewer demands than the corridor makes, so its answer is an
                  upper bound;
        docked    a history of whole levels was found under which the judge says docked. It was
                  flown by feedback of the true state without delay, which nobody has;
        open      neither was found.
        The ceiling lies between the share that docked and that share with the open ones.
Limits  the programme moves by Clohessy and Wiltshire: margins less than `SLACK_M` outside are
        not called refuted, which covers the difference to two bodies. Errors of the thrust that
        last for a burn depend on what was commanded before, so the programme has no bound for
        them: such scenarios are refused.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.in_process import check, fly, judge_of
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.geometry.cone import signed_distance
from rvd_dynamics.link.leg import LinkChance
from rvd_dynamics.motion import cw
from rvd_dynamics.world.plants.relative import TruthModel, TRUTH_MODELS
from rvd_dynamics.world.settings import DynamicsParams
from rvd_dynamics.world.spacecraft.thrusters import execute
from rvd_missions.lunar_approach import MISSION

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

HORIZON_STEPS = 60              # the programme looks so far: what is lost is lost early
SAMPLES_PER_STEP = 2            # instants at which it asks for the corridor
FACETS = 61                     # tangent planes of the cone, over a quarter turn either way
SLACK_M = 1e-5
BATCH = 2000                    # runs flown at once
# Ways to fly home with the true state in hand: time to return to the axis and time to take
# up a lateral rate [s], closing rate [m/s].
WAYS_HOME = ((8.0, 2.0, 0.25), (4.0, 1.0, 0.25), (20.0, 1.0, 0.25), (8.0, 1.0, 0.12))


class Ceiling(NamedTuple):
    """Which of N runs could have docked; each run is in exactly one of the five."""

    outside: Mask               # (N,) starts outside the corridor
    left: Mask                  # (N,) leaves before a command can act
    refuted: Mask               # (N,) no thrust history stays inside
    docked: Mask                # (N,) docks under a history that was found
    open: Mask                  # (N,) undecided

    @property
    def bounds(self) -> tuple[float, float]:
        """Share of the runs that surely, and that possibly, could have docked."""
        return float(self.docked.mean()), float((self.docked | self.open).mean())


class _World(NamedTuple):
    """What the world will do in each of N runs, whatever is commanded."""

    start: Array                # (N, 6)
    execution: Array            # (N, steps, 3) standard normals
    gets_up: Mask               # (N, steps) the command due in this step arrives


def ceiling(scenario: Scenario, runs: Sequence[int], first_step: int | None = None
            ) -> Ceiling:
    """
    Decide for each run whether a history of commands could have docked it.

    Parameters
    ----------
    scenario : Scenario
        World and links count; pilot, law and sharing do not.
    runs : sequence of int
        Numbers of the runs.
    first_step : int, optional
        First step in which a command can act, one of `first_steps`; by default that of a ground
        that is silent until it has seen telemetry.

    Returns
    -------
    Ceiling

    Raises
    ------
    ValueError
        If there are no runs, `first_step` is negative or errors of the thrust last for a burn.
    """
    if first_step is None:
        first_step = first_steps(scenario)['silent']
    if first_step < 0:
        raise BadInput(f'first_step must not be negative, got {first_step}')
    if len(runs) == 0:
        raise BadInput('runs must be one or more, got none')
    if _dynamics(scenario).execution_noise_per != 'step':
        raise BadInput('spacecraft_dynamics: execution_noise_per must be step for a ceiling, got '
                       f'{_dynamics(scenario).execution_noise_per}')
    parts = [_decide(scenario, runs[i:i + BATCH], first_step)
             for i in range(0, len(runs), BATCH)]
    return Ceiling(*(np.concatenate(part) for part in zip(*parts)))


def first_steps(scenario: Scenario) -> dict[str, int]:
    """Return the first step in which a command can act, by ceiling; `warm`: the link ran."""
    legs = scenario.part('legs')
    return {'silent': legs.loop, 'any': legs.forward, 'warm': 0}


def _decide(scenario: Scenario, runs: Sequence[int], first_step: int) -> Ceiling:
    world = _draw(scenario, runs)
    outside = signed_distance(world.start[:, :3], scenario.part('cone')) <= 0.0
    docked, left = np.zeros((2, len(runs)), dtype=bool)
    for way in WAYS_HOME:
        rows = np.flatnonzero(~(docked | outside | left))
        if rows.size == 0:
            break
        verdict = _fly_home(scenario, _of(world, rows), first_step, way)
        docked[rows] = verdict.success
        left[rows] |= verdict.values['exit_time_s'] <= first_step * scenario.run.step_s
    refuted = np.zeros_like(docked)
    for row in np.flatnonzero(~(docked | outside | left)):
        refuted[row] = best_margin(scenario, _of(world, [row]), first_step) < -SLACK_M
    return Ceiling(outside, left, refuted, docked, ~(outside | left | refuted | docked))


def _draw(scenario: Scenario, runs: Sequence[int]) -> _World:
    run, up = scenario.run, scenario.part('legs').forward
    seed, steps = run.seed, run.last_step + 1
    gets_up = np.ones((len(runs), steps), dtype=bool)       # before `up`: sent before the start
    link = LinkChance('link_forward', scenario.settings('link_forward'), up, run.step_ns)
    gets_up[:, up:] = link.of_runs(seed, runs, steps)[:, :steps - up]
    return _World(_dynamics(scenario).start(scenario.part('start'),
                                            streams.start_normals_of_runs(seed, runs)),
                  streams.normals_of_runs(seed, runs, 'execution', steps, 3), gets_up)


def _dynamics(scenario: Scenario) -> DynamicsParams:
    return scenario.settings('spacecraft_dynamics')


def _model(scenario: Scenario) -> TruthModel:
    return TRUTH_MODELS[_dynamics(scenario).truth_model](scenario.part('orbit'),
                                                         scenario.run.step_s)


def _of(world: _World, rows: Sequence[int]) -> _World:
    return _World(*(part[rows] for part in world))


# -- flown: a history that docks --------------------------------------------------------------

def _fly_home(scenario: Scenario, world: _World, first_step: int,
              way: tuple[float, float, float]) -> Verdict:
    """Fly with the true state in hand, one of `WAYS_HOME`, and judge."""
    model, craft = _model(scenario), _dynamics(scenario)
    form, judge = scenario.part('form'), judge_of(scenario, (len(world.start),))
    state = world.start
    judge.start(state)
    for step in range(scenario.run.last_step):
        levels = form.quantise(_towards_axis(state, scenario.part('orbit').mean_motion, way))
        levels[~world.gets_up[:, step] | (step < first_step)] = 0
        accel = execute(craft.thrust_fraction*form.effect(levels), world.execution[:, step],
                        craft.execution_noise_fraction)
        state = model.advance(state, accel)
        judge.advance(step + 1, state, accel)
        if judge.ended.all():
            break
    return judge.verdict()


def _towards_axis(state: Array, mean_motion: float, way: tuple[float, float, float]) -> Array:
    """Return accelerations (N, 3) [m/s^2] that return to the axis in a time, at a closing rate."""
    home_s, settle_s, closing = way
    wanted = np.column_stack([np.full(len(state), closing), -state[:, 1:3]/home_s])
    coupling = np.zeros_like(wanted)
    coupling[:, 1] = 2.0*mean_motion*state[:, 3]
    return (wanted - state[:, 3:])/settle_s - coupling


# -- refuted: no history stays inside ---------------------------------------------------------

def best_margin(scenario: Scenario, world: _World, first_step: int) -> float:
    """
    Return the largest least radial margin [m] that any thrust history can keep for a while.

    `world` is one run that is inside until `first_step`. Negative: no history stays inside.
    Asked for at sampled instants, in sampled directions, with thrust of any value up to the
    largest: each can only make the answer larger than the truth.
    """
    corridor = scenario.part('cone')
    steps = _before_docking(scenario, world, first_step)
    if steps == 0:
        return np.inf
    free, gain = _motion(_coast(scenario, world, first_step), scenario, steps)
    limit = _thrust_limits(scenario, world, first_step, steps)
    angle = np.arctan2(free[-1, 2], free[-1, 1]) + np.linspace(-np.pi/2, np.pi/2, FACETS)
    facets = np.column_stack([np.full(FACETS, corridor.tan_alpha),
                              np.cos(angle), np.sin(angle)])        # cos y + sin z <= R(x)
    rows = np.einsum('fi,jiu->jfu', facets, gain).reshape(-1, gain.shape[-1])
    room = corridor.docking_radius_m - np.einsum('fi,ji->jf', facets, free).ravel()
    found = linprog(
        np.append(np.zeros(rows.shape[1]), -1.0),                   # maximise the margin
        A_ub=np.column_stack([rows, np.ones(len(rows))]), b_ub=room,
        bounds=[*((-a, a) for a in limit), (None, None)], method='highs')
    return float(found.x[-1]) if found.status == 0 else np.inf


def _coast(scenario: Scenario, world: _World, steps: int) -> Array:
    """Return the state (6,) of one run after `steps` without thrust."""
    model, state = _model(scenario), world.start[0]
    for _ in range(steps):
        state = model.advance(state, np.zeros(3))
    return state


def _before_docking(scenario: Scenario, world: _World, first_step: int) -> int:
    """Return the steps of the programme: none in which full thrust could reach the plane."""
    state = _coast(scenario, world, first_step)
    fastest = 1.1*_dynamics(scenario).thrust_fraction*scenario.part('thrust').x_m_s2[-1]
    time = np.arange(1, HORIZON_STEPS + 1) * scenario.run.step_s
    reach = state[0] + state[3]*time + fastest*time*time/2.0
    return int(np.sum(np.maximum.accumulate(reach) < 0.0))


def _thrust_limits(scenario: Scenario, world: _World, first_step: int, steps: int
                   ) -> Array:
    """Return the largest thrust (3 steps,) [m/s^2] that can be executed; 0 where lost."""
    thrust, craft = scenario.part('thrust'), _dynamics(scenario)
    window = slice(first_step, first_step + steps)
    largest = craft.thrust_fraction*np.array(
        [thrust.x_m_s2[-1], thrust.lateral_m_s2[-1], thrust.lateral_m_s2[-1]])
    limit = np.abs(largest * (1.0 + craft.execution_noise_fraction*world.execution[0, window]))
    return (limit * world.gets_up[0, window, None]).ravel()


def _motion(state: Array, scenario: Scenario, steps: int) -> tuple[Array, Array]:
    """Return positions (j, 3) at the sampled instants without thrust, and d/d thrust of them."""
    n, dt = scenario.part('orbit').mean_motion, scenario.run.step_s
    phi, gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
    free, gain = [], []
    by_thrust = np.zeros((6, steps, 3))             # of the state at the beginning of the step
    for k in range(steps):
        for part in range(1, SAMPLES_PER_STEP + 1):
            time = dt*part/SAMPLES_PER_STEP
            ahead = cw.transition(n, time)
            moved = np.tensordot(ahead, by_thrust, axes=1)
            moved[:, k] += cw.input_matrix(n, time)
            free.append((ahead @ state)[:3])
            gain.append(moved[:3].reshape(3, -1))
        state, by_thrust = phi @ state, np.tensordot(phi, by_thrust, axes=1)
        by_thrust[:, k] += gamma
    return np.array(free), np.array(gain)


# -- shown beside a law -----------------------------------------------------------------------

def main(args: Sequence[str] | None = None) -> None:
    """Print the ceilings of a scenario and what its law reached in the same runs."""
    parser = argparse.ArgumentParser('python -m rvd_missions.lunar_approach.ceiling',
                                     description=main.__doc__)
    parser.add_argument('scenario', type=Path, help='scenario file')
    parser.add_argument('--runs', type=int, default=20000, metavar='N')
    parser.add_argument(
        '--warm', action='store_true', help='for a link that was running before t = 0, instead of '
        'a ground that is silent until telemetry and any command; what is flown starts cold')
    options = parser.parse_args(args)
    try:
        scenario, runs = load(options.scenario), range(options.runs)
        if scenario.mission is not MISSION:
            raise BadInput(f'{options.scenario} must be of mission {MISSION.name}, got '
                           f'{scenario.mission.name}')
        check(scenario)
        named = first_steps(scenario)
        wanted = ['warm'] if options.warm else ['silent', 'any']
        found = {name: ceiling(scenario, runs, named[name]) for name in wanted}
    except BadInput as error:
        parser.error(str(error))
    print('         ' + ''.join(f'{name:>18s}' for name in found))
    for part in Ceiling._fields:
        masks = [getattr(one, part) for one in found.values()]
        print(f'{part:8s} ' + ''.join(f'{m.sum():9d}  {m.mean():.5f}' for m in masks))
    print('ceiling  ' + ''.join('{:9.5f}..{:.5f}'.format(*one.bounds) for one in found.values()))
    reached = np.concatenate([fly(scenario, runs[i:i + BATCH]).verdict.success
                              for i in range(0, options.runs, BATCH)])
    print(f'flown    {reached.mean():.5f}')
    for name, one in found.items():
        print(f'         {reached[one.docked].mean():.5f} of the runs that could be saved ({name})')


if __name__ == '__main__':
    main()
