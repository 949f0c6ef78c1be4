"""
Docking: a chaser with panels and tanks comes from 3 m to hover 7 cm before the port of its target.

Source  An Hao, Qu Zhenshen, Wang Changhong, J. System Simulation 27(6), 2015, pp. 1227-1234.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

HERE = 'rvd_missions.docking'
SETTINGS = f'{HERE}.settings'

MISSION = Mission(
    name='docking',
    title='A chaser with panels and sloshing tanks hovers 7 cm before the port of its target.',
    shared=(
        Shared('run', f'{SETTINGS}:Run'),
        Shared('orbit', f'{SETTINGS}:OrbitParams', 'orbit.'),
        Shared('chaser', f'{SETTINGS}:Chaser', 'chaser.'),
        Shared('panels', f'{SETTINGS}:Panels', 'panels.'),
        Shared('tanks', f'{SETTINGS}:Tanks', 'tanks.'),
        Shared('start', f'{SETTINGS}:Start', 'start.'),
        Shared('aim', f'{SETTINGS}:Aim', 'aim.'),
        Shared('limits', f'{SETTINGS}:Limits', 'limits.'),
        Shared('seeing', f'{SETTINGS}:Seeing', 'seeing.'),
        Shared('scatter', f'{HERE}.scatter:Scatter', 'scatter.'),
        Shared('camera', 'rvd_dynamics.geometry.pinhole:CameraParams', 'camera.'),
        Shared('planner', f'{HERE}.planning:PlannerParams'),
        Shared('closing', f'{HERE}.planning:ClosingTask', 'closing.'),
        Shared('stereo', f'{HERE}.stereo_signals:StereoParams', 'stereo.'),
        Shared('rendering', 'rvd_dynamics.geometry.markers:RenderingParams', 'rendering.'),
        Shared('thruster', 'rvd_dynamics.world.spacecraft.reaction_control:ThrusterParams',
               'thruster.'),
        Shared('operation', f'{HERE}.hand_settings:Steering'),
        Shared('leg_params', f'{HERE}.hand_settings:LinkDelay'),
        Shared('hand', 'rvd_dynamics.commands.hand:HandParams', 'hand.'),
    ),
    sections={
        'docking_dynamics': f'{HERE}.space:DynamicsParams',
        'inertial_unit': 'rvd_dynamics.world.sensors.inertial:InertialParams',
        'camera': f'{HERE}.space:SeeingParams',
        'vision': 'rvd_dynamics.onboard.navigation.vision:VisionParams',
        'docking_navigation': 'rvd_dynamics.onboard.navigation.filters:FilterParams',
        'docking_controller': f'{HERE}.onboard:ControllerParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'hand_predictor': 'rvd_groundstation.prediction.six_dof:SixDofParams',
        'hand_pilot': 'rvd_groundstation.operators.hand_pilot:HandPilotParams',
        'joystick_replay': 'rvd_groundstation.settings:ReplayParams',
        'standard_messages': f'{HERE}.standard:StandardParams',
    },
    parts={
        'craft': f'{HERE}.space:spacecraft',
        'form': f'{HERE}.commands:form',
        'period': f'{SETTINGS}:period',
        'late': f'{SETTINGS}:late',
        'timed': f'{SETTINGS}:timed',
        'legs': 'rvd_dynamics.diagram.run:legs',
        'hand_form': f'{HERE}.hand_settings:hand_form',
        'steered': f'{HERE}.hand_settings:steered',
        'tape': f'{HERE}.ground:tape',
        'frames': f'{HERE}.standard:frames',
        'still_frames': f'{HERE}.standard:still_frames',
        'craft_model': f'{HERE}.hand_prediction:craft_model',
        'cameras': f'{HERE}.stereo_signals:cameras',
        'marker_radii': f'{HERE}.stereo_signals:radii',
        'preparation': f'{HERE}.planning:planned',
    },
    checked=('timed', 'period', 'late', 'legs', 'steered', 'preparation'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    display=f'{HERE}.display_remote:display',
    campaign_figures=f'{HERE}.campaign_figures:FIGURES',
)
