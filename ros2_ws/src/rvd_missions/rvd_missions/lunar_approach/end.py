"""
When an approach ends: said once, for the plant and for the judge.
"""

import numpy as np
from numpy.typing import NDArray


def ended(k: int, state: NDArray, last_step: int) -> NDArray[np.bool_]:
    """
    Say of states (..., 6) of step k whether the run ends here, (...).

    At the docking plane x = 0 or past it, at the time limit, or where the state is not finite.
    Leaving the corridor does not end a run.
    """
    over = (state[..., 0] >= 0.0) | (k >= last_step)
    if not np.isfinite(state).all():
        over = over | ~np.isfinite(state).all(axis=-1)
    return over
