"""
Sticks: a stepped pilot's levels as `sensor_msgs/Joy`, and a held stick of which the newest counts.
"""

import time

from sensor_msgs.msg import Joy

from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.ros.conversions import header_at

HELD_FOR_S = 0.5                # [s] wall time after which a held stick is no pilot


class HeldStick:
    """The newest message of a stick that sends when it likes, by the wall clock."""

    def __init__(self) -> None:
        self._newest: tuple[float, Joy] | None = None

    def take(self, joy: Joy) -> None:
        """Keep `joy`; it came now."""
        self._newest = (time.monotonic(), joy)

    def newest(self) -> Joy | None:
        """Return the newest message, None when there is none or it is too old."""
        if self._newest is None or time.monotonic() - self._newest[0] > HELD_FOR_S:
            return None
        return self._newest[1]


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
