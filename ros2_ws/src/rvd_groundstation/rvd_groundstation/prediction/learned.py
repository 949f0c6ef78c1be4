"""
Kalman filter of the relative motion that learns the sensor's noise and knows of lost commands.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Model   the linear model of the motion (`cw`), in which thrust is known but for a fraction of it,
        and an unknown acceleration of `unmodelled_m_s2` acts besides.
Noise   measurement = state (1 + f N), so the variance of a component is h (f^2 E[x^2] + sigma^2)
        with E[x^2] = x^2 + P: no floor is needed where a component is zero. The covariance is
        P = A + h B, B being what comes of the sensor: it grows with h also where it was made before
        h was known. Two innovations that follow each other differ by A + A' + h (B + R + B' + R'),
        which says h; each counts by the square of how much of that is the sensor's.
Unknown what acts on the craft without anybody knowing it makes innovations agree with each other;
        those of a filter that is right do not. As long as they do, an unknown acceleration grows.
Thrust  what acted is random where nobody has told: mean and variance come from the predictor.

Source  innovations: Mehra, IEEE Trans. Automatic Control 15(2), 1970; the moment estimate is ours.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.prediction.filter_params import FilterParams
from rvd_groundstation.prediction.gate import STANDING

Array = NDArray[np.float64]
FACTOR = (0.04, 400.0)                  # bounds of h: a fifth of the noise assumed, and 20 times it


class LearnedGate:
    """Which rows take a sample, as `gate.Gate` says; filled by the compiled update."""

    def __init__(self, batch: tuple) -> None:
        rows = int(np.prod(batch))
        self._batch = batch
        self.rows = [np.zeros(rows, dtype=bool), np.zeros(rows, dtype=bool)]
        self.in_a_row, self.counted = np.zeros((2, rows), dtype=np.int64)

    @property
    def taken(self) -> NDArray[np.bool_]:
        """Rows that have taken the last sample (...)."""
        return self.rows[0].reshape(self._batch)

    @property
    def anew(self) -> NDArray[np.bool_]:
        """Those of them that begin anew at it (...)."""
        return self.rows[1].reshape(self._batch)

    @property
    def outliers(self) -> NDArray[np.int64]:
        """Samples left out so far (...)."""
        return self.counted.reshape(self._batch)


class LearnedFilter:
    """The filter; a row has the same bits alone and in any batch."""

    def __init__(self, params: FilterParams, run: Run, orbit: OrbitParams, start: StartParams,
                 batch: tuple = (), track: bool = True) -> None:
        """
        Start at the nominal state.

        `batch` is the shape of the leading axes. The covariance is needed for the gains; `track`
        says whether anybody looks at it.
        """
        from rvd_groundstation.prediction import learned_compiled   # takes a second
        self._rows, self._batch = int(np.prod(batch)), batch
        self._compiled, self._params, self._track = learned_compiled, params, track
        self._motion = self._by_block(cw.transition(orbit.mean_motion, run.step_s),
                                      cw.input_matrix(orbit.mean_motion, run.step_s))
        self._no_motion = self._by_block(np.eye(6), np.zeros((6, 3)))
        self.estimate = np.tile(start.state, (*batch, 1))
        self._state = self._first(start.state)
        self._left = np.zeros((self._rows if track else 0, 6, 6))
        self._sigma = np.repeat([params.position_sigma_m, params.velocity_sigma_m_s], 3)**2
        self._besides = np.repeat([params.gate_position_m, params.gate_velocity_m_s], 3)**2
        self._sigma, self._besides = (v[self._order] for v in (self._sigma, self._besides))
        self._bound, self._share = params.gate_nis, params.measurement_fraction**2
        self.gate = LearnedGate(batch)
        none = np.zeros(0, dtype=np.int64)      # compiled or loaded here, not in the first step
        self._update(self._state[:0], np.zeros((0, 3)), np.zeros((0, 4)), np.zeros((0, 6)),
                     none > 0, self._motion, none, none, none > 0, none > 0, np.zeros((0, 6)))

    def _by_block(self, phi: Array, gamma: Array) -> tuple[Array, Array, Array]:
        """Return a motion in the plane, out of it, and what an acceleration adds, flat."""
        plane, normal = self._order[:4], self._order[4:]
        return (phi[np.ix_(plane, plane)].ravel(), phi[np.ix_(normal, normal)].ravel(),
                np.concatenate([gamma[plane, :2].ravel(), gamma[normal, 2]]))

    def _first(self, start: Array) -> Array:
        """Return what all rows are before the first sample, (chunks, KEPT*LANES)."""
        at, covariance = self._compiled, self._params.start_covariance()
        row = np.zeros(at.KEPT)
        for base, places in ((at.KNOWN, self._order[:4]), (at.KNOWN_NORMAL, self._order[4:])):
            row[base:base + len(places)**2] = covariance[np.ix_(places, places)].ravel()
        row[at.ESTIMATE:at.ESTIMATE + 6] = start[self._order]
        row[at.SUM] = row[at.WEIGHT] = self._params.noise_weight        # a factor of 1
        row[at.UNKNOWN] = self._params.unmodelled_m_s2**2
        return np.tile(np.repeat(row, at.LANES), (-(-self._rows//at.LANES), 1))

    def advance(self, m: int, accel: Array, measured: Array, received: NDArray,
                spread: Array | None = None) -> Array:
        """
        Advance the estimate to sample m; as `ScheduledFilter.advance`.

        `spread` (..., 4) is the covariance of `accel` besides the thrust's own noise: xx, yy, zz
        and xy [m^2/s^4].
        """
        rows, motion, variance = self._rows, self._no_motion, np.zeros((self._rows, 4))
        if m > 0:
            motion = self._motion
            executed = (self._params.execution_fraction * accel).reshape(rows, 3)
            variance[:, :3] = executed*executed
            if spread is not None:
                variance += spread.reshape(rows, 4)
        estimate, flat = np.empty((rows, 6)), np.ascontiguousarray
        self._update(self._state, flat(np.reshape(accel, (rows, 3))), variance,
                     flat(measured.reshape(rows, 6)), flat(np.reshape(received, rows)), motion,
                     self.gate.in_a_row, self.gate.counted, *self.gate.rows, estimate)
        self.estimate = estimate.reshape(*self._batch, 6)
        return self.estimate

    def _update(self, state: Array, accel: Array, variance: Array, measured: Array,
                received: NDArray, motion: tuple[Array, Array, Array], *filled: NDArray) -> None:
        params = self._params
        self._compiled.update(state, accel, variance, measured, received, *motion, self._share,
                              self._sigma, *FACTOR, params.unmodelled_m_s2**2, self._bound,
                              self._besides, params.gate_patience, *filled, self._left)

    @property
    def _order(self) -> NDArray:
        return np.array(self._compiled.ORDER)

    def _kept(self, first: int, count: int = 1) -> Array:
        """Return numbers of each row, (N, count)."""
        of_chunk = self._state.reshape(len(self._state), -1, self._compiled.LANES)
        return np.swapaxes(of_chunk[:, first:first + count], 1, 2).reshape(-1, count)[:self._rows]

    @property
    def factor(self) -> Array:
        """How noisy the sensor is: variance over the one assumed (...)."""
        said, weight = self._kept(self._compiled.SUM, 2).T
        return np.clip(said/weight, *FACTOR).reshape(self._batch)

    @property
    def unknown(self) -> Array:
        """Variance of the acceleration that nobody knows of (...) [m^2/s^4]."""
        return self._kept(self._compiled.UNKNOWN).reshape(self._batch)

    @property
    def covariance(self) -> Array | None:
        """Covariance of the estimate (..., 6, 6); None when not tracked."""
        if not self._track:
            return None
        known, sensed = (self._kept(first, 20)
                         for first in (self._compiled.KNOWN, self._compiled.SENSED))
        both = known + self.factor.reshape(-1, 1)*sensed
        covariance = np.zeros((self._rows, 6, 6))
        for places, flat in ((self._order[:4], both[:, :16]), (self._order[4:], both[:, 16:])):
            covariance[:, places[:, None], places] = flat.reshape(-1, len(places), len(places))
        return covariance.reshape(*self._batch, 6, 6)

    def gain(self, m: int) -> Array:
        """Return the gain (..., 6, 6) that sample m had, the last one."""
        return np.eye(6) - self._left.reshape(*self._batch, 6, 6)

    def state(self) -> Any:
        """Return what `restore` needs to be as now."""
        return self.estimate, [array.copy() for array in self._changing]

    def restore(self, state: Any) -> None:
        """Be as then."""
        self.estimate, kept = state
        for array, then in zip(self._changing, kept):
            array[...] = then

    @property
    def _changing(self) -> list[NDArray]:
        return [self._state, self.gate.in_a_row, self.gate.counted, *self.gate.rows]

    def stand_still(self, m: int) -> None:
        """Have only the gate to change: the gains follow the estimate."""
        self._bound = STANDING * self._params.gate_nis
