"""
The pseudo-rate modulator: a Schmitt trigger with first-order feedback, and its design formulas.

    u jumps to sign(X - x) where |X - x| >= on, and to 0 where it falls to off or below;
    T x' = K_F u - x

Source  An, Qu, Wang 2015, figure 3, eq. 28 to 31 after Xu, Introduction to Satellite Engineering,
        2003; their X0*, H_E, H_A, T_F. Corrected here: eq. 28 lacks a minus sign, so its on-time is
        negative; eq. 30 holds for H_E << 1 alone, and is wrong near the dead band. Derived: the
        rest. For K_F other than 1, X and both thresholds count in units of K_F.

Formulas take X of either sign, arrays of any shape; NaN where the modulator does not pulse.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings

Array = NDArray[np.float64]


@settings
class ModulatorParams:
    """A pseudo-rate modulator."""

    on_threshold: float = param(
        0.30, 'Error at which the trigger fires, H_E.', above=0.0, high=100.0)
    off_threshold: float = param(
        0.20, 'Error at which it stops, H_A.', low=0.0, high=100.0)
    time_constant_s: float = param(0.5, 'Time constant of the feedback, T_F [s].', above=0.0,
                                   high=100.0)
    feedback_gain: float = param(1.0, 'Gain of the feedback, K_F.', above=0.0, high=100.0)

    def __post_init__(self) -> None:
        require(self.off_threshold < self.on_threshold, 'off_threshold',
                f'be below on_threshold, {self.on_threshold:g}', self.off_threshold)

    # -- for a constant input ---------------------------------------------------------------------

    def _scaled(self, x: ArrayLike) -> tuple[Array, float, float]:
        """Return |X| where it pulses, NaN elsewhere, and both thresholds, in units of K_F."""
        k = self.feedback_gain
        size = np.abs(np.asarray(x, dtype=float))/k
        on, off = self.on_threshold/k, self.off_threshold/k
        return np.where((size > on) & (size < 1.0 + off), size, np.nan), on, off

    def on_time(self, x: ArrayLike) -> Array:
        """Return the length of a pulse [s]."""
        size, on, off = self._scaled(x)
        return -self.time_constant_s*np.log1p(-(on - off)/(on + 1.0 - size))

    def off_time(self, x: ArrayLike) -> Array:
        """Return the pause between two pulses [s]."""
        size, on, off = self._scaled(x)
        return self.time_constant_s*np.log((size - off)/(size - on))

    def frequency(self, x: ArrayLike) -> Array:
        """Return the frequency of pulses [Hz]."""
        return 1.0/(self.on_time(x) + self.off_time(x))

    def frequency_approximate(self, x: ArrayLike) -> Array:
        """Return it by the closed form that holds for a narrow trigger [Hz]; corrected eq. 30."""
        size, on, off = self._scaled(x)
        above = size - 0.5*(on + off)
        return above*(1.0 - above)/(self.time_constant_s*(on - off))

    def duty(self, x: ArrayLike) -> Array:
        """Return the fraction of time for which it is on: 0 in the dead band, 1 when saturated."""
        size = np.abs(np.asarray(x, dtype=float))/self.feedback_gain
        on, total = self.on_time(x), 1.0/self.frequency(x)
        least = self.on_threshold/self.feedback_gain
        most = self.saturation/self.feedback_gain
        return np.where(size <= least, 0.0, np.where(size >= most, 1.0, on/total))

    @property
    def shortest_pulse_s(self) -> float:
        """Length of the shortest pulse, that of an input just at the dead band [s]."""
        k = self.feedback_gain
        return float(-self.time_constant_s*np.log1p(
            -(self.on_threshold - self.off_threshold)/k))

    @property
    def saturation(self) -> float:
        """Input from which it is on for good."""
        return self.feedback_gain + self.off_threshold


class Modulator:
    """Modulators of a batch of axes (...): decides once a step and holds over it."""

    def __init__(self, settings: ModulatorParams, step_s: float, shape: tuple) -> None:
        self._on, self._off = settings.on_threshold, settings.off_threshold
        self._gain = settings.feedback_gain
        self._decay = float(np.exp(-step_s/settings.time_constant_s))
        self.feedback, self.output = np.zeros((2, *shape))

    def step(self, x: ArrayLike) -> Array:
        """Return u (...) of -1, 0, 1 for this step; an input that is NaN gives 0."""
        error = np.asarray(x, dtype=float) - self.feedback
        size = error*self.output                            # positive while it goes on
        go_on = size > self._off
        fires = np.abs(error) >= self._on
        self.output = np.where(go_on, self.output, np.where(fires, np.sign(error), 0.0))
        aim = self._gain*self.output
        self.feedback = aim + (self.feedback - aim)*self._decay
        return self.output


def limit_cycle(dead_band: float, pulse_s: float, acceleration: float) -> tuple[float, float]:
    """
    Return the period [s] and the speed of the limit cycle of a double integrator.

    One shortest pulse at either edge of the dead band turns the speed over: it is half of what a
    pulse gives, and the way there and back four dead bands long. `dead_band` [m] or [rad] on
    either side, `pulse_s` [s], `acceleration` [m/s^2] or [rad/s^2] while a pulse lasts.
    """
    gained = acceleration*pulse_s
    return 8.0*dead_band/gained, 0.5*gained
