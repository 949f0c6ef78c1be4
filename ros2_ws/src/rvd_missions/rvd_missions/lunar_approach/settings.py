"""
Settings of the approach that belong to no single block, and what is made of them.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, section 3.1.
"""

from rvd_dynamics.commands.levels import LevelForm, ThrustParams
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion.orbit import StartParams
from rvd_groundstation.operators.operation import checked, Operation

SHORTEST_STEP_S, LONGEST_STEP_S = 0.05, 1.0


@settings
class DockingParams:
    """Limits at the docking plane (section 3.1 of the paper)."""

    max_closing_rate_m_s: float = param(
        0.3, 'Closing rate that must not be reached at the docking plane [m/s].', above=0.0)
    max_lateral_rate_m_s: float = param(
        0.3, 'Lateral rate that must not be reached at the docking plane [m/s].', above=0.0)


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
