"""
One axis: a craft comes to rest at a berth, steered from afar through a delay.

This object is light. What costs time to import, or must not be seen by everybody, is named as
text and loaded by the process that needs it.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

MISSION = Mission(
    name='one_axis',
    title='A craft comes to rest at a berth on one axis, steered through a delay.',
    shared=(
        Shared('leg_params', 'rvd_dynamics.diagram.run:LegParams'),
        Shared('thruster', 'one_axis.commands:ThrusterParams', 'thruster.'),
        Shared('berth', 'one_axis.berth:Berth', 'berth.'),
    ),
    sections={
        'plant': 'one_axis.space:PlantParams',
        'sensor': 'one_axis.space:SensorParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'controller': 'one_axis.ground:ControllerParams',
    },
    parts={
        'legs': 'rvd_dynamics.diagram.run:legs',
        'form': 'one_axis.commands:form',
    },
    checked=('legs',),
    diagram='one_axis.diagram:diagram',
    judge='one_axis.judge:Judge',
    figures='one_axis.figures:FIGURES',
    display='one_axis.display:display',
)
