"""
The figures of a session: who succeeded how often, what it felt like, and how people learned.

A flight is a row as `people.read_flights` returns it; a condition has its words.

Intervals   Flights of one volunteer are alike, so they are not so many independent trials.
            Of one volunteer: Wilson's, over the flights, for this person alone.
            Of a condition: Korn's and Graubard's over volunteers (`stats.clustered`), and
            Student's t over the volunteers' means for workload; none of a single volunteer.
            Of a flight number: Wilson's, each volunteer flies it once.
"""

from collections.abc import Callable, Mapping, Sequence
from statistics import mean, median
from typing import Any, TYPE_CHECKING

import numpy as np

from rvd_campaign.campaign import stats
from rvd_campaign.report.page import Drawn
from rvd_dynamics.recording.drawing import ABOVE, canvas, INK, LINES, MUTED, svg

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Flight = Mapping[str, Any]
Words = Mapping[str, str]               # condition: its words, in the order of the session
ROW_IN = 0.2                            # of a volunteer in a figure of rows
BESIDE = 0.13                           # flights between the points of two conditions


def drawn(flights: Sequence[Flight], words: Words) -> list[Drawn]:
    """Return the figures of the flights of a session, of which some count."""
    flown = {name: said for name, said in words.items() if _of(flights, name)}
    made = [
        Drawn('Success', svg('success', lambda: success(flights, flown)),
              'Share of the flights that count which succeeded, with 95 % intervals. Thick: the '
              'condition over its volunteers (Korn and Graubard: for other volunteers like '
              'these; none is shown for a single one). Thin: each volunteer alone (Wilson).',
              tall=True),
        Drawn('Ratings', svg('ratings', lambda: ratings(flights, flown)),
              'Cooper-Harper rating, 1 is best, and NASA-TLX workload, unweighted. A line spans '
              'the flights of a volunteer, its point is their median or mean. Diamond: the '
              'condition, the median over its flights, and the mean of the volunteers’ means '
              'with its 95 % interval (Student over volunteers) from two volunteers on.',
              tall=True)]
    if max(flight['number'] for flight in flights) > 1:
        made.append(Drawn(
            'Learning', svg('learning', lambda: learning(flights, flown)),
            'By the number of the flight in a volunteer’s plan; hollow: training, which does '
            'not count. Above: share of the volunteers who succeeded, with its 95 % interval '
            '(Wilson). Below: workload, thin for each volunteer, thick the mean.'))
    return made


def success(flights: Sequence[Flight], words: Words) -> 'Figure':
    """Draw the success rate of each condition and, below it, of its volunteers."""
    def point(axes: 'Axes', at: float, rows: Sequence[Flight], colour: str, marker: str) -> None:
        good = sum(f['success'] for f in rows)
        axes.plot(stats.wilson(good, len(rows)), [at, at], color=colour, linewidth=1.0)
        axes.plot(good / len(rows), at, marker, color=colour, markersize=3.5)

    def whole(axes: 'Axes', at: float, rows: Sequence[Flight], colour: str, marker: str) -> None:
        counts = [(sum(f['success'] for f in own), len(own)) for own in _by_volunteer(rows)]
        interval = stats.clustered(counts)
        if interval is not None:
            axes.plot(interval, [at, at], color=colour, linewidth=3.0)
        axes.plot(sum(s for s, _ in counts) / len(rows), at, marker, color=colour, markersize=7)

    figure = _canvas(flights, words)
    axes = figure.subplots()
    _rows(axes, flights, words, whole, point)
    axes.set(xlabel='success rate', xlim=(-0.02, 1.02))
    return figure


def ratings(flights: Sequence[Flight], words: Words) -> 'Figure':
    """Draw handling and workload of each condition and, below it, of its volunteers."""
    figure = _canvas(flights, words)
    panels = figure.subplots(1, 2, sharey=True, gridspec_kw={'wspace': 0.08})
    for axes, column, label, middle in (
            (panels[0], 'cooper_harper', 'Cooper-Harper rating', median),
            (panels[1], 'tlx', 'NASA-TLX workload', mean)):
        def point(axes: 'Axes', at: float, rows: Sequence[Flight], colour: str, marker: str,
                  column: str = column, middle: Callable = middle) -> None:
            values = [f[column] for f in rows]
            axes.plot([min(values), max(values)], [at, at], color=colour, linewidth=1.0)
            axes.plot(middle(values), at, marker, color=colour, markersize=3.5)

        def whole(axes: 'Axes', at: float, rows: Sequence[Flight], colour: str, marker: str,
                  column: str = column) -> None:
            if column == 'cooper_harper':
                axes.plot(median(f[column] for f in rows), at, 'D', color=colour, markersize=6)
                return
            means = [mean(f[column] for f in own) for own in _by_volunteer(rows)]
            if len(means) > 1:
                axes.plot(stats.mean_interval(means), [at, at], color=colour, linewidth=3.0)
            axes.plot(mean(means), at, 'D', color=colour, markersize=6)
        _rows(axes, flights, words, whole, point)
        axes.set(xlabel=label)
    panels[0].set(xlim=(0.7, 10.3), xticks=range(1, 11))
    panels[1].set(xlim=(-2, 102))
    return figure


def learning(flights: Sequence[Flight], words: Words) -> 'Figure':
    """Draw success and workload over the number of the flight."""
    figure = canvas(4.8, top=0.42, hspace=0.14)
    above, below = figure.subplots(2, 1, sharex=True)
    beside = BESIDE * (np.arange(len(words)) - 0.5*(len(words) - 1))
    for (name, said), shift, (colour, style, marker) in zip(words.items(), beside,
                                                            LINES * len(words)):
        rows = _of(flights, name, training=True)
        numbers = sorted({f['number'] for f in rows})
        at = {n: [f for f in rows if f['number'] == n] for n in numbers}
        rates = [mean(f['success'] for f in at[n]) for n in numbers]
        above.plot(np.add(numbers, shift), rates, color=colour, linestyle=style, linewidth=0.8,
                   label=said)
        below.plot(np.add(numbers, shift), [mean(f['tlx'] for f in at[n]) for n in numbers],
                   color=colour, linestyle=style, linewidth=2.2, label=said)
        for number, rate in zip(numbers, rates):
            good = sum(f['success'] for f in at[number])
            x, hollow = number + shift, all(f['training'] for f in at[number])
            above.plot([x, x], stats.wilson(good, len(at[number])), color=colour, linewidth=1.2)
            above.plot(x, rate, marker, color=colour, markersize=5,
                       markerfacecolor='none' if hollow else colour)
        for own in _by_volunteer(rows):
            below.plot([f['number'] + shift for f in own], [f['tlx'] for f in own], color=colour,
                       linewidth=0.7, alpha=0.55)
    above.set(ylabel='success rate', ylim=(-0.05, 1.05))
    below.set(ylabel='NASA-TLX workload', xlabel='number of the flight', ylim=(-2, 102))
    below.xaxis.get_major_locator().set_params(integer=True)
    above.legend(ncols=4, **ABOVE)
    return figure


def _rows(axes: 'Axes', flights: Sequence[Flight], words: Words, whole: Callable,
          point: Callable) -> None:
    """Draw a row for each condition, then one for each of its volunteers, from the top."""
    at, ticks = 0.0, []
    for (name, said), (colour, _, marker) in zip(words.items(), LINES * len(words)):
        rows = _of(flights, name)
        whole(axes, at, rows, colour, marker)
        ticks.append((at, said))
        for own in _by_volunteer(rows):
            at += 1.0
            point(axes, at, own, colour, marker)
            ticks.append((at, own[0]['volunteer']))
        at += 1.8
    axes.set_yticks([y for y, _ in ticks], [said for _, said in ticks])
    for label, (_, said) in zip(axes.get_yticklabels(), ticks):
        strong = said in words.values()
        label.set(fontweight='bold' if strong else 'normal', color=INK if strong else MUTED)
    axes.set_ylim(at - 1.0, -0.8)
    axes.grid(axis='y', visible=False)


def _canvas(flights: Sequence[Flight], words: Words) -> 'Figure':
    rows = sum(1.8 + len(_by_volunteer(_of(flights, name))) for name in words)
    longest = max(map(len, words.values()))
    return canvas(0.9 + ROW_IN*rows, left=min(0.05 + 0.0075*longest, 0.4), top=0.15)


def _of(flights: Sequence[Flight], condition: str, training: bool = False) -> list[Flight]:
    """Return the flights of a condition, those that count if not `training` ones too."""
    return [f for f in flights if f['condition'] == condition and (training or not f['training'])]


def _by_volunteer(rows: Sequence[Flight]) -> list[list[Flight]]:
    """Return the flights of each volunteer, in the order of their numbers."""
    who = sorted({f['volunteer'] for f in rows})
    return [sorted((f for f in rows if f['volunteer'] == name), key=lambda f: f['number'])
            for name in who]
