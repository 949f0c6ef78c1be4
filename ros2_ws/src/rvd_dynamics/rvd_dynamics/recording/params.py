"""
Settings of the two nodes that only look on: the recorder and the markers.
"""

from dataclasses import dataclass

from rvd_dynamics.params import param


@dataclass(frozen=True)
class RecorderParams:
    """Settings of `bag_recorder`."""

    bag_dir: str = param('bag', 'Folder of the bag; must not exist yet.')


@dataclass(frozen=True)
class MarkerParams:
    """Settings of `markers`."""

    show_truth: bool = param(False, 'Draw the true motion too, which no pilot sees.')
