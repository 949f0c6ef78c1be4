"""
How round markers look in an image: what the camera renders, and what the craft knows of them.
"""

from rvd_dynamics.diagram.params import param, settings


@settings
class RenderingParams:
    """How markers look in an image, and which blobs count."""

    big_radius_m: float = param(0.010, 'Radius of a big marker [m].', above=0.0, high=1.0)
    small_radius_m: float = param(0.00125, 'Radius of a small marker [m].', above=0.0, high=1.0)
    background: float = param(20.0, 'Grey level of the target.', low=0.0, high=255.0)
    marker: float = param(200.0, 'Grey level of a marker.', low=0.0, high=255.0)
    blur_px: float = param(0.7, 'Standard deviation of the blur [px].', above=0.0, high=10.0)
    noise: float = param(2.0, 'Standard deviation of the noise of a pixel [grey levels].', low=0.0,
                         high=100.0)
    threshold: float = param(70.0, 'Grey level above which a pixel belongs to a blob.', low=0.0,
                             high=255.0)
    least_px: int = param(6, 'Least number of pixels of a blob.', low=1, high=10000)
