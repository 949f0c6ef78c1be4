"""
Tether: a gripper released on a tether flies to a target that does not help, and stops before it.

Source  Hu Yongxin, Huang Panfeng, Meng Zhongjie, Liu Zhengxiong, Zhang Yizhai, Dong Gangqi; the
        equations and Table 1 are lost in the text at hand. `diagram` has the data flow.
"""

from rvd_dynamics.diagram.mission import Mission, Shared

HERE = 'rvd_missions.tether'

MISSION = Mission(
    name='tether',
    title='A gripper on a tether flies from a platform to 20 m from a target, by an optimal plan.',
    shared=(
        Shared('leg_params', f'{HERE}.settings:LegParams'),
        Shared('orbit', f'{HERE}.settings:OrbitParams', 'orbit.'),
        Shared('gripper', f'{HERE}.settings:GripperParams', 'gripper.'),
        Shared('tether', f'{HERE}.settings:TetherParams', 'tether.'),
        Shared('approach', f'{HERE}.settings:ApproachParams', 'approach.'),
        Shared('arrival', f'{HERE}.settings:ArrivalParams', 'arrival.'),
        Shared('planner', f'{HERE}.optimum:PlannerParams', 'planner.'),
        Shared('inputs', f'{HERE}.inputs:InputParams', 'inputs.'),
    ),
    sections={
        'gripper_dynamics': f'{HERE}.space:DynamicsParams',
        'gripper_sensors': f'{HERE}.space:SensorParams',
        'gripper_tracker': f'{HERE}.onboard:TrackerParams',
        'link_back': 'rvd_dynamics.link.models:LinkParams',
        'link_forward': 'rvd_dynamics.link.models:LinkParams',
        'onboard_guard': 'rvd_dynamics.commands.abort:GuardParams',
    },
    parts={
        'legs': f'{HERE}.settings:legs',
        'form': f'{HERE}.commands:form',
        'preparation': f'{HERE}.optimum:Preparation',
        'checked': f'{HERE}.settings:checked',
    },
    checked=('checked', 'legs'),
    diagram=f'{HERE}.diagram:diagram',
    judge=f'{HERE}.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    display=f'{HERE}.display:TetherDisplay',
)
