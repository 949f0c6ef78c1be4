"""
Target orbital frame and Moon-centred inertial frame, and the way between them.

Inertial `_i`   origin Moon; X in the lunar equator towards the J2000 equinox, Z along the
                normal of the lunar equator.
Target `_t`     origin target; x along its velocity, y radially outward, z = x cross y, which
                is minus the orbit normal. It turns with the orbit, at (0, 0, -n) on its own axes.
State           position and velocity [m, m/s] on the last axis; in `_t` of the chaser relative
                to the target as seen in the turning frame, in `_i` of a body relative to the
                Moon. Leading axes are batch axes.
Valid           circular target orbit about a point-mass Moon.
Source          Zhang, Li, Tang 2014, section 1.2 and Table 1.
"""

from math import cos, radians, sin

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.diagram.params import param, settings


@settings
class PlaneParams:
    """Orientation of the target orbit and place of the target at the epoch (Table 1)."""

    epoch_utc: str = param('2025-01-01T00:00:00', 'Epoch, at which t = 0, in UTC.')
    inclination_deg: float = param(
        45.0, 'Inclination of the target orbit to the lunar equator [deg].')
    ascending_node_deg: float = param(25.0, 'Right ascension of the ascending node [deg].')
    argument_of_latitude_deg: float = param(
        0.0, 'Argument of latitude of the target at the epoch [deg].')


def rotation(t: ArrayLike, orbit: OrbitParams,
             plane: PlaneParams = PlaneParams()) -> NDArray[np.float64]:
    """
    Return R_it (..., 3, 3) at `t` (...) [s] since the epoch: vec_i = R_it @ vec_t.

    Its columns are the axes of the target frame, written in the inertial frame.
    """
    u = radians(plane.argument_of_latitude_deg) + orbit.mean_motion*np.asarray(t, dtype=float)
    i, node = radians(plane.inclination_deg), radians(plane.ascending_node_deg)
    # unit vectors of the orbit plane: to the ascending node, and a quarter orbit further
    p = np.array([cos(node), sin(node), 0.0])
    q = np.array([-cos(i)*sin(node), cos(i)*cos(node), sin(i)])
    c, s = np.cos(u)[..., np.newaxis], np.sin(u)[..., np.newaxis]
    outward, along = c*p + s*q, c*q - s*p
    minus_normal = np.broadcast_to(np.cross(q, p), outward.shape)
    return np.stack([along, outward, minus_normal], axis=-1)


def target_state(t: ArrayLike, orbit: OrbitParams,
                 plane: PlaneParams = PlaneParams()) -> NDArray[np.float64]:
    """Return the inertial state (..., 6) of the target at `t` (...) [s] since the epoch."""
    r_it = rotation(t, orbit, plane)
    speed = orbit.mean_motion*orbit.radius_m
    return np.concatenate([orbit.radius_m*r_it[..., 1], speed*r_it[..., 0]], axis=-1)


def to_inertial(state_t: ArrayLike, t: ArrayLike, orbit: OrbitParams,
                plane: PlaneParams = PlaneParams()) -> NDArray[np.float64]:
    """Return the inertial state (..., 6) of a chaser with relative state `state_t` (..., 6)."""
    x, y, z, vx, vy, vz = np.moveaxis(np.asarray(state_t, dtype=float), -1, 0)
    n = orbit.mean_motion
    r_it = rotation(t, orbit, plane)
    place = _turn(r_it, np.stack([x, y, z], axis=-1))
    motion = _turn(r_it, np.stack([vx + n*y, vy - n*x, vz], axis=-1))    # v + omega x r
    return target_state(t, orbit, plane) + np.concatenate([place, motion], axis=-1)


def to_target(state_i: ArrayLike, t: ArrayLike, orbit: OrbitParams,
              plane: PlaneParams = PlaneParams()) -> NDArray[np.float64]:
    """
    Return the relative state (..., 6) of a chaser with inertial state `state_i` (..., 6).

    Two positions of 2e6 m are subtracted: expect errors of some 1e-9 m and 1e-12 m/s.
    """
    away = np.asarray(state_i, dtype=float) - target_state(t, orbit, plane)
    r_ti = np.swapaxes(rotation(t, orbit, plane), -1, -2)
    x, y, z = np.moveaxis(_turn(r_ti, away[..., :3]), -1, 0)
    vx, vy, vz = np.moveaxis(_turn(r_ti, away[..., 3:]), -1, 0)
    n = orbit.mean_motion
    return np.stack([x, y, z, vx - n*y, vy + n*x, vz], axis=-1)


def _turn(matrix: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.einsum('...ij,...j->...i', matrix, vector)
