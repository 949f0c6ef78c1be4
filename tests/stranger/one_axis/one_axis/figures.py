"""
The figure of a run: where the craft was, and what its thruster did.
"""

from typing import Any

from rvd_dynamics.recording.drawing import BLUE, canvas, DASHED, Figure, INK, VERMILLION
from rvd_dynamics.recording.recording import Recording

from one_axis.signals import THRUST, TRUTH


def approach(run: Recording) -> Any:
    """Draw position and acceleration over time."""
    figure = canvas(3.6, hspace=0.12)
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    truth, thrust, berth = run.of(TRUTH), run.of(THRUST), run.scenario.part('berth')
    top.plot(truth.t, truth['state'][:, 0], color=INK)
    top.axhline(0.0, color=INK, linewidth=0.8)
    top.axhline(berth.max_overshoot_m, color=VERMILLION, linestyle=DASHED)
    top.set(ylabel='x [m]')
    bottom.step(thrust.t, thrust['command'][:, 0], where='post', color=BLUE)
    bottom.set(xlabel='time [s]', ylabel='command [m/s^2]')
    return figure


FIGURES = {
    'approach': Figure(
        approach, 'Approach',
        'True position over time; the berth is at 0, and the craft must stay below the dashed '
        'line. Below: the acceleration that the guard commanded.',
        signals=(TRUTH.name, THRUST.name)),
}
