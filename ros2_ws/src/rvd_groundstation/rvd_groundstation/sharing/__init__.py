"""
Sharing: how the levels of the pilot and of the automatic controller become one command.

`SHARING` lists the ways of sharing by their names in a scenario; each is a frozen dataclass with
`share(pilot, auto) -> levels` over arrays (..., 3) of whole levels -3..3, and `pilot_weight`.
`decide` adds the modes and the rules for an input that is not valid.
"""

from rvd_groundstation.sharing.decision import decide, Decision
from rvd_groundstation.sharing.eq25 import Eq25
from rvd_groundstation.sharing.filter import StickFilter

SHARING = {'eq25': Eq25, 'filter': StickFilter}

__all__ = ['Decision', 'Eq25', 'SHARING', 'StickFilter', 'decide']
