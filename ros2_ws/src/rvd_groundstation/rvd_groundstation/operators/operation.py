"""
Who flies and who decides: the settings that operators and sharing have in common.
"""

from dataclasses import dataclass

from rvd_dynamics.diagram.params import param, require
from rvd_dynamics.diagram.run import Run

MODES = ('manual', 'shared', 'auto')
OPERATORS = ('model', 'replay', 'console', 'joy', 'none')
JOY_INPUTS = ('stepped', 'held')


@dataclass(frozen=True)
class Operation:
    """Mode, operator, and how a stick is read."""

    mode: str = param('shared', 'Who decides: manual, the operator; auto, the law; shared, both.')
    operator: str = param('model', 'Operator: model, a pilot model; replay, a tape; console, the '
                          'browser; joy, a joystick node; none.')
    joy_input: str = param('stepped', 'How the stick is read: stepped, one Joy for each step; '
                           'held, the newest Joy of the last half second.')

    def __post_init__(self) -> None:
        for name, allowed in (('mode', MODES), ('operator', OPERATORS), ('joy_input', JOY_INPUTS)):
            require(getattr(self, name) in allowed, name, f'be one of {", ".join(allowed)}',
                    getattr(self, name))

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
        raise ValueError('joy_input held needs pace realtime: lock step has no wall clock '
                         'by which a stick could be held')
    return operation
