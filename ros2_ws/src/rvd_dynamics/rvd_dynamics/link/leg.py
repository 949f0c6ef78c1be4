"""
One direction of the link in one process, on arrays of N runs.

The play-out buffer turns random transits into a constant delay plus erasures, which are settled
before the run (`LinkPlan.intact_in_time`): what was sent at k - n arrives at k, with a mask of
the rows in which the frame came through intact. In a graph the same leg is a node that plays
frames of bytes (`link.channel`); a test holds the two against each other.

An ABORT makes every frame from then on expedited: it skips the buffer and pushes out whatever is
due in the same step. Which frame comes out when is then read from the channel itself, row by row.
"""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.block import Leg as Declaration
from rvd_dynamics.diagram.block import LINK, now
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.link.bursts import lost_in_bursts
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.link.plan import draw_plan, intact_of_runs, LinkPlan
from rvd_dynamics.link.play_out import Frame
from rvd_dynamics.link.signals import status


@dataclass(frozen=True)
class LinkChance:
    """What a link does to the frame of each step: a plan for one run, the mask for many."""

    purpose: str
    params: LinkParams
    hold_steps: int
    step_ns: int

    @property
    def purposes(self) -> tuple[str, ...]:
        """The stream of the link, and that of its bursts where it has any."""
        return (self.purpose, self.of_bursts) if self.params.lost_to_bursts else (self.purpose,)

    @property
    def of_bursts(self) -> str:
        """What the stream of the bursts is for."""
        return f'link/{self.purpose.replace("/", "_")}/bursts'

    def of_run(self, seed: int, run: int, steps: int) -> LinkPlan:
        """Return the plan of one run."""
        plan = draw_plan(self.params, streams.generator(seed, run, self.purpose), steps,
                         self.step_ns, self.hold_steps)
        if not self.params.lost_to_bursts:
            return plan
        return replace(plan, lost=plan.lost | self._bursts(seed, [run], steps)[0, :, None])

    def of_runs(self, seed: int, runs: Sequence[int], steps: int) -> NDArray[np.bool_]:
        """Return which frames come through intact and in time, (N, steps)."""
        intact = intact_of_runs(self.params, streams.generators(seed, runs, self.purpose),
                                len(runs), steps, self.step_ns, self.hold_steps)
        if self.params.lost_to_bursts:
            intact &= ~self._bursts(seed, runs, steps)
        return intact

    def _bursts(self, seed: int, runs: Sequence[int], steps: int) -> NDArray[np.bool_]:
        return lost_in_bursts(self.params, streams.generators(seed, runs, self.of_bursts), steps,
                              self.step_ns)


def leg(scenario: Scenario, name: str, content: Signal, arrival: Signal, hold_steps: int,
        *optional: str) -> Declaration:
    """
    Return a leg of a scenario's link, for its diagram; `optional` parts of what it carries.

    `name` is that of its node, its section and its random stream: link_back or link_forward.
    """
    chance = LinkChance(name, scenario.settings(name), hold_steps, scenario.run.step_ns)
    return Declaration(
        name, 'rvd_dynamics.link.leg:Leg', LINK, reads={'content': now(content, *optional)},
        writes={'arrival': arrival}, settings=scenario.mission.sections[name],
        draws={'chance': chance}, executable='link_emulator', status=status(name))


class Leg:
    """
    The leg as a block.

    Reads       content     anything
    Writes      arrival     the parts of `content` that it has, and `received`
    """

    def __init__(self, block: Declaration, chance: NDArray[np.bool_], batch: tuple, run: Run,
                 runs: Sequence[int], steps: int, abort_step: int | None) -> None:
        drawn = block.draws['chance']
        self._intact, self._hold = chance, drawn.hold_steps
        self._arrival = block.writes['arrival']
        content = block.reads['content'].signal
        self._copied = [part.name for part in content.parts if part.name in
                        {p.name for p in self._arrival.parts}]
        self._on_its_way: deque[Any] = deque(maxlen=self._hold + 1)
        self._nothing = self._arrival.initial(batch)
        self._lost = np.zeros(batch, dtype=bool)
        self._source: NDArray[np.int64] | None = None
        if abort_step is not None and any(part.name == 'expedited' for part in content.parts):
            plans = [drawn.of_run(run.seed, number, steps) for number in runs]
            self._source = sources(plans, self._hold, run.step_ns, abort_step)
            self._kept: list[Any] = []

    def step(self, k: int, content: Any) -> dict[str, Any]:
        """Send `content` and return what is released in step k."""
        if self._source is not None:
            return {'arrival': self._released(k, content)}
        self._on_its_way.append(content)
        sent = k - self._hold
        if sent < 0:
            return {'arrival': self._nothing}
        first = self._on_its_way[0]
        return {'arrival': self._arrival(
            **{name: getattr(first, name) for name in self._copied},
            received=self._intact[:, sent])}

    def _released(self, k: int, content: Any) -> Any:
        """Return, row by row, what the frame that the channel released had in it."""
        self._kept.append(content)
        source = self._source[:, k]
        received = source >= 0
        made = {}
        for name in self._copied:
            part = getattr(self._nothing, name)
            chosen = np.array(np.broadcast_to(part, part.shape))
            for step in np.unique(source[received]):
                rows = source == step
                chosen[rows] = np.broadcast_to(getattr(self._kept[step], name),
                                               chosen.shape)[rows]
            made[name] = chosen
        return self._arrival(**made, received=received)


def sources(plans: Sequence[LinkPlan], hold_steps: int, step_ns: int, abort_step: int
            ) -> NDArray[np.int64]:
    """
    Return the step whose frame comes out intact in each step, (N, steps); -1: none does.

    Frames are expedited from `abort_step` on, and may then come out twice or after newer ones,
    which the guard's gate refuses: only a frame that is newer than all before it counts.
    """
    steps = len(plans[0].duplicated)
    found = np.full((len(plans), steps), -1, dtype=np.int64)
    for row, plan in zip(found, plans):
        channel, newest = Channel(plan, hold_steps, step_ns), -1
        for k in range(steps):
            payload = k.to_bytes(8, 'little')
            out = channel.advance(k, Frame(sequence=k + 1, sent_ns=k*step_ns, payload=payload,
                                           expedited=k >= abort_step))
            if out is None or out.sequence - 1 <= newest:
                continue
            if out.payload == (out.sequence - 1).to_bytes(8, 'little'):
                row[k] = newest = out.sequence - 1
    return found
