"""
Command forms of thrusters along the axes of the target orbital frame: what is commanded is an
acceleration, in the alphabet that the engines have.

    continuous      any acceleration up to a largest one
    rate_limited    the same, with thrust that builds up and dies away at a constant rate
    bang_bang       engines of equal thrust that are on or off: whole levels of each axis
    pulses          full thrust for part of a step, on-times in whole ticks of a valve

Shapes  commands and accelerations carry x, y, z on the last axis; leading axes are batch axes.
Source  Xu, Zhang, Chinese J. Theor. Appl. Mech. 52(6), section on realisable thrust: rate-limited
        with a cap, and four engines of a quarter of the thrust. Both rules of rounding and both
        readings of the rate are reconstructions (the equation is lost in the scan).

A form with memory, such as a rate limit, makes the command of a step from that of the step before:
`follow(last, wanted)`, which every form has. `away` says where from a target the craft is, as signs
of x, y, z, and so what an ABORT does.
"""

from collections.abc import Sequence
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_dynamics.diagram.run import Run

Array = NDArray[np.float64]
BEHIND = (-1, 0, 0)                     # the craft comes from -x
ROUNDING = 1e-9                         # (3 a) / a may be 2.9999999999999996
STEP_S = 1.0                            # [s] without a run


def _finite(wanted: ArrayLike) -> Array:
    """Return what is wanted, zero where it is not finite."""
    wanted = np.asarray(wanted, dtype=float)
    return np.where(np.isfinite(wanted), wanted, 0.0)


@settings
class Continuous:
    """Any acceleration up to a largest one on each axis; a command is (..., 3) float64 [m/s^2]."""

    max_m_s2: float = param(
        0.01, 'Largest acceleration on each axis [m/s^2].', above=0.0, high=1000.0)
    away: tuple = wiring(BEHIND)

    neutral = np.zeros(3)
    wire = Struct('<3d')

    @property
    def retreat(self) -> Array:
        """What an ABORT commands: full thrust away from the target."""
        return self.max_m_s2 * np.array(self.away, dtype=float)

    def effect(self, command: ArrayLike) -> Array:
        """Return the nominal acceleration (..., 3) [m/s^2]: a command says it itself."""
        return np.asarray(command, dtype=float)

    def quantise(self, wanted: ArrayLike) -> Array:
        """Return the command nearest to accelerations (..., 3) [m/s^2]; zero where unknown."""
        return np.clip(_finite(wanted), -self.max_m_s2, self.max_m_s2)

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> Array:
        """Return the command after `last` (..., 3) that is nearest to what is wanted."""
        return self.quantise(wanted)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return all(abs(a) <= self.max_m_s2 for a in command)


@settings
class RateLimited(Continuous):
    """
    Thrust that ramps at a constant rate, on and off; commands as `Continuous`.

    `rate` goes towards the command and stops there. `rate2` ramps all the time, with a dead zone
    of half a ramp in which it holds: the only reading with which the speed oscillates near the
    target, as the source says it does.
    """

    ramp_s: float = param(
        3.0, 'Time in which thrust rises from nothing to the largest [s].', above=0.0, high=3600.0)
    reading: str = param(
        'rate', 'Whether thrust stops at the command (rate) or ramps without intermediate hold '
        '(rate2).', choices=('rate', 'rate2'))
    run: Run | None = wiring()

    @property
    def change_m_s2(self) -> float:
        """Largest change of a component in one step [m/s^2]."""
        step_s = STEP_S if self.run is None else self.run.step_s
        return self.max_m_s2 * step_s / self.ramp_s

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> Array:
        """Return the command that thrust can reach one step after `last` (..., 3)."""
        last, wanted = _finite(last), self.quantise(wanted)
        change, most = self.change_m_s2, self.max_m_s2
        if self.reading == 'rate':
            return np.clip(np.clip(wanted, last - change, last + change), -most, most)
        to_go = wanted - last
        ramp = np.where(to_go > 0.0, change, -change)
        thrust = np.clip(np.where(np.abs(to_go) <= 0.5*change, last, last + ramp), -most, most)
        return np.where(np.abs(thrust) < ROUNDING*most, 0.0, thrust)    # up and down again is off


@settings
class BangBang:
    """
    Engines of equal thrust, on or off; a command is whole levels (..., 3) of int8.

    `round` lights the number of engines nearest to what is wanted, `floor` no more than that.
    """

    max_m_s2: float = param(
        0.01, 'Acceleration on each axis with all engines on [m/s^2].', above=0.0, high=1000.0)
    engines: int = param(4, 'Engines in each direction of an axis.', low=1, high=100)
    rounding: str = param(
        'round', 'Whether the nearest number of engines is lit (round), or no more than what is '
        'wanted (floor).', choices=('round', 'floor'))
    away: tuple = wiring(BEHIND)

    neutral = np.zeros(3, dtype=np.int8)
    wire = Struct('<3b')

    @property
    def alphabet(self) -> NDArray[np.int8]:
        """Levels of each axis."""
        return np.arange(-self.engines, self.engines + 1, dtype=np.int8)

    @property
    def retreat(self) -> NDArray[np.int8]:
        """What an ABORT commands: full thrust away from the target."""
        return (self.engines * np.array(self.away)).astype(np.int8)

    def effect(self, command: ArrayLike) -> Array:
        """Return the nominal acceleration (..., 3) [m/s^2] of commands (..., 3)."""
        return np.asarray(command, dtype=float) * (self.max_m_s2 / self.engines)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.int8]:
        """Return the levels for accelerations (..., 3) [m/s^2]; 0 where unknown."""
        wanted = _finite(wanted)
        size = np.abs(wanted) / (self.max_m_s2 / self.engines)
        lit = np.floor(size + (0.5 if self.rounding == 'round' else ROUNDING))
        return np.copysign(np.minimum(lit, self.engines), wanted).astype(np.int8)

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> NDArray[np.int8]:
        """Return the command after `last`: engines have no memory."""
        return self.quantise(wanted)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one (NaN and 1.5 are not)."""
        return all(level in range(-self.engines, self.engines + 1) for level in command)


@settings
class Pulses:
    """
    Pulse width: full thrust for part of each step; a command is on-times (..., 3) in ticks, int16.

    A pulse is no shorter than the least on-time (the minimum impulse bit over the thrust) and no
    longer than the step. What is wanted of less than half of the least pulse gets none.
    """

    max_m_s2: float = param(
        0.01, 'Acceleration on each axis while a thruster is on [m/s^2].', above=0.0, high=1000.0)
    tick_s: float = param(
        0.001, 'Resolution of the time for which a thruster is on [s].', above=0.0, high=1.0)
    least_on_s: float = param(
        0.02, 'Shortest time for which a thruster can be on [s].', low=0.0, high=10.0)
    run: Run | None = wiring()
    away: tuple = wiring(BEHIND)

    neutral = np.zeros(3, dtype=np.int16)
    wire = Struct('<3h')

    def __post_init__(self) -> None:
        if self.run is not None:
            require(self.tick_s <= self.run.step_s <= 32767 * self.tick_s, 'tick_s',
                    f'go 1 to 32767 times into step_s = {self.run.step_s:g}', self.tick_s)
            require(self.least_on_s <= self.run.step_s, 'least_on_s',
                    f'not be above step_s = {self.run.step_s:g}', self.least_on_s)

    @property
    def step_s(self) -> float:
        """Length of a step [s]."""
        return STEP_S if self.run is None else self.run.step_s

    @property
    def longest(self) -> int:
        """Ticks in a step."""
        return int(self.step_s / self.tick_s + ROUNDING)

    @property
    def least(self) -> int:
        """Ticks of the shortest pulse."""
        return max(int(np.ceil(self.least_on_s / self.tick_s - ROUNDING)), 1)

    @property
    def retreat(self) -> NDArray[np.int16]:
        """What an ABORT commands: full thrust away from the target."""
        return (self.longest * np.array(self.away)).astype(np.int16)

    def effect(self, command: ArrayLike) -> Array:
        """Return the mean acceleration (..., 3) [m/s^2] over a step of commands (..., 3)."""
        return np.asarray(command, dtype=float) * (self.max_m_s2 * self.tick_s / self.step_s)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.int16]:
        """Return the on-times for mean accelerations (..., 3) [m/s^2]; 0 where unknown."""
        wanted = _finite(wanted)
        ticks = np.abs(wanted) / (self.max_m_s2 * self.tick_s / self.step_s)
        on = np.clip(np.floor(ticks + 0.5), self.least, self.longest)
        on = np.where(ticks < 0.5*self.least, 0.0, on)
        return np.copysign(on, wanted).astype(np.int16)

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> NDArray[np.int16]:
        """Return the command after `last`: valves have no memory."""
        return self.quantise(wanted)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one."""
        return all(on == 0 or (abs(on) in range(self.least, self.longest + 1)) for on in command)


def switches(commands: ArrayLike) -> NDArray[np.int64]:
    """
    Return how often engines go on or off, of commands (steps, ..., 3); shape (...).

    All are off before the first step and after the last. Counted on each axis: a change of sign
    puts one engine off and another on, and a change of size neither.
    """
    on = np.sign(np.asarray(commands)).astype(np.int64)
    off = np.zeros((1, *on.shape[1:]), dtype=np.int64)
    change = np.abs(np.diff(np.concatenate([off, on, off]), axis=0))
    return change.sum(axis=(0, -1))
