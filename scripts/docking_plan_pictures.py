"""
Make the table and pictures of plans and images of docs/missions/docking.md again.

    ./rvd campaign docking_planners --out runs/planners
    ./rvd fly docking_images --processes one --pace lockstep --out runs/images
    ./rvd shell python scripts/docking_plan_pictures.py runs/planners runs/images
"""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pyarrow.parquet as parquet

from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.reader import read
from rvd_groundstation.planning.closing.task import margins
from rvd_missions.docking.figures import navigation
from rvd_missions.docking.markers import CHASER_PORT, TARGET_PORT
from rvd_missions.docking.planner_figures import DRAWN, FIGURES
from rvd_missions.docking.profile import Profile

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / 'docs' / 'images'


class OnBoard:
    """The profile that the craft makes itself, as a plan of the ground."""

    def __init__(self, scenario: object, task: object) -> None:
        aim, start = scenario.part('aim'), np.array([scenario.part('start').position_m])
        self._profile = Profile(scenario.settings('docking_controller').profile,
                                start + CHASER_PORT - TARGET_PORT, aim.distance_m, aim.nominal_s)
        self.duration_s, self._task = aim.nominal_s, task
        t = np.linspace(0.0, self.duration_s, 20_001)
        _, accel = self.at(t)
        effort = float((accel*accel).sum(axis=-1).mean()*self.duration_s)
        self.cost = task.cost(self.duration_s, effort)

    def at(self, times: object) -> tuple:
        """Return states (..., 6) and accelerations (..., 3); see `task.Reference`."""
        def state(t: float) -> np.ndarray:
            port, speed = self._profile.at(t)
            return np.concatenate([port[0] - CHASER_PORT + TARGET_PORT, speed[0]])
        h = 1e-4
        made = np.array([state(t) for t in times])
        bend = np.array([(state(t + h) - state(t - h))[3:]/(2*h) for t in times])
        return made, bend + np.stack(self._task.drift(np.moveaxis(made, -1, 0)), axis=-1)


def table() -> None:
    """Print what the three planners plan."""
    for name in ('velocity_profile', 'polynomial', 'pseudospectral'):
        scenario = load(ROOT / 'scenarios' / 'docking.yaml').with_values(
            '/**', planner='pseudospectral' if name == 'velocity_profile' else name)
        made = scenario.part('preparation')
        task = made.maker.task
        plan = OnBoard(scenario, task) if name == 'velocity_profile' else made.nominal
        effort = (plan.cost - task.cost(plan.duration_s, 0.0))/task.effort_weight
        print(f'{name}: {plan.duration_s:.8f} s, J {plan.cost:.10f}, effort {effort:.4e} m^2/s^3, '
              f'{margins(task, plan)}')


def main(campaign: Path, images: Path) -> None:
    """Print the table and draw both pictures."""
    table()
    flown = parquet.read_table(campaign / 'results.parquet').to_pydict()
    names = np.array(flown['condition'])
    tables = {name: {column: np.array(flown[column], dtype=float)[names == name]
                     for column in DRAWN} for name in dict.fromkeys(flown['condition'])}
    figure = FIGURES['planners'].draw
    png(IMAGES / 'docking-planners.png', lambda: figure(SimpleNamespace(tables=tables))[0])
    run = read(images)
    png(IMAGES / 'docking-images.png', lambda: navigation(run))


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    main(Path(sys.argv[1]), Path(sys.argv[2]))
