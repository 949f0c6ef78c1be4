"""What the tests of the tethered robot share: orbits, craft, and the compiled plant's inputs."""

import numpy as np

from rvd_missions.tether import geometry
from rvd_missions.tether.settings import (
    ApproachParams, GripperParams, OrbitParams, TetherParams)

GEO = OrbitParams()
LEO = OrbitParams(perigee_altitude_m=6878e3 - GEO.body_radius_m)
ELLIPSE = OrbitParams(eccentricity=0.3, perigee_altitude_m=500e3, start_anomaly_deg=40.0)
ORBITS = {'geo': GEO, 'leo': LEO, 'ellipse': ELLIPSE}
GRIPPER, TETHER, APPROACH = GripperParams(), TetherParams(), ApproachParams()
CRAFT = np.array([GRIPPER.mass_kg, *GRIPPER.inertia_kg_m2, GRIPPER.attachment_m, 0.0, 0.0, 0.0])


def orbit_at(orbit, t):
    """Return mu / r^3 and the sine and cosine of the turn since the start."""
    now = orbit.at(t)
    turn = now.anomaly - orbit.at(0.0).anomaly
    return np.array([orbit.gravitational_parameter_m3_s2/now.radius**3, np.sin(turn), np.cos(turn)])


def over_step(orbit, t, h):
    """Return what the compiled plant needs of the orbit."""
    return np.array([orbit_at(orbit, t + part) for part in (0.0, 0.5*h, h)])


def plant_start(approach=APPROACH, orbit=GEO):
    """Return the planned start with a quaternion, (1, 13)."""
    x = approach.initial(orbit.at(0.0).rate)
    return np.concatenate([x[:6], geometry.quaternion(x[6:9]), x[9:]])[np.newaxis]
