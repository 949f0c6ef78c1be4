"""
The console's node of one run: decodes what the page is shown, publishes the stick.
"""

import threading
import time
from typing import Callable

import numpy as np
from rclpy.serialization import deserialize_message
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool

from rvd_dynamics.link.frame import Downlink, unpack_downlink
from rvd_dynamics.diagram.judge import for_page, from_message
from rvd_dynamics.diagram.ros.conversions import header_at, ns_of, state_from_msg
from rvd_dynamics.diagram.ros.node import WatchNode
from rvd_dynamics.commands.levels import stick_axes, stick_levels
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.protocol import Stick
from rvd_interfaces.msg import (
    LinkFrame, LinkStatus, PredictionScore, RelativeState, RunEvent, ThrustCommand, Verdict)
from rvd_interfaces.srv import RunControl

ACTIONS = {'pause': RunControl.Request.PAUSE, 'resume': RunControl.Request.RESUME,
           'mode': RunControl.Request.MODE, 'abort': RunControl.Request.ABORT}
COUNTS = ('sent', 'delivered', 'late', 'lost', 'outage', 'corrupted', 'in_flight', 'queued')
DELAYS = ('delay_p50', 'delay_p99', 'delay_max')
# What the craft or the judge says on /run/events has not come down the link: not for the page.
HEARD = ('command_blender', 'state_predictor', 'auto_controller', 'console')
ALWAYS = ('PAUSE', 'RESUME')
NEWEST = ('/ground/estimate', '/ground/prediction', '/ground/prediction_score',
          '/ground/auto_command', '/link/back/status')      # decoded once per frame at most
DECODE_S = 1.0 / 30             # [s] wall time
SERVICE_S = 2.0                 # [s] wall time to wait for /run/control


class ConsoleNode(WatchNode):
    """The eyes and the stick of one run."""

    def __init__(self, hub: Hub, call_soon: Callable) -> None:
        super().__init__('console')
        self._hub, self._call_soon = hub, call_soon
        self._raw: dict[str, bytes] = {}
        self._decoded_at = 0.0
        self._joy = self.writer('/joy', Joy)
        self._control = self.create_client(RunControl, '/run/control')
        self._command_at = time.monotonic()
        self._stamp_ns = -1                     # of the last Joy; -1: not ready yet
        self._gate = threading.Lock()           # the page's thread publishes, ours ends the node
        self._left = False
        for topic in NEWEST:
            self.watch(topic, KINDS[topic], self._keeper(topic), raw=True)
        self.watch('/ground/telemetry', LinkFrame, self._on_telemetry)
        self.watch('/ground/command', ThrustCommand, self._on_command)
        self.watch('/run/pause', Bool, lambda m: hub.post('paused', m.data))
        self.watch('/run/events', RunEvent, self._on_event)
        self.watch('/run/verdict', Verdict, self._on_verdict)

    # -- from the graph -------------------------------------------------------------------

    def _keeper(self, topic: str) -> Callable:
        def keep(data: bytes) -> None:
            self._raw[topic] = data
        return keep

    def _on_telemetry(self, frame: LinkFrame) -> None:
        if frame.empty:
            if frame.step > self.mission.back_steps:
                self._hub.post('telemetry_lost', frame.step, 'EMPTY')
            return
        content = unpack_downlink(bytes(frame.payload))
        if isinstance(content, Downlink) and np.isfinite(content.state).all():
            self._hub.post('telemetry', frame.step, frame.sent, frame.arrived,
                           content.generated_ns, content.state, content.accepted_sequence,
                           content.refusal)
        else:
            self._hub.post('telemetry_lost', frame.step, getattr(content, 'name', 'NAN'))

    def _on_command(self, command: ThrustCommand) -> None:
        self.step, self._command_at = command.step, time.monotonic()
        if self._command_at - self._decoded_at >= DECODE_S:
            self._decoded_at = self._command_at
            self._decode_newest()
        self._hub.post('command', command.step, command.sequence, command.kind,
                       command.levels.tolist(), command.decided_by, command.pilot_weight,
                       command.reason)
        self.diagnose()

    def _decode_newest(self) -> None:
        raw, self._raw = self._raw, {}
        for topic, data in raw.items():
            getattr(self, DECODERS[topic])(deserialize_message(data, KINDS[topic]))

    def _decode_estimate(self, message: RelativeState) -> None:
        self._post_state('est', message)

    def _decode_prediction(self, message: RelativeState) -> None:
        self._post_state('pred', message)

    def _post_state(self, name: str, message: RelativeState) -> None:
        covariance = np.asarray(message.covariance)
        sigma = None if np.isnan(covariance[0]) else np.sqrt(
            np.maximum(covariance.reshape(6, 6).diagonal(), 0.0))
        self._hub.post('state', name, message.step, ns_of(message.header.stamp),
                       state_from_msg(message), sigma, message.valid)

    def _decode_score(self, score: PredictionScore) -> None:
        if score.valid:
            e, v = score.position_error, score.velocity_error
            self._hub.post('score', score.step, ns_of(score.header.stamp),
                           [e.x, e.y, e.z, v.x, v.y, v.z], score.sigma.tolist(),
                           score.rms.tolist(), score.scored)

    def _decode_auto(self, command: ThrustCommand) -> None:
        self._hub.post('automatic', command.levels.tolist(), command.valid)

    def _decode_link(self, status: LinkStatus) -> None:
        self._hub.post('link', {name: getattr(status, name) for name in COUNTS + DELAYS})

    def _on_event(self, event: RunEvent) -> None:
        if event.node in HEARD or event.code in ALWAYS:
            self._hub.post('event', {'t': event.step * self.mission.step_s, 'node': event.node,
                                     'code': event.code, 'text': event.text})

    def _on_verdict(self, v: Verdict) -> None:
        if v.final:                             # before, it would be truth
            self._hub.post('final', for_page(from_message(v)))
            self.finish()

    def on_end(self) -> None:
        """Stay for the verdict, which comes after the last step."""
        if 'mission_monitor' not in self._names:
            self.finish()

    # -- from the page (called on the event loop's thread) --------------------------------

    def joy(self, stick: Stick) -> list[int]:
        """Publish a stick sample as Joy; return the levels it means."""
        s = self.mission.stick
        axes, buttons = stick_axes(stick.deflection, stick.held, s)
        if not buttons and not stick.held:      # no dead-man button to open: say nothing
            return [0, 0, 0]
        with self._gate:
            if not self._left and (self._stamp_ns >= 0 or not stick.held):
                self._joy.publish(Joy(header=header_at(self._next_stamp(),
                                                       f'console {stick.sequence}'),
                                      axes=axes, buttons=buttons))
        return stick_levels(axes, buttons, s)[0].tolist()

    def _next_stamp(self) -> int:
        """
        Return the simulation instant: the last step and the wall time since, up to a step.

        Stamps rise from 0, so that the recorded stick is a tape with the run's own time.
        """
        m = self.mission
        if self._stamp_ns < 0:
            self._stamp_ns = 0
        else:
            since = (time.monotonic() - self._command_at) * m.pace_factor / m.step_s
            now = int((max(self.step, 0) + min(max(since, 0.0), 0.999)) * m.step_ns)
            self._stamp_ns = max(now, self._stamp_ns + 1)
        return self._stamp_ns

    def on_ready(self) -> None:
        """Open the tape: nobody has the stick at 0."""
        self.joy(Stick(False, 0, (0.0, 0.0, 0.0)))

    def event(self, code: str, text: str) -> None:
        """Say on /run/events that something happened, as long as there is a run."""
        with self._gate:
            if not self._left:
                super().event(code, text)

    def leave(self) -> None:
        """Be told that the node is about to end: what the page wants now goes nowhere."""
        with self._gate:
            self._left = True

    def control(self, action: str, mode: str, reply: Callable[[bool, str], None]) -> None:
        """Call /run/control without waiting for the answer."""
        if self._left:
            reply(False, 'the run has ended')
            return
        future = self._control.call_async(RunControl.Request(action=ACTIONS[action], mode=mode))
        future.add_done_callback(lambda f: self._call_soon(
            reply, f.result().accepted, f.result().message))


KINDS = {'/ground/estimate': RelativeState, '/ground/prediction': RelativeState,
         '/ground/prediction_score': PredictionScore, '/ground/auto_command': ThrustCommand,
         '/link/back/status': LinkStatus}
DECODERS = {'/ground/estimate': '_decode_estimate', '/ground/prediction': '_decode_prediction',
            '/ground/prediction_score': '_decode_score', '/ground/auto_command': '_decode_auto',
            '/link/back/status': '_decode_link'}
