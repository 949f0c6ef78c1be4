"""
Settings of the ground nodes that pick a part from a table or a file.
"""

from rvd_dynamics.diagram.params import choice, param, settings
from rvd_groundstation.guidance import LAWS
from rvd_groundstation.sharing import SHARING

ControllerParams = choice('ControllerParams', 'law', LAWS, 'corridor_apf',
                          'Guidance law of the automatic controller.')
BlenderParams = choice('BlenderParams', 'sharing', SHARING, 'eq25',
                       'Rule that combines the levels of pilot and automatic controller.')


@settings
class ReplayParams:
    """Settings of `joystick_replay`."""

    tape: str = param(
        '', 'Tape to replay: a CSV file, a rosbag2 folder or one file of it (.mcap or .db3, also '
        'with .zstd).')
    tape_topic: str = param('/joy', 'Topic of the bag to replay, of sensor_msgs/msg/Joy.')
