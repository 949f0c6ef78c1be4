"""
What ours give where the paper says something of its Figures 4 to 16: the numbers, figure by figure.

    ./rvd shell python scripts/tether_published.py

Case 1 is the scenario `tether_open_loop`, Figures 4 to 10; case 2 `tether`, Figures 11 to 16; both
are flown in this process. The curves themselves are lost with the paper's images: what is compared
is what its text says of them (docs/missions/tether.md).

The fit of an input is that of the clipped spline against PCHIP through the same nodes, which does
not overshoot: the paper compares with `the expected input` and does not say what that is between
two nodes.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse, Scenario
from rvd_dynamics.recording.history import everything, of_history
from rvd_dynamics.recording.recording import Recording
from rvd_missions.tether import geometry
from rvd_missions.tether.figures import direction, torque
from rvd_missions.tether.inputs import joined, limits
from rvd_missions.tether.signals import TRACKING, TRUTH

NAMES = 'u1 u2 u3 u4 u5 u6 u7'.split()
POOR_N = 0.1                            # fit of the tension that counts as poor


def flown(closed: bool) -> Recording:
    """Return the recording of a case."""
    scenario = parse('/**: {ros__parameters: {mission: tether, step_s: 0.02, timeout_s: 100.0}}',
                     Path(__file__).stem).with_values('gripper_tracker', feedback=closed)
    return of_history(scenario, fly(scenario, [0], record=everything(scenario)))


def windows(time_s: NDArray, poor: NDArray) -> list[tuple[float, float]]:
    """Return the spans of time in which something is so, gaps of less than a second closed."""
    found: list[list[float]] = []
    for t in time_s[poor]:
        if found and t - found[-1][1] < 1.0:
            found[-1][1] = t
        else:
            found.append([t, t])
    return [(round(float(a), 1), round(float(b), 1)) for a, b in found]


def inputs(run: Recording, scenario: Scenario) -> None:
    """Print how well the inputs fit, how far they are from the plan, and their greatest values."""
    told, plan = run.of(TRACKING), scenario.part('preparation').plan
    low, high = limits(scenario.part('gripper'), scenario.part('tether'))
    fit = np.abs(told['feedforward'] - joined(plan, 'pchip', told.t, low, high))
    print('  fit, greatest over the limit:',
          ', '.join(f'{n} {v:.1e}' for n, v in zip(NAMES, (fit/high).max(axis=0))))
    print(f'  u1 off by more than {POOR_N} N:',
          ', '.join(f'{a} to {b} s' for a, b in windows(told.t, fit[:, 0] > POOR_N)))
    cut = np.abs(told['feedforward'][:, 0] - joined(plan, 'unclipped', told.t, low, high)[:, 0])
    print(f'  of that by the clipping: {windows(told.t, cut > POOR_N)}')
    acted = run.of(TRUTH)['applied'][1:]            # under the command of the step before
    off = acted - told['feedforward'][:len(acted)]
    print('  actual off from planned, rms over the greatest planned:', ', '.join(
        f'{n} {v:.3f}' for n, v in zip(NAMES, np.sqrt((off*off).mean(axis=0))
                                       / np.abs(told['feedforward']).max(axis=0))))
    print('  greatest, over the limit:', ', '.join(
        f'{n} {v:.3f}' for n, v in zip(NAMES, np.abs(acted).max(axis=0)/high)))
    impulse = scenario.run.step_s*np.abs(acted).sum(axis=0)
    print(f'  impulse along: tether {impulse[0]:.2f} N s, thrusters {impulse[1]:.2f} N s')


def motion(run: Recording, closed: bool) -> None:
    """Print how far the gripper was from its plan, its attitude, torques and sight angle."""
    truth, told = run.of(TRUTH), run.of(TRACKING)
    sight = direction(told['planned'][:, 1:3])
    off = told['range'][:, np.newaxis]*sight - truth['target']
    print(f'Figure {14 if closed else 7}\n  off its planned place at 25, 50, 75, 100 s:', ', '.join(
        f'{1e3*np.linalg.norm(off[i]):.1f} mm' for i in (1250, 2500, 3750, -1)))
    print('  off at the end, from the target:', np.round(-off[-1], 6).tolist(), 'm')
    angles = geometry.euler(truth['state'][:, 6:10])
    error = angles - told['planned'][:, 3:]
    print(f'Figure {15 if closed else 8}\n  off the planned attitude:', ', '.join(
        f'{n} {np.abs(e).max():.4f} rad at {told.t[np.abs(e).argmax()]:.1f} s'
        for n, e in zip(('roll', 'pitch', 'yaw'), error.T)))
    print('  greatest:', ', '.join(f'{n} {np.abs(a).max():.4f} rad at '
                                   f'{truth.t[np.abs(a).argmax()]:.1f} s'
                                   for n, a in zip(('roll', 'pitch', 'yaw'), angles.T)))
    print('  off at the end:', np.round(error[-1], 7).tolist(), 'rad')
    arm = run.scenario.part('gripper').attachment_m
    place = truth['target'] + truth['state'][:, :3] - told['range'][:, np.newaxis]*sight
    planned = torque(arm*told['feedforward'][:, 0], place,
                     geometry.quaternion(told['planned'][:, 3:]))
    was = torque(arm*truth['tension'], truth['state'][:, :3], truth['state'][:, 6:10])
    if not closed:
        apart = np.abs(was[1:] - planned[:-1]).max(axis=0)
        print(f'Figure 9\n  greatest torque planned {np.abs(planned).max():.4f} N m, actual '
              f'{np.abs(was).max():.4f}; apart by up to {apart.max():.4f}')
    gamma = geometry.sight_angle(truth['state'][:, 6:10], truth['target'])
    meant = geometry.sight_angle(geometry.quaternion(told['planned'][:, 3:]), sight)
    print(f'Figure {16 if closed else 10}\n  greatest sight angle {gamma.max():.4f} rad at '
          f'{truth.t[gamma.argmax()]:.1f} s; at 52 s {gamma[2600]:.4f}; off the planned one by up '
          f'to {np.abs(gamma - meant).max():.4f}')


if __name__ == '__main__':
    for is_closed, of in ((False, '4 to 6'), (True, '11 to 13')):
        recorded = flown(is_closed)
        print(f'Case {1 + is_closed}\nFigures {of}')
        inputs(recorded, recorded.scenario)
        motion(recorded, is_closed)
