"""
The start of a run: how long `fly` waits for it, and what it says of it meanwhile.

A graph that has not made a step in `START_S` does not come up. Loops that are compiled, at the
first use on a machine, are no part of that: with other work about they take minutes.
"""

import time
from typing import Any

from rvd_campaign.flight.vigil import Vigil
from rvd_dynamics.diagram.roster import Roster

# [s] wall time for the graph to come up, besides what is compiled; in real time a rehearsal comes
# before
START_S = {'lockstep': 60.0, 'realtime': 180.0}
TOLD_S = 2.0                    # [s] wall time of compiling that is told
COMPILING = ('loops are compiled, which is done once on a machine and may take some minutes')


class Starting:
    """The start of one run; `look` again and again until its first step."""

    def __init__(self, roster: Roster, domain: int, vigil: Vigil) -> None:
        self._roster, self._domain, self._vigil = roster, domain, vigil
        self._start_s = START_S[roster.scenario.run.pace]
        self._looked = time.monotonic()
        self._waited = self._compiled = 0.0     # [s] wall time, without that in which ours stood
        self._told = False
        self.who: list[str] = []                # processes that compile

    def look(self, watch: Any, stopped_s: float) -> str | None:
        """
        Return the sentence that says why the graph did not come up, once it takes too long.

        Parameters
        ----------
        watch : FlightWatch
        stopped_s : float
            Wall time since the last look for which this process was stopped [s].
        """
        now = time.monotonic()
        passed, self._looked = now - self._looked - stopped_s, now
        self.who = self._vigil.compiling()
        if self.who:
            self._compiled += passed
        else:
            self._waited += passed
        return self._why(watch) if self._waited > self._start_s else None

    def news(self) -> str:
        """Return what is to be told of the start, once; empty where there is nothing."""
        if self._told or self._compiled < TOLD_S:
            return ''
        self._told = True
        return f'{COMPILING}: {", ".join(self.who)}'

    def line(self, ready: int) -> str:
        """Return one line of progress; `ready`: how many nodes are."""
        return f'starting: {self.progress(ready)}'

    def progress(self, ready: int) -> str:
        """Return the progress in words; `ready`: how many nodes are."""
        compiling = f'; loops are compiled: {", ".join(self.who)}' if self.who else ''
        return f'{ready} of {len(self._roster.names)} nodes ready{compiling}'

    def _why(self, watch: Any) -> str:
        words = f'the graph did not come up in {self._start_s:g} s'
        if self._compiled >= TOLD_S:
            words += f', and {self._compiled:.0f} s in which loops were compiled'
        foreign = [e for e in self._roster.diagram.externals if e.foreign]
        silent = [topic for e in foreign for topic in e.writes if not watch.is_written(topic)]
        if silent:
            return (f'{words}: nobody publishes {", ".join(silent)} with '
                    f'ROS_DOMAIN_ID={self._domain}: start its driver')
        waiting = sorted(set(self._roster.names) - watch.ready - {e.name for e in foreign})
        return f'{words}: not ready: {", ".join(waiting) or self._roster.diagram.plant}'
