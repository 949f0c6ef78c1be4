"""
Bursts of loss: the link is good or bad, and changes between the two as a Markov chain.

In a bad step each frame is lost with probability `burst_loss_fraction`, together with its copy, as
in an outage. From one step to the next a burst ends with probability r = T/burst_mean_s, at most 1,
and one begins with p = r f/(1 - f), so that the share of bad steps is p/(p + r) = f and a burst
takes 1/r steps on average. A run begins anywhere in that.

Source  E. N. Gilbert, Bell System Technical Journal 39, 1960, pp. 1253-1265; E. O. Elliott, the
        same 42, 1963, pp. 1977-1997. Their good state loses nothing, and frames little, here: that is
        `loss_fraction`.
"""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.link.models import LinkParams


def lost_in_bursts(params: LinkParams, rngs: Iterable[np.random.Generator], steps: int,
                   step_ns: int) -> NDArray[np.bool_]:
    """
    Return which frames bursts take, (runs, steps); `rngs` yields the generator of each run.

    Two uniforms a step, used or not: a longer run begins as a shorter one does.
    """
    drawn = np.array([rng.random((steps, 2)) for rng in rngs])      # (runs, steps, 2)
    share = params.burst_fraction
    ends = min(step_ns / NS_PER_S / params.burst_mean_s, 1.0)
    begins = ends * share / (1.0 - share)
    bad = drawn[:, 0, 0] < share
    lost = np.empty(drawn.shape[:2], dtype=bool)
    for k in range(steps):
        if k:
            bad = drawn[:, k, 0] < np.where(bad, 1.0 - ends, begins)
        lost[:, k] = bad & (drawn[:, k, 1] < params.burst_loss_fraction)
    return lost
