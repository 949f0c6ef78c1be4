"""
The craft of the docking mission's specification, section 2.5, for tests.
"""

import numpy as np

from rvd_dynamics.world.spacecraft.effectors import cantilever, Tank
from rvd_dynamics.world.spacecraft.spacecraft import Spacecraft

MEAN_MOTION = 8.1478e-4         # [rad/s] 210 km above the Moon
RADIUS = 1947.4e3               # [m]
PANEL = {'mass': 18.0, 'length': 4.0, 'frequency': 2*np.pi*0.25, 'damping': 0.005}


def panels(driven=False, damped=True, **changed):
    """Return two panels along +y and -y."""
    given = {**PANEL, **changed, **({} if damped else {'damping': 0.0})}
    return tuple(cantilever((0.0, 0.9*side, 0.0), (0.0, side, 0.0), (0.0, 0.0, 1.0), chord=1.6,
                            driven=driven, **given) for side in (1.0, -1.0))


def tanks(swings=1, damped=True):
    """Return the tanks of hydrogen and oxygen."""
    axes = ([(0, 1, 0), (0, 0, 1)], [(0, 0, 1), (0, 1, 0)])
    xi = 0.01 if damped else 0.0
    return (Tank((-1.0, 0.0, 0.0), axes[0][:swings], 60.0, 0.25, xi),
            Tank((0.3, 0.0, 0.0), axes[1][:swings], 140.0, 0.35, xi))


def craft(n=MEAN_MOTION, swings=1, driven=False, damped=True, **changed):
    """Return the craft; `changed` replaces properties."""
    given = {'mass': 2000.0, 'inertia': np.diag([2200.0, 3000.0, 2800.0]),
             'target_inertia': np.diag([900.0, 1100.0, 1100.0]),
             'panels': panels(driven, damped), 'tanks': tanks(swings, damped),
             'mean_motion': n, 'orbit_radius': RADIUS}
    return Spacecraft(**{**given, **changed})
