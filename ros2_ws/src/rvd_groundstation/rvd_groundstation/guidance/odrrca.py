"""
The law `odrrca` along the V-bar of a circular orbit: range-rate control with a transverse thruster.

Frame   target orbital, docking plane at x = 0; the chaser comes from behind, phi_d = -90 degrees.
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Source  Yu, Yang 1998; the formulas are in `range_rate`, with nu. = n and nu.. = 0. Along the line
        of sight, what keeps D. and a gain on the error of D., as `thrust` of the elliptic mission
        has it. Ours: the aim point and the least closing speed (`aim`). Out of the plane, of which
        the paper says nothing, the same stiffness and damping as across, assumed:
        a_z = -q n^2 z - q1 n z'.
Limits  the defaults are tuned for the lunar approach, not published: docs/laws.md. The law knows
        no corridor wall; that it stays inside follows from holding the direction.
"""

from math import pi
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_dynamics.motion.kepler import Motion
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_groundstation.guidance.aim import AimParams
from rvd_groundstation.guidance.range_rate import (
    across, check_gains, feed_forward, FORMS, keeping, line_of_sight, range_rate)

Array = NDArray[np.float64]
BEHIND = -pi/2                  # phi_d [rad]: on the V-bar behind the target


@settings
class OdrrcaAim(AimParams):
    """The point that `odrrca` heads for, and the speed it keeps."""

    beyond_m: float = param(
        300.0, 'Distance beyond the docking plane of the point that the law heads for [m].',
        low=0.0, high=1000.0)


@settings
class Odrrca:
    """Range-rate control with a transverse thruster, along the V-bar and past the docking plane."""

    uses_stick: ClassVar[bool] = False

    orbit: OrbitParams = wiring()

    form: str = param('r1', 'Form of the reference range rate.', choices=FORMS)
    k: float = param(-0.923, 'Gain of the range rate, by which the range follows exp(k n t).')
    k1: float = param(0.0, 'Gain of the direction rate in the range rate.')
    q: float = param(102000.0, 'Stiffness of the transverse thruster.', above=0.0, high=1e8)
    q1: float = param(2020.0, 'Damping of the transverse thruster.', low=0.0)
    ff: str = param(
        'on', 'Feed-forward of the transverse thruster, of gravity and closing.',
        choices=('off', 'on'))
    rate_gain_per_s: float = param(
        0.173, 'Acceleration per unit of error of the range rate [1/s].', above=0.0, high=100.0)
    aim: AimParams = param(OdrrcaAim, 'Where the law heads.')

    def __post_init__(self) -> None:
        require(self.k < 0.0, 'k', 'be negative: the range follows exp(k n t) and would not shrink',
                self.k)
        check_gains(self.form, self.k, self.k1, self.q1)

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None = None) -> Array:
        """Return the acceleration (..., 3) [m/s^2] wanted; see `Law.wanted`."""
        state = self.aim.seen(prediction)
        n = self.orbit.mean_motion
        target = Motion(0.0, self.orbit.radius_m, n, 0.0)
        los = line_of_sight(state)
        rate = range_rate(self.form, self.k, self.k1, 0.0, los, target)
        if self.aim.least_closing_m_s > 0.0:    # at 0 the law may open the range, as published
            rate = np.minimum(rate, -self.aim.least_closing_m_s)
        along = keeping(los, target, n*n) + self.rate_gain_per_s*(rate - los.range_rate)
        fed = feed_forward(self.ff, self.k, 0.0, BEHIND, target, 1.0)
        side = across(self.q, self.q1, BEHIND, los, target, fed)
        s, c = state[..., 0]/los.range, state[..., 1]/los.range         # sin phi, cos phi
        result = np.empty((3, *state.shape[:-1]))
        result[0] = along*s + side*c
        result[1] = along*c - side*s
        result[2] = -n*(self.q*n*state[..., 2] + self.q1*state[..., 5])
        return result.transpose(*range(1, result.ndim), 0)
