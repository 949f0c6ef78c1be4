"""
Poses on board from a pair of cameras: from named markers, or from the blobs of rendered images.
"""

from typing import Any

import numpy as np

from rvd_dynamics.geometry.pinhole import CameraParams, require_markers
from rvd_dynamics.onboard.navigation.stereo import ImageVision, StereoVision
from rvd_dynamics.onboard.navigation.vision import VisionParams
from rvd_missions.docking import markers
from rvd_missions.docking.settings import Start
from rvd_missions.docking.signals import POSE


def known(camera: CameraParams, settings: VisionParams, batch: tuple) -> tuple:
    """Return what the craft knows of markers and cameras, as `Vision` takes it."""
    require_markers('markers', markers.BIG)
    return (settings, markers.BIG, markers.SMALL, markers.CHASER_PORT[0] - camera.place_m[0], batch)


class Stereo:
    """Poses from the markers in both images."""

    def __init__(self, settings: VisionParams, camera: CameraParams, cameras: tuple,
                 batch: tuple) -> None:
        self._poses = StereoVision(cameras, *known(camera, settings, batch))

    def step(self, k: int, features: Any) -> dict[str, Any]:
        """Return the pose of the features of step k."""
        counted = self._poses.mode.copy()           # those that this view is solved with
        return {'pose': of(self._poses.poses(features.pixels), features, counted)}


class Images:
    """Poses from blobs; before the first the craft takes itself to be at the nominal start."""

    def __init__(self, settings: VisionParams, camera: CameraParams, cameras: tuple,
                 marker_radii: Any, start: Start, batch: tuple) -> None:
        self._poses = ImageVision(
            cameras, marker_radii, markers.TARGET_PORT - np.array(start.position_m),
            np.array([0.0, 0.0, 0.0, 1.0]), *known(camera, settings, batch))

    def step(self, k: int, blobs: Any) -> dict[str, Any]:
        """Return the pose of the blobs of step k."""
        counted = self._poses.mode.copy()
        return {'pose': of(self._poses.poses(blobs.blobs), blobs, counted)}


def of(pose: Any, seen: Any, counted: Any) -> Any:
    """Return a pose as the signal."""
    return POSE(place=pose.place, turn=pose.turn, covariance=pose.covariance, usable=pose.usable,
                exposed=seen.exposed, markers=counted)
