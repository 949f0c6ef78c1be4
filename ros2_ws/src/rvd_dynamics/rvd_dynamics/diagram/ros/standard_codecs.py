"""
Codecs of standard messages, for tools that know nothing of ours: RViz, Foxglove, rosbag2 readers.

They are written and never read by a block. Quaternions are (x, y, z, w); a twist is in the axes of
its child frame, as nav_msgs/Odometry has it. Frames are named as REP 105 does: `run.frame_id`, then
`*_base` of each body.
"""

from typing import Any

from nav_msgs.msg import Odometry as OdometryMessage
import numpy as np
from numpy.typing import NDArray
from sensor_msgs.msg import Imu as ImuMessage
from tf2_msgs.msg import TFMessage

from rvd_dynamics.diagram.ros.codecs import Codec
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
    """
    Frames, each in another, as `tf2_msgs/TFMessage`.

    A frame that is not known yet (NaN) is left out: tf2 refuses it with an error each time.
    """

    def __init__(self, signal: Signal, run: Run, frames: tuple) -> None:
        super().__init__(signal, run)
        self._frames = frames
        self._layouts: dict[bytes, Layout] = {}     # by which frames are known

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value: place and turn of each frame in its parent."""
        rows = np.concatenate((value.place, value.turn), axis=-1)
        known = np.isfinite(rows).all(axis=-1)
        layout = self._layouts.get(known.tobytes())
        if layout is None:
            layout = self._layouts[known.tobytes()] = self._laid_out(known)
        numbers = []
        for row in rows[known].tolist():
            numbers += (*self.stamp(k), *row)
        return layout.pack(*numbers)

    def _laid_out(self, known: NDArray[np.bool_]) -> Layout:
        frames = [frame for frame, is_known in zip(self._frames, known) if is_known]
        names = {}
        for i, (parent, child) in enumerate(frames):
            names[f'transforms[{i}].header.frame_id'] = parent
            names[f'transforms[{i}].child_frame_id'] = child
        return Layout(TFMessage, names, {'transforms': len(frames)})


class StillTransforms(Transforms):
    """The same, of frames that do not move in their parents."""

    def __init__(self, signal: Signal, run: Run, still_frames: tuple) -> None:
        super().__init__(signal, run, still_frames)
