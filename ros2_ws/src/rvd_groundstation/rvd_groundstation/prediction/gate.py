"""
Which samples of the telemetry a filter takes.

Gate    a sample is an outlier, and left out as if it had been lost, where the sum of its
        innovations squared, each over its own variance, is above `gate_nis`. The variance is that
        of the prior, which grows with the samples that were lost, of the noise where the chaser
        nominally is and where the prior has it, and of what the filter leaves out: commands that
        were lost. The sum is chi-square of 6 where that is right and correlations are left aside;
        141 was the largest in 100 runs of each condition of five campaigns, with five times the
        noise assumed. From an ABORT on, whose instant is not known, the bound is STANDING times as
        wide. After `gate_patience` outliers in a row it is the filter that is wrong: it begins anew
        at the next sample, with the covariance of the start.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_groundstation.prediction.filter_params import FilterParams

Array = NDArray[np.float64]
STANDING = 100.0                        # factor of `gate_nis` once the approach is broken off


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

    def state(self) -> Any:
        """Return what `restore` needs to be as now."""
        return self.taken, self.anew, self.outliers, self._in_a_row, self._lost

    def restore(self, state: Any) -> None:
        """Be as then."""
        self.taken, self.anew, self.outliers, self._in_a_row, self._lost = state

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
