"""
Guidance laws: what the automatic controller wants at the predicted state.

`LAWS` lists them by their names in a scenario. Each is a frozen dataclass: `mission` first,
then its settings, `uses_stick` (whether it looks at the pilot's levels) and
`levels(prediction, stick_levels) -> levels`. A law that must know what becomes of its levels
has a field `sharing`, which it is given with the mission. To add a law: one file, one line here.
"""

from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.mission import Mission
from rvd_groundstation.guidance.barrier import Barrier
from rvd_groundstation.guidance.corridor_apf import CorridorApf
from rvd_groundstation.guidance.damped_apf import DampedApf
from rvd_groundstation.guidance.none import NoLaw


class Law(Protocol):
    """What `LAWS` lists."""

    mission: Mission
    uses_stick: ClassVar[bool]

    def levels(self, prediction: ArrayLike, stick_levels: ArrayLike | None) -> NDArray[np.int8]:
        """
        Return levels -3..3 for states at the instant at which a command sent now will act.

        Parameters
        ----------
        prediction : array_like, shape (..., 6)
            States [m, m/s]; an unknown one (NaN) gives level 0.
        stick_levels : array_like of int, shape (..., 3), or None
            The pilot's levels, for laws that use them; None if there is no valid stick.

        Returns
        -------
        ndarray of int8, shape (..., 3)
        """


LAWS = {
    'corridor_apf': CorridorApf,
    'damped_apf': DampedApf,
    'barrier': Barrier,
    'none': NoLaw,
}
