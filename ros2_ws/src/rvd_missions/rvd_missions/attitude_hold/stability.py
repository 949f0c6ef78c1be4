"""
How much gain error the golden-section law with fixed parameters bears: poles, and Jury's criterion.

The law has the gain b of its model, the plant rho b (actuator times sensor gain over the estimate).
`loop` gives the characteristic polynomial of the closed loop as base + rho*change, highest power
first, from the model alone, for a delay of whole steps around the loop, too:

one tap     y(k+1) = f1 y(k) + f2 y(k-1) + rho b u(k): the characteristic model itself
two taps    y(k+1) = 2 y(k) - y(k-1) + rho dt^2/2 (u(k) + u(k-1)): the double integrator under a
            zero-order hold, with b = dt^2

Source  E. I. Jury, Theory and Application of the z-Transform Method, 1964, for the criterion;
        derivation D of the specification for the two loops.
"""

from math import inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_missions.attitude_hold.laws.golden_section import L1, L2

ONE_TAP, TWO_TAPS = (1.0,), (0.5, 0.5)
Polynomial = NDArray[np.float64]


def loop(taps: tuple[float, ...] = ONE_TAP, f1: float = 2.0, f2: float = -1.0,
         delay: int = 0) -> tuple[Polynomial, Polynomial]:
    """
    Return (base, change): the loop's polynomial in z is base + rho*change.

    `taps` are the shares of the input in the steps after it. The law is u = -(L1 f1 y(k) +
    L2 f2 y(k-1))/b, with the f1, f2 of the plant; a delay puts further steps into its input.
    """
    plant = np.array([1.0, -f1, -f2])
    law = np.array([L1*f1, L2*f2])
    change = np.convolve(np.asarray(taps, dtype=float), law)
    extra = len(taps) - 1 + delay               # powers of 1/z beyond those of the one-tap loop
    base = np.concatenate([plant, np.zeros(extra)])
    return base, np.concatenate([np.zeros(len(base) - len(change)), change])


def poles(rho: float, base: Polynomial, change: Polynomial) -> NDArray[np.complex128]:
    """Return the poles of the loop at a gain error, the farthest from zero first."""
    roots = np.roots(base + rho*change)
    return roots[np.argsort(-np.abs(roots))]


def is_stable(polynomial: ArrayLike) -> bool:
    """
    Tell by Jury's table whether all roots lie inside the unit circle.

    The first coefficient is that of the highest power and must not be zero.
    """
    row = np.asarray(polynomial, dtype=float)
    if not row[0] != 0.0:
        raise ValueError(f'the first coefficient must not be zero, got {row[0]}')
    row = row / row[0]
    while len(row) > 1:
        if not abs(row[-1]) < row[0]:
            return False
        row = (row[0]*row - row[-1]*row[::-1])[:-1]
    return True


def range_of_gain(base: Polynomial, change: Polynomial) -> tuple[float, float]:
    """
    Return the open interval of the gain error, as a ratio, that leaves the loop stable.

    A root crosses the unit circle at z = 1, at z = -1 or as a pair; the crossings are where the
    polynomial has a root there, which for a pair is where the last determinant of Jury's table is
    zero. Between two of them nothing changes, so one look inside each interval tells.

    Raises
    ------
    ValueError
        If the loop is stable at no positive gain error.
    """
    at = sorted({0.0, *_crossings(base, change)})
    inside = [(low, high) for low, high in zip(at, [*at[1:], inf])
              if is_stable(base + (0.5*(low + high) if high < inf else low + 1.0)*change)]
    if not inside:
        raise ValueError('the loop is stable at no positive gain error')
    return inside[0]


def _crossings(base: Polynomial, change: Polynomial) -> list[float]:
    """Return the positive gain errors at which a root is on the unit circle."""
    found = []
    for z in (1.0, -1.0):
        slope = np.polyval(change, z)
        if abs(slope) > 1e-12:
            found.append(-np.polyval(base, z) / slope)
    # A pair at exp(+-i w): base/change is real there, so the phase condition is a polynomial in
    # z: base(z) change(1/z) - base(1/z) change(z) = 0, both as powers of z.
    cross = np.polysub(np.convolve(base, change[::-1]), np.convolve(base[::-1], change))
    cross = cross[np.argmax(np.abs(cross) > 1e-14):]
    for z in np.roots(cross):
        if abs(abs(z) - 1.0) < 1e-6 and abs(z.imag) > 1e-6:
            z = z/abs(z)
            below = np.polyval(change, z)
            if abs(below) > 1e-12:
                found.append(float((-np.polyval(base, z)/below).real))
    return [rho for rho in found if rho > 1e-12]


def radius(rho: ArrayLike, base: Polynomial, change: Polynomial) -> NDArray[np.float64]:
    """Return the distance from zero of the farthest pole, for gain errors of any shape."""
    rho = np.asarray(rho, dtype=float)
    return np.array([abs(poles(r, base, change)[0]) for r in rho.ravel()]).reshape(rho.shape)
