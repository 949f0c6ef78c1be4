"""
Settings that belong to no single block: where the chaser starts, where an approach ends.
"""

from math import radians

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.form import thrusters
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_groundstation.guidance.range_rate import LineOfSight, state_of
from rvd_missions.elliptic_rendezvous.laws import LAWS, Rrca

ThrusterParams = thrusters(0.6)


@settings
class StartParams:
    """Where and how the chaser starts, as the line of sight from target to chaser tells."""

    range_m: float = param(50e3, 'Range at the start [m].', above=0.0, high=500e3)
    direction_deg: float = param(
        210.0, 'Direction at the start, from radial-out along the orbit [deg].', low=-360.0,
        high=360.0)
    range_rate_m_s: float = param(0.0, 'Range rate at the start [m/s].')
    direction_rate_deg_s: float = param(
        0.0, 'Rate of the direction at the start, against the orbital frame [deg/s].')
    out_of_plane_m: float = param(0.0, 'Position out of the orbital plane at the start [m].')
    range_sigma_m: float = param(
        0.0, 'Standard deviation of the range at the start [m].', low=0.0)
    direction_sigma_deg: float = param(
        0.0, 'Standard deviation of the direction at the start [deg].', low=0.0)

    def state(self, normals: NDArray) -> NDArray[np.float64]:
        """Return states (..., 6) for standard normal draws (..., 2)."""
        d = np.maximum(self.range_m + self.range_sigma_m*normals[..., 0], 0.1*self.range_m)
        phi = radians(self.direction_deg) + radians(self.direction_sigma_deg)*normals[..., 1]
        state = state_of(LineOfSight(d, phi, self.range_rate_m_s,
                                     radians(self.direction_rate_deg_s)))
        state[..., 2] = self.out_of_plane_m
        return state


@settings
class ArrivalParams:
    """Where the approach ends, and what must hold there."""

    range_m: float = param(50.0, 'Range at which the approach ends [m].', above=0.0)
    lost_range_factor: float = param(
        3.0, 'Multiple of the start range at which the chaser counts as lost.', above=1.0)
    hold_tolerance_m: float = param(
        0.1, 'Greatest difference of the held range from it, in the combined mode [m].', above=0.0)
    direction_tolerance_deg: float = param(
        2.0, 'Greatest difference from the direction wanted, in the combined mode [deg].',
        above=0.0)


@settings
class GuidanceParams:
    """The law of the approach, and the gains of each."""

    law: str = param('rrca', 'Law of the approach.', choices=LAWS)
    rrca: Rrca = param(LAWS['rrca'], 'Settings of rrca.')
    odrrca: Rrca = param(LAWS['odrrca'], 'Settings of odrrca.')
    combined: Rrca = param(LAWS['combined'], 'Settings of combined.')

    @property
    def selected(self) -> Rrca:
        """The law, with its gains."""
        return getattr(self, self.law)


def checked(run: Run, orbit: EllipseParams, start: StartParams, arrival: ArrivalParams) -> None:
    """
    Refuse what does not fit together.

    Raises
    ------
    ValueError
        Names the key, the value and the bound.
    """
    longest = 0.01/orbit.motion(0.0).rate
    if run.step_s > longest:
        raise BadInput(f'step_s must be at most {longest:.3g}, a hundredth of the time scale at '
                       f'perigee, where the motion is fastest, got {run.step_s}')
    if start.range_m <= arrival.range_m:
        raise BadInput(f'start.range_m must be above arrival.range_m = {arrival.range_m:g}, where '
                       f'the approach ends, got {start.range_m}')


def away() -> tuple[int, int, int]:
    """Return where an ABORT thrusts: nowhere, since away is another way on every side."""
    return 0, 0, 0
