"""
Signals of the approach among obstacles, for M obstacles and a command form.

Frame: target orbital. States (x, y, z, vx, vy, vz) [m, m/s] relative to the target; those of the
obstacles are (M, 6). What goes over the link is one row: the chaser's state, then the obstacles'.
"""

from functools import lru_cache
from typing import NamedTuple

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

CODECS = link.CODECS
STATE = 'rvd_interfaces/msg/RelativeState'

_state = Part('state', (6,), 'm, m/s')
_valid = Part('valid', (), '', '?')
_covariance = Part('covariance', (6, 6), 'm, m/s', optional=True, spread=True)

TRUTH = '/truth/state'
OBSTACLES = '/ground/obstacles'
ALARM = '/ground/alarm'
ESTIMATE = Signal('/ground/estimate', (_state, _valid, _covariance), STATE, f'{CODECS}:Estimate')
PREDICTION = Signal('/ground/prediction', (_state, _valid, _covariance), STATE,
                    f'{CODECS}:Prediction')


class Signals(NamedTuple):
    """The signals whose layout depends on the obstacles or on the command form."""

    truth: Signal
    downlink: Signal
    telemetry: Signal
    obstacles: Signal           # as the ground foresees them, and the covariance relative to them
    alarm: Signal
    command: Signal
    uplink: Signal
    arrival: Signal
    thrust: Signal


@lru_cache(maxsize=16)
def signals(obstacles: int, command: Part) -> Signals:
    """Return the signals for a number of obstacles and the part that carries a command."""
    sent = Part('state', (6 + 6*obstacles,), 'm, m/s')
    around = Part('obstacles', (obstacles, 6), 'm, m/s')
    return Signals(
        Signal(TRUTH, (_state, Part('acceleration', (3,), 'm/s^2'), around,
                       Part('final', (), '', '?')), truth=True),
        link.downlink(sent), link.telemetry(sent),
        Signal(OBSTACLES, (around, _valid,
                           Part('covariance', (obstacles, 3, 3), 'm^2', spread=True))),
        Signal(ALARM, (
            Part('on', (obstacles,), '', '?'), Part('distance', (obstacles,), 'm'),
            Part('zone', (obstacles,), 'm'),
            Part('probability', (obstacles,), '', optional=True))),
        Signal('/ground/command', (command, link.KIND)),
        link.uplink(command), link.arrival(command), link.thrust(command))
