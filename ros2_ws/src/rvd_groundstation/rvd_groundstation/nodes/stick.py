"""
Sticks: a stepped pilot's levels as `sensor_msgs/Joy`, and a held stick of which the newest counts.
"""

import time

from sensor_msgs.msg import Joy

from rvd_dynamics.commands.levels import HIGHEST, stick_axes
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
    axes, buttons = stick_axes([level / HIGHEST for level in levels], True, mission.stick)
    return Joy(header=header_at(step * mission.step_ns, 'joy'), axes=axes, buttons=buttons)
