"""
Make the pictures of docs/missions/tether.md again, from flights in process.

    ./rvd shell python scripts/make_tether_pictures.py
"""

from pathlib import Path

import numpy as np

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.drawing import (
    ABOVE, canvas, DASHED, INK, MUTED, ORANGE, png, VERMILLION)
from rvd_dynamics.recording.history import everything, of_history
from rvd_missions.tether import figures, geometry
from rvd_missions.tether.signals import TRACKING, TRUTH

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / 'docs' / 'images'
DRAWN = {'tether': ('inputs', 'trajectory', 'attitude', 'sight'),
         'tether_open_loop': ('trajectory', 'tether_torque', 'sight')}


def flown(name: str):
    """Return the recording of a scenario, flown in this process."""
    scenario = load(ROOT / 'scenarios' / f'{name}.yaml')
    return of_history(scenario, fly(scenario, [0], record=everything(scenario)))


def cases(open_loop, closed_loop):
    """Draw what the text of the paper speaks of, case 1 on the left, case 2 on the right."""
    figure = canvas(9.0, top=0.42, hspace=0.34, wspace=0.17)
    panels = figure.subplots(5, 2, sharex=True)
    for column, run, numbers in ((0, open_loop, (4, 7, 8, 9, 10)),
                                 (1, closed_loop, (11, 14, 15, 12, 16))):
        truth, told = run.of(TRUTH), run.of(TRACKING)
        sight = figures.direction(told['planned'][:, 1:3])
        off = np.linalg.norm(told['range'][:, np.newaxis]*sight - truth['target'], axis=-1)
        angles = geometry.euler(truth['state'][:, 6:10])
        axes = panels[:, column]
        plan = run.scenario.part('preparation').plan
        axes[0].plot(plan.node_s, plan.controls[:, 0], color=VERMILLION, linestyle='', marker='o',
                     markersize=3.0, label='planned, at the nodes')
        axes[0].plot(truth.t, truth['tension'], color=INK, label='actual')
        axes[1].plot(truth.t, off, color=INK)
        for i, name, colour in ((0, 'roll', figures.AXES[0]), (1, 'pitch', figures.AXES[1]),
                                (2, 'yaw', figures.AXES[2])):
            axes[2].plot(told.t, told['planned'][:, 3 + i], color=colour, linestyle=DASHED,
                         linewidth=1.0)
            axes[2].plot(truth.t, angles[:, i], color=colour, label=name)
        if column == 0:
            arm = run.scenario.part('gripper').attachment_m
            turned = figures.torque(arm*truth['tension'], truth['state'][:, :3],
                                    truth['state'][:, 6:10])
            for i, name in ((1, 'about y'), (2, 'about z')):
                axes[3].plot(truth.t, turned[:, i], color=figures.AXES[i], label=name)
        else:
            for i, name in enumerate(('along', 'in plane', 'out of plane')):
                axes[3].plot(truth.t, truth['applied'][:, 1 + i], color=figures.AXES[i], label=name)
                axes[3].plot(told.t, told['feedforward'][:, 1 + i], color=figures.AXES[i],
                             linestyle=DASHED, linewidth=1.0)
        meant = geometry.sight_angle(geometry.quaternion(told['planned'][:, 3:]), sight)
        axes[4].plot(told.t, meant, color=MUTED, linestyle=DASHED)
        axes[4].plot(truth.t, geometry.sight_angle(truth['state'][:, 6:10], truth['target']),
                     color=INK)
        axes[4].axvline(52.0, color=ORANGE, linewidth=0.8)
        axes[4].axhline(0.22 if column == 0 else 0.18, color=VERMILLION, linewidth=0.8)
        for panel, number, label in zip(axes, numbers, (
                'tension [N]', 'off its plan [m]', 'attitude [rad]',
                'tether torque [N m]' if column == 0 else 'thrust [N]', 'sight [rad]')):
            panel.set(ylabel=label, title=f'{number}')
        for panel in (axes[0], axes[2], axes[3]):
            panel.legend(ncols=3, **ABOVE)
        axes[4].set(xlabel='time [s]', ylim=(0.0, None))
    return figure


if __name__ == '__main__':
    runs = {}
    for scenario_name, names in DRAWN.items():
        run = runs[scenario_name] = flown(scenario_name)
        for figure in names:
            png(IMAGES / f'{scenario_name}_{figure}.png',
                lambda draw=figures.FIGURES[figure].draw: draw(run))
    png(IMAGES / 'tether_cases.png', lambda: cases(runs['tether_open_loop'], runs['tether']))
