"""
The figures of the limit cycles: the paper's Figures 3 to 6, and where the branches lead.
"""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, GREEN, INK, LINES, MUTED, VERMILLION)
from rvd_missions.elliptic_rendezvous.gains import CycleCase
from rvd_missions.elliptic_rendezvous.limit_cycles import Branch, cycle, Cycle

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

ECCENTRICITIES = (0.05, 0.1, 0.2, 0.3)
PANELS = {      # title: the law and k2 of the paper's figure
    'Figure 3: RRCA, k2 = 0': {'law': 'rrca', 'k2': 0.0},
    'Figure 4: ODRRCA, k2 = 0': {'law': 'odrrca', 'k2': 0.0},
    'Figure 5: RRCA, k2 = -0.5': {'law': 'rrca', 'k2': -0.5},
    'Figure 6: ODRRCA, k2 = -0.5': {'law': 'odrrca', 'k2': -0.5},
}
FORMS = {'R1, k1 = 1': {'form': 'r1', 'k1': 1.0}, 'R2, k1 = 0.5': {'form': 'r2', 'k1': 0.5}}
MARKS = {'period doubling': ('o', VERMILLION), 'fold': ('D', INK), 'torus': ('s', GREEN)}

Cycles = dict[str, dict[float, Cycle | None]]


def cycles(case: CycleCase) -> Cycles:
    """Return the cycles of the four figures, by title and eccentricity; None: there is none."""
    return {title: {e: cycle(replace(case, e=e, **changes)) for e in ECCENTRICITIES}
            for title, changes in PANELS.items()}


def portraits(found: Cycles) -> 'Canvas':
    """Draw the cycles in the plane of direction and direction rate."""
    figure = canvas(6.4, hspace=0.38, wspace=0.2, top=0.5)
    for axes, (title, row) in zip(figure.subplots(2, 2).flat, found.items()):
        for (e, one), (colour, _, _) in zip(row.items(), LINES):
            if one is None:
                continue
            axes.plot(np.degrees(one.path[:, 0]), one.path[:, 1], color=colour,
                      linestyle='-' if one.stable else DASHED,
                      label=f'e = {e:g}' + ('' if one.stable else ', unstable'))
        axes.set(title=title, xlabel='direction [deg]', ylabel='d direction / d anomaly')
        axes.legend(loc='best', fontsize=7.5)
    return figure


def branches(found: dict[str, Branch]) -> 'Canvas':
    """Draw branches in the eccentricity: the direction at perigee and the multipliers."""
    figure = canvas(4.0, wspace=0.2, top=0.5)
    left, right = figure.subplots(1, 2)
    for (name, branch), (colour, _, _) in zip(found.items(), LINES):
        phi = np.degrees(branch.starts[:, 0])
        stable = branch.stable
        largest = [np.abs(np.linalg.eigvals(j)).max() for j in branch.jacobians]
        for axes, values in ((left, phi), (right, largest)):
            values = np.asarray(values)
            axes.plot(branch.at, values, color=colour, linestyle=DASHED, linewidth=1.1)
            axes.plot(branch.at, np.where(stable, values, np.nan), color=colour, linewidth=2.2,
                      label=name)
        for event in branch.events:
            mark, ink = MARKS[event.kind]
            left.plot(event.at, np.degrees(event.start[0]), mark, color=ink, markersize=6)
            right.plot(event.at, np.abs(np.linalg.eigvals(event.jacobian)).max(), mark, color=ink,
                       markersize=6)
    left.set(xlabel='eccentricity', ylabel='direction at perigee [deg]')
    right.set(xlabel='eccentricity', ylabel='largest |multiplier|', yscale='log')
    right.axhline(1.0, color=MUTED, linewidth=0.8)
    right.axhline(np.exp(-np.pi), color=BLUE, linewidth=0.8, linestyle=DASHED)
    left.legend(**ABOVE, ncols=2)
    return figure
