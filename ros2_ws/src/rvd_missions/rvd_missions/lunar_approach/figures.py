"""
The figures of an approach, drawn from its recording.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.levels import stick_levels
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry import cone
from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, CORNER, DASHED, every, Figure, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_groundstation.prediction.consistency import nees, SIGMAS, within
from rvd_missions.lunar_approach.signals import (
    ARRIVAL, AUTO, COMMAND, MEASUREMENT, PREDICTION, SCORE, STICK, TRUTH, UPLINK)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

AXES = 'xyz'
NEES_95 = (1.24, 14.45)                 # 95 % of a chi-square of 6
PREDICTED = {'color': BLUE, 'linewidth': 1.1, 'linestyle': (0, (4, 2))}


def approach(run: Recording) -> 'Canvas':
    """Draw the track in x-y and x-z with corridor and boundary, and the end from behind."""
    figure = canvas(5.4, top=0.58, hspace=0.24, wspace=0.20)
    grid = figure.add_gridspec(2, 2, width_ratios=[2.5, 1.0])
    sides = figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[1, 0])
    for axes, lateral in zip(sides, (1, 2)):
        _side_view(axes, run, lateral)
    sides[0].set_xlabel('')
    figure.legend(*sides[0].get_legend_handles_labels(), ncols=7, **CORNER)
    sides[1].set_xlabel('x, along track [m]')
    _end_view(figure.add_subplot(grid[:, 1]), run)
    return figure


def _side_view(axes: 'Axes', run: Recording, lateral: int) -> None:
    state = run.of(TRUTH).state
    start = run.scenario.part('start').position_m[0]
    first = min(start, float(np.nanmin(state[:, 0], initial=0.0)))
    x = np.linspace(first, 0.0, 121)
    wall, inner = cone.radius(x, run.scenario.part('cone')), _boundary(run, x)
    for sign in (1.0, -1.0):
        axes.plot(x, sign * wall, color=INK, linestyle=DASHED, linewidth=1.8,
                  label='corridor wall' if sign > 0 else None)
        axes.plot(x, sign * inner, color=ORANGE, linewidth=1.8,
                  label='control boundary' if sign > 0 else None)
        axes.fill_between(x, sign * inner, sign * wall, color=ORANGE, alpha=0.10, linewidth=0)
    if run.has(MEASUREMENT.name):
        measured = _shown(run.of(MEASUREMENT).state, lateral)
        axes.plot(*measured, linestyle='', marker='.', markersize=2.2, color=MUTED, alpha=0.7,
                  label='measured', markevery=every(measured[0]))
    axes.plot(*_shown(state, lateral), color=INK, linewidth=2.0, label='true')
    if run.has(PREDICTION.name):
        axes.plot(*_shown(run.of(PREDICTION).state, lateral), **PREDICTED, label='predicted')
    axes.plot(state[0, 0], state[0, lateral], 'o', color=INK, markersize=5, label='start')
    draw_obstacles(axes, run.scenario, lateral)
    _mark_exit(axes, run, lateral)
    widest = float(wall.max())
    seen = np.abs(_shown(state, lateral)[1])
    limit = 1.12 * min(max(widest, float(np.nanmax(seen, initial=0.0))), 2.5 * widest)
    axes.set(ylabel=f'{AXES[lateral]}, {("", "radial", "cross track")[lateral]} [m]',
             xlim=(first - 0.3, 0.6), ylim=upwards(lateral, limit))
    axes.axvline(0.0, color=MUTED, linewidth=0.8)
    axes.set_title(('', 'Side: x-y plane', 'Top: x-z plane, z down')[lateral])


def upwards(lateral: int, limit: float) -> tuple[float, float]:
    """Return bottom and top of a side view as the console has it: from above, z points down."""
    return (limit, -limit) if lateral == 2 else (-limit, limit)


def draw_obstacles(axes: 'Axes', scenario: Scenario, lateral: int, run: int | None = None) -> None:
    """Draw the keep-out spheres of a run into a side view, whose scales differ: as ellipses."""
    from matplotlib.patches import Circle
    obstacles, number = scenario.part('obstacles'), scenario.run.run if run is None else run
    places = obstacles.places(scenario.run.seed, [number], ())
    for place, radius in zip(places, obstacles.radii):
        axes.add_patch(Circle((place[0], place[lateral]), radius, color=VERMILLION, alpha=0.55,
                              linewidth=0))


def _boundary(run: Recording, x: NDArray) -> NDArray:
    """Return the radius of the control boundary [m] at stations `x` [m]."""
    part = run.scenario.part
    return cone.control_boundary(x, part('cone'), part('orbit').mean_motion,
                                 part('approach_rate_m_s'), part('leg_params').loop_s)


def _shown(state: NDArray, lateral: int) -> tuple[NDArray, NDArray]:
    """Return station and offset, without what lies past the docking plane."""
    before = state[:, 0] <= 0.3
    return state[before, 0], state[before, lateral]


def _judged(run: Recording, name: str) -> float:
    """Return a measure of the run; NaN where it is unknown."""
    return np.nan if run.verdict is None else run.verdict.value(name)


def _mark_exit(axes: 'Axes', run: Recording, lateral: int) -> None:
    where = [_judged(run, f'exit_{axis}_m') for axis in 'xyz']
    if np.isfinite(where[0]):
        axes.plot(where[0], where[lateral], 'X', color=VERMILLION, markersize=9,
                  markeredgewidth=0, label='left the corridor')


def _end_view(axes: 'Axes', run: Recording) -> None:
    """Look along +x at the last two metres, as the console's section does: z right, y up."""
    from matplotlib.patches import Circle
    state, limit = run.of(TRUTH).state, run.scenario.part('cone').docking_radius_m
    near = state[state[:, 0] > -2.0]
    axes.add_patch(Circle((0, 0), limit, fill=False, edgecolor=INK, linestyle=DASHED,
                          linewidth=1.8))
    axes.plot(near[:, 2], near[:, 1], color=INK, linewidth=1.8)
    if len(near):
        inside = run.verdict is not None and run.verdict.success
        axes.plot(near[-1, 2], near[-1, 1], 'o' if inside else 'X', markersize=8, zorder=5,
                  color=GREEN if inside else VERMILLION, markeredgewidth=0)
    reach = 1.25 * max(limit, float(np.abs(near[:, 1:3]).max(initial=0.0)))
    axes.set(xlabel='z [m]', ylabel='y [m]', xlim=(-reach, reach), ylim=(-reach, reach),
             aspect='equal')
    axes.set_title('last 2 m, along +x')


def margin(run: Recording) -> 'Canvas':
    """Draw the signed distance to the corridor wall and the closing rate over time."""
    figure = canvas(3.4, hspace=0.12)
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    t, state = run.of(TRUTH).t, run.of(TRUTH).state
    distance = cone.signed_distance(state[:, :3], run.scenario.part('cone'))
    top.plot(t, distance, color=INK, linewidth=1.8)
    top.axhline(0.0, color=VERMILLION, linewidth=1.2)
    inner = _boundary(run, np.minimum(state[:, 0], 0.0))
    beyond = np.sqrt(state[:, 1]**2 + state[:, 2]**2) > inner
    top.fill_between(t, 0.0, 1.0, where=beyond, step='mid', color=ORANGE, alpha=0.22,
                     linewidth=0, transform=top.get_xaxis_transform(),
                     label='outside the control boundary')
    top.legend(**ABOVE)
    low = min(0.0, float(np.nanmin(distance, initial=0.0)))
    top.axhspan(low * 1.1 - 0.12, 0.0, color=VERMILLION, alpha=0.10, linewidth=0)
    top.set(ylabel='distance to wall [m]', ylim=(low * 1.1 - 0.12, None))
    top.set_title('Below 0: outside the corridor')
    if np.isfinite(_judged(run, 'exit_time_s')):
        top.axvline(_judged(run, 'exit_time_s'), color=VERMILLION, linestyle=':', linewidth=1.2)
    limit = run.scenario.part('docking').max_closing_rate_m_s
    bottom.plot(t, state[:, 3], color=INK, linewidth=1.5)
    bottom.axhline(limit, color=VERMILLION, linewidth=1.2)
    bottom.annotate('limit at docking', (0.0, limit), xytext=(4, -10), color=VERMILLION,
                    textcoords='offset points', fontsize=8.0)
    bottom.set(xlabel='time [s]', ylabel='x rate [m/s]')
    return figure


def levels(run: Recording) -> 'Canvas':
    """Draw what pilot and automatic controller wanted and what was sent, axis by axis."""
    figure = canvas(4.8, hspace=0.14)
    rows = figure.subplots(3, 1, sharex=True)
    joy, auto, sent = run.of(STICK), run.of(AUTO), run.of(COMMAND)
    settings, step_s = run.scenario.part('stick'), run.scenario.run.step_s
    pilot = np.array([stick_levels(a.tolist(), b.tolist(), settings)[0]
                      for a, b in zip(joy.axes, joy.buttons)]).reshape(-1, 3)
    for i, axes in enumerate(rows):
        axes.fill_between(sent.step * step_s, sent.levels[:, i], step='post', color=MUTED,
                          alpha=0.45, linewidth=0, label='sent (blended)')
        if len(joy):
            axes.step(joy.t, pilot[:, i] + 0.08, where='post', color=VERMILLION, linewidth=1.3,
                      label='pilot')
        if len(auto):
            axes.step(auto.step * step_s, auto.levels[:, i] - 0.08, where='post', color=BLUE,
                      linewidth=1.3, linestyle=(0, (3, 1)), label='automatic')
        axes.set(ylabel=f'{AXES[i]} level', ylim=(-3.4, 3.4))
        axes.set_yticks((-2, 0, 2), ('\u22122', '0', '+2'))
        axes.set_yticks((-3, -1, 1, 3), minor=True)
    rows[0].set_title('Commands as made on the ground')
    rows[0].legend(ncols=3, **ABOVE)
    rows[-1].set_xlabel('time on the ground [s]')
    return figure


def prediction_error(run: Recording) -> tuple[NDArray, NDArray, NDArray]:
    """
    Return times (N,) [s], predicted minus true (N, 6) and claimed covariances (N, 6, 6).

    Only predictions for instants whose truth was recorded: one for an instant after the end of
    the run has none.
    """
    step_s, true, made = run.scenario.run.step_s, run.of(TRUTH), run.of(PREDICTION)
    row = {int(k): i for i, k in enumerate(true.step)}
    wanted = [row.get(k, -1) if ok else -1
              for k, ok in zip(np.rint(made.t / step_s).astype(int).tolist(), made.valid)]
    rows = np.array(wanted, dtype=int)
    used = rows >= 0
    return made.t[used], made.state[used] - true.state[rows[used]], made.covariance[used]


def consistency(run: Recording) -> 'Canvas':
    """Draw each prediction's error by its own covariance: all six together, and one by one."""
    figure = canvas(3.6, hspace=0.16)
    together, each = figure.subplots(2, 1, sharex=True)
    t, error, covariance = prediction_error(run)
    found = nees(error, covariance)
    together.axhspan(*NEES_95, color=BLUE, alpha=0.16, linewidth=0, label='95 % of right ones')
    together.axhline(6.0, color=BLUE, linewidth=1.2, linestyle=DASHED, label='right mean, 6')
    together.plot(t, found, color=INK, linewidth=1.4, label='of each prediction')
    known = np.isfinite(found)
    if known.any():
        inside = within(error[known], covariance[known]).mean()
        together.set_title(f'Mean {found[known].mean():.1f}; '
                           f'{100*inside:.1f} % within two sigma')
    together.set(yscale='log', ylabel='NEES',
                 ylim=(0.05, max(40.0, 1.3*np.nanmax(found, initial=0.0))))
    together.legend(ncols=3, **ABOVE)
    ratio = error[known]/np.sqrt(np.diagonal(covariance[known], axis1=-2, axis2=-1))
    each.axhspan(-SIGMAS, SIGMAS, color=BLUE, alpha=0.16, linewidth=0)
    for i, colour in enumerate((INK, ORANGE, GREEN)):
        each.plot(t[known], ratio[:, i], color=colour, linewidth=1.4, label=AXES[i])
        each.plot(t[known], ratio[:, 3 + i], color=colour, linewidth=1.1, linestyle=DASHED,
                  label=f'{AXES[i]} rate')
    _scaled_to(each, np.append(ratio, 2.4))
    each.set(xlabel='instant predicted for [s]', ylabel='error, in sigma')
    each.legend(ncols=6, **ABOVE)
    return figure


def prediction(run: Recording) -> 'Canvas':
    """Draw the prediction error against truth in its band, and against what came down later."""
    figure = canvas(5.4, top=0.58, hspace=0.12, wspace=0.16)
    panels = figure.subplots(3, 2, sharex=True)
    t, error, covariance = prediction_error(run)
    sigma = np.sqrt(np.maximum(np.diagonal(covariance, axis1=-2, axis2=-1), 0.0))
    score, forward = run.of(SCORE), run.links['forward']
    scored = score.valid
    lost = forward.never_released + forward.hold_s
    for column, (unit, scale) in enumerate((('mm', 1e3), ('mm/s', 1e3))):
        for i in range(3):
            axes, k = panels[i, column], 3*column + i
            axes.fill_between(t, -2*scale*sigma[:, k], 2*scale*sigma[:, k], color=BLUE,
                              alpha=0.16, linewidth=0, label='claimed, 2 sigma')
            axes.plot(score.t[scored], scale * score.error[scored, k], linestyle='',
                      marker='.', markersize=2.5, color=MUTED, label='against later received',
                      markevery=every(score.t[scored]))
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


def _scaled_to(axes: 'Axes', values: NDArray) -> None:
    """Scale to error and band; a few wild points, of sensor noise, may fall outside."""
    values = np.abs(values[np.isfinite(values)])
    if len(values) and values.max() > 0.0:
        axes.set_ylim(-1.25 * values.max(), 1.25 * values.max())


FIGURES = {
    'approach': Figure(
        approach, 'Approach',
        'The track from the side and from above, as the console shows it, in the target orbital '
        'frame; the lateral scale is stretched. '
        'Outside the control boundary, drift can carry the chaser to the wall before a command '
        'sent now takes effect. Each panel shows the cone cut along its axis: the chaser meets '
        'the wall when its distance from the axis, not y or z alone, reaches the radius of the '
        'cone. Right: the last two metres, seen along the direction of flight, and the limit at '
        'the docking plane.',
        signals=(TRUTH.name,), also=(MEASUREMENT.name, PREDICTION.name)),
    'margin': Figure(
        margin, 'Corridor margin',
        'Signed distance from the true position to the corridor wall. Shaded: the chaser was '
        'outside the control boundary.',
        signals=(TRUTH.name,)),
    'levels': Figure(
        levels, 'Who commanded what',
        'Thrust levels asked for by the pilot and by the automatic controller, and the command '
        'made from them, at the time they were issued on the ground. They act on board one '
        'forward delay later.',
        signals=(COMMAND.name,), also=(STICK.name, AUTO.name)),
    'prediction': Figure(
        prediction, 'Prediction error',
        'Predicted minus true state at the same instant (line), with the band of two standard '
        'deviations that the predictor claimed. Dots: predicted state minus the measurement of '
        'that instant, which came down the link later; they contain the sensor\u2019s noise, and '
        'some may lie outside the plot. A command lost on the link shows as an error that lasts '
        'until telemetry reveals the loss.',
        signals=(TRUTH.name, PREDICTION.name),
        also=(f'{PREDICTION.name}.covariance', SCORE.name, ARRIVAL.name, UPLINK.name)),
    'consistency': Figure(
        consistency, 'What the prediction was worth',
        'Normalised error squared (NEES) of each prediction: its error against the truth, all six '
        'components, by the covariance that it claimed. Predictions that follow each other hold '
        'the same commands, so a single run is no test: the campaign `consistency` is.',
        signals=(TRUTH.name, PREDICTION.name), also=(f'{PREDICTION.name}.covariance',)),
}
