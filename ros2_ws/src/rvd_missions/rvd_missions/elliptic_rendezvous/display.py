"""
What the console draws of a rendezvous: target and chaser in the orbital plane, far and near.
"""

from math import cos, pi, sin

import numpy as np

from rvd_dynamics.commands.form import CommandForm, part
from rvd_dynamics.diagram.display import (
    Body, Box, Chart, Charts, CommandAxis, CommandRow, Commands, Cylinder, Display, Flat,
    Instrument, Instruments, Label, Line, Number, Reading, Ref, Trail, TRUTH)
from rvd_missions.elliptic_rendezvous.laws import Rrca
from rvd_missions.elliptic_rendezvous.settings import ArrivalParams, StartParams
from rvd_missions.elliptic_rendezvous.signals import COMMAND, GUIDANCE, PREDICTION, TELEMETRY

DEGREES = 180.0/pi
CRAFT = (Box((4.0, 2.5, 2.5)), Cylinder(0.8, 1.0, centre_m=(2.5, 0.0, 0.0)))


def display(start: StartParams, arrival: ArrivalParams, law: Rrca, form: CommandForm
            ) -> Display:
    """Return the display of a run."""
    measured, predicted = Ref(TELEMETRY.name, 'state'), Ref(PREDICTION.name, 'position')
    hold = arrival.range_m
    unit = part(form).unit
    most = 0.1 if unit == 'm/s^2' else float(np.abs(form.quantise(np.full(3, 1e9))).max())

    def seen(label: str, unit: str, part: str, factor: float = 1.0, digits: int = 2) -> Instrument:
        return Instrument(label, unit, (
            Reading('predicted', Number(GUIDANCE.name, part, (0,), factor)),), digits)
    return Display(
        measured=TELEMETRY.name, predicted=PREDICTION.name,
        bodies=(Body('target', 'target', CRAFT, label='target'),
                Body('chaser', 'measured', CRAFT, measured, label='chaser'),
                Body('predicted chaser', 'predicted', CRAFT, predicted),
               Body('true chaser', 'truth', CRAFT, Ref(TRUTH, 'position'), label='truth')),
        lines=(Line('hold', 'goal', _circle(hold), dashed=True),
               Line('far', 'plain', _circle(10.0*hold), dashed=True),
               Trail('way', 'measured', measured), Trail('way ahead', 'predicted', predicted),
               Trail('true way', 'truth', Ref(TRUTH, 'position'))),
        labels=(Label(f'{hold:g} m', (0.0, 1.06*hold, 0.0)),
                Label(f'{10*hold:g} m', (0.0, 10.6*hold, 0.0))),
        views=(Flat('Whole', '+x', '+y', span_m=2.6*start.range_m),
               Flat('Approach', '+x', '+y', span_m=40.0*hold),
               Flat('Near', '+x', '+y', span_m=5.0*hold)),
        instruments=Instruments('Line of sight', (
            seen('range', 'm', 'range'), seen('direction', 'deg', 'direction', DEGREES),
            seen('range rate', 'm/s', 'range_rate', digits=4),
            seen('wanted rate', 'm/s', 'reference_rate', digits=4),
            seen('turning', 'deg/min', 'direction_rate', 60.0*DEGREES),
            seen('along', 'mm/s^2', 'along', 1000.0), seen('across', 'mm/s^2', 'across', 1000.0),
            seen('true anomaly', 'deg', 'anomaly', DEGREES, 1))),
        commands=Commands(
            'Thrust', tuple(CommandAxis(axis, most) for axis in 'xyz'), COMMAND,
            (CommandRow('sent', 'sent', Ref(COMMAND, 'value')),), digits=4, unit=unit),
        charts=Charts('Course', (
            Chart('direction [deg]', (Number(GUIDANCE.name, 'direction', (0,), DEGREES),),
                  least=180.0),
            Chart('range rate [m/s]', (Number(GUIDANCE.name, 'range_rate'),), least=0.1)),
            window_s=3600.0),
        modes=(), abort='coasting',
        goal='flying around at the range held' if law.flies_around else 'arriving near the target')


def _circle(radius: float) -> tuple[tuple[float, float, float], ...]:
    return tuple((radius*sin(2.0*pi*i/72), radius*cos(2.0*pi*i/72), 0.0) for i in range(73))
