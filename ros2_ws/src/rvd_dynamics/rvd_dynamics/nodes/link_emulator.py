"""
ROS shell of one direction of the space link; run twice, as `link_forward` and `link_back`.

Fires on    /ground/uplink k or /onboard/downlink k      rvd_interfaces/LinkFrame
Publishes   /onboard/command k or /ground/telemetry k    rvd_interfaces/LinkFrame, maybe empty
            /link/forward/status or /link/back/status    rvd_interfaces/LinkStatus
Parameters  the fields of LinkParams

The node reads the envelope only; the payload is bytes to it.
"""

from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.link.plan import draw_plan
from rvd_dynamics.link.play_out import Frame
from rvd_dynamics.diagram.ros.conversions import empty_frame, header_at
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.diagram.streams import generator
from rvd_interfaces.msg import LinkFrame, LinkStatus

# name: (input, output, status)
LEGS = {
    'link_forward': ('/ground/uplink', '/onboard/command', '/link/forward/status'),
    'link_back': ('/onboard/downlink', '/ground/telemetry', '/link/back/status'),
}


class LinkEmulator(StepNode):
    """One direction of the link as a node."""

    def __init__(self) -> None:
        super().__init__('link_emulator')
        mission, name = self.mission, self.get_name()
        hold = mission.forward_steps if name == 'link_forward' else mission.back_steps
        plan = draw_plan(self.settings(LinkParams), generator(mission.seed, mission.run, name),
                         mission.last_step + 1, mission.step_ns, hold)
        self._channel = Channel(plan, hold, mission.step_ns)
        self._hold_s = hold * mission.step_s
        source, sink, status = LEGS[name]
        self.step_input(source, LinkFrame)
        self._out = self.step_output(sink, LinkFrame)
        self._status = self.step_output(status, LinkStatus)

    def _spec(self):
        if self.get_name() not in LEGS:
            raise ValueError(f'a link must be named {" or ".join(LEGS)}, not '
                             f'{self.get_name()!r}: add --ros-args -r __node:=link_forward')
        return super()._spec()

    def on_step(self, step: int, sent: LinkFrame | None) -> None:
        """Send what came in, hand on what is due."""
        frame = None
        if sent is not None and not sent.empty:
            frame = Frame(sequence=sent.sequence, sent_ns=sent.sent, expedited=sent.expedited,
                          payload=bytes(sent.payload))
        due = self._channel.advance(step, frame)
        if due is None:
            self._out.publish(empty_frame(step))
        else:
            self._out.publish(LinkFrame(
                step=step, sequence=due.sequence, sent=due.sent_ns, arrived=due.arrived_ns,
                released=due.released_ns, expedited=due.expedited, payload=due.payload))
        self._publish_status(step)

    def _publish_status(self, step: int) -> None:
        counts, delay_s = self._channel.counts, self._channel.delay_s
        self._status.publish(LinkStatus(
            header=header_at(step * self.mission.step_ns, self.mission.frame_id), step=step,
            sent=counts.sent, duplicated=counts.duplicated, delivered=counts.delivered,
            late=counts.late, lost=counts.lost, outage=counts.outage,
            duplicate_dropped=counts.duplicate_dropped, in_flight=counts.in_flight,
            queued=counts.queued, corrupted=counts.corrupted, reordered=counts.reordered,
            play_out_delay=self._hold_s, delay_p50=delay_s(50), delay_p99=delay_s(99),
            delay_max=delay_s(100)))


def main(args=None) -> None:
    """Run the node."""
    run(LinkEmulator, args)
