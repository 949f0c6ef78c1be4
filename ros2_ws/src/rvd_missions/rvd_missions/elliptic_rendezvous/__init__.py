"""
Rendezvous on elliptic orbits by range-rate control: an approach along a corridor, and a fly-around.

Source  Yu Shaohua, Yang Linna, J. Astronautics 1998 no. 3. Its equations are lost in the scan;
        what was derived and what was assumed in their place is in docs/missions.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

HERE = 'rvd_missions.elliptic_rendezvous'

MISSION = Mission(
    name='elliptic_rendezvous',
    title='A chaser approaches a target on an elliptic orbit by range-rate control, to 50 m.',
    shared=(
        Shared('leg_params', 'rvd_dynamics.diagram.run:LegParams'),
        Shared('orbit', 'rvd_dynamics.motion.kepler:EllipseParams', 'orbit.'),
        Shared('start', f'{HERE}.settings:StartParams', 'start.'),
        Shared('arrival', f'{HERE}.settings:ArrivalParams', 'arrival.'),
        Shared('thrust', f'{HERE}.settings:ThrusterParams', 'thrust.'),
        Shared('guidance', f'{HERE}.settings:GuidanceParams', 'guidance.'),
    ),
    sections={
        'spacecraft_dynamics': f'{HERE}.space:PlantParams',
        'relative_sensor': f'{HERE}.space:SensorParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'auto_controller': f'{HERE}.thrust:ThrustParams',
    },
    parts={
        'legs': 'rvd_dynamics.diagram.run:legs',
        'abort_profile': 'rvd_groundstation.prediction.abort:profile',
        'form': 'rvd_dynamics.commands.form:thruster_form',
        'away': f'{HERE}.settings:away',
        'law': f'{HERE}.ground:law',
        'checked': f'{HERE}.settings:checked',
    },
    checked=('checked', 'legs'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    display=f'{HERE}.display:display',
)
