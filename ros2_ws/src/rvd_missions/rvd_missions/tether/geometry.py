"""
Geometry of platform, gripper and target: lengths and angles, frames, attitude.

Frames  I of `settings`. Tether t: x_t from the platform to the gripper, at (alpha1, beta1); sight
        v: x_v from the gripper to the target, at (alpha0, beta0); alpha in the orbit plane from +x
        to +y, beta out of it, x_v = (cos b cos a, cos b sin a, sin b). Body: x_b boresight.
Euler   3-2-1 (yaw psi, pitch theta, roll phi), given as (phi, theta, psi); quaternions
        (x, y, z, w) turn body vectors into I.
Source  Hu et al. (docs/missions/tether.md); the closure D = l1 x_t + l0 x_v is derived.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_missions.tether.settings import ApproachParams, OrbitParams


class Baseline(NamedTuple):
    """Platform to target at one instant, in I."""

    place: NDArray                      # (3,) [m]
    rate: NDArray                       # (3,) [m/s]


def baseline(orbit: OrbitParams, length_m: ArrayLike, time_s: float) -> Baseline:
    """
    Return the vector from platform to target, (..., 3), at a time, for lengths (...) at the start.

    Platform and target are on one orbit but for a turn of it in its plane, which is a solution of
    the linearised motion on any ellipse: the baseline stays normal to the radius and in proportion
    to it. On a circle this is the V-bar.
    """
    start, now = orbit.at(0.0), orbit.at(time_s)
    turn = now.anomaly - start.anomaly
    c, s, size = np.cos(turn), np.sin(turn), now.radius/start.radius
    # r' = r nu' e sin nu / (1 + e cos nu)
    e, nu = orbit.eccentricity, now.anomaly
    growth = now.rate*e*np.sin(nu)/(1.0 + e*np.cos(nu))
    length = np.asarray(length_m, dtype=float)[..., np.newaxis]*size
    along, across = np.array([c, s, 0.0]), np.array([-s, c, 0.0])
    return Baseline(length*along, length*(growth*along + now.rate*across))


class Sight(NamedTuple):
    """Lengths [m] and angles [rad] of one line, each (...)."""

    length: NDArray
    alpha: NDArray
    beta: NDArray


def line(vector: ArrayLike) -> Sight:
    """Return length and angles of vectors (..., 3)."""
    v = np.asarray(vector, dtype=float)
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    flat = np.sqrt(x*x + y*y)
    return Sight(np.sqrt(x*x + y*y + z*z), np.arctan2(y, x), np.arctan2(z, flat))


def quaternion(euler: ArrayLike) -> NDArray[np.float64]:
    """Return the quaternion (..., 4) of Euler angles (..., 3)."""
    half = 0.5*np.asarray(euler, dtype=float)
    (cr, cp, cy), (sr, sp, sy) = (np.moveaxis(f(half), -1, 0) for f in (np.cos, np.sin))
    return np.stack([sr*cp*cy - cr*sp*sy, cr*sp*cy + sr*cp*sy,
                     cr*cp*sy - sr*sp*cy, cr*cp*cy + sr*sp*sy], axis=-1)


def euler(q: ArrayLike) -> NDArray[np.float64]:
    """Return the Euler angles (..., 3) of quaternions (..., 4)."""
    x, y, z, w = np.moveaxis(np.asarray(q, dtype=float), -1, 0)
    return np.stack([np.arctan2(2.0*(w*x + y*z), 1.0 - 2.0*(x*x + y*y)),
                     np.arcsin(np.clip(2.0*(w*y - x*z), -1.0, 1.0)),
                     np.arctan2(2.0*(w*z + x*y), 1.0 - 2.0*(y*y + z*z))], axis=-1)


def boresight(q: ArrayLike) -> NDArray[np.float64]:
    """Return the boresight (..., 3) in I of quaternions (..., 4)."""
    x, y, z, w = np.moveaxis(np.asarray(q, dtype=float), -1, 0)
    return np.stack([1.0 - 2.0*(y*y + z*z), 2.0*(x*y + z*w), 2.0*(x*z - y*w)], axis=-1)


def sight_angle(q: ArrayLike, towards: ArrayLike) -> NDArray[np.float64]:
    """Return the angle (...) between boresight and vectors (..., 3) to the target [rad]."""
    b, v = boresight(q), np.asarray(towards, dtype=float)
    cross = np.stack([b[..., 1]*v[..., 2] - b[..., 2]*v[..., 1],
                      b[..., 2]*v[..., 0] - b[..., 0]*v[..., 2],
                      b[..., 0]*v[..., 1] - b[..., 1]*v[..., 0]], axis=-1)
    size = np.sqrt(cross[..., 0]**2 + cross[..., 1]**2 + cross[..., 2]**2)
    return np.arctan2(size, b[..., 0]*v[..., 0] + b[..., 1]*v[..., 1] + b[..., 2]*v[..., 2])


def goal(orbit: OrbitParams, approach: ApproachParams, time_s: float) -> NDArray[np.float64]:
    """Return the planned end (12,) at a time: at rest before the target, on its V-bar at t = 0."""
    place, rate = baseline(orbit, approach.baseline_m, time_s)
    return np.array([*(place - [approach.final_range_m, 0.0, 0.0]), *rate, *np.zeros(6)])


def product(p: ArrayLike, q: ArrayLike) -> NDArray[np.float64]:
    """Return the quaternion (..., 4) that turns by q first, then by p."""
    px, py, pz, pw = np.moveaxis(np.asarray(p, dtype=float), -1, 0)
    qx, qy, qz, qw = np.moveaxis(np.asarray(q, dtype=float), -1, 0)
    return np.stack([pw*qx + px*qw + py*qz - pz*qy, pw*qy - px*qz + py*qw + pz*qx,
                     pw*qz + px*qy - py*qx + pz*qw, pw*qw - px*qx - py*qy - pz*qz], axis=-1)


def to_inertial(q: ArrayLike, vector: ArrayLike) -> NDArray[np.float64]:
    """Return body vectors (..., 3) in I, for quaternions (..., 4)."""
    return _turned(q, vector, 1.0)


def to_body(q: ArrayLike, vector: ArrayLike) -> NDArray[np.float64]:
    """Return vectors (..., 3) of I in the body, for quaternions (..., 4)."""
    return _turned(q, vector, -1.0)


def _turned(q: ArrayLike, vector: ArrayLike, sense: float) -> NDArray[np.float64]:
    """Return v + 2 w (u x v) + 2 u x (u x v), u the quaternion's vector times `sense`."""
    x, y, z, w = np.moveaxis(np.asarray(q, dtype=float), -1, 0)
    x, y, z = sense*x, sense*y, sense*z
    a, b, c = np.moveaxis(np.asarray(vector, dtype=float), -1, 0)
    i, j, k = 2.0*(y*c - z*b), 2.0*(z*a - x*c), 2.0*(x*b - y*a)
    return np.stack([a + w*i + y*k - z*j, b + w*j + z*i - x*k, c + w*k + x*j - y*i], axis=-1)
