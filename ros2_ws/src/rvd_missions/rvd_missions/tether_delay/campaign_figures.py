"""
The figure of a campaign over delays: what a late order costs.
"""

from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import ABOVE, CampaignFigure, canvas, INK, LINES
from rvd_dynamics.recording.worded import worded

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

DRAWN = {'stood_range_m': 'stands before the target at [m]', 'closest_m': 'closest distance [m]',
         'miss_m': 'miss at the end of the plan [m]'}


def delays(results: Any) -> tuple['Canvas', str]:
    """Draw where the gripper stood, how near it came and how it missed, over the loop delay."""
    figure = canvas(6.6, top=0.5, hspace=0.14)
    panels = figure.subplots(len(DRAWN), 1, sharex=True)
    groups: dict[str, list] = {}
    for condition in results.campaign.conditions:
        legs = condition.scenario.part('legs')
        groups.setdefault(condition.group, []).append(
            (legs.loop*legs.step_s, results.tables[condition.name]))
    for (name, found), (colour, style, marker) in zip(groups.items(), LINES):
        found.sort(key=lambda pair: pair[0])
        for axes, column in zip(panels, DRAWN):
            known = [(delay, values[np.isfinite(values)]) for delay, values in (
                (delay, np.asarray(table[column])) for delay, table in found)]
            known = [(delay, values) for delay, values in known if len(values)]
            x = [delay for delay, _ in known]
            low, middle, high = (np.array([np.quantile(v, q) for _, v in known])
                                 for q in (0.05, 0.5, 0.95))
            axes.fill_between(x, low, high, color=colour, alpha=0.15, linewidth=0.0)
            axes.plot(x, middle, color=colour, linestyle=style, marker=marker, markersize=3.5,
                      label=worded(name))
    for axes, label in zip(panels, DRAWN.values()):
        axes.set(ylabel=label)
    panels[1].axhline(0.0, color=INK, linewidth=0.8)
    panels[-1].set(xlabel='loop delay [s]')
    panels[0].legend(ncols=len(groups), **ABOVE)
    return figure, ('Medians over the runs in which the value is known, with the range of 5 to '
                    '95 %, over the delay of forward and back leg together.')


FIGURES = {'delays': CampaignFigure(delays, 'What a late order costs', columns=tuple(DRAWN))}
