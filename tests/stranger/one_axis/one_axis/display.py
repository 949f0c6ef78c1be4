"""
What the console draws: a box on a line, two instruments, the command that is sent.
"""

from rvd_dynamics.diagram.display import (
    Body, Box, CommandAxis, CommandRow, Commands, Display, Instrument, Instruments, Line, Number,
    Perspective, Reading, Ref)

from one_axis.berth import Berth
from one_axis.commands import ThrusterParams
from one_axis.signals import COMMAND, TELEMETRY


def display(berth: Berth, thruster: ThrusterParams) -> Display:
    """Return the display of a run."""
    craft = Ref(TELEMETRY.name, 'state')
    return Display(
        measured=TELEMETRY.name,
        bodies=(Body('craft', 'measured', (Box((1.0, 0.6, 0.6)),), craft, axes='x',
                     label='craft'),),
        lines=(Line('track', 'plain', ((-12.0, -0.3, 0.0), (2.0, -0.3, 0.0))),
               Line('stop', 'limit', ((berth.max_overshoot_m, -0.8, 0.0),
                                      (berth.max_overshoot_m, 0.8, 0.0)))),
        views=(Perspective('Track', centre_m=(-5.0, 0.0, 0.0), distance_m=16.0),),
        stars=False,
        instruments=Instruments('Craft', (
            Instrument('position', 'm', (Reading('measured', Number(TELEMETRY.name, 'state', (0,)),
                                                 high=berth.max_overshoot_m),)),
            Instrument('speed', 'mm/s', (Reading('measured', Number(
                TELEMETRY.name, 'state', (1,), factor=1000.0)),), digits=0))),
        commands=Commands(
            'Thrust', (CommandAxis('x', thruster.steps * thruster.step_m_s2),), COMMAND.name,
            (CommandRow('sent', 'sent', Ref(COMMAND.name, 'value')),), digits=3, unit='m/s^2'),
        modes=(), abort='backing away', goal='coming to rest at the berth')
