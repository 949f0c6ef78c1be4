"""
Make the pictures of docs/cluttered.md again from the folder of its campaign.

    ./rvd campaign cluttered --out runs/cluttered
    ./rvd shell python scripts/cluttered_pictures.py runs/cluttered
"""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pyarrow.parquet

from rvd_campaign.campaign.spec import load_campaign
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.geometry import cone
from rvd_dynamics.recording.drawing import BLUE, canvas, DASHED, GREEN, INK, ORANGE, png
from rvd_dynamics.recording.worded import worded
from rvd_missions.lunar_approach.cluttered import draw
from rvd_missions.lunar_approach.figures import draw_obstacles, upwards
from rvd_missions.lunar_approach.signals import TRUTH

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'
RUN = 8
FLOWN = {'manual,spheres=four': INK, 'damped_apf,spheres=four': ORANGE,
         'barrier stops only,spheres=four': GREEN, 'barrier,spheres=four': BLUE}


def outcomes(folder: Path, campaign: object) -> object:
    """Draw what became of the runs in the campaign's folder."""
    whole = pyarrow.parquet.read_table(folder / 'results.parquet')
    columns = {name: whole[name].to_numpy(zero_copy_only=False) for name in whole.column_names}
    tables = {c.name: {name: values[columns['condition'] == c.name]
                       for name, values in columns.items()} for c in campaign.conditions}
    return draw(SimpleNamespace(shown=campaign.conditions, tables=tables))[0]


def tracks(campaign: object) -> object:
    """Draw one run of four spheres under four conditions, in both planes."""
    figure = canvas(5.0, top=0.5, hspace=0.2)
    panels = figure.subplots(2, 1, sharex=True)
    shown = {c.name: c.scenario for c in campaign.conditions if c.name in FLOWN}
    for axes, lateral in zip(panels, (1, 2)):
        scenario = next(iter(shown.values()))
        x = np.linspace(-30.0, 0.0, 61)
        for sign in (1.0, -1.0):
            axes.plot(x, sign*cone.radius(x, scenario.part('cone')), color=INK, linestyle=DASHED)
        draw_obstacles(axes, scenario, lateral, RUN)
        axes.set(ylabel=f'{"xyz"[lateral]} [m]', xlim=(-30.3, 0.6),
                 ylim=upwards(lateral, 1.9))
    for name, colour in FLOWN.items():
        flown = fly(shown[name], [RUN], record=[TRUTH.name])
        state = flown.history[TRUTH.name].state[:flown.end_step[0] + 1, 0]
        for axes, lateral in zip(panels, (1, 2)):
            axes.plot(state[:, 0], state[:, lateral], color=colour, linewidth=1.4,
                      label=f'{worded(name.partition(",")[0])}: {flown.verdict.reason[0]}')
            axes.plot(state[-1, 0], state[-1, lateral], 'o', color=colour, markersize=5)
    panels[1].set_xlabel('x, along track [m]')
    panels[0].legend(ncols=2, loc='lower left', bbox_to_anchor=(0.0, 1.0), frameon=False)
    return figure


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    made = load_campaign('cluttered')
    png(IMAGES / 'cluttered_outcomes.png', lambda: outcomes(Path(sys.argv[1]), made), dpi=110)
    png(IMAGES / 'cluttered_tracks.png', lambda: tracks(made), dpi=110)
