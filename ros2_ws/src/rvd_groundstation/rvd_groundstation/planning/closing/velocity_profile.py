"""
A closing by a velocity profile: fast, slow down, dock, come to rest; the offset dies away.

It is no optimum: it is what a person can follow on a display.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_groundstation.planning.closing.task import ClosingParams, Ends, margins


@settings
class VelocityProfile:
    """Speeds and stretches of the profile."""

    fast_m_s: float = param(0.05, 'Closing speed of the first stretch [m/s].', above=0.0)
    dock_m_s: float = param(0.02, 'Closing speed of the last stretch [m/s].', above=0.0)
    dock_m: float = param(0.2, 'Length of the last stretch [m].', above=0.0)
    acceleration_m_s2: float = param(
        0.005, 'Acceleration between the stretches [m/s^2].', above=0.0)
    task: ClosingParams = wiring(ClosingParams())

    def __post_init__(self) -> None:
        require(self.dock_m_s <= self.fast_m_s, 'dock_m_s', f'not be above fast_m_s, '
                f'{self.fast_m_s:g}', self.dock_m_s)
        least = self.dock_m_s*self.dock_m_s/(2.0*self.acceleration_m_s2)
        require(self.dock_m >= least, 'dock_m', f'be at least {least:g} m, in which the chaser '
                'comes to rest', self.dock_m)

    def plan(self, ends: Ends, before: object = None) -> 'ProfileReference':
        """
        Return the profile between two states at rest; it has no use for an earlier one.

        Raises
        ------
        BadInput
            If the way is too short, or the profile breaks a limit of the task.
        """
        moving = max(np.abs(ends.initial[3:]).max(), np.abs(ends.final[3:]).max())
        if moving > 0.0:
            raise BadInput('a velocity profile begins and ends at rest, got a speed of '
                           f'{moving:g} m/s')
        way = ends.final[0] - ends.initial[0]
        a, fast, slow = self.acceleration_m_s2, self.fast_m_s, self.dock_m_s
        changing = (2.0*fast*fast - slow*slow)/(2.0*a)
        cruise = way - changing - self.dock_m
        if cruise < 0.0:
            raise BadInput(f'velocity profile: the way along x must be at least '
                           f'{changing + self.dock_m:g} m, got {way:g}')
        # knots of speed: up, cruise, down, dock, rest
        durations = np.array([fast/a, cruise/fast, (fast - slow)/a,
                              (self.dock_m - slow*slow/(2.0*a))/slow, slow/a])
        knots = np.concatenate([[0.0], durations.cumsum()])
        speeds = np.array([0.0, fast, fast, slow, slow, 0.0])
        made = ProfileReference(self.task, ends, knots, speeds)
        low, high = self.task.duration_s
        if not low <= made.duration_s <= high:
            raise BadInput(f'velocity profile: its duration must be between {low:g} and {high:g} '
                           f's, got {made.duration_s:.4g}')
        margins(self.task, made).check(self.task)
        return made


@dataclass(frozen=True)
class ProfileReference:
    """Piecewise linear speed along x; quintics across, at rest when the last stretch begins."""

    task: ClosingParams
    ends: Ends
    knots_s: NDArray
    speeds_m_s: NDArray

    @property
    def duration_s(self) -> float:
        """Duration [s]."""
        return float(self.knots_s[-1])

    @property
    def cost(self) -> float:
        """Cost J, its integral by the midpoint rule."""
        step = self.duration_s/20_000
        _, accel = self.at(step*(np.arange(20_000) + 0.5))
        return float(self.task.cost(self.duration_s, step*(accel*accel).sum()))

    def at(self, time_s: ArrayLike) -> tuple[NDArray, NDArray]:
        """Return states (..., 6) and accelerations (..., 3) at times (...) [s]."""
        t = np.clip(np.asarray(time_s, dtype=float), 0.0, self.duration_s)
        state, bend = np.empty((*t.shape, 6)), np.empty((*t.shape, 3))
        part = np.clip(np.searchsorted(self.knots_s, t, side='right') - 1, 0, 4)
        slopes = np.diff(self.speeds_m_s)/np.diff(self.knots_s)
        ways = np.concatenate([[0.0], np.cumsum(
            0.5*(self.speeds_m_s[1:] + self.speeds_m_s[:-1])*np.diff(self.knots_s))])
        since = t - self.knots_s[part]
        state[..., 0] = self.ends.initial[0] + ways[part] + since*(
            self.speeds_m_s[part] + 0.5*slopes[part]*since)
        state[..., 3] = self.speeds_m_s[part] + slopes[part]*since
        bend[..., 0] = slopes[part]
        until = self.knots_s[3]
        s = np.clip(t/until, 0.0, 1.0)[..., np.newaxis]
        change = (self.ends.final - self.ends.initial)[1:3]
        state[..., 1:3] = self.ends.initial[1:3] + change*s**3*(10.0 - 15.0*s + 6.0*s*s)
        state[..., 4:6] = change*30.0*s*s*(1.0 - s)**2/until
        bend[..., 1:3] = change*60.0*s*(1.0 - s)*(1.0 - 2.0*s)/until**2
        drift = np.stack(self.task.drift(np.moveaxis(state, -1, 0)), axis=-1)
        return state, bend + drift
