"""
The figure of a campaign over planners: time, propellant and margins of each.
"""

from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import (
    BLUE, CampaignFigure, canvas, DASHED, GREEN, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.worded import worded

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

DRAWN = {'settled_s': (1.0, 'in the band for good [s]'), 'propellant_kg': (1e3, 'propellant [g]'),
         'speed_margin_m_s': (1e3, 'margin of speed [mm/s]'),
         'cone_margin_m': (1e3, 'margin of the cone of view [mm]')}
COLOURS = BLUE, VERMILLION, GREEN, ORANGE


def planners(results: Any) -> tuple['Canvas', str]:
    """Draw each run of each condition as a point, and the medians."""
    figure = canvas(4.6, top=0.3, hspace=0.35, wspace=0.28)
    panels = figure.subplots(2, 2).ravel()
    names = list(results.tables)
    for axes, (column, (scale, label)) in zip(panels, DRAWN.items()):
        for i, name in enumerate(names):
            values = scale*np.asarray(results.tables[name][column], dtype=float)
            values = values[np.isfinite(values)]
            beside = i + 0.5*((np.arange(len(values))*0.618034) % 1.0 - 0.5)
            axes.plot(beside, values, '.', color=COLOURS[i % len(COLOURS)], markersize=2.5)
            if len(values):
                axes.plot([i - 0.35, i + 0.35], [np.median(values)]*2, color='k', linewidth=1.2)
        axes.set(ylabel=label)
        axes.set_xticks(range(len(names)), [worded(n).replace(' ', '\n') for n in names],
                        fontsize=6.0)
        if 'margin' in column:
            axes.axhline(0.0, color=MUTED, linestyle=DASHED, linewidth=1.0)
            axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    return figure, (
        'A point is a run, the black line the median. Speed: greatest allowed minus greatest '
        'flown. Cone: offset that is allowed minus the one flown, the least beyond 0.3 m.')


FIGURES = {'planners': CampaignFigure(planners, 'Planners of the closing', tuple(DRAWN))}
