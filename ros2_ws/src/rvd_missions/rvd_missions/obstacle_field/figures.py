"""
The figures of a run: the track past the obstacles, distance and speed, thrust, alarms.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, Figure, GREEN, INK, LINES, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_missions.obstacle_field.signals import ALARM, TRUTH

DOTTED = (0, (1, 2))


def truth_of(run: Recording) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Return times, states (n, 6), accelerations (n, 3) and obstacles (n, M, 6) of a recording."""
    truth = run.of(TRUTH)
    count = run.scenario.part('obstacles').count
    return (truth.t, truth['state'], truth['acceleration'],
            np.reshape(truth['obstacles'], (len(truth.t), count, 6)))


def planes(axes: Any, track: NDArray, colour: str, **look: Any) -> None:
    """Draw a track (n, 3) into two axes: the orbital plane, and the horizontal one."""
    for panel, across in zip(axes, (1, 2)):
        panel.plot(track[:, 0], track[:, across], color=colour, **look)


def draw_obstacles(axes: Any, obstacles: NDArray, radii: NDArray) -> None:
    """Draw obstacles (n, M, 6) as circles at their start, with the way of those that move."""
    from matplotlib.patches import Circle
    for panel, across in zip(axes, (1, 2)):
        for i, radius in enumerate(radii):
            place = obstacles[0, i, (0, across)]
            panel.add_patch(Circle(place, radius, color=VERMILLION, alpha=0.55, linewidth=0))
            if np.any(obstacles[0, i, 3:]):
                panel.plot(obstacles[:, i, 0], obstacles[:, i, across], color=VERMILLION,
                           linestyle=DOTTED, linewidth=1.0)


def name_planes(axes: Any, craft: Any) -> None:
    """Give the views from the side and from above (z down) target, names and equal scales."""
    from matplotlib.patches import Circle
    for panel, across in zip(axes, (1, 2)):
        panel.add_patch(Circle((0, 0), craft.target_radius_m, color=MUTED, linewidth=0))
        panel.set(xlabel='x, along track [m]', aspect='equal',
                  ylabel=f'{"xyz"[across]}, {("", "radial", "cross track")[across]} [m]')
        panel.set_title(('', 'Side', 'Top, z down')[across])
        if across == 2:
            panel.invert_yaxis()                # as the console's view from above


def track(run: Recording) -> Any:
    """Draw the track in two planes."""
    figure = canvas(3.6, wspace=0.18)
    axes = figure.subplots(1, 2)
    _, state, _, obstacles = truth_of(run)
    draw_obstacles(axes, obstacles, run.scenario.part('obstacles').radii)
    planes(axes, state, INK)
    name_planes(axes, run.scenario.part('craft'))
    return figure


def approach(run: Recording) -> Any:
    """Draw distance, speed with its limit, and clearance over time."""
    figure = canvas(5.4, hspace=0.3)
    far, fast, near = figure.subplots(3, 1, sharex=True)
    t, state, _, obstacles = truth_of(run)
    craft, corridor = run.scenario.part('craft'), run.scenario.part('speed_corridor')
    r, v = (np.linalg.norm(part, axis=1) for part in (state[:, :3], state[:, 3:]))
    far.plot(t, r, color=INK)
    far.axhline(craft.arrival_m, color=GREEN, linestyle=DASHED)
    far.set(ylabel='distance [m]')
    fast.semilogy(t[1:], 1000.0*np.maximum(v[1:], 1e-6), color=INK, label='speed')
    fast.semilogy(t, 1000.0*corridor.limit(r - craft.contact_m), color=ORANGE, linestyle=DASHED,
                  label='limit' if corridor.kept else 'limit, not kept')
    fast.set(ylabel='speed [mm/s]', ylim=(1.0, None))
    fast.legend(ncols=2, **ABOVE)
    reach = run.scenario.part('reach_m')
    for i, (colour, style, _) in zip(range(len(reach)), LINES * 11):
        gap = np.linalg.norm(state[:, :3] - obstacles[:, i, :3], axis=1) - reach[i]
        near.semilogy(t, np.maximum(gap, 1e-3), color=colour, linestyle=style,
                      label=f'obstacle {i + 1}')
    near.set(ylabel='clearance [m]', xlabel='time [s]')
    if len(reach):
        near.legend(ncols=4, **ABOVE)
    return figure


def thrust(run: Recording) -> Any:
    """Draw the executed acceleration of each axis."""
    figure = canvas(4.2, hspace=0.14)
    t, _, accel, _ = truth_of(run)
    for panel, values, axis in zip(figure.subplots(3, 1, sharex=True), accel.T, 'xyz'):
        panel.step(t[:-1], values[1:], where='post', color=BLUE, linewidth=1.0)
        panel.set(ylabel=f'{axis} [m/s²]')
    panel.set(xlabel='time [s]')
    return figure


def alarms(run: Recording) -> Any:
    """Draw distance, zone and alarm of each obstacle."""
    alarm = run.of(ALARM)
    count = run.scenario.part('obstacles').count
    distance, zone, on = (np.reshape(alarm[part], (len(alarm.t), count))
                          for part in ('distance', 'zone', 'on'))
    figure = canvas(0.6 + 1.5*max(count, 1), hspace=0.2)
    if not count:
        figure.text(0.5, 0.5, 'no obstacles', ha='center', color=MUTED)
        return figure
    for i, panel in enumerate(figure.subplots(count, 1, sharex=True, squeeze=False)[:, 0]):
        panel.plot(alarm.t, distance[:, i], color=INK, label='distance of the centres')
        panel.plot(alarm.t, zone[:, i], color=ORANGE, linestyle=DASHED, label='braking zone')
        alarmed = on[:, i] > 0.5
        panel.plot(alarm.t[alarmed], distance[alarmed, i], linestyle='', marker='.',
                   color=VERMILLION, markersize=5, label='alarm')
        panel.set(ylabel=f'obstacle {i + 1} [m]', ylim=(0.0, 1.3*zone[:, i].max()))
    figure.axes[0].legend(ncols=3, **ABOVE)
    figure.axes[-1].set(xlabel='time [s]')
    return figure


FIGURES = {
    'track': Figure(
        track, 'Track', 'True track from the side and from above, as the console shows it. Discs: '
        'the obstacles where they start; dotted: the way of those that move.', signals=(TRUTH,)),
    'approach': Figure(
        approach, 'Approach', 'Distance to the target, with the distance of arrival dashed; speed '
        'and its limit; clearance between the surfaces of the chaser and of each obstacle.',
        signals=(TRUTH,)),
    'thrust': Figure(thrust, 'Thrust', 'Acceleration that the thrusters gave.', signals=(TRUTH,)),
    'alarms': Figure(
        alarms, 'Alarms', 'Distance of each obstacle as the ground foresaw it, and its braking '
        'zone; red where it alarmed.', signals=(ALARM,)),
}
