"""
The pair of cameras: features of both images, or images that are rendered and searched for blobs.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.streams import generator
from rvd_dynamics.geometry.markers import RenderingParams
from rvd_dynamics.motion import attitude
from rvd_dynamics.world.sensors.camera import features
from rvd_dynamics.world.sensors.rendering import blobs, render
from rvd_dynamics.world.spacecraft.spacecraft import Spacecraft
from rvd_missions.docking import markers
from rvd_missions.docking.scatter import Drawn, drawn, Scatter
from rvd_missions.docking.settings import Chaser
from rvd_missions.docking.signals import MARKERS
from rvd_missions.docking.space import mounted, relative, SeeingParams
from rvd_missions.docking.stereo_signals import CAMERAS, SPOTS, STEREO

STEREO_DRAWS = CAMERAS*2*MARKERS + 1    # normals of a view: both images, and whether it is lost
REST = 256                              # px by which the pattern of noise is larger than an image
RENDERED_DRAWS = CAMERAS*2 + 1          # where the noise of each image begins, and the same


class _Pair:
    """What both have in common: where the craft is, and the draws of a view."""

    def __init__(self, settings: SeeingParams, cameras: tuple, own: Drawn, late: int,
                 period: int, views: NDArray, draws: int, batch: tuple) -> None:
        from scipy.special import ndtr
        self._image, self._cameras, self._late, self._period = settings.image, cameras, late, period
        self._centre, self._mounted = mounted(settings, own, batch)
        each = np.reshape(views, (*np.shape(views)[:-1], -1, draws))
        self._normals, self._chance = each[..., :-1], ndtr(each[..., -1])
        self._points = markers.TARGET_PORT + np.concatenate([markers.BIG, markers.SMALL])


class StereoCamera(_Pair):
    """Markers in both images, with corner noise."""

    def __init__(self, settings: SeeingParams, cameras: tuple, chaser: Chaser, scatter: Scatter,
                 craft: Spacecraft, late: int, period: int, views: NDArray, properties: NDArray,
                 batch: tuple) -> None:
        super().__init__(settings, cameras, drawn(scatter, craft, chaser, properties), late,
                         period, views, STEREO_DRAWS, batch)

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the features of both cameras that come out at step k."""
        offset, turn = relative(truth, self._centre)
        row = k//self._period
        normals = self._normals[..., row, :].reshape((*turn.shape[:-1], CAMERAS, MARKERS, 2))
        pixels = np.stack([features(
            camera, self._image, self._points, markers.FACING, offset, turn, normals[..., i, :, :],
            self._chance[..., row], *self._mounted)
            for i, camera in enumerate(self._cameras)], axis=-3)
        return {'features': STEREO(pixels=pixels, exposed=np.int64(k - self._late))}


class RenderedCamera(_Pair):
    """Renders both images and finds their blobs; corner noise plays no part."""

    def __init__(self, settings: SeeingParams, rendering: RenderingParams, cameras: tuple,
                 marker_radii: NDArray, chaser: Chaser, scatter: Scatter, craft: Spacecraft,
                 late: int, period: int, views: NDArray, properties: NDArray,
                 batch: tuple) -> None:
        from scipy.special import ndtr
        super().__init__(settings, cameras, drawn(scatter, craft, chaser, properties), late,
                         period, views, RENDERED_DRAWS, batch)
        self._look = rendering
        self._pattern = pattern(cameras[0].width_px + REST)
        self._shifts = np.minimum((REST*ndtr(self._normals)).astype(np.int64), REST - 1)
        self._radii = marker_radii

    def step(self, k: int, truth: Any) -> dict[str, Any]:
        """Return the blobs in both images that come out at step k."""
        offset, turn = relative(truth, self._centre)
        row = k//self._period
        batch = turn.shape[:-1]
        found = SPOTS.initial(batch).blobs.copy()
        for at in np.ndindex(batch):
            if self._chance[(*at, row)] < self._image.drop_out or not np.isfinite(
                    offset[at]).all():
                continue
            shifts = self._shifts[(*at, row)].reshape(CAMERAS, 2)
            for i, camera in enumerate(self._cameras):
                size = camera.width_px
                found[(*at, i)] = blobs(self._look, render(
                    camera, self._look, self._points, self._radii, markers.FACING,
                    *placed(camera, offset[at], turn[at], *(part[at] for part in self._mounted)),
                    self._pattern[shifts[i, 1]:, shifts[i, 0]:][:size, :size]))
        return {'blobs': SPOTS(blobs=found, exposed=np.int64(k - self._late))}


@lru_cache(maxsize=2)
def pattern(side: int) -> NDArray[np.float32]:
    """Return normals (side, side), the noise of all images: each shows another part of it."""
    made = generator(0, 0, 'docking/camera/pattern').standard_normal((side, side), np.float32)
    made.setflags(write=False)
    return made


def placed(camera: Any, offset: NDArray, turn: NDArray, turned_deg: NDArray, moved_m: NDArray
           ) -> tuple[NDArray, NDArray]:
    """Return place and attitude of a craft whose aligned camera sees what the real one does."""
    place = np.array(camera.place_m)
    tilted = attitude.multiply(turn, attitude.from_rotation_vector(np.radians(turned_deg)))
    eye = offset + attitude.rotate(turn, place + moved_m)
    return eye - attitude.rotate(tilted, place), tilted
