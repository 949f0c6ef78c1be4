"""
Settings of the nodes that watch: the recorder and the markers.
"""

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.geometry.cone import SLOWEST_RATE


@settings
class RecorderParams:
    """Settings of the recorder."""

    bag_dir: str = param('', 'Directory of the bag, which must not exist yet or be empty.')


@settings
class MarkerParams:
    """Settings of the markers for RViz and Foxglove."""

    rate_hz: float = param(
        10.0, 'Number of pictures per second of wall time [Hz].', low=0.1, high=10.0)
    trail_points: int = param(
        200, 'Number of points to which a trail is thinned.', low=2, high=100_000)
    ellipsoid_sigma: float = param(
        2.0, 'Half axes of the uncertainty ellipsoid, in standard deviations.',
        above=0.0, high=10.0)
    boundary_rate_m_s: float = param(
        0.0, 'Closing rate for which the control boundary is drawn, where 0 selects that of the '
        'law or the start [m/s].', low=0.0, high=10.0)
    show_truth: bool = param(
        False, 'Whether to draw the true track, which nobody on the ground could see.')

    def __post_init__(self) -> None:
        require(not 0.0 < self.boundary_rate_m_s < SLOWEST_RATE, 'boundary_rate_m_s',
                f'be 0 or at least {SLOWEST_RATE:g}', self.boundary_rate_m_s)
