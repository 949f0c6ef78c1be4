"""
The first of the paper's planners: a velocity profile of fast approach, deceleration and docking.

Along x the distance of the faces falls with trapezoids of speed: up to the fast one, down to that
of docking, down to rest; how long the fast one lasts follows from the time that is left. Across,
the offset falls by a cubic. Source: An, Qu, Wang 2015, section 2.3 (1); numbers assumed.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, require, settings
from rvd_missions.docking.settings import compiled

Array = NDArray[np.float64]


@settings
class ProfileParams:
    """Speeds and accelerations of the profile."""

    fast_m_s: float = param(0.05, 'Speed of the fast approach [m/s].', above=0.0, high=10.0)
    dock_m_s: float = param(0.02, 'Speed of docking [m/s].', above=0.0, high=10.0)
    acceleration_m_s2: float = param(
        0.004, 'Acceleration and deceleration along the way [m/s^2].', above=0.0, high=10.0)
    lateral_s: float = param(50.0, 'Time in which the offset across is taken away [s].',
                             above=0.0, high=86400.0)

    def __post_init__(self) -> None:
        require(self.dock_m_s < self.fast_m_s, 'dock_m_s',
                f'be below fast_m_s, {self.fast_m_s:g}', self.dock_m_s)


class Profile:
    """
    Profiles of N rows, from where each begins.

    Parameters
    ----------
    start : array_like, shape (N, 3)
        Port from the target's port [m], x negative.
    distance, seconds : float
        Distance of the faces at the end [m], and the time to get there [s].

    Raises
    ------
    BadInput
        If a way cannot be gone in that time with those speeds; names the row's way and the bounds.
    """

    def __init__(self, settings: ProfileParams, start: ArrayLike, distance: float,
                 seconds: float) -> None:
        s, start = settings, np.array(start, dtype=float)
        fast, dock, a = s.fast_m_s, s.dock_m_s, s.acceleration_m_s2
        way = -start[:, 0] - distance
        ramps = [fast/a, (fast - dock)/a, dock/a]
        ramp_way = 0.5*(fast*ramps[0] + (fast + dock)*ramps[1] + dock*ramps[2])
        rest = seconds - sum(ramps)
        long = (way - ramp_way - dock*rest)/(fast - dock)       # at the fast speed
        for i in np.flatnonzero(~((long >= 0.0) & (long <= rest))):
            low, high = ramp_way + dock*max(rest, 0.0), ramp_way + fast*max(rest, 0.0)
            raise BadInput(f'profile: a way of {way[i]:.4g} m cannot be gone in {seconds:.4g} s '
                           f'with fast_m_s {fast:g} and dock_m_s {dock:g}, but {low:.4g} to '
                           f'{high:.4g} m')
        self._start, self._lateral, self._distance = start, s.lateral_s, distance
        # ends of the five parts (N, 6), speed at each, and the way gone
        spans = np.stack([np.full_like(long, ramps[0]), long, np.full_like(long, ramps[1]),
                          rest - long, np.full_like(long, ramps[2])], axis=-1)
        self._ends = np.concatenate([np.zeros_like(long)[:, None], np.cumsum(spans, -1)], axis=-1)
        self._speeds = np.array([0.0, fast, fast, dock, dock, 0.0])
        gone = 0.5*(self._speeds[1:] + self._speeds[:-1])*spans
        self._gone = np.concatenate([np.zeros_like(long)[:, None], np.cumsum(gone, -1)], axis=-1)

    def at(self, t: float) -> tuple[Array, Array]:
        """Return port (N, 3) [m] and velocity (N, 3) [m/s] at a time [s] since the start."""
        s = min(t/self._lateral, 1.0)
        left, slope = (1 - s)**2*(1 + 2*s), -6*s*(1 - s)/self._lateral
        return compiled().profile(t, self._start, self._ends, self._speeds, self._gone, left, slope)
