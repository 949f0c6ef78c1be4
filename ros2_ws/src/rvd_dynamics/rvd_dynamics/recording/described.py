"""
What a drawing shows, in a sentence for each panel: the text for those who cannot see it.

It is made of the drawing itself, so that every figure has one, also that of a mission of somebody
else's, and it says nothing that is not drawn.
"""

from typing import Any, TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

LONGEST = 2400                  # characters: more is read out by nobody
MOST_NAMED = 12                 # curves, or names of rows, of one panel
MOST_UNNAMED = 3
CURVE = 3                       # points from which on a line shows more than a limit


def described(figure: 'Figure') -> str:
    """Return what the panels of a drawing show, in their order."""
    panels = [said for axes in figure.axes if (said := _panel(axes))]
    if len(panels) > 1:
        panels = [f'Panel {i}: {said}' for i, said in enumerate(panels, 1)]
    words = [_one_line(text.get_text()) for text in figure.texts]
    text = ' '.join([*panels, *(f'{said}.' for said in words)]) or 'Nothing is drawn.'
    return text if len(text) <= LONGEST else text[:LONGEST].rpartition(' ')[0] + ' …'


def _panel(axes: 'Axes') -> str:
    if not axes.get_visible():
        return ''
    title = next((t for t in (axes.get_title('left'), axes.get_title()) if t), '')
    scales = f'{_axis(axes.yaxis, "vertical")}, {_axis(axes.xaxis, "horizontal")}'
    said = [part for part in (_one_line(title), scales, _curves(axes)) if part]
    return '; '.join(said) + '.'


def _axis(axis: 'Axis', which: str) -> str:
    """Return name and ends of an axis, from bottom to top or from left to right."""
    name = _one_line(axis.get_label_text()) or f'{which} axis'
    rows = _rows(axis)
    if rows:
        more = len(rows) - MOST_NAMED
        return f'{name} with {", ".join(rows[:MOST_NAMED])}' + (f' and {more} more' * (more > 0))
    low, high = axis.get_view_interval()        # as drawn: the first is at the bottom, or left
    return f'{name} from {_number(low)} to {_number(high)}'


def _rows(axis: 'Axis') -> list[str]:
    """Return the names that stand at an axis; none where it has numbers."""
    from matplotlib.ticker import FixedFormatter, FuncFormatter
    if not isinstance(axis.get_major_formatter(), (FixedFormatter, FuncFormatter)):
        return []
    names = [_one_line(text.get_text()) for text in axis.get_ticklabels()]
    return [name for name in names if any(c.isalpha() for c in name)]


def _curves(axes: 'Axes') -> str:
    """Return what the legend names, with least, greatest and last value of what is a curve."""
    handles, labels = axes.get_legend_handles_labels()
    named = [_curve(handle, _one_line(label)) for handle, label in zip(handles, labels)]
    lines = [line for line in axes.lines
             if line not in handles and line.get_transform() == axes.transData
             and len(line.get_xdata(orig=False)) >= CURVE]
    said = [*named[:MOST_NAMED], *(_curve(line, 'a curve') for line in lines[:MOST_UNNAMED])]
    more = len(named) + len(lines) - len(said)
    if more > 0:
        said.append(f'{more} more')
    return f'it shows {", ".join(said)}' if said else ''


def _curve(artist: Any, name: str) -> str:
    from matplotlib.lines import Line2D
    if not isinstance(artist, Line2D) or len(artist.get_xdata(orig=False)) < CURVE:
        return name
    return f'{name} ({_span(artist)})' if _known(artist).size else f'{name} (no data)'


def _known(line: 'Line2D') -> np.ndarray:
    values = np.asarray(line.get_ydata(orig=False), dtype=float)
    return values[np.isfinite(values)]


def _span(line: 'Line2D') -> str:
    values = _known(line)
    return (f'{_number(values.min())} to {_number(values.max())}, '
            f'last {_number(values[-1])}')


def _number(value: float) -> str:
    return f'{float(value):.3g}'.replace('-', '\u2212')


def _one_line(text: str) -> str:
    return ' '.join(text.replace('$', '').split())
