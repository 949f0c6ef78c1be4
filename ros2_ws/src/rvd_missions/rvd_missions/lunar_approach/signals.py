"""
Signals of the approach. Frame: target orbital, state (x, y, z, vx, vy, vz).
"""

from rvd_dynamics.commands.codes import KIND_THRUST
from rvd_dynamics.diagram.signal import Part, Signal

CODECS = 'rvd_dynamics.diagram.ros.codecs'
STATE = 'rvd_interfaces/msg/RelativeState'
THRUST_COMMAND = 'rvd_interfaces/msg/ThrustCommand'
FRAME = 'rvd_interfaces/msg/LinkFrame'

_state = Part('state', (6,), 'm, m/s')
_valid = Part('valid', (), '', '?')
_levels = Part('command', (3,), 'levels', 'i1')
_kind = Part('kind', (), 'KIND_*', 'u1', KIND_THRUST)
_covariance = Part('covariance', (6, 6), 'm, m/s', optional=True)

TRUTH = Signal('/truth/relative_state', (
    _state, Part('acceleration', (3,), 'm/s^2'), Part('final', (), '', '?')),
    STATE, f'{CODECS}:Truth', truth=True)
MEASUREMENT = Signal('/onboard/measurement', (_state,), STATE, f'{CODECS}:Measurement')
DOWNLINK = Signal('/onboard/downlink', (
    _state, Part('accepted', (), 'sequence', 'i8', optional=True),
    Part('refusal', (), 'REASON_*', 'u1', optional=True)), FRAME, f'{CODECS}:Downlink')
TELEMETRY = Signal('/ground/telemetry', (
    _state, Part('received', (), '', '?')), FRAME, f'{CODECS}:Telemetry')
ESTIMATE = Signal('/ground/estimate', (_state, _valid, _covariance), STATE, f'{CODECS}:Estimate')
PREDICTION = Signal('/ground/prediction', (_state, _valid, _covariance), STATE,
                    f'{CODECS}:Prediction')
SCORE = Signal('/ground/prediction_score', (
    _valid, Part('error', (6,), 'm, m/s'), Part('sigma', (6,), 'm, m/s'),
    Part('scored', (), '', 'i8'), Part('rms', (6,), 'm, m/s')),
    'rvd_interfaces/msg/PredictionScore', f'{CODECS}:Score')
STICK = Signal('/joy', (
    _levels, _valid, Part('raw', (), 'axes, buttons', 'O', optional=True)),
    'sensor_msgs/msg/Joy', f'{CODECS}:Stick')
AUTO = Signal('/ground/auto_command', (_levels, _valid), THRUST_COMMAND, f'{CODECS}:Automatic')
COMMAND = Signal('/ground/command', (
    _levels, _kind, Part('decided_by', (), 'BY_*', 'u1'), Part('pilot_weight', ()),
    Part('reason', (), 'REASON_*', 'u1')), THRUST_COMMAND, f'{CODECS}:Ground')
UPLINK = Signal('/ground/uplink', (_levels, _kind, Part('expedited', (), '', '?')), FRAME,
                f'{CODECS}:Uplink')
ARRIVAL = Signal('/onboard/command', (
    _levels, _kind, Part('received', (), '', '?'),
    Part('reason', (), 'REASON_*', 'u1', optional=True),
    Part('sequence', (), '', 'i8', optional=True)), FRAME, f'{CODECS}:Arrival')
THRUST = Signal('/onboard/thruster_command', (
    _levels, Part('kind', (), 'KIND_*', 'u1', optional=True),
    Part('valid', (), '', '?', optional=True),
    Part('reason', (), 'REASON_*', 'u1', optional=True),
    Part('sequence', (), '', 'i8', optional=True),
    Part('decided_by', (), 'BY_*', 'u1', optional=True)), THRUST_COMMAND, f'{CODECS}:Thrusters')
STATUS = {leg: Signal(f'/link/{leg}/status', (), 'rvd_interfaces/msg/LinkStatus', '')
          for leg in ('forward', 'back')}
