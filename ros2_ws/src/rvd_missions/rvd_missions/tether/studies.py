"""
Studies: how the inputs are joined, from which start the open loop ends as published, and whether
the baseline could be known better.

    ./rvd shell python -m rvd_missions.tether.studies plan
    ./rvd shell python -m rvd_missions.tether.studies splines
    ./rvd shell python -m rvd_missions.tether.studies starts 120
    ./rvd shell python -m rvd_missions.tether.studies search 300
    ./rvd shell python -m rvd_missions.tether.studies baseline 40
    ./rvd shell python -m rvd_missions.tether.studies observer 100 20
    ./rvd shell python -m rvd_missions.tether.studies beads 5 10 20 40

Table 1 of the paper is lost, and with it the start. `starts` draws starts at random, plans each and
flies it open loop, to see whether any gives what was published and the default start does not: a
pitch error of 0.2 rad at the end, a greatest pitch of 0.2322 rad, the greatest sight angle near
52 s. `search` does not draw them but looks for them: from the best of a third of as many draws it
goes on in random steps, shorter after each failure and longer after each success, towards all of
the published numbers at once. What it finds is fitted, and no evidence for the start of the paper.

`baseline` estimates the error of the baseline by what is measured anyway. Motion across the sight
is known from the commands, and seen as an angle: their quotient is the range. Of
(D - r)_y = tan(alpha0) (D - r)_x, with r_y of the nominal motion under the commands that were
carried out, r_x of the encoder and D = (D0 + d) dhat, the error d is found by linear least squares
over all samples of a flight, out of plane likewise; with it the errors of the release, and of the
mass, by what the encoder reads against the nominal motion.

`observer` flies the tracker with and without the observer on board, as many runs of the seed given.
Its settings were chosen on runs 0 to 23 of seed 0: another seed had no part in the choice.

`beads` flies case 2 on a tether cut into so many pieces: what converges with their number, and what
depends on the step over which a command is held and on the damping instead.
"""

import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import RADIUS_EARTH
from rvd_dynamics.diagram.streams import generator
from rvd_groundstation.planning.report import report
from rvd_missions.tether import geometry, optimum
from rvd_missions.tether.inputs import joined, limits, SPLINES
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams
from rvd_missions.tether.signals import TRACKING, TRUTH

ORBITS = {'GEO': OrbitParams(), 'LEO': OrbitParams(perigee_altitude_m=6878e3 - RADIUS_EARTH)}
GRIPPER, TETHER = GripperParams(), TetherParams()
STEP_S = 0.02
CHANGES = np.array([0.01, 0.01, 0.01, 0.001])   # of release [m/s] and mass, for derivatives
PUBLISHED = ('published', 0.77, 0.2, 0.2322, 0.22, 52.0)


class Outcome(NamedTuple):
    """How open loops ended, each (n,)."""

    range_error: NDArray                # [m]
    cross_error: NDArray                # [m]
    attitude: NDArray                   # (n, 3) [rad]
    peak_pitch: NDArray                 # [rad]
    sight: NDArray                      # greatest angle [rad]
    sight_s: NDArray                    # and when [s]


def open_loop(orbit: OrbitParams, task: ApproachParams, nodes: int,
              splines: Sequence[str]) -> Outcome:
    """Plan an approach and fly it open loop with each way to join the nodes."""
    from rvd_missions.tether import motion
    plan = optimum.plan(orbit, GRIPPER, TETHER, task, optimum.PlannerParams(nodes))
    steps, n = int(round(plan.end_s/STEP_S)), len(splines)
    times = STEP_S*np.arange(steps)
    inputs = np.stack([joined(plan, s, times, *limits(GRIPPER, TETHER)) for s in splines], axis=1)
    halves = [orbit.at(0.5*STEP_S*i) for i in range(2*steps + 1)]
    turn = np.array([m.anomaly for m in halves]) - orbit.at(0.0).anomaly
    gravity = orbit.gravitational_parameter_m3_s2/np.array([m.radius for m in halves])**3
    known = np.stack([gravity, np.sin(turn), np.cos(turn)], axis=-1)
    start = task.initial(orbit.at(0.0).rate)
    state = np.tile(np.concatenate([start[:6], geometry.quaternion(start[6:9]), start[9:]]), (n, 1))
    craft = np.tile([GRIPPER.mass_kg, *GRIPPER.inertia_kg_m2, GRIPPER.attachment_m, *[0.0]*3],
                    (n, 1))
    states = np.empty((steps + 1, n, 13))
    states[0] = state
    for k in range(steps):
        state = motion.advance(state, inputs[k], known[2*k:2*k + 3], craft, STEP_S)
        states[k + 1] = state
    sizes = task.baseline_m*np.array([m.radius for m in halves[::2]])/halves[0].radius
    target = sizes[:, np.newaxis]*np.stack([np.cos(turn[::2]), np.sin(turn[::2]),
                                            np.zeros(steps + 1)], axis=-1)
    sight = target[:, np.newaxis] - states[..., :3]
    gamma = geometry.sight_angle(states[..., 6:10], sight)
    angles = geometry.euler(states[..., 6:10])
    end = sight[-1]
    return Outcome(end[:, 0] - task.final_range_m, np.sqrt((end[:, 1:]**2).sum(axis=1)), angles[-1],
                   np.abs(angles[..., 1]).max(axis=0), gamma.max(axis=0),
                   STEP_S*gamma.argmax(axis=0))


def plans() -> None:
    """Print the report on the plan of the default start, on both orbits and several meshes."""
    print('orbit nodes         J  on 20 more   defect    bound  end off when flown [m]  iterations')
    for name, orbit in ORBITS.items():
        for nodes in (20, 30, 40):
            parts = [(orbit, GRIPPER, TETHER, ApproachParams(), optimum.PlannerParams(n))
                     for n in (nodes, nodes + 20)]
            made, finer = (optimum.plan(*p) for p in parts)
            said = report(optimum.solver(*parts[0]), made, refined=finer)
            print(f'{name:<6}{nodes:5d}{said.cost:10.6f}{said.refined_cost:12.6f}{said.defect:9.1e}'
                  f'{said.bound:9.1e}{np.linalg.norm(said.flown[:3]):24.4f}{made.iterations:12d}',
                  flush=True)


def splines() -> None:
    """Print the final range error of each way to join the nodes, on both orbits."""
    print('range error [m]' + ''.join(f'{s:>12}' for s in SPLINES))
    for name, orbit in ORBITS.items():
        found = open_loop(orbit, ApproachParams(), 40, SPLINES)
        print(f'{name:<15}' + ''.join(f'{e:12.4f}' for e in found.range_error))


def starts(count: int) -> None:
    """Print the outcome of starts drawn at random, and how near any comes to the published one."""
    rows = []
    for i in range(count):
        rng = generator(0, i, 'tether/studies/starts')
        name = ('GEO', 'LEO')[i % 2]
        task = replace(
            ApproachParams(), lateral_m_s=tuple(rng.uniform(-0.15, 0.15, 2)),
            attitude_rad=tuple(rng.uniform(-0.1, 0.1, 3)),
            rate_rad_s=tuple(rng.uniform(-0.02, 0.02, 3)), speed_m_s=rng.uniform(0.8, 1.3))
        try:
            found = open_loop(ORBITS[name], task, 30, ('clipped',))
        except BadInput as error:
            print(f'{i:4d} {name} {error}', flush=True)
            continue
        rows.append((found.range_error[0], abs(found.attitude[0, 1]), found.peak_pitch[0],
                     found.sight[0], found.sight_s[0]))
        print(f'{i:4d} {name} range {rows[-1][0]:+.3f} m, pitch {rows[-1][1]:.3f} rad, peak '
              f'{rows[-1][2]:.4f} rad, sight {rows[-1][3]:.3f} rad at {rows[-1][4]:5.1f} s',
              flush=True)
    table = np.array(rows)
    print(f'{len(table)} flown          least   median greatest published')
    for i, words in enumerate(('range error [m]', 'pitch error [rad]', 'peak pitch [rad]',
                               'sight angle [rad]', 'its time [s]')):
        column = table[:, i]
        print(f'{words:<18}{column.min():9.3f}{np.median(column):9.3f}{column.max():9.3f}'
              f'{PUBLISHED[1 + i]:9.3f}')


# what is wanted of an open loop, and how far off counts as one: range [m], pitch at the end and its
# peak, greatest sight angle [rad], and when [s]
WANTED = np.array([0.77, 0.2, 0.2322, 0.215, 52.0])
UNIT = np.array([0.3, 0.05, 0.03, 0.03, 10.0])
LEAST = np.array([0.7, -0.15, -0.15, *[-0.1]*3, *[-0.02]*3])
MOST = np.array([1.4, 0.15, 0.15, *[0.1]*3, *[0.02]*3])


def judged(orbit: OrbitParams, start: NDArray) -> tuple[float, NDArray, NDArray]:
    """Return how far from published an open loop from a start (9,) ends, numbers, attitude."""
    task = replace(ApproachParams(), speed_m_s=float(start[0]), lateral_m_s=tuple(start[1:3]),
                   attitude_rad=tuple(start[3:6]), rate_rad_s=tuple(start[6:]))
    try:
        found = open_loop(orbit, task, 30, ('clipped',))
    except BadInput:
        return np.inf, np.full(5, np.nan), np.full(3, np.nan)
    told = np.array([found.range_error[0], abs(found.attitude[0, 1]), found.peak_pitch[0],
                     found.sight[0], found.sight_s[0]])
    return float((((told - WANTED)/UNIT)**2).sum()), told, found.attitude[0]


def search(count: int) -> None:
    """Print the start that comes nearest to all that was published, of `count` tried an orbit."""
    for name, orbit in ORBITS.items():
        rng = generator(0, 0, f'tether/studies/search {name}')
        tried = []
        for _ in range(count//3):
            start = rng.uniform(LEAST, MOST)
            tried.append((start, *judged(orbit, start)))
        best, step = min(tried, key=lambda t: t[1]), 0.2
        for _ in range(count - count//3):
            start = np.clip(best[0] + step*(MOST - LEAST)*rng.normal(size=9), LEAST, MOST)
            made = (start, *judged(orbit, start))
            better = made[1] < best[1]
            best, step = (made, 1.5*step) if better else (best, max(0.9*step, 0.005))
        start, cost, told, attitude = best
        print(f'{name} after {count}: off by {cost:.2f}, start {np.round(start, 4).tolist()}\n'
              f'  range {told[0]:+.3f} m, pitch {told[1]:.3f} rad, peak {told[2]:.4f} rad, sight '
              f'{told[3]:.3f} rad at {told[4]:.1f} s, attitude at the end '
              f'{np.round(attitude, 3).tolist()} rad', flush=True)


CASES = {                               # by section: what else is not as in the scenario
    'noise alone': {},
    'release off by 0.03 m/s': {'gripper_dynamics': {'velocity_sigma_m_s': 0.03}},
    'mass off by 0.1 %': {'gripper_dynamics': {'mass_sigma': 0.001}},
    'mass off by 1 %': {'gripper_dynamics': {'mass_sigma': 0.01}},
    'released across at 0.3 m/s': {'/**': {'approach.lateral_m_s': [0.3, -0.3]}},
    '  and mass off by 1 %': {'/**': {'approach.lateral_m_s': [0.3, -0.3]},
                              'gripper_dynamics': {'mass_sigma': 0.01}},
}
NOISE = {'encoder_sigma_m': 0.005, 'bearing_sigma_rad': 5e-4, 'attitude_sigma_rad': 5e-4}


def baseline(count: int) -> None:
    """Print how well the error of the baseline is found after a flight, in each case."""
    from rvd_dynamics.diagram.in_process import fly
    from rvd_dynamics.diagram.scenario import parse
    base = parse('/**: {ros__parameters: {mission: tether, step_s: 0.02, timeout_s: 100.0}}',
                 'baseline').with_values('gripper_sensors', **NOISE)
    print('error of the baseline [m], 1 sigma: 1.0 before')
    for name, changes in CASES.items():
        scenario = base.with_values('gripper_dynamics', baseline_sigma_m=1.0)
        for section, values in changes.items():
            scenario = scenario.with_values(section, **values)
        history = fly(scenario, range(count), record=[TRUTH.name, TRACKING.name]).history
        truth, told = history[TRUTH.name], history[TRACKING.name]
        found = estimated_baseline(truth.applied, told.measured, scenario.part('preparation'))
        start = truth.state[0, :, :3] + truth.target[0]
        exact = np.sqrt((start*start).sum(axis=-1)) - ApproachParams().baseline_m
        print(f'  {name:<28} {np.sqrt(np.mean((found - exact)**2)):6.3f} after', flush=True)


ACROSS = {'approach.lateral_m_s': [0.3, -0.3]}
OBSERVED = {                            # by section, beside noise and a baseline known to 1 m
    'baseline known, and told so': {
        'gripper_dynamics': {'baseline_sigma_m': 0.0},
        'gripper_tracker': {'observer.baseline_sigma_m': 0.0}},
    'the default release': {},
    '  and a density of 5e-3': {'gripper_tracker': {'observer.force_sigma_n_rt_s': 5e-3}},
    'released across at 0.3 m/s': {'/**': ACROSS},
    '  mass 1 %, release 0.03 m/s': {
        '/**': ACROSS, 'gripper_dynamics': {'mass_sigma': 0.01, 'velocity_sigma_m_s': 0.03}},
    'default, mass 1 %, release 0.03': {
        'gripper_dynamics': {'mass_sigma': 0.01, 'velocity_sigma_m_s': 0.03}},
    'default, 0.005 N on each axis': {
        'gripper_dynamics': {'disturbance_n': [0.005, 0.005, 0.005]}},
}


def observed(count: int, seed: int) -> None:
    """Print how flights end without and with the observer on board, in each case."""
    from rvd_dynamics.diagram.in_process import fly
    from rvd_dynamics.diagram.scenario import parse
    base = parse('/**: {ros__parameters: {mission: tether, step_s: 0.02, timeout_s: 100.0}}',
                 'observer').with_values('gripper_sensors', **NOISE)
    base = base.with_values('/**', seed=seed).with_values('gripper_dynamics', baseline_sigma_m=1.0)
    print(f'{count} runs of seed {seed}          rms [m]: without     with     mean  greatest'
          '   thrust [N s]: without     with')
    for name, changes in OBSERVED.items():
        scenario = base
        for section, values in changes.items():
            scenario = scenario.with_values(section, **values)
        without, with_it = (
            fly(scenario.with_values('gripper_tracker', observer__on=on), range(count)
                ).verdict.values for on in (False, True))
        error = with_it['range_error_m']
        print(f'  {name:<32} {np.sqrt(np.mean(without["range_error_m"]**2)):11.3f} '
              f'{np.sqrt(np.mean(error**2)):8.3f} {error.mean():+8.3f} {np.abs(error).max():9.3f} '
              f'{without["fuel_N_s"].mean():21.1f} {with_it["fuel_N_s"].mean():8.1f}', flush=True)


RINGING = ((0.02, 0.1), (0.01, 0.1), (0.02, 10.0))      # step [s], damping [N s]


def pieces(counts: Sequence[int]) -> None:
    """Print how case 2 ends on a tether of so many pieces; 0 is one without mass."""
    from rvd_dynamics.diagram.in_process import fly
    from rvd_dynamics.diagram.scenario import parse
    for step_s, damping in RINGING:
        print(f'steps of {1e3*step_s:g} ms, c = {damping:g} N s\n  pieces  range [mm]  thrust [N s]'
              '  tension off, mean and greatest [N]  least [N]  slack [s]')
        base = parse('/**: {ros__parameters: {mission: tether, timeout_s: 100.0, step_s: '
                     f'{step_s}}}}}', 'beads')
        for count in counts:
            made = fly(base.with_values('gripper_dynamics', beads=count, reel__damping_n_s=damping),
                       [0], record=[TRUTH.name])
            truth, v = made.history[TRUTH.name], made.verdict.values
            felt = truth.tension[1:, 0]
            off = np.abs(felt - truth.applied[1:, 0, 0])
            print(f'{count:8d}{1e3*v["range_error_m"][0]:12.2f}{v["fuel_N_s"][0]:14.3f}'
                  f'{off.mean():15.4f}{off.max():22.3f}{felt.min():11.4f}{v["slack_s"][0]:11.2f}',
                  flush=True)


def estimated_baseline(applied: NDArray, measured: NDArray,
                       made: optimum.Preparation) -> NDArray[np.float64]:
    """
    Return the error of the baseline (N,) [m] that explains what was seen best.

    Of the commands carried out (steps + 1, N, 7), the first one unknown, and of what the tracker
    measured (steps + 1, N, 6). Found with it are the errors of the release and of the mass, which
    the encoder tells by the braking of the tether.
    """
    from rvd_missions.tether import motion
    steps, n = len(applied) - 1, applied.shape[1]
    orbit, gripper, tether, task = made.orbit, made.gripper, made.tether, made.approach
    start = task.initial(orbit.at(0.0).rate)
    # as planned; with another release along x, y and z; with another mass
    count = 1 + len(CHANGES)
    state = np.tile(np.concatenate([start[:6], geometry.quaternion(start[6:9]), start[9:]]),
                    (count, n, 1))
    craft = np.tile([gripper.mass_kg, *gripper.inertia_kg_m2, gripper.attachment_m, *[0.0]*3],
                    (count, n, 1))
    for i in range(3):
        state[1 + i, :, 3 + i] += CHANGES[i]
    craft[4, :, 0] *= 1.0 + CHANGES[3]
    state, craft = state.reshape(-1, 13), craft.reshape(-1, 8)
    normal, right = np.zeros((n, 5, 5)), np.zeros((n, 5))
    for k in range(steps + 1):
        if k > 0:
            times = STEP_S*(k - 1 + np.array([0.0, 0.5, 1.0]))
            turn = [orbit.at(t).anomaly - orbit.at(0.0).anomaly for t in times]
            gravity = [orbit.gravitational_parameter_m3_s2/orbit.at(t).radius**3 for t in times]
            state = motion.advance(state, np.tile(applied[k], (count, 1)), np.stack(
                [gravity, np.sin(turn), np.cos(turn)], axis=-1), craft, STEP_S)
        tension = applied[k, :, 0] if k > 0 else np.full(n, tether.least_n)
        place = state[:, :3].reshape(count, n, 3)
        out = np.sqrt((place*place).sum(axis=-1))/(1.0 + tension/tether.stiffness_n)
        unit = geometry.baseline(orbit, 1.0, k*STEP_S).place
        length, alpha, beta = (measured[k, :, i] for i in range(3))
        y, z = place[0, :, 1], place[0, :, 2]
        true_length = length*(1.0 + tension/tether.stiffness_n)
        ahead = task.baseline_m*unit[0] - np.sqrt(true_length*true_length - y*y - z*z)
        up = np.tan(beta)/np.cos(alpha)
        for known, moved, left, sigma in (
                (np.zeros(n), out, length - out[0], NOISE['encoder_sigma_m']),
                (np.tan(alpha)*unit[0] - unit[1], place[..., 1],
                 task.baseline_m*unit[1] - y - np.tan(alpha)*ahead,
                 NOISE['bearing_sigma_rad']*ahead),
                (up*unit[0], place[..., 2], -z - up*ahead, NOISE['bearing_sigma_rad']*ahead)):
            slopes = (moved[1:] - moved[0]).T/CHANGES
            row = np.concatenate([known[:, np.newaxis], slopes], axis=1)
            weight = 1.0/sigma**2*np.ones(n)
            normal += (weight[:, np.newaxis]*row)[:, :, np.newaxis]*row[:, np.newaxis, :]
            right += (weight*left)[:, np.newaxis]*row
    return np.linalg.solve(normal, right[..., np.newaxis])[:, 0, 0]


if __name__ == '__main__':
    if sys.argv[1:] == ['plan']:
        plans()
    elif sys.argv[1:] == ['splines']:
        splines()
    elif len(sys.argv) == 3 and sys.argv[1] == 'starts' and sys.argv[2].isdigit():
        starts(int(sys.argv[2]))
    elif len(sys.argv) == 3 and sys.argv[1] == 'search' and sys.argv[2].isdigit():
        search(int(sys.argv[2]))
    elif len(sys.argv) == 3 and sys.argv[1] == 'baseline' and sys.argv[2].isdigit():
        baseline(int(sys.argv[2]))
    elif len(sys.argv) == 4 and sys.argv[1] == 'observer' and all(
            word.isdigit() for word in sys.argv[2:]):
        observed(*map(int, sys.argv[2:]))
    elif len(sys.argv) > 2 and sys.argv[1] == 'beads' and all(
            word.isdigit() for word in sys.argv[2:]):
        pieces([int(word) for word in sys.argv[2:]])
    else:
        sys.exit(__doc__.strip())
