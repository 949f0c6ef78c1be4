"""
Signals of the rendezvous. Frame: target orbital, state (x, y, z, vx, vy, vz).
"""

from functools import lru_cache
from typing import NamedTuple

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

CODECS = link.CODECS
STATE = 'rvd_interfaces/msg/RelativeState'

_state = Part('state', (6,), 'm, m/s')
_valid = Part('valid', (), '', '?')

TRUTH = Signal('/truth/relative_state', (
    _state, Part('acceleration', (3,), 'm/s^2'), Part('final', (), '', '?')),
    STATE, f'{CODECS}:Truth', truth=True)
DOWNLINK, TELEMETRY = link.downlink(_state), link.telemetry(_state)
_covariance = Part('covariance', (6, 6), 'm, m/s', optional=True, spread=True)     # of nobody
PREDICTION = Signal('/ground/prediction', (_state, _valid, _covariance), STATE,
                    f'{CODECS}:Prediction')
GUIDANCE = Signal('/ground/guidance', (     # what the law sees and wants
    Part('range', (), 'm'), Part('direction', (), 'rad'), Part('range_rate', (), 'm/s'),
    Part('direction_rate', (), 'rad/s'), Part('reference_rate', (), 'm/s'),
    Part('along', (), 'm/s^2'), Part('across', (), 'm/s^2'), Part('anomaly', (), 'rad'),
    Part('near', (), '', '?')))
COMMAND = '/ground/command'


class CommandSignals(NamedTuple):
    """The signals whose layout depends on the command form."""

    command: Signal
    uplink: Signal
    arrival: Signal
    thrust: Signal


@lru_cache(maxsize=16)
def command_signals(command: Part) -> CommandSignals:
    """Return the signals for the part that carries a command."""
    return CommandSignals(Signal(COMMAND, (command, link.KIND)), link.uplink(command),
                          link.arrival(command), link.thrust(command))
