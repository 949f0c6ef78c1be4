"""
Golden-section adaptive law on a characteristic model, with a logic derivative.

    v(k) = -(l1 f1 e(k) + l2 f2 e(k-1)) / (b + lambda),   l1 = 0.382, l2 = 0.618
    u(k) = v(k)/dt^2 - kd(k) (e(k) - e(k-1))/dt,   kd = derivative sqrt((|e(k)| + |e(k-1)|) / 1 deg)

Source  Xie Yongchun, He Yingzi, Wu Hongxin, of which only fragments are at hand: the form of the
        law is from general knowledge of the method, that of kd is an assumption; what the paper's
        second number of the logic derivative, ed(k), does is lost with its formula.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_missions.attitude_hold.laws.characteristic_model import Identifier

L2 = float((np.sqrt(5.0) - 1.0) / 2.0)          # 0.618..., l1 + l2 = 1 and l2^2 = l1
L1 = 1.0 - L2
DEG = float(np.degrees(1.0))                    # [deg/rad]


@settings
class GoldenSection:
    """Adaptive golden-section law on an identified characteristic model."""

    softening: float = param(
        0.001, 'Lambda: what is added to the gain of the model before the law divides by it, as a '
        'fraction of the nominal gain.', low=0.0, high=100.0)
    derivative_per_s: float = param(
        0.015, 'Gain of the logic derivative at 1 deg of recent error [1/s].', low=0.0, high=100.0)
    adapts: bool = param(
        True, 'Whether the model is identified on line; else it keeps its first parameters.')
    forgetting: float = param(
        0.901, 'Forgetting factor of the least squares.', low=0.5, high=1.0)
    dead_zone_deg: float = param(
        0.0139, 'Residual of the model within which nothing is learnt [deg].', low=0.0, high=10.0)
    f_variance: float = param(
        2.2e-5, 'Variance of f1 and f2 at the start, for a residual of 1 deg.', above=0.0, high=1e6)
    b_variance: float = param(
        2080.0, 'Variance of the gain at the start, for a residual of 1 deg.', above=0.0, high=1e6)
    lowest_gain: float = param(
        0.376, 'Least gain of the model, as a fraction of the nominal one.', above=0.0, high=1.0)
    highest_gain: float = param(
        10.0, 'Greatest gain of the model, as a fraction of the nominal one.', low=1.0, high=1e3)

    def __post_init__(self) -> None:
        require(self.lowest_gain < self.highest_gain, 'lowest_gain',
                f'be below highest_gain, {self.highest_gain:g}', self.lowest_gain)

    def controller(self, step_s: float, batch: tuple) -> 'Golden':
        """Return the law with its memory, for a batch of runs sampled every `step_s`."""
        return Golden(self, step_s, batch)


class Golden:
    """The law at work."""

    def __init__(self, law: GoldenSection, step_s: float, batch: tuple) -> None:
        self._law, self._step_s = law, step_s
        self._model = Identifier(
            law.forgetting, law.dead_zone_deg, (law.f_variance, law.b_variance),
            (law.lowest_gain, law.highest_gain), batch)

    def wanted(self, errors: tuple, acted: NDArray, fresh: NDArray) -> NDArray[np.float64]:
        """Return the wanted acceleration (...) [rad/s^2]; see `laws.Controller`."""
        now, before, first = (DEG*error for error in errors)
        square = self._step_s*self._step_s
        if self._law.adapts:
            self._model.learn(now, (before, first, square*DEG*acted), fresh)
        f1, f2, b = self._model.estimate
        golden = (L1*f1*now + L2*f2*before) / ((b + self._law.softening)*square)
        damping = self._law.derivative_per_s*np.sqrt(np.abs(now) + np.abs(before))
        return -(golden + damping*((now - before)/self._step_s)) / DEG

    @property
    def inside(self) -> Mapping[str, NDArray]:
        """What the law believes: f1, f2 and the gain b, each (...)."""
        return self._model.estimate._asdict()
