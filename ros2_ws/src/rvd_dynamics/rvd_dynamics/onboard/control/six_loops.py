"""
Six loops of PID and pseudo-rate modulator: three for position, three for attitude.

    X = K (e + T_d e' + K_i S e dt),  u = modulator(X) in {-1, 0, 1}

Order   last axis: x, y, z, then roll, pitch, yaw; e is wanted minus actual.
Source  An, Qu, Wang 2015, section 2.5: six independent loops, no gains printed; eq. 31, the dead
        band H_E/K. The integral acts near the aim alone and is bounded by the dead band [assumed].

`Design` is what the formulas say of a loop, and `require_design` refuses gains that break a rule.
"""

from dataclasses import dataclass
from math import atan, pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.onboard.control.pseudo_rate import limit_cycle, Modulator, ModulatorParams

Array = NDArray[np.float64]
NEAR = 2.0                      # dead bands within which the integral acts
APART = 1.15                    # least ratio between 1/T_F and a frequency of the structure


@settings
class LoopParams:
    """One PID with its modulator, the same for three axes."""

    gain: float = param(12.0, 'Gain K, of an error in metres or radians.', above=0.0, high=1e5)
    derivative_s: float = param(3.5, 'Derivative time T_d [s].', low=0.0, high=1000.0)
    integral_per_s: float = param(0.0, 'Integral gain K_i [1/s].', low=0.0, high=100.0)
    modulator: ModulatorParams = param(ModulatorParams, 'Its modulator.')

    @property
    def dead_band(self) -> float:
        """Error below which a loop at rest does nothing: H_E/K, in metres or radians."""
        return self.modulator.on_threshold/self.gain


@settings
class AttitudeLoopParams(LoopParams):
    """The same for attitude."""

    gain: float = param(50.0, 'Gain K, of an error in radians.', above=0.0, high=1e5)
    derivative_s: float = param(3.0, 'Derivative time T_d [s].', low=0.0, high=1000.0)


class SixLoops:
    """Six loops of a batch: state of the integrals and modulators."""

    def __init__(self, position: LoopParams, attitude: LoopParams, step_s: float,
                 batch: tuple) -> None:
        self._loops, self._step_s = (position, attitude), step_s
        self._modulators = [Modulator(loop.modulator, step_s, (*batch, 3)) for loop in self._loops]
        self._integral = [np.zeros((*batch, 3)) for _ in self._loops]

    def step(self, error: ArrayLike, rate: ArrayLike) -> Array:
        """
        Return u (..., 6) of -1, 0, 1.

        Parameters
        ----------
        error, rate : array_like, shape (..., 6)
            Wanted minus actual position [m] and attitude [rad], and their rates. NaN: no answer.
        """
        error, rate = np.asarray(error, dtype=float), np.asarray(rate, dtype=float)
        found = []
        for i, (loop, modulator) in enumerate(zip(self._loops, self._modulators)):
            e, de = error[..., 3*i:3*i + 3], rate[..., 3*i:3*i + 3]
            if loop.integral_per_s:
                near = np.abs(e) < NEAR*loop.dead_band      # false for NaN
                most = loop.dead_band/loop.integral_per_s
                self._integral[i] = np.where(near, np.clip(
                    self._integral[i] + self._step_s*e, -most, most), self._integral[i])
            x = loop.gain*(e + loop.derivative_s*de + loop.integral_per_s*self._integral[i])
            found.append(modulator.step(x))
        return np.concatenate(found, axis=-1)


# -- design ---------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Design:
    """
    What a loop does to a rigid craft.

    `acceleration` is that of the thrusters of the axis [m/s^2] or [rad/s^2]; lengths and speeds are
    in metres or radians.
    """

    loop: LoopParams
    acceleration: float

    @property
    def shortest_pulse_s(self) -> float:
        """Length of the shortest pulse [s]."""
        return self.loop.modulator.shortest_pulse_s

    @property
    def limit_cycle_s(self) -> float:
        """Period of the limit cycle at the aim [s], by dead band and shortest pulse."""
        return limit_cycle(self.loop.dead_band, self.shortest_pulse_s, self.acceleration)[0]

    @property
    def limit_cycle_rate(self) -> float:
        """Speed on it."""
        return limit_cycle(self.loop.dead_band, self.shortest_pulse_s, self.acceleration)[1]

    def phase_lead(self, frequency: float, delay_s: float) -> float:
        """
        Return the phase by which the mean thrust leads an error of `frequency` [rad/s], in rad.

        The modulator's feedback follows X, so that on average K_F u = X + T_F X'.
        """
        m = self.loop.modulator
        return (atan(frequency*self.loop.derivative_s) + atan(frequency*m.time_constant_s)
                - frequency*delay_s)


def require_design(name: str, design: Design, widest: float, least_on_s: float, delay_s: float,
                   frequencies: ArrayLike, clock_s: float, lead_deg: float = 20.0) -> None:
    """
    Refuse a loop that breaks a rule.

    Parameters
    ----------
    name : str
        What the keys of its settings begin with.
    design : Design
    widest : float
        Dead band that is still allowed [m] or [rad].
    least_on_s, clock_s, delay_s : float
        Least on-time of a thruster, step of the modulator, delay around the loop [s].
    frequencies : array_like
        Frequencies of panels and tanks [rad/s], at which thrust must lead by `lead_deg`; those
        above pi/(2 delay) are beyond control and left out.

    Raises
    ------
    BadInput
        Names the first rule, the value and its bound.
    """
    loop = design.loop
    m = loop.modulator
    if not loop.dead_band < widest:
        raise BadInput(f'{name}.gain: the dead band on_threshold/gain must be below {widest:g}, '
                       f'got {loop.dead_band:g}')
    if not design.shortest_pulse_s >= least_on_s:
        raise BadInput(f'{name}.modulator: its shortest pulse must not be below the least on-time '
                       f'of a thruster, {least_on_s:g} s, got {design.shortest_pulse_s:.4g} s')
    if not m.time_constant_s >= clock_s:
        raise BadInput(f'{name}.modulator.time_constant_s must be at least one step, '
                       f'{clock_s:g} s, got {m.time_constant_s:g}')
    for w in np.sort(np.ravel(frequencies)):
        corner = 1.0/m.time_constant_s
        if max(corner/w, w/corner) < APART:
            raise BadInput(f'{name}.modulator.time_constant_s: 1/T_F must be at least a factor '
                           f'{APART} away from {w:.4g} rad/s of a panel or tank, got '
                           f'{corner:.4g} rad/s')
        lead = design.phase_lead(w, delay_s)
        if w*delay_s < 0.5*pi and not lead > np.radians(lead_deg):
            raise BadInput(f'{name}.derivative_s: thrust must lead by {lead_deg:g} degrees at '
                           f'{w:.4g} rad/s of a panel or tank, got {np.degrees(lead):.3g}')
