"""
Guidance laws: what the automatic controller wants at the predicted state.

`LAWS` lists them by the name a scenario gives. Each is a frozen dataclass of settings with
`uses_stick` (does it look at the pilot's command?) and `wanted(prediction, stick)`, which returns
an acceleration in SI units; the command form makes a command of it. What a law must know besides
its settings (the cone, the orbit, the command form, the sharing) it names as a field made by
`wiring()`, and gets that and nothing else. Add one: one file, one line here.
"""

from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_groundstation.guidance.barrier import Barrier
from rvd_groundstation.guidance.corridor_apf import CorridorApf
from rvd_groundstation.guidance.damped_apf import DampedApf
from rvd_groundstation.guidance.none import NoLaw
from rvd_groundstation.guidance.odrrca import Odrrca
from rvd_groundstation.guidance.safe_approach import SafeApproach


class Law(Protocol):
    """What `LAWS` lists."""

    uses_stick: ClassVar[bool]

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None) -> NDArray[np.float64]:
        """
        Return the acceleration wanted at the instant at which a command sent now will act.

        Parameters
        ----------
        prediction : array_like, shape (..., 6)
            States [m, m/s] at that instant; NaN where unknown.
        stick : array_like, shape (..., 3), or None
            The pilot's command, for laws that use it; None when there is none, and in mode auto,
            where the automatic command goes out as it is.

        Returns
        -------
        ndarray, shape (..., 3)
            Acceleration [m/s^2]. Where the state is unknown it is zero or NaN, and the command
            form makes the neutral command of either.
        """


LAWS = {
    'corridor_apf': CorridorApf,
    'damped_apf': DampedApf,
    'barrier': Barrier,
    'safe_apf': SafeApproach,
    'odrrca': Odrrca,
    'none': NoLaw,
}
