"""
Settings of the approach that belong to no single block, and what is made of them.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, section 3.1.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.levels import LevelForm, ThrustParams
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import LegParams, Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import StartNormals
from rvd_dynamics.geometry.cone import Cone
from rvd_dynamics.geometry.keep_out import Stop, stop_of, StopParams
from rvd_dynamics.geometry.obstacles import require_apart, rows_of, Spheres
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.operators.operation import checked, Operation

SHORTEST_STEP_S, LONGEST_STEP_S = 0.05, 1.0
SURVEYED = 'lunar_approach/obstacles/places'        # stream of where the obstacles are


@settings
class DockingParams:
    """Limits at the docking plane (section 3.1 of the paper)."""

    max_closing_rate_m_s: float = param(
        0.3, 'Closing rate that must not be reached at the docking plane [m/s].', above=0.0)
    max_lateral_rate_m_s: float = param(
        0.3, 'Lateral rate that must not be reached at the docking plane [m/s].', above=0.0)


@settings
class Measured:
    """What is measured of a run in a campaign besides what its judge measures."""

    prediction: bool = param(
        False, 'Hold each prediction against the truth of its instant: its error by its own '
        'covariance, and how often it lies within two deviations.')


@settings
class Obstacles(Spheres):
    """
    Keep-out spheres that stand in the frame of the target, for the centre of the chaser.

    Where they are is known before the flight, to the ground as to everybody: the scatter moves
    them from run to run, and the map with them.
    """

    number: int = param(
        0, 'Number of obstacles, the first ones of those listed, where -1 means all.', low=-1,
        high=64)
    radius_m: tuple = param(
        (0.4, 0.4), 'Radius of each keep-out sphere, the chaser\'s own included [m].', above=0.0,
        high=1000.0)
    position_m: tuple = param(
        (-19.0, 0.3, 0.1, -12.0, -0.3, -0.1),
        'Nominal position x, y, z of one obstacle after the other [m].')
    scatter_m: tuple = param(
        (0.0, 0.0, 0.0), 'Standard deviations of an obstacle\'s position about its nominal one '
        'along x, y and z, drawn for each run [m].', low=0.0, length=3)
    stop: StopParams = param(StopParams, 'What a stop short of an obstacle counts on.')

    def __post_init__(self) -> None:
        """Check nothing here: whether the lists fit each other is seen by `clear_start`."""

    @property
    def nominal(self) -> NDArray[np.float64]:
        """Nominal positions (M, 3) [m]."""
        return rows_of('position_m', self.position_m, len(self.radius_m))[:self.count]

    def places(self, seed: int, runs: Sequence[int], batch: tuple) -> NDArray[np.float64]:
        """Return where the obstacles are in runs, (*batch, M, 3), or (M, 3) where all agree [m]."""
        if not self.count or not any(self.scatter_m):
            return self.nominal
        # all that are listed are drawn, so that fewer of them stand where they stood among more
        drawn = StartNormals(SURVEYED, 3*len(self.radius_m)).of_runs(seed, runs, 1)
        drawn = drawn.reshape(*batch, len(self.radius_m), 3)[..., :self.count, :]
        return self.nominal + drawn*np.array(self.scatter_m)


def form(thrust: ThrustParams) -> LevelForm:
    """Return the command form: three levels on each axis."""
    return LevelForm(thrust)


def paced(operation: Operation, run: Run) -> Operation:
    """
    Return the operation, or refuse a time grid or a pace that the approach cannot be flown with.

    Raises
    ------
    ValueError
        Names the key and the value.
    """
    require(SHORTEST_STEP_S <= run.step_s <= LONGEST_STEP_S, 'step_s',
            f'be between {SHORTEST_STEP_S:g} and {LONGEST_STEP_S:g}', run.step_s)
    return checked(operation, run)


def usual_steps(start: StartParams, run: Run) -> int:
    """Return a number of steps that few runs outlast: a tenth more than the nominal approach."""
    closing = max(start.velocity_m_s[0], 1e-9)
    return int(1.1 * -start.position_m[0] / closing / run.step_s + 10.0)


def stop(obstacles: Obstacles, thrust: ThrustParams, orbit: OrbitParams, leg_params: LegParams,
         run: Run) -> Stop | None:
    """Return how the ground plans to stop short of an obstacle; None: there is none."""
    if not obstacles.count:
        return None
    return stop_of(obstacles.stop, form(thrust), orbit.mean_motion, run.step_s, leg_params.loop_s)


def clear_start(scenario: Scenario, obstacles: Obstacles, start: StartParams, cone: Cone) -> bool:
    """
    Refuse obstacles among which nothing can be flown.

    Raises
    ------
    ValueError
        Names the key, the value and the bound.
    """
    if not obstacles.count:
        return True
    listed = len(obstacles.radius_m)
    require(obstacles.count <= listed, 'obstacles.number',
            f'be at most the {listed} that obstacles.radius_m lists', obstacles.number)
    rows_of('obstacles.position_m', obstacles.position_m, listed, 'obstacles.radius_m')
    for i, (place, radius) in enumerate(zip(obstacles.nominal, obstacles.radii)):
        key = f'obstacles.position_m of obstacle {i + 1}'
        require_apart(key, place, np.zeros(3), cone.docking_radius_m + radius,
                      'the docking port, which it would overlap')
        require_apart(key, place, np.array(start.position_m), radius,
                      'the start, where the chaser is')
    scenario.part('stop')
    require(scenario.settings('state_predictor').prediction, 'state_predictor: prediction',
            'be true among obstacles, which laws keep away from by the predicted state', False)
    method = scenario.settings('state_predictor').filter
    require(method != 'scheduled', 'state_predictor: filter',
            'be learned or adaptive among obstacles, where the chaser may stand: the scheduled '
            'filter knows only the straight approach', method)
    return True
