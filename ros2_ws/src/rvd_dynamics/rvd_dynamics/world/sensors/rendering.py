"""
Images of round markers as a camera takes them, and the blobs that the camera's head finds in them.

Image   grey levels of 8 bits, pixel (0, 0) at the centre of the upper left one. A marker is a disc
        on the target's face: each pixel is the mean of RAYS x RAYS rays that meet it or not, so
        that perspective is exact, and one that a nearer disc stops goes no further; then the blur
        of the optics, noise, whole levels.
Blobs   connected pixels above a threshold; the centre is the centroid of what is brighter than the
        background, to a fraction of a pixel. Which marker a blob is nobody says.
Valid   a dark target: no sun, no glare, no distortion; nothing but markers covers markers.

OpenCV is imported with the first image.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.markers import RenderingParams
from rvd_dynamics.geometry.pinhole import CAMERA_ORDER, CameraParams
from rvd_dynamics.motion import attitude

Array = NDArray[np.float64]
RAYS = 6                                # in a pixel, along each axis
MOST_BLOBS = 24
PAD = 3                                 # px around a blob that belong to its centroid


def render(camera: CameraParams, look: RenderingParams, points: ArrayLike, radii: ArrayLike,
           facing: ArrayLike, offset: ArrayLike, turn: ArrayLike, noise: ArrayLike
           ) -> NDArray[np.uint8]:
    """
    Return an image (height, width).

    Parameters
    ----------
    points, radii : array_like, shapes (M, 3), (M,)
        Centres [m] and radii [m] of the discs on the target.
    facing : array_like, shape (3,)
        Unit vector of the face that they lie on.
    offset, turn : array_like, shapes (3,), (4,)
        Craft's centre from the target's in target axes [m]; attitude relative to the target.
    noise : array_like, shape (height, width)
        Normals, one for each pixel.
    """
    cv2 = _opencv()
    size = camera.width_px
    turn = np.asarray(turn, dtype=float)
    eye = np.asarray(offset) + attitude.rotate(turn, np.array(camera.place_m))
    centres = attitude.rotate_back(turn, np.asarray(points) - eye)[:, CAMERA_ORDER]
    normal = attitude.rotate_back(turn, np.asarray(facing, dtype=float))[CAMERA_ORDER]
    image = np.full((size, size), look.background, dtype=np.float32)
    seen = [(centre, radius) for centre, radius in zip(centres, radii)
            if centre[2] > 0.0 and normal @ centre < 0.0]
    for centre, radius in seen:
        nearer = [other for other in seen if _before(other, (centre, radius))]
        _draw(cv2, image, camera, look, centre, normal, radius, nearer)
    cv2.scaleAdd(np.asarray(noise, dtype=np.float32), look.noise, image, image)
    return cv2.convertScaleAbs(np.maximum(image, 0.0, out=image))


def _before(other: tuple[Array, float], disc: tuple[Array, float]) -> bool:
    """Say whether another disc (centre in the camera's frame, radius) may cover some of a disc."""
    (near, wide), (far, radius) = other, disc
    apart = np.hypot(*(near[:2]/near[2] - far[:2]/far[2]))
    return near[2] < far[2] and apart < 1.3*(wide/near[2] + radius/far[2])


def _met(across: Array, down: Array, centre: Array, normal: Array, radius: float
         ) -> NDArray[np.bool_]:
    """Return which rays, by their slopes, meet a disc."""
    along = (normal @ centre)/(normal[0]*across + normal[1]*down + normal[2])
    away = (along*across - centre[0])**2 + (along*down - centre[1])**2 + (along - centre[2])**2
    return away < radius*radius


def _draw(cv2: Any, image: NDArray, camera: CameraParams, look: RenderingParams, centre: Array,
          normal: Array, radius: float, nearer: list[tuple[Array, float]]) -> None:
    """
    Brighten the pixels of a disc, but where one of those nearer covers it.

    Centres and normal are in the camera's frame.
    """
    f, c = camera.focal_px, 0.5*camera.width_px
    u, v = f*centre[:2]/centre[2] + c
    half = int(np.ceil(1.3*f*radius/centre[2] + 4.0*look.blur_px)) + 1
    left, top = int(round(u)) - half, int(round(v)) - half
    count = 2*half + 1
    x0, y0 = max(left, 0), max(top, 0)
    x1, y1 = (min(at + count, camera.width_px) for at in (left, top))
    if x1 <= x0 or y1 <= y0:
        return
    fine = (np.arange(count*RAYS) + 0.5)/RAYS - 0.5
    across, down = np.meshgrid((left + fine - c)/f, (top + fine - c)/f)
    met = _met(across, down, centre, normal, radius)
    for other in nearer:
        met &= ~_met(across, down, other[0], normal, other[1])
    met = met.reshape(count, RAYS, count, RAYS)
    patch = met.mean(axis=(1, 3), dtype=np.float32)*np.float32(look.marker - look.background)
    patch = cv2.GaussianBlur(patch, (0, 0), look.blur_px)
    image[y0:y1, x0:x1] += patch[y0 - top:y1 - top, x0 - left:x1 - left]


def blobs(look: RenderingParams, image: NDArray[np.uint8]) -> Array:
    """Return the blobs of an image, (MOST_BLOBS, 3): centre [px] and pixels; NaN: no more."""
    cv2 = _opencv()
    _, bright = cv2.threshold(image, look.threshold, 255, cv2.THRESH_BINARY)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(bright, connectivity=8)
    found = np.full((MOST_BLOBS, 3), np.nan)
    order = 1 + np.argsort(-stats[1:, cv2.CC_STAT_AREA], kind='stable')
    for i, label in enumerate(order[:MOST_BLOBS]):
        x, y, w, h, area = stats[label]
        edge = x == 0 or y == 0 or x + w == image.shape[1] or y + h == image.shape[0]
        if area < look.least_px or edge:        # one that is cut has its centre elsewhere
            continue
        x0, y0 = max(x - PAD, 0), max(y - PAD, 0)
        part = slice(y0, y + h + PAD), slice(x0, x + w + PAD)
        own = (labels[part] == label) | (labels[part] == 0)
        above = np.where(own, image[part].astype(np.float32) - np.float32(look.background), 0.0)
        m = cv2.moments(above)
        found[i] = x0 + m['m10']/m['m00'], y0 + m['m01']/m['m00'], area
    return found


@lru_cache(maxsize=1)
def _opencv() -> Any:
    import cv2
    cv2.setNumThreads(1)
    return cv2
