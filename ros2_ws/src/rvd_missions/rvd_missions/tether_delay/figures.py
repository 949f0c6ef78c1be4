"""
The figures of a run: those of `tether`, and what was done when.
"""

from typing import TYPE_CHECKING

import numpy as np

from rvd_dynamics.recording.drawing import canvas, DASHED, Figure, GREEN, INK, MUTED, ORANGE
from rvd_dynamics.recording.recording import Recording
from rvd_missions.tether import figures as tether
from rvd_missions.tether_delay.signals import CRAFT, SITUATION, TRUTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

WORDS = ('on the latch', 'under way', 'brakes', 'stands', 'arrived', 'aborted')


def decisions(run: Recording) -> 'Canvas':
    """Draw the distance to the target, as it was and as it was shown, and what was done."""
    figure = canvas(4.4, top=0.3, hspace=0.12, left=0.11)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    truth, craft, shown = run.of(TRUTH), run.of(CRAFT), run.of(SITUATION)
    above.plot(truth.t, np.linalg.norm(truth['target'], axis=-1), color=INK, label='true')
    above.plot(shown.t, shown['range'], color=ORANGE, label='shown on the ground')
    above.plot(shown.t, shown['ahead'], color=MUTED, linestyle=DASHED,
               label='where an order would act, by the plan')
    above.axhline(run.scenario.part('approach').final_range_m, color=GREEN, linewidth=0.8)
    above.set(ylabel='distance to the target [m]')
    above.legend(loc='upper right')
    below.step(craft.t, craft['doing'], where='post', color=INK, label='on board')
    below.step(shown.t, shown['doing'], where='post', color=ORANGE, label='on the ground')
    below.set_yticks(range(len(WORDS)), WORDS)
    below.set(xlabel='time [s]')
    return figure


FIGURES = {
    'decisions': Figure(
        decisions, 'Decisions', 'Above: distance to the target; green: where the approach ends. '
        'Below: what the gripper does, and what the ground knows of it.',
        signals=(TRUTH.name, CRAFT.name, SITUATION.name)),
    **{name: figure for name, figure in tether.FIGURES.items() if name != 'tether_torque'}}
