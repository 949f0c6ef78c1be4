"""
The craft flown by hand: its controller, and what it sends down.

The hands' wishes go through the loops, the allocation and the safety strategy of the automatic
approach, and through the guard. Rates move the place and the attitude that the loops hold; a pulse
opens the thrusters of its axis, whose loop rests. From HOLD on the craft flies by itself, until the
operator resumes; the attitude then goes back to that of the target at the rate of a full
deflection.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.hand import HandForm, Hands, together
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.motion import attitude
from rvd_missions.docking import markers
from rvd_missions.docking.commands import ValveForm
from rvd_missions.docking.hand_signals import DOWNLINK, STEERING
from rvd_missions.docking.onboard import backing, Controller, ControllerParams
from rvd_missions.docking.safety import ABORT, HOLD, NOMINAL, RETREAT
from rvd_missions.docking.settings import Aim, OrbitParams
from rvd_missions.docking.signals import GUIDANCE, WANTED


class HandController(Controller):
    """Does what two hand controllers ask for, within the safety strategy."""

    def __init__(self, settings: ControllerParams, run: Run, aim: Aim, orbit: OrbitParams,
                 form: ValveForm, hand_form: HandForm, runs: Sequence[int],
                 batch: tuple) -> None:
        super().__init__(settings, run, aim, orbit, form, runs, batch)
        rows = int(np.prod(batch, dtype=int))
        hand = hand_form.hand
        self._hands = Hands(hand, run.step_s, rows)
        self._command = np.zeros((rows, 7), dtype=np.int8)
        self._age = np.zeros(rows, dtype=np.int64)              # steps since it came
        self._patience = round(hand.hold_s/run.step_s)
        self._slew = np.radians(hand.rate_deg_s)
        self._place = np.full((rows, 3), np.nan)
        self._turn = np.full((rows, 4), np.nan)
        self._state = np.zeros(rows, dtype=np.uint8)
        self._aborted = np.zeros(rows, dtype=bool)

    def step(self, k: int, estimate: Any, control: Control = Control(), translation: Any = None,
             rotation: Any = None, hand: Any = None) -> dict[str, Any]:
        """Return valves, guidance and steering of step k."""
        rows = len(self._place)
        r, v, q, rate, nis = (np.reshape(getattr(estimate, name), (rows, -1)) for name in
                              ('position', 'velocity', 'attitude', 'rate', 'nis'))
        wish = self._hands.step(self._heard(translation, rotation, hand, control))
        port = r + attitude.rotate(q, np.broadcast_to(markers.CHASER_PORT, r.shape)) \
            - markers.TARGET_PORT
        spin = rate + self._n*attitude.matrix(q)[:, 1]          # relative to the target
        self._safety.resume(wish.resume & (self._state > NOMINAL))
        state = self._safety.advance(k*self._run.step_s, port, v[:, 0],
                                     attitude.rotation_vector(q), spin, nis, self._pushed)
        speed, turning, drifts = self._follow(r, q, wish, state)
        away = attitude.rotate_back(q, self._place - r)
        lean = attitude.rotation_vector(attitude.multiply(attitude.conjugate(self._turn), q))
        error = np.concatenate([np.where(drifts[:, :1], np.nan, away),
                                np.where(drifts[:, 1:], np.nan, -lean)], axis=-1)
        change = np.concatenate([attitude.rotate_back(q, speed - v), turning - spin], axis=-1)
        demand = self._loops.step(error, change)
        demand = np.where(np.repeat(drifts, 3, axis=-1), wish.push, demand)
        valves = self._shares.open(self._allocated(demand))
        backing = (state == RETREAT) & (demand[:, 0] < 0.0)
        valves = valves | (backing[:, None] & self._brake)
        abort, out = (state == ABORT) | self._aborted, self._out
        return {
            'wanted': WANTED(command=out(valves.astype(np.uint8)),
                             kind=out(np.where(abort, KIND_ABORT, KIND_THRUST).astype(np.uint8)),
                             received=np.ones(self._batch, dtype=bool)),
            'guidance': GUIDANCE(reference=out(self._place.copy()), error=out(error),
                                 demand=out(demand), safety=out(state.copy())),
            'steering': STEERING(reference=out(self._place.copy()), attitude=out(self._turn.copy()),
                                 command=out(self._command.copy()))}

    def _heard(self, translation: Any, rotation: Any, hand: Any, control: Control) -> NDArray:
        """Return the commands (N, 7) in force; the last one goes on for a while."""
        rows, abort = len(self._place), np.bool_(control.abort)
        if hand is None:
            command, came = together(translation, rotation), np.bool_(True)
        else:
            command, came = hand.command, np.reshape(hand.received, -1)
            abort = came & np.reshape(np.asarray(hand.kind) == KIND_ABORT, -1)
        self._aborted = self._aborted | abort
        command = np.broadcast_to(np.reshape(command, (-1, 7)), (rows, 7))
        self._age = np.where(came, 0, self._age + 1)
        kept = np.where((self._age <= self._patience)[:, None], self._command, 0)
        self._command = np.where(np.reshape(came, (-1, 1)), command, kept).astype(np.int8)
        return self._command

    def _follow(self, r: NDArray, q: NDArray, wish: Any, state: NDArray
                ) -> tuple[NDArray, NDArray, NDArray]:
        """Move what is held; return its velocity (N, 3), spin (N, 3), and who drifts (N, 2)."""
        dt, stopped = self._run.step_s, state >= HOLD
        new = np.isnan(self._place[:, 0]) | ((state > NOMINAL) & (self._state == NOMINAL))
        fresh = np.isnan(self._turn[:, 0])
        self._state = state.copy()
        drifts = wish.drifts & ~stopped[:, None]
        self._place = np.where((new | drifts[:, 0])[:, None], r, self._place)
        self._turn = np.where((fresh | drifts[:, 1])[:, None], q, self._turn)
        going = np.where(state == RETREAT, backing(self._place[:, 0], dt), 0.0)
        back = going[:, None]*np.array([-1.0, 0.0, 0.0])
        speed = np.where(stopped[:, None], back, attitude.rotate(q, wish.speed))
        lean = attitude.rotation_vector(self._turn)
        size = np.sqrt((lean*lean).sum(axis=-1, keepdims=True))
        home = -lean*np.minimum(self._slew/np.maximum(size, 1e-12), 1.0)
        spin = np.where(stopped[:, None], home, wish.spin)
        held = np.where(drifts[:, :1], 0.0, speed)
        self._place = self._place + dt*held
        turned = attitude.multiply(self._turn, attitude.from_rotation_vector(
            dt*np.where(drifts[:, 1:], 0.0, spin)))
        self._turn = attitude.normalised(turned)
        return held, spin, drifts


class Telemetry:
    """What the craft sends down in each step."""

    def __init__(self, batch: tuple) -> None:
        self._batch = batch

    def step(self, k: int, estimate: Any, steering: Any, guidance: Any) -> dict[str, Any]:
        """Return the downlink of step k: estimate of now, what was held in the step before."""
        safety = np.broadcast_to(guidance.safety, self._batch)[..., np.newaxis].astype(float)
        return {'downlink': DOWNLINK(state=np.concatenate([
            estimate.position, estimate.velocity, estimate.attitude, estimate.rate,
            steering.reference, steering.attitude, safety], axis=-1))}
