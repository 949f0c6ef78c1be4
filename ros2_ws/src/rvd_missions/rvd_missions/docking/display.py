"""
What the console shows of the approach: what the craft says of itself and, in a review, the truth.

Frame   of the scene: x as in LVLH towards the target, y up, away from the Moon (-z of LVLH), z to
        the right as one looks along x (y of LVLH); from the target's centre.
Truth   panels that bend and liquids that move are measured by nothing on board, and the error of
        the navigation is not known there: all three are drawn of the truth, in a review alone.
        Propellant and pulses of a live run are booked from the valves that were commanded.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.display import (
    Alarm, Attitude, Body, Box, Camera, Chart, Charts, CommandAxis, CommandRow, Commands, DERIVED,
    Display, Flat, Gate, Gauge, Guidance, Instrument, Instruments, Label, Legend, Line, Needles,
    Number, Perspective, Pixels, Reading, Readout, Ref, Revolved, Ring, Section, Sphere, Spot,
    Trail, TRUTH)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry.pinhole import CameraParams
from rvd_dynamics.motion import attitude
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, PILOT, RunFacts
from rvd_missions.docking import markers, safety
from rvd_missions.docking.display_parts import (
    AXES, chaser, CHORD_M, digits, forms, hands, lamps, LIQUID_M, NEAR_X, seen, seen_turn, target)
from rvd_missions.docking.onboard import AUTHORITY
from rvd_missions.docking.settings import faces
from rvd_missions.docking.signals import ESTIMATE, FEATURES, GUIDANCE, POSE, STATIONS, THRUST

DEG = float(np.degrees(1.0))
BEND, SLOSH = 30.0, 5.0                 # what is drawn of the truth is larger by this
FADE_S = 0.7                            # [s] wall time in which a lamp goes out
G0 = 9.80665                            # [m/s^2]
ISP_S = 290.0                           # [s] that the books are kept with
GATES_M = (4.0, 2.0, 1.0, 0.5)          # [m] from the port, of what a good approach is
BACK_MM, BACK_MM_S = 10.0, 2.0          # by which an alarm's reading must be inside its limit again


class DockingDisplay(MissionDisplay):
    """The approach on the console."""

    heard_nodes = ('docking_controller', 'onboard_guard', 'console')

    def __init__(self, facts: RunFacts, scenario: Scenario) -> None:
        self._chaser, self._panels, self._tanks, self._limits, self._aim, self._form = map(
            scenario.part, ('chaser', 'panels', 'tanks', 'limits', 'aim', 'form'))
        self._n, form = scenario.part('orbit').mean_motion, self._form
        self._bounds = scenario.settings('docking_controller').safety
        topics = {signal.name for block in scenario.diagram.blocks
                  for signal in block.writes.values()}
        self._pinhole = FEATURES.name in topics
        self.derives_from = (GUIDANCE.name, POSE.name, *((FEATURES.name,) if self._pinhole else ()))
        self._flow = form.thrusters.force/(ISP_S*G0)             # [kg/s] of each thruster
        self._groups = np.array([['J1', 'J2', 'J3', 'J4'].index(g) for g in form.thrusters.groups])
        self._valves = np.zeros(len(form.thrusters), dtype=bool)
        self._glow = np.zeros(len(form.thrusters))
        self._pulses, self._spent = np.zeros(4, dtype=int), 0.0
        self._state, self._since = -1, 0.0
        super().__init__(facts, self._display(facts, scenario))

    # -- what goes by -------------------------------------------------------------------------

    def sent(self, sample: Sample) -> None:
        """Keep the books of the valves: what fades, pulses of each group, propellant."""
        value = np.array(sample.parts['value'], dtype=bool)
        if value.size != self._valves.size:
            return
        fade = self.facts.step_s/(FADE_S*max(self.facts.pace, 1.0))
        self._glow = np.where(value, 1.0, np.maximum(self._glow - fade, 0.0))
        self._pulses += np.bincount(self._groups[value & ~self._valves], minlength=4)
        self._spent += float(self._flow[value].sum())*self.facts.step_s
        self._valves = value

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return what is drawn of the estimate, the guidance, the camera and the valves."""
        made: dict[str, Any] = {
            'glow': self._glow.round(2).tolist(), 'pulses': self._pulses.tolist(),
            'spent': self._spent, 'wrench': (
                self._form.effect(self._valves.astype(np.uint8))/AUTHORITY).tolist(),
            'known': ['errors: truth, in a review', False],
            'books': [f'{int(self._pulses.sum())} pulses, {1000.0*self._spent:.0f} g booked',
                      False]}
        made |= self._estimated(newest.get(ESTIMATE.name))
        guided = newest.get(GUIDANCE.name)
        if guided is not None and guided.ok:
            made |= self._guided(guided)
        made |= self._images(newest.get(POSE.name), newest.get(FEATURES.name))
        return made

    def _estimated(self, sample: Sample | None) -> dict[str, Any]:
        if sample is None or not sample.ok:
            return {}
        r, v, q, rate = (np.array(sample.parts[name]) for name in
                         ('position', 'velocity', 'attitude', 'rate'))
        sigma = np.array(sample.parts.get('sigma', (np.nan,)*9))
        port = r + attitude.rotate(q, markers.CHASER_PORT) - markers.TARGET_PORT
        distance, across = -float(port[0]), float(np.hypot(port[1], port[2]))
        spin = rate + self._n*attitude.matrix(q)[1]     # relative to the target, body axes
        wall, fastest = self._bounds_at(distance)
        hovers = sample.t >= self._limits.from_s
        return {
            'chaser': seen(r).tolist(), 'turn': seen_turn(q).tolist(),
            'port': seen(port).tolist(), 'port_rate': seen(v).tolist(),
            'r': r.tolist(), 'v': v.tolist(), 'q': q.tolist(), 'distance': distance,
            'across': across, 'closing': float(v[0]), 'fastest': fastest, 'wall': wall,
            'extent': float(max(1.15*max(wall, across), 0.1)),
            'cut': [f'at {distance:.2f} m', False],
            'angles': (DEG*attitude.rotation_vector(q)).tolist(), 'rates': (DEG*spin).tolist(),
            'sigma_mm': (1000.0*sigma[:3]).tolist(), 'sigma_deg': (DEG*sigma[6:]).tolist(),
            # of all three axes together, as the error beside it
            'sigmas': [float(np.sqrt(np.sum(part*part))) for part in
                       (1000.0*sigma[:3], 1000.0*sigma[3:6], DEG*sigma[6:])],
            'near': self._limits_at(-1.0) if hovers else None,
            'far': self._limits_at(1.0) if hovers else None}

    def _bounds_at(self, distance: float) -> tuple[float, float]:
        """Return how far across [m] and how fast [m/s] the craft may be at a distance [m]."""
        b = self._bounds
        wall = b.near_lateral_m if distance <= b.near_m else distance*np.tan(np.radians(b.cone_deg))
        fastest = np.sqrt(2.0*b.brake_m_s2*max(distance - b.stop_m, 0.0))
        return float(wall), max(b.least_speed_m_s, float(fastest))

    def _limits_at(self, side: float) -> float:
        return self._aim.distance_m + side*self._limits.band_m

    def _guided(self, sample: Sample) -> dict[str, Any]:
        state = int(sample.parts['safety'])
        if state != self._state:
            self._state, self._since = state, sample.t
        words = safety.NAMES[state] + (f' for {sample.t - self._since:.0f} s' if state else '')
        made: dict[str, Any] = {'safety': [words, state != safety.NOMINAL],
                                'unsafe': float(state != safety.NOMINAL),
                                'demand': sample.parts['demand']}
        wanted = np.array(sample.parts['reference'])
        if np.isfinite(wanted).all():
            port = wanted + markers.CHASER_PORT - markers.TARGET_PORT
            made |= {'planned': -float(port[0]),
                     'wanted': seen(wanted + markers.CHASER_PORT).tolist(),
                     'behind': 1000.0*float(sample.parts['error'][0])}
        return made

    def _images(self, pose: Sample | None, features: Sample | None) -> dict[str, Any]:
        count = len(markers.BIG)
        counted = int(pose.parts['markers']) if pose is not None else -1
        made: dict[str, Any] = {
            'usable': None if pose is None else float(pose.parts['usable']),
            'set': None if counted < 0 else
            [f'{("big", "big and small", "small")[counted]} markers', False]}
        if features is not None and features.ok:
            known = np.isfinite(np.reshape(features.parts['pixels'], (-1, 2))[:, 0])
            used = known & np.repeat([counted in (0, 1), counted in (1, 2)], count)
            made |= {'pixels': features.parts['pixels'], 'used': used.astype(int).tolist()}
        return made

    # -- the truth, in a review -----------------------------------------------------------------

    def beside(self, shown: Mapping[str, Mapping[str, Any]], truth: Mapping[str, Any]
               ) -> dict[str, Any]:
        """Return what is drawn of the truth, and the error of the navigation."""
        r, q, target = (np.array(truth[n]) for n in ('position', 'attitude', 'target_attitude'))
        centre = np.array(self._chaser.centre_m)
        port, turn = faces(r, q, target, centre)
        origin = attitude.rotate_back(target, r) - attitude.rotate(turn, centre)
        made: dict[str, Any] = {
            'seen': seen(origin).tolist(), 'turn': seen_turn(turn).tolist(),
            'port': seen(port).tolist(), 'distance': -float(port[0]),
            'across': float(np.hypot(port[1], port[2])),
            'angles': (DEG*attitude.rotation_vector(turn)).tolist()}
        bending = np.reshape(truth['bending'], (2, len(STATIONS)))
        for i, side in enumerate((1.0, -1.0)):
            made[f'panel_{i}'] = self._outline(side, bending[i], origin, turn)
        for i, slosh in enumerate(np.reshape(truth['sloshing'], (2, 3))):
            rest = np.array([self._tanks.place_m[i], 0.0, 0.0])
            made[f'liquid_{i}'] = seen(origin + attitude.rotate(turn, rest + SLOSH*slosh)).tolist()
        made['tip_mm'] = 1000.0*float(np.abs(bending[:, -1]).max())         # of the worse of two
        made['slosh_mm'] = 1000.0*float(np.abs(truth['sloshing']).max())
        derived = shown.get(DERIVED, {})
        if derived.get('r') is not None:
            lost = attitude.rotation_vector(attitude.multiply(
                attitude.conjugate(np.array(derived['q'])), turn))
            speed = attitude.rotate_back(target, np.array(truth['velocity']))
            made |= {'error_mm': (1000.0*(np.array(derived['r']) - origin)).tolist(),
                     'error_m_s': (np.array(derived['v']) - speed).tolist(),
                     'error_deg': (-DEG*lost).tolist()}
        return made

    def _outline(self, side: float, bent: NDArray, origin: NDArray, turn: NDArray) -> list:
        """Return the edge of a panel as rows of points of the scene, its bending larger by BEND."""
        along = side*(self._panels.root_m + self._panels.length_m*np.array((0.0, *STATIONS)))
        out = BEND*np.array((0.0, *bent))
        edge = np.stack([np.zeros(5), along, out], axis=-1)
        half = np.array([CHORD_M, 0.0, 0.0])
        rows = np.concatenate([edge - half, (edge + half)[::-1], edge[:1] - half])
        return seen(origin + attitude.rotate(np.broadcast_to(turn, (len(rows), 4)), rows)).tolist()

    # -- hand controllers -----------------------------------------------------------------------

    def pilot(self, axes: Sequence[float], buttons: Sequence[int]) -> tuple[list[float], bool]:
        """Return the six deflections, and whether anybody holds the controllers."""
        if len(axes) < len(AXES) or not all(-1.0 <= a <= 1.0 for a in axes) or not any(buttons):
            return [0.0]*len(AXES), False
        return list(axes), True

    # -- what is drawn --------------------------------------------------------------------------

    def _display(self, facts: RunFacts, scenario: Scenario) -> Display:
        b = self._bounds
        slope = float(np.tan(np.radians(b.cone_deg)))
        start = scenario.part('start').position_m
        far = -float(start[0]) + 1.0
        band = (NEAR_X - self._limits_at(1.0), NEAR_X - self._limits_at(-1.0))
        hand = facts.operator == 'console' and facts.mode == 'manual'

        def of(part: str, index: tuple = (0,), factor: float = 1.0) -> Number:
            return Number(DERIVED, part, index, factor)

        def true(part: str, index: tuple = (0,), factor: float = 1.0) -> Number:
            return Number(TRUTH, part, index, factor)

        def row(label: str, unit: str, value: Number, truth: Number | None = None, digits: int = 1,
                low: Any = None, high: Any = None) -> Instrument:
            beside = (Reading('truth', truth),) if truth is not None else ()
            return Instrument(label, unit, (*beside, Reading('measured', value, low, high)), digits)
        xyz, turns = (0, 1, 2), tuple(of('angles', (i,)) for i in range(3))
        return Display(
            measured=ESTIMATE.name, link=False, stars=True,
            bodies=(
                Body('target', 'target', target(), label='target'),
                Body('chaser', 'measured', chaser(self._panels, self._tanks),
                     Ref(DERIVED, 'chaser'), attitude=Ref(DERIVED, 'turn'), label='chaser'),
                Body('truth', 'truth', (Box((3.0, 0.7, 0.7)),), Ref(TRUTH, 'seen'),
                     attitude=Ref(TRUTH, 'turn'), label='truth')),
            surfaces=(
                Revolved('cone', 'limit',
                         (-far, NEAR_X - b.near_m, NEAR_X - b.near_m + 1e-3, NEAR_X),
                         ((far + NEAR_X)*slope, b.near_m*slope, b.near_lateral_m, b.near_lateral_m),
                         meridians=4, faint_meridians=8, rings=((NEAR_X - 1.0, slope),
                                                                (NEAR_X - 3.0, 3.0*slope))),
                Revolved('band', 'goal', band, (0.3, 0.3), meridians=8,
                         rings=tuple((x, 0.3) for x in band)),
                Sphere('wanted', 'goal', 0.06, Ref(DERIVED, 'wanted')),
                *(Sphere(name, 'truth', LIQUID_M, Ref(TRUTH, f'liquid_{i}'))
                  for i, name in enumerate(('hydrogen', 'oxygen')) if self._tanks.sloshing)),
            lines=(Trail('flown', 'measured', Ref(DERIVED, 'chaser')),
                   Trail('true_path', 'truth', Ref(TRUTH, 'seen')),
                   *(Line(f'panel_{i}', 'truth', Ref(TRUTH, f'panel_{i}')) for i in range(2)
                     if self._panels.flexible)),
            labels=(Label(f'{b.cone_deg:g} deg', (NEAR_X - 3.0, 3.0*slope, 0.0)),),
            legend=(Legend('measured', 'estimate of the craft'),
                    Legend('goal', 'planned port, band'),
                    Legend('limit', 'cone'),
                    Legend('truth', f'truth, in a review: bending \u00d7{BEND:.0f}, '
                           f'liquids \u00d7{SLOSH:.0f}')),
            views=(
                Perspective('Approach', centre_m=(NEAR_X, 0.0, 0.0), distance_m=9.0,
                            follow=('chaser', 'truth'), start_m=-4.5, growth=1.0,
                            azimuth_rad=2.0, height_rad=0.45),
                Flat('Side', '+x', '+y', (-3.9, 0.0, 0.0), 9.5),
                Flat('Top', '+x', '-z', (-3.9, 0.0, 0.0), 9.5),
                Flat('Along', '+z', '+y', (0.0, 0.0, 0.0), 12.0),
                Flat('Faces', '+x', '+y', (NEAR_X - 0.1, 0.0, 0.0), 1.4)),
            camera=self._camera(scenario.part('camera')),
            instruments=Instruments('Approach', (
                row('distance', 'mm', of('distance', factor=1000.0),
                    true('distance', factor=1000.0), 0,
                    of('near', factor=1000.0), of('far', factor=1000.0)),
                row('to plan', 'mm', of('behind')),
                row('closing', 'mm/s', of('closing', factor=1000.0), digits=1,
                    high=of('fastest', factor=1000.0)),
                row('across', 'mm', of('across', factor=1000.0), true('across', factor=1000.0),
                    high=of('wall', factor=1000.0)),
                row('\u03c3 position', 'mm', of('sigmas', (0,)), true('error_mm', xyz), 2),
                row('\u03c3 speed', 'mm/s', of('sigmas', (1,)), true('error_m_s', xyz, 1000.0),
                    2),
                row('\u03c3 attitude', 'deg', of('sigmas', (2,)), true('error_deg', xyz), 3),
                Instrument('panel tip', 'mm', (Reading('truth', true('tip_mm')),), 1),
                Instrument('liquid', 'mm', (Reading('truth', true('slosh_mm')),), 1),
                row('markers', '', of('usable'), digits=0),
                row('propellant', 'g', of('spent', factor=1000.0),
                    true('propellant', factor=1000.0), 0))),
            section=Section(
                'Port across', 'Offset of the craft\'s port from the target\'s, with the bound',
                of('extent'), names=('y', '\u2212z'), note=Ref(DERIVED, 'cut'),
                rings=(Ring('limit', of('wall'), written=True),
                       Ring('goal', self._limits.lateral_m, dashed=True)),
                spots=(Spot('measured', Ref(DERIVED, 'port'), rate=Ref(DERIVED, 'port_rate')),
                       Spot('truth', Ref(TRUTH, 'port'), 'cross')),
                foot=Readout('safety', Ref(DERIVED, 'safety'))),
            attitude=Attitude(
                'Attitude from the target\'s', 'Roll, pitch and yaw of the craft from the target',
                (Needles('measured', turns, tuple(of('rates', (i,)) for i in range(3))),
                 Needles('truth', tuple(true('angles', (i,)) for i in range(3)))),
                limit=self._limits.attitude_deg),
            lamps=lamps(),
            commands=Commands(
                'Demand', tuple(CommandAxis(name, 1.0) for name in AXES), THRUST.name,
                (*((CommandRow('hands', 'pilot', Ref(PILOT, 'value')),) if hand else ()),
                 CommandRow('demanded', 'automatic', Ref(DERIVED, 'demand')),
                 CommandRow('valves', 'sent', Ref(DERIVED, 'wrench'))), digits=2),
            controller=hands() if hand else None,
            charts=Charts('Course', (
                Chart('distance, m', (of('distance'), of('planned'), true('distance')), least=0.1,
                      names=('flown', 'planned', 'true'), centred=False,
                      levels=(self._limits_at(-1.0), self._limits_at(1.0)), wide=True),
                *(Chart(f'{axis}, mm', (true('error_mm', (i,)),), of('sigma_mm', (i,)), least=0.5)
                  for i, axis in enumerate('xyz')),
                *(Chart(f'{axis}, deg', (true('error_deg', (i,)),), of('sigma_deg', (i,)),
                        least=0.02) for i, axis in enumerate(AXES[3:]))),
                note=Ref(DERIVED, 'known'), window_s=60.0, columns=3,
                band='\u00b12\u03c3 as claimed'),
            alarms=(
                Alarm('THE CRAFT HAS STOPPED THE APPROACH',
                      (Reading('measured', of('unsafe'), high=0.5),)),
                Alarm('OUTSIDE THE CONE',
                      (Reading('measured', of('across', factor=1000.0),
                               high=of('wall', factor=1000.0)),), 'across', 'mm', 0, BACK_MM),
                Alarm('TOO FAST',
                      (Reading('measured', of('closing', factor=1000.0),
                               high=of('fastest', factor=1000.0)),),
                      'closing', 'mm/s', 1, BACK_MM_S)),
            guidance=self._guidance(), modes=(), abort='backing away with J4',
            goal='hovering before the port',
            hint='Hover with the faces 3 to 11 cm apart.', forms=forms(scenario))

    def _guidance(self) -> Guidance:
        """Return the bounds of the safety strategy at some distances, and where to hover."""
        limits, gates = self._limits, []
        for at in GATES_M:
            wall, fastest = self._bounds_at(at)
            gates.append(Gate(at, (f'within {wall:.2f} m', f'below {1000.0*fastest:.0f} mm/s')))
        return Guidance(
            tuple(gates), (
                f'{1000.0*self._limits_at(-1.0):.0f} to {1000.0*self._limits_at(1.0):.0f} mm apart',
                f'across within {1000.0*limits.lateral_m:.0f} mm',
                f'turned within {limits.attitude_deg:g} deg'),
            (Number(DERIVED, 'distance'),), contact_label='hover')

    def _camera(self, camera: CameraParams) -> Camera:
        pixels = Pixels(Ref(DERIVED, 'pixels'), Ref(DERIVED, 'used'), float(camera.width_px),
                        camera.half_view) if self._pinhole else None
        title = ('markers as found, over the view from the estimate'
                 if self._pinhole else 'view from the estimate')
        return Camera(
            title, title, ('chaser',), at_m=tuple(seen(camera.place_m).tolist()),
            turns=True, aim_m=(NEAR_X, 0.0, 0.0), half_height_m=0.4,
            half_field=(0.06, 1.06*camera.half_view), pixels=pixels,
            gauge=Gauge('mm/s', -20.0, 80.0, 10.0, 2, (
                Reading('measured', Number(DERIVED, 'closing', factor=1000.0)),), digits=0),
            distance=(Reading('measured', Number(DERIVED, 'distance')),), digits=3,
            numbers=digits(('measured', '')))
