"""
The figures of a run, drawn from its recording.

Colours are Okabe and Ito's, which colour-blind readers tell apart; line style and weight say
the same once more. In the SVG they are names (`var(--ink)`) that the page gives values to, so
that one drawing serves light, dark and print. Text stays text.

Source  M. Okabe, K. Ito, Color Universal Design, 2008.
"""

import io
import re
from pathlib import Path
from typing import Callable

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.recording.reader import Frames, Recording
from rvd_dynamics.geometry import cone
from rvd_dynamics.commands.levels import stick_levels

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
WIDTH_IN = 9.6                          # of every figure in the report
MOST_DOTS = 500                         # of one kind in one panel
AXES = 'xyz'
PREDICTED = {'color': BLUE, 'linewidth': 1.1, 'linestyle': (0, (4, 2))}


CORNER = {'loc': 'upper right', 'bbox_to_anchor': (0.99, 1.0), 'columnspacing': 1.2}


def _figure(height_in: float, top: float = 0.32, **spaces: float) -> Figure:
    """Return an empty figure; all have the same margins, so that time axes stand in line."""
    figure = Figure(figsize=(WIDTH_IN, height_in))
    figure.subplots_adjust(left=0.07, right=0.985, bottom=0.47 / height_in,
                           top=1.0 - top / height_in, **spaces)
    return figure


def approach(run: Recording) -> Figure:
    """Draw the track in x-y and x-z with corridor and boundary, and the end from behind."""
    figure = _figure(5.4, top=0.58, hspace=0.24, wspace=0.20)
    grid = figure.add_gridspec(2, 2, width_ratios=[2.5, 1.0])
    sides = figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[1, 0])
    for axes, lateral in zip(sides, (1, 2)):
        _side_view(axes, run, lateral)
    sides[0].set_xlabel('')
    figure.legend(*sides[0].get_legend_handles_labels(), ncols=7, **CORNER)
    sides[1].set_xlabel('x, along track [m]')
    _end_view(figure.add_subplot(grid[:, 1]), run)
    return figure


def _side_view(axes: Axes, run: Recording, lateral: int) -> None:
    mission = run.mission
    state = run.truth.state
    first = min(mission.start.position_m[0], float(np.nanmin(state[:, 0], initial=0.0)))
    x = np.linspace(first, 0.0, 121)
    wall = cone.radius(x, mission.corridor)
    inner = cone.control_boundary(
        x, mission.corridor, mission.orbit.mean_motion,
        delay=mission.forward_delay_s + mission.back_delay_s)
    for sign in (1.0, -1.0):
        axes.plot(x, sign * wall, color=INK, linestyle=(0, (5, 3)), linewidth=1.8,
                  label='corridor wall' if sign > 0 else None)
        axes.plot(x, sign * inner, color=ORANGE, linewidth=1.8,
                  label='control boundary' if sign > 0 else None)
        axes.fill_between(x, sign * inner, sign * wall, color=ORANGE, alpha=0.10, linewidth=0)
    measured = _shown(run.measurement.state, lateral)
    axes.plot(*measured, linestyle='', marker='.', markersize=2.2, color=MUTED, alpha=0.7,
              label='measured', markevery=_every(measured[0]))
    axes.plot(*_shown(state, lateral), color=INK, linewidth=2.0, label='true')
    axes.plot(*_shown(run.prediction.state, lateral), **PREDICTED, label='predicted')
    if len(state):
        axes.plot(state[0, 0], state[0, lateral], 'o', color=INK, markersize=5, label='start')
    _mark_exit(axes, run, lateral)
    widest = float(wall.max())
    seen = np.abs(_shown(state, lateral)[1])
    limit = 1.12 * min(max(widest, float(np.nanmax(seen, initial=0.0))), 2.5 * widest)
    axes.set(ylabel=f'{AXES[lateral]}, {("", "radial", "cross track")[lateral]} [m]',
             xlim=(first - 0.3, 0.6), ylim=(-limit, limit))
    axes.axvline(0.0, color=MUTED, linewidth=0.8)
    axes.set_title(f'x-{AXES[lateral]} plane')


def _shown(state: NDArray, lateral: int) -> tuple[NDArray, NDArray]:
    """Return station and offset, without what lies past the docking plane."""
    before = state[:, 0] <= 0.3
    return state[before, 0], state[before, lateral]


def _every(values: NDArray) -> int:
    """Return which dots to draw (every n-th): more than MOST_DOTS say nothing more."""
    return len(values) // MOST_DOTS + 1


def _judged(run: Recording, name: str) -> float:
    """Return a measure of the run; NaN where it is unknown."""
    return np.nan if run.verdict is None else run.verdict.value(name)


def _mark_exit(axes: Axes, run: Recording, lateral: int) -> None:
    where = [_judged(run, f'exit_{axis}_m') for axis in 'xyz']
    if np.isfinite(where[0]):
        axes.plot(where[0], where[lateral], 'X', color=VERMILLION, markersize=9,
                  markeredgewidth=0, label='left the corridor')


def _end_view(axes: Axes, run: Recording) -> None:
    """Look along +x at the last two metres."""
    mission, state = run.mission, run.truth.state
    near = state[state[:, 0] > -2.0]
    limit = mission.corridor.docking_radius_m
    axes.add_patch(Circle((0, 0), limit, fill=False, edgecolor=INK, linestyle=(0, (5, 3)),
                          linewidth=1.8))
    axes.plot(near[:, 1], near[:, 2], color=INK, linewidth=1.8)
    if len(near):
        inside = run.verdict is not None and run.verdict.success
        axes.plot(near[-1, 1], near[-1, 2], 'o' if inside else 'X', markersize=8, zorder=5,
                  color=GREEN if inside else VERMILLION, markeredgewidth=0)
    reach = 1.25 * max(limit, float(np.abs(near[:, 1:3]).max(initial=0.0)))
    axes.set(xlabel='y [m]', ylabel='z [m]', xlim=(-reach, reach), ylim=(-reach, reach),
             aspect='equal')
    axes.set_title('last 2 m, along +x')


def margin(run: Recording) -> Figure:
    """Draw the signed distance to the corridor wall and the closing rate over time."""
    figure = _figure(3.4, hspace=0.12)
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    t, state = run.truth.t, run.truth.state
    distance = cone.signed_distance(state[:, :3], run.mission.corridor)
    top.plot(t, distance, color=INK, linewidth=1.8)
    top.axhline(0.0, color=VERMILLION, linewidth=1.2)
    inner = cone.control_boundary(
        np.minimum(state[:, 0], 0.0), run.mission.corridor, run.mission.orbit.mean_motion,
        delay=run.mission.forward_delay_s + run.mission.back_delay_s)
    beyond = np.sqrt(state[:, 1]**2 + state[:, 2]**2) > inner
    top.fill_between(t, 0.0, 1.0, where=beyond, step='mid', color=ORANGE, alpha=0.22,
                     linewidth=0, transform=top.get_xaxis_transform(),
                     label='beyond the control boundary')
    top.legend(loc='lower right', bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
    low = min(0.0, float(np.nanmin(distance, initial=0.0)))
    top.axhspan(low * 1.1 - 0.12, 0.0, color=VERMILLION, alpha=0.10, linewidth=0)
    top.set(ylabel='distance to wall [m]', ylim=(low * 1.1 - 0.12, None))
    top.set_title('Below 0: outside the corridor')
    if np.isfinite(_judged(run, 'exit_time_s')):
        top.axvline(_judged(run, 'exit_time_s'), color=VERMILLION, linestyle=':', linewidth=1.2)
    limit = run.mission.docking.max_closing_rate_m_s
    bottom.plot(t, state[:, 3], color=INK, linewidth=1.5)
    bottom.axhline(limit, color=VERMILLION, linewidth=1.2)
    bottom.annotate('limit at docking', (0.0, limit), xytext=(4, -10), color=VERMILLION,
                    textcoords='offset points', fontsize=8.0)
    bottom.set(xlabel='time [s]', ylabel='x rate [m/s]')
    return figure


def levels(run: Recording) -> Figure:
    """Draw what pilot and automatic controller wanted and what was sent, axis by axis."""
    figure = _figure(4.8, hspace=0.14)
    rows = figure.subplots(3, 1, sharex=True)
    stick = np.array([stick_levels(a.tolist(), b.tolist(), run.mission.stick)[0]
                      for a, b in zip(run.joy.axes, run.joy.buttons)]).reshape(-1, 3)
    step_s = run.mission.step_s
    for i, axes in enumerate(rows):
        if len(run.ground.step):
            axes.fill_between(run.ground.step * step_s, run.ground.levels[:, i], step='post',
                              color=MUTED, alpha=0.45, linewidth=0, label='sent (blended)')
        if len(stick):
            axes.step(run.joy.t, stick[:, i] + 0.08, where='post', color=VERMILLION,
                      linewidth=1.3, label='pilot')
        if len(run.auto.step):
            axes.step(run.auto.step * step_s, run.auto.levels[:, i] - 0.08, where='post',
                      color=BLUE, linewidth=1.3, linestyle=(0, (3, 1)), label='automatic')
        axes.set(ylabel=f'{AXES[i]} level', ylim=(-3.4, 3.4))
        axes.set_yticks((-2, 0, 2), ('\u22122', '0', '+2'))
        axes.set_yticks((-3, -1, 1, 3), minor=True)
    rows[0].set_title('Commands as made on the ground')
    if rows[0].get_legend_handles_labels()[0]:
        rows[0].legend(loc='lower right', ncols=3, bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
    rows[-1].set_xlabel('time on the ground [s]')
    return figure


def prediction_error(run: Recording) -> tuple[NDArray, NDArray, NDArray]:
    """
    Return times (N,) [s], predicted minus true (N, 6) and claimed deviations (N, 6).

    Only predictions for instants of which the bag holds the truth; one for an instant after
    the end of the run has none.
    """
    step_s = run.mission.step_s
    row = {int(k): i for i, k in enumerate(run.truth.step)}
    made = run.prediction
    wanted = [row.get(k, -1) if ok else -1
              for k, ok in zip(np.rint(made.t / step_s).astype(int).tolist(), made.valid)]
    rows = np.array(wanted, dtype=int)
    used = rows >= 0
    variance = np.diagonal(made.covariance[used], axis1=-2, axis2=-1)
    return (made.t[used], made.state[used] - run.truth.state[rows[used]],
            np.sqrt(np.maximum(variance, 0.0)))


def prediction(run: Recording) -> Figure:
    """Draw the prediction error against truth in its band, and against what came down later."""
    figure = _figure(5.4, top=0.58, hspace=0.12, wspace=0.16)
    panels = figure.subplots(3, 2, sharex=True)
    t, error, sigma = prediction_error(run)
    scored = run.score.valid
    lost = _gaps(run.command_frames, run.mission.forward_delay_s, run.mission.step_s
                 ) + run.mission.forward_delay_s
    for column, (unit, scale) in enumerate((('mm', 1e3), ('mm/s', 1e3))):
        for i in range(3):
            axes, k = panels[i, column], 3*column + i
            axes.fill_between(t, -2*scale*sigma[:, k], 2*scale*sigma[:, k], color=BLUE,
                              alpha=0.16, linewidth=0, label='claimed, 2 sigma')
            axes.plot(run.score.t[scored], scale * run.score.error[scored, k], linestyle='',
                      marker='.', markersize=2.5, color=MUTED, label='against later received',
                      markevery=_every(run.score.t[scored]))
            axes.plot(t, scale * error[:, k], color=INK, linewidth=1.4, label='against truth')
            _scaled_to(axes, np.concatenate([scale * error[:, k], 2*scale*sigma[:, k]]))
            axes.axhline(0.0, color=MUTED, linewidth=0.8)
            for at in lost:
                axes.axvline(at, color=VERMILLION, linestyle=':', linewidth=1.1,
                             label='command lost' if at == lost[0] else None)
            axes.set_ylabel(f'{AXES[i]}{" rate" * column} [{unit}]')
        panels[2, column].set_xlabel('instant predicted for [s]')
    panels[0, 0].set_title('Position: predicted minus true')
    panels[0, 1].set_title('Velocity: predicted minus true')
    figure.legend(*panels[0, 0].get_legend_handles_labels(), ncols=4, **CORNER)
    return figure


def _scaled_to(axes: Axes, values: NDArray) -> None:
    """Scale to error and band; a few wild points, of sensor noise, may fall outside."""
    values = np.abs(values[np.isfinite(values)])
    if len(values) and values.max() > 0.0:
        axes.set_ylim(-1.25 * values.max(), 1.25 * values.max())


def links(run: Recording) -> Figure:
    """Draw the transit time of every frame that was released, per link."""
    figure = _figure(3.8, hspace=0.42, wspace=0.05)
    panels = figure.subplots(2, 2, sharey='row', width_ratios=[4, 1])
    mission = run.mission
    for row, (name, frames, hold, colour) in enumerate((
            ('Forward link (to the chaser)', run.command_frames, mission.forward_delay_s,
             VERMILLION),
            ('Back link (to the ground)', run.telemetry, mission.back_delay_s, BLUE))):
        strip, bars = panels[row]
        transit = frames.arrived - frames.sent
        released = np.isfinite(transit)
        strip.plot(frames.sent[released], transit[released], linestyle='', marker='.',
                   markersize=3.5, color=colour, markevery=_every(transit[released]))
        strip.axhline(hold, color=INK, linewidth=1.2, linestyle=(0, (5, 3)))
        gaps = _gaps(frames, hold, mission.step_s)
        if len(gaps):
            strip.plot(gaps, np.full(len(gaps), hold), linestyle='', marker='x', markersize=6,
                       color=INK, markeredgewidth=1.4, label='never released')
            strip.legend(loc='lower right', bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2)
        low = float(np.nanmin(transit, initial=hold))
        strip.set_ylim(low - 0.08 * (hold - low) - 0.02, hold + 0.12 * (hold - low) + 0.05)
        strip.set_title(name)
        strip.set_ylabel('transit [s]')
        if released.any():
            bars.hist(transit[released], bins=24, orientation='horizontal', color=colour,
                      alpha=0.7)
        bars.axhline(hold, color=INK, linewidth=1.2, linestyle=(0, (5, 3)))
    panels[1, 0].set_xlabel('sent at [s]')
    panels[1, 1].set_xlabel('frames')
    return figure


def _gaps(frames: Frames, hold: float, step_s: float) -> NDArray:
    """Return when the frames were sent [s] in whose place an empty one came out."""
    sent = frames.step[frames.empty] * step_s - hold
    return sent[sent > -0.5 * step_s]


FIGURES: dict[str, Callable[[Recording], Figure]] = {
    'approach': approach, 'margin': margin, 'levels': levels, 'prediction': prediction,
    'links': links}


def svg(name: str, run: Recording) -> str:
    """Return a figure of `FIGURES` as an SVG element to stand in a page that has the colours."""
    return drawn(name, lambda: FIGURES[name](run))


def drawn(name: str, draw: Callable[[], Figure]) -> str:
    """Return what `draw` draws as an SVG element; `name` sets its ids apart from others'."""
    with matplotlib.rc_context(STYLE):
        text = io.StringIO()
        draw().savefig(text, format='svg', metadata={'Date': None})
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
    return drawing


def approach_picture(run: Recording, path: Path) -> None:
    """Write the approach as a PNG on white, for pages that cannot hold a drawing."""
    with matplotlib.rc_context({**STYLE, 'savefig.facecolor': 'white'}):
        approach(run).savefig(path, dpi=150, format='png')
