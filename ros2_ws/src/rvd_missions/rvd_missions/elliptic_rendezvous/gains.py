"""
One case of the direction-angle equation, and what its gains must be.

Source  Yu, Yang 1998: k, k1, k2, q and phi_d are the paper's names, kept here.
"""

from math import radians

from rvd_dynamics.diagram.params import param, require, settings
from rvd_groundstation.guidance.range_rate import check_gains, FEED_FORWARDS, FORMS


@settings
class CycleCase:
    """
    One case of the direction-angle equation; the keys are the options of the command.

    `law` odrrca has the transverse thruster, and q, q1, phi_d and ff with it; for rrca they do
    not count.
    """

    law: str = param('rrca', 'Law: rrca thrusts along the line of sight, odrrca across, too.',
                     choices=('rrca', 'odrrca'))
    form: str = param('r1', 'Form of the reference range rate.', choices=FORMS)
    e: float = param(0.1, 'Eccentricity of the target orbit.')
    k: float = param(-0.5, 'Gain of the range rate: the range follows exp(k nu).')
    k1: float = param(1.0, 'Gain of the direction rate in the range rate.')
    k2: float = param(0.0, 'Gain of the orbit\'s angular acceleration in the range rate.')
    q: float = param(10.0, 'Stiffness of the transverse thruster.', above=0.0)
    q1: float = param(0.0, 'Damping of the transverse thruster.', low=0.0)
    phi_d_deg: float = param(-90.0, 'Direction wanted, from radial-out along the orbit [deg].')
    ff: str = param('off', 'Feed-forward of the transverse thruster: off, on (gravity and k), or '
                    'full (also the orbit\'s angular acceleration).', choices=FEED_FORWARDS)

    def __post_init__(self) -> None:
        require(self.e >= 0.0, 'e', 'not be negative: it is an eccentricity', self.e)
        require(self.e < 1.0, 'e', 'be below 1: an orbit of eccentricity 1 or more never returns',
                self.e)
        check_gains(self.form, self.k, self.k1, self.q1 if self.law == 'odrrca' else 0.0)

    @property
    def phi_d(self) -> float:
        """Direction wanted [rad]."""
        return radians(self.phi_d_deg)
