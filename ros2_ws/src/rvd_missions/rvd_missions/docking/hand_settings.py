"""
Settings of a craft that is flown by hand: who steers, from where, and the delays.
"""

from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.hand import HandForm, HandParams
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import LegParams, Run
from rvd_dynamics.diagram.time_grid import whole_steps
from rvd_groundstation.operators.operation import checked, JOY_INPUTS

STEERINGS = ('profile', 'aboard', 'remote')


@settings
class Steering:
    """Who steers the craft."""

    steering: str = param(
        'profile', 'Who steers: profile is the craft alone, aboard are hand controllers in the '
        'craft, remote ones on the ground, through the link.', choices=STEERINGS)
    operator: str = param(
        'none', 'Who holds the hand controllers: model is a pilot model, replay a tape, joy any '
        'node that publishes /joy/translation and /joy/rotation, console the browser, which '
        'watches with steering profile; none is nobody.',
        choices=('model', 'replay', 'console', 'joy', 'none'))
    joy_input: str = param(
        'stepped', 'How the controllers are read: stepped takes one Joy for each step, held the '
        'newest Joy of the last half second.', choices=JOY_INPUTS)

    @property
    def by_hand(self) -> bool:
        """Whether anybody steers by hand."""
        return self.steering != 'profile'

    @property
    def mode(self) -> str:
        """Who decides, in a word."""
        return 'manual' if self.by_hand else 'auto'

    @property
    def stepped(self) -> bool:
        """Whether an operator answers every step, so that the graph waits for it."""
        return self.by_hand and self.joy_input == 'stepped'


@settings
class LinkDelay(LegParams):
    """Delays of the two legs of the link, after their play-out buffers; none by default."""

    forward_delay_s: float = param(
        0.0, 'Constant delay of the forward link [s].', low=0.0, high=60.0)
    back_delay_s: float = param(
        0.0, 'Constant delay of the back link [s].', low=0.0, high=60.0)


def steered(operation: Steering, run: Run, hand: HandParams, planner: Any) -> Steering:
    """
    Return who steers, or refuse who cannot.

    Raises
    ------
    BadInput
        Names key and value.
    """
    whole_steps('hand.pulse_s', hand.pulse_s, run.step_s)
    if not operation.by_hand:
        if operation.operator not in ('none', 'console'):
            raise BadInput(f'operator {operation.operator} needs steering aboard or remote, got '
                           'profile: the craft flies by itself')
        return operation
    if planner.planner != 'velocity_profile':
        raise BadInput(f'planner {planner.planner} needs steering profile: nobody tracks its plan '
                       f'by hand, got {operation.steering}')
    if operation.operator == 'none':
        raise BadInput(f'steering {operation.steering} needs an operator: model, replay, console '
                       'or joy, got none')
    return checked(operation, run)


def hand_form(hand: HandParams) -> HandForm:
    """Return the form of the commands of both hands."""
    return HandForm(hand)
