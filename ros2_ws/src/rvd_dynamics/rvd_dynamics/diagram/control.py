"""
Control of a run under way: the mode, and an abort.

In a graph it comes from the service `/run/control`; in one process from a schedule.
"""

from dataclasses import dataclass
from typing import NamedTuple

MODE_EVENT, MODE_WORDS = 'MODE', 'mode '   # code of the event of a new mode; before its name


class Control(NamedTuple):
    """What is in force in a step; one block of a diagram gets it."""

    mode: str = ''                      # empty where the mission has no modes
    abort: bool = False
    next_mode: str = ''                 # mode of the next step, for who must tell other blocks


@dataclass(frozen=True)
class Change:
    """A change of control that takes effect in `step`."""

    step: int
    mode: str = ''                      # empty: as before
    abort: bool = False
