"""
Attitude hold: one axis of a satellite is held by a law that meets soft faults of its gains.

Source  Xie Yongchun, He Yingzi, Wu Hongxin: adaptive passive fault-tolerant control based on
        characteristic extraction; only fragments are at hand. `diagram` has the data flow.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

HERE = 'rvd_missions.attitude_hold'

MISSION = Mission(
    name='attitude_hold',
    title='One axis of a satellite is held through gain faults of actuator and sensors.',
    shared=(
        Shared('placement', f'{HERE}.settings:Placement'),
        Shared('leg_params', f'{HERE}.settings:LegParams'),
        Shared('craft', f'{HERE}.settings:Craft', 'craft.'),
        Shared('torque', f'{HERE}.commands:TorqueParams', 'torque.'),
        Shared('attitude', f'{HERE}.settings:Attitude', 'attitude.'),
        Shared('faults', f'{HERE}.settings:Faults', 'faults.'),
        Shared('limits', f'{HERE}.settings:Limits', 'limits.'),
    ),
    sections={
        'attitude_dynamics': f'{HERE}.space:DynamicsParams',
        'attitude_sensors': f'{HERE}.space:SensorParams',
        'attitude_controller': f'{HERE}.control:ControllerParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
    },
    parts={
        'legs': f'{HERE}.settings:legs',
        'form': f'{HERE}.commands:form',
        'timed': f'{HERE}.settings:timed',
    },
    checked=('timed', 'legs'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    campaign_figures=f'{HERE}.campaign_figures:FIGURES',
    display=f'{HERE}.display:AttitudeDisplay',
)
