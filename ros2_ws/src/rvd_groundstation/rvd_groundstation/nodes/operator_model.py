"""
ROS shell of the stochastic pilot: looks at the displays, moves the stick.

Fires on    /ground/estimate k     rvd_interfaces/RelativeState
            /ground/prediction k   rvd_interfaces/RelativeState
Publishes   /joy k                 sensor_msgs/Joy, stamped step * step_ns
Parameters  the fields of PilotParams
"""

import numpy as np
from sensor_msgs.msg import Joy

from rvd_dynamics.diagram.ros.conversions import state_from_msg
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.diagram.streams import pilot_draws, skill_normal
from rvd_groundstation.nodes.stick import joy_of_levels
from rvd_groundstation.operators.pilot import Pilot, PilotParams
from rvd_interfaces.msg import RelativeState


class OperatorModel(StepNode):
    """The model pilot as a node."""

    def __init__(self) -> None:
        super().__init__('operator_model')
        mission, params = self.mission, self.settings(PilotParams)
        draws = pilot_draws(mission.seed, mission.run, mission.last_step + 1)
        self._pilot = Pilot(params, mission, draws,
                            skill_normal(mission.seed, params.operator_of(mission.run)))
        self.step_input('/ground/estimate', RelativeState, early=True)
        self.step_input('/ground/prediction', RelativeState)
        self._joy = self.step_output('/joy', Joy)

    def on_step(self, step: int, estimate: RelativeState | None,
                prediction: RelativeState | None) -> None:
        """Let the pilot see both displays and publish his stick."""
        valid = (estimate is not None and prediction is not None
                 and estimate.valid and prediction.valid)
        nothing = np.full(6, np.nan)
        levels = self._pilot.advance(
            step, state_from_msg(estimate) if valid else nothing,
            state_from_msg(prediction) if valid else nothing, np.array(valid))
        self._joy.publish(joy_of_levels(levels.tolist(), step, self.mission))


def main(args=None) -> None:
    """Run the node."""
    run(OperatorModel, args)
