"""
The ground segment: a proportional-derivative law on what came down the link.
"""

from typing import Any

import numpy as np

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.params import param, settings

from one_axis.commands import AccelerationForm
from one_axis.signals import COMMAND, TELEMETRY, UPLINK


@settings
class ControllerParams:
    """Gains of the law."""

    stiffness_per_s2: float = param(
        0.04, 'Acceleration per metre of distance [1/s^2].', low=0.0)
    damping_per_s: float = param(
        0.4, 'Acceleration per unit of velocity [1/s].', low=0.0)


class Controller:
    """
    Wants a = -k x - d v for the newest state that came down; neutral before the first.

    It makes no prediction, so the gains must be low for the delay around the loop.
    """

    def __init__(self, settings: ControllerParams, form: AccelerationForm, batch: tuple) -> None:
        self._settings, self._form = settings, form
        self._state = TELEMETRY.initial(batch).state            # NaN: nothing is known yet

    def step(self, k: int, telemetry: Any, control: Control) -> dict[str, Any]:
        """Return the command of step k and the uplink that carries it."""
        received = telemetry.received[..., np.newaxis]
        self._state = np.where(received, telemetry.state, self._state)
        x, v = self._state[..., 0:1], self._state[..., 1:2]
        wanted = -self._settings.stiffness_per_s2*x - self._settings.damping_per_s*v
        command = self._form.quantise(wanted)
        kind = np.uint8(KIND_ABORT if control.abort else KIND_THRUST)
        return {'command': COMMAND(command=command, kind=kind),
                'uplink': UPLINK(command=command, kind=kind,
                                 expedited=np.bool_(control.abort))}
