"""
What figures are made of: how one is declared, the house's look, and drawings as SVG or PNG.

Colours are Okabe and Ito's, which colour-blind readers tell apart; line style and weight say
the same once more. In the SVG they are names (`var(--ink)`) that the page gives values to, so
that one drawing serves light, dark and print. Text stays text.

matplotlib is imported where something is drawn: to list the figures of a mission takes none. The
user's settings of it (MPLBACKEND as notebooks set it, a matplotlibrc, a style with LaTeX) stay
out, when it is imported and when something is drawn: they could spoil a figure or raise.

Source  M. Okabe, K. Ito, Color Universal Design, 2008.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
import importlib
import io
import logging
import os
from pathlib import Path
import re
import sys
import threading
from typing import Any, TYPE_CHECKING
from unittest import mock

from numpy.typing import NDArray

from rvd_dynamics.bad_input import one_line
from rvd_dynamics.recording.described import described
from rvd_dynamics.recording.recording import Recording

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

INK, MUTED, FAINT = '#16191d', '#6b7280', '#d5d9df'
BLUE, VERMILLION, GREEN, ORANGE = '#0072b2', '#d55e00', '#009e73', '#e69f00'
NAMES = {INK: 'ink', MUTED: 'muted', FAINT: 'faint', BLUE: 'blue', VERMILLION: 'vermillion',
         GREEN: 'green', ORANGE: 'orange'}
STYLE = {
    'svg.fonttype': 'none', 'svg.hashsalt': 'rvd', 'font.size': 9.0, 'axes.labelsize': 9.0,
    'axes.titlesize': 9.5, 'axes.titlelocation': 'left', 'axes.titleweight': 'bold',
    'legend.fontsize': 8.5, 'legend.frameon': False, 'legend.handlelength': 2.4,
    'xtick.labelsize': 8.5, 'ytick.labelsize': 8.5, 'text.color': INK, 'axes.labelcolor': INK,
    'axes.titlecolor': INK, 'axes.edgecolor': MUTED, 'xtick.color': MUTED, 'ytick.color': MUTED,
    'xtick.labelcolor': INK, 'ytick.labelcolor': INK, 'axes.linewidth': 0.8,
    'axes.spines.top': False, 'axes.spines.right': False, 'axes.grid': True,
    'grid.color': FAINT, 'grid.linewidth': 0.6, 'axes.axisbelow': True,
    'lines.linewidth': 1.5, 'lines.solid_capstyle': 'round', 'figure.facecolor': 'none',
    'axes.facecolor': 'none', 'savefig.facecolor': 'none', 'path.simplify': True,
}
WIDTH_IN = 9.6                          # of every figure in a report
MOST_DOTS = 500                         # of one kind in one panel
DASHED = (0, (5, 3))
LINES = [(BLUE, '-', 'o'), (VERMILLION, DASHED, 's'), (GREEN, (0, (8, 2, 1, 2)), '^'),
         (ORANGE, (0, (2, 1.5)), 'D'), (INK, '-', 'v'), (MUTED, DASHED, 'P')]   # of conditions
CORNER = {'loc': 'upper right', 'bbox_to_anchor': (0.99, 1.0), 'columnspacing': 1.2}
ABOVE = {'loc': 'lower right', 'bbox_to_anchor': (1.0, 1.0), 'borderaxespad': 0.2}


@dataclass(frozen=True)
class Figure:
    """
    A figure of a recording, as a mission declares it.

    Attributes
    ----------
    draw : callable
        Takes a `Recording` with a scenario and returns a matplotlib figure, `canvas` for one.
    title, caption : str
        A few words above it; sentences below it that say how to read it.
    signals : tuple of str
        Topics without which it is left out.
    also : tuple of str
        Topics, or parts ('TOPIC.PART'), that it shows where they were recorded. To record an
        in-process flight for the figure, ask for both.
    """

    draw: Callable[[Recording], Any]
    title: str
    caption: str
    signals: tuple[str, ...]
    also: tuple[str, ...] = ()

    def missing(self, run: Recording) -> tuple[str, ...]:
        """Return the signals that the figure needs and the recording lacks."""
        return tuple(topic for topic in self.signals if not run.has(topic))


@dataclass(frozen=True)
class CampaignFigure:
    """
    A figure of a campaign.

    Attributes
    ----------
    draw : callable
        Takes the results of the campaign (`rvd_campaign.campaign.figures.Results`: conditions
        with their scenarios, `summary`, result `tables` by condition) and returns a matplotlib
        figure, `canvas` for one, and its caption.
    title : str
        A few words above it.
    columns : tuple of str
        Columns of the result table that it is drawn from.
    tall : bool
        May be broken between two printed pages.
    """

    draw: Callable[[Any], tuple[Any, str]]
    title: str
    columns: tuple[str, ...] = ()
    tall: bool = False


_LOADING = threading.Lock()
NOBODYS = {'MPLBACKEND': 'agg', 'MATPLOTLIBRC': os.devnull}


def load() -> Any:
    """Return matplotlib, imported without the settings of the user or of the working folder."""
    with _LOADING:
        if 'matplotlib' not in sys.modules:
            # of a cache that cannot be written: it does without
            logging.getLogger('matplotlib').setLevel(logging.ERROR)
            exists = os.path.exists         # it looks for `matplotlibrc` here before all else

            def but_not_here(path: Any) -> bool:
                return path != 'matplotlibrc' and exists(path)
            with mock.patch.dict(os.environ, NOBODYS), mock.patch('os.path.exists', but_not_here):
                importlib.import_module('matplotlib')
    import matplotlib.figure
    return matplotlib


def _settings(own: dict[str, Any]) -> Any:
    """Return the context in which matplotlib has its defaults, our style and `own`."""
    matplotlib = load()
    usual = {key: value for key, value in matplotlib.rcParamsDefault.items()
             if not key.startswith('backend')}
    return matplotlib.rc_context({**usual, **STYLE, **own})


def canvas(height_in: float, top: float = 0.32, left: float = 0.07, **spaces: float) -> 'Canvas':
    """Return an empty figure; all have the same margins, so that time axes stand in line."""
    made = load().figure.Figure(figsize=(WIDTH_IN, height_in))
    made.subplots_adjust(left=left, right=0.985, bottom=0.47 / height_in,
                         top=1.0 - top / height_in, **spaces)
    return made


def beside(words: Sequence[str]) -> float:
    """Return the left margin of a canvas that has these words, a line each, beside its axis."""
    return min(0.04 + 0.0068*max(map(len, words)), 0.5)


def every(values: NDArray) -> int:
    """Return which dots to draw (every n-th): more than MOST_DOTS say nothing more."""
    return len(values) // MOST_DOTS + 1


def svg(name: str, draw: Callable[[], Any]) -> str:
    """
    Return what `draw` draws as an SVG element to stand in a page that has the colours.

    `name` sets the ids of this drawing apart from those of others in the page. What is drawn is
    its alternative text, as `described` says it.
    """
    with _settings({}):
        text, drawn = io.StringIO(), draw()
        drawn.savefig(text, format='svg', metadata={'Date': None})
        shown = escape(one_line(described(drawn)))
    drawing = text.getvalue()
    drawing = drawing[drawing.index('<svg'):]
    drawing = re.sub(r'<metadata>.*?</metadata>', '', drawing, flags=re.S)
    drawing = re.sub(r'<svg [^>]*?viewBox="([^"]*)"[^>]*>', r'<svg viewBox="\1" role="img">',
                     drawing, count=1, flags=re.S)
    drawing = re.sub(r'(font: [^;"\']*?[\d.]+px) [^;"]*', r"\1 var(--font)", drawing)
    drawing = re.sub(r'(\bid="|url\(#|href="#)', rf'\1{name}-', drawing)
    drawing = re.sub(r'(\d\.\d\d)\d+', r'\1', drawing)      # a hundredth of a point is enough
    for colour, meaning in NAMES.items():
        drawing = drawing.replace(colour, f'var(--{meaning})')
    return drawing.replace('role="img"', f'role="img" aria-label="{shown}"', 1)


def png(path: Path, draw: Callable[[], Any], dpi: int = 150) -> None:
    """Write what `draw` draws as a PNG on white, for pages that cannot hold a drawing."""
    with _settings({'savefig.facecolor': 'white'}):
        draw().savefig(path, dpi=dpi, format='png')
