"""
What every mission's scenario says: the run itself, and the delays of the link.
"""

from functools import cached_property
from typing import NamedTuple

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.diagram import GROUPINGS
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.time_grid import whole_steps

PACES = ('lockstep', 'realtime')
DEFAULT_MISSION = 'lunar_approach'


@settings
class Run:
    """Time grid, random seed and pace of a run."""

    mission: str = param(
        DEFAULT_MISSION, 'Name of the mission that is flown, one of `rvd list missions`.')
    step_s: float = param(0.5, 'Base step of the diagram [s].', low=0.001, high=10.0)
    timeout_s: float = param(
        200.0, 'Simulated time after which the run ends at the latest [s].', above=0.0,
        high=86400.0)
    seed: int = param(0, 'Seed of every random stream.', low=0, high=2**63 - 1)     # what ROS takes
    run: int = param(0, 'Number of the run within the seed.', low=0, high=2**32 - 1)
    pace: str = param(
        'lockstep', 'Pace of simulated time: lockstep runs as fast as the machine allows, '
        'realtime follows the wall clock.', choices=PACES)
    pace_factor: float = param(
        1.0, 'Simulated seconds per second of wall time with pace realtime.', low=0.01,
        high=1000.0)
    processes: str = param(
        'blocks', 'How blocks share processes: blocks gives each its own, segments one to each '
        'segment, one the same to all.', choices=GROUPINGS)
    frame_id: str = param('target_lvlh', 'Name of the frame in which states are given.')
    nodes: tuple = param(
        ('',), 'Names of all nodes of this run, set at bring-up, where an empty name means all '
        'that the run cannot do without.')

    def __post_init__(self) -> None:
        require(abs(self.step_s * NS_PER_S - self.step_ns) < 1e-3, 'step_s',
                'be a whole number of nanoseconds', self.step_s)
        require(self.step_s <= self.timeout_s, 'timeout_s', 'be between one step and 86400',
                self.timeout_s)

    @cached_property
    def step_ns(self) -> int:
        """Base step [ns]; every instant is a whole number of these."""
        return round(self.step_s * NS_PER_S)

    @cached_property
    def last_step(self) -> int:
        """First step at or after the time limit: no run is longer."""
        return -(-round(self.timeout_s * NS_PER_S) // self.step_ns)


class Legs(NamedTuple):
    """Constant delays of the link on the grid of a run [steps]."""

    forward: int                        # ground to craft
    back: int                           # craft to ground
    step_s: float                       # [s]

    @property
    def loop(self) -> int:
        """Delay around the loop [steps]."""
        return self.forward + self.back


@settings
class LegParams:
    """Delays of the two legs of the link, after their play-out buffers."""

    forward_delay_s: float = param(
        5.0, 'Constant delay of the forward link [s].', low=0.0, high=3600.0)
    back_delay_s: float = param(
        5.0, 'Constant delay of the back link [s].', low=0.0, high=3600.0)

    @property
    def loop_s(self) -> float:
        """Delay around the loop [s]."""
        return self.forward_delay_s + self.back_delay_s

    def on(self, run: Run) -> Legs:
        """
        Return the delays in steps.

        Raises
        ------
        ValueError
            If one is not a whole number of steps.
        """
        return Legs(whole_steps('forward_delay_s', self.forward_delay_s, run.step_s),
                    whole_steps('back_delay_s', self.back_delay_s, run.step_s), run.step_s)


def legs(leg_params: LegParams, run: Run) -> Legs:
    """Return the delays of the link in steps, as a part of a mission; ValueError off the grid."""
    return leg_params.on(run)
