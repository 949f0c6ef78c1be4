"""
From markers in the image to the pose of the craft: which set of markers, and OpenCV's PnP.

Output  place of the target's port in craft axes from the craft's centre [m], attitude of the craft
        relative to the target as a quaternion, and their covariance (6, 6) over (place [m], small
        turn of the craft in its axes [rad]), from the corner noise to first order.
Sets    far away the big markers, near the small ones, both solved together in between; each change
        has a hysteresis, so that noise does not switch to and fro.
Source  An, Qu, Wang 2015, sections 2.1 and 4.2 name the camera and print no number. Pose: Terzakis,
        Lourakis, ECCV 2020 (SQPNP), then the least squares of the reprojection (ITERATIVE).

OpenCV is imported with the first object that is made.
"""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.geometry.pinhole import BODY_ORDER, CameraParams, USABLE
from rvd_dynamics.motion import attitude

Array = NDArray[np.float64]
BIG, BOTH, SMALL = 0, 1, 2


@settings
class VisionParams:
    """When the sets of markers are handed over, and what noise is assumed."""

    both_below_m: float = param(
        0.60, 'Distance of the faces below which the small markers are used, too [m].', above=0.0,
        high=100.0)
    small_below_m: float = param(
        0.12, 'Distance below which they are used alone [m].', above=0.0, high=100.0)
    hysteresis_m: float = param(
        0.05, 'Distance by which either is left later than it is entered [m].', low=0.0, high=10.0)
    assumed_sigma_px: float = param(
        0.1, 'Standard deviation of a marker in the image that is assumed [px].', above=0.0,
        high=100.0)

    def __post_init__(self) -> None:
        require(self.small_below_m + self.hysteresis_m < self.both_below_m, 'small_below_m',
                f'be below both_below_m by more than the hysteresis, {self.hysteresis_m:g}',
                self.small_below_m)


class Pose(NamedTuple):
    """What was seen; NaN where no pose was found. Rows in front."""

    place: Array                # (..., 3) of the port in craft axes [m]
    turn: Array                 # (..., 4) craft relative to target
    covariance: Array           # (..., 6, 6)
    usable: NDArray[np.int64]   # (...) markers seen of those that count


class Vision:
    """
    Poses of a batch of runs.

    Parameters
    ----------
    camera : CameraParams
    settings : VisionParams
    big, small : array_like, shape (M, 3)
        Markers on the target, in its axes from its port [m].
    face_m : float
        Distance from the camera forward to the craft's own docking face [m].
    """

    def __init__(self, camera: CameraParams, settings: VisionParams, big: ArrayLike,
                 small: ArrayLike, face_m: float, batch: tuple) -> None:
        self._camera, self._settings, self._face = camera, settings, face_m
        self._points = np.concatenate([big, small])
        kind = np.array([BIG]*len(big) + [SMALL]*len(small))
        self._of_mode = {BIG: kind == BIG, SMALL: kind == SMALL, BOTH: kind >= 0}
        self.mode = np.zeros(batch, dtype=np.int64)

    def poses(self, pixels: ArrayLike) -> Pose:
        """Return the poses of features (..., M, 2), big markers first; NaN is not seen."""
        pixels = np.asarray(pixels, dtype=float)
        batch = pixels.shape[:-2]
        found = Pose(np.full((*batch, 3), np.nan), np.full((*batch, 4), np.nan),
                     np.full((*batch, 6, 6), np.nan), np.zeros(batch, dtype=np.int64))
        for at in np.ndindex(batch):
            usable = self._of_mode[int(self.mode[at])] & np.isfinite(pixels[at][:, 0])
            found.usable[at] = usable.sum()
            if found.usable[at] < USABLE:
                continue
            pose = solve(self._camera, self._points[usable], pixels[at][usable],
                         self._settings.assumed_sigma_px)
            if pose is not None:
                found.place[at], found.turn[at], found.covariance[at] = pose
        return self._handed_over(found)

    def _handed_over(self, found: Pose) -> Pose:
        """Choose the sets of markers for the next frame, where a pose was found; return those."""
        away = found.place[..., 0] - self._camera.place_m[0] - self._face       # NaN: none found
        self.mode = handed_over(self._settings, self.mode, away)
        return found


def handed_over(settings: VisionParams, mode: ArrayLike, away: ArrayLike) -> NDArray[np.int64]:
    """Return the sets that count next, of those of now and distances [m]; NaN: the same."""
    s, mode, away = settings, np.asarray(mode), np.asarray(away)
    both, small, more = s.both_below_m, s.small_below_m, s.hysteresis_m
    enters = (mode == BIG) & (away < both) | (mode == SMALL) & (away > small + more)
    leaves = np.where(away > both + more, BIG, np.where(away < small, SMALL, BOTH))
    return np.where(enters, BOTH, np.where(mode == BOTH, leaves, mode))


def solve(camera: CameraParams, points: Array, pixels: Array, sigma_px: float
          ) -> tuple[Array, Array, Array] | None:
    """
    Return place (3,), attitude (4,) and covariance (6, 6) of one view, or None if there is none.

    `points` (M, 3) on the target from its port [m], `pixels` (M, 2); see the module.
    """
    cv2 = _opencv()
    ok, turn, shift = cv2.solvePnP(points, pixels, camera.matrix, None, flags=cv2.SOLVEPNP_SQPNP)
    if not ok:
        return None
    turn, shift = cv2.solvePnPRefineLM(points, pixels, camera.matrix, None, turn, shift)
    if not shift[2, 0] > 0.0:
        return None
    matrix = cv2.Rodrigues(turn)[0]                     # camera from target
    shift = shift[:, 0]
    arm = points @ matrix.T
    x, y, z = (arm + shift).T
    f, o = camera.focal_px, np.zeros(len(points))
    rows = np.stack([np.stack([f/z, o, -f*x/(z*z)], -1), np.stack([o, f/z, -f*y/(z*z)], -1)], -2)
    a, b, c = arm.T
    skew = np.stack([np.stack([o, c, -b], -1), np.stack([-c, o, a], -1),
                     np.stack([b, -a, o], -1)], -2)     # of a turn of the target: w x arm
    jacobian = np.concatenate([rows, rows @ skew], axis=-1).reshape(-1, 6)
    covariance = sigma_px*sigma_px*np.linalg.inv(jacobian.T @ jacobian)
    order = np.array(BODY_ORDER)
    both = np.concatenate([order, 3 + order])
    covariance = covariance[np.ix_(both, both)]
    # the craft turns by the opposite of what the target does
    covariance[:3, 3:] *= -1.0
    covariance[3:, :3] *= -1.0
    place = np.array(camera.place_m) + shift[order]
    return place, attitude.conjugate(_quaternion(matrix[order])), covariance


def _quaternion(m: Array) -> Array:
    """Return the quaternion (4,) of a rotation matrix (3, 3), by its greatest component."""
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    squares = np.array([m[0, 0], m[1, 1], m[2, 2], trace])
    i = int(np.argmax(squares))
    if i == 3:
        q = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1.0 + trace])
    else:
        j, k = (i + 1) % 3, (i + 2) % 3
        q = np.empty(4)
        q[i] = 1.0 + 2.0*m[i, i] - trace
        q[j], q[k] = m[j, i] + m[i, j], m[k, i] + m[i, k]
        q[3] = m[k, j] - m[j, k]
    return attitude.normalised(q)


@lru_cache(maxsize=1)
def _opencv() -> Any:
    import cv2                          # 0.2 s
    cv2.setNumThreads(1)                # a pose is too small a task to share
    return cv2
