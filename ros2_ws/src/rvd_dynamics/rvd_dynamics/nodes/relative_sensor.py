"""
ROS shell of the relative-state sensor and of the telemetry formatter on board.

Fires on    /truth/relative_state k         rvd_interfaces/RelativeState
            /onboard/thruster_command k-1   rvd_interfaces/ThrustCommand
Publishes   /onboard/measurement k          rvd_interfaces/RelativeState, SOURCE_MEASUREMENT
            /onboard/downlink k             rvd_interfaces/LinkFrame
Parameters  the fields of SensorParams
"""

import numpy as np

from rvd_dynamics.commands.codes import REASON_EMPTY
from rvd_dynamics.link.frame import pack_downlink
from rvd_dynamics.diagram.ros.conversions import state_from_msg, state_to_msg
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.diagram.streams import measurement_normals
from rvd_dynamics.world.settings import SensorParams
from rvd_interfaces.msg import LinkFrame, RelativeState, ThrustCommand


class RelativeSensor(StepNode):
    """The sensor as a node."""

    def __init__(self) -> None:
        super().__init__('relative_sensor')
        mission = self.mission
        self._sensor = self.settings(SensorParams).selected
        self._noise = measurement_normals(mission.seed, mission.run, mission.last_step + 1)
        self.step_input('/truth/relative_state', RelativeState)
        self.step_input('/onboard/thruster_command', ThrustCommand, lag=1, early=True)
        self._measurement = self.step_output('/onboard/measurement', RelativeState)
        self._downlink = self.step_output('/onboard/downlink', LinkFrame)
        self._accepted = 0

    def on_step(self, step: int, truth: RelativeState | None, command: ThrustCommand | None
                ) -> None:
        """Measure, and pack what was measured for the link."""
        state = np.full(6, np.nan) if truth is None else state_from_msg(truth)
        measured = self._sensor.measure(state, self._noise[step])
        valid = bool(np.isfinite(measured).all())
        now = step * self.mission.step_ns
        refusal = 0
        if command is not None:
            refusal = 0 if command.sequence else command.reason     # none was accepted: why
            self._accepted = max(self._accepted, command.sequence)
        self._downlink.publish(LinkFrame(
            step=step, sequence=step + 1, sent=now, arrived=-1, released=-1,
            payload=pack_downlink(
                sequence=step + 1, generated_ns=now, state=measured,
                accepted_sequence=self._accepted,
                refusal=0 if refusal == REASON_EMPTY else refusal)))
        self._measurement.publish(state_to_msg(
            step, now, self.mission.frame_id, RelativeState.SOURCE_MEASUREMENT, measured, valid))


def main(args=None) -> None:
    """Run the node."""
    run(RelativeSensor, args)
