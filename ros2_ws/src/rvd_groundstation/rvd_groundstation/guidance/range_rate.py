"""
Range-rate control: reference range rate and transverse acceleration, from the line of sight.

Frame   target orbital (`motion.kepler`); the line of sight runs from target to chaser at the
        angle phi from radial-out, positive along the orbital motion: x = D sin phi, y = D cos phi.
Source  Yu, Yang 1998, sections 2 and 3. Its equations are lost in the scan; these were derived
        from its words (forms R1, R2, R4: docs/missions/elliptic_rendezvous.md):
        R1  D._r = D (k nu. + k1 phi. + k2 nu.. / nu.)
        R2  D._r = D (nu. (k nu. + k1 phi.) / (phi. + nu.) + k2 nu.. / nu.)
        R4  D._r = D nu. (k nu. + k1 phi. + k2 nu.. / nu.) / (phi. + nu.)
        a_phi = D nu.^2 (-q wrap(phi - phi_d) - q1 phi' + ff)
        k, k1, k2, q and phi_d are the paper's names, kept here.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import require
from rvd_dynamics.motion.kepler import Motion

Array = NDArray[np.float64]
FORMS = ('r1', 'r2', 'r4')
FEED_FORWARDS = ('off', 'on', 'full')
LEAST_TURN = 0.05               # |1 + phi'| that R2 and R4 divide by, at least


class LineOfSight(NamedTuple):
    """Where the chaser is as the line of sight tells; each (...)."""

    range: Array                # D [m]
    direction: Array            # phi [rad]
    range_rate: Array           # D. [m/s]
    direction_rate: Array       # phi., against the turning orbital frame [rad/s]


def check_gains(form: str, k: float, k1: float, q1: float = 0.0) -> None:
    """
    Refuse gains with which no approach can be steady.

    The damping of the direction angle, averaged over an orbit, is 2 (k + k1) + q1 in form R1 and
    2 k1 + q1 in R2 and R4: by Liouville's theorem the map over one orbit contracts areas by
    exp(-2 pi) to that power.

    Raises
    ------
    Impossible
        Names the gain, its bound and why.
    """
    require(k <= 0.0, 'k', 'not be positive: the range follows exp(k nu), and the chaser would '
            'leave', k)
    least = (-k if form == 'r1' else 0.0) - q1/2
    why = '-k' if form == 'r1' else '0'
    less = ' - q1/2' if q1 else ''
    require(k1 > least, 'k1', f'be above {why}{less} = {least:g}: below, form {form.upper()} does '
            'not damp the direction angle over an orbit', k1)


def line_of_sight(state: ArrayLike) -> LineOfSight:
    """Return the line of sight in the orbital plane of states (..., 6)."""
    state = np.asarray(state, dtype=float)
    x, y, vx, vy = (state[..., i] for i in (0, 1, 3, 4))
    d = np.sqrt(x*x + y*y)
    return LineOfSight(d, np.arctan2(x, y), (x*vx + y*vy)/d, (y*vx - x*vy)/(d*d))


def state_of(los: LineOfSight) -> Array:
    """Return the states (..., 6) in the orbital plane; the inverse of `line_of_sight`."""
    d, phi, closing, turning = np.broadcast_arrays(*los)
    s, c, across = np.sin(phi), np.cos(phi), d*turning
    o = np.zeros_like(d)
    return np.stack([d*s, d*c, o, closing*s + across*c, closing*c - across*s, o], axis=-1)


def wrap(angle: ArrayLike) -> Array:
    """Return an angle in [-pi, pi)."""
    angle = np.asarray(angle, dtype=float)
    return angle - 2.0*np.pi*np.floor(angle/(2.0*np.pi) + 0.5)


def range_rate(form: str, k: ArrayLike, k1: float, k2: float, los: LineOfSight,
               target: Motion) -> Array:
    """Return D._r [m/s] of one of the FORMS; `k` may differ from row to row."""
    w, swing = target.rate, target.acceleration/target.rate         # nu., nu.. / nu.
    if form == 'r1':
        return los.range*(k*w + k1*los.direction_rate + k2*swing)
    turn = 1.0 + los.direction_rate/w
    turn = np.where(np.abs(turn) < LEAST_TURN, np.copysign(LEAST_TURN, turn), turn)
    inner, outer = (0.0, k2*swing) if form == 'r2' else (k2*swing, 0.0)
    return los.range*((k*w + k1*los.direction_rate + inner)/turn + outer)


def across(q: float, q1: float, phi_d: float, los: LineOfSight, target: Motion,
           feed_forward: ArrayLike) -> Array:
    """Return a_phi [m/s^2]; `feed_forward` is ff."""
    off, rate = wrap(los.direction - phi_d), los.direction_rate/target.rate
    return los.range*target.rate**2*(feed_forward - q*off - q1*rate)


def feed_forward(ff: str, k: ArrayLike, k2: float, phi_d: float, target: Motion,
                 c: float) -> ArrayLike:
    """Return ff of one of the FEED_FORWARDS, in units of D nu.^2; c = 1 + e cos nu."""
    if ff == 'off':
        return 0.0
    held = 2.0*k + 1.5*np.sin(2.0*phi_d)/c                          # gravity and the closing
    return held if ff == 'on' else held + (1.0 + 2.0*k2)*target.acceleration/target.rate**2


def keeping(los: LineOfSight, target: Motion, gravity: float) -> Array:
    """Return the acceleration [m/s^2] along the line of sight that keeps D.; gravity: mu/r^3."""
    turn, side = los.direction_rate + target.rate, np.cos(los.direction)
    return -los.range*(turn*turn + gravity*(3.0*side*side - 1.0))
