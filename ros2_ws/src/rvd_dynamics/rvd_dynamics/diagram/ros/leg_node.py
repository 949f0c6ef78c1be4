"""A leg of the link as a node."""

from typing import Any

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.block import Leg
from rvd_dynamics.diagram.ros.frame_codecs import FrameOfLink
from rvd_dynamics.diagram.ros.firing import FiringNode
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.play_out import Frame
from rvd_interfaces.msg import LinkFrame, LinkStatus


class LegNode(FiringNode):
    """A leg of the link as a node: it reads the envelope of a frame, the payload is bytes to it."""

    raw = True

    def __init__(self, host: Host, block: Leg) -> None:
        super().__init__(host, block)
        self._name = block.writes['arrival'].name
        self._out = self.writer(self._name, LinkFrame)
        if block.status is not None:
            self._status = self.writer(block.status.name, LinkStatus)
            self._counted = Layout(LinkStatus, {'header.frame_id': self.run.frame_id})

    def make(self) -> None:
        """Draw what will happen to every frame."""
        run, drawn = self.run, self.block.draws['chance']
        plan = drawn.of_run(run.seed, run.run, run.last_step + 1)
        self._channel = Channel(plan, drawn.hold_steps, run.step_ns)
        self._hold_s = drawn.hold_steps * run.step_s

    def on_step(self, k: int, values: dict[str, Any]) -> None:
        """Send what came in, hand on what is due, and say what became of it all."""
        sent = values['content']
        frame = None
        if sent is not None and not sent.empty:
            frame = Frame(sequence=sent.sequence, sent_ns=sent.sent, expedited=sent.expedited,
                          payload=bytes(sent.payload))
        due = self._channel.advance(k, frame)
        passed = FrameOfLink(k, empty=True)
        if due is not None:
            passed = FrameOfLink(
                step=k, sequence=due.sequence, sent=due.sent_ns, arrived=due.arrived_ns,
                released=due.released_ns, expedited=due.expedited, payload=due.payload)
        self.host.publish(self._out, self._name, k, passed.serialised(), passed)
        if self.block.status is not None:
            self._tell(k)

    def _tell(self, k: int) -> None:
        delay_s = self._channel.delay_s
        self.host.publish(self._status, self.block.status.name, k, self._counted.pack(
            *divmod(k * self.run.step_ns, NS_PER_S), k, *vars(self._channel.counts).values(),
            self._hold_s, delay_s(50), delay_s(99), delay_s(100)))
