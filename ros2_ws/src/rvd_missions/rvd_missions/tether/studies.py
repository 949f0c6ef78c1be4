"""
Studies of the open loop: how the inputs are joined, and from which start it ends as published.

    ./rvd shell python -m rvd_missions.tether.studies splines
    ./rvd shell python -m rvd_missions.tether.studies starts 100

Table 1 of the paper is lost, and with it the start. `starts` draws starts at random, plans each and
flies it open loop, to see whether any gives what was published and the default start does not: a
pitch error of 0.2 rad at the end, a greatest pitch of 0.2322 rad, the greatest sight angle near
52 s.
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
from rvd_missions.tether import geometry, optimum
from rvd_missions.tether.inputs import joined, limits, SPLINES
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams

ORBITS = {'GEO': OrbitParams(), 'LEO': OrbitParams(perigee_altitude_m=6878e3 - RADIUS_EARTH)}
GRIPPER, TETHER = GripperParams(), TetherParams()
STEP_S = 0.02
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


if __name__ == '__main__':
    if sys.argv[1:] == ['splines']:
        splines()
    elif len(sys.argv) == 3 and sys.argv[1] == 'starts' and sys.argv[2].isdigit():
        starts(int(sys.argv[2]))
    else:
        sys.exit(__doc__.strip())
