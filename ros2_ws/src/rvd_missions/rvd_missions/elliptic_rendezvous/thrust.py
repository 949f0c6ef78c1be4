"""
From what a law wants to an acceleration: continuous, or in pulses.

Source  Yu, Yang 1998, section 2: the thruster along the line of sight makes D. follow D._r. How it
        does is lost. Continuous: what keeps D. as it is, from the line-of-sight equation, and a
        gain on the error. Pulses: what removes the error within one step, outside a dead band that
        scales with D._r; a fixed one that is fit for 50 km biases the direction at 50 m, and the
        other way round. The transverse thruster then fires what it owes when that is beyond the
        dead band. Out of the plane, of which the paper says nothing, z. follows k nu. z.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.motion.kepler import Motion
from rvd_groundstation.guidance.range_rate import keeping, LineOfSight
from rvd_missions.elliptic_rendezvous.laws import Demand

THRUSTERS = ('ideal', 'pulses')


@settings
class ThrustParams:
    """How thrusters carry out what a law wants."""

    thrusters: str = param(
        'ideal', 'Thrusters: ideal gives any acceleration, pulses fires outside a dead band.',
        choices=THRUSTERS)
    rate_gain_per_s: float = param(
        0.2, 'Acceleration per unit of error of the range rate, with ideal thrusters [1/s].',
        above=0.0)
    max_acceleration_m_s2: float = param(
        0.4, 'Greatest acceleration along and across the line of sight [m/s^2].', above=0.0)
    dead_band_m_s: float = param(
        0.001, 'Least dead band of the range rate, with pulses [m/s].', low=0.0)
    dead_band_fraction: float = param(
        0.002, 'Dead band of the range rate as a fraction of the reference rate, with pulses.',
        low=0.0, below=1.0)


class Thrusters:
    """Called once per step, in order; shape (...) is `batch`."""

    def __init__(self, params: ThrustParams, step_s: float, batch: tuple) -> None:
        self._params, self._step_s = params, step_s
        self._owed = np.zeros(batch)            # [m/s] across, wanted and not yet fired

    def acceleration(self, state: NDArray, los: LineOfSight, demand: Demand, target: Motion,
                     c: float, k: float) -> tuple[NDArray, NDArray, NDArray]:
        """
        Return acceleration along and across the line of sight and along z, each (...) [m/s^2].

        Parameters
        ----------
        state : ndarray, shape (..., 6)
        los : LineOfSight
            Of that state.
        demand : Demand
        target : Motion
            Of the target.
        c : float
            1 + e cos nu.
        k : float
            Gain of the range rate, which the motion out of the plane follows, too.
        """
        p, most = self._params, self._params.max_acceleration_m_s2
        gravity = target.rate*target.rate/c                             # mu / r^3
        z, out = state[..., 2], k*target.rate*state[..., 2] - state[..., 5]
        error = demand.range_rate - los.range_rate
        if p.thrusters == 'ideal':
            held = keeping(los, target, gravity)
            return (np.clip(held + p.rate_gain_per_s*error, -most, most),
                    np.clip(demand.across, -most, most),
                    np.clip(gravity*z + p.rate_gain_per_s*out, -most, most))
        band = np.maximum(p.dead_band_m_s, p.dead_band_fraction*np.abs(demand.range_rate))
        known = np.isfinite(demand.across)
        self._owed = self._owed + np.where(known, demand.across, 0.0)*self._step_s
        across = self._pulse(self._owed, band)
        self._owed = self._owed - across*self._step_s
        return self._pulse(error, band), across, self._pulse(out, band)

    def _pulse(self, error: NDArray, band: NDArray) -> NDArray:
        """Return what removes an error of velocity [m/s] in one step; nothing in the dead band."""
        most = self._params.max_acceleration_m_s2
        wanted = np.clip(error/self._step_s, -most, most)
        return np.where(np.abs(error) > band, wanted, 0.0)
