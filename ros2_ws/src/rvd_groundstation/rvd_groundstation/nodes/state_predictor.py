"""
ROS shell of the predictor: messages in, messages out, no mathematics.

Fires on    /ground/telemetry k           rvd_interfaces/LinkFrame, maybe empty
            /ground/command k-1           rvd_interfaces/ThrustCommand
Publishes   /ground/estimate k            rvd_interfaces/RelativeState, SOURCE_ESTIMATE
            /ground/prediction k          rvd_interfaces/RelativeState, SOURCE_PREDICTION
            /ground/prediction_score k    rvd_interfaces/PredictionScore
Parameters  the fields of PredictorParams
"""

import numpy as np

from rvd_dynamics.link.frame import Downlink, unpack_downlink
from rvd_dynamics.diagram.ros.conversions import header_at, levels_of, state_to_msg, vector
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_groundstation.prediction.predictor import Predictor, PredictorParams
from rvd_groundstation.prediction.score import Score, Scored
from rvd_interfaces.msg import LinkFrame, PredictionScore, RelativeState, ThrustCommand

NOT_RECEIVED = np.full(6, np.nan)


class StatePredictor(StepNode):
    """The predictor as a node."""

    def __init__(self) -> None:
        super().__init__('state_predictor')
        self.step_input('/ground/telemetry', LinkFrame)
        self.step_input('/ground/command', ThrustCommand, lag=1, early=True)
        self._estimate = self.step_output('/ground/estimate', RelativeState)
        self._prediction = self.step_output('/ground/prediction', RelativeState)
        self._scored = self.step_output('/ground/prediction_score', PredictionScore)
        # After the endpoints, which find their partners while filterpy is imported.
        self._predictor = Predictor(self.settings(PredictorParams), self.mission)
        self._score = Score(self.mission)

    def on_step(self, step: int, telemetry: LinkFrame | None, command: ThrustCommand | None
                ) -> None:
        """Filter what came down, predict when a command sent now will act, score the past."""
        measured = self._measured(step, telemetry)
        received = bool(np.isfinite(measured).all())
        p = self._predictor.advance(step, measured, received,
                                    None if step == 0 else levels_of(command))
        mission, valid = self.mission, bool(p.valid)
        seen_ns = (step - mission.back_steps) * mission.step_ns
        acts_ns = (step + mission.forward_steps) * mission.step_ns
        self._estimate.publish(state_to_msg(
            step, max(seen_ns, 0), mission.frame_id, RelativeState.SOURCE_ESTIMATE, p.estimate,
            valid, covariance=p.estimate_covariance))
        self._prediction.publish(state_to_msg(
            step, acts_ns, mission.frame_id, RelativeState.SOURCE_PREDICTION, p.predicted,
            valid, covariance=p.covariance))
        self._publish_score(step, self._score.advance(p, measured, received))

    def _measured(self, step: int, telemetry: LinkFrame | None) -> np.ndarray:
        if telemetry is None or telemetry.empty:
            return NOT_RECEIVED
        content = unpack_downlink(bytes(telemetry.payload))
        if not isinstance(content, Downlink):
            self.event('REFUSED', f'telemetry refused: {content.name}')
            return NOT_RECEIVED
        return np.array(content.state)

    def _publish_score(self, step: int, s: Scored) -> None:
        self._scored.publish(PredictionScore(
            header=header_at(max(step - self.mission.back_steps, 0) * self.mission.step_ns,
                             self.mission.frame_id),
            step=step, valid=bool(s.valid), position_error=vector(s.error[:3]),
            velocity_error=vector(s.error[3:]), sigma=s.sigma, scored=int(s.scored), rms=s.rms))


def main(args=None) -> None:
    """Run the node."""
    run(StatePredictor, args)
