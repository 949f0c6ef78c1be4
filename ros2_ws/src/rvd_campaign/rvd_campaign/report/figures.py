"""
Which figures a report has: the mission's own, and that of the link, which every mission gets.
"""

from typing import TYPE_CHECKING

import numpy as np

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, every, Figure, INK, load, VERMILLION)
from rvd_dynamics.recording.recording import Link, Recording

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

PANEL_IN = 1.66                         # height of the panels of one direction of the link
COLOURS = {True: VERMILLION, False: BLUE, None: INK}


def figures_of(run: Recording) -> dict[str, Figure]:
    """
    Return the figures that can be drawn of a recording, by name, in the order of the report.

    Raises
    ------
    ValueError
        If the mission's table of figures cannot be loaded; one line.
    """
    if run.scenario is None or run.last_step < 0:
        return {}
    figures = {name: figure for name, figure in _own(run).items() if not figure.missing(run)}
    return {**figures, 'links': LINKS} if _released(run) else figures


def _own(run: Recording) -> dict[str, Figure]:
    mission = run.scenario.mission
    load()                                  # before a mission that imports it with its figures
    try:
        own = loaded(mission.figures) if mission.figures else {}
    except BadInput as error:
        raise BadInput(f'mission {mission.name}: figures: {error}') from None
    if not isinstance(own, dict) or not all(
            str(name).isidentifier() and isinstance(figure, Figure)
            for name, figure in own.items()):
        raise BadInput(f'mission {mission.name}: {mission.figures} must be a dict of Figure by '
                       'plain names')
    return own


def _released(run: Recording) -> list[Link]:
    """Return the legs of the link whose frames were recorded."""
    return [link for link in run.links.values() if len(link.frames)]


def links(run: Recording) -> 'Canvas':
    """Draw the transit time of every frame that was released, a row for each leg of the link."""
    legs = _released(run)
    figure = canvas(PANEL_IN*len(legs) + 0.48, hspace=0.42, wspace=0.05)
    panels = figure.subplots(len(legs), 2, sharey='row', width_ratios=[4, 1], squeeze=False)
    for (strip, bars), link in zip(panels, legs):
        _transits(strip, bars, link)
    panels[-1, 0].set_xlabel('sent at [s]')
    panels[-1, 1].set_xlabel('frames')
    return figure


def _transits(strip: 'Axes', bars: 'Axes', link: Link) -> None:
    frames, hold, colour = link.frames, link.hold_s, COLOURS[link.upward]
    transit = frames.arrived - frames.sent
    released = np.isfinite(transit)
    strip.plot(frames.sent[released], transit[released], linestyle='', marker='.',
               markersize=3.5, color=colour, markevery=every(transit[released]))
    strip.axhline(hold, color=INK, linewidth=1.2, linestyle=DASHED)
    gaps = link.never_released
    if len(gaps):
        strip.plot(gaps, np.full(len(gaps), hold), linestyle='', marker='x', markersize=6,
                   color=INK, markeredgewidth=1.4, label='never released')
        strip.legend(**ABOVE)
    low = float(np.nanmin(transit, initial=hold))
    strip.set_ylim(low - 0.08 * (hold - low) - 0.02, hold + 0.12 * (hold - low) + 0.05)
    strip.set_title(link.title)
    strip.set_ylabel('transit [s]')
    if released.any():
        bars.hist(transit[released], bins=24, orientation='horizontal', color=colour, alpha=0.7)
    bars.axhline(hold, color=INK, linewidth=1.2, linestyle=DASHED)


LINKS = Figure(
    links, 'Link delays',
    'Transit time of each released frame over the time it was sent, and the distribution of '
    'transit times. Dashed: the constant delay that the play-out buffer makes of them; a frame '
    'that takes longer, or is lost, is never released. In a long run only every n-th dot is '
    'drawn.', signals=())
