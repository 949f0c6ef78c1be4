"""
Attitude by unit quaternions.

Quaternion  (x, y, z, w) on the last axis, as in ROS and scipy; leading axes are batch axes. The
            quaternion of a body turns its axes into vectors of the reference: v_ref = R(q) v_body.
            With w the angular velocity relative to the reference, in body axes [rad/s]:
            q' = 1/2 q (x) (w, 0).
Paper       An, Qu, Wang 2015 write q1 for our w and q24 for our (x, y, z); their C(q) is R(q)^T.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
SMALL = 1e-4                            # [rad] below which sin(a)/a is a series, exact to 1e-16


def multiply(p: ArrayLike, q: ArrayLike) -> Array:
    """Return the quaternion product p (x) q, (..., 4): R(p (x) q) = R(p) R(q)."""
    a, b, c, d = _parts(p)
    x, y, z, w = _parts(q)
    return _together(d*x + a*w + b*z - c*y, d*y + b*w + c*x - a*z,
                     d*z + c*w + a*y - b*x, d*w - a*x - b*y - c*z)


def conjugate(q: ArrayLike) -> Array:
    """Return the quaternion (..., 4) of the opposite turn."""
    return np.asarray(q, dtype=float)*np.array([-1.0, -1.0, -1.0, 1.0])


def normalised(q: ArrayLike) -> Array:
    """Return quaternions (..., 4) scaled to unit length."""
    q = np.asarray(q, dtype=float)
    return q/np.sqrt(_dot(q, q))[..., np.newaxis]


def matrix(q: ArrayLike) -> Array:
    """Return R (..., 3, 3): v_ref = R v_body; its columns are the body's axes."""
    x, y, z, w = _parts(q)
    rows = [[1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y)],
            [2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x)],
            [2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)]]
    return _together(*(number for row in rows for number in row)).reshape((*x.shape, 3, 3))


def rotate(q: ArrayLike, vector: ArrayLike) -> Array:
    """Return vectors (..., 3) of the body in the reference."""
    x, y, z, w = _parts(q)
    a, b, c = _parts(vector)
    t, u, v = 2.0*(y*c - z*b), 2.0*(z*a - x*c), 2.0*(x*b - y*a)
    return _together(a + w*t + (y*v - z*u), b + w*u + (z*t - x*v), c + w*v + (x*u - y*t))


def rotate_back(q: ArrayLike, vector: ArrayLike) -> Array:
    """Return vectors (..., 3) of the reference in the body."""
    return rotate(conjugate(q), vector)


def from_rotation_vector(vector: ArrayLike) -> Array:
    """Return the quaternion (..., 4) of a turn about `vector` (..., 3) by its length [rad]."""
    v = np.asarray(vector, dtype=float)
    angle = np.sqrt(_dot(v, v))
    near = angle < SMALL
    ratio = np.where(near, 0.5 - angle*angle/48.0,
                     np.sin(0.5*angle)/np.where(near, 1.0, angle))
    return np.concatenate([ratio[..., np.newaxis]*v, np.cos(0.5*angle)[..., np.newaxis]], axis=-1)


def rotation_vector(q: ArrayLike) -> Array:
    """Return the axis times the angle (..., 3) [rad], the angle at most pi."""
    q = np.asarray(q, dtype=float)
    q = np.where(q[..., 3:] < 0.0, -q, q)
    s = np.sqrt(_dot(q[..., :3], q[..., :3]))
    near = s < SMALL
    angle = 2.0*np.arctan2(s, q[..., 3])
    ratio = np.where(near, 2.0 + s*s/3.0, angle/np.where(near, 1.0, s))
    return ratio[..., np.newaxis]*q[..., :3]


def from_euler(angles: ArrayLike) -> Array:
    """Return the quaternion (..., 4) of roll, pitch, yaw (..., 3) [rad]: R = Rz Ry Rx."""
    half = 0.5*np.asarray(angles, dtype=float)
    (sr, sp, sy), (cr, cp, cy) = (_parts(f(half)) for f in (np.sin, np.cos))
    return _together(sr*cp*cy - cr*sp*sy, cr*sp*cy + sr*cp*sy,
                     cr*cp*sy - sr*sp*cy, cr*cp*cy + sr*sp*sy)


def euler(q: ArrayLike) -> Array:
    """Return roll, pitch, yaw (..., 3) [rad] of `from_euler`, the pitch within +-90 degrees."""
    x, y, z, w = _parts(q)
    pitch = np.clip(2*(w*y - x*z), -1.0, 1.0)
    return np.stack([np.arctan2(2*(w*x + y*z), 1 - 2*(x*x + y*y)), np.arcsin(pitch),
                     np.arctan2(2*(w*z + x*y), 1 - 2*(y*y + z*z))], axis=-1)


def _dot(a: Array, b: Array) -> Array:
    """Return the scalar products of the last axis, summed in a fixed order."""
    products = a*b
    total = products[..., 0]
    for i in range(1, products.shape[-1]):
        total = total + products[..., i]
    return total


def _parts(value: ArrayLike) -> list[Array]:
    """Return the components of the last axis: a view each, many times cheaper than moveaxis."""
    value = np.asarray(value, dtype=float)
    return [value[..., i] for i in range(value.shape[-1])]


def _together(*parts: Array) -> Array:
    """Return components (...) as one array (..., n); a tenth of the calls of `np.stack`."""
    made = np.empty((*np.shape(parts[0]), len(parts)))
    for i, part in enumerate(parts):
        made[..., i] = part
    return made
