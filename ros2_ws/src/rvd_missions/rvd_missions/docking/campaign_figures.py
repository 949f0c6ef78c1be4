"""
Figures of the mission's campaigns: which thruster's failure is survived, what the improvements
bring.
"""

from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import BLUE, CampaignFigure, canvas, INK, VERMILLION
from rvd_dynamics.recording.worded import worded
from rvd_missions.docking.commands import COUNT
from rvd_missions.docking.planner_figures import FIGURES as PLANNERS
from rvd_missions.docking.thruster_layout import layout

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas


LIMITED = {'hover_min_m': 'least distance [m]', 'hover_max_m': 'greatest distance [m]',
           'lateral_m': 'greatest offset in y or z [m]', 'attitude_deg': 'greatest angle [deg]'}


def margins(results: Any) -> tuple['Canvas', str]:
    """Draw how the runs of all conditions fill the limits."""
    scenario = results.campaign.conditions[0].scenario
    aim, limits = scenario.part('aim'), scenario.part('limits')
    bounds = {'hover_min_m': aim.distance_m - limits.band_m,
              'hover_max_m': aim.distance_m + limits.band_m, 'lateral_m': limits.lateral_m,
              'attitude_deg': limits.attitude_deg}
    flown = {name: np.concatenate([np.asarray(table[name], dtype=float)
                                   for table in results.tables.values()]) for name in LIMITED}
    never = ((flown['hover_min_m'] > bounds['hover_max_m'])
             | (flown['hover_max_m'] < bounds['hover_min_m']))
    figure = canvas(2.1, left=0.06, wspace=0.12)
    for axes, (name, words) in zip(figure.subplots(1, len(LIMITED)), LIMITED.items()):
        values = flown[name][~never]
        axes.hist(values[np.isfinite(values)], bins=40, color=BLUE)
        axes.axvline(bounds[name], color=VERMILLION, linewidth=1.2)
        axes.set(xlabel=words, yticks=[])
        axes.locator_params(axis='x', nbins=3)
    figure.subplots_adjust(right=0.975)
    caption = 'Runs by what is judged while they hover; red: the limit.'
    if never.any():
        caption += f' Not drawn: {never.sum():,} of {len(never):,}, never in the band meanwhile.'
    return figure, caption


def thrusters(results: Any) -> tuple['Canvas', str]:
    """Draw the greatest angle while hovering, by thruster and condition, and who hovers."""
    from matplotlib.colors import LogNorm
    names = list(results.tables)
    angle, good = np.full((2, len(names), COUNT), np.nan)
    for row, table in enumerate(results.tables.values()):
        which = np.asarray(table['run']) % COUNT
        for thruster in np.unique(which):
            angle[row, thruster] = np.mean(np.asarray(table['attitude_deg'])[which == thruster])
            good[row, thruster] = np.mean(np.asarray(table['success'])[which == thruster])
    figure = canvas(1.1 + 0.24*len(names), left=0.16)
    axes = figure.subplots()
    drawn = axes.imshow(angle, cmap='cividis', norm=LogNorm(0.2, 180.0), aspect='auto',
                        interpolation='nearest')
    figure.colorbar(drawn, ax=axes, label='greatest angle [deg]', pad=0.01)
    for row, thruster in zip(*np.nonzero(good < 1.0)):
        axes.plot(thruster, row, 'x', color=VERMILLION, markersize=4)
    axes.set_yticks(range(len(names)), [worded(name) for name in names])
    axes.set_xticks(range(0, COUNT, 4))
    groups = layout().groups
    for group in sorted(set(groups)):
        at = [i for i, other in enumerate(groups) if other == group]
        axes.text(np.mean(at), -0.6, group, ha='center', va='bottom', fontsize=7)
        if at[0]:
            axes.axvline(at[0] - 0.5, color=INK, linewidth=1.2)
    axes.set_xlabel('thruster that fails')
    axes.grid(False)
    figure.subplots_adjust(bottom=0.5/figure.get_figheight(), top=1.0 - 0.35/figure.get_figheight())
    return figure, ('Greatest angle while hovering; a cross: not all runs hover; white: the run '
                    'ended before.')


def improvements(results: Any) -> tuple['Canvas', str]:
    """Draw error of attitude and drift of the gyro of each condition, means over its runs."""
    names = list(results.tables)
    figure = canvas(0.8 + 0.2*len(names), left=0.36, wspace=0.12)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, column, words in zip(panels, ('nav_attitude_error_deg', 'gyro_drift_deg_h'), (
            'attitude error, rms of an axis [deg]', 'what is left of the bias [deg/h]')):
        for at, (name, table) in enumerate(results.tables.items()):
            values = np.asarray(table[column], dtype=float)
            colour = VERMILLION if name.startswith('mistuned') else BLUE
            axes.plot(values, np.full(len(values), at), '|', color=colour, alpha=0.4, markersize=5)
            axes.plot(np.nanmean(values), at, 'o', color=colour, markersize=4)
        axes.set(xlabel=words)
        axes.set_xlim(left=0.0)
        axes.locator_params(axis='x', nbins=4)
        axes.invert_yaxis()
    panels[0].invert_yaxis()                    # the axes share it: once is enough
    panels[0].set_yticks(range(len(names)), [worded(name) for name in names])
    return figure, 'Each run and, as a dot, the mean of its condition.'


FIGURES = {
    'margins': CampaignFigure(margins, 'How the limits are filled', tuple(LIMITED)),
    'thrusters': CampaignFigure(thrusters, 'By thruster', ('attitude_deg',)),
    'improvements': CampaignFigure(
        improvements, 'What the improvements bring',
        ('nav_attitude_error_deg', 'gyro_drift_deg_h')),
    **PLANNERS,
}
