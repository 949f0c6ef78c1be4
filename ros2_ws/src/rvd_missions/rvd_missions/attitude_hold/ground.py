"""
The law on the ground: it reads what came down the link and sends its command up.

It makes no prediction: it holds the axis as long as the delay around the loop leaves it a margin.
"""

from typing import Any

import numpy as np

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control as Asked
from rvd_dynamics.diagram.run import Legs, Run
from rvd_missions.attitude_hold.commands import TorqueForm
from rvd_missions.attitude_hold.control import Control
from rvd_missions.attitude_hold.settings import Attitude
from rvd_missions.attitude_hold.signals import COMMAND, LAW, UPLINK


class GroundController:
    """Fires on each telemetry frame, empty ones too."""

    def __init__(self, settings: Any, form: TorqueForm, attitude: Attitude, run: Run, legs: Legs,
                 batch: tuple) -> None:
        self._control = Control(settings.selected, form, attitude, run.step_s, legs.loop, batch)

    def step(self, k: int, telemetry: Any, control: Asked) -> dict[str, Any]:
        """Return the command of step k and the uplink that carries it."""
        command = self._control.command(k, telemetry.state[..., 0], telemetry.received)
        kind = np.uint8(KIND_ABORT if control.abort else KIND_THRUST)
        return {'command': COMMAND(command=command, kind=kind),
                'uplink': UPLINK(command=command, kind=kind, expedited=np.bool_(control.abort)),
                'law': LAW(error=self._control.error,
                           reference=np.float64(self._control.reference),
                           inside=self._control.inside)}
