"""
The corridor's potential field with a fixed band and damping of motion to and from the wall.

Frame, state and force as in `corridor_apf`: this is that law with three of its settings at other
defaults, and no mathematics of its own.
Source  Zhang, Li, Tang 2014, eq. 9: the band l0 in place of the control boundary of eq. 24.
        Ours: damping -l3 (v.n) n in the band on top of eq. 11, n the outward normal of the
        wall, v the velocity. A wall that only pushes returns the speed with which it was met,
        and the chaser then crosses to the other side.
Limits  near docking the band is deeper than the corridor is wide, so there it also centres the
        chaser, at the price of thrust. docs/models/damped_apf.md has the numbers.
"""

from rvd_dynamics.diagram.params import param, settings
from rvd_groundstation.guidance.corridor_apf import CorridorApf


@settings
class DampedApf(CorridorApf):
    """Potential field in a fixed band at the wall, with damping."""

    band_m: float = param(
        0.5, 'Depth of a fixed band at the wall, l0 of eq. 9, where 0 selects the control '
        'boundary instead [m].', low=0.0)
    damping_per_s: float = param(
        0.2, 'Deceleration per unit of speed along the normal of the wall [1/s].', low=0.0)
    damp_return: bool = param(True, 'Whether motion away from the wall is damped as well.')
