"""
Lunar approach: a pilot on Earth docks a chaser in lunar orbit through a link of seconds.

The reference system: Zhang, Li, Tang, J. Astronautics 35(3), 2014. `diagram` has the data flow.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

HERE = 'rvd_missions.lunar_approach'

MISSION = Mission(
    name='lunar_approach',
    title='A pilot on Earth docks a chaser in lunar orbit through a delay of seconds.',
    shared=(
        Shared('operation', 'rvd_groundstation.operators.operation:Operation'),
        Shared('leg_params', 'rvd_dynamics.diagram.run:LegParams'),
        Shared('orbit', 'rvd_dynamics.motion.orbit:OrbitParams', 'orbit.'),
        Shared('start', 'rvd_dynamics.motion.orbit:StartParams', 'start.'),
        Shared('cone', 'rvd_dynamics.geometry.cone:Cone', 'corridor.'),
        Shared('obstacles', f'{HERE}.settings:Obstacles', 'obstacles.'),
        Shared('measured', f'{HERE}.settings:Measured', 'measured.'),
        Shared('docking', f'{HERE}.settings:DockingParams', 'docking.'),
        Shared('thrust', 'rvd_dynamics.commands.levels:ThrustParams', 'thrust.'),
        Shared('stick', 'rvd_dynamics.commands.levels:StickParams', 'stick.'),
    ),
    sections={
        'spacecraft_dynamics': 'rvd_dynamics.world.settings:DynamicsParams',
        'relative_sensor': 'rvd_dynamics.world.settings:SensorParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'state_predictor': 'rvd_groundstation.prediction.predictor:PredictorParams',
        'auto_controller': 'rvd_groundstation.settings:ControllerParams',
        'command_blender': 'rvd_groundstation.settings:BlenderParams',
        'operator_model': 'rvd_groundstation.operators.pilot:OperatorParams',
        'joystick': 'rvd_groundstation.joystick.params:JoystickParams',
        'joystick_replay': 'rvd_groundstation.settings:ReplayParams',
    },
    parts={
        'legs': 'rvd_dynamics.diagram.run:legs',
        'form': f'{HERE}.settings:form',
        'paced': f'{HERE}.settings:paced',
        'stop': f'{HERE}.settings:stop',
        'clear_start': f'{HERE}.settings:clear_start',
        'sharing': f'{HERE}.ground:sharing',
        'law': f'{HERE}.ground:law',
        'pilot': f'{HERE}.ground:pilot',
        'approach_rate_m_s': f'{HERE}.ground:approach_rate_m_s',
        'abort_profile': 'rvd_groundstation.prediction.abort:profile',
        'start_scatter': f'{HERE}.ground:start_scatter',
        'tape': f'{HERE}.ground:tape',
    },
    checked=('paced', 'legs', 'clear_start'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    columns=f'{HERE}.columns:ORDER',
    column_measures=f'{HERE}.columns:MEASURES',
    figures=f'{HERE}.figures:FIGURES',
    campaign_figures=f'{HERE}.campaign_figures:FIGURES',
    campaign_notes=f'{HERE}.campaigns:notes',
    short_words={'pilot': f'{HERE}.campaigns:pilot'},
    display=f'{HERE}.display:LunarDisplay',
    scene=f'{HERE}.scene:scene',
    usual_steps=f'{HERE}.settings:usual_steps',
    modes=('manual', 'shared', 'auto'),
    markers=True,
)
