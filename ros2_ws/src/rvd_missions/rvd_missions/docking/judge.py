"""
The judge: did the chaser come to hover before the port, and how? From the truth alone.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.judge import Measure, Verdict
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry.pinhole import CameraParams, USABLE
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.navigation.vision import (
    BIG as BIG_SET, handed_over, SMALL as SMALL_SET)
from rvd_dynamics.world.sensors.camera import features, ImageParams
from rvd_missions.docking import markers, scatter as scattering
from rvd_missions.docking.settings import Aim, Chaser, ended, faces, Limits, Seeing
from rvd_missions.docking.space import relative


class Judge:
    """Follows the truth of one run, or of a batch of runs, step by step."""

    reasons = {
        'hovering': 'hovering before the port',
        'strayed': 'left the band before the port',
        'touched': 'the docking faces touched',
        'blind': 'fewer than four markers that count were in view',
        'invalid': 'the true state became invalid',
    }

    def __init__(self, run: Run, aim: Aim, limits: Limits, chaser: Chaser, camera: CameraParams,
                 cameras: tuple[CameraParams, ...], seeing: Seeing, scenario: Scenario,
                 scatter: scattering.Scatter, craft: Any, period: int, batch: tuple = (),
                 runs: Sequence[int] | None = None) -> None:
        low, high = aim.distance_m - limits.band_m, aim.distance_m + limits.band_m
        self._band = (low, high)
        self.measures = (
            Measure('hover_min_m', 'm', 'least distance while hovering', low=low, digits=4),
            Measure('hover_max_m', 'm', 'greatest distance while hovering', high=high, digits=4),
            Measure('settled_s', 's', 'in the band for good', high=limits.from_s, digits=1),
            Measure('lateral_m', 'm', 'greatest offset in y or z while hovering',
                    high=limits.lateral_m, digits=4),
            Measure('lateral_norm_m', 'm', 'greatest offset across', digits=4),
            Measure('attitude_deg', 'deg', 'greatest attitude angle while hovering',
                    high=limits.attitude_deg, digits=3),
            Measure('attitude_total_deg', 'deg', 'greatest turn in all', digits=3),
            Measure('closing_speed_m_s', 'm/s', 'greatest closing speed', digits=4),
            Measure('distance_nominal_m', 'm', 'distance at the nominal time', digits=4),
            Measure('fov_lost_s', 's', 'time with fewer than four markers in view',
                    high=0.5*run.step_s, digits=2),
            Measure('propellant_kg', 'kg', 'propellant', digits=4),
            Measure('pulses', '', 'pulses of all thrusters', digits=0))
        self._run, self._limits, self._period = run, limits, period
        self._from = int(np.ceil(limits.from_s/run.step_s - 1e-9))
        self._nominal = round(aim.nominal_s/run.step_s)
        self._cameras = cameras if seeing.camera in ('stereo', 'rendered') else (camera,)
        self._vision = scenario.settings('vision')
        self._mode = np.zeros(batch, dtype=np.int64)            # the markers that count
        self._centre = scattering.centre(scatter, craft, chaser, run, runs, batch)
        self._points = markers.TARGET_PORT + np.concatenate([markers.BIG, markers.SMALL])
        self._live = np.ones(batch, dtype=bool)
        self._reason = np.full(batch, '', dtype='U8')
        self._duration, self._blind, self._closing = np.zeros((3, *batch))
        self._spent, self._pulses, self._out = np.zeros((3, *batch))
        self._least = np.full(batch, np.inf)
        self._most, self._lateral, self._across, self._angle, self._turn = np.zeros((5, *batch))
        self._nominal_distance = np.full(batch, np.nan)
        self._strayed_at, self._blind_at = np.full((2, *batch), np.nan)     # [s] first time

    def follow(self, k: int, truth: Any) -> None:
        """Take the truth of step k, every step in order."""
        live, t = self._live, k*self._run.step_s
        port, turn = faces(truth.position, truth.attitude, truth.target_attitude, self._centre)
        distance = -port[..., 0]
        self._duration = np.where(live, t, self._duration)
        self._spent = np.where(live, truth.propellant, self._spent)
        self._pulses = np.where(live, truth.pulses, self._pulses)
        self._closing = np.where(live, np.fmax(self._closing, truth.velocity[..., 0]),
                                 self._closing)
        inside = (distance > self._band[0]) & (distance < self._band[1])
        self._out = np.where(live & ~inside, t + self._run.step_s, self._out)
        if k == self._nominal:
            self._nominal_distance = np.where(live, distance, self._nominal_distance)
        if k > self._from:
            self._hover(live, t, port, distance, turn)
        if k % self._period == 0:
            self._look(live, t, truth, distance)
        over = live & ended(k, port, self._run.last_step)
        if np.count_nonzero(over):
            self._reason = np.where(over, self._why(port), self._reason)
            self._live = live & ~over

    def _hover(self, live: NDArray, t: float, port: NDArray, distance: NDArray, turn: NDArray
               ) -> None:
        angles = np.degrees(attitude.rotation_vector(turn))
        across = np.abs(port[..., 1:])
        good = ((distance > self._band[0]) & (distance < self._band[1])
                & (across.max(axis=-1) < self._limits.lateral_m)
                & (np.abs(angles).max(axis=-1) < self._limits.attitude_deg))
        self._strayed_at = np.where(live & ~good, np.fmin(self._strayed_at, t), self._strayed_at)
        self._least = np.where(live, np.fmin(self._least, distance), self._least)
        for name, value in (
                ('_most', distance), ('_lateral', np.fmax(across[..., 0], across[..., 1])),
                ('_across', np.hypot(across[..., 0], across[..., 1])),
                ('_angle', np.abs(angles).max(axis=-1)),
                ('_turn', np.sqrt((angles*angles).sum(axis=-1)))):
            setattr(self, name, np.where(live, np.fmax(getattr(self, name), value),
                                         getattr(self, name)))

    def _look(self, live: NDArray, t: float, truth: Any, distance: NDArray) -> None:
        """
        Count the time in which no camera has enough of the markers that count for a pose.

        Looked at once a view, from the true place, without noise and drop-outs.
        """
        offset, turn = relative(truth, self._centre)
        counted = np.stack([self._mode != SMALL_SET]*len(markers.BIG)
                           + [self._mode != BIG_SET]*len(markers.SMALL), axis=-1)
        most = np.zeros(self._mode.shape, dtype=np.int64)
        for camera in self._cameras:
            pixels = features(camera, ImageParams(corner_sigma_px=0.0), self._points,
                              markers.FACING, offset, turn, 0.0, np.ones(turn.shape[:-1]))
            most = np.maximum(most, (np.isfinite(pixels[..., 0]) & counted).sum(axis=-1))
        few = most < USABLE
        self._mode = handed_over(self._vision, self._mode, np.where(few, np.nan, distance))
        self._blind_at = np.where(live & few, np.fmin(self._blind_at, t), self._blind_at)
        self._blind = self._blind + np.where(live & few, self._period*self._run.step_s, 0.0)

    def _why(self, port: NDArray) -> NDArray:
        """Return the reason for which runs would end here."""
        good = np.ones(self._live.shape, dtype=bool)
        values = self._values()
        for measure in self.measures:
            good = good & measure.ok(values[measure.name])
        why = np.where(good, 'hovering', 'strayed')
        why = np.where(self._blind > 0.0, 'blind', why)
        why = np.where(port[..., 0] < 0.0, why, 'touched')
        return np.where(np.isfinite(port).all(axis=-1), why, 'invalid')

    def _values(self) -> dict[str, NDArray]:
        hovered = np.isfinite(self._least)

        def known(value: NDArray) -> NDArray:
            return np.where(hovered, value, np.nan)
        return {
            'hover_min_m': known(self._least), 'hover_max_m': known(self._most),
            'settled_s': np.where(self._out <= self._duration, self._out, np.nan),
            'lateral_m': known(self._lateral), 'lateral_norm_m': known(self._across),
            'attitude_deg': known(self._angle), 'attitude_total_deg': known(self._turn),
            'closing_speed_m_s': self._closing, 'distance_nominal_m': self._nominal_distance,
            'fov_lost_s': self._blind, 'propellant_kg': self._spent, 'pulses': self._pulses}

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has strayed."""
        reason = np.where((self._reason == '') & final, 'strayed', self._reason)
        happened = np.where(reason == 'strayed', self._strayed_at,
                            np.where(reason == 'blind', self._blind_at, np.nan))
        return Verdict(reason == 'hovering', reason, self._duration, self._values(), happened)
