"""
What the console draws: platform, tether, gripper and target, from what came down the link.

Frame   inertial frame of the start, from the platform. The range is the planned one, since nothing
        measures it; direction, attitude and length are measured.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from rvd_dynamics.diagram.display import (
    Body, Box, Chart, Charts, CommandAxis, CommandRow, Commands, Cylinder, DERIVED, Display, Flat,
    Instrument, Instruments, Legend, Line, Number, Perspective, Reading, Ref, Trail)
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, RunFacts
from rvd_missions.tether.optimum import Preparation
from rvd_missions.tether.signals import COMMAND, SITUATION, TELEMETRY

SAID = SITUATION.name
CONE_M = 8.0                            # length of the cone of view that is drawn


class TetherDisplay(MissionDisplay):
    """The approach on the console."""

    heard_nodes = ('mission_control', 'console')
    derives_from = (SAID,)

    def __init__(self, facts: RunFacts, preparation: Preparation) -> None:
        self._half = preparation.approach.view_rad
        super().__init__(facts, _display(preparation))

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return tether, line of sight and the edges of the field of view, as rows of points."""
        made: dict[str, Any] = dict.fromkeys(('tether', 'sight', 'cone'))
        said = newest.get(SAID)
        if said is None or not said.ok or not np.isfinite(said.parts['gripper']).all():
            return made
        gripper, target = (list(map(float, said.parts[n])) for n in ('gripper', 'target'))
        made['tether'] = [[0.0, 0.0, 0.0], gripper]
        made['sight'] = [gripper, target]
        made['cone'] = self._cone(np.array(gripper), np.array(said.parts['attitude']))
        return made

    def _cone(self, tip: np.ndarray, attitude: np.ndarray) -> list[list[float]]:
        """Return one line that draws four edges and the rim of the field of view."""
        from rvd_missions.tether.geometry import to_inertial
        turn = np.linspace(0.0, 2.0*np.pi, 25)
        rim = CONE_M*np.stack([np.full(25, np.cos(self._half)), np.sin(self._half)*np.cos(turn),
                               np.sin(self._half)*np.sin(turn)], axis=-1)
        points = tip + to_inertial(np.broadcast_to(attitude, (25, 4)), rim)
        rows = []
        for i, point in enumerate(points):
            rows += [tip, point] if i % 6 == 0 else []
            rows.append(point)
        return np.array(rows).tolist()


def _display(preparation: Preparation) -> Display:
    p, approach = preparation, preparation.approach
    way = p.plan.state_at(np.linspace(p.plan.begin_s, p.plan.end_s, 101))[:, :3]

    def shown(label: str, unit: str, part: str, index: tuple = (0,), digits: int = 2,
              high: float | None = None, factor: float = 1.0) -> Instrument:
        low = None if high is None else -high
        return Instrument(label, unit, (
            Reading('measured', Number(SAID, part, index, factor), low, high),), digits)
    limit = approach.angle_limit
    return Display(
        measured=TELEMETRY.name,
        bodies=(Body('platform', 'plain', (Box((3.0, 2.0, 2.0)), Box((0.1, 8.0, 1.5)))),
                Body('gripper', 'measured', (
                    Box((0.8, 0.6, 0.6)), Cylinder(0.12, 0.8, centre_m=(0.7, 0.0, 0.0))),
                    Ref(SAID, 'gripper'), attitude=Ref(SAID, 'attitude'), label='gripper'),
                Body('target', 'target', (Box((2.5, 2.0, 2.0)), Box((0.1, 1.2, 9.0))),
                     Ref(SAID, 'target'), label='target')),
        lines=(Line('tether', 'measured', Ref(DERIVED, 'tether')),
               Line('sight', 'goal', Ref(DERIVED, 'sight'), dashed=True),
               Line('view', 'limit', Ref(DERIVED, 'cone')),
               Line('plan', 'plain', tuple(map(tuple, way.tolist())), dashed=True),
               Trail('way', 'measured', Ref(SAID, 'gripper'))),
        legend=(Legend('measured', 'tether and way'), Legend('plain', 'plan', dashed=True),
                Legend('limit', 'field of view')),
        views=(Perspective('Approach', centre_m=(50.0, 0.0, 0.0), distance_m=90.0),
               Perspective('Gripper', distance_m=12.0, follow=('gripper',)),
               Flat('In the orbit plane', '+x', '-y', (50.0, 0.0, 0.0), 120.0)),
        instruments=Instruments('Approach', (
            shown('planned range', 'm', 'range'),
            shown('tension', 'N', 'tension', digits=3),
            shown('sight angle', 'rad', 'sight_angle', digits=3, high=approach.view_rad),
            shown('length error', 'mm', 'error', (0,), 1, factor=1000.0),
            shown('bearing error, in plane', 'mrad', 'error', (1,), 2, factor=1000.0),
            shown('bearing error, out of plane', 'mrad', 'error', (2,), 2, factor=1000.0),
            shown('pitch error', 'mrad', 'error', (4,), 2, factor=1000.0),
            shown('yaw error', 'mrad', 'error', (5,), 2, factor=1000.0))),
        commands=Commands(
            'Planned inputs', tuple(CommandAxis(name, most) for name, most in (
                ('T', p.tether.most_n), *((f'F{a}', p.gripper.max_force_n) for a in 'lab'))),
            COMMAND.name, (CommandRow('plan', 'sent', Ref(COMMAND.name, 'value')),), digits=3,
            unit='N'),
        charts=Charts('Course', (
            Chart('sight angle, rad', (Number(SAID, 'sight_angle'),), least=limit),
            Chart('tension, N', (Number(SAID, 'tension'),), least=1.0)), window_s=100.0),
        modes=(), abort='braking by the tether', goal='arriving before the target')
