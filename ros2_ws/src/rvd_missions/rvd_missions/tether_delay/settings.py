"""
Settings of the decisions: who takes them, how the ground plans, how the gripper stands still.
"""

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_missions.tether import settings as tether
from rvd_missions.tether.onboard import TrackerParams
from rvd_missions.tether.settings import ApproachParams

MODES = ('model', 'hold', 'go')


@settings
class Operation:
    """Who says go and hold; ABORT is always for whoever is at the console."""

    mode: str = param(
        'model', 'Who decides: model is the stand-in for an operator, the flight director; hold '
        'and go are what a person orders.', choices=MODES)


@settings
class DirectorParams:
    """The flight director, a scripted stand-in for the operator; zero: never."""

    go_s: float = param(1.0, 'Time of the first GO [s].', low=0.0, high=3600.0)
    hold_range_m: float = param(
        60.0, 'Shown distance to the target at which HOLD is ordered, once [m].', low=0.0)
    look_s: float = param(
        10.0, 'Time from when the gripper is seen to stand until GO is ordered again [s].', low=0.0,
        high=3600.0)
    abort_range_m: float = param(
        0.0, 'Shown distance to the target at which ABORT is ordered [m].', low=0.0)
    predicts: bool = param(
        False, 'Whether what is shown is the distance at which an order given now would act, by '
        'the plan; otherwise it is that of the newest telemetry.')
    reaction_s: float = param(0.5, 'Median time from seeing to ordering [s].', low=0.0, high=60.0)
    reaction_spread: float = param(
        0.3, 'Standard deviation of the logarithm of that time.', low=0.0, high=2.0)


@settings
class GroundParams:
    """How mission control plans, and sends a plan up."""

    solve_s: float = param(
        3.0, 'Time that is allowed for a plan: it is used so long after it was asked for [s].',
        low=0.0, high=600.0)
    lead_s: float = param(
        2.0, 'Time that a plan has to be on board before it begins [s].', low=0.0, high=600.0)
    speed_m_s: float = param(
        0.6, 'Mean speed of a plan after a hold, which gives its duration [m/s].', above=0.0,
        high=10.0)
    least_s: float = param(30.0, 'Least duration of such a plan [s].', above=0.0, high=3600.0)
    replan_m: float = param(
        0.0, 'Distance of the gripper from its plan, as the telemetry tells it, from which on it '
        'is planned for anew in flight [m]; 0: never.', low=0.0, high=1000.0)


def tracker(scenario: Scenario) -> TrackerParams:
    """Return the law on board, as the ground has to know it to predict what the gripper does."""
    return scenario.settings('gripper_tracker')


@settings
class StandingParams:
    """How the gripper is stopped, and stands on a taut tether."""

    braking_m_s2: float = param(
        0.05, 'Deceleration along the tether after HOLD [m/s^2].', above=0.0, high=1.0)
    abort_m_s2: float = param(
        0.1, 'Deceleration along the tether after ABORT [m/s^2].', above=0.0, high=1.0)
    ease_s: float = param(
        20.0, 'Time constant with which bearing and attitude go over to pointing at the target '
        '[s].', above=0.0, high=600.0)
    settle_s: float = param(
        5.0, 'Time after the braking from when on the gripper is said to stand [s].', low=0.0,
        high=600.0)


def checked(run: Run, approach: ApproachParams, standing: StandingParams) -> None:
    """Refuse what mission `tether` refuses, and an ABORT that brakes less than a HOLD."""
    tether.checked(run, approach)
    require(standing.abort_m_s2 >= standing.braking_m_s2, 'hold.abort_m_s2', 'not be below '
            f'hold.braking_m_s2, {standing.braking_m_s2:g}', standing.abort_m_s2)
