"""
A pinhole camera and the markers that it looks at.

Frames  camera: origin the pinhole, x to the right, y down, z along the boresight; pixels from the
        upper left corner, the principal point in the middle. The camera of a craft looks along its
        +x, with z down: camera x, y, z are body y, z, x.
Shapes  points (..., 3) [m], pixels (..., 2); NaN where there is nothing to see.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, settings

Array = NDArray[np.float64]
CAMERA_ORDER = [1, 2, 0]                # body components in the order of the camera's axes
BODY_ORDER = [2, 0, 1]                  # and back
FLAT = 0.02                             # least thickness of markers as a fraction of their size
USABLE = 4                              # markers that a pose needs


@settings
class CameraParams:
    """The camera: its image, and where it is on the craft."""

    focal_px: float = param(1200.0, 'Focal length [px].', above=0.0, high=1e6)
    width_px: int = param(1024, 'Width and height of the image [px].', low=8, high=100_000)
    place_m: tuple = param((0.9, 0.0, 0.0), 'Place of the pinhole in the craft [m].', length=3)

    @property
    def half_view(self) -> float:
        """Tangent of half the field of view, across an edge."""
        return 0.5*self.width_px/self.focal_px

    @property
    def matrix(self) -> Array:
        """Matrix of the camera (3, 3) [px]."""
        c = 0.5*self.width_px
        return np.array([[self.focal_px, 0.0, c], [0.0, self.focal_px, c], [0.0, 0.0, 1.0]])


def project(camera: CameraParams, points: ArrayLike) -> Array:
    """Return the pixels (..., 2) of points (..., 3) in the camera's frame; NaN out of view."""
    x, y, z = np.moveaxis(np.asarray(points, dtype=float), -1, 0)
    ahead = np.where(z > 0.0, z, np.nan)
    across = np.stack([x/ahead, y/ahead], axis=-1)
    seen = np.all(np.abs(across) <= camera.half_view, axis=-1)          # false for NaN
    return np.where(seen[..., np.newaxis],
                    camera.focal_px*across + 0.5*camera.width_px, np.nan)


def require_markers(name: str, points: ArrayLike) -> None:
    """
    Refuse markers (M, 3) from which no unique pose follows.

    Raises
    ------
    BadInput
        If they are fewer than four, or nearly in one plane.
    """
    points = np.asarray(points, dtype=float)
    if len(points) < USABLE:
        raise BadInput(f'{name}: a pose needs {USABLE} markers, got {len(points)}')
    size = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if not size[2] > FLAT*size[0]:
        raise BadInput(f'{name}: markers must not lie in one plane: their thickness must be above '
                       f'{FLAT:g} of their size, got {size[2]/size[0] if size[0] else 0.0:.3g}')


def require_in_view(name: str, pixels: ArrayLike) -> None:
    """Refuse a start at which fewer than four markers (M, 2) are in view."""
    seen = int(np.isfinite(np.asarray(pixels)[..., 0]).sum())
    if seen < USABLE:
        raise BadInput(f'{name}: at least {USABLE} markers must be in view at the start, '
                       f'got {seen}')
