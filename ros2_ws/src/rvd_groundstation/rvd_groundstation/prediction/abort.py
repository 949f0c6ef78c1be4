"""
What an ABORT does, as both sides have agreed: when it is in force, and how it thrusts.

An ABORT is sent again in every step and skips the play-out buffer, so the first copy that gets
through acts one transit after it was sent, at a step that the ground knows by chance only. For
copies that fare independently, each in time with probability F(i) within i steps,

    P(not in force j steps after the first was sent) = prod over i = 0..j of 1 - F(i).

Limits  outages are not foreseen, and what bursts take is taken for independent. Transits are those
        of the link's settings, 4,096 drawn once; a burn is not shorter or longer than the guard's
        settings say.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.diagram.scenario import Scenario

Array = NDArray[np.float64]
TRANSITS = 4096                         # drawn to know the distribution of the transit
LONGEST = 1000                          # [steps] after which an ABORT that has not come never does
SURE = 1e-6                             # probability that is as good as none


class Link(Protocol):
    """What the ground knows of the link up: its statistics, as the link's settings say them."""

    delay_model: Any                    # has delays(rng, size, hold_s) [s], NaN where lost
    loss_fraction: float
    corrupt_fraction: float
    lost_to_bursts: float
    reorder_fraction: float
    reorder_delay_s: float


@dataclass(frozen=True)
class AbortProfile:
    """An ABORT: the burn agreed with the guard, and the link that carries it."""

    burn_s: float
    link: Link
    legs: Legs
    run: Run

    @cached_property
    def burn_steps(self) -> int:
        """Number of steps for which an ABORT in force thrusts."""
        return -(-round(self.burn_s * NS_PER_S) // self.run.step_ns)

    @cached_property
    def in_time(self) -> Array:
        """Probability that what is sent once comes through within 0, 1, 2, ... steps, (j,)."""
        link, rng = self.link, streams.generator(0, 0, 'ground/abort/transit')
        hold_s = self.legs.forward * self.run.step_s
        transit = link.delay_model.delays(rng, (TRANSITS,), hold_s)
        transit = transit + link.reorder_delay_s * (rng.random(TRANSITS) < link.reorder_fraction)
        step_ns = self.run.step_ns
        steps = np.ceil(np.rint(transit * NS_PER_S) / step_ns)      # NaN: never, in no bin below
        intact = ((1.0 - link.loss_fraction) * (1.0 - link.corrupt_fraction)
                  * (1.0 - link.lost_to_bursts))
        return intact * np.array([np.mean(steps <= j) for j in range(LONGEST)])

    @property
    def reaching(self) -> float:
        """Probability that a command acts: that it is there when it is due."""
        return float(self.in_time[min(self.legs.forward, LONGEST - 1)])

    @cached_property
    def waiting(self) -> Array:
        """
        Probability that no ABORT is in force 0, 1, 2, ... steps after the first was sent, (j,).
        """
        waiting = np.cumprod(1.0 - self.in_time)
        return waiting[:1 + int(np.argmax(waiting < SURE)) if waiting[-1] < SURE else LONGEST]

    def still_waiting(self, after: int) -> float:
        """Return the probability that no ABORT is in force `after` steps after the first."""
        return 1.0 if after < 0 else float(self.waiting[min(after, len(self.waiting) - 1)])

    def burning(self, after: int) -> float:
        """Return the probability that the burn is under way `after` steps after the first."""
        return self.still_waiting(after - self.burn_steps) - self.still_waiting(after)

    @cached_property
    def arrivals(self) -> tuple[NDArray[np.int64], Array]:
        """Steps after the first at which an ABORT may come into force, and their weights, (h,)."""
        weight = -np.diff(self.waiting, prepend=1.0)
        after = np.flatnonzero(weight > SURE)
        weight, never = weight[after], self.waiting[-1]
        if never > SURE:
            after, weight = np.append(after, np.iinfo(np.int64).max // 2), np.append(weight, never)
        return after, weight / weight.sum()


class Acting:
    """What acts on the craft in each step, by what the ground has sent; called in order."""

    def __init__(self, profile: AbortProfile, form: CommandForm) -> None:
        self._profile, self._retreat = profile, form.effect(np.asarray(form.retreat))
        self.abort_step: int | None = None      # in which the first ABORT was sent

    def sent(self, step: int, is_abort: bool) -> None:
        """Hear whether what was sent in `step` was an ABORT."""
        if is_abort and self.abort_step is None:
            self.abort_step = step

    def mean(self, step: int, own: Array) -> Array:
        """Return the mean acceleration in `step`, for which `own` (..., 3) was sent [m/s^2]."""
        if self.abort_step is None:
            return own
        after = step - self.abort_step
        return (self._profile.still_waiting(after) * own
                + self._profile.burning(after) * self._retreat)


def profile(scenario: Scenario) -> AbortProfile:
    """Return what an ABORT does in a mission with these sections: guard, link_forward."""
    return AbortProfile(scenario.settings('onboard_guard').abort_burn_s,
                        scenario.settings('link_forward'), scenario.part('legs'), scenario.run)
