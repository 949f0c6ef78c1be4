"""
The approach-speed corridor: how fast a craft may be at a distance from its target.

Source  Xu, Zhang, Chinese J. Theor. Appl. Mech. 52(6): the speed at contact is theirs. Both forms
        are reconstructions: linear, v_d + kappa (r - L), and the parabola of braking at a constant
        rate, v_d + sqrt(2 eta a (r - L)); L is the distance at contact.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings


@settings
class SpeedCorridor:
    """Limit of the speed over the distance to the target."""

    form: str = param(
        'none', 'Limit that is kept: none, a linear one, or the parabola of constant braking; with '
        'none, speeds are still held against the linear one.',
        choices=('none', 'linear', 'parabola'))
    contact_speed_m_s: float = param(
        5e-4, 'Speed allowed at contact [m/s].', above=0.0, high=100.0)
    slope_per_s: float = param(
        0.005, 'Speed per metre of distance in the linear form [1/s].', above=0.0, high=100.0)
    braking_m_s2: float = param(
        0.01, 'Deceleration of the thrusters in the parabola [m/s^2].', above=0.0, high=1000.0)
    braking_share: float = param(
        0.05, 'Share of that deceleration which the parabola counts on.', above=0.0, high=1.0)

    @property
    def kept(self) -> bool:
        """Whether a law is to keep it."""
        return self.form != 'none'

    def limit(self, gap: ArrayLike) -> NDArray[np.float64]:
        """
        Return the largest speed [m/s] at gaps (...) [m]; that at contact where one is negative.
        """
        gap = np.maximum(gap, 0.0)
        if self.form == 'parabola':
            return self.contact_speed_m_s + np.sqrt(
                2.0 * self.braking_share * self.braking_m_s2 * gap)
        return self.contact_speed_m_s + self.slope_per_s * gap
