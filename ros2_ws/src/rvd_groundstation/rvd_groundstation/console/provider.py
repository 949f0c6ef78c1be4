"""
What a mission tells the console: how it is displayed, and what is derived for the page.

A mission subclasses `MissionDisplay` and overrides what applies to it. Everything here runs on
the ground: it sees what came down the link and nothing else.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rvd_dynamics.diagram.display import Display
from rvd_dynamics.mission import Mission
from rvd_groundstation.console.decode import Sample


@dataclass(frozen=True)
class RunFacts:
    """What a page is told of a run once: its time grid, its delays, how it is flown."""

    step_ns: int                # base step
    forward_steps: int          # delay of the forward link
    back_steps: int             # of the back link
    timeout_s: float = 0.0      # the run ends at the latest then
    mode: str = 'auto'          # at the start
    operator: str = 'none'
    seed: int = 0
    pace: float = 1.0           # simulated seconds per second of wall time

    @property
    def last_step(self) -> int:
        """First step at or after the time limit: no run is longer."""
        return -(-round(self.timeout_s * 1e9) // self.step_ns)

    @property
    def step_s(self) -> float:
        """Base step [s]."""
        return self.step_ns / 1e9

    @property
    def forward_s(self) -> float:
        """Delay of the forward link [s]."""
        return self.forward_steps * self.step_ns / 1e9

    @property
    def back_s(self) -> float:
        """Delay of the back link [s]."""
        return self.back_steps * self.step_ns / 1e9


class MissionDisplay:
    """The display of one run, and what goes with it; this one derives nothing."""

    # Nodes whose events a page hears: those on the ground. What the craft or the judge says has
    # not come down the link.
    heard_nodes: tuple[str, ...] = ('console',)
    # Signals that `derive` reads although they are not displayed.
    derives_from: tuple[str, ...] = ()

    def __init__(self, facts: RunFacts, display: Display) -> None:
        self.facts, self.display = facts, display

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """
        Return the parts of the signal `derived`: numbers, points, rows of points, words.

        `newest` holds the newest sample of each signal. Called once for each new frame, so it
        may take some tenths of a millisecond; what is unknown is None.
        """
        return {}

    def joy(self, deflection: Sequence[float], held: bool
            ) -> tuple[list[float], list[int]] | None:
        """Return axes and buttons of the Joy for a stick; None: nothing is to be said."""
        controller = self.display.controller
        if controller is None:
            return None
        return [float(a) for a in deflection[:len(controller.axes)]], [int(held)]

    def pilot(self, axes: Sequence[float], buttons: Sequence[int]) -> tuple[list[float], bool]:
        """Return the command that a Joy means, and whether it is valid."""
        shown = self.display.commands.axes
        if len(axes) < len(shown) or not all(-1.0 <= a <= 1.0 for a in axes) or not any(buttons):
            return [0.0] * len(shown), False
        return [axis.highest * a for axis, a in zip(shown, axes)], True

    def verdict(self, message: Any) -> dict[str, Any]:
        """Return a final Verdict as the page shows it: see `verdict_of`."""
        return verdict_of(message, self.display)


def verdict_of(message: Any, display: Display, measures: Sequence[dict[str, Any]] = ()
               ) -> dict[str, Any]:
    """
    Return a final Verdict as the page shows it.

    `measures` are rows {name, words, unit, value, low, high, ok, digits}; a value or a limit
    that is not there, or an `ok` that nobody judged, is None.
    """
    return {'success': bool(message.success), 'reason': message.reason,
            'words': words_of(message.reason, display), 'duration': message.duration,
            'measures': list(measures)}


def words_of(reason: str, display: Display) -> str:
    """Return the words for a reason of the judge."""
    known = display.reasons or {}
    return known.get(reason) or reason.replace('_', ' ').capitalize()


def display_of(mission: Mission) -> MissionDisplay:
    """Return what the mission of a scenario tells the console."""
    from rvd_groundstation.console.lunar_display import LunarDisplay
    return LunarDisplay(mission)
