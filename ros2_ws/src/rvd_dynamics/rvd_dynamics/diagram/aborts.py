"""
Whether an ABORT that somebody asked for was in force before a run ended.

Asked for   by whoever controls the run (`/run/control`, in one process the schedule): the block
            that obeys says so on `/run/events` (ABORT). What a craft does by itself to keep out of
            danger is the mission's own, also where it looks the same on board.
In force    what shows it on board (`Diagram.abort_shown`, the guard's command in most missions)
            does so in each step to the end of the run. What is commanded in step k acts on
            [k, k+1), so that of the final step acts on nothing.
"""

import math

ABORT_EVENT = 'ABORT'           # code of the event


class Aborts:
    """Follows one run; what is said and what shows may come in any order."""

    def __init__(self, step_s: float) -> None:
        self._step_s = step_s
        self._asked: int | None = None          # step in which an ABORT was asked for first
        self._shown: int | None = None          # first step in which one showed on board

    @property
    def asked(self) -> bool:
        """Whether an ABORT has been asked for."""
        return self._asked is not None

    @property
    def awaited(self) -> bool:
        """Whether one has been asked for that has not shown on board."""
        return self.asked and self._shown is None

    def event(self, step: int, code: str) -> None:
        """Take an event of the run."""
        if code == ABORT_EVENT and (self._asked is None or step < self._asked):
            self._asked = step

    def board(self, step: int, shows: bool) -> None:
        """Take whether it showed on board in a step."""
        if shows and (self._shown is None or step < self._shown):
            self._shown = step

    def since(self, final_step: int) -> float:
        """Return from when one was in force [s]; NaN if the run ended before, or none was."""
        if self._asked is None or self._shown is None:
            return math.nan
        step = max(self._asked, self._shown)
        return step*self._step_s if step < final_step else math.nan
