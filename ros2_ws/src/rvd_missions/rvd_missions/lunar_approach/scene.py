"""
Obstacles as viewers draw them: spheres that stand where the map of a run says.
"""

from typing import Any

from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_missions.lunar_approach.settings import Obstacles

CRAFT_RADIUS_M = 0.3            # of the chaser in the scene of the markers; a symbol, not its size
# Named as text: every process asks for the scene to know its topics, few draw it.
SHAPES = 'rvd_dynamics.diagram.display.scene'


def scene(scenario: Scenario) -> Any:
    """
    Return the `Field` that markers draw besides the corridor; None where there is no obstacle.
    """
    spheres = obstacle_spheres(scenario.part('obstacles'), scenario.run)
    if not spheres:
        return None
    return loaded(f'{SHAPES}:Field')(spheres, (), CRAFT_RADIUS_M, corridor=True)


def obstacle_spheres(obstacles: Obstacles, run: Run) -> tuple[Any, ...]:
    """Return the keep-out spheres of a run, each a `Sphere`."""
    places = obstacles.places(run.seed, [run.run], ())
    sphere = loaded(f'{SHAPES}:Sphere') if len(places) else None
    return tuple(sphere(f'obstacle {i + 1}', 'limit', float(r), tuple(place.tolist()))
                 for i, (place, r) in enumerate(zip(places, obstacles.radii)))
