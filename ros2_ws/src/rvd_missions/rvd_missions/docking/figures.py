"""
The figures of a run: how it came to hover, and how well it knew where it was.
"""

from typing import TYPE_CHECKING

import numpy as np

from rvd_dynamics.motion import attitude
from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, Figure, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_missions.docking.settings import faces
from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, TRUTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

AXES = (('x', BLUE, '-'), ('y', VERMILLION, '-'), ('z', GREEN, '-'))


def approach(run: Recording) -> 'Canvas':
    """Draw distance, offset across and attitude, with the limits of hovering."""
    figure = canvas(5.6, top=0.42, hspace=0.16)
    above, middle, below = figure.subplots(3, 1, sharex=True, height_ratios=[2, 1, 1])
    truth, guided = run.of(TRUTH), run.of(GUIDANCE)
    aim, limits = run.scenario.part('aim'), run.scenario.part('limits')
    centre = run.scenario.part('chaser').centre_m
    port, turn = faces(truth['position'], truth['attitude'], truth['target_attitude'], centre)
    angles = np.degrees(attitude.rotation_vector(turn))
    planned = -guided['reference'][:, 0] - 3.0
    above.semilogy(guided.t, planned, color=ORANGE, linewidth=1.2, label='profile')
    above.semilogy(truth.t, -port[:, 0], color=INK, label='true')
    for side in (-limits.band_m, limits.band_m):
        above.axhline(aim.distance_m + side, color=MUTED, linestyle=DASHED, linewidth=1.0)
    above.set(ylabel='distance of the faces [m]')
    above.legend(ncols=2, **ABOVE)
    for axis, (name, color, style) in enumerate(AXES):
        if axis:
            middle.plot(truth.t, 1e3*port[:, axis], color=color, linestyle=style, label=name,
                        linewidth=1.1)
        below.plot(truth.t, angles[:, axis], color=color, linestyle=style, linewidth=1.1,
                   label=f'about {name}')
    for axes, size, label, most in ((middle, 1e3*limits.lateral_m, 'offset [mm]', 240.0),
                                    (below, limits.attitude_deg, 'attitude [deg]', 1.6)):
        for side in (-size, size):
            axes.plot([limits.from_s, truth.t[-1]], [side, side], color=MUTED, linestyle=DASHED,
                      linewidth=1.0)
        axes.set(ylabel=label, ylim=(-most, most))
        axes.legend(ncols=3, **ABOVE)
    below.set(xlabel='time [s]')
    return figure


def navigation(run: Recording) -> 'Canvas':
    """Draw the errors of position and attitude that the craft did not know of."""
    figure = canvas(3.8, top=0.42, hspace=0.16)
    above, below = figure.subplots(2, 1, sharex=True)
    truth, seen = run.of(TRUTH), run.of(ESTIMATE)
    count = min(len(truth.t), len(seen.t))
    away = seen['position'][:count] - truth['position'][:count]
    turn = np.degrees(attitude.rotation_vector(attitude.multiply(
        attitude.conjugate(seen['attitude'][:count]), truth['attitude'][:count])))
    for axis, (name, color, style) in enumerate(AXES):
        above.plot(truth.t[:count], 1e3*away[:, axis], color=color, linestyle=style, label=name,
                   linewidth=0.9)
        below.plot(truth.t[:count], turn[:, axis], color=color, linestyle=style, linewidth=0.9)
    above.set(ylabel='position [mm]')
    above.legend(ncols=3, **ABOVE)
    below.set(xlabel='time [s]', ylabel='attitude [deg]')
    return figure


FIGURES = {
    'approach': Figure(
        approach, 'Approach',
        'Distance of the docking faces on a logarithmic scale with the profile that is tracked, '
        'offset of the port across, and attitude, all true. Dashed: the limits of hovering.',
        signals=(TRUTH.name, GUIDANCE.name)),
    'navigation': Figure(
        navigation, 'Navigation error',
        'Estimated minus true position, and the turn from estimated to true attitude.',
        signals=(TRUTH.name, ESTIMATE.name)),
}
