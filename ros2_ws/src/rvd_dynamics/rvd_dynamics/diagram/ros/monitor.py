"""
The judge as a node: reads truth and nothing else, outside the ring.

Reads       the plant's truth
Publishes   /run/verdict    rvd_interfaces/Verdict, at most 10 a second of wall time while the run
            goes on, and the final one
"""

import time
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.judge import judgement
from rvd_dynamics.diagram.ros.conversions import header_at, verdict_to_msg
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.roster import MONITOR
from rvd_interfaces.msg import Verdict

PERIOD_S = 0.1                  # [s] wall time between two verdicts under way


class MissionMonitor(RunNode):
    """The judge as a node."""

    def __init__(self, host: Host) -> None:
        super().__init__(host, MONITOR)
        self._out = self.writer('/run/verdict', Verdict)
        self._published = time.monotonic()
        self._judged_final = False
        own = {'batch': ()}
        self._judge = made(self.scenario.mission.judge,
                           lambda name: own[name] if name in own else self.scenario.part(name),
                           'judge')

    def connect(self) -> None:
        """Listen to the truth."""
        truth = self.roster.diagram.truth
        if self.host.is_local(truth.name):
            self.host.take(truth.name, self.guarded(self._on_truth))
            return
        codec = made(truth.codec, lambda name: {'signal': truth, 'run': self.run}.get(name)
                     or self.scenario.part(name), f'signal {truth.name}')
        self.watch(truth.name, message_type(truth.message),
                   lambda m: self._on_truth(m.step, codec.decode(m.step, m)), rests=True)

    def _on_truth(self, step: int, truth: Any) -> None:
        if step != self.step + 1:
            raise BadInput(f'truth jumps from step {self.step} to {step}: a run with a gap '
                           'cannot be judged')
        self.step = step
        self._judge.follow(step, truth)
        now = time.monotonic()
        if truth.final or now - self._published >= PERIOD_S:
            self._published = now
            self._publish(bool(truth.final))
        self.host.diagnose()
        if truth.final:
            self._judged_final = True
            self.finish()

    def _publish(self, final: bool) -> None:
        judged = judgement(self._judge, self._judge.verdict(final))
        header = header_at(self.step * self.run.step_ns, self.run.frame_id)
        self.host.publish(self._out, '/run/verdict', self.step,
                          verdict_to_msg(header, self.step, final, judged))

    def on_end(self, final_step: int) -> None:
        """Judge the final truth first, which may still be on its way."""
        if self._judged_final:
            self.finish()
