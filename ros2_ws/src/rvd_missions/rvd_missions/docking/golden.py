"""
Attitude by the golden-section law of mission attitude_hold, in place of the three PID loops.

Each axis has a characteristic model of its own, sampled every `sample_s`. What the law wants, as a
fraction of the angular acceleration that J3 gives the nominal craft, goes into the modulator of
the attitude loops; what the modulator did since the last sample, on average, is what acted.
"""

from collections import deque

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.time_grid import whole_steps
from rvd_dynamics.onboard.control.pseudo_rate import Modulator, ModulatorParams
from rvd_dynamics.onboard.control.six_loops import SixLoops
from rvd_missions.attitude_hold.laws.golden_section import GoldenSection

SAMPLES = 3                             # that the law looks at


@settings
class GoldenLoopParams(GoldenSection):
    """The law as mission attitude_hold has it, and how often it samples."""

    sample_s: float = param(0.5, 'Time between two samples of the law [s].', above=0.0, high=10.0)


class GoldenLoops:
    """
    Six loops of which those of the attitude are golden-section laws.

    Parameters
    ----------
    loops : SixLoops
        Whose position loops are kept.
    modulator : ModulatorParams
        Of the attitude.
    acceleration : array_like, shape (3,)
        Angular acceleration about each axis while its thrusters are open [rad/s^2].
    """

    def __init__(self, settings: GoldenLoopParams, loops: SixLoops, modulator: ModulatorParams,
                 acceleration: ArrayLike, step_s: float, rows: int) -> None:
        self._loops, self._acceleration = loops, np.asarray(acceleration, dtype=float)
        self._every = whole_steps('golden_section.sample_s', settings.sample_s, step_s)
        self._law = settings.controller(settings.sample_s, (rows, 3))
        self._modulator = Modulator(modulator, step_s, (rows, 3))
        self._samples = deque([np.full((rows, 3), np.nan)]*SAMPLES, maxlen=SAMPLES)
        self._wanted, self._pushed = np.full((rows, 3), np.nan), np.zeros((rows, 3))
        self._k = 0

    def step(self, error: ArrayLike, rate: ArrayLike) -> NDArray[np.float64]:
        """Return u (..., 6) of -1, 0, 1; see `SixLoops`."""
        demand = self._loops.step(error, rate)
        if self._k % self._every == 0:
            self._sample(-np.asarray(error)[:, 3:])
        self._k += 1
        demand[:, 3:] = self._modulator.step(self._wanted)
        self._pushed = self._pushed + demand[:, 3:]
        return demand

    def _sample(self, turn: NDArray) -> None:
        """Take a sample of the attitude error (N, 3) [rad] and ask the law."""
        self._samples.appendleft(turn)
        now, *before = self._samples
        fresh = np.isfinite(before[1]) & np.isfinite(before[0]) & np.isfinite(now)
        # the first sample has none before it: the craft is taken to be at rest
        errors = (now, *(np.where(np.isfinite(e), e, now) for e in before))
        acted = self._acceleration*self._pushed/self._every
        self._wanted = self._law.wanted(errors, acted, fresh)/self._acceleration
        self._pushed = np.zeros_like(self._pushed)
