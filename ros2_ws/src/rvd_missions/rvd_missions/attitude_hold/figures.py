"""
The figures of a run: the attitude, its error, and what the law believes.
"""

from typing import TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, every, Figure, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_missions.attitude_hold.signals import LAW, MEASUREMENT, THRUST, TRUTH

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas

DEG = float(np.degrees(1.0))                    # [deg/rad]
LEAST_DEG = 1e-5                                # of the logarithmic scale


def attitude(run: Recording) -> 'Canvas':
    """Draw reference, true and measured attitude, and the torque."""
    figure = canvas(4.2, top=0.42, hspace=0.14)
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    truth, form = run.of(TRUTH), run.scenario.part('form')
    if run.has(MEASUREMENT.name):
        measured = run.of(MEASUREMENT)
        top.plot(measured.t, DEG*measured['state'][:, 0], linestyle='', marker='.', markersize=3.0,
                 color=MUTED, alpha=0.7, label='measured', markevery=every(measured.t))
    top.plot(truth.t, DEG*truth['state'][:, 0], color=INK, linewidth=1.8, label='true')
    top.step(truth.t, DEG*_reference(run), where='post', color=BLUE, linestyle=DASHED,
             label='reference')
    top.set(ylabel='attitude [deg]')
    top.legend(ncols=3, **ABOVE)
    _mark_faults((top, bottom), run)
    thrust = run.of(THRUST)
    bottom.step(thrust.t, thrust['command'][:, 0], where='post', color=BLUE, linewidth=1.2)
    most = form.torque.max_n_m
    if np.nanmax(np.abs(thrust['command']), initial=0.0) > 0.5*most:
        for side in (-most, most):
            bottom.axhline(side, color=VERMILLION, linewidth=1.0)
    bottom.set(xlabel='time [s]', ylabel='torque [N m]')
    return figure


def error(run: Recording) -> 'Canvas':
    """Draw the size of the true error on a logarithmic scale, with limits and windows."""
    figure = canvas(3.2, top=0.30)
    axes = figure.subplots()
    truth, limits = run.of(TRUTH), run.scenario.part('limits')
    size = np.abs(DEG*(truth['state'][:, 0] - _reference(run)))
    axes.semilogy(truth.t, np.maximum(size, LEAST_DEG), color=INK, linewidth=1.2)
    axes.axhline(limits.settled_deg, color=GREEN, linestyle=DASHED, label='settled below')
    axes.axhline(limits.max_rms_deg, color=VERMILLION, label='limit of the rms at the end')
    end = run.scenario.run.timeout_s
    axes.axvspan(end - limits.window_s, end, color=ORANGE, alpha=0.14, linewidth=0,
                 label='window of that rms')
    _mark_faults((axes,), run)
    axes.set(xlabel='time [s]', ylabel='|error| [deg]')
    axes.legend(ncols=3, **ABOVE)
    return figure


def law(run: Recording) -> 'Canvas':
    """Draw what the law believes: parameters of the model, or integral and rate."""
    figure = canvas(3.0, wspace=0.22)
    left, right = figure.subplots(1, 2)
    made = run.of(LAW)
    inside, name = made['inside'], run.scenario.settings('attitude_controller').law
    if name == 'golden_section':
        left.plot(made.t, inside[:, 0], color=BLUE, label='f1')
        left.plot(made.t, -inside[:, 1], color=VERMILLION, linestyle=DASHED, label='\u2212f2')
        right.plot(made.t, inside[:, 2], color=INK)
        left.set(ylabel='f1, \u2212f2', title='Characteristic model')
        right.set(ylabel='b / nominal', title='Gain of the model')
        left.legend()
    else:
        left.plot(made.t, DEG*inside[:, 0], color=BLUE)
        right.plot(made.t, DEG*inside[:, 1], color=INK)
        left.set(ylabel='integral [deg s]', title='Integral of the error')
        right.set(ylabel='rate [deg/s]', title='Filtered rate of the error')
    _mark_faults((left, right), run)
    for axes in (left, right):
        axes.set(xlabel='time [s]')
    return figure


def _reference(run: Recording) -> np.ndarray:
    """Return the reference [rad] of each step of the truth."""
    profile, step_s = run.scenario.part('attitude'), run.scenario.run.step_s
    return np.array([profile.at(int(k), step_s) for k in run.of(TRUTH).step])


def _mark_faults(panels: tuple['Axes', ...], run: Recording) -> None:
    faults = run.scenario.part('faults')
    for gain, at in ((faults.actuator_gain, faults.actuator_at_s),
                     (faults.sensor_gain, faults.sensor_at_s)):
        if gain != 1.0 and at < run.scenario.run.timeout_s:
            for axes in panels:
                axes.axvline(at, color=VERMILLION, linestyle=':', linewidth=1.2)


FIGURES = {
    'attitude': Figure(
        attitude, 'Attitude',
        'True attitude, what the sensors say (after a fault of their gain that is another scale) '
        'and the reference; below, the torque that the guard commanded. Dotted: a fault.',
        signals=(TRUTH.name, THRUST.name), also=(MEASUREMENT.name,)),
    'error': Figure(
        error, 'Error', 'Size of the true error. Dotted: a fault. The run is held if the root mean '
        'square of the error in the shaded window is below the limit.',
        signals=(TRUTH.name,)),
    'law': Figure(
        law, 'What the law believes',
        'Of golden_section the parameters of its characteristic model, which are those of a double '
        'integrator at 2, \u22121 and 1; of pid the integral and the rate of the measured error.',
        signals=(LAW.name,)),
}
