"""
Columns of a campaign's table beyond the measures: alarms, switches of the engines, speed swings.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray


class Columns:
    """Counts in the runs under way."""

    def __init__(self, batch: tuple) -> None:
        self._ended = np.zeros(batch, dtype=bool)
        self._alarms, self._switches = np.zeros((2, *batch), dtype=np.int64)
        self._alarm_steps = np.zeros(batch, dtype=np.int64)
        self._on: NDArray | None = None
        self._engines = np.zeros((3, *batch))
        self._swing = np.zeros(batch)
        self._speed: NDArray | None = None
        self._first = self._highest = np.zeros(batch)

    def step(self, k: int, truth: Any, thrust: Any, alarm: Any) -> dict[str, Any]:
        """Count step k."""
        live = ~self._ended
        if alarm.on.shape[-1]:
            on = alarm.on
            new = on if self._on is None else on & ~self._on
            self._on = on
            if on.any():
                self._alarms += live * new.sum(axis=-1)
                self._alarm_steps += live & on.any(axis=-1)
        engines = np.sign(np.moveaxis(thrust.command, -1, 0)).astype(float)
        changed = np.abs(engines - self._engines)
        self._switches += (live * (changed[0] + changed[1] + changed[2])).astype(np.int64)
        self._engines = engines
        u, v, w = (truth.state[..., i] for i in range(3, 6))
        speed = np.sqrt(u*u + v*v + w*w)
        if self._speed is not None:
            self._swing = np.where(live, self._swing + np.abs(speed - self._speed), self._swing)
        else:
            self._first = speed
        self._highest = np.where(live, np.maximum(self._highest, speed), self._highest)
        self._speed = np.where(live, speed, self._speed if self._speed is not None else speed)
        self._ended = self._ended | truth.final
        return {}

    def table(self, judge: Any, end_step: NDArray[np.int64]) -> dict[str, NDArray]:
        """
        Return the columns of N runs.

        `speed_swing_m_s` is by how much the variation of the speed exceeds that of one rise to the
        greatest speed and one fall to the last.
        """
        monotone = (self._highest - self._first) + (self._highest - self._speed)
        return {'alarms': self._alarms, 'alarm_steps': self._alarm_steps,
                'switches': self._switches, 'speed_swing_m_s': self._swing - monotone,
                'greatest_speed_m_s': self._highest, 'steps': end_step}
