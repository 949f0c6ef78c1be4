"""
One direction of the space link, event by event in simulation time.

Carries out a `LinkPlan`: each copy of a frame may be lost or damaged, takes its own transit time
and enters the play-out buffer; at most one frame comes out per step. The channel reads only the
envelope of a frame and damages only the payload. It owns no clock and draws no random numbers.

Damage is a burst of at most 32 flipped bits or a truncation. CRC-32 detects every such burst
when bits are numbered from the least significant one of each byte, as here.
"""

from collections import deque
from dataclasses import dataclass, fields
from heapq import heappop, heappush

from rvd_dynamics.link.plan import LinkPlan
from rvd_dynamics.link.play_out import Frame, Outcome, PlayOut
from rvd_dynamics.link.transits import Transits
from rvd_dynamics.diagram.params import require


@dataclass
class LinkCounts:
    """
    What became of the copies so far; the names are those of LinkStatus.msg.

    Every copy is somewhere: `sent + duplicated` is the sum of the seven counts that follow.
    """

    sent: int = 0
    duplicated: int = 0
    delivered: int = 0
    late: int = 0
    lost: int = 0
    outage: int = 0
    duplicate_dropped: int = 0
    in_flight: int = 0
    queued: int = 0
    corrupted: int = 0              # attribute of copies that arrived
    reordered: int = 0              # attribute of copies that arrived


LINK_COUNTS = tuple(f.name for f in fields(LinkCounts))


class Channel:
    """
    One direction of the link: call `advance` once per step, with steps rising by one.

    Parameters
    ----------
    plan : LinkPlan
        Fate of the frame of each step.
    hold_steps, step_ns : int
        Play-out delay [steps] and sampling period [ns], those the plan was drawn with.
    """

    def __init__(self, plan: LinkPlan, hold_steps: int, step_ns: int) -> None:
        require(plan.hold_ns == hold_steps * step_ns, 'hold_steps * step_ns',
                f'be the {plan.hold_ns} ns of the plan', hold_steps * step_ns)
        self.counts = LinkCounts()
        self._step_ns = step_ns
        self._steps = len(plan.duplicated)
        self._transit_ns = plan.transit_ns.tolist()     # lists: reading an item costs a tenth
        self._lost = plan.lost.tolist()
        self._damaged = plan.damaged.tolist()
        self._damage = plan.damage.tolist()
        self._duplicated = plan.duplicated.tolist()
        self._outage = plan.outage.tolist()
        self._in_flight: list[tuple[int, int, int, Frame]] = []     # heap by arrival
        self._buffer = PlayOut(hold_steps, step_ns)
        self._expedited: deque[Frame] = deque()
        self._newest_ns = -1                            # latest sending instant that arrived
        self._transits = Transits(plan.transit_ns)      # of all arrivals
        self._next_step: int | None = None

    def advance(self, step: int, frame: Frame | None) -> Frame | None:
        """
        Send `frame` (None: nothing to send) and return what the link releases in `step`.

        Raises
        ------
        ValueError
            If `step` does not follow the last one, is not in the plan, or is not the step
            the frame was sent in.
        """
        require(self._next_step in (None, step), 'step', f'be {self._next_step}', step)
        require(0 <= step < self._steps, 'step', f'be in the plan of {self._steps} steps', step)
        self._next_step = step + 1
        now_ns = step * self._step_ns
        if frame is not None:
            require(frame.sent_ns == now_ns, 'sent', f'be the {now_ns} ns of step {step}',
                    frame.sent_ns)
            self._send(step, frame)
        while self._in_flight and self._in_flight[0][0] <= now_ns:
            self._receive(*heappop(self._in_flight))
        released = self._release(step, now_ns)
        self.counts.in_flight = len(self._in_flight)
        self.counts.queued = len(self._buffer) + len(self._expedited)
        return released

    def delay_s(self, percent: int) -> float:
        """Return a percentile (nearest rank) of the transits so far [s]; 100 is the largest."""
        return self._transits.percentile_s(percent)

    def _send(self, step: int, frame: Frame) -> None:
        copies = 1 + self._duplicated[step]
        self.counts.sent += 1
        self.counts.duplicated += copies - 1
        for copy in range(copies):
            if self._outage[step]:
                self.counts.outage += 1
            elif self._lost[step][copy]:
                self.counts.lost += 1
            else:
                arrival_ns = frame.sent_ns + self._transit_ns[step][copy]
                heappush(self._in_flight, (arrival_ns, step, copy, frame))

    def _receive(self, arrival_ns: int, step: int, copy: int, frame: Frame) -> None:
        payload = frame.payload
        if self._damaged[step][copy]:
            payload = damaged(payload, self._damage[step][copy])
            self.counts.corrupted += 1
        self.counts.reordered += frame.sent_ns < self._newest_ns
        self._newest_ns = max(self._newest_ns, frame.sent_ns)
        self._transits.add(step, copy)

        arrived = frame._replace(payload=payload, arrived_ns=arrival_ns)
        if frame.expedited:
            self._expedited.append(arrived)     # each copy: the other may be the intact one
            return
        outcome = self._buffer.insert(arrived)
        self.counts.late += outcome is Outcome.LATE
        self.counts.duplicate_dropped += outcome is Outcome.DUPLICATE

    def _release(self, step: int, now_ns: int) -> Frame | None:
        """Release one frame; an expedited one goes first and makes the frame due now late."""
        frame = self._buffer.pop(step)
        if self._expedited:
            self.counts.late += frame is not None
            frame = self._expedited.popleft()
        if frame is None:
            return None
        self.counts.delivered += 1
        return frame._replace(released_ns=now_ns)


def damaged(payload: bytes, which: float) -> bytes:
    """
    Return a damaged `payload`: with a burst of at most 32 flipped bits, or cut short.

    Parameters
    ----------
    payload : bytes
        An empty one is returned as it is.
    which : float
        In [0, 1); its 53 bits choose the damage: 1 bit the kind, 20 the place, 32 the burst.
    """
    if not payload:
        return payload
    bits = int(which * (1 << 53))
    cut, place, burst = bits & 1, (bits >> 1) & 0xfffff, (bits >> 21) | 1
    if cut:
        return payload[:place % len(payload)]
    size = 8 * len(payload)
    flipped = (burst << place % size) & ((1 << size) - 1)
    return (int.from_bytes(payload, 'little') ^ flipped).to_bytes(len(payload), 'little')
