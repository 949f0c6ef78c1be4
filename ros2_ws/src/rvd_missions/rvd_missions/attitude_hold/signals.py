"""
Signals of the mission. State (angle, rate) [rad, rad/s] about the axis.
"""

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

_state = Part('state', (2,), 'rad, rad/s')
_command = Part('command', (1,), 'N m', initial=0.0)        # no torque

TRUTH = Signal('/truth/attitude', (
    _state, Part('torque', (1,), 'N m'), Part('final', (), '', '?')), truth=True)
MEASUREMENT = Signal('/onboard/attitude', (
    _state, Part('sensors', (3,), 'rad')))                  # horizon, sun, increment of the gyro
DOWNLINK, TELEMETRY = link.downlink(_state), link.telemetry(_state)
# What the law decides by: its errors, and what it believes or remembers. Unused numbers are NaN.
LAW = Signal('/attitude/law', (
    Part('error', (), 'rad'), Part('reference', (), 'rad'), Part('inside', (3,))))
COMMAND = Signal('/ground/command', (_command, link.KIND))
WANTED = Signal('/onboard/command', (                       # of a law on board
    _command, link.KIND, link.RECEIVED, Part('reason', (), 'REASON_*', 'u1', optional=True),
    link.SEQUENCE))
UPLINK, ARRIVAL = link.uplink(_command), link.arrival(_command)
THRUST = link.thrust(_command)
