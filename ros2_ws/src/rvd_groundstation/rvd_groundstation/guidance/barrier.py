"""
Predictive barrier: the level nearest to the pilot's from which the chaser can still stop inside.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes. Inside,
        components come first, and the levels -3..3 lie on an axis before them: (7, 2, n).
Method  Ours; the paper has nothing like it. y and z are treated separately: for each level one
        step under it, then a coast, then braking until rest or docking. The distance by which
        that ends outside `margin_fraction` of the wall radius is the level's violation. The
        level with the least violation is wanted, among equals the one nearest to the pilot's.
        Several coasts are tried and the worst counts: the cone narrows, so even a chaser at
        rest meets the wall.
Sharing the wanted level is the command that should come out. A blend (eq. 25) would change it,
        so the law returns the automatic level whose blend comes nearest.
Limits  y and z are kept in the square inside the circle; no bound on the prediction error.
        docs/models/barrier.md has the derivation, the measurements and the physical ceiling.
"""

from functools import cached_property
from math import sqrt
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.cone import Cone, radius
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.commands.levels import HIGHEST, LevelForm
from rvd_groundstation.sharing.decision import Sharing

Array = NDArray[np.float64]
Levels = NDArray[np.int8]

LEVELS = np.arange(-HIGHEST, HIGHEST + 1, dtype=np.int8)
COUPLINGS = ('closing_rate', 'all', 'none')
SLOWEST_M_S = 0.05              # [m/s] least closing rate assumed, so that the approach ends
VIOLATION_WEIGHT = 1000.0       # [m/s^2 per m] a tenth of a millimetre outweighs any thrust
THRUST_WEIGHT = 1e-4            # among equals, prefer the level with less thrust


class Ahead(NamedTuple):
    """The approach ahead, which both lateral axes share; components first."""

    x: Array                    # (n,)   station [m]
    closing: Array              # (n,)   rate along x, not below SLOWEST_M_S [m/s]
    left: Array                 # (n,)   time left after one sample until docking [s]
    drift: Array                # (2, n) acceleration by orbital coupling [m/s^2]


@settings
class Barrier:
    """Least change of the pilot's command that leaves a way to stop inside the corridor."""

    run: Run = wiring()
    cone: Cone = wiring()
    orbit: OrbitParams = wiring()
    form: LevelForm = wiring()
    sharing: Sharing = wiring()             # what becomes of our command
    uses_stick: ClassVar[bool] = True

    coasts_s: tuple = param(
        (0.0, 8.0), 'Coasts assumed before the brake, of which the worst counts [s].', low=0.0)
    brake_level: int = param(
        1, 'Lateral level that is kept in reserve for the brake.', low=1, high=3)
    margin_fraction: float = param(
        0.75, 'Lateral offset that may be used, as a fraction of the corridor radius.',
        above=0.0, high=1.0)
    coupling: str = param(
        'closing_rate', 'Orbital terms on y and z: closing_rate is the Coriolis term on y, all '
        'adds the tidal terms, none leaves both out.', choices=COUPLINGS)
    keep_closing_m_s: tuple = param(
        (0.18, 0.28), 'Lowest and highest closing rate to which the pilot may thrust [m/s].',
        length=2, rising=True)
    force_closing_m_s: tuple = param(
        (0.15, 0.285), 'Closing rates below and above which level 1 corrects the rate [m/s].',
        length=2, rising=True)
    blind_level: int = param(
        0, 'Level along x that is sent while no telemetry can have come yet: a negative one slows '
        'the approach, which gains time for what is not known.', low=-HIGHEST, high=HIGHEST)
    around_m_s: float = param(
        0.05, 'Largest lateral rate at which it leads round an obstacle that is in the way, where '
        '0 means that it only stops [m/s].', low=0.0, high=1.0)

    def __post_init__(self) -> None:
        require(len(self.coasts_s) > 0, 'coasts_s', 'be one number or more', list(self.coasts_s))

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None) -> Array:
        """
        Return the effect (..., 3) [m/s^2] of the automatic command; see `Law.wanted`.

        Without a stick the pilot counts as neutral, and the automatic command is the one that
        shall come out itself: so, too, in mode auto, where nobody blends and the law is told of
        none.
        """
        prediction = np.asarray(prediction, dtype=float)
        neutral = np.zeros((*prediction.shape[:-1], 3), dtype=np.int8)
        return self.told(self.outcome(prediction, neutral if stick is None else stick), stick)

    def told(self, outcome: Levels, stick: ArrayLike | None) -> Array:
        """
        Return the effect (..., 3) [m/s^2] of the automatic command that makes `outcome` of it.
        """
        if stick is not None:
            cell = LEVELS.size*np.add(stick, HIGHEST) + (outcome + HIGHEST)
            outcome = self._automatic.ravel().take(cell.T).T    # as components lie in memory
        return self.form.effect(outcome)

    def outcome(self, prediction: ArrayLike, stick_levels: ArrayLike) -> Levels:
        """Return the command (..., 3) that shall come out; 0 where the state is unknown."""
        prediction = np.asarray(prediction, dtype=float)
        state = np.ascontiguousarray(prediction.reshape(-1, 6).T)
        stick = np.ascontiguousarray(np.reshape(stick_levels, (-1, 3)).T)
        wanted = np.empty(stick.shape, dtype=np.int8)
        wanted[0], cost = self.wishes(state, stick)
        wanted[1:] = cost.argmin(axis=0)
        wanted[1:] -= HIGHEST
        wanted *= np.isfinite(state).all(axis=0)
        return wanted.T.reshape(*prediction.shape[:-1], 3)

    def wishes(self, state: Array, stick: Levels) -> tuple[Levels, Array]:
        """Return the level along x (n,), and what each level (7, 2, n) of y and z costs."""
        cost = self.violation(state)
        cost *= VIOLATION_WEIGHT
        cost += self._reluctance.take(stick[1:] + HIGHEST, axis=1)
        return self._closing(state[3], stick[0]), cost

    def violation(self, state: Array) -> Array:
        """Return by how much (7, 2, n) [m] each level misses the corridor from `state` (6, n)."""
        dt = self.run.step_s
        ahead = self._ahead(state)
        accel = self._lateral[:, None, None] + ahead.drift
        p = (state[1:3] + state[4:6]*dt) + accel*(dt*dt/2.0)    # after one sample
        v = state[4:6] + accel*dt
        worst = np.zeros_like(p)
        for coast in self.coasts_s:
            np.maximum(worst, self._miss(p, v, ahead, coast), out=worst)
        return worst

    def _ahead(self, state: Array) -> Ahead:
        dt = self.run.step_s
        closing = np.maximum(state[3], SLOWEST_M_S)
        to_go = np.maximum(-state[0]/closing, 0.0)
        drift = self.drift(state)
        return Ahead(state[0], closing, np.maximum(to_go - dt, 0.0), drift)

    def drift(self, state: Array) -> Array:
        """Return the orbital acceleration (2, n) [m/s^2] of y and z, as far as `coupling` says."""
        n = self.orbit.mean_motion
        drift = np.zeros_like(state[1:3])
        if self.coupling != 'none':
            drift[0] = 2.0*n*state[3]
        if self.coupling == 'all':
            drift[0] += 3.0*n*n*state[1]
            drift[1] = -n*n*state[2]
        return drift

    def _miss(self, p: Array, v: Array, ahead: Ahead, coast_s: float) -> Array:
        """Return how far outside (7, 2, n) [m] a coast and a brake from `p`, `v` end."""
        brake = self._brake
        coast = np.minimum(coast_s, ahead.left)
        if coast_s > 0.0:
            p = p + v*coast
            p += ahead.drift*(coast*coast/2.0)
            v = v + ahead.drift*coast
        time = np.abs(v)                            # the brake: until rest or docking
        time /= brake
        np.minimum(time, ahead.left - coast, out=time)
        station = ahead.closing*time
        station += ahead.x + ahead.closing*(self.run.step_s + coast)
        np.minimum(station, 0.0, out=station)
        bound = radius(station, self.cone)
        bound *= self.margin_fraction/sqrt(2.0)     # the square inside the circle
        end = v*time                                # v t - sign(v) a t^2 / 2
        time *= time
        time *= brake/2.0
        end -= np.copysign(time, v, out=time)
        end += p
        np.abs(end, out=end)
        end -= bound
        return end

    def _closing(self, rate: Array, stick: Levels) -> Levels:
        """Return the level along x: the pilot's, unless it drives the closing rate too far."""
        after = rate + self._along[stick + HIGHEST]*self.run.step_s
        slow, fast = self.keep_closing_m_s
        too_slow, too_fast = self.force_closing_m_s
        leaves = ((after <= slow) & (stick < 0)) | ((after >= fast) & (stick > 0))
        level = np.where(leaves, 0, stick)
        return np.where(rate > too_fast, -1, np.where(rate < too_slow, 1, level))

    # -- tables over the levels -3..3 ------------------------------------------------------

    @cached_property
    def _along(self) -> Array:
        """Acceleration along x of each level, (7,) [m/s^2]."""
        return self._accelerations[:, 0].copy()

    @cached_property
    def _lateral(self) -> Array:
        """Acceleration along y and z of each level, (7,) [m/s^2]."""
        return self._accelerations[:, 1].copy()

    @cached_property
    def _accelerations(self) -> Array:
        return self.form.effect(np.repeat(LEVELS[:, None], 3, axis=1))

    @cached_property
    def _brake(self) -> float:
        return float(self._lateral[HIGHEST + self.brake_level])

    @cached_property
    def _reluctance(self) -> Array:
        """Cost of a level that violates nothing: `[level, pilot's level]` (7, 7) [m/s^2]."""
        a = self._lateral
        return np.abs(a[:, None] - a) + THRUST_WEIGHT*np.abs(a)[:, None]

    @cached_property
    def _automatic(self) -> Levels:
        """Automatic level `[pilot's, wanted]` (7, 7) whose shared command comes nearest."""
        table = np.empty((LEVELS.size, LEVELS.size), dtype=np.int8)
        for pilot in LEVELS.tolist():
            for wanted in LEVELS.tolist():
                table[pilot + HIGHEST, wanted + HIGHEST] = self._nearest(pilot, wanted)
        return table

    def _nearest(self, pilot: int, wanted: int) -> int:
        if wanted == pilot:
            return pilot

        def rank(auto: int) -> tuple[int, int]:
            shared = int(self.sharing.share([pilot], [auto])[0])
            return abs(shared - wanted), abs(auto)
        return min(LEVELS.tolist(), key=rank)
