"""
Shapes for viewers: surfaces of revolution about the approach axis, ellipsoids of uncertainty.

Frame   target orbital: the axis of revolution is x.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def revolved(x: ArrayLike, radius: ArrayLike, sectors: int = 36) -> NDArray[np.float64]:
    """
    Return the triangles of a surface of revolution about x.

    Parameters
    ----------
    x, radius : array_like, shape (n,)
        Stations [m] and the radius there [m].
    sectors : int
        Flat faces around the axis.

    Returns
    -------
    ndarray, shape (2 (n - 1) sectors, 3, 3)
        Triangle, corner, coordinate [m].
    """
    x, radius = np.asarray(x, dtype=float), np.asarray(radius, dtype=float)
    angle = np.linspace(0.0, 2.0 * np.pi, sectors + 1)
    ring = np.stack([
        np.broadcast_to(x[:, np.newaxis], (len(x), sectors + 1)),
        radius[:, np.newaxis] * np.cos(angle), radius[:, np.newaxis] * np.sin(angle)], axis=-1)
    a, b, c, d = ring[:-1, :-1], ring[1:, :-1], ring[1:, 1:], ring[:-1, 1:]
    return np.stack([np.stack([a, b, c], axis=-2), np.stack([a, c, d], axis=-2)]
                    ).reshape(-1, 3, 3)


def ellipsoid(covariance: ArrayLike, sigmas: float
              ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """
    Return the ellipsoid of `sigmas` standard deviations.

    Parameters
    ----------
    covariance : array_like, shape (3, 3)
        Of the position [m^2].
    sigmas : float
        Half axes in standard deviations.

    Returns
    -------
    ndarray, shape (3,)
        Half axes [m].
    ndarray, shape (4,)
        Unit quaternion (x, y, z, w) that turns the frame's axes into those of the ellipsoid.
    """
    from scipy.spatial.transform import Rotation        # 0.2 s: not while the nodes start
    variance, axes = np.linalg.eigh(np.asarray(covariance, dtype=float))
    if np.linalg.det(axes) < 0.0:
        axes[:, 0] = -axes[:, 0]
    return sigmas * np.sqrt(np.maximum(variance, 0.0)), Rotation.from_matrix(axes).as_quat()
