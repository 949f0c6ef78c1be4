"""
The controller that tracks a plan of the ground: six loops on what came up in place of the profile.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.run import Run
from rvd_missions.docking.commands import ValveForm
from rvd_missions.docking.onboard import Controller, ControllerParams
from rvd_missions.docking.planning import Memory, PACKET
from rvd_missions.docking.plan_signals import DOWNLINK
from rvd_missions.docking.settings import Aim, OrbitParams


class TrackingController(Controller):
    """Holds its attitude and stays where it is until a whole plan has come up; then tracks it."""

    def __init__(self, settings: ControllerParams, run: Run, aim: Aim, orbit: OrbitParams,
                 form: ValveForm, runs: Sequence[int], batch: tuple) -> None:
        super().__init__(settings, run, aim, orbit, form, runs, batch)
        self._memory = Memory(len(self._held))

    def step(self, k: int, estimate: Any, plan: Any, control: Control) -> dict[str, Any]:
        """Return valves, guidance and downlink of step k."""
        rows = len(self._held)
        self._memory.take(np.reshape(plan.state, (rows, PACKET)), np.reshape(plan.received, rows))
        state = np.concatenate([estimate.position, estimate.velocity], axis=-1)
        return {**super().step(k, estimate, control), 'downlink': DOWNLINK(state=state)}

    def _guided(self, t: float, r: NDArray) -> tuple[NDArray, NDArray]:
        """Return place and velocity (N, 3) that the plan has for the craft's centre."""
        return self._memory.at(t)
