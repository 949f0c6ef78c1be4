"""
Signals of the approach. Frame: target orbital, state (x, y, z, vx, vy, vz).
"""

from rvd_dynamics.commands.levels import HIGHEST
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

CODECS = link.CODECS
STATE = 'rvd_interfaces/msg/RelativeState'
THRUST_COMMAND = 'rvd_interfaces/msg/ThrustCommand'
UNTOLD = 255                    # a mode of which nothing has been heard
MODE_COUNT = 3                    # manual, shared, auto
FAR = 1e8                       # [m, m/s] no approach is as far or as fast

_state = Part('state', (6,), 'm, m/s', low=-FAR, high=FAR)
_valid = Part('valid', (), '', '?')
_levels = Part('command', (3,), 'levels', 'i1', low=-HIGHEST, high=HIGHEST)
_covariance = Part('covariance', (6, 6), 'm, m/s', optional=True, spread=True)

TRUTH = Signal('/truth/relative_state', (
    _state, Part('acceleration', (3,), 'm/s^2'), Part('final', (), '', '?')),
    STATE, f'{CODECS}:Truth', truth=True)
MEASUREMENT = Signal('/onboard/measurement', (_state,), STATE, f'{CODECS}:Measurement')
DOWNLINK, TELEMETRY = link.downlink(_state), link.telemetry(_state)
ESTIMATE = Signal('/ground/estimate', (_state, _valid, _covariance), STATE, f'{CODECS}:Estimate')
PREDICTION = Signal('/ground/prediction', (_state, _valid, _covariance), STATE,
                    f'{CODECS}:Prediction')
SCORE = Signal('/ground/prediction_score', (
    _valid, Part('error', (6,), 'm, m/s'), Part('sigma', (6,), 'm, m/s'),
    Part('scored', (), '', 'i8', low=0, counts=True), Part('rms', (6,), 'm, m/s')),
    'rvd_interfaces/msg/PredictionScore', f'{CODECS}:Score')
STICK = Signal('/joy', (
    _levels, _valid, Part('raw', (), 'axes, buttons', 'O', optional=True)),
    'sensor_msgs/msg/Joy', f'{CODECS}:Stick')
READING = Signal('/ground/stick', (     # what one block has read of a held stick, for all
    _levels, _valid, Part('taken', (), '', '?')))
MODE = Signal('/ground/mode', (         # in force from the next step on, for a law that asks
    Part('mode', (), 'index of MODES', 'u1', initial=UNTOLD, codes=(*range(MODE_COUNT), UNTOLD)),))
AUTO = Signal('/ground/auto_command', (_levels, _valid), THRUST_COMMAND, f'{CODECS}:Automatic')
COMMAND = Signal('/ground/command', (
    _levels, link.KIND, Part('decided_by', (), 'BY_*', 'u1'),
    Part('pilot_weight', (), low=0.0, high=1.0), Part('reason', (), 'REASON_*', 'u1')),
    THRUST_COMMAND, f'{CODECS}:Ground')
UPLINK, ARRIVAL = link.uplink(_levels), link.arrival(_levels)
THRUST = link.thrust(_levels, THRUST_COMMAND, f'{CODECS}:Thrusters')
