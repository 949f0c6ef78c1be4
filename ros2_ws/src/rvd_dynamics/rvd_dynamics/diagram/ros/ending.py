"""
The end of a run as a process hears of it: believed if the plant has noted it.

Only the plant ends a run, and it says on `/run/end` which step is the last before anybody can have
that step. It notes the same on the page of the run (`pulse`) before: what is not there is refused,
whoever says it.

A node started by hand has no such page. It refuses a step that it has left behind, or that no run
of this scenario gets to. Whether the plant said the rest it cannot see by the message: it waits for
a moment before it leaves, and takes up its work again if a later step comes meanwhile.
"""

import time
from typing import Any

QUIET_S = 0.1                   # [s] wall time without a later step after which the end is believed
QUIET_STEPS = 1.5               # [steps] the same in real time, where it is longer


class Ending:
    """What a process has heard of the end from another one; `_heard` is of what it cannot check."""

    def __init__(self, host: Any) -> None:
        self._host = host
        self._heard: float | None = None        # wall time
        run = host.scenario.run
        self._quiet_s = QUIET_S if run.pace == 'lockstep' else max(
            QUIET_S, QUIET_STEPS*run.step_s/run.pace_factor)

    @property
    def sure(self) -> bool:
        """Whether a process that has nothing more to do may leave."""
        return self._heard is None or time.monotonic() - self._heard >= self._quiet_s

    def hear(self, message: Any) -> None:
        """Be told by another process which step is the last."""
        host, step = self._host, message.data
        last, now = host.scenario.run.last_step, max(n.step for n in host.nodes.values())
        if not now <= step <= last or host.final_step is not None:
            why = ('it has been said already' if host.final_step is not None else
                   f'this is step {now}' if step < now else f'no run here is longer than {last}')
            host.lead.refuse('/run/end', f'step {step} cannot be the last: {why}')
            return
        noted = host.noted_end
        if noted is None:
            self._heard = time.monotonic()
            host.lead.create_timer(self._quiet_s, host.lead.guarded(host.look))
        elif noted != step:
            host.lead.refuse('/run/end', f'step {step} is not the last: the run is at step '
                             f'{host.made} and goes on' if noted < 0 else
                             f'step {step} is not the last: that is {noted}')
            return
        host.end(step)

    def goes_on(self, step: int) -> None:
        """Be told that a step has come; if it is after the last one, that was not the last."""
        host = self._host
        if self._heard is None or host.final_step is None or step <= host.final_step:
            return
        self._heard, told = None, host.final_step
        host.final_step = None
        for node in host.nodes.values():
            node.finished = False
        host.lead.refuse('/run/end', f'step {told} was not the last: the run goes on with {step}')
