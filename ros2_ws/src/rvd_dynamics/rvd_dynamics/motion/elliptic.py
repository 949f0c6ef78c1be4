"""
Relative motion of two bodies in a central field, the target on an ellipse: exact.

Frame   target orbital: +x along the transverse, +y radially outward, +z opposite to the orbit
        normal.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis, velocity as seen in the rotating frame;
        leading axes are batch axes.
Valid   any separation; point-mass body; thrust held over a step along the rotating axes.
Source  Newton's law in the frame that turns at w = nu', w' = nu'' (`kepler`), R the chaser's
        radius, r the target's:
        x'' = -2 w y' - w' y + w^2 x - mu x / R^3 + ux
        y'' =  2 w x' + w' x + w^2 y - mu (r + y) / R^3 + mu / r^2 + uy
        z'' = -mu z / R^3 + uz
        The difference of the two large terms is taken in Battin's form, which keeps all its
        digits: -mu (r + y) / R^3 + mu / r^2 = -(mu / R^3)(y - r g),
        g = q (3 + 3q + q^2) / (1 + (1 + q)^1.5), q = (2 r y + x^2 + y^2 + z^2) / r^2
        (R. H. Battin, An Introduction to the Mathematics and Methods of Astrodynamics, 1999,
        section 8.4).

One classical Runge-Kutta step per call. The shortest time scale is 1 / nu' at perigee, some 800 s
in a low orbit: with steps of 2 s the truncation of a step is below 1e-14 of the separation.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.motion.kepler import EllipseParams, Motion

Components = tuple                      # (x, y, z, vx, vy, vz), each (...)


def step(state: ArrayLike, accel: ArrayLike, orbit: EllipseParams, time_s: float,
         dt: float) -> NDArray[np.float64]:
    """
    Return the state (..., 6) after `dt` [s] under `accel` (..., 3) [m/s^2].

    `time_s` is the beginning of the step, counted from the start of the orbit's clock. NaN stays
    NaN.
    """
    state = np.asarray(state, dtype=float)
    accel = np.asarray(accel, dtype=float)
    s = tuple(state[..., i] for i in range(6))
    u = tuple(accel[..., i] for i in range(3))
    mu, half = orbit.gravitational_parameter_m3_s2, dt/2
    begin, middle, end = (orbit.at(time_s + t) for t in (0.0, half, dt))
    k1 = _rate(s, u, begin, mu)
    k2 = _rate([a + half*b for a, b in zip(s, k1)], u, middle, mu)
    k3 = _rate([a + half*b for a, b in zip(s, k2)], u, middle, mu)
    k4 = _rate([a + dt*b for a, b in zip(s, k3)], u, end, mu)
    sixth = dt/6
    return np.moveaxis(np.stack([a + sixth*(b + 2.0*(c + d) + e)
                                 for a, b, c, d, e in zip(s, k1, k2, k3, k4)]), 0, -1)


def _rate(s: Components, u: tuple, target: Motion, mu: float) -> Components:
    """Return the time derivative of the state components `s` under thrust `u`."""
    x, y, z, vx, vy, vz = s
    r, w, turn = target.radius, target.rate, target.acceleration
    q = (2.0*r*y + x*x + y*y + z*z)/(r*r)
    cube = (1.0 + q)*np.sqrt(1.0 + q)                           # (R / r)^3
    g = q*(3.0 + q*(3.0 + q))/(1.0 + cube)
    pull = mu/(r*r*r)/cube                                      # mu / R^3
    return (vx, vy, vz,
            -2.0*w*vy - turn*y + w*w*x - pull*x + u[0],
            2.0*w*vx + turn*x + w*w*y - pull*(y - r*g) + u[1],
            -pull*z + u[2])
