"""
Signals of the mission. State: r, v of the gripper from the platform, in the inertial frame of the
start (`settings`); quaternion (x, y, z, w) of the body; body rates.
"""

import numpy as np

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link
from rvd_missions.tether.settings import TetherParams

# Before a command has come the reel keeps the tether taut; `form` has the scenario's tension.
NEUTRAL = np.array([TetherParams.least_n, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])

_state = Part('state', (13,), 'm, m/s, 1, rad/s')
_command = Part('command', (7,), 'N, N m', initial=NEUTRAL)

TRUTH = Signal('/truth/gripper', (
    _state,
    Part('target', (3,), 'm'),                  # from the gripper
    Part('applied', (7,), 'N, N m'),            # in the step before
    Part('tension', (), 'N'),                   # of the tether now
    Part('unstretched', (), 'm'),               # length that is paid out
    Part('final', (), '', '?')), truth=True)
MEASUREMENT = Signal('/onboard/measurement', (
    Part('encoder', (), 'm'),                   # length that the reel has paid out
    Part('bearing', (3,)),                      # unit vector to the target, in the body
    Part('attitude', (4,)),                     # quaternion
    Part('in_view', (), '', '?')))
# What the tracker follows: planned and measured (ls, alpha0, beta0, roll, pitch, yaw).
TRACKING = Signal('/onboard/tracking', (
    Part('planned', (6,), 'm, rad'), Part('measured', (6,), 'm, rad'),
    Part('feedforward', (7,), 'N, N m'), Part('range', (), 'm')))
# What comes down: measured (6), planned (6), planned range, tension that is asked for.
DOWNLINK, TELEMETRY = (make(Part('state', (14,), 'm, rad, N')) for make in (
    link.downlink, link.telemetry))
# What the ground makes of it, in the inertial frame of the start, from the platform. The range is
# the planned one: nothing measures it.
SITUATION = Signal('/ground/situation', (
    Part('gripper', (3,), 'm'), Part('planned', (3,), 'm'), Part('target', (3,), 'm'),
    Part('attitude', (4,)), Part('error', (6,), 'm, rad'), Part('range', (), 'm'),
    Part('sight_angle', (), 'rad'), Part('tension', (), 'N')))
COMMAND = Signal('/ground/command', (_command, link.KIND))
UPLINK, ARRIVAL = link.uplink(_command), link.arrival(_command)
WANTED = Signal('/onboard/wanted', (                        # by the tracker, for the guard
    _command, link.KIND, link.RECEIVED, Part('reason', (), 'REASON_*', 'u1', optional=True),
    link.SEQUENCE))
THRUST = link.thrust(_command)
