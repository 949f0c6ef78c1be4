"""
The space segment: the gripper is on the platform's latch until it is released.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.run import Run
from rvd_missions.tether import geometry, space
from rvd_missions.tether.settings import (
    ApproachParams, ArrivalParams, GripperParams, OrbitParams, TetherParams)
from rvd_missions.tether_delay.planning import Preparation, turn, turned


class LatchedDynamics(space.GripperDynamics):
    """
    The true motion of mission `tether`, from the release on.

    On the latch the gripper turns with the baseline. Opened, it is pushed off as in that mission,
    with the same errors of the release.
    """

    def __init__(self, settings: space.DynamicsParams, run: Run, orbit: OrbitParams,
                 gripper: GripperParams, tether: TetherParams, approach: ApproachParams,
                 arrival: ArrivalParams, preparation: Preparation, scatter: NDArray,
                 batch: tuple) -> None:
        super().__init__(settings, run, orbit, gripper, tether, approach, arrival, preparation,
                         scatter, batch)
        self._pushed, self._wound = self._states.copy(), self._reels.copy()
        self._latched = np.ones(len(self._states), dtype=bool)
        self._states = self._released(0.0)
        self._on_latch(0.0)

    def step(self, k: int, thrust: Any, craft: Any) -> dict[str, Any]:
        """Return the truth of step k; `craft` says which latches opened in the step before."""
        self._opens = np.reshape(craft.released, -1)
        return super().step(k, thrust)

    def _advance(self, t: float, commands: NDArray) -> None:
        opened = self._latched & self._opens
        if opened.any():
            self._states = np.where(opened[:, np.newaxis], self._released(t), self._states)
            self._reels = np.where(opened[:, np.newaxis], self._wound, self._reels)
            self._latched &= ~opened
        super()._advance(t, commands)
        self._on_latch(t + self._h)

    def _on_latch(self, t: float) -> None:
        """Put those on the latch where it is."""
        if not self._latched.any():
            return
        there = self._released(t)
        rate = self._orbit.at(t).rate
        spin = np.broadcast_to([0.0, 0.0, rate], (len(there), 3))
        there[:, 3:6] = np.cross(spin, there[:, :3])
        there[:, 10:] = geometry.to_body(there[:, 6:10], spin)
        self._states = np.ascontiguousarray(
            np.where(self._latched[:, np.newaxis], there, self._states))
        self._reels = np.where(self._latched[:, np.newaxis], self._wound, self._reels)

    def _released(self, t: float) -> NDArray[np.float64]:
        """Return the states (N, 13) of a release at a time."""
        angle, made = turn(self._orbit, t), self._pushed.copy()
        made[:, :3], made[:, 3:6] = (turned(angle, made[:, part])
                                     for part in (slice(0, 3), slice(3, 6)))
        made[:, 6:10] = geometry.product(geometry.quaternion([0.0, 0.0, angle]), made[:, 6:10])
        return made
