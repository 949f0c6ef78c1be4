"""
Columns of a campaign's table: where the gripper stood, how near it came, when and how it arrived.

All from the truth, with what the gripper did and followed.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.run import Run
from rvd_missions.tether.settings import ApproachParams
from rvd_missions.tether_delay.signals import ARRIVED, BRAKING, FLYING, STANDING


class Columns:
    """Follows the runs."""

    def __init__(self, run: Run, approach: ApproachParams, batch: tuple) -> None:
        self._h, self._goal = run.step_s, np.array([approach.final_range_m, 0.0, 0.0])
        names = ('released_s', 'told_range_m', 'stood_range_m', 'arrived_s', 'miss_m', 'joined_m')
        self._values = {name: np.full(batch, np.nan) for name in names}
        self._closest, self._plans = np.full(batch, np.inf), np.zeros(batch, dtype=np.int64)
        self._before, self._plan = np.zeros((2, *batch), dtype=np.uint8)

    def step(self, k: int, truth: Any, craft: Any, tracking: Any) -> dict[str, Any]:
        """Take step k."""
        v, doing, t = self._values, craft.doing, truth.target
        far = np.sqrt((t*t).sum(axis=-1))
        self._closest = np.fmin(self._closest, far)
        flies, flew = doing == FLYING, self._before == FLYING
        joins = flies & flew & (craft.plan != self._plan)       # a plan made in flight begins
        begun = flies & ~flew
        self._plans = self._plans + (begun | joins)
        off = t - self._goal
        a, b = tracking.planned[..., 1], tracking.planned[..., 2]
        beside = t - tracking.range[..., np.newaxis]*np.stack(
            [np.cos(b)*np.cos(a), np.cos(b)*np.sin(a), np.sin(b)], axis=-1)
        for name, now, value in (
                ('released_s', begun, k*self._h),
                ('told_range_m', (doing == BRAKING) & (self._before == FLYING), far),
                ('stood_range_m', (doing == STANDING) & (self._before == BRAKING), far),
                ('arrived_s', (doing == ARRIVED) & (self._before != ARRIVED), k*self._h),
                ('miss_m', (doing == ARRIVED) & (self._before != ARRIVED),
                 np.sqrt((off*off).sum(axis=-1))),
                ('joined_m', joins, np.sqrt((beside*beside).sum(axis=-1)))):
            v[name] = np.where(now & np.isnan(v[name]), value, v[name])
        self._before, self._plan = doing, craft.plan
        return {}

    def table(self, judge: Any, end_step: NDArray[np.int64]) -> dict[str, NDArray]:
        """Return the columns of N runs."""
        return {**self._values, 'closest_m': self._closest, 'plans': self._plans}
