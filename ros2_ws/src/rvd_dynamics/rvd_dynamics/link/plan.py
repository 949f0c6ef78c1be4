"""
What the link will do to each frame of a run, drawn before the run.

The plan holds everything random about a link. The node carries it out frame by frame
(`link.channel`); a campaign only uses `LinkPlan.intact_in_time`, because the play-out buffer
turns random transits into a constant delay plus erasures. Both get the same result.

Row k is for the frame sent in step k. Column 0 is the frame itself, column 1 the copy that
the link may make of it. Transits are integer ns, so that "transit = nT is in time" is exact.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, section 1.3, rules (1)-(4).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.diagram.params import require

UNIFORMS_PER_STEP = 9           # loss 2, held up 2, damage 2, duplicate 1, which damage 2
HANDFUL = 32                    # runs planned at a time
FAR_AHEAD = 1 << 64             # position in the stream at which the transits begin


@dataclass(frozen=True, eq=False)
class LinkPlan:
    """
    The fate of every frame of a run; arrays of shape (steps,) or (steps, 2).

    Plans of many runs have a leading axis; `outage` is the same in all of them.
    """

    hold_ns: int                        # [ns] play-out delay nT
    transit_ns: NDArray[np.int64]       # (steps, 2) [ns]; meaningless where lost
    lost: NDArray[np.bool_]             # (steps, 2) the copy vanishes
    damaged: NDArray[np.bool_]          # (steps, 2) the payload of the copy is damaged
    damage: NDArray[np.float64]         # (steps, 2) which damage, see channel.damaged;
                                        # meaningless where the copy is not damaged
    duplicated: NDArray[np.bool_]       # (steps,) a second copy is made
    outage: NDArray[np.bool_]           # (steps,) sent during an outage: no copy gets through

    @cached_property
    def in_time(self) -> NDArray[np.bool_]:
        """Copies that reach the play-out buffer by their instant of release, shape (steps, 2)."""
        in_time = (self.transit_ns <= self.hold_ns) & ~self.lost
        in_time[..., 1] &= self.duplicated
        in_time &= ~self.outage[:, None]
        return in_time

    @cached_property
    def intact_in_time(self) -> NDArray[np.bool_]:
        """
        Say for each step k whether the frame sent then is released intact at k + n.

        The buffer keeps the copy that arrives first (the original, if both arrive at the same
        instant) and cannot know that it is damaged: an intact second copy does not help.

        Returns
        -------
        ndarray of bool, shape (steps,)
        """
        first, second = self.in_time[..., 0], self.in_time[..., 1]
        sooner = self.transit_ns[..., 1] < self.transit_ns[..., 0]
        copy_counts = second & (sooner | ~first)
        damaged = np.where(copy_counts, self.damaged[..., 1], self.damaged[..., 0])
        return (first | second) & ~damaged


def draw_plan(params: LinkParams, rng: np.random.Generator, mission_steps: int, step_ns: int,
              hold_steps: int) -> LinkPlan:
    """
    Draw the fate of every frame that may be sent in a run.

    Each fault has its own variates in every step, used or not, and the transits come from a
    distant part of the stream. So switching a fault on moves no other draw, and a longer time
    limit does not change the steps before it.

    Parameters
    ----------
    params : LinkParams
    rng : numpy.random.Generator
        Based on PCG64, as `streams.generator` and `numpy.random.default_rng` make it.
    mission_steps : int
        Steps of the run, `mission.last_step + 1`.
    step_ns, hold_steps : int
        Sampling period [ns]; play-out delay n [steps], 0 for a direct link.

    Returns
    -------
    LinkPlan

    Raises
    ------
    ValueError
        If a number of steps or the period is impossible.
    """
    require(mission_steps >= 1, 'mission_steps', 'be positive', mission_steps)
    require(step_ns >= 1, 'step_ns', 'be positive', step_ns)
    require(hold_steps >= 0, 'hold_steps', 'not be negative', hold_steps)
    uniforms = _uniforms(params.has_faults, rng, mission_steps)
    if uniforms is None:
        uniforms = np.ones((mission_steps, UNIFORMS_PER_STEP))
    transits = params.delay_model.delays(rng, (mission_steps, 2), hold_steps * step_ns / NS_PER_S)
    return _plan(params, np.asfortranarray(uniforms), np.asfortranarray(transits),  # for speed
                 step_ns, hold_steps)


def intact_of_runs(params: LinkParams, rngs: Iterable[np.random.Generator], runs: int,
                   mission_steps: int, step_ns: int, hold_steps: int) -> NDArray[np.bool_]:
    """
    Return `draw_plan(...).intact_in_time` of many runs, shape (runs, steps).

    `rngs` yields their generators one after the other, as `streams.generators` does. In memory
    the runs of one step lie together, which suits a loop over steps.
    """
    intact = np.empty((mission_steps, runs), dtype=bool)
    rngs, faults, hold_s = iter(rngs), params.has_faults, hold_steps * step_ns / NS_PER_S
    for first in range(0, runs, HANDFUL):       # few enough for their plans to stay in the cache
        count = min(HANDFUL, runs - first)
        uniforms = np.ones((UNIFORMS_PER_STEP, count if faults else 1, mission_steps))
        transits = np.empty((2, count, mission_steps))
        for i, rng in enumerate(islice(rngs, count)):
            drawn = _uniforms(faults, rng, mission_steps)
            if drawn is not None:
                uniforms.T[:, i] = drawn
            transits.T[:, i] = params.delay_model.delays(rng, (mission_steps, 2), hold_s)
        plan = _plan(params, np.moveaxis(uniforms, 0, -1), np.moveaxis(transits, 0, -1),
                     step_ns, hold_steps)
        intact[:, first:first + count] = plan.intact_in_time.T
    return intact.T


def _uniforms(faults: bool, rng: np.random.Generator, steps: int) -> NDArray[np.float64] | None:
    """
    Draw the uniforms (steps, 9) of one run and move on to where the transits begin.

    Return None if there are no faults: 1, which draws never reach, then stands for all of them.
    """
    if not faults:
        rng.bit_generator.advance(FAR_AHEAD)
        return None
    uniforms = rng.random((steps, UNIFORMS_PER_STEP))
    rng.bit_generator.advance(FAR_AHEAD - uniforms.size)        # to the same place for any length
    return uniforms


def _plan(params: LinkParams, uniforms: NDArray, transits: NDArray, step_ns: int,
          hold_steps: int) -> LinkPlan:
    """Make the plan of draws (..., steps, 9) and transits (..., steps, 2) [s]."""
    struck = uniforms[..., :7] < (
        params.loss_fraction, params.loss_fraction, params.reorder_fraction,
        params.reorder_fraction, params.corrupt_fraction, params.corrupt_fraction,
        params.duplicate_fraction)
    missing = np.isnan(transits)
    transit_ns = np.rint(np.where(missing, 0.0, transits) * NS_PER_S).astype(np.int64)
    transit_ns += struck[..., 2:4] * round(params.reorder_delay_s * NS_PER_S)
    return LinkPlan(
        hold_ns=hold_steps * step_ns,
        transit_ns=transit_ns,
        lost=missing | struck[..., 0:2],
        damaged=struck[..., 4:6],
        damage=uniforms[..., 7:9],
        duplicated=struck[..., 6],
        outage=_outage(params.outages_ns, transits.shape[-2], step_ns),
    )


def _outage(windows_ns: tuple, steps: int, step_ns: int) -> NDArray[np.bool_]:
    """Mark the steps whose instant lies in a window, its start included, its end excluded."""
    marked = np.zeros(steps, dtype=bool)
    for start, end in windows_ns:
        marked[-(-start // step_ns):-(-end // step_ns)] = True
    return marked
