"""
The figures of a campaign, drawn from its result table; tracks are flown again for those shown.

`FIGURES` lists them by the name a campaign file gives: title, and a function of the results that
returns drawing and caption. Look and colours are those of the figures of a run.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
import numpy as np
from numpy.typing import NDArray

from rvd_campaign.campaign import stats
from rvd_campaign.campaign.results import Table
from rvd_campaign.campaign.spec import Campaign, Condition
from rvd_dynamics.recording.drawing import BLUE, GREEN, INK, MUTED, ORANGE, VERMILLION, WIDTH_IN
from rvd_campaign.loop import fly
from rvd_dynamics.geometry import cone

LANDED, TRACKS = 300, 40                # runs shown per condition
PANELS = 8                              # conditions in a figure of panels
DASHED = (0, (5, 3))
LINES = [(BLUE, '-', 'o'), (VERMILLION, DASHED, 's'), (GREEN, (0, (8, 2, 1, 2)), '^'),
         (ORANGE, (0, (2, 1.5)), 'D'), (INK, '-', 'v'), (MUTED, DASHED, 'P')]
Drawn = tuple[Figure, str]


@dataclass(frozen=True)
class Results:
    """What figures are drawn from."""

    campaign: Campaign
    summary: dict[str, Any]
    tables: dict[str, Table]

    @cached_property
    def rows(self) -> dict[str, dict[str, Any]]:
        """The summaries of the conditions by name."""
        return {c['name']: c for c in self.summary['conditions']}

    @property
    def shown(self) -> tuple[Condition, ...]:
        """The conditions of a figure with one panel each."""
        return self.campaign.conditions[:PANELS]


def success(results: Results) -> Drawn:
    """Draw the success rate of each condition with its interval, beside the references."""
    names = list(results.rows)
    figure = _figure(max(1.6, 0.75 + 0.28*len(names)), left=0.27)
    axes = figure.subplots()
    for at, name in enumerate(names):
        row = results.rows[name]
        fitted = name in results.summary['fitted']
        _interval(axes, at, row['successes'], row['runs'], BLUE, 'o', fitted)
    for label, row in results.campaign.reference.items():
        if row.get('condition') in names:
            _interval(axes, names.index(row['condition']) + 0.25, row['successes'], row['runs'],
                      VERMILLION, 'D', False)
    axes.set(yticks=range(len(names)), ylim=(len(names) - 0.4, -0.6), xlabel='success rate')
    axes.set_yticklabels(names)
    axes.grid(axis='y', visible=False)
    caption = ('Bars: 95 % intervals (Wilson). Hollow markers: fitted to this very success rate, '
               'so not a prediction.')
    if any('condition' in row for row in results.campaign.reference.values()):
        caption += ' Diamonds: the reference rows of the table.'
    return figure, caption


def _interval(axes: Axes, at: float, successes: int, runs: int, colour: str, marker: str,
              hollow: bool) -> None:
    low, high = stats.wilson(successes, runs)
    axes.plot([low, high], [at, at], color=colour, linewidth=2.2)
    axes.plot(successes / runs, at, marker, color=colour, markersize=6,
              markerfacecolor='none' if hollow else colour)


def landing(results: Results) -> Drawn:
    """Draw where successful runs met the docking plane (the paper's figure 7)."""
    shown = results.shown
    columns = min(len(shown), 4 if len(shown) in (4, 7, 8) else 3)
    lines = ceil(len(shown) / columns)
    figure = _figure(0.3 + 3.1*lines, hspace=0.42, wspace=0.24)
    for axes, condition in zip(figure.subplots(lines, columns, squeeze=False).flat, shown):
        mission, table = condition.scenario.mission, results.tables[condition.name]
        good = np.flatnonzero(table['success'])[:LANDED]
        axes.plot(table['y_m'][good], table['z_m'][good], '.', color=BLUE, markersize=4.5,
                  alpha=0.6, markeredgewidth=0)
        radius = mission.corridor.docking_radius_m
        axes.add_patch(Circle((0, 0), radius, fill=False, edgecolor=INK, linewidth=1.6,
                              linestyle=DASHED))
        axes.set(xlim=(-1.1*radius, 1.1*radius), ylim=(-1.1*radius, 1.1*radius), aspect='equal',
                 xlabel='y, radial [m]', ylabel='z, cross track [m]')
        upper = table['y_m'][table['success']] > 0.0
        axes.set_title(f'{condition.name}\n{100*upper.mean():.0f} % at y > 0' if upper.size
                       else condition.name)
    for axes in figure.axes[len(shown):]:
        axes.remove()
    return figure, (
        'Where successful runs met the docking plane, seen along the direction of flight: at most '
        f'the first {LANDED} of each condition. Dashed: the limit. The percentages are of all '
        'successful runs.')


def tracks(results: Results) -> Drawn:
    """Draw tracks of successful runs in both planes (the paper's figures 8 to 11)."""
    shown = results.shown
    figure = _figure(0.55 + 2.25*len(shown), hspace=0.34, wspace=0.14, top=0.58)
    panels = figure.subplots(len(shown), 2, squeeze=False, sharex=True)
    outside = []
    for line, condition in zip(panels, shown):
        states = flown_again(condition, results.tables[condition.name])
        for axes, lateral in zip(line, (1, 2)):
            _side_view(axes, condition, states, lateral)
            axes.set_title(f'{condition.name}: x-{"xyz"[lateral]}')
        if states.shape[1]:
            outside.append(f'{condition.name} {100*_left_boundary(condition, states):.0f} %')
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


def flown_again(condition: Condition, table: Table) -> NDArray[np.float64]:
    """Return the states (steps, n, 6) of the first successful runs of a condition."""
    runs = table['run'][table['success']][:TRACKS]
    if not len(runs):
        return np.empty((0, 0, 6))
    return fly(condition.scenario.loop(), runs.tolist(), record=True).history.truth


def _left_boundary(condition: Condition, states: NDArray[np.float64]) -> float:
    mission = condition.scenario.mission
    x, y, z = states[..., 0], states[..., 1], states[..., 2]
    beyond = np.sqrt(y*y + z*z) > _boundary(mission, np.minimum(x, 0.0))    # NaN compares false
    return float((beyond & (x < 0.0)).any(axis=0).mean())


def _boundary(mission: Any, x: NDArray[np.float64]) -> NDArray[np.float64]:
    return cone.control_boundary(x, mission.corridor, mission.orbit.mean_motion,
                                     delay=mission.forward_delay_s + mission.back_delay_s)


def _side_view(axes: Axes, condition: Condition, states: NDArray[np.float64], lateral: int
               ) -> None:
    mission = condition.scenario.mission
    first = mission.start.position_m[0]
    x = np.linspace(first, 0.0, 121)
    wall, inner = cone.radius(x, mission.corridor), _boundary(mission, x)
    for sign in (1.0, -1.0):
        axes.plot(x, sign*wall, color=INK, linestyle=DASHED, linewidth=1.8,
                  label='corridor wall' if sign > 0 else None)
        axes.plot(x, sign*inner, color=ORANGE, linewidth=1.8,
                  label='control boundary' if sign > 0 else None)
    every = max(1, round(2.0 / mission.step_s))
    for run in range(states.shape[1]):
        track = states[np.isfinite(states[:, run, 0]), run]
        track = np.concatenate([track[:-1:every], track[-1:]])
        axes.plot(track[:, 0], track[:, lateral], color=BLUE, linewidth=0.7, alpha=0.55,
                  label='flown' if run == 0 else None)
    widest = 1.08 * float(wall.max())
    axes.set(xlim=(first - 0.3, 0.6), ylim=(-widest, widest),
             ylabel=f'{"xyz"[lateral]}, {("", "radial", "cross track")[lateral]} [m]')


def curve(results: Results) -> Drawn:
    """Draw the success rate over the first axis of the grid, one line per group."""
    conditions = results.campaign.conditions
    axis = next((a for a in conditions[0].at if _number(conditions[0].at[a]) is not None), None)
    figure = _figure(3.9, top=0.15)
    axes = figure.subplots()
    if axis is None:
        return figure, 'The grid has no axis of numbers.'
    lines: dict[str, list] = {}
    for condition in conditions:
        others = [f'{a.rsplit(".", 1)[-1]} {v}' for a, v in condition.at.items() if a != axis]
        label = ', '.join([condition.group, *others])
        lines.setdefault(label, []).append(condition)
    for (label, members), (colour, style, marker) in zip(lines.items(), LINES * len(lines)):
        members = sorted(members, key=lambda c: _number(c.at[axis]))
        x = np.array([_number(c.at[axis]) for c in members])
        rows = [results.rows[c.name] for c in members]
        low, high = np.array([r['wilson95'] for r in rows]).T
        axes.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
        axes.plot(x, [r['success_rate'] for r in rows], color=colour, linestyle=style,
                  marker=marker, markersize=4.5, label=label if len(lines) > 1 else None)
    for label, row in results.campaign.reference.items():
        if 'at' in row:
            _reference_point(axes, float(row['at']), row, label)
    axes.set(xlabel=axis.rsplit('.', 1)[-1].replace('_s', ' [s]') if axis.endswith('_s')
             else axis.rsplit('.', 1)[-1], ylabel='success rate')
    if len(lines) > 1 or any('at' in row for row in results.campaign.reference.values()):
        axes.legend(loc='best')
    return figure, 'Success rate. Shaded: 95 % interval (Wilson) of each point on its own.'


def _reference_point(axes: Axes, x: float, row: dict, label: str) -> None:
    p, (low, high) = row['successes']/row['runs'], stats.wilson(row['successes'], row['runs'])
    axes.errorbar(x, p, [[p - low], [high - p]], fmt='*', color=INK, markersize=9, capsize=3,
                  label=label)


def failures(results: Results) -> Drawn:
    """Draw at which station runs left the corridor."""
    shown = results.shown
    figure = _figure(3.4, top=0.15)
    axes = figure.subplots()
    first = min(c.scenario.mission.start.position_m[0] for c in shown)
    bins = np.linspace(first, 0.0, 61)
    for condition, (colour, style, _) in zip(shown, LINES * 2):
        table = results.tables[condition.name]
        where = table['failed_x_m'][table['reason'] == 'left_corridor']
        share = np.histogram(where, bins)[0] / len(table['run'])
        axes.stairs(100*np.cumsum(share), bins, color=colour, linestyle=style, linewidth=1.6,
                    baseline=None, label=condition.name)
    axes.set(xlabel='station x [m]', ylabel='left the corridor so far [% of runs]')
    axes.legend(loc='upper left')
    return figure, 'Share of all runs that have left the corridor before reaching each station.'


def replicates(results: Results) -> Drawn:
    """Draw how experiments of the paper's size scatter."""
    campaign = results.campaign
    size = campaign.replicates[0] * campaign.replicates[1] if campaign.replicates else 1
    figure = _figure(3.3, wspace=0.22)
    left, right = figure.subplots(1, 2)
    rates = {name: table['success'].reshape(-1, size).mean(axis=1)
             for name, table in results.tables.items()}
    for (name, values), (colour, style, _) in zip(rates.items(), LINES):
        _bars(left, values, size, colour, style, name)
    for label, row in campaign.reference.items():
        left.axvline(row['successes'] / row['runs'], color=INK, linewidth=1.2, linestyle=DASHED)
        left.text(row['successes'] / row['runs'], 0.98, f' {label}', rotation=90, va='top',
                  ha='right', fontsize=7.5, transform=left.get_xaxis_transform())
    left.set(xlabel=f'success rate of {size} runs', ylabel='share of experiments')
    left.legend(loc='upper left')
    for a, b in campaign.compare[:1]:
        _bars(right, rates[a] - np.roll(rates[b], 1), size, BLUE, '-', 'other draws')
        _bars(right, rates[a] - rates[b], size, VERMILLION, DASHED, 'same draws')
        right.set_title(f'{a} minus {b}')
    right.set(xlabel='difference of success rates')
    right.axvline(0.0, color=INK, linewidth=1.0)
    right.legend(loc='upper left')
    count = len(next(iter(rates.values())))
    return figure, (
        f'{count:,} experiments of {size} runs each. Right: difference between the two conditions '
        'within one experiment, flown with the same people, starts and noise (same draws), and '
        'between one experiment and the next (other draws, and so other people).')


def _bars(axes: Axes, values: NDArray, size: int, colour: str, style: Any, label: str) -> None:
    counts, found = np.unique(np.rint(values*size).astype(int), return_counts=True)
    edges = (np.arange(counts[0], counts[-1] + 2) - 0.5) / size
    filled = np.zeros(len(edges) - 1)
    filled[counts - counts[0]] = found / len(values)
    axes.stairs(filled, edges, color=colour, linestyle=style, linewidth=1.5, label=label)


FIGURES: dict[str, tuple[str, Callable[[Results], Drawn]]] = {
    'success': ('Success', success),
    'curve': ('Success over the grid', curve),
    'landing': ('At the docking plane', landing),
    'tracks': ('Tracks', tracks),
    'failures': ('Where runs fail', failures),
    'replicates': ('Experiments of the paper\u2019s size', replicates),
}
NEEDED = ['run', 'success', 'reason', 'failed_x_m', 'y_m', 'z_m']       # columns


def _figure(height_in: float, top: float = 0.35, left: float = 0.07, **spaces: float) -> Figure:
    figure = Figure(figsize=(WIDTH_IN, height_in))
    figure.subplots_adjust(left=left, right=0.985, bottom=0.47/height_in,
                           top=1.0 - top/height_in, **spaces)
    return figure


def _number(value: Any) -> float | None:
    try:
        return float(value)
    except (TypeError, ValueError):
        return None
