"""
Prediction of a craft in six degrees of freedom, flown by hand through a link.

At step k the telemetry is that of the craft at step k - back. Commands that have been sent and that
this telemetry cannot show yet act on steps k - back to k + forward - 1; the predictor carries the
telemetry over them, so that what the operator sees is the craft at the instant at which a command
sent now will act.

Model    translation with the linear and quadratic terms of gravity (paper, eq. 1), attitude
         kinematics and a rigid body (eq. 2, without panels and tanks); the craft's loops by the
         mean of their modulators (duty = |X| - (H_E + H_A)/2 above the dead band, at most 1);
         clicks as pulses of the nominal force; what is held moves as the craft moves it.
Left out flexible panels and sloshing, delays of valves, noise of the pulses, the limit cycle
         within the dead band; what an ABORT does: then there is no prediction.
Frames   position and velocity in LVLH (x along the target's velocity, z to the Moon), attitude
         (x, y, z, w) from body to LVLH, rate inertial in body axes.
Source   An, Qu, Wang 2015, for the craft; prediction by replaying what was sent: Zhang, Li, Tang
         2014, eq. 7, here for a plant that is not linear.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.hand import HandParams, Hands
from rvd_dynamics.diagram.limits import LARGEST
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Legs

Array = NDArray[np.float64]
TELEMETRY, STATE = 21, 13               # numbers of a row of telemetry, and of what is predicted
ABORT = 3


@settings
class SixDofParams:
    """The craft as the ground takes it to be."""

    mass_kg: float = param(2000.0, 'Mass of the craft [kg].', above=0.0, high=1e6)
    inertia_kg_m2: tuple = param((2200.0, 3000.0, 2800.0), 'Moments of inertia [kg m^2].',
                                 above=0.0, high=1e9, length=3)
    force_n: float = param(40.0, 'Force of translation [N].', above=0.0, high=1e6)
    torque_n_m: float = param(16.0, 'Torque of rotation [N m].', above=0.0, high=1e6)
    brake_n: float = param(240.0, 'Force of the brake when it backs away [N].', low=0.0, high=1e6)
    bridge_s: float = param(2.0, 'Time without telemetry that is bridged [s].', low=0.0, high=60.0)


class LoopModel(NamedTuple):
    """A loop of the craft as the ground knows it."""

    gain: float
    derivative_s: float
    on: float                           # input at which its modulator fires, H_E
    middle: float                       # (H_E + H_A)/2


class CraftModel(NamedTuple):
    """What the predictor knows of orbit and craft besides its own settings."""

    mean_motion: float                  # [rad/s]
    radius_m: float                     # [m] of the orbit
    loops: tuple[LoopModel, LoopModel]  # position, attitude
    farthest_m: float                   # [m] x of the craft's centre where a retreat ends
    back_m_s: float                     # [m/s] speed of a retreat
    back_slows_m_s2: float              # [m/s^2] by which it slows down before its end


class Known(NamedTuple):
    """What the ground knows in one step, (N, ...); NaN in rows that are not valid."""

    estimate: Array                     # (N, 21) telemetry, the newest that came
    predicted: Array                    # (N, 13)
    valid: NDArray[np.bool_]            # (N,)


class SixDofPredictor:
    """N rows, called once per step, in order."""

    def __init__(self, params: SixDofParams, craft: CraftModel, hand: HandParams, legs: Legs,
                 rows: int) -> None:
        from rvd_groundstation.prediction import six_dof_compiled as machine
        self._predict = machine.predict
        self._model = np.array([
            legs.step_s, craft.mean_motion, craft.radius_m, params.mass_kg, *params.inertia_kg_m2,
            params.force_n, params.torque_n_m, *craft.loops[0], *craft.loops[1], params.brake_n,
            craft.farthest_m, craft.back_m_s, craft.back_slows_m_s2,
            np.radians(hand.rate_deg_s)])
        assert len(self._model) == machine.MODEL
        self._loop, self._bridge = legs.loop, round(params.bridge_s/legs.step_s)
        self._hands = Hands(hand, legs.step_s, rows)
        steps = self._loop + self._bridge
        # wishes of the last `steps` steps, each kept twice, so that those in use lie in a row
        self._push = np.zeros((2*steps, rows, 6), dtype=np.int8)
        self._speed, self._spin = np.zeros((2, 2*steps, rows, 3))
        self._drifts = np.zeros((2*steps, rows, 2), dtype=bool)
        self._resume = np.zeros((2*steps, rows), dtype=bool)
        self._steps, self._count = steps, 0
        self._telemetry = np.full((rows, TELEMETRY), np.nan)
        self._age = np.zeros(rows, dtype=np.int64)             # steps since it came
        self._aborted = np.zeros(rows, dtype=bool)

    def advance(self, telemetry: ArrayLike, received: ArrayLike, sent: ArrayLike | None,
                aborted: ArrayLike = False) -> Known:
        """
        Return what is known in this step.

        Parameters
        ----------
        telemetry : array_like, shape (N, 21)
            Position, velocity, attitude, rate, place and attitude that are held, safety state.
        received : array_like of bool, shape (N,)
        sent : array_like, shape (N, 7)
            Command sent in the step before; None in the first step.
        aborted : array_like of bool, shape (N,)
            That command was an ABORT.
        """
        telemetry = np.asarray(telemetry, dtype=float)
        if sent is not None:
            self._aborted = self._aborted | aborted
            self._remember(np.asarray(sent))
        came = np.asarray(received, dtype=bool) & np.isfinite(telemetry).all(axis=-1)
        self._telemetry = np.where(came[:, None], telemetry, self._telemetry)
        self._age = np.where(came, 0, self._age + 1)
        valid = (np.isfinite(self._telemetry[:, 0]) & (self._age <= self._bridge)
                 & ~self._aborted & (self._telemetry[:, -1] < ABORT))
        out = np.full((len(telemetry), STATE), np.nan)
        rows = np.flatnonzero(valid)
        if len(rows) == len(out):
            rows = slice(None)
        if valid.any():
            self._carry(rows, out)
            fits = (np.abs(out) <= LARGEST).all(axis=-1)        # NaN does not
            if (valid & ~fits).any():
                valid = valid & fits
                out[~valid] = np.nan
        return Known(self._telemetry, out, valid)

    def _remember(self, sent: NDArray) -> None:
        wish = self._hands.step(sent)
        if not self._steps:
            return
        at = self._count % self._steps
        for where, what in ((self._push, wish.push), (self._speed, wish.speed),
                            (self._spin, wish.spin), (self._drifts, wish.drifts),
                            (self._resume, wish.resume)):
            where[at] = where[at + self._steps] = what
        self._count += 1

    def _carry(self, rows: NDArray | slice, out: Array) -> None:
        """Predict some rows: over the wishes of the loop, and of what was bridged."""
        first = self._count % self._steps if self._steps else 0
        span = slice(first, first + self._steps)               # oldest to newest
        begin = self._bridge - self._age[rows]
        found = np.empty((len(begin), STATE))
        self._predict(np.ascontiguousarray(self._telemetry[rows]), begin, *(
            np.ascontiguousarray(kept[span][:, rows]) for kept in (
                self._push, self._speed, self._spin, self._drifts, self._resume)),
            self._model, found)
        out[rows] = found
