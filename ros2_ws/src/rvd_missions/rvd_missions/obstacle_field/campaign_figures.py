"""
The figures of a campaign among obstacles: tracks, speeds, thrust, alarms, spreads.

Tracks and time histories are those of the first run of each condition, flown again.
"""

from typing import Any

import numpy as np

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, CampaignFigure, canvas, DASHED, INK, LINES, ORANGE)
from rvd_dynamics.recording.worded import worded
from rvd_missions.obstacle_field.figures import draw_obstacles, name_planes, planes
from rvd_missions.obstacle_field.signals import TRUTH

Drawn = tuple[Any, str]
LOOKS = LINES * 2


def flown_again(results: Any) -> list[tuple[Any, Any]]:
    """Return the conditions that are shown, each with the true history of its first run."""
    shown = []
    for condition in results.shown:
        run = int(results.tables[condition.name]['run'][0])
        history = fly(condition.scenario, [run], record=[TRUTH]).history[TRUTH]
        shown.append((condition, type(history)(*(part[:, 0] for part in history))))
    return shown


def _seconds(condition: Any, history: Any) -> Any:
    return condition.scenario.run.step_s * np.arange(len(history.state))


def tracks(results: Any) -> Drawn:
    """Draw tracks, a pair of panels for each set of obstacles (Figures 2-4, 7)."""
    groups: dict[bytes, list] = {}
    for condition, history in flown_again(results):
        groups.setdefault(history.obstacles[0].tobytes(), []).append((condition, history))
    figure = canvas(0.3 + 3.0*len(groups), wspace=0.18, hspace=0.42)
    for axes, group in zip(figure.subplots(len(groups), 2, squeeze=False), groups.values()):
        scenario, history = group[0][0].scenario, group[0][1]
        draw_obstacles(axes, history.obstacles, scenario.part('obstacles').radii)
        for (condition, flown), (colour, style, _) in zip(group, LOOKS):
            planes(axes, flown.state, colour, linestyle=style, linewidth=1.1,
                   label=worded(condition.name))
        name_planes(axes, scenario.part('craft'))
        axes[1].legend(loc='best')
    return figure, ('True tracks from the side and from above, as the console shows them. Discs: '
                    'the obstacles where they start; dotted: the way of those that move.')


def speeds(results: Any) -> Drawn:
    """Draw speed over time and over distance (Figures 5, 6, 9, 11)."""
    figure = canvas(6.8, top=0.65, hspace=0.28)
    over_time, over_distance = figure.subplots(2, 1)
    limits = {}
    for (condition, history), (colour, style, _) in zip(flown_again(results), LOOKS):
        craft, corridor = (condition.scenario.part(p) for p in ('craft', 'speed_corridor'))
        r, v = (np.linalg.norm(history.state[:, part], axis=1)
                for part in (slice(0, 3), slice(3, 6)))
        over_time.semilogy(_seconds(condition, history)[1:], 1000.0*np.maximum(v[1:], 1e-6),
                           color=colour, linestyle=style, linewidth=1.1,
                           label=worded(condition.name))
        over_distance.loglog(r[1:] - craft.contact_m, 1000.0*np.maximum(v[1:], 1e-6), color=colour,
                             linestyle=style, linewidth=1.1)
        limits.setdefault(corridor, r - craft.contact_m)
    for corridor, gap in limits.items():
        if corridor.kept or len(limits) == 1:
            over_distance.plot(gap, 1000.0*corridor.limit(gap), color=INK, linewidth=0.7)
    over_time.set(xlabel='time [s]', ylabel='speed [mm/s]', ylim=(0.5, None))
    over_distance.set(xlabel='distance to contact [m]', ylabel='speed [mm/s]', ylim=(0.5, None))
    over_time.legend(ncols=3, **ABOVE)
    return figure, ('Speed of the first run of each condition over time and over the distance to '
                    'contact. Thin lines: the speed corridor.')


def near_target(results: Any) -> Drawn:
    """Draw the speed of the last minutes: where it oscillates (Figures 9 and 11)."""
    shown = flown_again(results)
    figure = canvas(0.5 + 1.35*len(shown), hspace=0.5)
    panels = figure.subplots(len(shown), 1, squeeze=False)[:, 0]
    for panel, (condition, history) in zip(panels, shown):
        t, v = _seconds(condition, history), np.linalg.norm(history.state[:, 3:], axis=1)
        late = t > t[-1] - 300.0
        panel.plot(t[late], 1000.0*v[late], color=BLUE, linewidth=1.0)
        panel.set(ylabel='[mm/s]', ylim=(0.0, None))
        panel.set_title(worded(condition.name))
    panel.set(xlabel='time [s]')
    return figure, 'Speed in the last 300 s of the first run of each condition.'


def accelerations(results: Any) -> Drawn:
    """Draw the executed acceleration along track (Figures 8 and 10)."""
    shown = flown_again(results)
    figure = canvas(0.5 + 1.35*len(shown), hspace=0.5)
    panels = figure.subplots(len(shown), 1, squeeze=False)[:, 0]
    for panel, (condition, history) in zip(panels, shown):
        panel.step(_seconds(condition, history)[:-1], 1000.0*history.acceleration[1:, 0],
                   where='post', color=BLUE, linewidth=0.8)
        panel.set(ylabel='[mm/s²]')
        panel.set_title(worded(condition.name))
    panel.set(xlabel='time [s]')
    return figure, 'Acceleration along track in the first run of each condition.'


def spread(results: Any) -> Drawn:
    """Draw propellant and clearance of all runs, by condition."""
    names = list(results.tables)
    figure = canvas(0.9 + 0.3*len(names), left=0.27, wspace=0.1)
    panels = figure.subplots(1, 3, sharey=True)
    kinds = (('propellant_kg', 'propellant [kg]'), ('clearance_m', 'least clearance [m]'),
             ('alarms', 'alarms'))
    for panel, (column, label) in zip(panels, kinds):
        for at, name in enumerate(names):
            values = np.asarray(results.tables[name][column], dtype=float)
            values = values[np.isfinite(values)]
            if values.size:
                low, first, middle, last, high = np.quantile(values, [0.05, 0.25, 0.5, 0.75, 0.95])
                panel.plot([low, high], [at, at], color=BLUE, linewidth=1.0)
                panel.plot([first, last], [at, at], color=BLUE, linewidth=5.0,
                           solid_capstyle='butt')
                panel.plot(middle, at, 'o', color=ORANGE, markersize=5)
        panel.set(xlabel=label)
    panels[0].set_yticks(range(len(names)), [worded(name) for name in names])
    panels[0].invert_yaxis()
    panels[1].axvline(0.0, color=INK, linestyle=DASHED, linewidth=0.8)
    return figure, 'Median, quartiles, and 5 to 95 % of all runs of each condition.'


FIGURES = {
    'tracks': CampaignFigure(tracks, 'Tracks', tall=True),
    'speeds': CampaignFigure(speeds, 'Approach speed'),
    'near_target': CampaignFigure(near_target, 'Speed near the target', tall=True),
    'accelerations': CampaignFigure(accelerations, 'Thrust along track', tall=True),
    'spread': CampaignFigure(spread, 'Propellant, clearance, alarms',
                             ('propellant_kg', 'clearance_m', 'alarms'), tall=True),
}
