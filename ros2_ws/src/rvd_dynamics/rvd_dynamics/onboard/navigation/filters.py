"""
Inertial and visual navigation: an attitude EKF and a position KF for craft relative to target.

Frames   target axes, which are taken to be those of LVLH (the target is held there); craft axes.
         Quaternion (x, y, z, w), craft relative to target: v_target = R(q) v_craft.
Attitude predicted by the gyro less its bias; error dq24' = -[w]x dq24 - db/2 - v_g/2, db' = v_b,
         measured dq24 of q^-1 (x) q_camera. Paper, eq. 11 to 13.
Position x = (r, V, d): r' = V, V' = N r + M V + R (f - d), N = diag(0, -n^2, 3n^2),
         M = [[0, 0, 2n], [0, 0, 0], [-2n, 0, 0]]; measured: the port in craft axes, R^T (p - r), so
         H = [-R^T, 0, 0]. Paper, eq. 14 and 15, which print H = [-R, 0, 0]. The attitude's own
         uncertainty counts in what is measured, by the distance of the port.
Latency  the camera shows what was; the filters stand at that instant, and their means are carried
         to the present by the samples since. So nothing is stitched in late, and NIS is exact.

Improvements of the paper, each with its switch:
  predictor      `euler` eq. 17; `frozen` eq. 18 and 19, both slopes with the input before;
                 `newest`, the second with the newest input. With an integrating gyro the input of
                 the step itself counts from the start, and the last two are one.
  bias_feedback  alpha of eq. 20, put into the estimate, b <- b - (alpha/2) T z; or, with
                 `feedback_in: covariance`, into the transition of the covariance alone.
  norm           `projection` eq. 21 to 27 with W = 1, `normalised`, or `none`.

Compiled; filterpy is the authority that the tests compare with (one predict of its objects takes
longer than all of this).
"""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.news import begun_anew, News
from rvd_dynamics.diagram.params import param, settings

Array = NDArray[np.float64]
PREDICTORS = ('euler', 'frozen', 'newest')
NORMS = ('none', 'normalised', 'projection')
GYROS = ('sampled', 'integrating')
DEG = float(np.radians(1.0))


@settings
class FilterParams:
    """What the filters assume, and the three improvements."""

    predictor: str = param('newest', 'How the attitude is predicted.', choices=PREDICTORS)
    bias_feedback_per_s2: float = param(
        0.0, 'Feedback of the attitude\'s innovation to the gyro\'s bias, alpha [1/s^2].', low=0.0,
        high=10.0)
    feedback_in: str = param('estimate', 'Where alpha stands.', choices=('estimate', 'covariance'))
    norm: str = param('projection', 'How the quaternion keeps its length.', choices=NORMS)
    gyro: str = param('integrating', 'What the gyro is taken to give.', choices=GYROS)
    gyro_sigma_deg_s: float = param(
        0.005, 'Assumed noise of a sample of the gyro [deg/s].', low=0.0, high=10.0)
    gyro_walk_rad_s: float = param(
        1e-6, 'Assumed walk of its bias in a second [rad/s].', low=0.0, high=1.0)
    gyro_bias_deg_h: float = param(
        5.0, 'Assumed deviation of its bias at the start [deg/h].', above=0.0, high=1e6)
    accel_sigma_m_s2: float = param(
        1.2e-3, 'Assumed noise of a sample of the accelerometer [m/s^2].', above=0.0, high=10.0)
    accel_walk_m_s2: float = param(
        1e-6, 'Assumed walk of its bias in a second [m/s^2].', low=0.0, high=1.0)
    accel_bias_m_s2: float = param(
        3e-4, 'Assumed deviation of its bias at the start [m/s^2].', above=0.0, high=10.0)
    speed_sigma_m_s: float = param(
        0.02, 'Assumed deviation of the velocity at the start from zero [m/s].', above=0.0,
        high=100.0)
    gate_nis: float = param(
        1e4, 'Normalised innovation squared, of attitude or position, above which a view is an '
        'outlier and left out.', above=0.0)
    gate_patience: int = param(
        10, 'Outliers in a row after which the filters begin anew at the next view.', low=1)


class Estimate(NamedTuple):
    """Where the craft is now; rows N, NaN before the first pose."""

    attitude: Array             # (N, 4) relative to the target
    rate: Array                 # (N, 3) angular velocity, inertial, craft axes [rad/s]
    position: Array             # (N, 3) of its centre from the target's, target axes [m]
    velocity: Array             # (N, 3) [m/s]
    nis: Array                  # (N, 2) of attitude and position, NaN between measurements


class Navigation:
    """
    Filters of N rows.

    Parameters
    ----------
    settings : FilterParams
    step_s : float
        Period of the samples [s].
    latency : int
        Steps by which the camera is late.
    fusion_s : float
        Period of the camera [s]: T of the feedback to the bias.
    mean_motion : float
        Of the target's orbit [rad/s].
    port : array_like, shape (3,)
        Place of the port in target axes [m].
    """

    def __init__(self, settings: FilterParams, step_s: float, latency: int, fusion_s: float,
                 mean_motion: float, port: ArrayLike, rows: int) -> None:
        s = settings
        alpha = s.bias_feedback_per_s2
        inside = s.feedback_in == 'estimate'
        self._settings = (
            step_s, float(mean_motion), PREDICTORS.index(s.predictor), NORMS.index(s.norm),
            s.gyro == 'integrating', 0.5*alpha*fusion_s if inside else 0.0,
            0.0 if inside else alpha, s.gate_nis, s.gate_patience)
        self.missed = np.zeros(rows, dtype=np.int64)        # outliers in a row
        self._patience, self._anew = s.gate_patience, False
        self._noises = ((0.5*step_s*DEG*s.gyro_sigma_deg_s)**2, step_s*s.gyro_walk_rad_s**2,
                        (step_s*s.accel_sigma_m_s2)**2, step_s*s.accel_walk_m_s2**2)
        self._start = np.array([(DEG/3600.0*s.gyro_bias_deg_h)**2, s.speed_sigma_m_s**2,
                                s.accel_bias_m_s2**2])
        self._port = np.array(port, dtype=float)
        self.attitude, self.bias = np.zeros((rows, 4)), np.zeros((rows, 3))
        self.attitude_covariance = np.zeros((rows, 6, 6))
        self.state, self.covariance = np.zeros((rows, 9)), np.zeros((rows, 9, 9))
        self.known = np.zeros(rows, dtype=bool)
        self._samples = np.zeros((rows, latency + 2, 6))
        self._output = np.full((rows, 16), np.nan)
        self._nothing = (np.full((rows, 3), np.nan), np.full((rows, 4), np.nan),
                         np.full((rows, 6, 6), np.nan))

    def step(self, rate: ArrayLike, force: ArrayLike, pose: tuple | None = None) -> Estimate:
        """
        Take a sample of the inertial unit (N, 3) each, and what the camera saw `latency` ago.

        `pose`: place (N, 3), attitude (N, 4) and covariance (N, 6, 6) as `vision.Pose`, rows NaN
        where nothing was seen; None if the camera shows nothing at this step.
        """
        self._samples[:, :-1] = self._samples[:, 1:]
        self._samples[:, -1, :3], self._samples[:, -1, 3:] = rate, force
        place, turn, covariance = self._nothing if pose is None else (
            np.array(part, dtype=float, order='C') for part in pose)  # read-only: compiled again
        due = self.missed >= self._patience
        nis = _compiled().advance(
            self.attitude, self.bias, self.attitude_covariance, self.state, self.covariance,
            self.known, self.missed, self._samples, place, turn, covariance, self._settings,
            self._noises, self._start, self._port, self._output)
        self._anew = bool((due & (self.missed == 0)).any())
        out = self._output
        return Estimate(out[:, 0:4].copy(), out[:, 4:7].copy(), out[:, 7:10].copy(),
                        out[:, 10:13].copy(), nis)

    def news(self) -> News:
        """Return whether the filters of any row have begun anew in the last step."""
        return [begun_anew('views of the camera', self._patience)] if self._anew else []

    def sigma(self) -> Array:
        """
        Return standard deviations (N, 9): position [m], velocity [m/s], turn of the craft [rad].

        They are those at the instant of the newest view, `latency` steps ago; NaN before the first.
        """
        # dq is half of the turn
        turn = 2.0*np.sqrt(np.diagonal(self.attitude_covariance, 0, 1, 2)[:, :3])
        moved = np.sqrt(np.diagonal(self.covariance, 0, 1, 2)[:, :6])
        return np.where(self.known[:, None], np.concatenate([moved, turn], axis=-1), np.nan)


def projected(x: ArrayLike, weight: ArrayLike) -> Array:
    """
    Return a state (q, b) (7,) moved onto the unit norm of q, least in (x - x^)^T W (x - x^).

    The constraint is linearised at q: D = [2 q^T, 0], d = 1 + |q|^2. With W = 1 this scales q by
    (|q|^2 + 1)/(2 |q|^2), one step of Newton's method for the length. Paper, eq. 21 to 27.

    Raises
    ------
    ValueError
        If W^-1 has no part along q: a covariance of small turns, which is tangent to the norm.
    """
    x, inverse = np.asarray(x, dtype=float), np.linalg.inv(np.asarray(weight, dtype=float))
    row = np.concatenate([2.0*x[:4], np.zeros(3)])
    along = row @ inverse @ row
    if not along > 0.0:
        raise ValueError(f'weight leaves no freedom along q: D W^-1 D^T is {along:g}')
    return x - inverse @ row*(row @ x - (1.0 + x[:4] @ x[:4]))/along


@lru_cache(maxsize=1)
def _compiled() -> Any:
    from rvd_dynamics.onboard.navigation import filters_compiled        # numba
    return filters_compiled
