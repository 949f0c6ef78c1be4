"""
ROS shell of the recorded pilot: plays a tape in simulation time.

Fires on    /ground/prediction k   rvd_interfaces/RelativeState, for its pace only
Publishes   /joy k                 sensor_msgs/Joy, stamped step * step_ns
Parameters  the fields of ReplayParams
"""

from sensor_msgs.msg import Joy

from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_groundstation.operators.tape import read_tape
from rvd_groundstation.settings import ReplayParams
from rvd_interfaces.msg import RelativeState


class JoystickReplay(StepNode):
    """A tape as a node."""

    def __init__(self) -> None:
        super().__init__('joystick_replay')
        self._tape = read_tape(self.settings(ReplayParams).tape)
        self.step_input('/ground/prediction', RelativeState)
        self._joy = self.step_output('/joy', Joy)

    def on_step(self, step: int, prediction: RelativeState | None) -> None:
        """Publish what the tape holds for this instant."""
        now = step * self.mission.step_ns
        axes, buttons = self._tape.at(now)
        self._joy.publish(Joy(header=header_at(now, 'joy'), axes=axes, buttons=buttons))


def main(args=None) -> None:
    """Run the node."""
    run(JoystickReplay, args)
