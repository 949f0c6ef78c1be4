"""
Signals of the mission. State (x, v) [m, m/s]: the berth is at x = 0, the craft starts at x < 0.
"""

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link

_state = Part('state', (2,), 'm, m/s')
_command = Part('command', (1,), 'm/s^2', initial=0.0)      # no thrust

TRUTH = Signal('/truth/state', (
    _state, Part('acceleration', (1,), 'm/s^2'), Part('final', (), '', '?')), truth=True)
DOWNLINK, TELEMETRY = link.downlink(_state), link.telemetry(_state)
COMMAND = Signal('/ground/command', (_command, link.KIND))
UPLINK, ARRIVAL = link.uplink(_command), link.arrival(_command)
THRUST = link.thrust(_command)
