"""
A recorded run: of a bag (`reader.read`) or of an in-process flight (`history.of_history`).

Figures and reports are functions of it and cannot tell which of the two it came from.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.block import GROUND
from rvd_dynamics.diagram.judge import Judgement
from rvd_dynamics.diagram.scenario import parse_known, Scenario
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.recording.series import Frames, LinkHistory, Series, SERIES, Table

LINK_STATUS = 'rvd_interfaces/msg/LinkStatus'
UNKNOWN = float('nan')


@dataclass(frozen=True)
class Event:
    """One event of the run."""

    step: int
    t: float                                    # [s]
    node: str
    code: str
    text: str


@dataclass(frozen=True)
class Link:
    """One direction of the link: what came out of it, and what it counted."""

    name: str                                   # 'forward'
    frames: Frames                              # released, a row per step
    history: LinkHistory
    hold_s: float                               # [s] constant delay; NaN where it is unknown
    step_s: float                               # [s] base step of the run; NaN likewise
    upward: bool | None = None                  # from the ground to the spacecraft

    @property
    def title(self) -> str:
        """Name and direction, for people."""
        words = {True: ' (to the spacecraft)', False: ' (to the ground)', None: ''}
        return f'{self.name.capitalize()} link{words[self.upward]}'

    @property
    def never_released(self) -> NDArray[np.float64]:
        """When the frames were sent [s] in whose place an empty one came out."""
        sent = self.frames.step[self.frames.empty] * self.step_s - self.hold_s
        return sent[sent > -0.5 * self.step_s]


@dataclass(frozen=True)
class Recording:
    """One run. Series have no rows where nothing was recorded."""

    path: Path | None                           # of the bag
    scenario_text: str                          # as flown; empty if it is not known
    scenario: Scenario | None                   # None: no text, or none that can be read here
    scenario_trouble: str                       # why there is none, or what of it was left out
    series: Mapping[str, Series]                # by topic
    kinds: Mapping[str, str]                    # topic -> message type, of all topics
    verdict: Judgement | None                   # the last one
    judged: bool                                # and it is the final one
    events: tuple[Event, ...]
    last_step: int                              # last step in the bag, -1 if none
    ended: bool                                 # the run came to its end within the bag
    complete: bool                              # the file has its end
    closed: bool                                # the recorder closed it, too
    trouble: str                                # what went wrong for the recorder first
    counts: dict[str, int]                      # topic -> messages in the bag
    missing: dict[str, int]                     # topic -> firings of the run not in the bag
    lost: dict[str, int] = field(default_factory=dict)  # topic -> received, but not stored
    damage: tuple[str, ...] = ()                # what of the bag cannot be read, as sentences

    def of(self, signal: Signal | str) -> Any:
        """
        Return the series of a signal, without rows where nothing of it was recorded.

        Parameters
        ----------
        signal : Signal or str
            A topic alone also finds what is no signal of a diagram; where neither recording nor
            scenario knows it, the empty series is a `Table`.
        """
        topic, kind = (signal.name, signal.message) if isinstance(signal, Signal) else (signal, '')
        recorded = self.kinds.get(topic)
        if recorded in SERIES and kind in ('', recorded) and topic in self.series:
            return self.series[topic]
        if not kind and self.scenario is not None and topic in self.scenario.diagram.signals:
            kind = self.scenario.diagram.signals[topic].message
        return SERIES.get(kind or recorded, Table).of([])

    def has(self, topic: str) -> bool:
        """Say whether anything of a topic was recorded."""
        return len(self.of(topic)) > 0

    @cached_property
    def links(self) -> dict[str, Link]:
        """The legs of the link by name, the way up first."""
        if self.scenario is None:               # all that is known is what they counted
            found = [Link(topic.rpartition('/')[0].rpartition('/')[2] or topic, Frames.of([]),
                          self.of(topic), UNKNOWN, UNKNOWN)
                     for topic, kind in self.kinds.items() if kind == LINK_STATUS]
        else:
            found = [self._link(leg) for leg in self.scenario.diagram.legs()]
        return {link.name: link for link in sorted(found, key=lambda link: not link.upward)}

    def _link(self, leg: Any) -> Link:
        diagram, step_s = self.scenario.diagram, self.scenario.run.step_s
        sender = diagram.writer_of[leg.reads['content'].signal.name]
        counted = LinkHistory.of([]) if leg.status is None else self.of(leg.status)
        return Link(leg.name.removeprefix('link_'), self.of(leg.writes['arrival']), counted,
                    leg.draws['chance'].hold_steps * step_s, step_s, sender.segment == GROUND)

    @property
    def name(self) -> str:
        """Name of the scenario; empty if it is not known."""
        return name_of(self.scenario_text)


def name_of(text: str) -> str:
    """Return the name of the scenario that `Scenario.dump` wrote into its first line."""
    found = re.match(r'# Scenario (.+) as flown', text)
    return found[1] if found else ''


def scenario_of(text: str) -> tuple[Scenario | None, str]:
    """
    Return the scenario of a recorded text, and what to say about it.

    Keys that this version does not know are left out and named. A text that cannot be read, or
    whose mission is not installed, gives None and the reason.
    """
    if not text:
        return None, 'the bag holds no scenario'
    try:
        scenario, unknown = parse_known(text, name_of(text) or 'of the bag')
        scenario.diagram                        # what breaks a rule is found out here
    except BadInput as error:
        return None, str(error)
    return scenario, f'this version does not know {", ".join(unknown)}' if unknown else ''
