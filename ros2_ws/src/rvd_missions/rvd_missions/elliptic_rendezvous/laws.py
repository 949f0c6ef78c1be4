"""
Range-rate control: what each law wants along and across the line of sight.

Frame   target orbital (`motion.kepler`); the line of sight runs from target to chaser at the
        angle phi from radial-out, positive along the orbital motion: x = D sin phi, y = D cos phi.
Source  Yu, Yang 1998, sections 2 and 3; the formulas are in `guidance.range_rate`. RRCA thrusts
        along the line of sight, ODRRCA adds a_phi across; the combined mode is RRCA down to a
        range D_f, where k = kappa (D_f - D) / D_f and a_phi take over.
"""

from math import radians
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.motion.kepler import Motion
from rvd_groundstation.guidance.range_rate import (
    across, check_gains, FEED_FORWARDS, feed_forward, FORMS, LineOfSight, range_rate)

Array = NDArray[np.float64]


class Demand(NamedTuple):
    """What a law wants; each (...)."""

    range_rate: Array           # D._r [m/s]
    across: Array               # a_phi [m/s^2]
    near: NDArray[np.bool_]     # the second stage of the combined mode is on


@settings
class Rrca:
    """Range-rate control: thrust along the line of sight alone, from a far range."""

    flies_around: ClassVar[bool] = False

    form: str = param('r1', 'Form of the reference range rate.', choices=FORMS)
    k: float = param(-0.5, 'Gain of the range rate, by which the range follows exp(k nu).')
    k1: float = param(1.0, 'Gain of the direction rate in the range rate.')
    k2: float = param(0.0, 'Gain of the angular acceleration of the orbit in the range rate.')

    def __post_init__(self) -> None:
        require(self.k < 0.0, 'k', 'be negative: the range follows exp(k nu) and would not shrink',
                self.k)
        check_gains(self.form, self.k, self.k1, getattr(self, 'q1', 0.0))

    def demand(self, los: LineOfSight, target: Motion, c: float, near: NDArray,
               hold_range_m: float) -> Demand:
        """
        Return what is wanted.

        Parameters
        ----------
        los : LineOfSight
            At the instant at which a command sent now will act.
        target : Motion
            Of the target at that instant.
        c : float
            1 + e cos nu there.
        near : ndarray of bool
            Rows that have been at the range of the second stage.
        hold_range_m : float
            That range.
        """
        return Demand(range_rate(self.form, self.k, self.k1, self.k2, los, target),
                      np.zeros_like(los.range), near)


@settings
class Odrrca(Rrca):
    """Range-rate control with a transverse thruster: an approach from any direction."""

    q: float = param(10.0, 'Stiffness of the transverse thruster.', above=0.0)
    q1: float = param(0.0, 'Damping of the transverse thruster.', low=0.0)
    phi_d_deg: float = param(
        -90.0, 'Direction wanted, from radial-out along the orbit [deg].', low=-360.0, high=360.0)
    ff: str = param('off', 'Feed-forward of the transverse thruster.', choices=FEED_FORWARDS)

    def demand(self, los: LineOfSight, target: Motion, c: float, near: NDArray,
               hold_range_m: float) -> Demand:
        """Return what is wanted; arguments as `Rrca.demand`."""
        phi_d = radians(self.phi_d_deg)
        fed = feed_forward(self.ff, self.k, self.k2, phi_d, target, c)
        return Demand(range_rate(self.form, self.k, self.k1, self.k2, los, target),
                      across(self.q, self.q1, phi_d, los, target, fed), near)


@settings
class FlyAroundParams:
    """The second stage of the combined mode: the range is held, the direction turned."""

    kappa: float = param(10.0, 'Stiffness of the range hold.', above=0.0)
    q: float = param(9.0, 'Stiffness of the transverse thruster.', above=0.0)
    q1: float = param(
        6.0, 'Damping of the transverse thruster, without which the fly-around does not settle.',
        above=0.0)
    phi_d_deg: float = param(
        -90.0, 'Direction wanted, from radial-out along the orbit [deg].', low=-360.0, high=360.0)


@settings
class Combined(Rrca):
    """Range-rate control from afar, then a fly-around at a held range to a direction."""

    flies_around: ClassVar[bool] = True

    fly_around: FlyAroundParams = param(FlyAroundParams, 'The second stage.')

    def demand(self, los: LineOfSight, target: Motion, c: float, near: NDArray,
               hold_range_m: float) -> Demand:
        """Return what is wanted; arguments as `Rrca.demand`."""
        far = Rrca.demand(self, los, target, c, near, hold_range_m)
        second, phi_d = self.fly_around, radians(self.fly_around.phi_d_deg)
        k = second.kappa*(hold_range_m - los.range)/hold_range_m
        fed = feed_forward('full', k, 0.0, phi_d, target, c)
        return Demand(
            np.where(near, range_rate('r1', k, 0.0, 0.0, los, target), far.range_rate),
            np.where(near, across(second.q, second.q1, phi_d, los, target, fed), 0.0), near)


LAWS = {'rrca': Rrca, 'odrrca': Odrrca, 'combined': Combined}
