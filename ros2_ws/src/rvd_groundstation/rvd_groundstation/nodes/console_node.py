"""
The console's node of one run: decodes what the page is shown, publishes the stick.
"""

from importlib import import_module
import threading
import time
from typing import Any, Callable

from rclpy.serialization import deserialize_message
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool

from rvd_dynamics.diagram.ros import graph
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.node import WatchNode
from rvd_groundstation.console.decode import command_of, link_of, SAMPLES, telemetry_of
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.protocol import RELEASED, Stick
from rvd_groundstation.console.provider import display_of
from rvd_interfaces.msg import LinkFrame, LinkStatus, RunEvent, ThrustCommand, Verdict
from rvd_interfaces.srv import RunControl

ACTIONS = {'pause': RunControl.Request.PAUSE, 'resume': RunControl.Request.RESUME,
           'mode': RunControl.Request.MODE, 'abort': RunControl.Request.ABORT}
ALWAYS = ('PAUSE', 'RESUME')    # events that a page hears whoever says them
LINK = '/link/back/status'
DECODE_S = 1.0 / 30             # [s] wall time


class ConsoleNode(WatchNode):
    """
    The eyes and the stick of one run.

    The command that is sent gives the beat: with it a step of the ground is over. What else
    comes once a step is kept as bytes and decoded once per frame at most.
    """

    def __init__(self, hub: Hub, call_soon: Callable) -> None:
        super().__init__('console')
        self.provider = display_of(self.mission)
        self._hub, self._call_soon = hub, call_soon
        self._raw: dict[str, bytes] = {}
        self._decoded_at = 0.0
        self._joy = self.writer('/joy', Joy)
        self._control = self.create_client(RunControl, '/run/control')
        self._command_at = time.monotonic()
        self._stamp_ns = -1                     # of the last Joy; -1: not ready yet
        self._gate = threading.Lock()           # the page's thread publishes, ours ends the node
        self._left = False
        display = self.provider.display
        self._kinds = {topic: graph.TOPICS[topic] for topic in self.spec.watches
                       if graph.TOPICS[topic] in SAMPLES and topic != display.commands.sent}
        for topic, kind in self._kinds.items():
            self.watch(topic, class_of(kind), self._keeper(topic), raw=True)
        self.watch(LINK, LinkStatus, self._keeper(LINK), raw=True)
        self.watch(display.measured, LinkFrame, self._on_telemetry)
        self.watch(display.commands.sent, ThrustCommand, self._on_command)
        self.watch('/run/pause', Bool, lambda m: hub.post('paused', m.data))
        self.watch('/run/events', RunEvent, self._on_event)
        self.watch('/run/verdict', Verdict, self._on_verdict)

    # -- from the graph -------------------------------------------------------------------

    def _keeper(self, topic: str) -> Callable:
        def keep(data: bytes) -> None:
            self._raw[topic] = data
        return keep

    def _on_telemetry(self, frame: LinkFrame) -> None:
        self._hub.post('telemetry', telemetry_of(frame, self.mission.step_s))

    def _on_command(self, command: ThrustCommand) -> None:
        self.step, self._command_at = command.step, time.monotonic()
        if self._command_at - self._decoded_at >= DECODE_S:
            self._decoded_at = self._command_at
            self._decode_newest()
        self._hub.post('command', command_of(command))
        self.diagnose()

    def _decode_newest(self) -> None:
        raw, self._raw = self._raw, {}
        for topic, data in raw.items():
            if topic == LINK:
                self._hub.post('link', link_of(deserialize_message(data, LinkStatus)))
                continue
            kind = self._kinds[topic]
            sample = SAMPLES[kind](deserialize_message(data, class_of(kind)))
            if sample is not None:
                self._hub.post('signal', topic, sample)

    def _on_event(self, event: RunEvent) -> None:
        if event.node in self.provider.heard_nodes or event.code in ALWAYS:
            self._hub.post('event', {'t': event.step * self.mission.step_s, 'node': event.node,
                                     'code': event.code, 'text': event.text})

    def _on_verdict(self, verdict: Verdict) -> None:
        if verdict.final:                       # before, it would be truth
            self._hub.post('final', self.provider.verdict(verdict))
            self.finish()

    def on_end(self) -> None:
        """Stay for the verdict, which comes after the last step."""
        if 'mission_monitor' not in self._names:
            self.finish()

    # -- from the page (called on the event loop's thread) --------------------------------

    def joy(self, stick: Stick) -> list[float]:
        """Publish a stick sample as Joy; return the command that it means."""
        made = self.provider.joy(stick.deflection, stick.held)
        if made is None:
            return [0.0] * len(self.provider.display.commands.axes)
        axes, buttons = made
        with self._gate:
            if not self._left and (self._stamp_ns >= 0 or not stick.held):
                self._joy.publish(Joy(header=header_at(self._next_stamp(),
                                                       f'console {stick.sequence}'),
                                      axes=axes, buttons=buttons))
        return self.provider.pilot(axes, buttons)[0]

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
        self.joy(RELEASED)

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


def class_of(kind: str) -> Any:
    """Return the message class of a type as ROS names it."""
    package, folder, name = kind.split('/')
    return getattr(import_module(f'{package}.{folder}'), name)
