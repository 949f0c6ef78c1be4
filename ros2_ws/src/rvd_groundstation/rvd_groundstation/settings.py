"""
Settings of the ground nodes that pick a part from a table or a file.
"""

from dataclasses import dataclass

from rvd_dynamics.diagram.params import choice, param
from rvd_groundstation.guidance import LAWS
from rvd_groundstation.sharing import SHARING

ControllerParams = choice('ControllerParams', 'law', LAWS, 'corridor_apf', 'Guidance law:')
BlenderParams = choice('BlenderParams', 'sharing', SHARING, 'eq25', 'Way of sharing:')


@dataclass(frozen=True)
class ReplayParams:
    """Settings of `joystick_replay`."""

    tape: str = param('', 'CSV file, .mcap file or rosbag2 folder with /joy.')
