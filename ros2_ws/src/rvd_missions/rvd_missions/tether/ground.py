"""
The ground segment: what the telemetry tells of the approach, and whether to go on.

Each frame that goes up carries the inputs that the plan has for the step in which it will act, and
says whether to go on or to ABORT. The tracker holds the plan itself, so that a frame that is lost
costs nothing.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.run import Legs, Run
from rvd_missions.tether import geometry
from rvd_missions.tether.commands import TetherForm
from rvd_missions.tether.inputs import InputParams, joined, limits
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.signals import COMMAND, SITUATION, TELEMETRY, UPLINK


class MissionControl:
    """Fires on each telemetry frame, empty ones too."""

    def __init__(self, preparation: Preparation, inputs: InputParams, form: TetherForm, run: Run,
                 legs: Legs, batch: tuple) -> None:
        p, self._batch, self._legs, self._h = preparation, batch, legs, run.step_s
        self._orbit, self._length = p.orbit, p.approach.baseline_m
        times = np.arange(p.last_step(run) + 1)*run.step_s
        self._inputs = form.quantise(joined(p.plan, inputs.spline, times,
                                            *limits(p.gripper, p.tether)))
        self._way = p.plan.state_at(np.clip(times, p.plan.begin_s, p.plan.end_s))[:, :3]
        self._state = TELEMETRY.initial(batch).state                # NaN: nothing is known yet

    def step(self, k: int, telemetry: Any, control: Control) -> dict[str, Any]:
        """Return the situation of step k, the command and the uplink that carries it."""
        self._state = np.where(telemetry.received[..., np.newaxis], telemetry.state, self._state)
        command = np.broadcast_to(self._inputs[min(k + self._legs.forward, len(self._inputs) - 1)],
                                  (*self._batch, 7))
        kind = np.uint8(KIND_ABORT if control.abort else KIND_THRUST)
        return {'command': COMMAND(command=command, kind=kind),
                'uplink': UPLINK(command=command, kind=kind, expedited=np.bool_(control.abort)),
                'situation': self._situation(max(k - self._legs.back, 0), self._state)}

    def _situation(self, at: int, state: NDArray) -> Any:
        """Return what a telemetry state (..., 14) of a step tells."""
        seen, planned, distance = state[..., :6], state[..., 6:12], state[..., 12]
        target = geometry.baseline(self._orbit, self._length, at*self._h).place
        alpha, beta = seen[..., 1], seen[..., 2]
        towards = np.stack([np.cos(beta)*np.cos(alpha), np.cos(beta)*np.sin(alpha), np.sin(beta)],
                           axis=-1)
        attitude = geometry.quaternion(seen[..., 3:])
        here = (*self._batch, 3)
        return SITUATION(
            gripper=target - distance[..., np.newaxis]*towards,
            planned=np.broadcast_to(self._way[min(at, len(self._way) - 1)], here),
            target=np.broadcast_to(target, here), attitude=attitude, error=seen - planned,
            range=distance, sight_angle=geometry.sight_angle(attitude, towards),
            tension=state[..., 13])
