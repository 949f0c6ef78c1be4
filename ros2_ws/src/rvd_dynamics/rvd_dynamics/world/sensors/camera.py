"""
What the camera sees of the target's markers: their places in the image, features and not pixels.

Model   pinhole, corner noise on both axes of the image, field of view, occlusion by the target's
        own face, whole frames that drop out; the camera sits a little off from where the craft
        thinks that it is. Latency is the delay of the diagram's edge.
Valid   markers are told apart without fault; no blur, no glare, no lens distortion.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.geometry.pinhole import CAMERA_ORDER, CameraParams, project
from rvd_dynamics.motion import attitude

Array = NDArray[np.float64]


@settings
class ImageParams:
    """How good the image is."""

    corner_sigma_px: float = param(
        0.1, 'Standard deviation of a marker in the image, on each axis [px].', low=0.0, high=100.0)
    drop_out: float = param(0.0, 'Fraction of frames that are lost.', low=0.0, high=1.0)
    alignment_deg: tuple = param(
        (0.0, 0.0, 0.0), 'Error of the camera\'s alignment about the craft\'s axes [deg].',
        low=-5.0, high=5.0, length=3)
    offset_m: tuple = param(
        (0.0, 0.0, 0.0), 'Error of the camera\'s place in the craft [m].', low=-0.1, high=0.1,
        length=3)


def features(camera: CameraParams, image: ImageParams, markers: ArrayLike, facing: ArrayLike,
             offset: ArrayLike, turn: ArrayLike, normals: ArrayLike, uniform: ArrayLike,
             alignment_deg: ArrayLike | None = None, offset_m: ArrayLike | None = None) -> Array:
    """
    Return the markers in the image, (..., M, 2) [px]; NaN where one is not seen.

    Parameters
    ----------
    markers : array_like, shape (M, 3)
        Places on the target [m].
    facing : array_like, shape (3,)
        Unit vector of the face that carries them: it hides them from behind.
    offset : array_like, shape (..., 3)
        True place of the craft's centre relative to the target's, in target axes [m].
    turn : array_like, shape (..., 4)
        True attitude of the craft relative to the target.
    normals : array_like, shape (..., M, 2)
    uniform : array_like, shape (...)
    alignment_deg, offset_m : array_like, shape (..., 3)
        How the camera is mounted, in place of what `image` says.
    """
    markers = np.asarray(markers, dtype=float)
    turn = np.asarray(turn, dtype=float)
    alignment_deg = image.alignment_deg if alignment_deg is None else alignment_deg
    offset_m = image.offset_m if offset_m is None else offset_m
    place = np.array(camera.place_m) + np.asarray(offset_m, dtype=float)
    tilt = attitude.from_rotation_vector(np.radians(alignment_deg))
    eye = np.asarray(offset, dtype=float) + attitude.rotate(turn, np.broadcast_to(
        place, (*turn.shape[:-1], 3)))
    sight = markers - eye[..., np.newaxis, :]                   # target axes
    body = attitude.rotate_back(attitude.multiply(turn, tilt)[..., np.newaxis, :], sight)
    seen = body[..., CAMERA_ORDER]
    pixels = project(camera, seen) + image.corner_sigma_px*np.asarray(normals, dtype=float)
    toward = -(sight[..., 0]*facing[0] + sight[..., 1]*facing[1] + sight[..., 2]*facing[2])
    hidden = (toward <= 0.0) | (np.asarray(uniform)[..., np.newaxis] < image.drop_out)
    return np.where(hidden[..., np.newaxis], np.nan, pixels)
