"""
Signals and settings of the pair of cameras, and of the images that they render.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.geometry.markers import RenderingParams
from rvd_dynamics.geometry.pinhole import CameraParams
from rvd_dynamics.onboard.navigation.stereo import pair
from rvd_missions.docking.markers import BIG, SMALL
from rvd_missions.docking.signals import EXPOSED, MARKERS

CAMERAS = 2
BLOBS = 24                              # rendering.MOST_BLOBS

STEREO = Signal('/onboard/stereo_features', (
    Part('pixels', (CAMERAS, MARKERS, 2), 'px'), EXPOSED))
SPOTS = Signal('/onboard/blobs', (                      # which marker each is nobody says
    Part('blobs', (CAMERAS, BLOBS, 3), 'px'), EXPOSED))


@settings
class StereoParams:
    """The pair of cameras: two like the one, side by side."""

    baseline_m: float = param(0.30, 'Distance between the two cameras [m].', above=0.0, high=10.0)


def cameras(camera: CameraParams, stereo: StereoParams) -> tuple[CameraParams, CameraParams]:
    """Return left and right camera of a scenario."""
    return pair(camera, stereo.baseline_m)


def radii(rendering: RenderingParams) -> NDArray:
    """Return the radii of all markers (M,) [m], big ones first."""
    return np.array([rendering.big_radius_m]*len(BIG) + [rendering.small_radius_m]*len(SMALL))
