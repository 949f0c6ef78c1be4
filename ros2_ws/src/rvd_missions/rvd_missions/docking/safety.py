"""
When the craft stops, backs away, or flees: the safety strategy on board.

States are ordered, NOMINAL < HOLD < RETREAT < ABORT, and only rise, unless an operator resumes.
Source: An, Qu, Wang 2015, section 2.5, has the concept alone; rules and numbers are assumed.

    HOLD      out of the cone, attitude or rate too large, camera lost, innovations too large, or a
              force or torque that is wanted all the time: a thruster is stuck
    RETREAT   near the port and too far aside, or with a thruster that is stuck
    ABORT     too fast to stop before the faces meet
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_missions.docking.settings import compiled

NOMINAL, HOLD, RETREAT, ABORT = range(4)
NAMES = ('NOMINAL', 'HOLD', 'RETREAT', 'ABORT')


@settings
class SafetyParams:
    """Bounds of the safety strategy."""

    active: bool = param(True, 'Whether it acts.')
    cone_deg: float = param(20.0, 'Half angle of the cone from the port that must not be left, '
                            'beyond near_m [deg].', above=0.0, below=90.0)
    near_m: float = param(0.3, 'Distance up to which the bound across is constant [m].', above=0.0,
                          high=100.0)
    near_lateral_m: float = param(0.08, 'Bound across there [m].', above=0.0, high=100.0)
    stop_m: float = param(0.03, 'Distance at which the craft must be able to stop [m].', low=0.0,
                          high=10.0)
    brake_m_s2: float = param(0.02, 'Deceleration that is counted on [m/s^2].', above=0.0,
                              high=10.0)
    least_speed_m_s: float = param(0.02, 'Closing speed that is always allowed [m/s].', above=0.0,
                                   high=10.0)
    attitude_deg: float = param(5.0, 'Greatest attitude angle [deg].', above=0.0, high=180.0)
    rate_deg_s: float = param(2.0, 'Greatest rate at first [deg/s].', above=0.0, high=100.0)
    late_rate_deg_s: float = param(0.5, 'Greatest rate after settling_s [deg/s].', above=0.0,
                                   high=100.0)
    settling_s: float = param(20.0, 'Time after which that holds [s].', low=0.0, high=86400.0)
    lost_s: float = param(2.0, 'Time without a pose that is borne [s].', above=0.0, high=86400.0)
    nis: float = param(30.0, 'Normalised innovation squared of three numbers that is borne.',
                       above=0.0, high=1e9)
    nis_views: int = param(5, 'Views in a row above it that are not.', low=1, high=1000)
    steady: float = param(
        0.2, 'Mean force or torque that is commanded along an axis, as a fraction of full thrust, '
        'above which a thruster is taken to be stuck.', above=0.0, high=10.0)
    steady_s: float = param(30.0, 'Time constant of that mean [s].', above=0.0, high=86400.0)


class Safety:
    """States of N rows."""

    def __init__(self, settings: SafetyParams, step_s: float, rows: int) -> None:
        self._settings, self._step_s = settings, step_s
        self.state = np.zeros(rows, dtype=np.uint8)
        self._blind = np.zeros(rows)
        self._odd = np.zeros(rows, dtype=np.int64)
        self._mean, self._nothing = np.zeros((rows, 6)), np.zeros((rows, 6))
        s = settings
        self._bounds = (np.tan(np.radians(s.cone_deg)), s.near_m, s.near_lateral_m, s.stop_m,
                        s.brake_m_s2, s.least_speed_m_s, np.radians(s.attitude_deg), s.lost_s,
                        s.nis, s.steady)

    def resume(self, rows: NDArray[np.bool_]) -> None:
        """Go back to NOMINAL in rows (N,) that hold or retreat; an ABORT stays one."""
        back = rows & (self.state < ABORT)
        self.state = np.where(back, NOMINAL, self.state).astype(np.uint8)
        self._blind = np.where(back, 0.0, self._blind)
        self._odd = np.where(back, 0, self._odd)
        self._mean = np.where(back[:, np.newaxis], 0.0, self._mean)

    def advance(self, t: float, port: NDArray, speed: NDArray, turn: NDArray, rate: NDArray,
                nis: NDArray, pushed: NDArray | None = None) -> NDArray[np.uint8]:
        """
        Return the states after what is known at `t` [s].

        Parameters
        ----------
        port, turn, rate : ndarray, shape (N, 3)
            Port from the target's port [m], attitude error [rad] and relative rate [rad/s].
        speed : ndarray, shape (N,)
            Along x, closing positive [m/s].
        nis : ndarray, shape (N, 2)
            NaN where no pose came.
        pushed : ndarray, shape (N, 6), optional
            Force and torque commanded in the step before, as fractions; nothing by default.
        """
        s = self._settings
        rate_bound = np.radians(s.rate_deg_s if t < s.settling_s else s.late_rate_deg_s)
        pushed = self._nothing if pushed is None else pushed
        compiled().watch(self.state, self._blind, self._odd, self._mean, port, speed, turn, rate,
                         nis, pushed, self._bounds, rate_bound, s.nis_views, self._step_s,
                         self._step_s/s.steady_s, s.active)
        return self.state
