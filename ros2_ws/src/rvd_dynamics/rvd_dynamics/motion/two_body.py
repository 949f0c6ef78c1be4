"""
Relative motion of two bodies in the central field of the Moon, the target on a circle.

Frame   target orbital: +x along track, +y radially outward, +z opposite to orbit normal.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Valid   any separation; point-mass Moon, circular target orbit; thrust held over a step along
        the rotating axes.
Source  Newton's law in the rotating frame, r^2 = x^2 + (a + y)^2 + z^2, n^2 = mu / a^3:
        x'' = -2n y' + n^2 x - mu x / r^3 + ux
        y'' =  2n x' + n^2 (a + y) - mu (a + y) / r^3 + uy
        z'' = -mu z / r^3 + uz
        The difference of the two large terms is taken in Encke's form: with
        q = (2 a y + x^2 + y^2 + z^2) / a^2, 1 - (a / r)^3 keeps all its digits
        (R. H. Battin, Astronautical Guidance, 1964).

One classical Runge-Kutta step per mission step. The motion has no time scale shorter than
1/n = 1200 s, so for steps of up to 1 s the truncation error is below rounding.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Components = tuple                      # (x, y, z, vx, vy, vz), each (...)


def step(state: ArrayLike, accel: ArrayLike, n: float, radius: float,
         dt: float) -> NDArray[np.float64]:
    """
    Return the state (..., 6) after `dt` [s] under `accel` (..., 3) [m/s^2].

    `n` [rad/s] is the orbital rate and `radius` [m] the orbit radius of the target. NaN
    stays NaN.
    """
    state = np.asarray(state, dtype=float)
    accel = np.asarray(accel, dtype=float)
    s = tuple(state[..., i] for i in range(6))
    u = tuple(accel[..., i] for i in range(3))
    half = dt / 2
    k1 = _rate(s, u, n, radius)
    k2 = _rate([a + half*b for a, b in zip(s, k1)], u, n, radius)
    k3 = _rate([a + half*b for a, b in zip(s, k2)], u, n, radius)
    k4 = _rate([a + dt*b for a, b in zip(s, k3)], u, n, radius)
    sixth = dt / 6
    return np.moveaxis(np.stack([a + sixth*(b + 2.0*(c + d) + e)
                                 for a, b, c, d, e in zip(s, k1, k2, k3, k4)]), 0, -1)


def _rate(s: Components, u: tuple, n: float, radius: float) -> Components:
    """Return the time derivative of the state components `s` under thrust `u`."""
    x, y, z, vx, vy, vz = s
    ux, uy, uz = u
    q = (2.0*radius*y + x*x + y*y + z*z) / (radius*radius)
    cube = (1.0 + q)*np.sqrt(1.0 + q)                           # (r / a)^3
    # n^2 (1 - (a / r)^3): centrifugal minus gravitational acceleration, per metre
    f = n*n*(q*(3.0 + q*(3.0 + q)) / (1.0 + cube) / cube)
    return (vx, vy, vz,
            f*x - 2.0*n*vy + ux,
            f*(radius + y) + 2.0*n*vx + uy,
            (f - n*n)*z + uz)
