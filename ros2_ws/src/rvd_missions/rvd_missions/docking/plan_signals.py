"""
Signals of a plan that the ground makes: what it knows of the craft, and the packets that go up.
"""

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link
from rvd_missions.docking.planning import PACKET

# place and velocity as the craft estimates them, LVLH; NaN while it does not know
DOWNLINK, TELEMETRY = (make(Part('state', (6,), 'm, m/s')) for make in (
    link.downlink, link.telemetry))
# a packet: see `planning`; as numbers with a checksum, which any frame of numbers is
_packet = Part('state', (PACKET,), '1, 1, s, m, m/s')
UPLINK = Signal('/ground/plan', (
    _packet, Part('accepted', (), 'sequence', 'i8', optional=True),
    Part('refusal', (), 'REASON_*', 'u1', optional=True)),
                link.FRAME, f'{link.FRAME_CODECS}:Downlink')
ARRIVAL = Signal('/onboard/plan', (_packet, link.RECEIVED), link.FRAME,
                 f'{link.FRAME_CODECS}:Telemetry')
