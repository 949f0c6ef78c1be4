"""
The thrusters of the chaser: four groups, of which the paper names the tasks and no numbers [A].

J1  orbit transfer      one of 490 N along +x
J2  translation         two for each signed axis, 20 N each, whose torques cancel
J3  attitude            two for each signed axis, 10 N each, as couples
J4  emergency, backup   four of 60 N along -x; four couples of 10 N whose torques point to the
                        corners of a tetrahedron: with 8 thrusters they turn the craft any way
                        without pushing it, which 8 of the 12 of J3, mirrored, would not
"""

import numpy as np

from rvd_dynamics.commands.thruster_set import joined, ThrusterSet

ARM = 0.8                               # [m]
X, Y, Z = np.eye(3)


def layout() -> ThrusterSet:
    """Return the thrusters of all groups, 37 of them."""
    return joined(
        _group('J1', 490.0, [((-1.5, 0.0, 0.0), X)]),
        _group('J2', 20.0, [(side*ARM*arm, sign*push) for arm, push in ((Y, X), (Z, Y), (X, Z))
                            for sign in (1.0, -1.0) for side in (1.0, -1.0)]),
        _group('J3', 10.0, [(side*ARM*arm, side*sign*push)
                            for arm, push in ((Y, Z), (Z, X), (X, Y))
                            for sign in (1.0, -1.0) for side in (1.0, -1.0)]),
        _group('J4', 60.0, [((1.2, y, z), -X) for y in (ARM, -ARM) for z in (ARM, -ARM)]),
        _group('J4', 10.0, [(side*ARM*arm, side*np.cross(torque, arm))
                            for torque, arm in _corners() for side in (1.0, -1.0)]))


def _group(name: str, force: float, where: list) -> ThrusterSet:
    places, directions = zip(*where)
    return ThrusterSet(np.array(places), np.array(directions), np.full(len(where), force),
                       (name,)*len(where))


def _corners() -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the four directions of a tetrahedron, each with a unit vector at right angles."""
    found = []
    for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        torque = np.array(signs)/np.sqrt(3.0)
        found.append((torque, np.array([signs[0], -signs[1], 0])/np.sqrt(2.0)))
    return found
