"""
Columns of a campaign's table beyond the measures: how often obstacles alarmed, and for how long.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray


class Columns:
    """Counts alarms in the runs under way."""

    def __init__(self, batch: tuple) -> None:
        self._ended = np.zeros(batch, dtype=bool)
        self._alarms, self._alarmed = np.zeros((2, *batch), dtype=np.int64)
        self._on: NDArray | None = None

    def step(self, k: int, truth: Any, alarm: Any) -> dict[str, Any]:
        """Count step k."""
        on = alarm.on
        if on.any():
            live = ~self._ended
            new = on if self._on is None else on & ~self._on
            self._alarms += live * new.sum(axis=-1)
            self._alarmed += live & on.any(axis=-1)
        self._on = on
        self._ended = self._ended | truth.final
        return {}

    def table(self, judge: Any, end_step: NDArray[np.int64]) -> dict[str, NDArray]:
        """Return the columns of N runs."""
        return {'alarms': self._alarms, 'steps': end_step, 'steps_alarmed': self._alarmed}
