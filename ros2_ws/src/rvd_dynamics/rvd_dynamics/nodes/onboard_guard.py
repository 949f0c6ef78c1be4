"""
ROS shell of the guard: the last word on board, and the only writer of thrust.

Fires on    /onboard/command k             rvd_interfaces/LinkFrame, maybe empty
Publishes   /onboard/thruster_command k    rvd_interfaces/ThrustCommand, acts on [k, k+1)
Parameters  the fields of GuardParams
"""

from rvd_dynamics.commands.codes import BY_GUARD, BY_NOBODY, KIND_ABORT
from rvd_dynamics.onboard.guard.guard import Guard, GuardParams
from rvd_dynamics.link.frame import Refusal
from rvd_dynamics.diagram.ros.conversions import NAN, header_at
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_interfaces.msg import LinkFrame, ThrustCommand

REFUSALS = frozenset(Refusal)


class OnboardGuard(StepNode):
    """The guard as a node."""

    def __init__(self) -> None:
        super().__init__('onboard_guard')
        self._guard = Guard(self.mission, self.settings(GuardParams))
        self.step_input('/onboard/command', LinkFrame)
        self._out = self.step_output('/onboard/thruster_command', ThrustCommand)

    def on_step(self, step: int, frame: LinkFrame | None) -> None:
        """Check what the link handed over and say what the thrusters do."""
        payload = None if frame is None or frame.empty else bytes(frame.payload)
        decision = self._guard.advance(step, payload)
        self._out.publish(ThrustCommand(
            header=header_at(step * self.mission.step_ns, self.mission.frame_id), step=step,
            sequence=decision.sequence, kind=decision.kind, levels=decision.levels,
            valid=decision.valid, pilot_weight=NAN, reason=decision.reason,
            decided_by=BY_GUARD if decision.kind == KIND_ABORT else BY_NOBODY))
        if decision.reason in REFUSALS:
            name = Refusal(decision.reason).name
            self.event('REFUSED', f'command refused: {name}, '
                       f'{decision.counts[name.lower()]} so far')


def main(args=None) -> None:
    """Run the node."""
    run(OnboardGuard, args)
