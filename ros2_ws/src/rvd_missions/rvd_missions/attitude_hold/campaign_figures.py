"""
The figure of a campaign over faults: each measure with both laws, and the paired difference.
"""

from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, CampaignFigure, canvas, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.worded import worded
from rvd_missions.attitude_hold.comparison import LAWS, Mean, Row, rows

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

DRAWN = {'rms_final_deg': 'rms at the end [deg]', 'overshoot_deg': 'overshoot [deg]',
         'settling_s': 'time to settle [s]'}
LOOKS = {'golden_section': (BLUE, 'o'), 'pid': (VERMILLION, 's')}
GROUPS = INK, GREEN, ORANGE, MUTED              # of cells that share all but the first word


def comparison(results: Any) -> tuple['Canvas', str]:
    """Draw the means of both laws, and golden_section minus pid run by run."""
    from matplotlib.ticker import NullFormatter

    found = rows(results.tables, tuple(DRAWN))
    figure = canvas(0.9 + 2.1*len(DRAWN), top=0.5, hspace=0.2, wspace=0.20)
    panels = figure.subplots(len(DRAWN), 2, squeeze=False, sharex=True)
    names = list(dict.fromkeys(_split(row.cell)[0] for row in found))
    groups = list(dict.fromkeys(_split(row.cell)[1] for row in found))
    for (left, right), (measure, label) in zip(panels, DRAWN.items()):
        chosen = [row for row in found if row.measure == measure]
        _levels(left, chosen, names, groups)
        _differences(right, chosen, names, groups)
        left.set(ylabel=label, yscale='log')
        left.yaxis.set_minor_formatter(NullFormatter())
        right.axhline(0.0, color=INK, linewidth=1.0)
    panels[0, 0].set_title('Mean with each law')
    panels[0, 1].set_title('golden section minus PID, run by run')
    for axes in panels[-1]:
        axes.set_xticks(range(len(names)), [name.replace(' ', '\n') for name in names],
                        fontsize=6.0)
    panels[0, 0].legend(ncols=2, **ABOVE)
    if len(groups) > 1:
        panels[1, 1].legend(ncols=len(groups), **ABOVE)
    figure.subplots_adjust(bottom=0.9/figure.get_figheight())
    return figure, (
        'Left: means over all runs in which the measure is known; in each group in the order of '
        'the colours on the right. Right: mean of the paired '
        'difference with its 95 % interval (Student), each on its own; below 0 golden section has '
        'the smaller value. ' + ' '.join(_count(found, measure) for measure in DRAWN))


def _split(cell: str) -> tuple[str, str]:
    """Return the first axis of a cell and the others, without the names of axes."""
    first, *rest = [word.partition('=')[2] for word in cell.split(',')] or ['']
    return first, ', '.join(rest)


def _place(row: Row, names: list[str], groups: list[str]) -> tuple[float, int]:
    name, group = _split(row.cell)
    at = groups.index(group)
    return names.index(name) + 0.22*(at - 0.5*(len(groups) - 1)), at


def _levels(axes: 'Axes', chosen: list[Row], names: list[str], groups: list[str]) -> None:
    for law, which in zip(LAWS, ('first', 'second')):
        colour, marker = LOOKS[law]
        x = [_place(row, names, groups)[0] for row in chosen]
        y = [getattr(row, which).value for row in chosen]
        axes.plot(x, np.maximum(y, 1e-9), marker, color=colour, markersize=4.0, label=worded(law))


def _differences(axes: 'Axes', chosen: list[Row], names: list[str], groups: list[str]) -> None:
    seen = set()
    for row in chosen:
        x, at = _place(row, names, groups)
        colour = GROUPS[at % len(GROUPS)]
        d: Mean = row.difference
        axes.plot([x, x], [d.low, d.high], color=colour, linewidth=2.0)
        axes.plot(x, d.value, 'o', color=colour, markersize=3.5,
                  label=None if at in seen else groups[at])
        seen.add(at)


def _count(found: list[Row], measure: str) -> str:
    signs = [row.difference.sign for row in found if row.measure == measure]
    return (f'{DRAWN[measure].partition(" [")[0].capitalize()}: smaller with golden section in '
            f'{signs.count(-1)} of {len(signs)} cells, with PID in {signs.count(1)}.')


FIGURES = {
    'comparison': CampaignFigure(comparison, 'Golden section against PID', tuple(DRAWN)),
}
