"""
Kalman filter of the relative motion: all six states are measured, with proportional noise.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Source  the paper (Zhang, Li, Tang 2014, section 2.2) asks for a filter and names none. Ours:
        measurement = state (1 + 0.01 N), so R = diag(0.01 max(|x_i|, floor_i))^2 + sigma_i^2;
        process noise Q = Gamma (3e-4 m/s^2)^2 Gamma' + floor. The floors keep R regular where
        a component is zero; they belong to the filter, and the sensor has none.

Gate    a sample is an outlier, and left out as if it had been lost, where the sum of its
        innovations squared, each over its own variance, is above `gate_nis`. The variance is that
        of the prior, which grows with the samples that were lost, of the noise where the chaser
        nominally is and where the prior has it, and of what the filter leaves out: commands that
        were lost. The sum is chi-square of 6 where that is right and correlations are left aside;
        141 was the largest in 100 runs of each condition of five campaigns, with five times the
        noise assumed. From an ABORT on, whose instant is not known, the bound is STANDING times as
        wide. After `gate_patience` outliers in a row it is the filter that is wrong: it begins anew
        at the next sample, with the covariance of the start.

`FILTERS` lists two. `scheduled` runs filterpy's filter once on the straight nominal approach
and keeps its gains, one 6 x 6 sequence for every run and row. `adaptive` keeps one filterpy
filter per row, with R from its own estimate.
"""

from functools import lru_cache
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run

Array = NDArray[np.float64]
STANDING = 100.0                        # factor of `gate_nis` once the approach is broken off
FLOOR_STEP_S = 0.5                      # [s] step to which `process_variance_floor` refers


@settings
class FilterParams:
    """Process and measurement noise assumed by the filter."""

    process_noise_m_s2: float = param(
        3e-4, 'Standard deviation of the unknown acceleration, which is constant within a step '
        '[m/s^2].', low=0.0)
    process_variance_floor: float = param(
        1e-10, 'Variance added to each position and velocity component per 0.5 s '
        '[m^2, m^2/s^2].', low=0.0)
    measurement_fraction: float = param(
        0.01, 'Standard deviation of the measurement noise of a component, as a fraction of its '
        'value.', above=0.0)
    position_floor_m: tuple = param(
        (0.25, 0.3, 0.3), 'Distance along x, y and z below which the measurement noise no longer '
        'shrinks with it [m].', low=0.0, length=3)
    velocity_floor_m_s: tuple = param(
        (0.25, 0.02, 0.02), 'Speed along x, y and z below which the measurement noise no longer '
        'shrinks with it [m/s].', low=0.0, length=3)
    position_sigma_m: float = param(
        1e-4, 'Standard deviation of the part of the position noise that does not depend on the '
        'position [m].', above=0.0)
    velocity_sigma_m_s: float = param(
        1e-5, 'Standard deviation of the part of the velocity noise that does not depend on the '
        'velocity [m/s].', above=0.0)
    start_position_sigma_m: tuple = param(
        (0.3, 0.5, 0.5), 'Standard deviations of the start position along x, y and z [m].',
        low=0.0, length=3)
    start_velocity_sigma_m_s: tuple = param(
        (0.01, 0.02, 0.02), 'Standard deviations of the start velocity along x, y and z [m/s].',
        low=0.0, length=3)
    gate_nis: float = param(
        1e3, 'Normalised innovation squared above which a sample is an outlier and left out.',
        above=0.0)
    gate_position_m: float = param(
        0.25, 'Standard deviation of what the gate allows for besides, such as commands that were '
        'lost: position [m].', low=0.0)
    gate_velocity_m_s: float = param(
        0.1, 'The same: velocity [m/s].', low=0.0)
    gate_patience: int = param(
        10, 'Outliers in a row after which the filter begins anew at the next sample.', low=1)

    def measurement_variance(self, state: Array) -> Array:
        """Return the diagonal of R (..., 6) at `state` (..., 6)."""
        floor = np.array(self.position_floor_m + self.velocity_floor_m_s)
        sigma = np.repeat([self.position_sigma_m, self.velocity_sigma_m_s], 3)
        share = self.measurement_fraction * np.maximum(np.abs(state), floor)
        return share*share + sigma*sigma

    def start_covariance(self) -> Array:
        """Return P0 (6, 6)."""
        sigma = np.array(self.start_position_sigma_m + self.start_velocity_sigma_m_s)
        return np.diag(sigma*sigma)

    def process_covariance(self, gamma: Array, step_s: float) -> Array:
        """Return Q (6, 6) of one step with the input matrix `gamma` (6, 3)."""
        floor = self.process_variance_floor * step_s / FLOOR_STEP_S
        variance = self.process_noise_m_s2 * self.process_noise_m_s2
        return variance * (gamma @ gamma.T) + floor * np.eye(6)


class Schedule(NamedTuple):
    """Gains and covariances of a filter on the nominal approach, by telemetry step."""

    gains: Array                        # (steps, 6, 6)
    covariances: Array                  # (steps, 6, 6) posterior, no sample lost
    measurement_variances: Array        # (steps, 6) diagonal of R
    priors: Array                       # (steps, 6) diagonal of the prior covariance


def gain_sequence(params: FilterParams, start: StartParams, orbit: OrbitParams, step_s: float,
                  steps: int, stands_from: int | None = None) -> Schedule:
    """
    Run filterpy's Kalman filter once on the straight nominal approach.

    The approach continues from the nominal start at the nominal velocity; sample 0 is taken at
    the start itself. Covariances do not depend on the measured values, so neither do the gains.

    Parameters
    ----------
    params : FilterParams
    start : StartParams
        Where the approach begins.
    orbit : OrbitParams
    step_s : float
        Time between two samples [s].
    steps : int
        Number of samples; a longer schedule begins with the matrices of a shorter one.
    stands_from : int, optional
        Sample from which the approach is broken off: the noise is that of the place where it was.

    Returns
    -------
    Schedule
        Read-only, and shared between equal calls.
    """
    return _schedule(params, start, step_s, orbit.mean_motion, steps, stands_from)


@lru_cache(maxsize=8)
def _schedule(params: FilterParams, start: StartParams, step_s: float, mean_motion: float,
              steps: int, stands_from: int | None) -> Schedule:
    kf = _filterpy_filter(params, start, step_s, mean_motion)
    last = steps if stands_from is None else stands_from
    time = step_s * np.minimum(np.arange(steps), last)[:, None]
    nominal = np.array(start.position_m) + time * np.array(start.velocity_m_s)
    nominal = np.hstack([nominal, np.broadcast_to(start.velocity_m_s, nominal.shape)])
    variances = params.measurement_variance(nominal)
    gains, covariances = np.empty((2, steps, 6, 6))
    priors = np.empty((steps, 6))
    for m in range(steps):
        if m > 0:
            kf.predict()
        priors[m] = np.diagonal(kf.P)
        kf.update(kf.x, R=np.diag(variances[m]))
        gains[m], covariances[m] = kf.K, kf.P
    for array in (gains, covariances, variances, priors):
        array.flags.writeable = False
    return Schedule(gains, covariances, variances, priors)


def _filterpy_filter(params: FilterParams, start: StartParams, step_s: float,
                     mean_motion: float):
    """Return a filterpy filter at the nominal start."""
    from filterpy.kalman import KalmanFilter            # slow to import: scipy comes with it
    kf = KalmanFilter(dim_x=6, dim_z=6, dim_u=3)
    kf.x = np.array(start.position_m + start.velocity_m_s)
    kf.F, kf.B = cw.transition(mean_motion, step_s), cw.input_matrix(mean_motion, step_s)
    kf.H = np.eye(6)
    kf.P, kf.Q = params.start_covariance(), params.process_covariance(kf.B, step_s)
    return kf


class TelemetryFilter(Protocol):
    """What `FILTERS` lists: made with (params, run, orbit, start, batch, track)."""

    estimate: Array                     # (..., 6) after the last `advance`, at first the start
    covariance: Array | None            # (..., 6, 6) of it, or None when not tracked
    gate: 'Gate'                        # which rows took the last sample

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray) -> Array:
        """Advance the estimate to sample m; see `ScheduledFilter.advance`."""

    def gain(self, m: int) -> Array:
        """Return the gain (..., 6, 6) that sample m had, the last one."""

    def shift(self, difference: Array) -> None:
        """Move the estimate by a difference (..., 6)."""

    def stand_still(self, m: int) -> None:
        """Be told that the approach is broken off at sample m."""


class Gate:
    """
    Which rows take a sample: not those where it is an outlier; see the head of the module.

    Attributes
    ----------
    taken : ndarray of bool, shape (...)
        Rows that have taken the last sample.
    anew : ndarray of bool, shape (...)
        Those of them that begin anew at it.
    outliers : ndarray of int, shape (...)
        Samples left out so far.
    """

    def __init__(self, params: FilterParams, batch: tuple) -> None:
        self._params, self._bound = params, params.gate_nis
        besides = np.repeat([params.gate_position_m, params.gate_velocity_m_s], 3)
        self._besides = besides*besides
        self.taken = self.anew = np.zeros(batch, dtype=bool)
        self.outliers = np.zeros(batch, dtype=np.int64)
        self._in_a_row = np.zeros(batch, dtype=np.int64)
        self._lost = np.zeros(batch, dtype=np.int64)        # samples since the last one taken

    def widen(self) -> None:
        """Allow for an ABORT that comes into force nobody knows when."""
        self._bound = STANDING * self._params.gate_nis

    def judge(self, innovation: Array, prior: Array, variance: Array, noise: Array,
              received: NDArray) -> tuple[NDArray, NDArray]:
        """
        Return the rows that take a sample, and those of them that begin anew at it.

        Parameters
        ----------
        innovation, prior : ndarray, shape (..., 6)
            Sample minus prior, 0 where none was received; and the prior itself.
        variance : ndarray, shape (..., 6)
            Of the prior, no sample lost.
        noise : ndarray, shape (..., 6)
            That the filter assumes; the place of the prior may be another one.
        received : ndarray of bool, shape (...)
        """
        grown = (1 + self._lost)[..., None]
        spread = (variance*grown*grown + (noise + self._besides)
                  + self._params.measurement_variance(prior))
        share = innovation*innovation/spread
        nis = (share[..., 0] + share[..., 1] + share[..., 2] + share[..., 3] + share[..., 4]
               + share[..., 5])
        good = nis <= self._bound               # not where it is infinite or NaN
        if good.all():                          # as nearly always
            self.taken, self.anew = received, np.zeros_like(received)
            self._in_a_row = np.where(received, 0, self._in_a_row)
        else:
            out = received & ~good
            self._in_a_row = np.where(received, np.where(out, self._in_a_row + 1, 0),
                                      self._in_a_row)
            self.anew = out & (self._in_a_row > self._params.gate_patience)
            self._in_a_row = np.where(self.anew, 0, self._in_a_row)
            self.taken = received & (good | self.anew)
            self.outliers = self.outliers + (out & ~self.anew)
        self._lost = np.where(self.taken, 0, self._lost + 1)
        return self.taken, self.anew


class ScheduledFilter:
    """The filter with the gains of `gain_sequence`; one line serves (6,) and (N, 6)."""

    def __init__(self, params: FilterParams, run: Run, orbit: OrbitParams, start: StartParams,
                 batch: tuple = (), track: bool = True) -> None:
        """
        Start at the nominal state.

        `batch` is the shape of the leading axes. With `track` the covariance of each row is
        followed through the samples that it lost; the estimate does not need it.
        """
        n, dt = orbit.mean_motion, run.step_s
        self._phi, self._gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
        self._sequence = (params, start, orbit, dt, run.last_step + 1)
        self._schedule = gain_sequence(*self._sequence)
        self._params, self._broken_off = params, False
        self.estimate = np.tile(start.state, (*batch, 1))
        self.covariance = np.tile(params.start_covariance(), (*batch, 1, 1)) if track else None
        self._process = params.process_covariance(self._gamma, dt)
        self.gate = Gate(params, batch)

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray) -> Array:
        """
        Advance the estimate to sample `m` and return it.

        Parameters
        ----------
        m : int
            Telemetry step: 0, 1, 2, ... in order.
        accel : ndarray, shape (..., 3)
            Commanded acceleration that acted on [m-1, m) [m/s^2]; not used at 0.
        measured : ndarray, shape (..., 6)
            Sample m; anything where `received` is false.
        received : ndarray of bool, shape (...)
            Rows that have the sample; the others keep the time update.

        Returns
        -------
        ndarray, shape (..., 6)
        """
        prior = self.estimate
        if m > 0:
            prior = cw.step(prior, accel, self._phi, self._gamma)
        innovation = np.where(received[..., None], measured - prior, 0.0)
        taken, anew = self.gate.judge(innovation, prior, self._schedule.priors[m],
                                       self._schedule.measurement_variances[m], received)
        if taken is not received:
            innovation = np.where(taken[..., None], innovation, 0.0)
        self.estimate = prior + cw.product(self._schedule.gains[m], innovation)
        if self.covariance is not None:
            self.covariance = self._next_covariance(m, taken)
        if anew.any():
            self.estimate = np.where(anew[..., None], measured, self.estimate)
            if self.covariance is not None:
                self.covariance = np.where(anew[..., None, None],
                                           self._params.start_covariance(), self.covariance)
        return self.estimate

    def gain(self, m: int) -> Array:
        """Return the gain (6, 6) of sample m."""
        return self._schedule.gains[m]

    def shift(self, difference: Array) -> None:
        """Move the estimate by a difference (..., 6)."""
        self.estimate = self.estimate + difference

    def stand_still(self, m: int) -> None:
        """Use gains for a chaser that stays about where it nominally is at sample m."""
        self._schedule, self._broken_off = gain_sequence(*self._sequence, stands_from=m), True
        self.gate.widen()

    def _next_covariance(self, m: int, received: NDArray) -> Array:
        """
        Return the covariance by Joseph's form, which is correct for any gain.

        The noise is that of the nominal place, and of the estimated one in an approach broken off.
        """
        p = self.covariance
        if m > 0:
            p = self._phi @ p @ self._phi.T + self._process
        gain = self._schedule.gains[m]
        keep = np.eye(6) - gain
        variances = self._schedule.measurement_variances[m]
        if self._broken_off:
            variances = self._params.measurement_variance(self.estimate)[..., None, :]
        noise = (gain * variances) @ gain.T
        return np.where(received[..., None, None], keep @ p @ keep.T + noise, p)


class AdaptiveFilter:
    """One filterpy filter per row with R from its own estimate: for study, slow in a batch."""

    def __init__(self, params: FilterParams, run: Run, orbit: OrbitParams, start: StartParams,
                 batch: tuple = (), track: bool = True) -> None:
        """Start as `ScheduledFilter` does; the covariance costs nothing here, `track` or not."""
        self._params = params
        self._filters = np.empty(batch, dtype=object)
        for row in np.ndindex(batch):
            self._filters[row] = _filterpy_filter(params, start, run.step_s, orbit.mean_motion)
        self.gate = Gate(params, batch)
        self._read()

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray) -> Array:
        """Advance the estimate to sample `m`; arguments as `ScheduledFilter.advance`."""
        rows = list(np.ndindex(self._filters.shape))
        for row in rows:
            if m > 0:
                self._filters[row].predict(u=accel[row])
        prior = self._read()
        innovation = np.where(received[..., None], measured - prior, 0.0)
        variance = np.diagonal(self.covariance, axis1=-2, axis2=-1)
        taken, anew = self.gate.judge(innovation, prior, variance, 0.0, received)
        for row in rows:
            kf = self._filters[row]
            if anew[row]:
                kf.x, kf.P = np.array(measured[row]), self._params.start_covariance()
            elif taken[row]:
                kf.update(measured[row], R=np.diag(self._params.measurement_variance(kf.x)))
        return self._read()

    def gain(self, m: int) -> Array:
        """Return the gains (..., 6, 6) of the last sample."""
        return np.array([kf.K for kf in self._filters.flat]).reshape(*self._filters.shape, 6, 6)

    def shift(self, difference: Array) -> None:
        """Move the estimates by a difference (..., 6)."""
        for row in np.ndindex(self._filters.shape):
            self._filters[row].x = self._filters[row].x + difference[row]
        self._read()

    def stand_still(self, m: int) -> None:
        """Have only the gate to change: the gains follow the estimate."""
        self.gate.widen()

    def _read(self) -> Array:
        batch = self._filters.shape
        rows = list(self._filters.flat)
        self.estimate = np.array([kf.x for kf in rows]).reshape(*batch, 6)
        self.covariance = np.array([kf.P for kf in rows]).reshape(*batch, 6, 6)
        return self.estimate


FILTERS = {'scheduled': ScheduledFilter, 'adaptive': AdaptiveFilter}
