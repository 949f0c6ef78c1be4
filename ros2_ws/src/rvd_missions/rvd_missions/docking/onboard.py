"""
The craft's own computers: pose, navigation, guidance and control. They read no truth.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.news import News
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.pinhole import CameraParams, require_markers
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.control.allocation import Allocation, Shares, WAYS
from rvd_dynamics.onboard.control.six_loops import (
    AttitudeLoopParams, Design, LoopParams, require_design, SixLoops)
from rvd_dynamics.onboard.navigation.filters import FilterParams, Navigation as Filters
from rvd_dynamics.onboard.navigation.vision import Vision as Poses, VisionParams
from rvd_missions.docking import markers
from rvd_missions.docking.commands import by_run, ValveForm
from rvd_missions.docking.golden import GoldenLoopParams, GoldenLoops
from rvd_missions.docking.profile import Profile, ProfileParams
from rvd_missions.docking.safety import ABORT, HOLD, RETREAT, Safety, SafetyParams
from rvd_missions.docking.settings import Aim, compiled, OrbitParams, rows
from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, POSE, WANTED

NOMINAL_MASS = 2000.0                           # [kg] what the craft takes itself to be
NOMINAL_INERTIA = np.array([2200.0, 3000.0, 2800.0])
AUTHORITY = np.array([40.0, 40.0, 40.0, 16.0, 16.0, 16.0])     # [N, N m] of J2 and J3
STRUCTURE = (0.25, 0.35, 2*np.pi*0.25)          # [rad/s] tanks and panels as they are known
LOOP_DELAY_S = 0.045                            # delay, lag, half the least on-time
WIDEST = (0.04, np.radians(0.35))               # dead bands that the limits allow [m], [rad]
# x of the centre where a retreat ends, its faces 3 m apart [m]; how fast it goes [m/s]; and how it
# slows down [m/s^2]: half of what J2, which alone pushes ahead, gives the nominal craft
FARTHEST = markers.TARGET_PORT[0] - markers.CHASER_PORT[0] - 3.0
BACK_M_S, BACK_SLOWS_M_S2 = 0.1, 0.01


def backing(x: NDArray, step_s: float) -> NDArray:
    """Return the speed (N,) of a retreat whose reference is at `x` (N,) [m], backwards [m/s]."""
    left = np.maximum(x - FARTHEST, 0.0)
    return np.minimum(np.minimum(BACK_M_S, np.sqrt(2.0*BACK_SLOWS_M_S2*left)), left/step_s)


class Vision:
    """Poses from the markers in the image."""

    def __init__(self, settings: VisionParams, camera: CameraParams, batch: tuple) -> None:
        require_markers('markers', markers.BIG)
        self._poses = Poses(camera, settings, markers.BIG, markers.SMALL,
                            markers.CHASER_PORT[0] - camera.place_m[0], batch)

    def step(self, k: int, features: Any) -> dict[str, Any]:
        """Return the pose of the features of step k."""
        counted = self._poses.mode.copy()           # those that this view is solved with
        pose = self._poses.poses(features.pixels)
        return {'pose': POSE(place=pose.place, turn=pose.turn, covariance=pose.covariance,
                             usable=pose.usable, exposed=features.exposed, markers=counted)}


class Navigation:
    """Both filters, on inertial samples and poses."""

    def __init__(self, settings: FilterParams, run: Run, orbit: OrbitParams, late: int,
                 period: int, batch: tuple) -> None:
        self._batch, self._late = batch, late + 1       # a pose is read a step after it comes out
        rows = int(np.prod(batch, dtype=int))
        self._filters = Filters(settings, run.step_s, self._late, period*run.step_s,
                                orbit.mean_motion, markers.TARGET_PORT, rows)
        self._sample = np.zeros((2, rows, 3))

    def step(self, k: int, inertial: Any, pose: Any) -> dict[str, Any]:
        """Return the estimate of step k."""
        fresh = int(np.max(pose.exposed)) == k - self._late and k > self._late
        seen = None
        if fresh:
            seen = (self._rows(pose.place, 3), self._rows(pose.turn, 4),
                    self._rows(pose.covariance, 6, 6))
        now = self._filters.step(*self._felt(inertial), seen)
        return {'estimate': ESTIMATE(
            position=self._out(now.position), velocity=self._out(now.velocity),
            attitude=self._out(now.attitude), rate=self._out(now.rate), nis=self._out(now.nis),
            sigma=self._out(self._filters.sigma()))}

    def news(self) -> News:
        """Return whether the filters of any row have begun anew in the last step."""
        return self._filters.news()

    def _felt(self, inertial: Any) -> tuple[NDArray, NDArray]:
        """Return rate and force (N, 3); the sample before goes on where one has not come."""
        sample = np.stack([self._rows(inertial.rate, 3), self._rows(inertial.force, 3)])
        self._sample = np.where(np.isfinite(sample), sample, self._sample)
        return self._sample[0], self._sample[1]

    def _rows(self, value: NDArray, *shape: int) -> NDArray:
        return np.reshape(np.broadcast_to(value, (*self._batch, *shape)), (-1, *shape))

    def _out(self, of_rows: NDArray) -> NDArray:
        return of_rows.reshape((*self._batch, *of_rows.shape[1:]))


@settings
class ControllerParams:
    """Guidance and control."""

    profile: ProfileParams = param(ProfileParams, 'The way to the port.')
    position: LoopParams = param(LoopParams, 'Loops of the position.')
    attitude: AttitudeLoopParams = param(AttitudeLoopParams, 'Loops of the attitude.')
    attitude_law: str = param('pid', 'Law of the attitude.', choices=('pid', 'golden_section'))
    golden_section: GoldenLoopParams = param(GoldenLoopParams, 'Settings of golden_section.')
    allocation: str = param('table', 'How thrusters are chosen.', choices=tuple(WAYS))
    failed: tuple = param((-1,), 'Numbers of thrusters known to have failed; -1 is none.', low=-1,
                          high=36)
    failed_by_run: bool = param(
        False, 'Whether the thruster of the run\'s number, modulo their number, is known to have '
        'failed, too.')
    safety: SafetyParams = param(SafetyParams, 'The safety strategy.')


class Controller:
    """Tracks the profile with six loops and opens valves."""

    def __init__(self, settings: ControllerParams, run: Run, aim: Aim, orbit: OrbitParams,
                 form: ValveForm, runs: Sequence[int], batch: tuple) -> None:
        s, self._batch, self._run, self._aim = settings, batch, run, aim
        for name, loop, acceleration, widest in (
                ('position', s.position, 40.0/NOMINAL_MASS, WIDEST[0]),
                ('attitude', s.attitude, float((16.0/NOMINAL_INERTIA).min()), WIDEST[1])):
            require_design(name, Design(loop, acceleration), widest, 0.04, LOOP_DELAY_S, STRUCTURE,
                           run.step_s)
        count = int(np.prod(batch, dtype=int))
        self._loops = SixLoops(s.position, s.attitude, run.step_s, (count,))
        if s.attitude_law == 'golden_section':
            self._loops = GoldenLoops(s.golden_section, self._loops, s.attitude.modulator,
                                      AUTHORITY[3:]/NOMINAL_INERTIA, run.step_s, count)
        self._settings, self._form, self._n = s, form, orbit.mean_motion
        numbers = np.arange(len(form.thrusters))
        failed = np.tile(np.isin(numbers, s.failed), (count, 1))
        if s.failed_by_run:
            failed |= numbers == by_run(runs, len(numbers))[:, np.newaxis]
        turn = ('J3',) if s.allocation == 'table' else ('J3', 'J4')
        self._allocations = []                  # of rows with the same mask
        for mask in np.unique(failed, axis=0):
            allocation = Allocation(form.thrusters, s.allocation, AUTHORITY, ('J2',), turn)
            allocation.fail(mask)
            self._allocations.append((np.flatnonzero((failed == mask).all(axis=1)), allocation))
        self._shares = Shares(4, (count, len(form.thrusters)))
        self._brake = form.retreat.astype(bool) & ~failed
        self._safety = Safety(s.safety, run.step_s, count)
        self._profile: Profile | None = None
        self._began, self._held = 0.0, np.full((count, 3), np.nan)
        self._nominal = np.ascontiguousarray(form.thrusters.nominal)
        self._pushed = np.zeros((count, 6))     # in the step before, of the authority

    def step(self, k: int, estimate: Any, control: Control) -> dict[str, Any]:
        """Return valves and guidance of step k."""
        r, v, q, rate, nis = (rows(part, width) for part, width in (
            (estimate.position, 3), (estimate.velocity, 3), (estimate.attitude, 4),
            (estimate.rate, 3), (estimate.nis, 2)))
        t = k*self._run.step_s
        port, spin = compiled().estimated(r, q, rate, self._n, markers.CHASER_PORT,
                                          markers.TARGET_PORT)     # spin: relative to the target
        turn = attitude.rotation_vector(q)
        state = self._safety.advance(t, port, v[:, 0], turn, spin, nis, self._pushed)
        wanted, speed = self._reference(t, r, state)
        error, change = compiled().errors(r, v, q, turn, spin, wanted, speed)
        demand = self._loops.step(error, change)
        valves = self._shares.open(self._allocated(demand))
        backing = (state == RETREAT) & (demand[:, 0] < 0.0)
        valves = valves | (backing[:, None] & self._brake)
        abort = (state == ABORT) | bool(control.abort)
        out = self._out
        return {
            'wanted': WANTED(command=out(valves.astype(np.uint8)),
                             kind=out(np.where(abort, KIND_ABORT, KIND_THRUST).astype(np.uint8)),
                             received=np.ones(self._batch, dtype=bool)),
            'guidance': GUIDANCE(reference=out(wanted), error=out(error), demand=out(demand),
                                 safety=out(state.copy()))}

    def _allocated(self, demand: NDArray) -> NDArray:
        """Return how much of each thruster (N, T) answers demands (N, 6)."""
        if len(self._allocations) == 1:
            found = self._allocations[0][1](demand)
        else:
            found = np.empty((len(demand), len(self._form.thrusters)))
            for at, allocation in self._allocations:
                found[at] = allocation(demand[at])
        self._pushed = compiled().wrench(found, self._nominal, AUTHORITY)
        return found

    def _reference(self, t: float, r: NDArray, state: NDArray) -> tuple[NDArray, NDArray]:
        """Return the wanted place and velocity (N, 3) of the craft's centre; NaN if unknown."""
        wanted, speed = self._guided(t, r)
        stopped = state >= HOLD
        if stopped.any():
            self._held = np.where((stopped & np.isnan(self._held[:, 0]))[:, None], r, self._held)
            back = state == RETREAT
            going = np.where(back, backing(self._held[:, 0], self._run.step_s), 0.0)
            self._held[:, 0] -= going*self._run.step_s
            wanted = np.where(stopped[:, None], self._held, wanted)
            speed = np.where(stopped[:, None], 0.0, speed)
            speed[:, 0] -= going
        return wanted, speed

    def _guided(self, t: float, r: NDArray) -> tuple[NDArray, NDArray]:
        """Return place and velocity (N, 3) that guidance wants, were all well; NaN if unknown."""
        if self._profile is None:
            if not np.isfinite(r).all():
                return np.full_like(r, np.nan), np.full_like(r, np.nan)
            self._began = t
            self._profile = Profile(self._settings.profile, r + markers.CHASER_PORT
                                    - markers.TARGET_PORT, self._aim.distance_m,
                                    self._aim.nominal_s - t)
        port, speed = self._profile.at(t - self._began)
        return port - markers.CHASER_PORT + markers.TARGET_PORT, speed

    def _out(self, of_rows: NDArray) -> NDArray:
        return of_rows.reshape((*self._batch, *of_rows.shape[1:]))
