"""
Signals of a craft that is flown by hand: the controllers, what goes up, what comes down.
"""

from rvd_dynamics.commands.hand import PERCENT
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

CODECS = 'rvd_dynamics.diagram.ros.hand_codecs'
JOY = 'sensor_msgs/msg/Joy'

_hold = (Part('deflection', (3,), '%', 'i1', low=-PERCENT, high=PERCENT),
         Part('switched', (), '', '?'), Part('resume', (), '', '?'), Part('valid', (), '', '?'))
_command = Part('command', (7,), '%, flags', 'i1', low=-PERCENT, high=PERCENT)
_pose = (Part('position', (3,), 'm'), Part('velocity', (3,), 'm/s'), Part('attitude', (4,)),
         Part('rate', (3,), 'rad/s'))

TRANSLATION = Signal('/joy/translation', _hold, JOY, f'{CODECS}:Controller')
ROTATION = Signal('/joy/rotation', _hold, JOY, f'{CODECS}:Controller')
STEERING = Signal('/onboard/steering', (        # what the craft makes of the hands
    Part('reference', (3,), 'm'), Part('attitude', (4,)), _command))

# Over the link. Down: position, velocity, attitude, rate, then place and attitude that are held,
# then the safety state; `state_of` takes it apart.
DOWN = 21
_down = Part('state', (DOWN,), 'm, m/s, rad/s')
DOWNLINK, TELEMETRY = link.downlink(_down), link.telemetry(_down)
COMMAND = Signal('/ground/command', (_command, link.KIND))
UPLINK = Signal('/ground/uplink', (_command, link.KIND, Part('expedited', (), '', '?')),
                link.FRAME, f'{CODECS}:HandUplink')
ARRIVAL = Signal('/onboard/hand', (
    _command, link.KIND, link.RECEIVED, Part('reason', (), 'REASON_*', 'u1', optional=True),
    link.SEQUENCE), link.FRAME, f'{CODECS}:HandArrival')

# What the ground knows: the craft as it was, and as it will be when a command sent now acts.
ESTIMATE = Signal('/ground/estimate', (
    *_pose, Part('safety', (), 'STATE_*', 'u1', high=3), Part('valid', (), '', '?')))
PREDICTION = Signal('/ground/prediction', (*_pose, Part('valid', (), '', '?')))
