"""
Laws that hold an axis: what acceleration they want, from the errors of the attitude.

`LAWS` lists them by the name a scenario gives. Each is a frozen dataclass of settings that makes a
`Controller`, which has the memory (an integral, a model). Add one: one file, one line here.
"""

from typing import Protocol

from numpy.typing import NDArray

from rvd_missions.attitude_hold.laws.golden_section import GoldenSection
from rvd_missions.attitude_hold.laws.pid import Pid


class Controller(Protocol):
    """A law at work on a batch of runs; arrays have the batch's shape (...)."""

    def wanted(self, errors: tuple[NDArray, NDArray, NDArray], acted: NDArray,
               fresh: NDArray) -> NDArray:
        """
        Return the angular acceleration wanted [rad/s^2].

        Parameters
        ----------
        errors : three ndarrays, each (...)
            Measured attitude minus the present reference [rad] at the newest sample and at the two
            before it; NaN where unknown.
        acted : ndarray (...)
            Nominal acceleration [rad/s^2] of the command that acted between the last two samples.
        fresh : ndarray (...) of bool
            Whether all three samples were measured; one that was lost has been filled in.
        """


class Law(Protocol):
    """What `LAWS` lists."""

    def controller(self, step_s: float, batch: tuple) -> Controller:
        """Return the law with its memory, for a batch of runs sampled every `step_s` seconds."""


LAWS = {'golden_section': GoldenSection, 'pid': Pid}
