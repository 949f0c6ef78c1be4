"""
The delays of the link, none unless a scenario says otherwise, as in the source.
"""

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import LegParams


@settings
class NoDelay(LegParams):
    """Delays of the two legs of the link, after their play-out buffers."""

    forward_delay_s: float = param(
        0.0, 'Constant delay of the forward link [s].', low=0.0, high=3600.0)
    back_delay_s: float = param(
        0.0, 'Constant delay of the back link [s].', low=0.0, high=3600.0)
