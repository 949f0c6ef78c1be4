"""
The law on board: it reads the sensors and hands its command to the guard.
"""

from typing import Any

import numpy as np

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control as Asked
from rvd_dynamics.diagram.run import Run
from rvd_missions.attitude_hold.commands import TorqueForm
from rvd_missions.attitude_hold.control import Control
from rvd_missions.attitude_hold.settings import Attitude
from rvd_missions.attitude_hold.signals import LAW, WANTED


class OnboardController:
    """Fires on each measurement."""

    def __init__(self, settings: Any, form: TorqueForm, attitude: Attitude, run: Run,
                 batch: tuple) -> None:
        self._control = Control(settings.selected, form, attitude, run.step_s, 0, batch)
        self._received = np.ones(batch, dtype=bool)

    def step(self, k: int, measurement: Any, control: Asked) -> dict[str, Any]:
        """Return the command of step k, for the guard."""
        command = self._control.command(k, measurement.state[..., 0], self._received)
        kind = np.uint8(KIND_ABORT if control.abort else KIND_THRUST)
        return {'wanted': WANTED(command=command, kind=kind, received=self._received),
                'law': LAW(error=self._control.error,
                           reference=np.float64(self._control.reference),
                           inside=self._control.inside)}
