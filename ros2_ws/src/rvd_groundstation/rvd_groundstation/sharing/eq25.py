"""
Weighted blending of two level commands, rounded away from zero, in exact arithmetic.

Inputs  levels -3..3 of the pilot and of the automatic controller; each axis is blended alone.
Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, eq. 25: U = <eta U_man + (1 - eta) U_auto>,
        <m> = sign(m) ceil|m|, eta = 0.7.
        In floating point 12 of the 4949 cells of a 0.01 grid of eta come out wrong, and level 4
        appears at eta = 0.2. So eta = p/q is taken as the decimal that was written, and
        e = p man + (q - p) auto is rounded in whole numbers: sign(e) ((|e| + q - 1) // q).
"""

from decimal import Decimal
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings

ROUNDINGS = ('away', 'truncate')
LEVELS = range(-3, 4)


@settings
class Eq25:
    """Blend with the weight `eta` of the pilot (eq. 25)."""

    eta: float = param(
        0.7, 'Weight of the pilot, taken as the exact decimal as written.', low=0.0, high=1.0)
    rounding: str = param(
        'away', 'Rounding of the blend: away from zero as in eq. 25, or, for study, truncate '
        'towards zero.', choices=ROUNDINGS)

    @property
    def pilot_weight(self) -> float:
        """Weight of the pilot, for display."""
        return float(self.eta)

    def share(self, pilot: ArrayLike, auto: ArrayLike) -> NDArray[np.int8]:
        """
        Blend two commands.

        Parameters
        ----------
        pilot, auto : array_like of whole numbers -3..3, shape (..., 3)
            Levels; `decide` has checked the range.

        Returns
        -------
        ndarray of int8, shape (..., 3)
        """
        # transposed there and back: in a batch the components come first in memory
        return self._table.take((7*np.add(pilot, 3) + np.add(auto, 3)).T).T

    @cached_property
    def _table(self) -> NDArray[np.int8]:
        # 49 cells in Python's integers: exact for any number of decimals, and one look-up a step.
        eta = exact_fraction(self.eta)
        p, q = eta.numerator, eta.denominator
        up = q - 1 if self.rounding == 'away' else 0
        cells = [[blend(p*man + (q - p)*auto, q, up) for auto in LEVELS] for man in LEVELS]
        return np.array(cells, dtype=np.int8).ravel()


def blend(e: int, q: int, up: int) -> int:
    """Return e / q rounded: away from zero with `up` = q - 1, towards it with 0."""
    size = (abs(e) + up) // q
    return size if e > 0 else -size


def exact_fraction(value: float | Decimal) -> Fraction:
    """Return the fraction that a decimal means as written: 0.7 is 7/10, not the nearest binary."""
    return Fraction(Decimal(str(value)))
