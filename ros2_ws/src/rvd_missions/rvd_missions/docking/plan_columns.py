"""
How far flown closings stay from the limits of their plans: columns of a campaign's table.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.run import Run
from rvd_missions.docking.planning import Preparation, TOUCHING_M

NEAR_M = 0.3                            # [m] nearer than this the dead band is wider than the cone
LOOKED_AT_S = 0.1                       # [s]


class FlownMargins:
    """Least margins of N rows, looked at ten times a second; negative: beyond the limit."""

    def __init__(self, preparation: Preparation, run: Run, batch: tuple) -> None:
        self._preparation, self._closing = preparation, preparation.closing
        self._slope = float(np.tan(np.radians(self._closing.view_half_angle_deg)))
        self._every = max(round(LOOKED_AT_S/run.step_s), 1)
        self._speed = np.zeros(batch)
        self._cone, self._nearest = np.full((2, *batch), np.inf)

    def step(self, k: int, truth: Any, live: NDArray[np.bool_]) -> None:
        """Take the truth of step k, of the rows that are still flying."""
        if k % self._every:
            return
        r, v = truth.position, truth.velocity
        across = np.hypot(r[..., 1], r[..., 2])
        gap = -r[..., 0] - TOUCHING_M
        cone = np.where(gap > NEAR_M, self._slope*gap - across, np.inf)
        for name, value, of in (
                ('_speed', np.sqrt((v*v).sum(axis=-1)), np.fmax), ('_cone', cone, np.fmin),
                ('_nearest', np.sqrt((r*r).sum(axis=-1)), np.fmin)):
            before = getattr(self, name)
            setattr(self, name, np.where(live, of(before, value), before))

    def table(self) -> dict[str, NDArray]:
        """Return the columns of N runs; duration and cost of the plan are NaN if there is none."""
        made, shape = self._preparation, self._speed.shape
        plan = (np.nan, np.nan)
        if made.on_ground:
            plan = made.nominal.duration_s, made.nominal.cost
        return {'planned_s': np.full(shape, plan[0]), 'planned_cost': np.full(shape, plan[1]),
                'speed_margin_m_s': self._closing.max_speed_m_s - self._speed,
                'cone_margin_m': self._cone,
                'keep_out_margin_m': self._nearest - self._closing.keep_out_radius_m}
