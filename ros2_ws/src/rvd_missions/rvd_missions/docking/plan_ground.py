"""
The ground segment: the planner of the closing, where the craft does not make its own profile.
"""

from typing import Any

import numpy as np

from rvd_dynamics.diagram.run import Legs, Run
from rvd_missions.docking.planning import KNOTS, packets, Preparation, shaped
from rvd_missions.docking.plan_signals import UPLINK


class ClosingPlanner:
    """
    Sends the plan up, a packet a step, round and round.

    The plan from the nominal start is one for all rows; it begins with the run. A plan made anew
    is each row's own and begins where the craft was at the instant of its telemetry.
    """

    def __init__(self, preparation: Preparation, run: Run, legs: Legs, batch: tuple) -> None:
        self._preparation, self._run, self._legs, self._batch = preparation, run, legs, batch
        self._packets = packets(preparation.nominal, 0.0, 1)
        replan_s = preparation.closing.replan_s
        self._anew = round(replan_s/run.step_s) if replan_s > 0.0 else None

    def step(self, k: int, telemetry: Any) -> dict[str, Any]:
        """Return the packet of step k."""
        if self._anew is not None and k >= self._anew:
            self._plan_anew(k, telemetry)
        packet = self._packets[..., k % KNOTS, :]
        return {'plan': UPLINK(state=np.broadcast_to(packet, (*self._batch, packet.shape[-1])))}

    def _plan_anew(self, k: int, telemetry: Any) -> None:
        """Plan once from where the craft is; a row of which nothing is known keeps its plan."""
        self._anew = None
        begin_s = (k - self._legs.back)*self._run.step_s
        states = np.reshape(telemetry.state, (-1, 6))
        known = np.reshape(telemetry.received, -1) & np.isfinite(states).all(axis=-1)
        self._packets = shaped(
            [packets(self._preparation.anew(state), begin_s, 2) if ok else self._packets
             for state, ok in zip(states, known)], self._batch)
