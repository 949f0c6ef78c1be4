"""
Layouts of common pads and sticks: where a driver's `sensor_msgs/Joy` has the axes and the dead-man.

Axes are positive forwards, to the left and up, as `joy_node` and our `joystick` send them. Only
axes that spring back to the middle are used: a throttle lever or a trigger rests at full thrust.

Sources
    xbox                wiki.ros.org/joy, table of the Xbox 360 pad under Linux: 0 and 1 left stick,
                        2 LT, 3 and 4 right stick, 5 RT; button 4 LB. These are StickParams'
                        defaults.
    ps4, ps5            The Linux drivers hid-sony and hid-playstation (ABS_X, ABS_Y, ABS_Z for L2,
                        ABS_RX, ABS_RY, ABS_RZ for R2; BTN_TL is the fifth button):
                        the same as xbox, with L1. For a DualShock 4 also
                        Rogiken-TNK-ROS/rtr_joycon, config/memo.md.
    logitech_f710       F310 and F710 with their switch at D; at X they are an xbox pad.
                        willydlw/fall2021mr, ros/turtlesim/joystick/joystickMapping.md
    logitech_extreme_3d ros-teleop/teleop_twist_joy, config/xd3.config.yaml: 1 and 0 the stick,
                        2 its twist, 3 the throttle; button 0 the trigger. z is the twist.
    spacemouse          ros-drivers/joystick_drivers, spacenav/src/spacenav.cpp: linear x, y, z,
                        then angular x, y, z on /spacenav/joy; button 0 the left one.
    game_controller     docs.ros.org/en/jazzy/p/joy, tables of `game_controller_node`: 0 and 1 left
                        stick, 2 and 3 right stick; button 9 the left shoulder. Any pad.
"""

_PAD = {'axis_x': 1, 'axis_y': 0, 'axis_z': 4, 'deadman_button': 4}
LAYOUTS = {
    'xbox': _PAD,
    'ps4': _PAD,
    'ps5': _PAD,
    'logitech_f710': {**_PAD, 'axis_z': 3},
    'logitech_extreme_3d': {**_PAD, 'axis_z': 2, 'deadman_button': 0},
    'spacemouse': {'axis_x': 0, 'axis_y': 1, 'axis_z': 2, 'deadman_button': 0},
    'game_controller': {**_PAD, 'axis_z': 3, 'deadman_button': 9},
}
