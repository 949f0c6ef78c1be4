"""
ROS shell of the guidance laws: the one that `law` names computes the automatic command.

Fires on    /ground/prediction k     rvd_interfaces/RelativeState
            /joy k                   sensor_msgs/Joy, if the law uses the stick and it is stepped
Watches     /joy                     if the law uses it and it is held: the newest counts
Publishes   /ground/auto_command k   rvd_interfaces/ThrustCommand
Parameters  the fields of ControllerParams: `law` and the settings of each law under its name;
            what a law must know of the sharing is read from the blender's section of the file
"""

import numpy as np

from rvd_dynamics.commands.codes import BY_AUTO, BY_NOBODY, REASON_MISSING, REASON_NONE
from rvd_dynamics.diagram.ros import graph
from rvd_dynamics.diagram.ros.conversions import NAN, header_at, state_from_msg
from rvd_dynamics.diagram.ros.params import settings_of
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.commands.levels import stick_levels
from rvd_groundstation.nodes.stick import HeldStick
from rvd_groundstation.settings import BlenderParams, ControllerParams
from rvd_interfaces.msg import RelativeState, ThrustCommand
from sensor_msgs.msg import Joy


class AutoController(StepNode):
    """A guidance law as a node."""

    def __init__(self) -> None:
        super().__init__('auto_controller')
        self.step_input('/ground/prediction', RelativeState)
        self._stick = HeldStick()
        self._stepped = ('/joy', 0) in self.spec.fires_on
        if self._stepped:
            self.step_input('/joy', Joy)
        elif '/joy' in self.spec.watches:
            self.watch('/joy', Joy, self._stick.take)
        self._out = self.step_output('/ground/auto_command', ThrustCommand)

    def _spec(self) -> graph.Spec:
        sharing = settings_of('command_blender', BlenderParams).selected
        self._law = self.settings(ControllerParams, mission=self.mission,
                                  sharing=sharing).selected
        return graph.spec_of(self.get_name(), self.mission.operator, self.mission.joy_input,
                             self._law.uses_stick)

    def on_step(self, step: int, prediction: RelativeState | None, joy: Joy | None = None
                ) -> None:
        """Ask the law for levels at the predicted state."""
        valid = prediction is not None and prediction.valid
        levels = np.zeros(3, dtype=np.int8)
        if valid:
            stick = None
            joy = joy if self._stepped else self._stick.newest()
            if joy is not None:
                stick, held = stick_levels(joy.axes, joy.buttons, self.mission.stick)
                stick = stick if held else None
            levels = self._law.levels(state_from_msg(prediction), stick)
        acts_ns = (step + self.mission.forward_steps) * self.mission.step_ns
        self._out.publish(ThrustCommand(
            header=header_at(acts_ns, self.mission.frame_id), step=step, levels=levels,
            valid=valid, decided_by=BY_AUTO if valid else BY_NOBODY, pilot_weight=NAN,
            reason=REASON_NONE if valid else REASON_MISSING))


def main(args=None) -> None:
    """Run the node."""
    run(AutoController, args)
