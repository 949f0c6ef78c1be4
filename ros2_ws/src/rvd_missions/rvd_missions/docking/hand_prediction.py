"""
The predictor of a craft that is flown through the link, as a block, and what it knows of the craft.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT
from rvd_dynamics.commands.hand import HandParams
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.diagram.scenario import Scenario
from rvd_groundstation.prediction.six_dof import (
    CraftModel, LoopModel, SixDofParams, SixDofPredictor, TELEMETRY)
from rvd_missions.docking.onboard import BACK_M_S, BACK_SLOWS_M_S2, FARTHEST
from rvd_missions.docking.settings import OrbitParams

POSE = (('position', slice(0, 3)), ('velocity', slice(3, 6)), ('attitude', slice(6, 10)),
        ('rate', slice(10, 13)))


def craft_model(scenario: Scenario, orbit: OrbitParams) -> CraftModel:
    """Return what the ground knows of the craft's design: its loops, and how it retreats."""
    controller = scenario.settings('docking_controller')
    loops = tuple(LoopModel(
        loop.gain, loop.derivative_s, loop.modulator.on_threshold,
        0.5*(loop.modulator.on_threshold + loop.modulator.off_threshold))
        for loop in (controller.position, controller.attitude))
    return CraftModel(orbit.mean_motion, orbit.radius_m, loops, FARTHEST, BACK_M_S,
                      BACK_SLOWS_M_S2)


class HandPredictor:
    """The craft as it was, and as it will be when a command sent now acts."""

    def __init__(self, settings: SixDofParams, craft_model: CraftModel, hand: HandParams,
                 legs: Legs, batch: tuple, block: Block) -> None:
        self._batch = batch
        self._rows = int(np.prod(batch, dtype=int))
        self._predictor = SixDofPredictor(settings, craft_model, hand, legs, self._rows)
        self._estimate, self._prediction = block.writes['estimate'], block.writes['prediction']

    def step(self, k: int, telemetry: Any, command: Any) -> dict[str, Any]:
        """Return what the ground knows at step k."""
        n = self._rows
        sent = np.broadcast_to(np.reshape(command.command, (-1, 7)), (n, 7)) if k else None
        known = self._predictor.advance(
            np.broadcast_to(np.reshape(telemetry.state, (-1, TELEMETRY)), (n, TELEMETRY)),
            np.broadcast_to(np.reshape(telemetry.received, -1), n), sent,
            np.reshape(np.asarray(command.kind) == KIND_ABORT, -1))
        there = np.isfinite(known.estimate[:, 0])
        safety = np.where(there, known.estimate[:, -1], 0.0).astype(np.uint8)
        return {
            'estimate': self._estimate(
                **{name: self._out(known.estimate[:, part]) for name, part in POSE},
                safety=self._out(safety), valid=self._out(there)),
            'prediction': self._prediction(
                **{name: self._out(known.predicted[:, part]) for name, part in POSE},
                valid=self._out(known.valid))}

    def _out(self, rows: NDArray) -> NDArray:
        return rows.reshape((*self._batch, *rows.shape[1:]))
