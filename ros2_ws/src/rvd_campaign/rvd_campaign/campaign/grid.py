"""
The cells of a campaign's grid, and what a loop delay means for both legs of the link.
"""

import itertools
import math
from collections.abc import Iterator
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import ScenarioError
from rvd_dynamics.diagram.time_grid import whole_steps


class Cells:
    """The cells of a grid, without making them all at once."""

    def __init__(self, axes: dict[str, list[tuple[Any, Any]]]) -> None:
        self._axes = axes
        self.count = math.prod(len(values) for values in axes.values())

    def __iter__(self) -> Iterator[dict[str, tuple[Any, Any]]]:
        for values in itertools.product(*self._axes.values()):
            yield dict(zip(self._axes, values))

    def short(self, axis: str) -> str:
        """Return the last word of an axis, where that is enough to tell it from the others."""
        last = axis.rsplit('.', 1)[-1]
        return last if sum(a.rsplit('.', 1)[-1] == last for a in self._axes) == 1 else axis


def legs(loop_delay_s: Any, step_s: float) -> dict[str, float]:
    """Split a loop delay evenly; the back leg takes the odd step."""
    if isinstance(loop_delay_s, bool) or not isinstance(loop_delay_s, (int, float)) \
            or not 0.0 <= loop_delay_s <= 3600.0:
        raise ScenarioError(f'loop_delay_s must be between 0 and 3600, got {loop_delay_s}')
    try:
        steps = whole_steps('loop_delay_s', loop_delay_s, step_s)
    except BadInput as error:
        raise ScenarioError(error) from None
    return {'forward_delay_s': steps//2 * step_s, 'back_delay_s': (steps - steps//2) * step_s}
