"""
Obstacles as viewers draw them: spheres that stand where the map of a run says.
"""

from rvd_dynamics.diagram.display import Field, Sphere
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_missions.lunar_approach.settings import Obstacles

CRAFT_RADIUS_M = 0.3            # of the chaser in the scene of the markers; a symbol, not its size


def scene(scenario: Scenario) -> Field | None:
    """Return what the markers draw besides craft and corridor; None where there is no obstacle."""
    spheres = obstacle_spheres(scenario.part('obstacles'), scenario.run)
    return Field(spheres, (), CRAFT_RADIUS_M, corridor=True) if spheres else None


def obstacle_spheres(obstacles: Obstacles, run: Run) -> tuple[Sphere, ...]:
    """Return the keep-out spheres of a run."""
    places = obstacles.places(run.seed, [run.run], ())
    return tuple(Sphere(f'obstacle {i + 1}', 'limit', float(r), tuple(place.tolist()))
                 for i, (place, r) in enumerate(zip(places, obstacles.radii)))
