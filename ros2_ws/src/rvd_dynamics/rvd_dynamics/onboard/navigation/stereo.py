"""
The pose from two cameras, solved together, and from blobs that nobody has named.

Pose    Gauss-Newton on the reprojection in all cameras at once, from the pose of the one that sees
        most (OpenCV's PnP, `vision.solve`). With the port at p and the target turned by R in craft
        axes a marker X is at p + R X; d/dp is 1, and a small turn d of the craft changes it by
        (R X) x d.
Names   each marker gets the blob that is next to where the last pose has it, by the least sum of
        distances (Hungarian method), of blobs of about its size and within GATE_PX; failing that
        the same after the whole pattern was shifted onto the blobs, which finds it again after a
        loss. What does not fit to WORST_PX afterwards is no pose.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.pinhole import CAMERA_ORDER, CameraParams, project, USABLE
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.navigation.vision import Pose, solve, Vision

Array = NDArray[np.float64]
ROUNDS = 6
GATE_PX = 15.0
WORST_PX = 1.0
SIZES = 0.4, 2.5                        # a blob's area over that of its marker


def pair(camera: CameraParams, baseline_m: float) -> tuple[CameraParams, CameraParams]:
    """Return the left and right camera of a stereo pair about the place of one."""
    x, y, z = camera.place_m
    return tuple(replace(camera, place_m=(x, y + side*0.5*baseline_m, z)) for side in (-1.0, 1.0))


def seen_from(cameras: Sequence[CameraParams], points: Array, place: Array, turn: Array
              ) -> tuple[Array, Array]:
    """Return markers (C, M, 3) in the cameras' frames and their arms (M, 3) in craft axes [m]."""
    arm = attitude.rotate_back(turn, points)
    body = place + arm
    return np.stack([(body - np.array(c.place_m))[:, CAMERA_ORDER] for c in cameras]), arm


def solve_together(cameras: Sequence[CameraParams], points: Array, pixels: Array, sigma_px: float
                   ) -> tuple[Array, Array, Array, float] | None:
    """
    Return place (3,), attitude (4,), covariance (6, 6) and rms residual [px], or None.

    `points` (M, 3) on the target from its port [m]; `pixels` (C, M, 2), NaN where not seen.
    """
    known = np.isfinite(pixels[..., 0])
    best = int(known.sum(axis=-1).argmax())
    if known[best].sum() < USABLE:
        return None
    first = solve(cameras[best], points[known[best]], pixels[best][known[best]], sigma_px)
    if first is None:
        return None
    place, turn, _ = first
    focal = np.array([c.focal_px for c in cameras])[:, None]
    centre = np.array([0.5*c.width_px for c in cameras])[:, None, None]
    for _ in range(ROUNDS):
        at, arm = seen_from(cameras, points, place, turn)
        x, y, z = np.moveaxis(at, -1, 0)
        residual = pixels - (focal[..., None]*at[..., :2]/z[..., None] + centre)
        o = np.zeros_like(z)
        rows = np.stack([np.stack([-focal*x/(z*z), focal/z, o], -1),    # by body x, y, z
                         np.stack([-focal*y/(z*z), o, focal/z], -1)], -2)
        a, b, c = arm.T
        n = np.zeros_like(a)
        cross = np.stack([np.stack([n, -c, b], -1), np.stack([c, n, -a], -1),
                          np.stack([-b, a, n], -1)], -2)                # [arm]x
        jacobian = np.concatenate([rows, rows @ cross], axis=-1)[known].reshape(-1, 6)
        left = residual[known].reshape(-1)
        information = jacobian.T @ jacobian
        step = np.linalg.solve(information, jacobian.T @ left)
        place = place + step[:3]
        turn = attitude.normalised(attitude.multiply(turn, attitude.from_rotation_vector(step[3:])))
        if np.abs(step).max() < 1e-9:
            break
    if not np.isfinite(place).all():
        return None
    rms = float(np.sqrt((left*left).mean()))
    return place, turn, sigma_px*sigma_px*np.linalg.inv(information), rms


class StereoVision(Vision):
    """Poses of a batch of runs from named markers in both images; see `vision.Vision`."""

    def __init__(self, cameras: Sequence[CameraParams], *more: object) -> None:
        super().__init__(cameras[0], *more)
        self._cameras = cameras

    def poses(self, pixels: ArrayLike) -> Pose:
        """Return the poses of features (..., C, M, 2); `usable` counts both cameras'."""
        pixels = np.asarray(pixels, dtype=float)
        found = unknown(pixels.shape[:-3])
        for at in np.ndindex(found.usable.shape):
            mine = self._of_mode[int(self.mode[at])]
            found.usable[at] = np.isfinite(pixels[at][:, mine, 0]).sum()
            pose = solve_together(self._cameras, self._points[mine], pixels[at][:, mine],
                                  self._settings.assumed_sigma_px)
            if pose is not None:
                found.place[at], found.turn[at], found.covariance[at], _ = pose
        return self._handed_over(found)


class ImageVision(StereoVision):
    """
    Poses from blobs.

    `radii` (M,) are those of the markers [m], `place` (3,) and `turn` (4,) where the craft takes
    the target's port to be before it has seen it.
    """

    def __init__(self, cameras: Sequence[CameraParams], radii: Array, place: Array, turn: Array,
                 *more: object) -> None:
        super().__init__(cameras, *more)
        batch = self.mode.shape
        self._radii = radii
        self._place = np.array(np.broadcast_to(place, (*batch, 3)))
        self._turn = np.array(np.broadcast_to(turn, (*batch, 4)))

    def poses(self, blobs: ArrayLike) -> Pose:
        """Return the poses of blobs (..., C, B, 3), centre and area [px]."""
        blobs = np.asarray(blobs, dtype=float)
        found = unknown(blobs.shape[:-3])
        for at in np.ndindex(found.usable.shape):
            mine = self._of_mode[int(self.mode[at])]
            for shifted in (False, True):
                pixels = self._named(at, blobs[at], mine, shifted)
                found.usable[at] = np.isfinite(pixels[..., 0]).sum()
                pose = solve_together(self._cameras, self._points[mine], pixels,
                                      self._settings.assumed_sigma_px)
                if pose is not None and pose[3] < WORST_PX:
                    found.place[at], found.turn[at], found.covariance[at], _ = pose
                    self._place[at], self._turn[at] = pose[:2]
                    break
        return self._handed_over(found)

    def _named(self, at: tuple, blobs: Array, mine: NDArray, shifted: bool) -> Array:
        """Return the pixels (C, M, 2) of the markers of this mode; NaN where no blob fits."""
        points, radii = self._points[mine], self._radii[mine]
        there, _ = seen_from(self._cameras, points, self._place[at], self._turn[at])
        pixels = np.full((*there.shape[:-1], 2), np.nan)
        for i, camera in enumerate(self._cameras):
            wanted = project(camera, there[i])
            area = np.pi*(camera.focal_px*radii/there[i][:, 2])**2
            pixels[i] = named(wanted, area, blobs[i], shifted)
        return pixels


def named(wanted: Array, area: Array, blobs: Array, shifted: bool) -> Array:
    """
    Return the blob's centre for each marker, (M, 2) [px]; NaN where none fits.

    Parameters
    ----------
    wanted, area : ndarray, shapes (M, 2), (M,)
        Where the markers should be [px], and how large [px]; NaN where not in view.
    blobs : ndarray, shape (B, 3)
    shifted : bool
        Whether the pattern as a whole may be elsewhere.
    """
    from scipy.optimize import linear_sum_assignment
    blobs = blobs[np.isfinite(blobs[:, 0])]
    found = np.full(wanted.shape, np.nan)
    ratio = blobs[None, :, 2]/area[:, None]
    fits = (ratio > SIZES[0]) & (ratio < SIZES[1])
    markers, kept = np.isfinite(wanted[:, 0]), fits.any(axis=0)
    if not markers.any() or not kept.any():
        return found
    if shifted:
        wanted = wanted + blobs[kept, :2].mean(axis=0) - wanted[markers].mean(axis=0)
    away = np.hypot(*(np.nan_to_num(wanted, nan=1e6)[:, None, k] - blobs[None, :, k]
                      for k in (0, 1)))
    away = np.where(fits & markers[:, None], away, 1e6)
    row, column = linear_sum_assignment(np.minimum(away, 10.0*GATE_PX))
    good = away[row, column] < (2.0 if shifted else 1.0)*GATE_PX
    found[row[good]] = blobs[column[good], :2]
    return found


def unknown(batch: tuple) -> Pose:
    """Return a pose that nobody has found yet."""
    return Pose(np.full((*batch, 3), np.nan), np.full((*batch, 4), np.nan),
                np.full((*batch, 6, 6), np.nan), np.zeros(batch, dtype=np.int64))
