"""
The figures of a run, those of the paper: what was planned, and what was.

Planned values are those that the tracker followed, so that they need no planner.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, Figure, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_missions.tether import geometry
from rvd_missions.tether.signals import TRACKING, TRUTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

AXES = (BLUE, VERMILLION, GREEN)


def inputs(run: Recording) -> 'Canvas':
    """Draw tension, thruster force and control torque: Figures 4 to 6, and 11 to 13."""
    figure = canvas(6.6, top=0.42, hspace=0.14)
    panels = figure.subplots(3, 1, sharex=True)
    truth, told = run.of(TRUTH), run.of(TRACKING)
    gripper, tether = run.scenario.part('gripper'), run.scenario.part('tether')
    was, fed = truth['applied'], told['feedforward']
    panels[0].plot(told.t, fed[:, 0], color=MUTED, linestyle=DASHED, label='planned')
    panels[0].plot(truth.t, truth['tension'], color=INK, label='actual')
    panels[0].set(ylabel='tension [N]')
    for axes, first, names, most, label in (
            (panels[1], 1, ('along', 'in plane', 'out of plane'), gripper.max_force_n,
             'thrust [N]'),
            (panels[2], 4, 'xyz', gripper.max_torque_n_m, 'torque [N m]')):
        for i, (name, colour) in enumerate(zip(names, AXES)):
            axes.plot(told.t, fed[:, first + i], color=colour, linestyle=DASHED, linewidth=1.0)
            axes.plot(truth.t, was[:, first + i], color=colour, label=name)
        peak = np.nanmax(np.abs(was[:, first:first + 3]))
        if peak > 0.5*most:
            for side in (-most, most):
                axes.axhline(side, color=VERMILLION, linewidth=0.8)
        axes.set(ylabel=label)
    for axes in panels:
        axes.legend(ncols=3, **ABOVE)
    panels[0].axhline(tether.most_n, color=VERMILLION, linewidth=0.8)
    panels[-1].set(xlabel='time [s]')
    return figure


def trajectory(run: Recording) -> 'Canvas':
    """Draw the way from target to gripper in the inertial frame of the start: Figures 7 and 14."""
    figure = canvas(5.4, top=0.42, hspace=0.14)
    panels = figure.subplots(3, 1, sharex=True)
    truth, told = run.of(TRUTH), run.of(TRACKING)
    sight = direction(told['planned'][:, 1:3])
    planned, was = -told['range'][:, np.newaxis]*sight, -truth['target']
    for i, (axes, name) in enumerate(zip(panels, 'xyz')):
        axes.plot(told.t, planned[:, i], color=MUTED, linestyle=DASHED, label='planned')
        axes.plot(truth.t, was[:, i], color=INK, label='actual')
        axes.set(ylabel=f'{name} from the target [m]')
    panels[0].axhline(-run.scenario.part('approach').final_range_m, color=GREEN, linewidth=0.8)
    panels[0].legend(ncols=2, **ABOVE)
    panels[-1].set(xlabel='time [s]')
    return figure


def attitude(run: Recording) -> 'Canvas':
    """Draw roll, pitch and yaw: Figures 8 and 15."""
    figure = canvas(3.6, top=0.42)
    axes = figure.subplots()
    truth, told = run.of(TRUTH), run.of(TRACKING)
    angles = geometry.euler(truth['state'][:, 6:10])
    for i, (name, colour) in enumerate(zip(('roll', 'pitch', 'yaw'), AXES)):
        axes.plot(told.t, told['planned'][:, 3 + i], color=colour, linestyle=DASHED, linewidth=1.0)
        axes.plot(truth.t, angles[:, i], color=colour, label=name)
    limit = run.scenario.part('approach').angle_limit
    for side in (-limit, limit):
        axes.axhline(side, color=VERMILLION, linewidth=0.8)
    axes.set(xlabel='time [s]', ylabel='attitude [rad]')
    axes.legend(ncols=3, **ABOVE)
    return figure


def tether_torque(run: Recording) -> 'Canvas':
    """Draw the torque of the tether on the gripper, body axes: Figure 9."""
    figure = canvas(3.2, top=0.42)
    axes = figure.subplots()
    truth, told = run.of(TRUTH), run.of(TRACKING)
    arm = run.scenario.part('gripper').attachment_m
    was = torque(arm*truth['tension'], truth['state'][:, :3], truth['state'][:, 6:10])
    target = truth['target'] + truth['state'][:, :3]            # from the platform
    place = target[:len(told.t)] - told['range'][:, np.newaxis]*direction(told['planned'][:, 1:3])
    planned = torque(arm*told['feedforward'][:, 0], place,
                      geometry.quaternion(told['planned'][:, 3:]))
    for i, name in ((1, 'y'), (2, 'z')):
        axes.plot(told.t, planned[:, i], color=AXES[i], linestyle=DASHED, linewidth=1.0)
        axes.plot(truth.t, was[:, i], color=AXES[i], label=name)
    most = run.scenario.part('gripper').max_torque_n_m
    for side in (-most, most):
        axes.axhline(side, color=VERMILLION, linewidth=0.8)
    axes.set(xlabel='time [s]', ylabel='torque of the tether [N m]')
    axes.legend(ncols=2, **ABOVE)
    return figure


def sight(run: Recording) -> 'Canvas':
    """Draw the angle between boresight and line of sight: Figures 10 and 16."""
    figure = canvas(3.2, top=0.42)
    axes = figure.subplots()
    truth, told = run.of(TRUTH), run.of(TRACKING)
    planned = geometry.sight_angle(geometry.quaternion(told['planned'][:, 3:]),
                                   direction(told['planned'][:, 1:3]))
    axes.plot(told.t, planned, color=MUTED, linestyle=DASHED, label='planned')
    axes.plot(truth.t, geometry.sight_angle(truth['state'][:, 6:10], truth['target']), color=INK,
              label='actual')
    view = run.scenario.part('approach').view_rad
    axes.axhline(view, color=VERMILLION, linewidth=0.8, label='field of view, as half an angle')
    axes.axhline(view/2, color=ORANGE, linewidth=0.8, label='as a whole one')
    axes.set(xlabel='time [s]', ylabel='sight angle [rad]', ylim=(0.0, None))
    axes.legend(ncols=4, **ABOVE)
    return figure


def direction(angles: NDArray) -> NDArray[np.float64]:
    """Return unit vectors (n, 3) of alpha and beta (n, 2)."""
    a, b = angles[:, 0], angles[:, 1]
    return np.stack([np.cos(b)*np.cos(a), np.cos(b)*np.sin(a), np.sin(b)], axis=-1)


def torque(pull: NDArray, place: NDArray, attitude: NDArray) -> NDArray[np.float64]:
    """Return x_b times x_t (n, 3) in the body, times `pull` (n,)."""
    along = geometry.to_body(attitude, place/np.linalg.norm(place, axis=-1, keepdims=True))
    nothing = np.zeros(len(pull))
    return pull[:, np.newaxis]*np.stack([nothing, -along[:, 2], along[:, 1]], axis=-1)


SIGNALS = (TRUTH.name, TRACKING.name)
FIGURES = {
    'inputs': Figure(
        inputs, 'Inputs', 'Tension, thruster force along the tether frame and control torque about '
        'the body axes. Dashed: planned; the red lines are limits.', signals=SIGNALS),
    'trajectory': Figure(
        trajectory, 'Relative trajectory', 'The gripper from the target, in the inertial frame of '
        'the start: x from platform to target, y to nadir, z along the orbit normal. Dashed: '
        'planned; green: where the approach ends.', signals=SIGNALS),
    'attitude': Figure(
        attitude, 'Attitude', 'Roll, pitch and yaw. Dashed: planned; red: the bound of pitch and '
        'yaw in the plan.', signals=SIGNALS),
    'tether_torque': Figure(
        tether_torque, 'Torque of the tether', 'The tether pulls behind the centre of mass and '
        'turns the gripper. Dashed: planned; red: the limit of the control torque.',
        signals=SIGNALS),
    'sight': Figure(
        sight, 'Sight angle', 'Angle between boresight and line of sight. The camera sees the '
        'target below the red line; the paper does not say whether its 0.4 rad are half a cone or '
        'a whole one, hence the second line.', signals=SIGNALS),
}
