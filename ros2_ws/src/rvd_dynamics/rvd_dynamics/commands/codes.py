"""
The constants of `rvd_interfaces/msg/ThrustCommand.msg` as plain integers.

Pure modules (blender, guard, links, in-process loop) use these names and need no ROS; a test
holds them equal to the message's. Their meaning is documented in the message, and only there.
"""

KIND_THRUST = 0
KIND_HOLD = 1
KIND_RETREAT = 2
KIND_ABORT = 3
KIND_RESUME = 4

BY_NOBODY = 0
BY_PILOT = 1
BY_AUTO = 2
BY_BLEND = 3
BY_GUARD = 4

REASON_NONE = 0
REASON_EMPTY = 1
REASON_LENGTH = 2
REASON_CHECKSUM = 3
REASON_ORDER = 4
REASON_AGE = 5
REASON_RANGE = 6
REASON_MISSING = 7
REASON_MODE = 8
REASON_PILOT_INVALID = 9
REASON_AUTO_INVALID = 10
REASON_BOTH_INVALID = 11
REASON_ABORT = 12
