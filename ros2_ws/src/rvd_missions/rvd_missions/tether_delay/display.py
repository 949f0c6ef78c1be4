"""
What the console draws of a gripper that is ordered through a link.

The page of mission `tether`; besides, the orders as buttons, what the gripper does, and the range
at which an order that is given now would act.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from rvd_dynamics.diagram.display import (
    DERIVED, Display, LampGroup, Lamps, Mode, Ref)
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import RunFacts
from rvd_missions.tether.display import SAID, TetherDisplay
from rvd_missions.tether_delay.planning import Preparation
from rvd_missions.tether_delay.signals import BRAKING, FLYING, STANDING

DOES = ('latched', 'flies', 'brakes', 'stands', 'there', 'aborts')      # in the order of `doing`
# The order that a gripper obeys which does this; otherwise it does not tell of one.
OBEYED = {FLYING: 'go', BRAKING: 'hold', STANDING: 'hold'}
ORDERS = (
    Mode('model', 'Stand-in', 'KeyB', 'leave go and hold to the stand-in for an operator'),
    Mode('hold', 'HOLD', 'KeyH', 'HOLD: come to rest and stand on a taut tether'),
    Mode('go', 'GO', 'KeyF', 'GO: fly the plan, after a HOLD a new one'))


class OrderedDisplay(TetherDisplay):
    """The approach on the console, and who orders what."""

    def __init__(self, facts: RunFacts, preparation: Preparation) -> None:
        super().__init__(facts, preparation)
        self.display = _ordered(self.display)

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return what mission `tether` derives, what the gripper does, and what order it obeys."""
        said = newest.get(SAID)
        made = super().derive(newest)
        if made['gripper'] is None:             # nothing has come down
            return {**made, **dict.fromkeys(('obeyed', 'does', 'plans'))}
        doing, plans, refused = (int(said.parts[n]) for n in ('doing', 'plans', 'refused'))
        words = [f'plan {plans}' if plans else 'no plan yet']
        words += [f'{refused} not to be had'] if refused else []
        far, ahead = said.parts['range'], said.parts['ahead']
        # the ground knows where an order acts while a plan is flown that no HOLD has made void
        words += [f'an order given now acts at {ahead:.1f} m'] if ahead != far else []
        return {**made, 'obeyed': OBEYED.get(doing), 'plans': [' \u00b7 '.join(words), refused > 0],
                'does': [float(i == doing) for i in range(len(DOES))]}


def _ordered(display: Display) -> Display:
    return replace(
        display, modes=ORDERS, on_board=Ref(DERIVED, 'obeyed'),
        lamps=Lamps('What the gripper does', 'What the gripper does, by its telemetry',
                    (LampGroup('gripper', '', DOES),), Ref(DERIVED, 'does'), Ref(DERIVED, 'does'),
                    note=Ref(DERIVED, 'plans'), role='measured'),
        abort='coming to rest, for good',
        hint='GO opens the latch, HOLD stops the gripper; both act a delay later.')
