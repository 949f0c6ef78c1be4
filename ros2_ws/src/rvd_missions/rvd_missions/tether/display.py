"""
What the console draws: platform, tether, gripper and target, from what came down the link.

Frame   of the scene: from the platform, x as in the inertial frame of the start, y up, away from
        the Earth, z against the orbit's normal. The range is the planned one, since nothing
        measures it; direction, attitude and length are measured. The true range is shown in a
        review alone.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.display import (
    Alarm, Body, Box, Chart, Charts, CommandAxis, CommandRow, Commands, Cylinder, DERIVED, Display,
    Flat, Instrument, Instruments, Label, Legend, Line, Number, Perspective, Reading, Readout, Ref,
    Ring, Section, Spot, Trail, TRUTH)
from rvd_dynamics.motion import attitude
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, RunFacts
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.signals import COMMAND, SITUATION, TELEMETRY

SAID = SITUATION.name
BACK_RAD = 0.005                        # by which an alarm's reading must be inside its limit again
CONE_M = 8.0                            # length of the cone of view that is drawn
OVER = np.array([1.0, 0.0, 0.0, 0.0])   # half a turn about x: from nadir to up


def seen(vector: ArrayLike) -> NDArray[np.float64]:
    """Return vectors (..., 3) of the inertial frame of the start in the axes of the scene."""
    return np.asarray(vector, dtype=float)*np.array([1.0, -1.0, -1.0])


def seen_turn(q: ArrayLike) -> NDArray[np.float64]:
    """Return an attitude in the axes of the scene, of a body whose shape is `seen`."""
    return attitude.multiply(attitude.multiply(OVER, np.asarray(q, dtype=float)),
                             attitude.conjugate(OVER))


class TetherDisplay(MissionDisplay):
    """The approach on the console."""

    heard_nodes = ('mission_control', 'console')
    derives_from = (SAID,)

    def __init__(self, facts: RunFacts, preparation: Preparation) -> None:
        self._half = preparation.approach.view_rad
        super().__init__(facts, _display(facts, preparation))

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return gripper, target, tether, sight, and the edges of the field of view."""
        said = newest.get(SAID)
        if said is None or not said.ok or not np.isfinite(said.parts['gripper']).all():
            return dict.fromkeys(('gripper', 'target', 'turn', 'tether', 'sight', 'cone', 'spot',
                                  'margin'))
        there, target, q = (np.array(said.parts[n]) for n in ('gripper', 'target', 'attitude'))
        gripper, ahead = seen(there).tolist(), seen(target).tolist()
        sight = attitude.rotate_back(q, target - there)
        angle = float(np.arctan2(np.hypot(sight[1], sight[2]), sight[0]))
        across = sight[1:]/max(float(np.hypot(sight[1], sight[2])), 1e-12)
        left = self._half - angle
        return {'gripper': gripper, 'target': ahead, 'turn': seen_turn(q).tolist(),
                'tether': [[0.0, 0.0, 0.0], gripper], 'sight': [gripper, ahead],
                'cone': self._cone(there, q),
                'spot': seen([0.0, *(angle*across)]).tolist(),
                'margin': [f'{left:.2f} rad', left < 0.0]}

    def beside(self, shown: Mapping[str, Mapping[str, Any]], truth: Mapping[str, Any]
               ) -> dict[str, Any]:
        """Return where the gripper truly is, and the tether to it."""
        state = np.array(truth['state'])
        gripper = seen(state[:3]).tolist()
        return {'gripper': gripper, 'turn': seen_turn(state[6:10]).tolist(),
                'tether': [[0.0, 0.0, 0.0], gripper]}

    def _cone(self, tip: NDArray, q: NDArray) -> list[list[float]]:
        """Return one line that draws four edges and the rim of the field of view."""
        turn = np.linspace(0.0, 2.0*np.pi, 25)
        rim = CONE_M*np.stack([np.full(25, np.cos(self._half)), np.sin(self._half)*np.cos(turn),
                               np.sin(self._half)*np.sin(turn)], axis=-1)
        points = tip + attitude.rotate(np.broadcast_to(q, (25, 4)), rim)
        rows = []
        for i, point in enumerate(points):
            rows += [tip, point] if i % 6 == 0 else []
            rows.append(point)
        return seen(rows).tolist()


def _display(facts: RunFacts, preparation: Preparation) -> Display:
    p, approach = preparation, preparation.approach
    way = seen(p.plan.state_at(np.linspace(p.plan.begin_s, p.plan.end_s, 101))[:, :3])
    force, torque = p.gripper.max_force_n, p.gripper.max_torque_n_m

    def shown(label: str, unit: str, part: str, index: tuple = (0,), digits: int = 2,
              high: float | None = None, factor: float = 1.0, true: Number | None = None
              ) -> Instrument:
        beside = () if true is None else (Reading('truth', true),)
        return Instrument(label, unit, (
            *beside, Reading('measured', Number(SAID, part, index, factor), None, high)), digits)

    def errors(title: str, index: tuple[int, ...], names: tuple[str, ...], least: float) -> Chart:
        return Chart(title, tuple(Number(SAID, 'error', (i,), 1000.0) for i in index), names=names,
                     least=least)
    return Display(
        measured=TELEMETRY.name, link=facts.forward_steps + facts.back_steps > 0,
        bodies=(Body('platform', 'plain', (Box((3.0, 2.0, 2.0)), Box((0.1, 1.5, 8.0))),
                     label='platform'),
                Body('gripper', 'measured', (
                    Box((0.8, 0.6, 0.6)), Cylinder(0.12, 0.8, centre_m=(0.7, 0.0, 0.0))),
                    Ref(DERIVED, 'gripper'), attitude=Ref(DERIVED, 'turn'), label='gripper'),
                Body('truth', 'truth', (Box((0.8, 0.6, 0.6)),), Ref(TRUTH, 'gripper'),
                     attitude=Ref(TRUTH, 'turn')),
                Body('target', 'target', (Box((2.5, 2.0, 2.0)), Box((0.1, 1.2, 9.0))),
                     Ref(DERIVED, 'target'), label='target')),
        lines=(Line('tether', 'measured', Ref(DERIVED, 'tether')),
               Line('sight', 'goal', Ref(DERIVED, 'sight'), dashed=True),
               Line('view', 'limit', Ref(DERIVED, 'cone')),
               Line('plan', 'plain', tuple(map(tuple, way.tolist())), dashed=True),
               Trail('way', 'measured', Ref(DERIVED, 'gripper')),
               Trail('true_way', 'truth', Ref(TRUTH, 'gripper'))),
        labels=tuple(Label(f'{x} m', (float(x), -6.0, 0.0)) for x in (25, 50, 75)),
        legend=(Legend('measured', 'tether, way'),
                Legend('plain', 'plan', dashed=True), Legend('limit', 'field of view'),
                Legend('goal', 'sight', dashed=True)),
        views=(Perspective('Approach', centre_m=(52.0, 0.0, 0.0), distance_m=150.0,
                           azimuth_rad=1.75, height_rad=0.3),
               Perspective('Gripper', distance_m=14.0, follow=('gripper',), share=1.0, growth=0.0),
               Flat('Orbit plane', '+x', '+y', (50.0, 0.0, 0.0), 120.0),
               Flat('Above', '+x', '-z', (50.0, 0.0, 0.0), 120.0)),
        instruments=Instruments('Approach', (
            shown('range (plan)', 'm', 'range', true=Number(TRUTH, 'target', (0, 1, 2))),
            shown('tension', 'N', 'tension', digits=3, true=Number(TRUTH, 'tension')),
            shown('sight angle', 'rad', 'sight_angle', digits=3, high=approach.view_rad),
            shown('length error', 'mm', 'error', (0,), 1, factor=1000.0),
            shown('bearing \u03b1', 'mrad', 'error', (1,), factor=1000.0),
            shown('bearing \u03b2', 'mrad', 'error', (2,), factor=1000.0),
            shown('roll error', 'mrad', 'error', (3,), factor=1000.0),
            shown('pitch error', 'mrad', 'error', (4,), factor=1000.0),
            shown('yaw error', 'mrad', 'error', (5,), factor=1000.0))),
        section=Section(
            'Target in the field of view', 'Direction of the target from the boresight, with the '
            'field of view', 1.1*approach.view_rad, right='+z', up='+y',
            names=('\u2212z', '\u2212y'),
            rings=(Ring('limit', approach.view_rad),
                   Ring('goal', approach.angle_limit, dashed=True)),
            spots=(Spot('measured', Ref(DERIVED, 'spot')),),
            foot=Readout('left to its edge', Ref(DERIVED, 'margin'))),
        commands=Commands(
            'Planned inputs, N and N m', (
                CommandAxis('tension', p.tether.most_n),
                *(CommandAxis(name, force) for name in ('along', 'in plane', 'across')),
                *(CommandAxis(name, torque) for name in ('roll', 'pitch', 'yaw'))),
            COMMAND.name, (CommandRow('plan', 'sent', Ref(COMMAND.name, 'value')),), digits=3),
        charts=Charts('Course', (
            Chart('sight, rad', (Number(SAID, 'sight_angle'),), least=0.05, centred=False,
                  levels=(0.0, approach.view_rad)),
            Chart('tension, N', (Number(SAID, 'tension'),), least=0.5, centred=False,
                  levels=(0.0,)),
            errors('length, mm', (0,), (), 1.0),
            errors('error, mrad', (1, 2), ('bearing \u03b1, in plane', '\u03b2, across'), 0.05),
            errors('error, mrad ', (3, 4, 5), ('roll', 'pitch', 'yaw'), 0.5)), window_s=100.0),
        alarms=(Alarm('TARGET OUT OF VIEW', (
            Reading('measured', Number(SAID, 'sight_angle'), high=approach.view_rad),),
            'sight angle', 'rad', 3, BACK_RAD),),
        modes=(), abort='braking by the tether', goal='arriving before the target')
