"""
The space segment: the true motion of gripper and tether, and what the gripper measures.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_missions.tether import geometry
from rvd_missions.tether.end import ended
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.settings import (
    ApproachParams, ArrivalParams, GripperParams, OrbitParams, TetherParams)
from rvd_missions.tether.signals import MEASUREMENT, TRUTH

SCATTERED = 12          # baseline, mass, inertia, velocity (3), attitude (3), rate (3)


@settings
class ReelParams:
    """The elastic tether and its reel."""

    damping_n_s: float = param(
        0.1, 'Damping c of the tether per unit of strain rate [N s]; the paper gives no unit.',
        low=0.0)
    gain_m_s_n: float = param(
        0.5, 'Speed of the reel per newton of tension off the commanded one [m/s/N].', above=0.0)
    reset_s: float = param(0.05, 'Time in which the reel takes the mean speed over [s].', above=0.0)
    parts: int = param(20, 'Parts of a step in which the elastic tether is integrated.', low=1,
                       high=1000)


@settings
class DynamicsParams:
    """What is not as planned."""

    elastic: bool = param(
        False, 'Whether the tether is elastic and the reel controls its tension; otherwise the '
        'tension is what is commanded.')
    beads: int = param(
        0, 'Number of pieces of the whole tether, each with its mass in a bead at its inner end; '
        'the piece at the reel has none yet, so 1 is no mass, as is 0.', low=0, high=64)
    density_kg_m3: float = param(
        1440.0, 'Density of the tether where it has a mass, aramid [kg/m^3].', above=0.0)
    reel: ReelParams = param(ReelParams, 'The elastic tether and its reel.')
    baseline_error_m: float = param(
        0.0, 'True distance from platform to target at the start minus the assumed one [m].')
    baseline_sigma_m: float = param(0.0, 'Standard deviation of that distance [m].', low=0.0)
    mass_sigma: float = param(
        0.0, 'Standard deviation of mass and of the moments of inertia, as fractions.', low=0.0,
        below=0.3)
    velocity_error_m_s: tuple = param(
        (0.0, 0.0, 0.0), 'True velocity of the release minus the planned one [m/s].', length=3)
    velocity_sigma_m_s: float = param(
        0.0, 'Standard deviation of the release along each axis [m/s].', low=0.0)
    attitude_sigma_rad: float = param(
        0.0, 'Standard deviation of the attitude at the start, about each axis [rad].', low=0.0)
    rate_sigma_rad_s: float = param(
        0.0, 'Standard deviation of the rate at the start, about each axis [rad/s].', low=0.0)
    disturbance_n: tuple = param(
        (0.0, 0.0, 0.0), 'Constant disturbing force, inertial axes of the start [N].', length=3)

    def __post_init__(self) -> None:
        require(not (self.elastic and self.beads), 'beads', 'be 0 with elastic: the reel of a '
                'tether with mass holds the tension that is commanded', self.beads)


@settings
class SensorParams:
    """Noise of the sensors."""

    encoder_sigma_m: float = param(
        0.0, 'Standard deviation of the length that the encoder reads [m].', low=0.0)
    bearing_sigma_rad: float = param(
        0.0, 'Standard deviation of the bearing, across each axis of the camera [rad].', low=0.0,
        high=0.1)
    attitude_sigma_rad: float = param(
        0.0, 'Standard deviation of the attitude, about each axis [rad].', low=0.0, high=0.1)
    period_s: float = param(
        0.0, 'Time between measurements [s]; 0 measures in each step.', low=0.0, high=10.0)


class GripperDynamics:
    """The true motion; see `motion`."""

    def __init__(self, settings: DynamicsParams, run: Run, orbit: OrbitParams,
                 gripper: GripperParams, tether: TetherParams, approach: ApproachParams,
                 arrival: ArrivalParams, preparation: Preparation, scatter: NDArray,
                 batch: tuple) -> None:
        from rvd_missions.tether import motion
        self._motion, self._settings, self._batch, self._h = motion, settings, batch, run.step_s
        self._orbit, self._tether = orbit, tether
        self._ends = approach, arrival, preparation.last_step(run)
        rows = int(np.prod(batch, dtype=int))
        drawn = np.reshape(scatter, (rows, SCATTERED))
        self._baseline = (approach.baseline_m + settings.baseline_error_m
                          + settings.baseline_sigma_m*drawn[:, 0])
        factor = 1.0 + settings.mass_sigma*drawn[:, 1:3]
        self._craft = np.concatenate([
            gripper.mass_kg*factor[:, :1], factor[:, 1:]*gripper.inertia_kg_m2,
            np.full((rows, 1), gripper.attachment_m),
            np.tile(settings.disturbance_n, (rows, 1))], axis=1)
        start = approach.initial(orbit.at(0.0).rate)
        velocity = (start[3:6] + settings.velocity_error_m_s
                    + settings.velocity_sigma_m_s*drawn[:, 3:6])
        attitude = start[6:9] + settings.attitude_sigma_rad*drawn[:, 6:9]
        rate = start[9:] + settings.rate_sigma_rad_s*drawn[:, 9:]
        self._states = np.ascontiguousarray(np.concatenate([
            np.tile(start[:3], (rows, 1)), velocity, geometry.quaternion(attitude), rate], axis=1))
        strain = tether.least_n/tether.stiffness_n
        self._reels = np.tile([approach.released_m/(1.0 + strain), approach.speed_m_s,
                               tether.least_n, strain], (rows, 1))
        reel = settings.reel
        self._reel = np.array([tether.stiffness_n, reel.damping_n_s, reel.gain_m_s_n, reel.reset_s])
        self._chain = Chain(settings, run, tether, approach, rows) if settings.beads else None
        self._applied = np.full((*batch, 7), np.nan)
        self._now = self._orbit_at(0.0)

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k, under the command of the step before."""
        if k > 0:
            self._applied = np.array(np.broadcast_to(thrust.command, (*self._batch, 7)))
            self._advance((k - 1)*self._h, np.ascontiguousarray(self._applied.reshape(-1, 7)))
        state = self._states.reshape(*self._batch, 13)
        place, _ = geometry.baseline(self._orbit, self._baseline, k*self._h)
        target = np.reshape(place - self._states[:, :3], (*self._batch, 3))
        return {'truth': TRUTH(
            state=state, target=target, applied=self._applied,
            tension=self._reels[:, 2].reshape(self._batch),
            unstretched=self._reels[:, 0].reshape(self._batch),
            final=ended(k, state, target, *self._ends))}

    def _advance(self, t: float, commands: NDArray) -> None:
        h = self._h
        orbit = np.array([self._now, self._orbit_at(t + 0.5*h), self._orbit_at(t + h)])
        self._now = orbit[2]
        if self._chain is not None:
            self._states, self._reels = self._chain.advance(
                self._states, commands, orbit, self._craft)
            return
        if self._settings.elastic:
            self._states, self._reels = self._motion.advance_elastic(
                self._states, self._reels, commands, orbit, self._craft, self._reel, h,
                self._settings.reel.parts)
            return
        self._states = self._motion.advance(self._states, commands, orbit, self._craft, h)
        r, tension = self._states[:, :3], commands[:, 0]
        length = np.sqrt(r[:, 0]*r[:, 0] + r[:, 1]*r[:, 1] + r[:, 2]*r[:, 2])
        strain = tension/self._tether.stiffness_n
        self._reels = np.stack([length/(1.0 + strain), np.zeros_like(length), tension, strain],
                               axis=1)

    def _orbit_at(self, t: float) -> NDArray[np.float64]:
        """Return mu / r^3, and the sine and cosine of the turn since the start."""
        now = self._orbit.at(t)
        turn = now.anomaly - self._orbit.at(0.0).anomaly
        g = self._orbit.gravitational_parameter_m3_s2/(now.radius*now.radius*now.radius)
        return np.array([g, np.sin(turn), np.cos(turn)])


class Chain:
    """The beads of N tethers; see `beads`. A piece is the whole tether over their number."""

    def __init__(self, settings: DynamicsParams, run: Run, tether: TetherParams,
                 approach: ApproachParams, rows: int) -> None:
        from rvd_missions.tether import beads
        self._compiled, self._h = beads, run.step_s
        piece = (approach.baseline_m - approach.final_range_m)/settings.beads
        area = tether.stiffness_n/tether.modulus_pa
        self.tether = np.array([tether.stiffness_n, settings.reel.damping_n_s, piece,
                                settings.density_kg_m3*area])
        self._parts = beads.parts_of(run.step_s, piece, tether.stiffness_n, self.tether[3])
        self.beads = np.zeros((rows, 2*settings.beads, 6))
        self.counts = np.zeros(rows, dtype=np.int64)

    def advance(self, states: NDArray, commands: NDArray, orbit: NDArray,
                craft: NDArray) -> tuple[NDArray, NDArray]:
        """Return states (N, 13) after a step, and reels (N, 4) as `motion.advance_elastic`."""
        states, self.beads, self.counts, found = self._compiled.advance(
            states, self.beads, self.counts, commands, orbit, craft, self.tether, self._h,
            self._parts)
        length, tension = found.T
        return states, np.stack([length, np.zeros_like(length), tension,
                                 tension/self.tether[0]], axis=1)


class GripperSensors:
    """
    Encoder of the reel, camera and attitude sensor of the gripper; nothing measures the range.

    Between two measurements the last ones are repeated.
    """

    def __init__(self, settings: SensorParams, run: Run, approach: ApproachParams,
                 noise: NDArray) -> None:
        self._settings, self._view, self._noise = settings, approach.view_rad, noise
        self._every = max(1, round(settings.period_s/run.step_s))
        self._last: Any = None

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the measurement of step k."""
        if k % self._every == 0:
            self._last = self._measured(truth, self._noise[..., k, :])
        return {'measurement': self._last}

    def _measured(self, truth: Any, noise: NDArray) -> Any:
        s, q = self._settings, truth.state[..., 6:10]
        seen = geometry.to_body(q, truth.target)
        size = np.sqrt(seen[..., 0]*seen[..., 0] + seen[..., 1]*seen[..., 1]
                       + seen[..., 2]*seen[..., 2])
        across = seen[..., 1:]/size[..., np.newaxis] + s.bearing_sigma_rad*noise[..., 1:3]
        flat = across[..., 0]*across[..., 0] + across[..., 1]*across[..., 1]
        ahead = np.sqrt(np.maximum(1.0 - flat, 0.0))*np.sign(seen[..., 0])
        turn = geometry.quaternion(s.attitude_sigma_rad*noise[..., 3:6])
        return MEASUREMENT(
            encoder=truth.unstretched + s.encoder_sigma_m*noise[..., 0],
            bearing=np.concatenate([ahead[..., np.newaxis], across], axis=-1),
            attitude=geometry.product(q, turn),
            in_view=geometry.sight_angle(q, truth.target) <= self._view)
