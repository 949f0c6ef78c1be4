"""
The tracker on board: follows the plan by bearing, paid-out length and attitude alone.

Law     y = (ls, alpha0, beta0, roll, pitch, yaw), e = y - y*, e' a filtered difference:
            T   = T*                                    the tension is fed forward
            F_l = F_l* - m (wl^2 e_l + 2 wl e_l')
            F_a = F_a* + m l0* (wa^2 e_a + 2 wa e_a')   a lateral offset is -l0* e_a
            F_b = F_b* + m l0* (wa^2 e_b + 2 wa e_b')
            tau = tau* - I (wt^2 e + 2 wt e')
        within the limits. Only the planned range l0* is used: nothing measures it.
Source  assumed: section 2.3 of Hu et al. and its gains are lost (docs/missions/tether.md).
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.diagram.news import News
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_missions.tether import geometry
from rvd_missions.tether.commands import TetherForm
from rvd_missions.tether.inputs import InputParams, reference
from rvd_missions.tether.observer import Observer, ObserverParams, shifted
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.settings import GripperParams
from rvd_missions.tether.signals import DOWNLINK, TRACKING, WANTED


@settings
class TrackerParams:
    """Gains of the tracker [A]."""

    feedback: bool = param(
        True, 'Whether the measurements are fed back; without it the plan is flown open loop.')
    length_rad_s: float = param(0.35, 'Natural frequency wl along the tether [rad/s].', low=0.0)
    bearing_rad_s: float = param(0.25, 'Natural frequency wa across the sight [rad/s].', low=0.0)
    attitude_rad_s: float = param(0.8, 'Natural frequency wt of the attitude [rad/s].', low=0.0)
    filter_s: float = param(0.3, 'Time constant of the filtered differences [s].', above=0.0)
    knows_stretch: bool = param(
        False, 'Whether the planned length is that of the unstretched tether, which the encoder '
        'reads; otherwise the reading is taken for the distance to the platform.')
    aborts_blind: bool = param(
        True, 'Whether losing the target out of the field of view asks for an ABORT.')
    observer: ObserverParams = param(ObserverParams, 'Estimate of motion and baseline.')


class Feedback:
    """The law of the module on arrays (..., 6), with the memory of its filtered difference."""

    def __init__(self, settings: TrackerParams, gripper: GripperParams, step_s: float,
                 batch: tuple) -> None:
        m, inertia = gripper.mass_kg, np.array(gripper.inertia_kg_m2)
        wl, wa, wt = settings.length_rad_s, settings.bearing_rad_s, settings.attitude_rad_s
        # along, two across (times the range of the step), three about the body's axes
        self._stiffness = np.array([-m*wl*wl, m*wa*wa, m*wa*wa, *-inertia*wt*wt])
        self._damping = 2.0*np.array([-m*wl, m*wa, m*wa, *-inertia*wt])
        self._blend = step_s/(settings.filter_s + step_s)
        self._step_s = step_s
        self._error, self._slope = np.zeros((2, *batch, 6))
        self._begun = False

    def resume(self, error: NDArray, slope: NDArray) -> None:
        """Go on from errors (..., 6) and their filtered differences, as if it had run before."""
        self._error, self._slope, self._begun = error, slope, True

    def answer(self, error: NDArray, planned_range: ArrayLike, anew: NDArray | None = None
               ) -> NDArray[np.float64]:
        """
        Return force and torque (..., 6) that answer an error (..., 6) at a range (...) [m].

        Where it is not known the last one holds. Where `anew` (...) another reference is followed
        than in the step before, whose difference to that one is no motion.
        """
        error = np.where(np.isfinite(error), error, self._error)
        if self._begun:
            change = (error - self._error)/self._step_s
            slope = self._slope + self._blend*(change - self._slope)
            self._slope = slope if anew is None else np.where(anew[..., np.newaxis], 0.0, slope)
        self._error, self._begun = error, True
        far = np.asarray(planned_range, dtype=float)
        one = np.ones_like(far)
        scale = np.stack([one, far, far, one, one, one], axis=-1)
        return scale*(self._stiffness*error + self._damping*self._slope)


def seen(measurement: Any) -> NDArray[np.float64]:
    """Return (..., 6) length and angles of a measurement."""
    sight = geometry.line(geometry.to_inertial(measurement.attitude, measurement.bearing))
    angles = geometry.euler(measurement.attitude)
    return np.stack([measurement.encoder, sight.alpha, sight.beta,
                     *np.moveaxis(angles, -1, 0)], axis=-1)


class GripperTracker:
    """
    Fires on each measurement.

    It has had the whole plan since before the release; of what comes up the link it takes
    whether to ABORT.
    """

    def __init__(self, settings: TrackerParams, inputs: InputParams, preparation: Preparation,
                 form: TetherForm, run: Run, batch: tuple) -> None:
        self._settings, self._form = settings, form
        p = preparation
        times = np.arange(p.last_step(run) + 1)*run.step_s
        self._planned = reference(p.plan, inputs.spline, times, p.orbit, p.gripper, p.tether,
                                  p.approach, settings.knows_stretch)
        self._feedback = Feedback(settings, p.gripper, run.step_s, batch)
        self._received = np.ones(batch, dtype=bool)
        self._observer = None
        if settings.observer.on and settings.feedback:
            rows = int(np.prod(batch, dtype=int))
            self._observer = Observer(settings.observer, p.orbit, p.gripper, p.tether, p.approach,
                                      run.step_s, rows)
            at = np.clip(times, p.plan.begin_s, p.plan.end_s)
            self._places = p.plan.state_at(at)[:, :3]
            self._targets = np.stack([geometry.baseline(p.orbit, p.approach.baseline_m, t).place
                                      for t in at])
            part = (at - p.plan.begin_s)/p.plan.duration_s
            self._moved = part*part*(3.0 - 2.0*part)    # of the error of the baseline

    def step(self, k: int, measurement: Any, arrival: Any) -> dict[str, Any]:
        """Return the command of step k, for the guard, and the downlink."""
        at = min(k, len(self._planned.range_m) - 1)
        planned, fed = self._planned.seen[at], self._planned.inputs[at]
        measured = seen(measurement)
        batch = measured.shape[:-1]
        planned, fed = (np.broadcast_to(v, (*batch, len(v))) for v in (planned, fed))
        wanted, distance = fed, np.full(batch, self._planned.range_m[at])
        if self._observer is not None:
            error, planned, distance = self._observed(k, at, measured, planned)
            wanted = np.concatenate([fed[..., :1], fed[..., 1:] + self._feedback.answer(
                error, distance)], axis=-1)
        elif self._settings.feedback:
            wanted = np.concatenate([fed[..., :1], fed[..., 1:] + self._feedback.answer(
                measured - planned, self._planned.range_m[at])], axis=-1)
        command = self._form.quantise(wanted)
        if self._observer is not None:
            self._observer.sent(command.reshape(-1, 7))
        known = np.isfinite(measurement.encoder)            # in real time one may be missing
        blind = ~measurement.in_view & known & (
            self._settings.aborts_blind and self._settings.feedback)
        asked = blind | (arrival.received & (arrival.kind == KIND_ABORT))
        return {'wanted': WANTED(command=command, received=self._received,
                                 kind=np.where(asked, np.uint8(KIND_ABORT), np.uint8(KIND_THRUST))),
                'tracking': TRACKING(planned=planned, measured=measured, feedforward=fed,
                                     range=distance),
                'downlink': DOWNLINK(state=np.concatenate(
                    [measured, planned, distance[..., np.newaxis], command[..., :1]], axis=-1))}

    def news(self) -> News:
        """Return what the observer has taken against its gate in the last step."""
        return [] if self._observer is None else self._observer.news()

    def _observed(self, k: int, at: int, measured: NDArray, planned: NDArray
                  ) -> tuple[NDArray, NDArray, NDArray]:
        """Return the error (..., 6) by what is estimated, what is followed, and the range."""
        found = self._observer.take(k, measured[..., :3].reshape(-1, 3))
        moved = shifted(self._places[at], self._targets[at], self._observer.state[:, 6],
                        self._moved[at])
        followed, found, distance = (np.reshape(v, (*measured.shape[:-1], *v.shape[1:])) for v in (
            moved[:, :3], found, moved[:, 3]))
        planned = np.concatenate([followed, planned[..., 3:]], axis=-1)
        return (np.concatenate([found - followed, measured[..., 3:] - planned[..., 3:]], axis=-1),
                planned, distance)
