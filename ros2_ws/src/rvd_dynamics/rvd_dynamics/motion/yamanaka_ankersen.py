"""
Linear relative motion about a target on an elliptic orbit: Yamanaka and Ankersen's matrix.

Frame   target orbital: +x along the transverse, +y radially outward, +z opposite to the orbit
        normal.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis, velocity as seen in the rotating frame.
Valid   separation << orbit radius; any eccentricity below 1; thrust held over a step along the
        rotating axes. The error grows with the square of the separation. At e = 0 it is the matrix
        of Clohessy and Wiltshire.
Source  K. Yamanaka, F. Ankersen, J. Guidance, Control, and Dynamics 25(1), 2002, pp. 60-66,
        eq. 71-84, for the axes above: theirs are x, z, -y. With c = 1 + e cos nu and
        k^2 = nu' / c^2, constant along the orbit, positions are scaled by c and velocities
        turned into derivatives by nu; the in-plane solutions are then
        (1, 0), (-cos (c + 1), c sin), (sin (c + 1), c cos), (3 c^2 J, 2 - 3 e c sin J),
        J = k^2 (t - t0).
"""

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.motion.kepler import EllipseParams, Motion

Matrix = NDArray[np.float64]

# Nodes and weights of Gauss and Legendre on 0 .. 1; the error of a step is below rounding.
_NODES = ((0.5 - 0.15**0.5, 5/18), (0.5, 4/9), (0.5 + 0.15**0.5, 5/18))
# Rows of our state in theirs: (x, z) and their rates, then y and its rate.
_IN_PLANE, _OUT = [0, 1, 3, 4], [2, 5]
_SIGNS = np.array([1.0, -1.0, 1.0, -1.0])       # our y is their -z


def transition(orbit: EllipseParams, begin_s: float, end_s: float) -> Matrix:
    """
    Return the matrix (6, 6) that carries a state from `begin_s` to `end_s` without thrust.

    Times count from the start of the orbit's clock [s]; `end_s` may be the earlier one.
    """
    e, begin, end = orbit.eccentricity, orbit.at(begin_s), orbit.at(end_s)
    c = 1.0 + e*cos(begin.anomaly)
    k2 = begin.rate/(c*c)
    passed = k2*(end_s - begin_s)
    matrix = np.zeros((6, 6))
    inner = (_unscaled(e, end, k2) @ _solutions(e, end.anomaly, passed)
             @ _inverse_solutions(e, begin.anomaly) @ _scaled(e, begin, k2))
    matrix[np.ix_(_IN_PLANE, _IN_PLANE)] = _SIGNS[:, None]*inner*_SIGNS
    turn = end.anomaly - begin.anomaly
    swing = np.array([[cos(turn), sin(turn)], [-sin(turn), cos(turn)]])
    matrix[np.ix_(_OUT, _OUT)] = (_unscaled(e, end, k2)[::2, ::2] @ swing
                                  @ _scaled(e, begin, k2)[::2, ::2])
    return matrix


def input_matrix(orbit: EllipseParams, begin_s: float, end_s: float) -> Matrix:
    """Return what an acceleration (3,) held from `begin_s` to `end_s` adds to the state, (6, 3)."""
    span = end_s - begin_s
    return span*sum(weight*transition(orbit, begin_s + node*span, end_s)[:, 3:]
                    for node, weight in _NODES)


def _scaled(e: float, at: Motion, k2: float) -> Matrix:
    """Return what makes (x, z, x', z') by time into scaled ones by nu."""
    c = 1.0 + e*cos(at.anomaly)
    return np.kron([[c, 0.0], [-e*sin(at.anomaly), 1.0/(k2*c)]], np.eye(2))


def _unscaled(e: float, at: Motion, k2: float) -> Matrix:
    """Return the inverse of `_scaled`."""
    c = 1.0 + e*cos(at.anomaly)
    return np.kron([[1.0/c, 0.0], [k2*e*sin(at.anomaly), k2*c]], np.eye(2))


def _solutions(e: float, nu: float, passed: float) -> Matrix:
    """Return four solutions (x, z, dx, dz) as columns, `passed` being J (eq. 83)."""
    rho = 1.0 + e*cos(nu)
    s, c = rho*sin(nu), rho*cos(nu)
    ds, dc = cos(nu) + e*cos(2.0*nu), -(sin(nu) + e*sin(2.0*nu))
    return np.array([
        [1.0, -c*(1.0 + 1.0/rho), s*(1.0 + 1.0/rho), 3.0*rho*rho*passed],
        [0.0, s, c, 2.0 - 3.0*e*s*passed],
        [0.0, 2.0*s, 2.0*c - e, 3.0*(1.0 - 2.0*e*s*passed)],
        [0.0, ds, dc, -3.0*e*(ds*passed + s/(rho*rho))]])


def _inverse_solutions(e: float, nu: float) -> Matrix:
    """Return the inverse of `_solutions` at J = 0 (eq. 82)."""
    rho = 1.0 + e*cos(nu)
    s, c = rho*sin(nu), rho*cos(nu)
    return np.array([
        [1.0 - e*e, 3.0*e*s/rho*(1.0 + 1.0/rho), -e*s*(1.0 + 1.0/rho), 2.0 - e*c],
        [0.0, -3.0*s/rho*(1.0 + e*e/rho), s*(1.0 + 1.0/rho), c - 2.0*e],
        [0.0, -3.0*(c/rho + e), c*(1.0 + 1.0/rho) + e, -s],
        [0.0, 3.0*rho + e*e - 1.0, -rho*rho, e*s]])/(1.0 - e*e)
