"""
Signals of the mission. LVLH axes but where it says otherwise; quaternions (x, y, z, w).
"""

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link
from rvd_missions.docking.commands import COUNT
from rvd_missions.docking.markers import BIG, SMALL

MARKERS = len(BIG) + len(SMALL)
STATIONS = (0.25, 0.5, 0.75, 1.0)        # along a panel, from its root, as a fraction of its length

TRUTH = Signal('/truth/spacecraft', (
    Part('position', (3,), 'm'), Part('velocity', (3,), 'm/s'),
    Part('target_attitude', (4,)), Part('target_rate', (3,), 'rad/s'),
    Part('attitude', (4,)), Part('rate', (3,), 'rad/s'),                    # body axes
    Part('turned', (3,), 'rad'), Part('gained', (3,), 'm/s'),               # over the step, body
    Part('felt', (3,), 'm/s^2'),                                            # body axes
    Part('thrust', (COUNT,), '1'), Part('pulses', (), '', 'i8'),
    Part('propellant', (), 'kg'), Part('final', (), '', '?'),
    Part('bending', (2, len(STATIONS)), 'm'),           # of each panel along its normal, STATIONS
    Part('sloshing', (2, 3), 'm')), truth=True)         # of each tank's liquid, body axes
INERTIAL = Signal('/onboard/inertial', (
    Part('rate', (3,), 'rad/s'), Part('force', (3,), 'm/s^2')))             # body axes
EXPOSED = Part('exposed', (), 'steps', 'i8', -1, counts=True)    # step of the picture; < 0: none yet
FEATURES = Signal('/onboard/features', (
    Part('pixels', (MARKERS, 2), 'px'), EXPOSED))
POSE = Signal('/onboard/pose', (                                            # craft axes
    Part('place', (3,), 'm'), Part('turn', (4,)), Part('covariance', (6, 6), spread=True),
    Part('usable', (), '', 'i8', low=0, high=MARKERS), EXPOSED,
    # that count: 0 big, 1 both, 2 small; -1 none do
    Part('markers', (), 'SET_*', 'i8', -1, codes=(-1, 0, 1, 2))))
ESTIMATE = Signal('/onboard/estimate', (                                    # target axes
    Part('position', (3,), 'm'), Part('velocity', (3,), 'm/s'), Part('attitude', (4,)),
    Part('rate', (3,), 'rad/s'), Part('nis', (2,)),
    Part('sigma', (9,), 'm, m, m, m/s, m/s, m/s, rad, rad, rad')))         # attitude: craft axes
GUIDANCE = Signal('/onboard/guidance', (
    Part('reference', (3,), 'm'), Part('error', (6,), 'm, rad'), Part('demand', (6,)),
    Part('safety', (), 'STATE_*', 'u1', high=3)))
_command = Part('command', (COUNT,), '', 'u1', initial=0, high=1)           # all valves shut
WANTED = Signal('/onboard/command', (
    _command, link.KIND, link.RECEIVED, Part('reason', (), 'REASON_*', 'u1', optional=True),
    link.SEQUENCE))
THRUST = link.thrust(_command)
