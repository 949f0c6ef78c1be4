"""
The figures of a campaign that any mission can have, drawn from its summary and result table.

`figures_of` lists them by the name a campaign file gives, with those of the mission. Look and
colours are those of the figures of a run.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_campaign.campaign import stats
from rvd_campaign.campaign.ensemble_figure import ensemble
from rvd_campaign.campaign.forest import differences
from rvd_campaign.campaign.results import Table
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.mission import Mission
from rvd_dynamics.recording.drawing import (
    BLUE, CampaignFigure, canvas, DASHED, INK, LINES, load, VERMILLION)
from rvd_dynamics.recording.worded import worded, worded_axis

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SUCCESS, FAILURE = 'success rate', 'failure rate'
CROWDED = 0.9                           # success rate above which failures are what differs
LOGARITHMIC = (' Failures on a logarithmic axis, with the same intervals; a triangle is the upper '
               'end where none was seen.')
PANELS = 8                              # conditions in a figure of panels
ALWAYS = ('run', 'success', 'reason')   # columns that every result table has
Drawn = tuple['Figure', str]


@dataclass(frozen=True)
class Results:
    """What figures are drawn from."""

    campaign: Any               # spec.Campaign, which asks here for the names of figures
    summary: dict[str, Any]
    tables: dict[str, Table]

    @cached_property
    def rows(self) -> dict[str, dict[str, Any]]:
        """The summaries of the conditions by name."""
        return {c['name']: c for c in self.summary['conditions']}

    @property
    def shown(self) -> tuple[Any, ...]:
        """The conditions of a figure with one panel each."""
        return self.campaign.conditions[:PANELS]


def success(results: Results) -> Drawn:
    """Draw the success rate of each condition with its interval, beside the references."""
    names = list(results.rows)
    said = [worded(name) for name in names]
    left = min(0.04 + 0.0072*max(map(len, said)), 0.5)          # room for the longest name
    figure = canvas(max(1.6, 0.75 + 0.28*len(names)), left=left, wspace=0.06)
    kinds = kinds_of(results)
    for axes, kind in zip(figure.subplots(1, len(kinds), squeeze=False, sharey=True)[0], kinds):
        for at, name in enumerate(names):
            row = results.rows[name]
            fitted = name in results.summary['fitted']
            _interval(axes, at, row, BLUE, 'o', fitted, kind)
        for label, row in results.campaign.reference.items():
            if row.get('condition') in names:
                _interval(axes, names.index(row['condition']) + 0.25, row, VERMILLION, 'D', False,
                          kind)
        axes.set(yticks=range(len(names)), ylim=(len(names) - 0.4, -0.6), xlabel=kind)
        axes.grid(axis='y', visible=False)
        if kind == FAILURE:
            axes.set_xscale('log')
            _ticks(axes.xaxis)
    figure.axes[0].set_yticklabels(said)
    caption = ('Bars: 95 % intervals (Wilson). Hollow markers: fitted to this very success rate, '
               'so not a prediction.')
    if any('condition' in row for row in results.campaign.reference.values()):
        caption += ' Diamonds: the reference rows of the table.'
    return figure, caption + (LOGARITHMIC if FAILURE in kinds else '')


def kinds_of(results: Results) -> list[str]:
    """Return what is drawn: failures beside successes where these crowd below 1."""
    high = any(row['success_rate'] > CROWDED for row in results.rows.values())
    return [SUCCESS, FAILURE] if high else [SUCCESS]


def _interval(axes: 'Axes', at: float, row: dict[str, Any], colour: str, marker: str,
              hollow: bool, kind: str) -> None:
    middle, low, high = shown_as(kind, row)
    axes.plot([low, high], [at, at], color=colour, linewidth=2.2)
    axes.plot(high if np.isnan(middle) else middle, at, '<' if np.isnan(middle) else marker,
              color=colour, markersize=6, markerfacecolor='none' if hollow else colour)


def shown_as(kind: str, row: dict[str, Any]) -> tuple[float, float, float]:
    """
    Return the rate of successes or failures of a row, and its interval.

    Where nothing failed a logarithmic axis has no place for the rate, which is NaN, nor for the
    interval's lower end, which is then a tenth of a run.
    """
    successes, runs = row['successes'], row['runs']
    low, high = stats.wilson(successes, runs)
    if kind == SUCCESS:
        return successes / runs, low, high
    failed = 1.0 - successes / runs
    return failed if successes < runs else float('nan'), max(1.0 - high, 0.1/runs), 1.0 - low


def _ticks(axis: Any) -> None:
    """Give a logarithmic axis ticks at 1, 2 and 5 of each decade, written out."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f'{value:g}'))
    axis.set_minor_locator(NullLocator())


def curve(results: Results) -> Drawn:
    """Draw the success rate over the first axis of the grid, one line per group."""
    conditions = results.campaign.conditions
    axis = next((a for a in conditions[0].at if _number(conditions[0].at[a]) is not None), None)
    if axis is None:
        return canvas(3.9, top=0.15), 'The grid has no axis of numbers.'
    lines: dict[tuple[str, str], list] = {}
    for condition in conditions:
        others = [f'{a.rsplit(".", 1)[-1]}={v}' for a, v in condition.at.items() if a != axis]
        lines.setdefault((condition.group, worded(','.join(others))), []).append(condition)
    groups = list(dict.fromkeys(group for group, _ in lines))
    apart = groups if len(lines) > len(LINES) and len(groups) > 1 else [None]
    kinds = kinds_of(results)
    if len(apart) == 1:
        figure = canvas(3.9, top=0.15, wspace=0.2)
        panels = figure.subplots(1, len(kinds), squeeze=False).T
    else:
        figure = canvas(3.7*len(kinds), top=0.3, hspace=0.25, wspace=0.2)
        panels = figure.subplots(len(kinds), len(apart), squeeze=False)
    for kind, row in zip(kinds, panels):
        for group, axes in zip(apart, row):
            mine = {name: members for name, members in lines.items() if group in (None, name[0])}
            _lines(axes, results, axis, mine, kind, group)
    return figure, ('Success rate. Shaded: 95 % interval (Wilson) of each point on its own.'
                    + (LOGARITHMIC if FAILURE in kinds else ''))


def _lines(axes: 'Axes', results: Results, axis: str, lines: dict[tuple[str, str], list],
           kind: str, group: str | None) -> None:
    """Draw lines of conditions by (group, rest of the name); `group`: that of the panel."""
    for ((of, rest), members), (colour, style, marker) in zip(lines.items(), LINES * len(lines)):
        members = sorted(members, key=lambda c: _number(c.at[axis]))
        x = np.array([_number(c.at[axis]) for c in members])
        middle, low, high = np.array([shown_as(kind, results.rows[c.name]) for c in members]).T
        label = rest if group else ', '.join(filter(None, (worded(of), rest)))
        axes.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
        axes.plot(x, middle, color=colour, linestyle=style, marker=marker, markersize=4.5,
                  label=label if len(lines) > 1 else None)
    for label, row in results.campaign.reference.items():
        if 'at' in row:
            _reference_point(axes, float(row['at']), row, label, kind)
    axes.set(xlabel=worded_axis(axis.rsplit('.', 1)[-1]), ylabel=kind)
    if group:
        axes.set_title(worded(group))
    if kind == FAILURE:
        axes.set_yscale('log')
        _ticks(axes.yaxis)
    elif len(lines) > 1 or any('at' in row for row in results.campaign.reference.values()):
        axes.legend(loc='best', fontsize=7.5)


def _reference_point(axes: 'Axes', x: float, row: dict, label: str, kind: str) -> None:
    p, low, high = shown_as(kind, row)
    axes.errorbar(x, p, [[p - low], [high - p]], fmt='*', color=INK, markersize=9, capsize=3,
                  label=label)


def replicates(results: Results) -> Drawn:
    """Draw how experiments of the paper's size scatter."""
    campaign = results.campaign
    size = campaign.replicates[0] * campaign.replicates[1] if campaign.replicates else 1
    figure = canvas(3.3, wspace=0.22)
    left, right = figure.subplots(1, 2)
    rates = {name: table['success'].reshape(-1, size).mean(axis=1)
             for name, table in results.tables.items()}
    for (name, values), (colour, style, _) in zip(rates.items(), LINES):
        _bars(left, values, size, colour, style, worded(name))
    for label, row in campaign.reference.items():
        left.axvline(row['successes'] / row['runs'], color=INK, linewidth=1.2, linestyle=DASHED)
        left.text(row['successes'] / row['runs'], 0.98, f' {label}', rotation=90, va='top',
                  ha='right', fontsize=7.5, transform=left.get_xaxis_transform())
    left.set(xlabel=f'success rate of {size} runs', ylabel='share of experiments')
    left.legend(loc='upper left')
    for a, b in campaign.compare[:1]:
        _bars(right, rates[a] - np.roll(rates[b], 1), size, BLUE, '-', 'other draws')
        _bars(right, rates[a] - rates[b], size, VERMILLION, DASHED, 'same draws')
        right.set_title(f'{worded(a)} minus {worded(b)}')
    right.set(xlabel='difference of success rates')
    right.axvline(0.0, color=INK, linewidth=1.0)
    right.legend(loc='upper left')
    count = len(next(iter(rates.values())))
    return figure, (
        f'{count:,} experiments of {size} runs each. Right: difference between the two conditions '
        'within one experiment, flown with the same people, starts and noise (same draws), and '
        'between one experiment and the next (other draws, and so other people).')


def _bars(axes: 'Axes', values: NDArray, size: int, colour: str, style: Any, label: str) -> None:
    counts, found = np.unique(np.rint(values*size).astype(int), return_counts=True)
    edges = (np.arange(counts[0], counts[-1] + 2) - 0.5) / size
    filled = np.zeros(len(edges) - 1)
    filled[counts - counts[0]] = found / len(values)
    axes.stairs(filled, edges, color=colour, linestyle=style, linewidth=1.5, label=label)


def _number(value: Any) -> float | None:
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


FIGURES = {
    'success': CampaignFigure(success, 'Success'),
    'curve': CampaignFigure(curve, 'Success over the grid'),
    'differences': CampaignFigure(differences, 'Comparisons side by side', tall=True),
    'ensemble': CampaignFigure(ensemble, 'How sharp the results are', tall=True),
    'replicates': CampaignFigure(replicates, 'Experiments of the paper\u2019s size'),
}


def figures_of(mission: Mission) -> dict[str, CampaignFigure]:
    """
    Return the figures that a campaign of a mission may have, by name.

    Raises
    ------
    ValueError
        If the mission's table of figures cannot be loaded; one line.
    """
    load()                                  # before a mission that imports it with its figures
    try:
        return {**FIGURES, **(loaded(mission.campaign_figures) if mission.campaign_figures else {})}
    except (ImportError, ValueError) as error:
        raise BadInput(f'mission {mission.name}: campaign figures: {error}') from None


def shown_by(campaign: Any) -> dict[str, CampaignFigure]:
    """Return the figures that a campaign asks for, by name."""
    known = figures_of(campaign.mission)
    return {name: known[name] for name in campaign.figures or ('success',)}


def needed(campaign: Any) -> list[str]:
    """Return the columns of the result table from which a campaign's figures are drawn."""
    return list(dict.fromkeys((*ALWAYS, *(column for figure in shown_by(campaign).values()
                                          for column in figure.columns))))
