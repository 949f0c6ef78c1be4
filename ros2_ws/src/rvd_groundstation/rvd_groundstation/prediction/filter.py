"""
Kalman filter of the relative motion: all six states are measured, with proportional noise.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Source  the paper (Zhang, Li, Tang 2014, section 2.2) asks for a filter and names none. Ours:
        measurement = state (1 + 0.01 N), so R = diag(0.01 max(|x_i|, floor_i))^2 + sigma_i^2;
        process noise Q = Gamma (3e-4 m/s^2)^2 Gamma' + floor. The floors keep R regular where
        a component is zero; they belong to the filter, and the sensor has none.

`FILTERS` lists two. `scheduled` runs filterpy's filter once on the straight nominal approach
and keeps its gains, one 6 x 6 sequence for every run and row. `adaptive` keeps one filterpy
filter per row, with R from its own estimate.
"""

from functools import lru_cache
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_dynamics.diagram.run import Run
from rvd_groundstation.prediction.filter_params import FilterParams
from rvd_groundstation.prediction.gate import Gate

Array = NDArray[np.float64]


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

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray,
                spread: Array | None = None) -> Array:
        """Advance the estimate to sample m; see `ScheduledFilter.advance`."""

    def gain(self, m: int) -> Array:
        """Return the gain (..., 6, 6) that sample m had, the last one."""

    def state(self) -> Any:
        """Return what `restore` needs to be as now."""

    def restore(self, state: Any) -> None:
        """Be as then."""

    def stand_still(self, m: int) -> None:
        """Be told that the approach is broken off at sample m."""


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

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray,
                spread: Array | None = None) -> Array:
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
        spread : ndarray, shape (..., 4), optional
            Covariance of `accel`: xx, yy, zz and xy [m^2/s^4]; the learned filter alone uses it.

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

    def state(self) -> Any:
        """Return what `restore` needs to be as now."""
        return self.estimate, self.covariance, self.gate.state()

    def restore(self, state: Any) -> None:
        """Be as then."""
        self.estimate, self.covariance, gate = state
        self.gate.restore(gate)

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

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray,
                spread: Array | None = None) -> Array:
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

    def state(self) -> Any:
        """Return what `restore` needs to be as now."""
        return [(kf.x, kf.P) for kf in self._filters.flat], self.gate.state()

    def restore(self, state: Any) -> None:
        """Be as then."""
        rows, gate = state
        for kf, (x, p) in zip(self._filters.flat, rows):
            kf.x, kf.P = x, p
        self.gate.restore(gate)
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


def _learned(*args: Any, **kwargs: Any) -> TelemetryFilter:
    from rvd_groundstation.prediction.learned import LearnedFilter
    return LearnedFilter(*args, **kwargs)


FILTERS = {'learned': _learned, 'scheduled': ScheduledFilter, 'adaptive': AdaptiveFilter}
