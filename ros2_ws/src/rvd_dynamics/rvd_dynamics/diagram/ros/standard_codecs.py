"""
Codecs of standard messages, for tools that know nothing of ours: RViz, Foxglove, rosbag2 readers.

They are written and never read by a block. Quaternions are (x, y, z, w); a twist is in the axes of
its child frame, as nav_msgs/Odometry has it. Frames are named as REP 105 does: `run.frame_id`, then
`*_base` of each body.
"""

from typing import Any

from nav_msgs.msg import Odometry as OdometryMessage
from sensor_msgs.msg import Imu as ImuMessage

from rvd_dynamics.diagram.ros.codecs import Codec
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.signal import Signal

NO_COVARIANCE = (0.0,)*36               # unknown, by the convention of these messages
BODY = 'chaser_base'


class Odometry(Codec):
    """Pose in the run's frame and twist in the body's axes as `nav_msgs/Odometry`."""

    child = BODY

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = Layout(OdometryMessage, {
            'header.frame_id': run.frame_id, 'child_frame_id': self.child})

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        return self._layout.pack(
            *self.stamp(k), *value.position.tolist(), *value.attitude.tolist(), *NO_COVARIANCE,
            *value.linear.tolist(), *value.angular.tolist(), *NO_COVARIANCE)


class EstimatedOdometry(Odometry):
    """The same, of what the craft believes: a frame of its own."""

    child = f'{BODY}_estimate'


class Imu(Codec):
    """Angular velocity and specific force in the body's axes as `sensor_msgs/Imu`."""

    def __init__(self, signal: Signal, run: Run) -> None:
        super().__init__(signal, run)
        self._layout = Layout(ImuMessage, {'header.frame_id': BODY})

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value; it has no orientation: covariance -1."""
        none = (0.0,)*9
        return self._layout.pack(*self.stamp(k), 0.0, 0.0, 0.0, 1.0, -1.0, *none[1:],
                                 *value.rate.tolist(), *none, *value.force.tolist(), *none)


class Transforms(Codec):
    """Frames, each in another, as `tf2_msgs/TFMessage`; only where tf2_msgs is installed."""

    def __init__(self, signal: Signal, run: Run, frames: tuple) -> None:
        super().__init__(signal, run)
        self._frames = frames

    def encode(self, k: int, value: Any) -> Any:
        """Return the message of a value: translation and rotation of each frame in its parent."""
        from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
        from tf2_msgs.msg import TFMessage
        return TFMessage(transforms=[
            TransformStamped(
                header=header_at(self.stamp_ns(k), parent), child_frame_id=child,
                transform=Transform(translation=Vector3(**dict(zip('xyz', place.tolist()))),
                                    rotation=Quaternion(**dict(zip('xyzw', turn.tolist())))))
            for (parent, child), place, turn in zip(self._frames, value.place, value.turn)])
