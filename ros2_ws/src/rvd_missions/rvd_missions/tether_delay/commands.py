"""
The form of what goes up: an order, and one point of a plan.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from struct import Struct

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_missions.tether_delay.signals import HOLD, ORDER_WIDTH


@dataclass(frozen=True)
class OrderForm:
    """Numbers of `signals.ORDER_WIDTH`; without any the order in force before stays in force."""

    wire = Struct(f'<{ORDER_WIDTH}d')

    @property
    def neutral(self) -> NDArray[np.float64]:
        """No order, no plan."""
        return np.zeros(ORDER_WIDTH)

    @property
    def retreat(self) -> NDArray[np.float64]:
        """An ABORT is a kind of frame: it needs no numbers."""
        return self.neutral

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the numbers themselves."""
        return np.asarray(command, dtype=float)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.float64]:
        """Return the numbers themselves, neutral where they are not finite."""
        wanted = np.asarray(wanted, dtype=float)
        known = np.isfinite(wanted).all(axis=-1, keepdims=True)
        return np.where(known, wanted, self.neutral)

    def legal(self, command: Sequence) -> bool:
        """Say whether numbers, as they came over the wire, are an order and a point of a plan."""
        order, plan, point = command[:3]
        return bool(np.isfinite(command).all() and order in range(HOLD + 1)
                    and plan >= 0 and point >= 0 and plan % 1 == 0 and point % 1 == 0)
