"""
Who flies and who decides: the settings that operators and sharing have in common.
"""

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run

MODES = ('manual', 'shared', 'auto')
OPERATORS = ('model', 'replay', 'console', 'joy', 'none')
JOY_INPUTS = ('stepped', 'held')
JOY_DRIVERS = ('joystick', 'joy_node', 'external')


@settings
class Operation:
    """Mode, operator, and how a stick is read."""

    mode: str = param(
        'shared', 'Who decides: manual is the operator, auto is the law, shared is both.',
        choices=MODES)
    operator: str = param(
        'model', 'Who flies: model is a pilot model, replay a tape, console the browser, joy a '
        'joystick node, none nobody.', choices=OPERATORS)
    joy_input: str = param(
        'stepped', 'How the stick is read: stepped takes one Joy for each step, held the newest '
        'Joy of the last half second.', choices=JOY_INPUTS)
    joy_driver: str = param(
        'joystick', 'Who publishes a held stick of operator joy: joystick is our own driver, '
        'joy_node that of the ROS package joy, external a node that somebody else starts.',
        choices=JOY_DRIVERS)

    @property
    def stepped(self) -> bool:
        """Whether an operator answers every step, so that the graph waits for it."""
        return self.operator != 'none' and self.joy_input == 'stepped'


def checked(operation: Operation, run: Run) -> Operation:
    """
    Return the operation, or refuse one that the run's pace does not allow.

    Raises
    ------
    ValueError
        If a stick is to be held in lock step.
    """
    if operation.joy_input == 'held' and run.pace == 'lockstep':
        raise BadInput('joy_input held needs pace realtime: lock step has no wall clock '
                       'by which a stick could be held')
    return operation
