"""
The console's node of one run: decodes what the page is shown, publishes the stick.
"""

from dataclasses import replace
import threading
import time
from typing import Any, Callable

import rclpy
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool

from rvd_dynamics.diagram.aborts import ABORT_EVENT
from rvd_dynamics.diagram.control import MODE_EVENT
from rvd_dynamics.diagram.judge import for_page, from_message
from rvd_dynamics.diagram.params import leaves
from rvd_dynamics.diagram.ros.arguments import Arguments, parsed
from rvd_dynamics.diagram.ros.boundary import content, read, Refused
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.horizon import Horizon
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.ros.params import declare
from rvd_dynamics.diagram.ros.process import listen_for_the_end
from rvd_dynamics.diagram.roster import MONITOR, RUN_TOPICS
from rvd_dynamics.link.frame import ReplayWindow
from rvd_dynamics.link.signals import FRAME
from rvd_groundstation.console.decode import COMMANDS, link_of, SAMPLES, telemetry_of
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.params import ConsoleParams
from rvd_groundstation.console.protocol import RELEASED, Stick
from rvd_groundstation.console.provider import display_of, on_ground
from rvd_interfaces.msg import LinkFrame, LinkStatus, RunEvent, Verdict
from rvd_interfaces.srv import RunControl

NAME = 'console'
ACTIONS = {'pause': RunControl.Request.PAUSE, 'resume': RunControl.Request.RESUME,
           'mode': RunControl.Request.MODE, 'abort': RunControl.Request.ABORT}
ALWAYS = ('PAUSE', 'RESUME', MODE_EVENT, ABORT_EVENT)   # events that a page hears whoever says them
LINK = '/link/back/status'
DECODE_S = 1.0 / 30             # [s] wall time


class ConsoleNode(RunNode):
    """
    The eyes and the stick of one run.

    The command that is sent gives the beat: with it a step of the ground is over. What else
    comes once a step is kept as bytes and decoded once per frame at most.
    """

    def __init__(self, host: Host, hub: Hub, call_soon: Callable) -> None:
        super().__init__(host, NAME)
        self.provider = display_of(self.scenario)
        self._hub, self._call_soon = hub, call_soon
        self._raw: dict[str, bytes] = {}
        self._decoded_at = 0.0
        # Only who flies has a stick: the operator of the run may be another one.
        self._joys = {topic: self.writer(topic, Joy) for topic in self.provider.sticks
                      if topic in self.roster.writes(NAME)}
        self._control = self.create_client(RunControl, '/run/control')
        self._command_at = time.monotonic()
        self._stamp_ns = -1                     # of the last Joy; -1: not ready yet
        self._gate = threading.Lock()           # the page's thread publishes, ours ends the node
        self._left = False
        display, topics = self.provider.display, self.roster.topics
        signals = on_ground(self.roster.diagram)
        self._framed = topics[display.measured] == FRAME
        self._width = signals[display.measured].parts[0].shape[0] if self._framed else 0
        self._command_of = COMMANDS[topics[display.commands.sent]]
        # What is displayed, and what the writers of this run wait for the console to hear.
        heard = ({*display.parts(), *self.provider.derives_from} & set(signals)
                 | set(self.roster.reads(NAME)) - set(RUN_TOPICS))
        self._signals = signals
        self._taken: dict[str, Callable] = {}   # by topic: what of a message can be
        self._horizon = Horizon(self.run, self.run.last_step,
                                made=host.bound_of(*self.roster.blocks))
        self._window = ReplayWindow()           # of telemetry
        self._kinds = {topic: topics[topic] for topic in sorted(heard)
                       if topic not in (*self.provider.sticks, LINK, display.commands.sent)
                       and not (self._framed and topic == display.measured)}

    def connect(self) -> None:
        """Listen."""
        display, topics = self.provider.display, self.roster.topics
        for topic, kind in self._kinds.items():
            self.watch(topic, message_type(kind), self._keeper(topic), raw=True)
        if LINK in topics:
            self.watch(LINK, LinkStatus, self._keeper(LINK), raw=True)
        if self._framed:
            self.watch(display.measured, LinkFrame, self._on_telemetry)
        self.watch(display.commands.sent, message_type(topics[display.commands.sent]),
                   self._on_command)
        self.watch('/run/pause', Bool, lambda m: self._hub.post('paused', m.data))
        self.watch('/run/events', RunEvent, self._on_event)
        self.watch('/run/verdict', Verdict, self._on_verdict)

    # -- from the graph -------------------------------------------------------------------

    def _keeper(self, topic: str) -> Callable:
        def keep(data: bytes) -> None:
            self._raw[topic] = data
        return keep

    def _can_be(self, topic: str, message: Any) -> bool:
        """Say whether a message can be one of this run; one that cannot is left out."""
        step, signal = message.step, self._signals.get(topic)
        try:
            if not self._horizon.believes(step, self.step):
                raise Refused(self._horizon.words(step, self.step))
            if signal is not None:
                if topic not in self._taken:
                    self._taken[topic] = content(signal, self.codec_of(signal), ('covariance',))
                self._taken[topic](step, message)
        except Refused as why:
            self.refuse(topic, str(why))
            return False
        return True

    def _on_telemetry(self, frame: LinkFrame) -> None:
        if not self._can_be(self.provider.display.measured, frame):
            return
        self._hub.post('telemetry', telemetry_of(frame, self.run.step_s, self._width,
                                                 self.provider.measured, self._window))

    def _on_command(self, command: Any) -> None:
        if not self._can_be(self.provider.display.commands.sent, command):
            return
        self.step, self._command_at = command.step, time.monotonic()
        if self._command_at - self._decoded_at >= DECODE_S:
            self._decoded_at = self._command_at
            self._decode_newest()
        self._hub.post('command', self._command_of(command))
        self.host.diagnose()

    def _decode_newest(self) -> None:
        raw, self._raw = self._raw, {}
        for topic, data in raw.items():
            try:
                self._post_newest(topic, data)
            except Refused as why:
                self.refuse(topic, str(why))

    def _post_newest(self, topic: str, data: bytes) -> None:
        if topic == LINK:
            status = read(data, LinkStatus)
            if self._can_be(LINK, status):
                self._hub.post('link', link_of(status))
            return
        kind = self._kinds[topic]
        if kind in SAMPLES:
            message = read(data, message_type(kind))
            sample = SAMPLES[kind](message) if self._can_be(topic, message) else None
            if sample is not None:
                self._hub.post('signal', topic, sample)

    def _on_event(self, event: RunEvent) -> None:
        if event.node in self.provider.heard_nodes or event.code in ALWAYS:
            self._hub.post('event', {'t': event.step * self.run.step_s, 'node': event.node,
                                     'code': event.code, 'text': event.text})

    def _on_verdict(self, verdict: Verdict) -> None:
        if verdict.final:                       # before, it would be truth
            self._hub.post('final', for_page(from_message(verdict)))
            self.finish()

    def on_end(self, final_step: int) -> None:
        """Stay for the verdict, which comes after the last step, if somebody judges the run."""
        judged = self.subscriptions_of['/run/verdict'].get_publisher_count() > 0
        if MONITOR not in self.roster.names and not judged:
            self.finish()

    # -- from the page (called on the event loop's thread) --------------------------------

    def joy(self, stick: Stick) -> list[float]:
        """Publish a stick sample as Joy; return the command that it means."""
        made = self.provider.joys(stick) if self._joys else {}
        value = [0.0] * len(self.provider.display.commands.axes)
        with self._gate:
            says = made and not self._left and (self._stamp_ns >= 0 or not stick.held)
            header = header_at(self._next_stamp(), f'console {stick.sequence}') if says else None
            for topic, (axes, buttons) in made.items():
                if says:
                    self._joys[topic].publish(Joy(header=header, axes=axes, buttons=buttons))
                value = self.provider.heard_joy(topic, axes, buttons)[0]
        return value

    def _next_stamp(self) -> int:
        """
        Return the simulation instant: the last step and the wall time since, up to a step.

        Stamps rise from 0, so that the recorded stick is a tape with the run's own time.
        """
        run = self.run
        if self._stamp_ns < 0:
            self._stamp_ns = 0
        else:
            since = (time.monotonic() - self._command_at) * run.pace_factor / run.step_s
            now = int((max(self.step, 0) + min(max(since, 0.0), 0.999)) * run.step_ns)
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
        with self._gate:
            if self._left:
                reply(False, 'the run has ended')
                return
            future = self._control.call_async(
                RunControl.Request(action=ACTIONS[action], mode=mode))
        future.add_done_callback(lambda f: self._call_soon(
            reply, f.result().accepted, f.result().message))


# -- the process ----------------------------------------------------------------------------

def own_settings(arguments: list[str]) -> ConsoleParams:
    """Return what the ROS arguments of a console started by hand say about the console."""
    rclpy.init(args=[NAME, *arguments], signal_handler_options=SignalHandlerOptions.NO)
    try:
        probe = Node(NAME)
        params = declare(probe, ConsoleParams)
        probe.destroy_node()
    finally:
        rclpy.try_shutdown()
    return params


def of_the_run(arguments: list[str]) -> Arguments:
    """Return the ROS arguments without those that concern the console alone."""
    given, own = parsed([NAME, *arguments]), {key for key, _ in leaves(ConsoleParams)}
    return replace(given, overrides=tuple(o for o in given.overrides if o[1] not in own))


def follow(hub: Hub, arguments: list[str], stopped: Callable[[], bool], call_soon: Callable
           ) -> None:
    """
    Serve the node of one run until the run is over or `stopped()`; errors as `Host.spin`.

    `call_soon` hands a call to the thread of the hub.
    """
    rclpy.init(args=[NAME, *arguments], signal_handler_options=SignalHandlerOptions.NO)
    host = node = None
    try:
        host = Host(of_the_run(arguments))
        node = ConsoleNode(host, hub, call_soon)
        hub.post('begin', hub.run_name or 'run', node.provider, node)
        node.connect()
        listen_for_the_end(host)
        host.spin(stopped)
    finally:
        if node is not None:
            node.leave()
        if host is not None:
            host.close()
        rclpy.try_shutdown()
