"""
The figures of a campaign of approaches: where runs dock, fly and fail, and what it costs.

They are drawn from the result table; tracks are flown again for the runs that are shown.
"""

from math import ceil, sqrt
from textwrap import fill
from typing import Any, TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry import cone
from rvd_dynamics.recording.drawing import (
    beside, BLUE, CampaignFigure, canvas, DASHED, INK, LINES, ORANGE)
from rvd_dynamics.recording.worded import worded
from rvd_missions.lunar_approach import cluttered
from rvd_missions.lunar_approach.figures import upwards
from rvd_missions.lunar_approach.signals import TRUTH

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

LANDED, TRACKS = 300, 40                # runs shown per condition
COMPARED = {'delta_v_m_s': 'delta-v [m/s]', 'duration_s': 'time [s]', 'offset_m': 'offset [m]',
            'min_corridor_margin_m': 'least margin [m]'}
# of predictions: what is right, and the label
PREDICTED = {'prediction_nees': (6.0, 'NEES of the prediction'),
             'prediction_coverage_2sigma': (0.954, 'share within two sigma')}
Drawn = tuple['Canvas', str]


def landing(results: Any) -> Drawn:
    """Draw where successful runs met the docking plane (the paper's figure 7)."""
    from matplotlib.patches import Circle
    shown = results.shown
    columns = min(len(shown), 4 if len(shown) in (4, 7, 8) else 3)
    lines = ceil(len(shown) / columns)
    titles = [_landed(c.name, results.tables[c.name], 96 // columns) for c in shown]
    top = 0.12 + 0.16*max(title.count('\n') + 1 for title in titles)
    figure = canvas(0.3 + 3.1*lines, top=top, hspace=0.42, wspace=0.24)
    panels = figure.subplots(lines, columns, squeeze=False).flat
    for axes, condition, title in zip(panels, shown, titles):
        table = results.tables[condition.name]
        good = np.flatnonzero(table['success'])[:LANDED]
        axes.plot(table['z_m'][good], table['y_m'][good], '.', color=BLUE, markersize=4.5,
                  alpha=0.6, markeredgewidth=0)
        radius = condition.scenario.part('cone').docking_radius_m
        axes.add_patch(Circle((0, 0), radius, fill=False, edgecolor=INK, linewidth=1.6,
                              linestyle=DASHED))
        axes.set(xlim=(-1.1*radius, 1.1*radius), ylim=(-1.1*radius, 1.1*radius), aspect='equal',
                 xlabel='z, cross track [m]', ylabel='y, radial [m]')
        axes.set_title(title)
    for axes in figure.axes[len(shown):]:
        axes.remove()
    return figure, (
        'Where successful runs met the docking plane, seen along the direction of flight: at most '
        f'the first {LANDED} of each condition. Dashed: the limit. The percentages are of all '
        'successful runs.' + _skew(results))


def _skew(results: Any) -> str:
    """Return score tests of landings at y > 0: against a half, and between compared conditions."""
    counts = {name: (int((table['y_m'][table['success']] > 0.0).sum()),
                     int(table['success'].sum())) for name, table in results.tables.items()}
    halves = [f'{worded(name)} {(upper - runs/2.0)/sqrt(runs/4.0):+.1f}'
              for name, (upper, runs) in counts.items() if runs]
    pairs = [f'{worded(a)} minus {worded(b)} {skew_z(counts[a], counts[b]):+.1f}'
             for a, b in results.campaign.compare if counts[a][1] and counts[b][1]]
    return ''.join(f' {words}: {", ".join(said)}.' for words, said in (
        ('z of the share at y > 0 against a half', halves),
        ('z of the difference of two such shares', pairs)) if said)


def skew_z(a: tuple[int, int], b: tuple[int, int]) -> float:
    """
    Return the score statistic of the difference of two proportions (successes, runs).

    With the pooled variance of independent samples: conditions that share their draws scatter
    together, so that z is rather too near 0. NaN: all are alike.
    """
    pooled = (a[0] + b[0])/(a[1] + b[1])
    variance = pooled*(1.0 - pooled)*(1.0/a[1] + 1.0/b[1])
    return (a[0]/a[1] - b[0]/b[1])/sqrt(variance) if variance > 0.0 else float('nan')


def _landed(name: str, table: dict[str, NDArray], width: int) -> str:
    """Return the title of a condition's panel, in lines of `width` characters."""
    upper, words = table['y_m'][table['success']] > 0.0, fill(worded(name), width)
    return f'{words}\n{100*upper.mean():.0f} % at y > 0' if upper.size else words


def tracks(results: Any) -> Drawn:
    """Draw tracks of successful runs in both planes (the paper's figures 8 to 11)."""
    shown = results.shown
    figure = canvas(0.55 + 2.25*len(shown), hspace=0.34, wspace=0.14, top=0.58)
    panels = figure.subplots(len(shown), 2, squeeze=False, sharex=True)
    outside = []
    for line, condition in zip(panels, shown):
        states = flown_again(condition.scenario, results.tables[condition.name])
        for axes, lateral in zip(line, (1, 2)):
            _side_view(axes, condition.scenario, states, lateral)
            axes.set_title(fill(f'{worded(condition.name)}: '
                                f'{("", "from the side", "from above")[lateral]}', 56))
        if states.shape[1]:
            share = _left_boundary(condition.scenario, states)
            outside.append(f'{worded(condition.name)} {100*share:.0f} %')
    for axes in panels[-1]:
        axes.set_xlabel('x, along track [m]')
    figure.legend(*panels[0, 0].get_legend_handles_labels(), ncols=3, loc='upper right',
                  bbox_to_anchor=(0.99, 1.0))
    return figure, (
        f'The first {TRACKS} successful runs of each condition, flown again for this figure. '
        'Dashed: the corridor wall; solid: the control boundary. Each panel shows the cone cut '
        'along its axis. Share of these runs that were outside the control boundary at some time: '
        f'{"; ".join(outside) or "none shown"}. According to the paper, tracks flown under shared '
        'control stay inside it.')


def flown_again(scenario: Scenario, table: dict[str, NDArray]) -> NDArray[np.float64]:
    """Return the states (steps, n, 6) of the first successful runs of a table."""
    runs = table['run'][table['success']][:TRACKS]
    if not len(runs):
        return np.empty((0, 0, 6))
    return fly(scenario, runs.tolist(), record=[TRUTH.name]).history[TRUTH.name].state


def _left_boundary(scenario: Scenario, states: NDArray[np.float64]) -> float:
    x, y, z = states[..., 0], states[..., 1], states[..., 2]
    beyond = np.sqrt(y*y + z*z) > _boundary(scenario, np.minimum(x, 0.0))    # NaN compares false
    return float((beyond & (x < 0.0)).any(axis=0).mean())


def _boundary(scenario: Scenario, x: NDArray[np.float64]) -> NDArray[np.float64]:
    return cone.control_boundary(x, scenario.part('cone'), scenario.part('orbit').mean_motion,
                                 scenario.part('approach_rate_m_s'),
                                 scenario.part('leg_params').loop_s)


def _side_view(axes: 'Axes', scenario: Scenario, states: NDArray[np.float64], lateral: int
               ) -> None:
    first = scenario.part('start').position_m[0]
    x = np.linspace(first, 0.0, 121)
    wall, inner = cone.radius(x, scenario.part('cone')), _boundary(scenario, x)
    for sign in (1.0, -1.0):
        axes.plot(x, sign*wall, color=INK, linestyle=DASHED, linewidth=1.8,
                  label='corridor wall' if sign > 0 else None)
        axes.plot(x, sign*inner, color=ORANGE, linewidth=1.8,
                  label='control boundary' if sign > 0 else None)
    every = max(1, round(2.0 / scenario.run.step_s))
    for run in range(states.shape[1]):
        track = states[np.isfinite(states[:, run, 0]), run]
        track = np.concatenate([track[:-1:every], track[-1:]])
        axes.plot(track[:, 0], track[:, lateral], color=BLUE, linewidth=0.7, alpha=0.55,
                  label='flown' if run == 0 else None)
    widest = 1.08 * float(wall.max())
    axes.set(xlim=(first - 0.3, 0.6), ylim=upwards(lateral, widest),
             ylabel=f'{"xyz"[lateral]}, {("", "radial", "cross track")[lateral]} [m]')


def failures(results: Any) -> Drawn:
    """Draw at which station runs left the corridor."""
    shown = results.shown
    figure = canvas(3.4, top=0.15)
    axes = figure.subplots()
    first = min(c.scenario.part('start').position_m[0] for c in shown)
    bins = np.linspace(first, 0.0, 61)
    for condition, (colour, style, _) in zip(shown, LINES * 2):
        table = results.tables[condition.name]
        where = table['failed_x_m'][table['reason'] == 'left_corridor']
        share = np.histogram(where, bins)[0] / len(table['run'])
        axes.stairs(100*np.cumsum(share), bins, color=colour, linestyle=style, linewidth=1.6,
                    baseline=None, label=worded(condition.name))
    axes.set(xlabel='station x [m]', ylabel='left the corridor so far [% of runs]')
    axes.legend(loc='upper left')
    return figure, 'Share of all runs that have left the corridor before reaching each station.'


def comparison(results: Any) -> Drawn:
    """Draw success, delta-v, time, offset and least margin of every condition side by side."""
    names = list(results.tables)
    words = [worded(name) for name in names]
    figure = canvas(1.0 + 0.27*len(names), left=beside(words), wspace=0.12, top=0.15)
    first, *panels = figure.subplots(1, 1 + len(COMPARED), sharey=True)
    for at, name in enumerate(names):
        row, table = results.rows[name], results.tables[name]
        first.plot(row['wilson95'], [at, at], color=BLUE, linewidth=2.2)
        first.plot(row['success_rate'], at, 'o', color=BLUE, markersize=5)
        for panel, column in zip(panels, COMPARED):
            _spread(panel, at, table[column][table['success']])
    first.set(xlabel='success', xlim=(-0.05, 1.05))
    first.set_yticks(range(len(names)), words)
    first.set_ylim(len(names) - 0.4, -0.6)
    for panel, label in zip(panels, COMPARED.values()):
        panel.set(xlabel=label)
    for panel in figure.axes:
        panel.grid(axis='y', visible=False)
    return figure, ('Success with its 95 % interval (Wilson). The others: median, quartiles, and 5 '
                    'to 95 % of the successful runs of each condition.')


def consistency(results: Any) -> Drawn:
    """Draw what predictions were worth in every condition: NEES, and how often within two sigma."""
    names = list(results.tables)
    words = [worded(name) for name in names]
    figure = canvas(1.0 + 0.27*len(names), left=beside(words), wspace=0.08, top=0.15)
    panels = figure.subplots(1, 2, sharey=True)
    for panel, (column, (right, label)) in zip(panels, PREDICTED.items()):
        panel.axvline(right, color=INK, linestyle=DASHED, linewidth=1.2)
        for at, name in enumerate(names):
            values = results.tables[name][column]
            values = values[~np.isnan(values)]
            if not len(values):
                continue
            panel.plot(np.quantile(values, [0.05, 0.95]), [at, at], color=BLUE, linewidth=1.0)
            off = 1.96*values.std()/np.sqrt(len(values))
            panel.plot([values.mean() - off, values.mean() + off], [at, at], color=BLUE,
                       linewidth=5.0, solid_capstyle='butt')
            panel.plot(values.mean(), at, 'o', color=ORANGE, markersize=4.5)
        panel.set(xlabel=label)
        panel.grid(axis='y', visible=False)
    panels[0].set_xscale('log')
    panels[0].set_yticks(range(len(names)), words)
    panels[0].set_ylim(len(names) - 0.4, -0.6)
    return figure, (
        'Each prediction of each run held against the truth of its instant. Dots: mean of all '
        'runs, with its 95 % interval; thin lines: 5 to 95 % of the runs. Dashed: what a normally '
        'distributed error of the claimed covariance gives, 6 and 95.4 %.')


def _spread(axes: 'Axes', at: int, values: NDArray[np.float64]) -> None:
    if not len(values):
        return
    low, lower, middle, upper, high = np.quantile(values, [0.05, 0.25, 0.5, 0.75, 0.95])
    axes.plot([low, high], [at, at], color=BLUE, linewidth=1.0)
    axes.plot([lower, upper], [at, at], color=BLUE, linewidth=5.0, solid_capstyle='butt')
    axes.plot(middle, at, 'o', color=ORANGE, markersize=4.5)


FIGURES = {
    'landing': CampaignFigure(landing, 'At the docking plane', ('y_m', 'z_m'), tall=True),
    'tracks': CampaignFigure(tracks, 'Tracks', tall=True),
    'failures': CampaignFigure(failures, 'Where runs fail', ('failed_x_m',)),
    'comparison': CampaignFigure(comparison, 'Conditions side by side', tuple(COMPARED), tall=True),
    'consistency': CampaignFigure(consistency, 'What predictions are worth', tuple(PREDICTED),
                                  tall=True),
    'cluttered': CampaignFigure(cluttered.draw, 'Among obstacles', cluttered.COLUMNS, tall=True),
}
