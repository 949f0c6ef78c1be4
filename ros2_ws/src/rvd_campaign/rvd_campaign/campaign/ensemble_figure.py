"""
The figure of a campaign with a sample: each output at all points, and what its variance is due to.
"""

from textwrap import fill
from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import BLUE, canvas, INK, MUTED, ORANGE
from rvd_dynamics.recording.worded import worded

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Drawn = tuple['Figure', str]
THICK = 0.36                            # of a bar
TITLE = 14                              # characters in a line of a panel's title


def ensemble(results: Any) -> Drawn:
    """Draw bands of all outputs, and below, where there are any, their indices."""
    made = results.summary.get('ensemble')
    if made is None:
        return canvas(1.0), 'The campaign has no sample.'
    outputs = list(made['points'][0]['outputs'])
    indexed, groups = bool(made['indices']), made['groups']
    high = 0.6 + 0.42*len(outputs)                          # [in]
    below = (0.6 + 0.34*len(groups)) if indexed else 0.0
    between = 0.9 if indexed else 0.5
    figure = canvas(high + below + between, left=0.21, top=0.15, hspace=0.45)
    grid = figure.add_gridspec(2 if indexed else 1, len(outputs) if indexed else 1,
                               height_ratios=[high, below] if indexed else None, wspace=0.12)
    _bands(figure.add_subplot(grid[0, :]), made, outputs)
    for at, output in enumerate(outputs if indexed else ()):
        _indices(figure.add_subplot(grid[1, at]), made, output, at == 0)
    return figure, _caption(made, indexed)


def _caption(made: dict[str, Any], indexed: bool) -> str:
    chosen = made['accepted']
    text = (f'Above: success rates, and their differences, of {made["latin_hypercube"]} points of '
            'the sample (grey) and of the scenario as it is (orange).')
    if chosen is not None:
        text += (f' Blue: the {len(chosen["points"])} points that agree with '
                 f'{chosen["reference"]} within {chosen["standard_errors"]:g} standard errors, '
                 'and their range.')
    if indexed:
        text += (' Below: Sobol indices of groups of numbers, first order (blue) and total '
                 '(orange), with 95 % intervals.')
    return text


def _bands(axes: 'Axes', made: dict[str, Any], outputs: list[str]) -> None:
    chosen = set(made['accepted']['points']) if made['accepted'] else set()
    points = [p['outputs'] for p in made['points'][:made['latin_hypercube']]]
    good = np.array([k in chosen for k in range(len(points))], dtype=bool)
    for at, output in enumerate(outputs):
        values = np.array([p[output] for p in points])
        spread = 0.22*np.sin(2.4*np.arange(len(points)))        # so that dots do not hide others
        axes.plot(values[~good], at + spread[~good], '.', color=MUTED, markersize=3.5, alpha=0.6,
                  markeredgewidth=0)
        axes.plot(values[good], at + spread[good], '.', color=BLUE, markersize=5.0,
                  markeredgewidth=0)
        if good.any():
            axes.plot([values[good].min(), values[good].max()], [at, at], color=BLUE,
                      linewidth=1.6)
    for band in made['bands']:
        axes.plot(band['fit'], outputs.index(band['output']), 'D', color=ORANGE, markersize=5.5)
    axes.axvline(0.0, color=INK, linewidth=0.8)
    axes.set(yticks=range(len(outputs)), ylim=(len(outputs) - 0.5, -0.5),
             xlabel='success rate, or difference of two')
    axes.set_yticklabels([worded(output) for output in outputs])
    axes.grid(axis='y', visible=False)


def _indices(axes: 'Axes', made: dict[str, Any], output: str, named: bool) -> None:
    rows = [i for i in made['indices'] if i['output'] == output]
    for at, index in enumerate(rows):
        for off, which, colour in ((-0.5, 'first', BLUE), (0.5, 'total', ORANGE)):
            if index[which] is None:
                continue
            axes.barh(at + off*THICK, index[which], THICK, color=colour,
                      xerr=index[f'{which}95'], error_kw={'elinewidth': 0.9, 'ecolor': INK})
    axes.set(yticks=range(len(rows)), ylim=(len(rows) - 0.5, -0.5), xlim=(-0.15, 1.25),
             xticks=[0.0, 0.5, 1.0])
    axes.set_yticklabels([i['group'] for i in rows] if named else [])
    axes.set_title(fill(worded(output), TITLE))
    axes.grid(axis='y', visible=False)
