"""
What the console shows of the lunar approach: corridor, docking port, drift, thrust levels.

Frame   target orbital: +x along track, +y radially outward, +z completes the triad; the docking
        port is at the origin, the chaser comes from -x. States (x, y, z, vx, vy, vz) [m, m/s].
"""

from collections.abc import Mapping, Sequence
from math import asin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import KIND_ABORT
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.commands.levels import HIGHEST, stick_axes, stick_levels, StickParams
from rvd_dynamics.constants import RADIUS_MOON
from rvd_dynamics.diagram.display import (
    Axis, Ball, Body, Box, Camera, CameraMark, Chart, Charts, CommandAxis, CommandRow, Commands,
    Controller, Cylinder, DERIVED, Digits, Display, Flat, Gauge, Instrument, Instruments, Label,
    Legend, Line, Motion, Number, Perspective, Reading, Readout, Ref, Revolved, Ring, Section,
    Solid, Spot, Torus, Trail, TRUTH)
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.geometry.cone import (
    Cone, control_boundary, distance_at, radius, signed_distance)
from rvd_dynamics.geometry.obstacles import clearance
from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, RunFacts
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_missions.lunar_approach import advice, signals
from rvd_missions.lunar_approach.aborted import AbortedWay
from rvd_missions.lunar_approach.advice import both
from rvd_missions.lunar_approach.scene import obstacle_spheres
from rvd_missions.lunar_approach.settings import DockingParams, Obstacles

TELEMETRY, ESTIMATE, PREDICTION, SCORE, AUTO, COMMAND, PILOT = (
    signal.name for signal in (signals.TELEMETRY, signals.ESTIMATE, signals.PREDICTION,
                               signals.SCORE, signals.AUTO, signals.COMMAND, signals.STICK))

HORIZON_S = 240                 # [s] how far free drift is followed
DRIFT_POINTS = 24               # points of the line where the chaser drifts if nothing is done
FARTHEST_M = -36.0              # [m] first station at which the corridor is drawn
STATIONS = 61                   # at which the control boundary is
LEAST_EXTENT_M = 0.36           # [m] of the cross-section, which shrinks with the corridor
MOST_EXTENT = 2.5               # wall radii: a chaser further out is shown at the section's edge
AIM_FROM_M = -0.2               # [m] nearer than this the aim on the camera says nothing

HULL, DARK, FOIL, CELLS = '#d5dbe2', '#3a4652', '#b98f4c', '#27508a'
STATION, PORT, END, WHITE, GREEN = '#c3cad2', '#333e49', '#aeb6be', '#f2f5f8', '#56d6b0'


class LunarDisplay(MissionDisplay):
    """The lunar approach on the console."""

    heard_nodes = ('command_blender', 'state_predictor', 'auto_controller', 'console')

    def __init__(self, facts: RunFacts, orbit: OrbitParams, start: StartParams, cone: Cone,
                 docking: DockingParams, stick: StickParams, approach_rate_m_s: float,
                 obstacles: Obstacles, run: Run, form: CommandForm, legs: Legs,
                 abort_profile: AbortProfile) -> None:
        self._orbit, self._cone, self._docking, self._stick = orbit, cone, docking, stick
        self._rate_m_s = approach_rate_m_s
        self._start_m = tuple(start.position_m)
        self._loop_s = facts.forward_s + facts.back_s
        self._horizon = np.linspace(0.0, HORIZON_S, HORIZON_S + 1)
        self._drift = cw.transition(orbit.mean_motion, self._horizon)
        self._obstacles = obstacle_spheres(obstacles, run)
        self._places = np.array([sphere.place for sphere in self._obstacles]).reshape(-1, 3)
        self._radii = obstacles.radii
        self._aborted = AbortedWay(abort_profile, form, orbit, legs, run)
        super().__init__(facts, self._display())

    # -- what is derived ------------------------------------------------------------------

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return margins, the cross-section, where the drift leads, and the words beside them."""
        measured, predicted = state_in(newest, TELEMETRY), state_in(newest, PREDICTION)
        made: dict[str, Any] = {}
        for name, state in (('measured', measured), ('predicted', predicted)):
            made[f'wall_{name}'] = made[f'margin_{name}'] = None
            if self._obstacles:
                made[f'clearance_{name}'] = None if state is None else float(
                    clearance(state[:3], self._places, self._radii).min())
            if state is not None:
                made[f'wall_{name}'] = self._wall(state)
                made[f'margin_{name}'] = float(signed_distance(state[:3], self._cone))
        made.update(self._section(predicted if predicted is not None else measured,
                                  max(offset(s) for s in (measured, predicted, np.zeros(3))
                                      if s is not None)))
        outlook = None if predicted is None else self.outlook(
            predicted, self._push(newest[PREDICTION]))
        made['ahead'] = self._ahead(newest) if predicted is not None else None
        made['drift'] = outlook and outlook['path']
        made['hit'] = outlook and outlook['hit'] and [0.0, *outlook['hit']]
        made['leave'] = self._leave_words(outlook)
        made['room'] = None if predicted is None else float(
            self._boundary(min(float(predicted[0]), 0.0)) - offset(predicted))
        made['leave_s'] = None if outlook is None else (
            HORIZON_S if outlook['leave'] is None else outlook['leave'])
        made['aim'] = None
        if measured is not None and predicted is not None and measured[0] < AIM_FROM_M:
            made['aim'] = [0.0, *(measured[1:3] - predicted[1:3]).tolist()]
        made['spread_estimate'] = two_sigma(newest.get(ESTIMATE))
        made['spread_prediction'] = two_sigma(newest.get(PREDICTION))
        made['rms'] = rms_words(newest.get(SCORE))
        return made

    def _wall(self, state: NDArray) -> float:
        """Return the wall radius [m] at the station of a state, at the port past it."""
        return float(radius(min(float(state[0]), 0.0), self._cone))

    def _boundary(self, station: Any) -> NDArray:
        return control_boundary(station, self._cone, self._orbit.mean_motion, self._rate_m_s,
                                self._loop_s)

    def _section(self, state: NDArray | None, farthest: float) -> dict[str, Any]:
        """
        Return wall and control boundary where the corridor is cut, and the words for where.

        The cut reaches to what is `farthest` [m] from the axis, within reason.
        """
        x = float(self._start_m[0] if state is None else state[0])
        station = max(FARTHEST_M, min(x, 0.0))
        wall = float(radius(station, self._cone))
        return {'section_wall': wall, 'section_boundary': float(self._boundary(station)),
                'section_extent': max(wall*1.12, LEAST_EXTENT_M,
                                      min(farthest*1.12, wall*MOST_EXTENT)),
                'section_note': [f'at x = {shown(station, 1)} m', False]}

    def _leave_words(self, outlook: dict[str, Any] | None) -> list | None:
        if outlook is None:
            return None
        if outlook['margin'] < 0.0:
            return ['OUTSIDE', True]
        if outlook['leave'] is None:
            return ['stays inside', False]
        return [f'{outlook["leave"]:.0f} s', outlook['leave'] < self._loop_s]

    def sent(self, sample: Sample) -> None:
        """Follow what is sent: after an ABORT the guard decides what acts."""
        self._aborted.sent(sample.step, sample.parts['value'], sample.parts['kind'] == KIND_ABORT)

    def _step_of(self, sample: Sample) -> int:
        """Return the step at whose beginning a sample is valid."""
        return round(sample.t / self.facts.step_s)

    def _push(self, predicted: Sample) -> NDArray | None:
        """Return what the guard adds to the drift, rows (x, y, z) [m]; None before an ABORT."""
        if self._aborted.abort_step is None:
            return None
        return self._aborted.push(self._step_of(predicted), self._horizon)

    def _ahead(self, newest: Mapping[str, Sample]) -> list[list[float]] | None:
        """Return the way from the estimate to the prediction after an ABORT, None before one."""
        estimate = state_in(newest, ESTIMATE)
        if self._aborted.abort_step is None or estimate is None:
            return None
        return self._aborted.ahead(estimate, self._step_of(newest[ESTIMATE]),
                                   self._step_of(newest[PREDICTION]))

    def outlook(self, state: NDArray, push: NDArray | None = None) -> dict[str, Any]:
        """
        Return where a state (6,) stands in the corridor and where it drifts.

        Unpowered, or with what the guard of an aborted approach adds: `push` (T, 3) [m].
        `margin` [m] to the wall, `leave` [s] until the drift leaves the corridor (None: it does
        not), `plane` [s] until it reaches the docking plane (None: never), `hit` (y, z) there,
        `path` rows (x, y, z).
        """
        corridor = self._cone
        made: dict[str, Any] = {'margin': float(signed_distance(state[:3], corridor)),
                                'leave': None, 'plane': None, 'hit': None}
        path = np.einsum('kij,j->ki', self._drift[:, :3], state)
        if push is not None:
            path = path + push
        y, z = path[:, 1], path[:, 2]
        margin = distance_at(path[:, 0], np.sqrt(y*y + z*z), corridor)
        plane = _crossing(self._horizon, -path[:, 0])
        leave = _crossing(self._horizon, margin)
        end = float(self._horizon[-1]) if plane is None else plane
        if leave is not None and leave <= end:
            made['leave'] = leave
        if plane is not None:
            made['plane'] = plane
            made['hit'] = [float(np.interp(plane, self._horizon, c)) for c in (y, z)]
        times = np.linspace(0.0, end, DRIFT_POINTS)
        made['path'] = np.stack([np.interp(times, self._horizon, path[:, i])
                                 for i in range(3)], axis=-1).round(3).tolist()
        return made

    def measured(self, state: list[float]) -> dict[str, Any]:
        """Return position and velocity."""
        return {'position': state[:3], 'velocity': state[3:]}

    # -- the stick ------------------------------------------------------------------------

    def joy(self, deflection: Sequence[float], held: bool
            ) -> tuple[list[float], list[int]] | None:
        """Put the stick on the axes and the button that the scenario names."""
        axes, buttons = stick_axes(deflection, held, self._stick)
        if not buttons and not held:            # no dead-man button to open: say nothing
            return None
        return axes, buttons

    def pilot(self, axes: Sequence[float], buttons: Sequence[int]) -> tuple[list[float], bool]:
        """Return the levels that a Joy means."""
        levels, valid = stick_levels(axes, buttons, self._stick)
        return levels.tolist(), valid

    # -- what is drawn --------------------------------------------------------------------

    def _display(self) -> Display:
        docking = self._docking
        rate, lateral = docking.max_closing_rate_m_s, docking.max_lateral_rate_m_s
        return Display(
            measured=TELEMETRY, predicted=PREDICTION,
            bodies=(
                Body('chaser', 'measured', chaser(), Ref(TELEMETRY, 'position'),
                     label='measured'),
                Body('ghost', 'predicted', chaser(), Ref(PREDICTION, 'position'),
                     label='predicted'),
                Body('truth', 'truth', chaser(), Ref(TRUTH, 'position'), label='truth'),
                Body('station', 'target', station(self._cone.docking_radius_m))),
            surfaces=(*self._surfaces(), *self._obstacles),
            lines=(
                Trail('flown', 'measured', Ref(ESTIMATE, 'position')),
                Trail('ahead', 'predicted', Ref(PREDICTION, 'position'),
                      spread=Number(DERIVED, 'spread_prediction'),
                      since=Ref(ESTIMATE, 'position'),
                      since_spread=Number(DERIVED, 'spread_estimate'),
                      anew=Ref(DERIVED, 'ahead')),
                Line('drift', 'predicted', Ref(DERIVED, 'drift'), dashed=True),
                Trail('true_path', 'truth', Ref(TRUTH, 'position'))),
            labels=tuple(Label(f'−{x} m', (-float(x), 0.0, 0.0)) for x in range(5, 40, 5)),
            legend=(
                Legend('measured', 'measured'), Legend('predicted', 'predicted, 2σ tube'),
                Legend('predicted', 'drift from there', dashed=True),
                Legend('limit', 'corridor, obstacles' if self._obstacles else 'corridor'),
                Legend('guide', 'control boundary', dashed=True)),
            views=(
                Perspective('Orbit', distance_m=4.0, follow=('chaser', 'truth'), along='+x',
                            share=0.56, start_m=-30.0),
                Flat('Side', '+x', '+y', (-16.5, 0.0, 0.0), 40.0, stretch=4.0),
                Flat('Top', '+x', '-z', (-16.5, 0.0, 0.0), 40.0, stretch=4.0)),
            sky=(Ball((0.0, -1.0, 0.0), asin(RADIUS_MOON / self._orbit.radius_m)),),
            camera=self._camera(rate),
            instruments=Instruments('Motion', (
                Instrument('range', 'm', both('position', (0, 1, 2), past=0)),
                Instrument('closing rate', 'm/s', both('velocity', (0,), 0.0, rate), 3),
                Instrument('lateral offset', 'm', tuple(
                    Reading(role, Number(signal, 'position', (1, 2)),
                            high=Number(DERIVED, f'wall_{role}'))
                    for role, signal in (('measured', TELEMETRY), ('predicted', PREDICTION)))),
                Instrument('lateral rate', 'm/s', both('velocity', (1, 2), None, lateral), 3),
                Instrument('wall margin', 'm', margins('margin')),
                *((Instrument('clearance', 'm', margins('clearance')),)
                  if self._obstacles else ()))),
            section=self._cut(),
            commands=Commands('Thrust levels', tuple(CommandAxis(a, HIGHEST) for a in 'xyz'),
                              COMMAND, (
                CommandRow('pilot', 'pilot', Ref(PILOT, 'value')),
                CommandRow('automatic', 'automatic', Ref(AUTO, 'value')),
                CommandRow('sent', 'sent', Ref(COMMAND, 'value')))),
            controller=Controller((
                Axis('x', 'forward', 'back', (('KeyW', 'KeyS'),), 1, True, along='+x'),
                Axis('y', 'up', 'down', (('ArrowUp', 'ArrowDown'), ('KeyR', 'KeyF')), 3, True,
                     along='+y'),
                Axis('z', 'right', 'left', (('ArrowRight', 'ArrowLeft'), ('KeyD', 'KeyA')), 2,
                     along='+z')),
                tuple(level / HIGHEST for level in range(1, HIGHEST + 1)), verb='thrust'),
            charts=Charts('Prediction error', (
                *(error(f'{axis}, cm', i, 100.0) for i, axis in enumerate('xyz')),
                *(error(f'{axis} rate, mm/s', i, 1000.0) for i, axis in enumerate('xyz', 3))),
                Ref(DERIVED, 'rms'), columns=3, curve='predicted − received',
                band='±2σ as claimed'),
            alarms=advice.alarms(docking, self._loop_s, bool(self._obstacles)),
            guidance=advice.guidance(docking, self._cone, -self._start_m[0], self._rate_m_s,
                                     self._boundary),
            abort='braking and backing away',
            goal='docking within the limits',
            hint='Dock inside the green circle, slower than the limits.')

    def _surfaces(self) -> tuple[Revolved, ...]:
        corridor = self._cone
        x = np.linspace(FARTHEST_M, 0.0, STATIONS)
        tens = [-10.0, -20.0, -30.0]

        def wall(stations: Sequence[float]) -> tuple:
            return tuple(zip(stations, radius(np.array(stations), corridor).tolist()))
        ends = wall([FARTHEST_M, 0.0])
        return (
            Revolved('corridor', 'limit', *zip(*ends), faint_meridians=12, skin=True, axis=True,
                     rings=wall(tens), faint_rings=wall([-5.0, -15.0, -25.0, -35.0])),
            Revolved('boundary', 'guide', tuple(x.tolist()), tuple(self._boundary(x).tolist()),
                     dashed=True,
                     rings=tuple(zip(tens, self._boundary(np.array(tens)).tolist()))))

    def _camera(self, rate: float) -> Camera:
        def readings(part: str, index: tuple[int, ...], roles: tuple[str, ...],
                     past: int | None = None) -> tuple:
            signals = {'truth': TRUTH, 'measured': TELEMETRY, 'predicted': PREDICTION}
            return tuple(Reading(role, Number(signals[role], part, index, past=past))
                         for role in roles)
        return Camera(
            'docking camera · delayed', 'docking camera · truth', ('truth', 'chaser'),
            marks=(CameraMark('goal', (0.0, 0.0, 0.0), self._cone.docking_radius_m),
                   CameraMark('predicted', Ref(DERIVED, 'aim'))),
            gauge=Gauge('m/s', 0.0, rate * 1.34, 0.05, 2,
                        readings('velocity', (0,), ('truth', 'measured', 'predicted')), rate),
            distance=readings('position', (0, 1, 2), ('truth', 'measured'), past=0),
            numbers=Digits((
                Motion('to go', both('position', (0,), factor=-1.0), both('velocity', (0,)),
                       'closing', signed=False),
                Motion('up', both('position', (1,)), both('velocity', (1,))),
                Motion('right', both('position', (2,)), both('velocity', (2,))))))

    def _cut(self) -> Section:
        return Section(
            'Corridor section',
            'Cross-section of the corridor with measured and predicted position',
            Number(DERIVED, 'section_extent'), note=Ref(DERIVED, 'section_note'),
            rings=(Ring('limit', Number(DERIVED, 'section_wall'), written=True),
                   Ring('guide', Number(DERIVED, 'section_boundary'), dashed=True),
                   Ring('goal', self._cone.docking_radius_m)),
            spots=(Spot('predicted', Ref(DERIVED, 'hit'), 'cross',
                        origin=Ref(PREDICTION, 'position')),
                   Spot('measured', Ref(TELEMETRY, 'position')),
                   Spot('predicted', Ref(PREDICTION, 'position'), 'ring',
                        spread=Number(DERIVED, 'spread_prediction'),
                        rate=Ref(PREDICTION, 'velocity')),
                   Spot('truth', Ref(TRUTH, 'position'), 'cross')),
            foot=Readout('drifting out in', Ref(DERIVED, 'leave')))


def state_in(newest: Mapping[str, Sample], signal: str) -> NDArray | None:
    """Return the newest state (6,) of a signal, None when it is not known."""
    sample = newest.get(signal)
    if sample is None or not sample.ok:
        return None
    return np.array(sample.parts['position'] + sample.parts['velocity'])


def offset(state: NDArray) -> float:
    """Return how far a state (3 or more) is from the axis [m]."""
    return float(np.hypot(state[1], state[2]))


def two_sigma(sample: Sample | None) -> float | None:
    """Return two standard deviations [m] across the corridor, None when not estimated."""
    if sample is None or not sample.ok or 'sigma' not in sample.parts:
        return None
    return 2.0 * max(sample.parts['sigma'][1:3])


def rms_words(sample: Sample | None) -> list | None:
    """Return the errors of the prediction so far, in words."""
    if sample is None or not np.isfinite(sample.parts['rms']).all():
        return None
    rms = np.array(sample.parts['rms'])
    position, rate = np.sqrt(np.sum(rms[:3]**2)), np.sqrt(np.sum(rms[3:]**2))
    return [f'rms {100.0 * position:.1f} cm · {1000.0 * rate:.1f} mm/s', False]


def shown(value: float, digits: int) -> str:
    """Return a number as the page writes it, with a minus and no hyphen."""
    return f'{value:.{digits}f}'.replace('-', '−')


def margins(name: str) -> tuple[Reading, ...]:
    """Return the readings of a derived distance that must not fall below 0."""
    return tuple(Reading(role, Number(DERIVED, f'{name}_{role}'), low=0.0)
                 for role in ('measured', 'predicted'))


def error(title: str, i: int, factor: float) -> Chart:
    """Return the chart of one component of the error, with two of its own sigma."""
    return Chart(title, (Number(SCORE, 'error', (i,), factor),),
                 Number(SCORE, 'sigma', (i,), factor))


def chaser() -> tuple[Solid, ...]:
    """Return the chaser: its docking face is at the origin, the body lies behind it."""
    return (
        tube(DARK, 0.13, 0.16, 0.1, -0.05), tube(HULL, 0.17, 0.3, 0.2, -0.2),
        tube(HULL, 0.3, 0.3, 0.5, -0.55), tube(FOIL, 0.3, 0.26, 0.22, -0.91),
        tube(DARK, 0.09, 0.16, 0.16, -1.09), *panels(-0.7, 0.34, 0.95, 0.34, DARK))


def station(docking_radius_m: float) -> tuple[Solid, ...]:
    """Return the target: its port is at the origin, with the docking circle about it."""
    return (
        tube(PORT, 0.24, 0.2, 0.14, 0.08), tube(STATION, 0.5, 0.26, 0.3, 0.3),
        tube(STATION, 0.5, 0.5, 1.5, 1.2), tube(END, 0.3, 0.5, 0.35, 2.1),
        *panels(1.25, 0.55, 2.1, 0.8, PORT),
        Box((0.01, 0.3, 0.025), colour=WHITE, lit=False),       # the cross that one aims at
        Box((0.01, 0.025, 0.3), colour=WHITE, lit=False),
        Torus(docking_radius_m, 0.012, colour=GREEN, lit=False))


def tube(colour: str, front: float, back: float, length: float, x: float) -> Cylinder:
    """Return a piece of hull about the x axis, `front` its radius towards +x."""
    return Cylinder(front, length, back, (x, 0.0, 0.0), colour=colour)


def panels(x: float, reach: float, length: float, width: float, frame: str) -> tuple[Box, ...]:
    """Return two solar wings along z with the booms that hold them."""
    made = []
    for side in (-1, 1):
        made.append(Box((width, 0.015, length), (x, 0.0, side * (reach + length / 2)), frame))
        for i in range(4):
            z = side * (reach + (length * (i + 0.5)) / 4)
            made.append(Box((width * 0.94, 0.012, (length / 4) * 0.9), (x, 0.012, z), CELLS))
        made.append(Box((0.04, 0.03, reach), (x, 0.0, (side * reach) / 2 + side * 0.1), frame))
    return tuple(made)


def _crossing(times: NDArray, values: NDArray) -> float | None:
    """Return the first instant at which `values` falls below zero, None when it does not."""
    below = np.flatnonzero(values < 0.0)
    if not below.size:
        return None
    i = int(below[0])
    if i == 0:
        return 0.0
    share = values[i - 1] / (values[i - 1] - values[i])
    return float(times[i - 1] + share * (times[i] - times[i - 1]))
