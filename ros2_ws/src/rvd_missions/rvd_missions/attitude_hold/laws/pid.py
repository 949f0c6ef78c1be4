"""
Proportional-integral-derivative law with a first-order filter of the derivative.

    u(k) = -(kp e(k) + ki I(k) + kd d(k)),   I(k) = I(k-1) + dt e(k),
    d(k) = d(k-1) + dt/(dt + T) ((e(k) - e(k-1))/dt - d(k-1))

Both errors of the difference are taken from the present reference, so that a step of the reference
is not differentiated. The integral is bounded, which keeps it from winding up.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class Pid:
    """Proportional-integral-derivative law with fixed gains."""

    proportional_per_s2: float = param(
        0.223, 'Acceleration per error [1/s^2].', low=0.0, high=1e4)
    integral_per_s3: float = param(
        1.8e-5, 'Acceleration per time integral of the error [1/s^3].', low=0.0, high=1e4)
    derivative_per_s: float = param(
        0.588, 'Acceleration per rate of the error [1/s].', low=0.0, high=1e4)
    filter_s: float = param(
        0.003, 'Time constant of the filter of the rate [s].', low=0.0, high=1e4)
    integral_limit_deg_s: float = param(
        1.8, 'Bound of the time integral of the error, on either side [deg s].', above=0.0,
        high=1e6)

    def controller(self, step_s: float, batch: tuple) -> 'PidAtWork':
        """Return the law with its memory, for a batch of runs sampled every `step_s`."""
        return PidAtWork(self, step_s, batch)


class PidAtWork:
    """The law at work."""

    def __init__(self, law: Pid, step_s: float, batch: tuple) -> None:
        self._law, self._step_s = law, step_s
        self._share = step_s / (step_s + law.filter_s)
        self._most = float(np.radians(law.integral_limit_deg_s))
        self._integral, self._rate = np.zeros(batch), np.zeros(batch)

    def wanted(self, errors: tuple, acted: NDArray, fresh: NDArray) -> NDArray[np.float64]:
        """Return the wanted acceleration (...) [rad/s^2]; see `laws.Controller`."""
        now, before, _ = errors
        law, dt = self._law, self._step_s
        summed = np.clip(self._integral + dt*now, -self._most, self._most)
        self._integral = np.where(np.isfinite(summed), summed, self._integral)
        rate = self._rate + self._share*((now - before)/dt - self._rate)
        self._rate = np.where(np.isfinite(rate), rate, self._rate)
        return -(law.proportional_per_s2*now + law.integral_per_s3*self._integral
                 + law.derivative_per_s*self._rate)

    @property
    def inside(self) -> Mapping[str, NDArray]:
        """What the law remembers: integral [rad s] and filtered rate [rad/s], each (...)."""
        return {'integral': self._integral, 'rate': self._rate}
