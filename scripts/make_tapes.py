"""
Make the shipped tapes again: what the model pilot did in a flown scenario, and two idle hands.

    ./rvd shell python scripts/make_tapes.py
"""

from pathlib import Path

import numpy as np

from rvd_dynamics.commands.levels import HIGHEST, stick_axes, StickParams
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_missions.lunar_approach.signals import STICK

ROOT = Path(__file__).resolve().parents[1]
END_S = 200.0                   # [s] the tapes last as long as a run may


def main() -> None:
    """Write tapes/*.csv."""
    paper = load(ROOT / 'scenarios' / 'paper.yaml')
    flight = fly(paper, [0], record=[STICK.name])
    stick, step_s = paper.part('stick'), paper.run.step_s
    if not flight.verdict.success[0]:
        raise SystemExit('seed 0 no longer docks: choose another for the tape')
    levels = flight.history[STICK.name].command[:, 0]
    write('docking', 'The model pilot who docks in scenario paper with seed 0, in mode shared and '
          'lock step.', stick, np.arange(len(levels)) * step_s, levels)
    write('hands_off', 'A pilot who holds the dead-man button and touches nothing.',
          stick, [0.0], np.zeros((1, 3)))
    stuck = np.array([[0, 0, 0], [0, 3, 0]])
    write('stuck_stick', 'A stick that jams at full +y after 40 s.', stick, [0.0, 40.0], stuck)


def write(name: str, meaning: str, stick: StickParams, t_s, levels) -> None:
    """Write the samples at which the stick moves; the last holds to the end of the tape."""
    axes = np.array([stick_axes(row / HIGHEST, True, stick)[0] for row in levels])
    moved = np.append(True, np.any(np.diff(axes, axis=0), axis=1))
    rows = [(t, *row) for t, row, new in zip(t_s, axes, moved) if new] + [(END_S, *axes[-1])]
    head = ['t_s'] + [f'axis_{i}' for i in range(5)] + [f'button_{i}' for i in range(5)]
    lines = [f'# {meaning}', ','.join(head)]
    lines += [','.join(f'{value:.9g}' for value in row) + ',0,0,0,0,1' for row in rows]
    (ROOT / 'tapes' / f'{name}.csv').write_text('\n'.join(lines) + '\n', encoding='utf-8')


if __name__ == '__main__':
    main()
