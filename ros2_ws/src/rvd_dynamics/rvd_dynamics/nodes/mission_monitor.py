"""
ROS shell of the judge: reads truth and nothing else, outside the ring.

Watches     /truth/relative_state    rvd_interfaces/RelativeState
Publishes   /run/verdict             rvd_interfaces/Verdict, at most 10 a second of wall time
            while the run goes on, and the final one
"""

import time

import numpy as np

from rvd_dynamics.diagram.judge import judgement
from rvd_dynamics.diagram.ros.conversions import header_at, state_from_msg, verdict_to_msg
from rvd_dynamics.diagram.ros.node import WatchNode
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.judge import Judge
from rvd_interfaces.msg import RelativeState, Verdict

PERIOD_S = 0.1                  # [s] wall time between two verdicts under way


class MissionMonitor(WatchNode):
    """The judge as a node."""

    def __init__(self) -> None:
        super().__init__('mission_monitor')
        self._judge = Judge(self.mission)
        self._out = self.writer('/run/verdict', Verdict)
        self._published = time.monotonic()
        self._judged_final = False
        self.watch('/truth/relative_state', RelativeState, self._on_truth, rests=True)

    def _on_truth(self, truth: RelativeState) -> None:
        if truth.step != self.step + 1:
            raise ValueError(f'truth jumps from step {self.step} to {truth.step}: '
                             'a run with a gap cannot be judged')
        self.step = truth.step
        state = state_from_msg(truth)
        a = truth.acceleration
        if truth.step == 0:
            self._judge.start(state)
        else:
            self._judge.advance(truth.step, state, np.array((a.x, a.y, a.z)))
        now = time.monotonic()
        if truth.final or now - self._published >= PERIOD_S:
            self._published = now
            self._publish(truth.final)
        self.diagnose()
        if truth.final:
            self._judged_final = True
            self.finish()

    def _publish(self, final: bool) -> None:
        judged = judgement(self._judge, self._judge.verdict(final))
        header = header_at(self.step * self.mission.step_ns, self.mission.frame_id)
        self._out.publish(verdict_to_msg(header, self.step, final, judged))

    def on_end(self) -> None:
        """Judge the final truth first, which may still be on its way."""
        if self._judged_final:
            self.finish()


def main(args=None) -> None:
    """Run the node."""
    run(MissionMonitor, args)
