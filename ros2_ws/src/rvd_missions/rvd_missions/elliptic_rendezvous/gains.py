"""
The gains of range-rate control, and what they must be.

Source  Yu, Yang 1998: k, k1, k2, q and phi_d are the paper's names, kept here.
"""

from math import radians

from rvd_dynamics.diagram.params import param, require, settings

FORMS = ('r1', 'r2', 'r4')
FEED_FORWARDS = ('off', 'on', 'full')


def check_gains(form: str, k: float, k1: float, q1: float = 0.0) -> None:
    """
    Refuse gains with which no approach can be steady.

    The damping of the direction angle, averaged over an orbit, is 2 (k + k1) + q1 in form R1 and
    2 k1 + q1 in R2 and R4: by Liouville's theorem the map over one orbit contracts areas by
    exp(-2 pi) to that power.

    Raises
    ------
    Impossible
        Names the gain, its bound and why.
    """
    require(k <= 0.0, 'k', 'not be positive: the range follows exp(k nu), and the chaser would '
            'leave', k)
    least = (-k if form == 'r1' else 0.0) - q1/2
    why = '-k' if form == 'r1' else '0'
    less = ' - q1/2' if q1 else ''
    require(k1 > least, 'k1', f'be above {why}{less} = {least:g}: below, form {form.upper()} does '
            'not damp the direction angle over an orbit', k1)


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
