"""
The ground segment: the predictor, and the law on what it predicts.
"""

from typing import Any

import numpy as np

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.motion.kepler import EllipseParams
from rvd_groundstation.guidance.range_rate import line_of_sight
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_missions.elliptic_rendezvous.laws import Rrca
from rvd_missions.elliptic_rendezvous.prediction import VaryingPredictor
from rvd_missions.elliptic_rendezvous.settings import ArrivalParams
from rvd_missions.elliptic_rendezvous.signals import GUIDANCE, PREDICTION
from rvd_missions.elliptic_rendezvous.thrust import ThrustParams, Thrusters


def law(scenario: Scenario) -> Rrca:
    """Return the law of a scenario."""
    return scenario.part('guidance').selected


class StatePredictor:
    """Where the chaser will be when a command sent now acts."""

    def __init__(self, orbit: EllipseParams, legs: Legs, form: CommandForm, batch: tuple,
                 abort_profile: AbortProfile) -> None:
        self._predictor = VaryingPredictor(orbit, legs, form, batch, abort_profile)

    def step(self, k: int, telemetry: Any, command: Any) -> dict[str, Any]:
        """Return the prediction of step k."""
        _, ahead = self._predictor.advance(
            k, telemetry.state, telemetry.received, command.command,
            bool(np.ravel(command.kind)[0] == KIND_ABORT))
        return {'prediction': PREDICTION(state=ahead, valid=np.isfinite(ahead).all(axis=-1))}


class AutoController:
    """The law, and the thrusters that carry it out."""

    def __init__(self, settings: ThrustParams, law: Rrca, orbit: EllipseParams,
                 arrival: ArrivalParams, legs: Legs, form: CommandForm, batch: tuple,
                 block: Block) -> None:
        self._law, self._orbit, self._arrival, self._form = law, orbit, arrival, form
        self._legs, self._lag_s = legs, 1.0/settings.rate_gain_per_s
        self._thrusters = Thrusters(settings, legs.step_s, batch)
        self._near = np.zeros(batch, dtype=bool)
        self._command, self._uplink = block.writes['command'], block.writes['uplink']
        self._last = self._neutral = np.broadcast_to(form.neutral, (*batch, 3))

    def step(self, k: int, prediction: Any, control: Control) -> dict[str, Any]:
        """Return the command of step k, the uplink that carries it, and what the law sees."""
        target = self._orbit.at((k + self._legs.forward)*self._legs.step_s)
        c = self._orbit.parameter/target.radius
        state, hold = prediction.state, self._arrival.range_m
        los = line_of_sight(state)
        if self._law.flies_around:
            stops_at = los.range + los.range_rate*self._lag_s       # if it were stopped now
            self._near = self._near | (stops_at <= hold)
        demand = self._law.demand(los, target, c, self._near, hold)
        along, across, out = self._thrusters.acceleration(state, los, demand, target, c,
                                                          self._law.k)
        s, side = np.sin(los.direction), np.cos(los.direction)
        wanted = np.stack([along*s + across*side, along*side - across*s, out], axis=-1)
        command = self._form.follow(self._last, wanted)
        kind = KIND_THRUST
        if control.abort:
            command, kind = self._neutral, KIND_ABORT
        self._last = command
        made = {'command': self._command(command=command, kind=np.uint8(kind)),
                'uplink': self._uplink(command=command, kind=np.uint8(kind),
                                 expedited=np.bool_(control.abort))}
        made['guidance'] = GUIDANCE(
            range=los.range, direction=los.direction, range_rate=los.range_rate,
            direction_rate=los.direction_rate, reference_rate=demand.range_rate, along=along,
            across=across, anomaly=np.full(los.range.shape, target.anomaly), near=self._near)
        return made
