"""
A stepped pilot's levels as the `sensor_msgs/Joy` that a real stick would send.
"""

from sensor_msgs.msg import Joy

from rvd_dynamics.mission import Mission
from rvd_dynamics.ros.conversions import header_at


def joy_of_levels(levels: list[int], step: int, mission: Mission) -> Joy:
    """Return the Joy whose levels are `levels`, dead-man button held."""
    stick = mission.stick
    axes = [0.0] * (1 + max(stick.axis_x, stick.axis_y, stick.axis_z))
    axes[stick.axis_x] = stick.sign_x * levels[0] / 3
    axes[stick.axis_y] = stick.sign_y * levels[1] / 3
    axes[stick.axis_z] = stick.sign_z * levels[2] / 3
    buttons = [0] * (stick.deadman_button + 1)
    if buttons:
        buttons[-1] = 1
    return Joy(header=header_at(step * mission.step_ns, 'joy'), axes=axes, buttons=buttons)
