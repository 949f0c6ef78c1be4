"""
Signals of the mission: those of `tether`, orders and plans that go up, and what the gripper does.

A frame that goes up carries the order in force and one point of the newest plan. Both are repeated:
a frame that is lost costs a step, or one turn of the plan's points.
"""

from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link import signals as link
from rvd_missions.tether import signals as tether
from rvd_missions.tether.signals import COMMAND, MEASUREMENT, THRUST, TRACKING, TRUTH, WANTED

__all__ = ('ARRIVAL', 'COMMAND', 'CRAFT', 'DECISION', 'DOWNLINK', 'MEASUREMENT', 'SITUATION',
           'TELEMETRY', 'THRUST', 'TRACKING', 'TRUTH', 'UPLINK', 'WANTED')

WAIT, GO, HOLD = range(3)               # orders
# what the gripper does: on its latch; follows a plan; comes to rest; stands; stands at the end of a
# plan; stands, or comes to rest, for good
LATCHED, FLYING, BRAKING, STANDING, ARRIVED, ABORTED = range(6)
NO_PLAN = 255                   # plan of a gripper that has been aborted: it will fly none

# order; plan (its number, 0: none); which point of it (0: the start, K + 1: the end); its begin and
# end [s]; state (12) and controls (7) there
ORDER_WIDTH = 24
_order = Part('command', (ORDER_WIDTH,), '1, s, m, m/s, rad, rad/s, N, N m', initial=0.0)

UPLINK, ARRIVAL = link.uplink(_order), link.arrival(_order)
# measured (6), followed (6), range by which it is followed, tension that is asked for, what the
# gripper does, number of the newest plan that is complete on board, and of the one that is flown,
# force (3) and torque (3) that are asked for
DOWNLINK, TELEMETRY = (make(Part('state', (23,), 'm, rad, N, 1, N m')) for make in (
    link.downlink, link.telemetry))
DECISION = Signal('/ground/decision', (
    Part('order', (), 'WAIT, GO, HOLD', 'u1', high=HOLD), Part('abort', (), '', '?')))
SITUATION = Signal('/ground/situation', (
    *tether.SITUATION.parts,
    Part('ahead', (), 'm'),             # range at which an order sent now would act, by the plan
    Part('doing', (), '', 'u1', high=ABORTED), Part('plans', (), '', 'u1'),
    Part('refused', (), '', 'u1')))
CRAFT = Signal('/onboard/craft', (
    Part('doing', (), '', 'u1', high=ABORTED), Part('released', (), '', '?'),
    Part('plan', (), '', 'u1')))
