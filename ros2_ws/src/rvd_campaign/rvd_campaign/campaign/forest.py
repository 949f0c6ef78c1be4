"""
The figure of differences: each comparison of a campaign as a dot with its interval.
"""

from typing import Any, TYPE_CHECKING

from rvd_dynamics.recording.drawing import BLUE, canvas, DASHED, INK
from rvd_dynamics.recording.worded import worded

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FAR, NEAR = 0.3, 0.05                   # beyond FAR the axis is logarithmic outside of NEAR


def differences(results: Any) -> tuple['Figure', str]:
    """Draw the differences of success rates, one panel for each condition compared with."""
    by_base: dict[str, list[dict[str, Any]]] = {}
    for pair in results.summary['differences']:
        by_base.setdefault(pair['b'], []).append(pair)
    if not by_base:
        return canvas(1.6), 'The campaign compares nothing.'
    rows = {base: [_label(results, pair['a']) for pair in pairs]
            for base, pairs in by_base.items()}
    alike = len({tuple(labels) for labels in rows.values()}) == 1
    labels = rows[next(iter(rows))] if alike else [
        f'{worded(pair["a"])} minus {worded(pair["b"])}'
        for pair in results.summary['differences']]
    panels = list(by_base.items()) if alike else [
        ('', results.summary['differences'])]
    left = min(0.04 + 0.0072*max(map(len, labels)), 0.55)       # room for the longest label
    figure = canvas(1.1 + 0.25*len(labels), left=left, wspace=0.06, top=0.32)
    axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    for panel, (base, pairs) in zip(axes, panels):
        _dots(panel, pairs)
        if base:
            panel.set_title(f'minus {worded(base)}' if len(panels) == 1
                            else _title(results, base), fontsize=8.5)
    axes[0].set_yticks(range(len(labels)), labels)
    axes[0].set_ylim(len(labels) - 0.4, -0.6)
    return figure, ('Difference of success rates, flown with the same draws, with its 95 % '
                    'interval (Newcombe, paired). Each has 95 % confidence by itself: of twenty without '
                    'effect one is expected to exclude 0. Panels with large differences are '
                    f'logarithmic beyond {NEAR:g}.' + _bases(results, by_base, alike))


def _dots(panel: Any, pairs: list[dict[str, Any]]) -> None:
    for at, pair in enumerate(pairs):
        panel.plot(pair['paired95'], [at, at], color=BLUE, linewidth=2.2)
        panel.plot(pair['difference'], at, 'o', color=BLUE, markersize=5)
    panel.axvline(0.0, color=INK, linestyle=DASHED, linewidth=1.2)
    panel.grid(axis='y', visible=False)
    panel.set_xlabel('difference of success rates')
    if max(abs(pair['difference']) for pair in pairs) > FAR:
        ticks = (-1.0, -0.3, -NEAR, 0.0, NEAR, 0.3, 1.0)
        reach = panel.get_xlim()
        panel.set_xscale('symlog', linthresh=NEAR, linscale=1.2)
        panel.set_xticks(ticks, [f'{tick:g}' for tick in ticks], fontsize=7)
        panel.minorticks_off()
        panel.set_xlim(1.3*min(reach[0], -NEAR), 1.3*max(reach[1], NEAR))


def _label(results: Any, name: str) -> str:
    """Return what a condition is called beside others of its group."""
    at = results.campaign.condition(name).at
    return ', '.join(str(value) for value in at.values()) if at else worded(name)


def _title(results: Any, name: str) -> str:
    return worded(results.campaign.condition(name).group)


def _bases(results: Any, by_base: dict[str, Any], alike: bool) -> str:
    rates = '; '.join(f'{worded(base)} {results.rows[base]["success_rate"]:.3f}'
                      for base in by_base)
    return f' Compared with: {rates}.' if alike else ''
