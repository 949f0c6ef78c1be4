"""
Obstacle field: a chaser comes to a target past static or moving obstacles.

The reference system: Xu, Zhang, Chinese J. Theor. Appl. Mech. 52(6). `diagram` has the data flow.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

NAME = 'obstacle_field'
HERE = f'rvd_missions.{NAME}'

MISSION = Mission(
    name=NAME,
    title='A chaser comes to a target past obstacles, by a potential field with alarms.',
    shared=(
        Shared('leg_params', f'{HERE}.legs:NoDelay'),
        Shared('orbit', f'{HERE}.settings:Orbit', 'orbit.'),
        Shared('start', f'{HERE}.settings:Start', 'start.'),
        Shared('craft', f'{HERE}.settings:Craft', 'craft.'),
        Shared('obstacles', f'{HERE}.settings:Obstacles', 'obstacles.'),
        Shared('thrust', f'{HERE}.settings:ThrusterParams', 'thrust.'),
        Shared('speed_corridor', 'rvd_dynamics.geometry.speed_corridor:SpeedCorridor',
               'speed_corridor.'),
    ),
    sections={
        'spacecraft_dynamics': f'{HERE}.space:DynamicsParams',
        'relative_sensor': f'{HERE}.space:SensorParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'state_predictor': f'{HERE}.navigation:NavigationParams',
        'auto_controller': f'{HERE}.ground:ControllerParams',
    },
    parts={
        'legs': 'rvd_dynamics.diagram.run:legs',
        'abort_profile': 'rvd_groundstation.prediction.abort:profile',
        'form': 'rvd_dynamics.commands.form:thruster_form',
        'away': f'{HERE}.settings:away',
        'law': f'{HERE}.settings:law',
        'contact_m': f'{HERE}.settings:contact_m',
        'reach_m': f'{HERE}.settings:reach_m',
        'clear_start': f'{HERE}.settings:clear_start',
        'navigation': f'{HERE}.navigation:checked',
    },
    checked=('legs', 'form', 'law', 'clear_start', 'navigation'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    campaign_figures=f'{HERE}.campaign_figures:FIGURES',
    display=f'{HERE}.display:FieldDisplay',
    scene=f'{HERE}.display:scene',
    usual_steps=f'{HERE}.settings:usual_steps',
    markers=True,
)
