"""
Settings of the nodes that watch: the recorder and the markers.
"""

from dataclasses import dataclass

from rvd_dynamics.diagram.params import param, require


@dataclass(frozen=True)
class RecorderParams:
    """Settings of the recorder."""

    bag_dir: str = param('', 'Directory to make for the bag; must be empty if it exists.')


@dataclass(frozen=True)
class MarkerParams:
    """Settings of the markers for RViz and Foxglove."""

    rate_hz: float = param(10.0, 'Pictures per second of wall time, at most 10 [1/s].')
    trail_points: int = param(200, 'A trail is thinned to at most this many points.')
    ellipsoid_sigma: float = param(2.0, 'Half axes of the ghost in standard deviations.')
    boundary_rate_m_s: float = param(0.25, 'Closing rate the control boundary is drawn for [m/s].')
    show_truth: bool = param(False, 'Draw the true track too, which no one on Earth can see.')

    def __post_init__(self) -> None:
        require(0.1 <= self.rate_hz <= 10.0, 'rate_hz', 'be between 0.1 and 10', self.rate_hz)
        require(2 <= self.trail_points <= 100_000, 'trail_points', 'be between 2 and 100000',
                self.trail_points)
        require(0.0 < self.ellipsoid_sigma <= 10.0, 'ellipsoid_sigma', 'be above 0, up to 10',
                self.ellipsoid_sigma)
        require(0.01 <= self.boundary_rate_m_s <= 10.0, 'boundary_rate_m_s',
                'be between 0.01 and 10', self.boundary_rate_m_s)
