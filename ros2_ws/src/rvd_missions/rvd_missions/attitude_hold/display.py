"""
What the console draws of an axis: the craft turned by its attitude, a needle that shows it larger,
numbers, the torque, and the error over time.

The axis is +x, towards whoever looks; angles turn from +y to +z. Only a law on the ground has a
console: of one on board nothing comes down.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import (
    Body, Box, Chart, Charts, CommandAxis, CommandRow, Commands, DERIVED, Display, Flat, Instrument,
    Instruments, Label, Legend, Line, Number, Perspective, Reading, Ref)
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, RunFacts
from rvd_missions.attitude_hold import signals
from rvd_missions.attitude_hold.commands import TorqueParams
from rvd_missions.attitude_hold.settings import Limits, Placement

TELEMETRY, LAW, COMMAND = (s.name for s in (signals.TELEMETRY, signals.LAW, signals.COMMAND))
DEG = float(np.degrees(1.0))                    # [deg/rad]
LARGER = 40.0                                   # the needle turns by this times the attitude
NEEDLE_M = 2.2
HULL, CELLS = '#d5dbe2', '#27508a'


class AttitudeDisplay(MissionDisplay):
    """An axis on the console."""

    heard_nodes = ('attitude_controller', 'console')

    def __init__(self, facts: RunFacts, placement: Placement, limits: Limits,
                 torque: TorqueParams) -> None:
        if placement.law_runs != 'ground':
            raise BadInput('law_runs must be ground for a console, got onboard: nothing comes down '
                           'of a law on board')
        super().__init__(facts, _display(limits, torque))

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return the attitude as a quaternion, and the two needles as pairs of points."""
        measured, law = newest.get(TELEMETRY), newest.get(LAW)
        made: dict[str, Any] = {'attitude': None, 'needle': None, 'wanted': None}
        if measured is not None and measured.ok:
            angle = float(measured.parts['state'][0])
            made['attitude'] = [float(np.sin(angle/2)), 0.0, 0.0, float(np.cos(angle/2))]
            made['needle'] = needle(angle)
        if law is not None and law.ok and np.isfinite(law.parts['reference']):
            made['wanted'] = needle(float(law.parts['reference']))
        return made


def needle(angle: float) -> list[list[float]]:
    """Return two points [m]: the origin, and where a needle at LARGER times an angle [rad] ends."""
    turned = LARGER*angle
    return [[0.0, 0.0, 0.0],
            [0.0, NEEDLE_M*float(np.cos(turned)), NEEDLE_M*float(np.sin(turned))]]


def _display(limits: Limits, torque: TorqueParams) -> Display:
    def row(label: str, unit: str, number: Number, digits: int, limit: float | None = None
            ) -> Instrument:
        low = None if limit is None else -limit
        return Instrument(label, unit, (Reading('measured', number, low, limit),), digits)

    return Display(
        measured=TELEMETRY,
        bodies=(Body('craft', 'measured', (
            Box((1.0, 1.2, 0.8), colour=HULL),
            Box((0.04, 0.6, 2.4), (0.0, 0.0, 2.0), CELLS),
            Box((0.04, 0.6, 2.4), (0.0, 0.0, -2.0), CELLS)),
            attitude=Ref(DERIVED, 'attitude'), label='measured'),),
        lines=(Line('needle', 'measured', Ref(DERIVED, 'needle')),
               Line('reference', 'goal', Ref(DERIVED, 'wanted'), dashed=True),
               Line('zero', 'plain', ((0.0, 0.0, 0.0), (0.0, NEEDLE_M, 0.0)))),
        labels=(Label(f'needles \u00d7{LARGER:.0f}', (0.0, NEEDLE_M, -0.4)),),
        legend=(Legend('measured', f'measured attitude, \u00d7{LARGER:.0f}'),
                Legend('goal', 'reference', dashed=True)),
        views=(Perspective('Craft', distance_m=10.0),
               Flat('Along the axis', '+y', '+z', (0.0, 0.8, 0.0), 9.0)),
        instruments=Instruments('Attitude', (
            row('attitude', 'deg', Number(TELEMETRY, 'state', (0,), DEG), 4),
            row('rate', 'deg/s', Number(TELEMETRY, 'state', (1,), DEG), 4),
            row('error', 'deg', Number(LAW, 'error', factor=DEG), 4, limits.settled_deg),
            row('reference', 'deg', Number(LAW, 'reference', factor=DEG), 2))),
        commands=Commands(
            'Torque', (CommandAxis('x', torque.max_n_m),), COMMAND,
            (CommandRow('sent', 'sent', Ref(COMMAND, 'value')),), digits=4, unit='N m'),
        charts=Charts('Error', (
            Chart('error, deg', (Number(LAW, 'error', factor=DEG),), least=limits.max_rms_deg),)),
        modes=(), abort='coasting without torque', goal='holding the reference')
