"""
A recorded run as arrays, read from its bag alone; no ROS needed.

A bag that was cut off (kill -9, full disk, broken copy) is read as far as it goes; `Recording`
then says so, and how many messages of which topic are missing.
"""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.judge import from_message
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording.messages import files_of, MessageFile, stamp_ns, Stored
from rvd_dynamics.recording.recording import Event, Recording, scenario_of
from rvd_dynamics.recording.series import Series, SERIES
from rvd_dynamics.recording.steps import HEADER_THEN_STEP, STAMP_FIRST, STEP_FIRST, step_reader

CARRY_A_STEP = HEADER_THEN_STEP | STEP_FIRST
STORY = ('/run/scenario', '/run/verdict', '/run/events', '/run/end')


def read(path: Path) -> Recording:
    """
    Read a run from its bag: a run folder, a bag folder or an MCAP file.

    Messages are decoded when somebody asks for their series.

    Raises
    ------
    ValueError
        If there is no bag, or a message cannot be decoded. A bag that was cut off is no error.
    """
    bag = _Bag(files_of(path))
    scenarios, verdicts, events, ends = (bag.decoded(topic) for topic in STORY)
    text = scenarios[-1].data if scenarios else ''
    scenario, trouble = scenario_of(text)
    noted = bag.notes.get('rvd_missing')
    owed = _owed(scenario, noted)
    steps = {topic: bag.steps(topic, scenario) for topic in (owed or bag.stored)}
    last_step = int(ends[-1].data) if ends else max(
        (int(s.max()) for s in steps.values() if len(s)), default=-1)
    lost = {topic: int(n) for topic, n in bag.notes.get('rvd_lost', {}).items()}
    notes = bag.notes.get('rvd_recording', {})
    noted_step = notes.get('last_step', '')     # which the recorder knows, and has not heard
    flown = max(last_step, int(noted_step) if noted_step.isdecimal() else -1)
    return Recording(
        path=path, scenario_text=text, scenario=scenario, scenario_trouble=trouble,
        series=_Decoded(bag), kinds=bag.kinds,
        verdict=from_message(verdicts[-1]) if verdicts else None,
        judged=bool(verdicts and verdicts[-1].final),
        events=tuple(Event(m.step, stamp_ns(m.header.stamp) / NS_PER_S, m.node, m.code, m.text)
                     for m in events),
        last_step=last_step, ended=bool(ends), complete=bag.complete,
        closed=bag.complete and notes.get('closed') != 'false',
        trouble=notes.get('trouble', ''), counts=bag.counts,
        missing={topic: _missing(steps[topic], period, flown)
                 for topic, period in owed.items()} if scenario is not None else
        {topic: int(n) + lost.get(topic, 0) for topic, n in (noted or {}).items()},
        lost=lost)


def newest(path: Path, topics: Iterable[str]) -> dict[str, Any]:
    """
    Return the last message of each of `topics` in a bag, decoded; None where it has none.

    Raises
    ------
    ValueError
        If there is no bag.
    """
    found: dict[str, Any] = dict.fromkeys(topics)
    for file in files_of(path):
        last: dict[str, Stored] = {stored.topic: stored for stored in MessageFile(file, found)}
        found.update((topic, stored.message) for topic, stored in last.items())
    return found


def _owed(scenario: Scenario | None, noted: Mapping[str, str] | None) -> dict[str, int]:
    """
    Return the topics that should have a message at each firing, with their period [steps].

    The recorder's notes name them; where it had no time to write notes, they are those of a run
    in which every node takes part.
    """
    if scenario is None:
        return {}
    owed = Roster(scenario).owed
    return owed if noted is None else {topic: owed.get(topic, 1) for topic in noted}


def _missing(steps: NDArray[np.int64], period: int, last_step: int) -> int:
    """Return how many firings up to the last step are not among the recorded ones."""
    return last_step // period + 1 - len(np.unique(steps[steps <= last_step]))


class _Bag:
    """Messages by topic, in file order and serialised: few of them are ever looked at."""

    def __init__(self, files: Iterable[Path]) -> None:
        self.stored: dict[str, list[Stored]] = {}
        self.kinds: dict[str, str] = {}
        self.counts: dict[str, int] = {}
        self.notes: dict[str, dict[str, str]] = {}
        self.complete = True
        for file in files:
            self._take(file)

    def _take(self, file: Path) -> None:
        content = MessageFile(file)
        for stored in content:
            kind = stored.source.kind
            if kind in SERIES or kind in STAMP_FIRST or stored.topic in STORY:
                self.stored.setdefault(stored.topic, []).append(stored)
        for source in content.sources:
            self.kinds[source.topic] = source.kind
            self.counts[source.topic] = self.counts.get(source.topic, 0) + source.count
        self.notes.update(content.notes)
        self.complete = self.complete and content.complete

    def decoded(self, topic: str) -> list[Any]:
        """Return the messages of a topic; ValueError if one cannot be decoded."""
        return [stored.message for stored in self.stored.get(topic, ())]

    def steps(self, topic: str, scenario: Scenario | None) -> NDArray[np.int64]:
        """Return the steps of the messages of a topic, as far as they can be known."""
        kind, reader = self.kinds.get(topic, ''), None
        if scenario is not None:
            reader = step_reader(kind, scenario.run.step_ns)
        elif kind in CARRY_A_STEP:
            reader = step_reader(kind, 1)
        stored = self.stored.get(topic, ()) if reader is not None else ()
        return np.array([reader(message.data) for message in stored], dtype=np.int64)


class _Decoded(Mapping):
    """The series of a bag by topic; each is made when somebody looks at it first."""

    def __init__(self, bag: _Bag) -> None:
        self._bag = bag
        self._topics = [topic for topic in bag.stored if bag.kinds[topic] in SERIES]
        self._made: dict[str, Series] = {}

    def __getitem__(self, topic: str) -> Series:
        if topic not in self._topics:
            raise KeyError(topic)
        if topic not in self._made:
            kind = SERIES[self._bag.kinds[topic]]
            try:
                self._made[topic] = kind.of(self._bag.decoded(topic))
            except BadInput as error:
                raise BadInput(f'{topic}: {error}') from None
        return self._made[topic]

    def __iter__(self) -> Iterator[str]:
        return iter(self._topics)

    def __len__(self) -> int:
        return len(self._topics)
