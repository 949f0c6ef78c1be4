"""
Navigation of the ground: where chaser and obstacles will be when a command sent now acts.

`direct` takes what came down as it is: the source's ideal sensors, without a delay. `filter` is
the predictor of the house (`rvd_groundstation.prediction`) for the chaser, and for the obstacles a
Kalman filter whose gains are computed on the way, the same for all rows: a covariance depends on no
measured value, and a lost sample skips the update and keeps the sequence.

Covariance of the relative position, for the alarm: with `open_loop` that of the start, carried by
the motion and never improved by a measurement, as in the source; with `predicted` that of the
predictor, and of the filter of each obstacle.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.news import begun_anew, News
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.geometry.collision import require_definite
from rvd_dynamics.motion import cw
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_groundstation.prediction.filter_params import FilterParams
from rvd_groundstation.prediction.predictor import Predictor, PredictorParams
from rvd_missions.obstacle_field.settings import Obstacles, Orbit, Start

Array = NDArray[np.float64]
PROCESS_FLOOR = 1e-10                   # [m^2, m^2/s^2] variance added to an obstacle per step


@settings
class NavigationParams:
    """Settings of `state_predictor`."""

    method: str = param(
        'auto', 'Whether the ground takes measurements as they are (direct), filters and predicts '
        '(filter), or filters where the link has a delay (auto).',
        choices=('auto', 'direct', 'filter'))
    covariance: str = param(
        'auto', 'Covariance of the alarm: that of the start carried by the motion (open_loop), '
        'that of the predictor (predicted), or the predictor\'s where there is one (auto).',
        choices=('auto', 'open_loop', 'predicted'))
    position_sigma_m: tuple = param(
        (0.1, 0.1, 0.1), 'Standard deviations of the relative position at the start along x, y and '
        'z, for open_loop [m].', above=0.0, length=3)
    position_correlation: tuple = param(
        (0.0, 0.0, 0.0), 'Correlations of the relative position at the start, xy, xz and yz.',
        low=-1.0, high=1.0, length=3)
    velocity_sigma_m_s: tuple = param(
        (5e-4, 5e-4, 5e-4), 'Standard deviations of the relative velocity at the start along x, y '
        'and z, for open_loop [m/s].', low=0.0, length=3)
    assumed_position_sigma_m: float = param(
        0.02, 'Standard deviation of a measured position that the filters assume [m].', above=0.0,
        high=100.0)
    assumed_velocity_sigma_m_s: float = param(
        0.002, 'Standard deviation of a measured velocity that the filters assume [m/s].',
        above=0.0, high=10.0)
    process_noise_m_s2: float = param(
        1e-5, 'Standard deviation of the acceleration of the chaser that the filter does not know '
        '[m/s^2].', low=0.0, high=1.0)
    gate_nis: float = param(
        1e4, 'Normalised innovation squared of an obstacle above which its measurement is an '
        'outlier and left out.', above=0.0)
    gate_patience: int = param(
        10, 'Outliers of an obstacle in a row after which its filter begins anew.', low=1)

    def __post_init__(self) -> None:
        xy, xz, yz = self.position_correlation
        correlation = np.array([[1.0, xy, xz], [xy, 1.0, yz], [xz, yz, 1.0]])
        least = float(np.linalg.eigvalsh(correlation).min())
        require(least > 0.0, 'position_correlation', 'make a positive definite covariance, not one '
                f'with an eigenvalue of {least:.3g}', list(self.position_correlation))

    def start_covariance(self) -> Array:
        """Return the covariance (6, 6) of the relative state at the start."""
        xy, xz, yz = self.position_correlation
        sigma = np.array(self.position_sigma_m)
        made = np.zeros((6, 6))
        correlation = np.array([[1.0, xy, xz], [xy, 1.0, yz], [xz, yz, 1.0]])
        made[:3, :3] = correlation * np.outer(sigma, sigma)
        made[3:, 3:] = np.diag(np.square(self.velocity_sigma_m_s))
        require_definite(made[:3, :3], 'position covariance')
        return made

    def filter(self) -> PredictorParams:
        """Return the settings of the chaser's filter."""
        kalman = FilterParams(
            process_noise_m_s2=self.process_noise_m_s2, process_variance_floor=PROCESS_FLOOR,
            measurement_fraction=1e-12, position_sigma_m=self.assumed_position_sigma_m,
            velocity_sigma_m_s=self.assumed_velocity_sigma_m_s,
            start_position_sigma_m=(10.0,) * 3, start_velocity_sigma_m_s=(1.0,) * 3,
            gate_patience=self.gate_patience)
        return PredictorParams(
            in_flight='as_sent', filter='scheduled', prior='kalman', kalman=kalman)

    def on(self, legs: Legs) -> 'Chosen':
        """
        Return what `auto` means for a link.

        Raises
        ------
        ValueError
            If measurements are to be taken as they are through a delay, or a covariance is asked
            for that nobody has.
        """
        filters = legs.loop > 0 if self.method == 'auto' else self.method == 'filter'
        require(filters or legs.loop == 0, 'method', 'be filter or auto where the link has a delay',
                self.method)
        require(filters or self.covariance != 'predicted', 'covariance',
                'be open_loop or auto where nothing is predicted', self.covariance)
        return Chosen(filters, filters and self.covariance != 'open_loop')


class Chosen(NamedTuple):
    """How the ground navigates."""

    filters: bool
    predicted: bool                     # the covariance of the alarm is the predictor's


class Known(NamedTuple):
    """What the ground knows in one step."""

    estimate: Array                     # (..., 6) at k - back
    predicted: Array                    # (..., 6) at k + forward
    obstacles: Array                    # (..., M, 6) at k + forward
    valid: NDArray[np.bool_]            # (...)
    covariance: Array                   # (..., M, 3, 3) of the relative position at k + forward
    own: tuple[Any, Any]                # (..., 6, 6) of estimate and prediction, or None


class Direct:
    """What came down, as it is; where nothing came, the last state carried on by the motion."""

    def __init__(self, orbit: Orbit, run: Run, form: CommandForm, obstacles: Obstacles,
                 batch: tuple) -> None:
        self._phi = cw.transition(orbit.mean_motion, run.step_s)
        self._gamma = cw.input_matrix(orbit.mean_motion, run.step_s)
        self._form, self._moving, self._batch = form, obstacles.moving, batch
        self._state = np.full((*batch, 6), np.nan)
        self._obstacles = np.full((*batch, obstacles.count, 6), np.nan)
        self.valid = np.zeros(batch, dtype=bool)

    def advance(self, measured: Array, received: NDArray, sent: Any) -> tuple[Array, Array]:
        """Return states (..., 6) and obstacles (..., M, 6) of this step."""
        own, around = apart(measured)
        if not received.all():
            accel = self._form.effect(sent)
            carried = cw.step(self._state, accel, self._phi, self._gamma)
            own = np.where(received[..., None], own, carried)
            around = np.where(received[..., None, None], around,
                              drifted(self._obstacles, self._phi, self._moving))
            self.valid = self.valid | received
        elif not self.valid.all():
            self.valid = np.ones_like(self.valid)
        self._state, self._obstacles = own, around
        return own, around


@dataclass
class _Gains:
    """The Kalman filter of one kind of obstacle, run ahead of its measurements."""

    phi: Array                          # (6, 6) of a step
    noise: Array                        # (6, 6) R
    covariance: Array                   # (6, 6) after the last update
    spread: Array = field(default_factory=lambda: np.ones(6))   # (6,) of the last innovation

    def next(self, first: bool) -> Array:
        """Move on by a sample, and return its gain (6, 6)."""
        if not first:
            self.covariance = cw.carried(self.covariance, self.phi) + PROCESS_FLOOR*np.eye(6)
        self.spread = np.diagonal(self.covariance + self.noise)
        gain = np.linalg.solve(self.covariance + self.noise, self.covariance).T
        keep = np.eye(6) - gain
        self.covariance = keep @ self.covariance @ keep.T + gain @ self.noise @ gain.T
        return gain


class Tracker:
    """Filters of the obstacles, and their prediction over the loop."""

    def __init__(self, params: NavigationParams, orbit: Orbit, run: Run, legs: Legs,
                 obstacles: Obstacles, batch: tuple) -> None:
        n, h = orbit.mean_motion, run.step_s
        self._phi, self._loop = cw.transition(n, h), cw.transition(n, h * legs.loop)
        self._moving, self._back = obstacles.moving, legs.back
        variance = np.repeat(np.square([params.assumed_position_sigma_m,
                                        params.assumed_velocity_sigma_m_s]), 3)
        start = np.diag(np.repeat([100.0, 1.0], 3))
        # a static obstacle has no velocity, and its filter knows
        stands = np.diag([1.0]*3 + [0.0]*3)
        self._gains = {False: _Gains(np.eye(6), np.diag(variance),
                                     stands @ start + 1e-12*np.eye(6)),
                       True: _Gains(self._phi, np.diag(variance), start)}
        self._state = np.full((*batch, obstacles.count, 6), np.nan)
        self._gate, self._patience = params.gate_nis, params.gate_patience
        self._lost, self._in_a_row = np.zeros((2, *batch, obstacles.count), dtype=np.int64)
        self._anew = np.zeros((*batch, obstacles.count), dtype=bool)

    def advance(self, k: int, measured: Array, received: NDArray) -> Array:
        """Return the obstacles (..., M, 6) foreseen for a command of step k."""
        if k >= self._back:
            carried = drifted(self._state, self._phi, self._moving)
            gain = {moves: gains.next(k == self._back) for moves, gains in self._gains.items()}
            known = np.isfinite(carried[..., 0])
            innovation = measured - carried
            good = ~known | self._fits(innovation)
            received = received[..., None]
            self._in_a_row = np.where(received, np.where(good, 0, self._in_a_row + 1),
                                      self._in_a_row)
            self._anew = anew = received & (self._in_a_row > self._patience)
            self._in_a_row = np.where(anew, 0, self._in_a_row)
            received = received & (good | anew)
            self._lost = np.where(received, 0, self._lost + 1)
            known = known & ~anew
            update = np.where(self._moving[:, None], cw.product(gain[True], innovation),
                              cw.product(gain[False], innovation))
            updated = np.where(known[..., None], carried + update, measured)
            self._state = np.where(received[..., None], updated, carried)
        return drifted(self._state, self._loop, self._moving)

    def news(self) -> News:
        """Return which obstacles' filters, of any row, have begun anew in the last step."""
        if not self._anew.any():
            return []
        rows = self._anew.reshape(-1, self._anew.shape[-1])
        return [begun_anew(f'obstacle {i}', self._patience)
                for i in np.flatnonzero(rows.any(axis=0))]

    def _fits(self, innovation: Array) -> NDArray:
        """Return which measurements (..., M) are no outliers; see `prediction.filter.Gate`."""
        moving, still = (self._gains[moves].spread for moves in (True, False))
        spread = np.where(self._moving[:, None], moving, still)
        grown = (1 + self._lost)[..., None]
        share = innovation*innovation/(grown*grown*spread)
        return (share[..., 0] + share[..., 1] + share[..., 2] + share[..., 3] + share[..., 4]
                + share[..., 5]) <= self._gate

    def covariance(self) -> Array:
        """Return the covariances (M, 3, 3) [m^2] of the positions foreseen."""
        found = {moves: cw.carried(gains.covariance, self._loop if moves else np.eye(6))[:3, :3]
                 for moves, gains in self._gains.items()}
        return np.array([found[bool(moves)] for moves in self._moving]).reshape(-1, 3, 3)


class Navigation:
    """What `state_predictor` computes; called once per step, in order."""

    def __init__(self, params: NavigationParams, run: Run, legs: Legs, orbit: Orbit, start: Start,
                 obstacles: Obstacles, form: CommandForm, batch: tuple, track: bool,
                 abort: AbortProfile | None = None) -> None:
        self._chosen = params.on(legs)
        self._count = obstacles.count
        self._phi = cw.transition(orbit.mean_motion, run.step_s)
        # the covariance of step 0 is that of the start; a command acts `forward` steps later
        self._open = params.start_covariance()
        for _ in range(legs.forward):
            self._open = cw.carried(self._open, self._phi)
        self._direct = self._predictor = None
        if self._chosen.filters:
            track = track or self._chosen.predicted
            self._predictor = Predictor(params.filter(), run, legs, orbit, start, form, batch,
                                        track, abort)
            self._tracker = Tracker(params, orbit, run, legs, obstacles, batch)
        else:
            self._direct = Direct(orbit, run, form, obstacles, batch)

    def advance(self, k: int, measured: Array, received: NDArray, sent: Any, late: dict,
                abort: bool = False) -> Known:
        """
        Return what is known at step k.

        Parameters
        ----------
        k : int
        measured : ndarray, shape (..., 6 + 6 M)
            What came down.
        received : ndarray of bool, shape (...)
        sent : ndarray, shape (..., 3), or None
            Command of the step before.
        late : dict
            Commands of steps before that one, which were missing then, each with whether it was
            an ABORT.
        abort : bool
            Whether the command of the step before was an ABORT.
        """
        if k:
            self._open = cw.carried(self._open, self._phi)
        if self._direct is not None:
            own, around = self._direct.advance(measured, received, sent)
            return Known(own, own, around, self._direct.valid, self._opened(), (None, None))
        own, around = apart(measured)
        p = self._predictor.advance(k, own, received, sent, abort, late)
        around = self._tracker.advance(k, around, received)
        covariance = self._opened()
        if self._chosen.predicted:
            covariance = p.covariance[..., None, :3, :3] + self._tracker.covariance()
        return Known(p.estimate, p.predicted, around, p.valid, covariance,
                     (p.estimate_covariance, p.covariance))

    def news(self) -> News:
        """Return which filters have begun anew in the last step."""
        if self._predictor is None:
            return []
        return self._predictor.news() + self._tracker.news()

    def _opened(self) -> Array:
        return np.broadcast_to(self._open[:3, :3], (self._count, 3, 3))


def apart(measured: Array) -> tuple[Array, Array]:
    """Return chaser (..., 6) and obstacles (..., M, 6) of what came down."""
    return measured[..., :6], _rows(measured[..., 6:])


def _rows(flat: Array) -> Array:
    """Return (..., 6 M) as (..., M, 6), with the components first in memory as they come."""
    parts = np.moveaxis(flat, -1, 0)
    parts = parts.reshape(parts.shape[0] // 6, 6, *parts.shape[1:])
    return np.moveaxis(parts, (0, 1), (-2, -1))


def drifted(obstacles: Array, phi: Array, moving: NDArray[np.bool_]) -> Array:
    """Return obstacles (..., M, 6) after what `phi` (6, 6) spans; the static ones stay."""
    if not moving.any():
        return obstacles
    return np.where(moving[:, None], cw.product(phi, obstacles), obstacles)


def checked(scenario: Any, legs: Legs) -> Chosen:
    """
    Return how the ground navigates.

    Raises
    ------
    ValueError
        If settings and link do not fit; names section and key.
    """
    try:
        return scenario.settings('state_predictor').on(legs)
    except BadInput as error:
        raise BadInput(f'state_predictor: {error}') from None
