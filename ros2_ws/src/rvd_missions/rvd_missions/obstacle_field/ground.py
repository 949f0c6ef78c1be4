"""
The ground segment: navigation and guidance as blocks.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.params import choice
from rvd_dynamics.diagram.run import Legs, Run
from rvd_groundstation.guidance.safe_apf import SafeApf
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_missions.obstacle_field.navigation import Navigation, NavigationParams
from rvd_missions.obstacle_field.settings import Obstacles, Orbit, Start
from rvd_missions.obstacle_field.signals import ESTIMATE, PREDICTION

THRUST, ABORT = np.uint8(KIND_THRUST), np.uint8(KIND_ABORT)

LAWS = {'safe_apf': SafeApf}
ControllerParams = choice('ControllerParams', 'law', LAWS, 'safe_apf',
                          'Guidance law of the automatic controller.')


class StatePredictor:
    """Where chaser and obstacles will be when a command sent now acts."""

    def __init__(self, settings: NavigationParams, run: Run, legs: Legs, orbit: Orbit, start: Start,
                 obstacles: Obstacles, form: CommandForm, batch: tuple, block: Block,
                 wanted: frozenset[str], abort_profile: AbortProfile) -> None:
        track = bool({'estimate.covariance', 'prediction.covariance'} & wanted)
        self._navigation = Navigation(settings, run, legs, orbit, start, obstacles, form, batch,
                                      track, abort_profile)
        self.news = self._navigation.news
        self._obstacles = block.writes['obstacles']
        self._estimate, self._prediction = block.writes['estimate'], block.writes['prediction']

    def step(self, k: int, telemetry: Any, command: Any, late: Mapping[int, Any] | None = None
             ) -> dict[str, Any]:
        """Return what the ground knows at step k; `late`: commands that were missing before."""
        known = self._navigation.advance(
            k, telemetry.state, telemetry.received, command.command if k else None,
            {step: (missed.command, _is_abort(missed)) for step, missed in (late or {}).items()},
            _is_abort(command))
        before, after = known.own
        return {
            'estimate': ESTIMATE(state=known.estimate, valid=known.valid, covariance=before),
            'prediction': PREDICTION(state=known.predicted, valid=known.valid, covariance=after),
            'obstacles': self._obstacles(obstacles=known.obstacles, valid=known.valid,
                                         covariance=known.covariance)}


def _is_abort(command: Any) -> bool:
    """Say whether a command is an ABORT, which it is in all rows or in none."""
    return bool(np.ravel(command.kind)[0] == KIND_ABORT)


class AutoController:
    """The guidance law, and the command form that makes a command of what it wants."""

    def __init__(self, law: SafeApf, run: Run, legs: Legs, form: CommandForm, reach_m: NDArray,
                 batch: tuple, block: Block, wanted: frozenset[str]) -> None:
        self._law, self._form, self._reach_m = law, form, reach_m
        self._step_s, self._forward = run.step_s, legs.forward
        self._command, self._uplink = block.writes['command'], block.writes['uplink']
        self._alarm = block.writes['alarm']
        self._tells = 'alarm' in wanted
        self._neutral = np.broadcast_to(form.neutral, (*batch, 3))
        self._last = self._neutral
        self._on = np.zeros((*batch, len(reach_m)), dtype=bool)

    def step(self, k: int, prediction: Any, obstacles: Any, control: Control) -> dict[str, Any]:
        """Return the command of step k, the uplink that carries it, and the alarms."""
        law, state = self._law, prediction.state
        met = law.encounter(state, obstacles.obstacles, self._reach_m)
        self._on, probability = law.alarmed(met, obstacles.covariance, self._on)
        t_s = (k + self._forward) * self._step_s
        wish = law.acceleration(state, t_s, law.repulsion(met, self._on))
        command = self._form.follow(self._last, wish)
        kind = THRUST
        if control.abort:
            command, kind = self._neutral, ABORT
        self._last = command
        made = {'command': self._command(command=command, kind=kind),
                'uplink': self._uplink(command=command, kind=kind,
                                       expedited=np.bool_(control.abort))}
        if self._tells:
            made['alarm'] = self._alarm(
                on=self._on, distance=met.distance, zone=met.zone, probability=probability)
        return made
