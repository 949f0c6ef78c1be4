"""
Settings of the approach among obstacles that belong to no single block.

Frame   target orbital: +x along track, +y radially outward, +z completes the triad. The source
        has x radial, y along track, z along the orbit normal: (x, y, z) here is (y, x, -z) there.
Source  Xu, Zhang, Chinese J. Theor. Appl. Mech. 52(6), simulation parameters; what the scan lost is
        reconstructed (docs/missions/obstacle_field.md).
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.form import thrusters
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry.obstacles import require_apart, Spheres

STATIC, ORBIT = MOTIONS = ('static', 'orbit')
ThrusterParams = thrusters(0.01)


@settings
class Orbit:
    """Circular orbit of the target."""

    mean_motion_rad_s: float = param(
        1.1e-3, 'Mean motion of the target [rad/s].', above=0.0, high=0.1)

    @property
    def mean_motion(self) -> float:
        """Orbital rate of the target [rad/s]."""
        return self.mean_motion_rad_s


@settings
class Start:
    """Nominal start of the chaser."""

    position_m: tuple = param(
        (50.0, -10.0, -25.0), 'Nominal start position along x, y and z [m].', length=3)
    velocity_m_s: tuple = param(
        (0.0, 0.0, 0.0), 'Nominal start velocity along x, y and z [m/s].', length=3)

    @property
    def state(self) -> NDArray[np.float64]:
        """Position and velocity, shape (6,) [m, m/s]."""
        return np.array(self.position_m + self.velocity_m_s)


@settings
class Craft:
    """Chaser and target as spheres, the chaser's mass and engines, and where a run ends."""

    chaser_radius_m: float = param(1.0, 'Radius of the chaser [m].', above=0.0, high=1000.0)
    target_radius_m: float = param(1.0, 'Radius of the target [m].', above=0.0, high=1000.0)
    arrival_gap_m: float = param(
        0.5, 'Gap between chaser and target at which the chaser has arrived [m].', above=0.0,
        high=1000.0)
    mass_kg: float = param(100.0, 'Mass of the chaser at the start [kg].', above=0.0, high=1e7)
    specific_impulse_s: float = param(
        300.0, 'Specific impulse of the engines [s].', above=0.0, high=1e5)

    @property
    def contact_m(self) -> float:
        """Distance of the centres of chaser and target at contact [m]."""
        return self.chaser_radius_m + self.target_radius_m

    @property
    def arrival_m(self) -> float:
        """Distance of the centres at which the chaser has arrived [m]."""
        return self.contact_m + self.arrival_gap_m


@settings
class Obstacles(Spheres):
    """What is known of the obstacles before the flight: how many, how large, how they move."""

    motion: tuple = param(
        (STATIC, STATIC, STATIC), 'How each obstacle moves: static in the frame of the target, or '
        'on an orbit of its own.', choices=MOTIONS)

    def __post_init__(self) -> None:
        Spheres.__post_init__(self)
        require(len(self.motion) == len(self.radius_m), 'motion',
                f'be {len(self.radius_m)} words, one for each radius_m', list(self.motion))

    @property
    def moving(self) -> NDArray[np.bool_]:
        """Which of them are on an orbit, (M,)."""
        return np.array([motion == ORBIT for motion in self.motion[:self.count]], dtype=bool)


# -- parts that blocks ask for by name ---------------------------------------------------------

def contact_m(craft: Craft) -> float:
    """Return the distance of chaser and target at contact [m]."""
    return craft.contact_m


def reach_m(craft: Craft, obstacles: Obstacles) -> NDArray[np.float64]:
    """Return the distances (M,) of the centres of chaser and obstacles at contact [m]."""
    return craft.chaser_radius_m + obstacles.radii


def away(start: Start) -> tuple[int, int, int]:
    """Return signs of x, y, z that lead away from the target, along the longest axis."""
    longest = int(np.argmax(np.abs(start.position_m)))
    return tuple(int(np.sign(v)) if i == longest else 0 for i, v in enumerate(start.position_m))


def law(scenario: Scenario) -> Any:
    """Return the guidance law, with what it asks for besides its settings."""
    return scenario.wired(scenario.settings('auto_controller').selected)


def usual_steps(scenario: Scenario, run: Run) -> int:
    """Return a number of steps that few runs outlast; all where nothing is drawn for each step."""
    drawn = any(name == 'noise' or name == 'execution' for block in scenario.diagram.blocks
                for name in block.draws)
    return int(1100.0 / run.step_s) if drawn else run.last_step + 1


def clear_start(scenario: Scenario, start: Start, craft: Craft, obstacles: Obstacles) -> bool:
    """
    Refuse a field that cannot be flown.

    Raises
    ------
    ValueError
        Names the key, the value and the bound.
    """
    first = np.array(start.position_m)
    far = float(np.sqrt(first @ first))
    require(far > craft.arrival_m, 'start.position_m',
            f'be more than {craft.arrival_m:g} m from the target, where a run ends',
            list(start.position_m))
    world = scenario.settings('spacecraft_dynamics').obstacles
    where = world.states(obstacles)
    for i, (place, radius) in enumerate(zip(where[:, :3], obstacles.radii)):
        key = f'spacecraft_dynamics: obstacles.position_m of obstacle {i + 1}'
        require_apart(key, place, np.zeros(3), craft.target_radius_m + radius,
                      'the target, which it would overlap')
        require_apart(key, place, first, craft.chaser_radius_m + radius,
                      'the start, where the chaser is')
    return True
