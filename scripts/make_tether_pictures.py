"""
Make the pictures of docs/missions/tether.md again, from flights in process.

    ./rvd shell python scripts/make_tether_pictures.py
"""

from pathlib import Path

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.history import everything, of_history
from rvd_missions.tether import figures

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / 'docs' / 'images'
DRAWN = {'tether': ('inputs', 'trajectory', 'attitude', 'sight'),
         'tether_open_loop': ('trajectory', 'tether_torque', 'sight')}


def flown(name: str):
    """Return the recording of a scenario, flown in this process."""
    scenario = load(ROOT / 'scenarios' / f'{name}.yaml')
    return of_history(scenario, fly(scenario, [0], record=everything(scenario)))


if __name__ == '__main__':
    for scenario_name, names in DRAWN.items():
        run = flown(scenario_name)
        for figure in names:
            png(IMAGES / f'{scenario_name}_{figure}.png',
                lambda draw=figures.FIGURES[figure].draw: draw(run))
