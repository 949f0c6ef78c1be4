"""
The space segment: chaser and target as they move, the inertial unit, the camera.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry.pinhole import CameraParams, require_in_view
from rvd_dynamics.motion import attitude
from rvd_dynamics.world.sensors.camera import features, ImageParams
from rvd_dynamics.world.sensors.inertial import InertialParams, InertialUnit
from rvd_dynamics.world.spacecraft.effectors import beam_shapes, cantilever, Tank
from rvd_dynamics.world.spacecraft.reaction_control import (
    Failure, KINDS, ReactionControl, ThrusterParams)
from rvd_dynamics.world.spacecraft.spacecraft import Spacecraft
from rvd_missions.docking import markers
from rvd_missions.docking.commands import by_run, ValveForm
from rvd_missions.docking.scatter import drawn, Scatter
from rvd_missions.docking.settings import (
    Chaser, compiled, ended, faces, OrbitParams, Panels, rows, Start, Tanks)
from rvd_missions.docking.signals import FEATURES, INERTIAL, MARKERS, POSE, STATIONS, TRUTH

VIEW_DRAWS = 2*MARKERS + 1              # normals of a view: markers, and whether it is lost


@settings
class DynamicsParams:
    """The plant: its sub-steps, and a thruster that fails."""

    sub_steps: int = param(4, 'Steps of the plant in a base step.', low=1, high=1000)
    failed_thruster: int = param(0, 'Number of a thruster that fails.', low=0)
    failed_by_run: bool = param(False, 'Whether its number is that of the run instead, modulo the '
                                'number of thrusters: a campaign then fails each in turn.')
    failure: str = param('sound', 'How it fails.', choices=tuple(KINDS))
    failure_at_s: float = param(0.0, 'Instant of the failure [s].', low=0.0)
    failure_factor: float = param(0.5, 'Thrust that a weak one keeps, as a fraction.', low=0.0,
                                  high=2.0)


@settings
class PoseNoise:
    """The simple camera: a pose with noise of a fixed size."""

    simple_place_sigma_m: float = param(
        0.003, 'Standard deviation of each coordinate of a pose of the simple camera [m].',
        above=0.0, high=10.0)
    simple_angle_sigma_deg: float = param(
        0.05, 'Standard deviation of each angle of it [deg].', above=0.0, high=10.0)


@settings
class SeeingParams:
    """What is imperfect about the camera, pinhole or simple."""

    image: ImageParams = param(ImageParams, 'The image.')
    noise: PoseNoise = param(PoseNoise, 'The simple camera.')


def spacecraft(chaser: Chaser, panels: Panels, tanks: Tanks, orbit: OrbitParams) -> Spacecraft:
    """Return chaser and target of a scenario; BadInput if there can be none such."""
    bending, sloshing = (), ()
    if panels.flexible:
        bending = tuple(cantilever(
            (0.0, side*panels.root_m, 0.0), (0.0, side, 0.0), (0.0, 0.0, 1.0), panels.mass_kg,
            panels.length_m, 2*np.pi*panels.frequency_hz, panels.damping, panels.modes)
            for side in (1.0, -1.0))
    if tanks.sloshing:
        axes = np.eye(3)[1:], np.eye(3)[:0:-1]
        sloshing = tuple(Tank(
            (tanks.place_m[i], 0.0, 0.0), axes[i][:tanks.axes], tanks.mass_kg[i],
            tanks.frequency_rad_s[i], tanks.damping) for i in (0, 1))
    return Spacecraft(chaser.mass_kg, chaser.inertia, np.diag(chaser.target_inertia_kg_m2),
                      bending, sloshing, orbit.mean_motion, orbit.radius_m)


class Dynamics:
    """The true motion under the valves of the step before."""

    def __init__(self, settings: DynamicsParams, run: Run, craft: Spacecraft, chaser: Chaser,
                 start: Start, form: ValveForm, thruster: ThrusterParams, camera: CameraParams,
                 panels: Panels, scatter: Scatter, start_scatter: NDArray, pulses: NDArray,
                 properties: NDArray, runs: Sequence[int], batch: tuple) -> None:
        own = drawn(scatter, craft, chaser, properties)
        craft = own.craft
        self._run, self._craft, self._batch, self._centre = run, craft, batch, own.centre
        count = int(np.prod(batch, dtype=int))
        shifts = np.reshape(start_scatter, (count, 9))
        place = start.position_m + start.position_sigma_m*shifts[:, :3]
        q = attitude.from_euler(np.radians(
            start.attitude_deg + start.attitude_sigma_deg*shifts[:, 3:6]))
        still = attitude.rotate_back(q, np.array([0.0, -craft.mean_motion, 0.0]))
        self._state = craft.state(
            count, position=place, attitude=q,
            rate=still + np.radians(start.rate_sigma_deg_s)*shifts[:, 6:])
        nominal = features(camera, ImageParams(corner_sigma_px=0.0),
                           markers.TARGET_PORT + markers.BIG, markers.FACING, start.position_m,
                           attitude.from_euler(np.radians(start.attitude_deg)),
                           np.zeros((len(markers.BIG), 2)), 0.5)
        require_in_view('start', nominal)
        which = by_run(runs, len(form.thrusters)) if settings.failed_by_run else \
            settings.failed_thruster
        failed = Failure(which, settings.failure, round(settings.failure_at_s/run.step_s),
                         settings.failure_factor)
        self._control = ReactionControl(
            form.thrusters, thruster, run.step_s, settings.sub_steps,
            np.reshape(pulses, (count, -1)), self._centre,
            chaser.thrust_scale*own.thrust, (failed,))
        self._at = {name: where for name, (where, _) in craft.states.items()}
        self._shapes = beam_shapes(panels.modes, STATIONS)/np.sqrt(panels.mass_kg)
        self._spent = np.zeros(count)
        self._moved = (np.zeros((count, 3)),)*3
        self._mean = np.zeros((count, len(form.thrusters)))

    def step(self, k: int, thrust: Any) -> dict[str, Any]:
        """Return the truth of step k."""
        if k > 0:
            command = np.reshape(thrust.command, (len(self._state), -1))
            fired = self._control.step(k - 1, command)
            moved = self._craft.advance(self._state, fired.wrench, self._run.step_s)
            self._state, self._mean = moved.state, fired.mean
            self._moved = (moved.turned, moved.gained, moved.felt)
            self._spent = self._spent + fired.spent
        s = self._of_state
        port, _ = faces(s('position'), s('attitude'), s('target_attitude'), self._centre)
        pulses = self._control.pulses.sum(axis=-1)
        turned, gained, felt = self._moved
        return {'truth': TRUTH(
            **{name: self._out(s(name)) for name in TRUTH.type._fields[:6]},
            turned=self._out(turned), gained=self._out(gained), felt=self._out(felt),
            thrust=self._out(self._mean), pulses=self._out(pulses),
            propellant=self._out(self._spent),
            final=self._out(ended(k, port, self._run.last_step)),
            bending=self._out(self._bending()), sloshing=self._out(self._sloshing()))}

    def _bending(self) -> NDArray:
        """Return the deflection of each panel (N, 2, S) [m]; stiff ones have none."""
        made = np.zeros((len(self._state), 2, len(STATIONS)))
        for i in range(len(self._craft.panels)):
            modes = self._of_state(f'panel_{i}')
            for j in range(modes.shape[1]):             # a sum in a fixed order
                made[:, i] += modes[:, j:j + 1]*self._shapes[:, j]
        return made

    def _sloshing(self) -> NDArray:
        """Return where the liquid of each tank is from its place at rest (N, 2, 3) [m]."""
        made = np.zeros((len(self._state), 2, 3))
        for i, tank in enumerate(self._craft.tanks):
            swing = self._of_state(f'tank_{i}')/np.sqrt(np.reshape(tank.mass, (-1, 1)))
            for j, axis in enumerate(np.atleast_2d(tank.axes)):
                made[:, i] += swing[:, j:j + 1]*axis
        return made

    def _of_state(self, name: str) -> NDArray:
        return self._state[:, self._at[name]]

    def _out(self, of_rows: NDArray) -> NDArray:
        """Return rows (N, ...) with the batch axes in front."""
        return of_rows.reshape((*self._batch, *of_rows.shape[1:])).copy()


class Inertial:
    """The inertial unit."""

    def __init__(self, settings: InertialParams, run: Run, bias: NDArray, noise: NDArray) -> None:
        self._unit, self._noise = InertialUnit(settings, run.step_s, bias), noise

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the samples of step k; at the start nothing has turned yet."""
        turned, gained = truth.turned, truth.gained
        rate, force = self._unit.measure(truth.rate, truth.felt, turned, gained,
                                         self._noise[..., k, :])
        return {'inertial': INERTIAL(rate=rate, force=force)}


class Camera:
    """The camera: markers in the image, as they were when it was exposed."""

    def __init__(self, settings: SeeingParams, camera: CameraParams, chaser: Chaser,
                 scatter: Scatter, craft: Spacecraft, late: int, period: int, views: NDArray,
                 properties: NDArray, batch: tuple) -> None:
        self._settings, self._camera, self._late = settings, camera, late
        self._centre, self._mounted = mounted(
            settings, drawn(scatter, craft, chaser, properties), batch)
        self._normals, self._chance = _by_view(views)
        self._period = period
        self._points = markers.TARGET_PORT + np.concatenate([markers.BIG, markers.SMALL])

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the features that come out at step k."""
        offset, turn = relative(truth, self._centre)
        row = k//self._period
        normals = self._normals[..., row, :].reshape((*turn.shape[:-1], len(self._points), 2))
        pixels = features(self._camera, self._settings.image, self._points, markers.FACING,
                          offset, turn, normals, self._chance[..., row], *self._mounted)
        return {'features': FEATURES(pixels=pixels, exposed=np.int64(k - self._late))}


class SimpleCamera:
    """A camera that gives a pose with noise of a fixed size."""

    def __init__(self, settings: SeeingParams, camera: CameraParams, chaser: Chaser,
                 scatter: Scatter, craft: Spacecraft, late: int, period: int, views: NDArray,
                 properties: NDArray, batch: tuple) -> None:
        self._late, self._period = late, period
        self._normals, self._chance = _by_view(views)
        self._drop_out = settings.image.drop_out
        self._place = settings.noise.simple_place_sigma_m
        self._angle = np.radians(settings.noise.simple_angle_sigma_deg)
        self._centre, (turned, moved) = mounted(
            settings, drawn(scatter, craft, chaser, properties), batch)
        self._off = bool(np.any(turned) or np.any(moved))
        self._tilt = attitude.from_rotation_vector(np.radians(turned))
        self._lens = np.array(camera.place_m), np.array(camera.place_m) + moved
        self._covariance = np.diag([self._place**2]*3 + [self._angle**2]*3)

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the pose that comes out at step k."""
        offset, turn = relative(truth, self._centre)
        row = k//self._period
        normals = self._normals[..., row, :]
        lost = (self._chance[..., row, np.newaxis] < self._drop_out) | ~np.isfinite(offset[..., :1])
        place = attitude.rotate_back(turn, markers.TARGET_PORT - offset)
        if self._off:                          # seen from where it is, taken for where it should be
            thought, really = self._lens
            place = attitude.rotate_back(self._tilt, place - really) + thought
            turn = attitude.multiply(turn, self._tilt)
        place = place + self._place*normals[..., :3]
        seen = attitude.multiply(turn, attitude.from_rotation_vector(
            self._angle*normals[..., 3:6]))
        usable = np.where(lost[..., 0], 0, len(markers.BIG))
        return {'pose': POSE(
            place=np.where(lost, np.nan, place), turn=np.where(lost, np.nan, seen),
            covariance=np.broadcast_to(self._covariance, (*offset.shape[:-1], 6, 6)),
            usable=usable, exposed=np.int64(k - self._late),
            markers=np.full(usable.shape, -1))}


def mounted(settings: SeeingParams, own: Any, batch: tuple) -> tuple[NDArray, tuple]:
    """Return the craft's centre (*batch, 3), and how the camera is turned [deg] and moved [m]."""
    def shaped(of_rows: NDArray) -> NDArray:
        return of_rows.reshape((*batch, 3))
    return shaped(own.centre), (shaped(settings.image.alignment_deg + own.alignment),
                                shaped(settings.image.offset_m + own.camera))


def _by_view(views: NDArray) -> tuple[NDArray, NDArray]:
    """Return normals (..., views, 24) and uniforms (..., views) of normal draws of all views."""
    from scipy.special import ndtr
    drawn = np.reshape(views, (*np.shape(views)[:-1], -1, VIEW_DRAWS))
    return drawn[..., :-1], ndtr(drawn[..., -1])


def relative(truth: Any, centre: NDArray) -> tuple[NDArray, NDArray]:
    """Return the drawing's origin of the chaser from the target's centre, target axes; attitude."""
    batch = np.shape(truth.position)[:-1]
    away, turn = compiled().relative(rows(truth.position, 3), rows(truth.attitude, 4),
                                     rows(truth.target_attitude, 4))
    away, turn = away.reshape((*batch, 3)), turn.reshape((*batch, 4))
    return away - attitude.rotate(turn, np.broadcast_to(centre, away.shape)), turn
