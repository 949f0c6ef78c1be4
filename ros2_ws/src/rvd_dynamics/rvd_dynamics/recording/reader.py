"""
A recorded run as arrays, read from its bag alone; no ROS needed.

A bag that was cut off (kill -9, full disk, broken copy) is read as far as it goes; `Recording`
then says so, and how many messages of which topic are missing. Of one that is damaged, or made to
do harm, what can be read is read, and `Recording.damage` says what cannot.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.judge import from_message, Judged, Judgement
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording.limits import MAX_HELD
from rvd_dynamics.recording.mcap_records import last_time
from rvd_dynamics.recording.messages import files_of, MessageFile, stamp_ns, Stored
from rvd_dynamics.recording.recording import Event, Recording, scenario_of
from rvd_dynamics.recording.series import Series, SERIES
from rvd_dynamics.recording.steps import HEADER_THEN_STEP, STAMP_FIRST, STEP_FIRST, step_reader

CARRY_A_STEP = HEADER_THEN_STEP | STEP_FIRST
STORY = {'/run/scenario': 'std_msgs/msg/String', '/run/verdict': 'rvd_interfaces/msg/Verdict',
         '/run/events': 'rvd_interfaces/msg/RunEvent', '/run/end': 'std_msgs/msg/UInt64'}
LARGEST_STEP = 2**53            # a float still knows it from the next one
BEYOND = 1000                   # [steps] after the last one of a scenario that are no damage yet
OVERHEAD = 200                  # [B] of memory that a message takes besides its bytes
HOPELESS = 100                  # messages of a topic that cannot be decoded, and none that can
NO_MESSAGE = (AttributeError, TypeError, ValueError, OverflowError, LookupError)


def read(path: Path) -> Recording:
    """
    Read a run from its bag: a run folder, a bag folder or an MCAP file.

    Messages are decoded when somebody asks for their series.

    Raises
    ------
    ValueError
        If there is no bag, or none that can be opened. A bag that was cut off or damaged is no
        error.
    """
    bag = _Bag(files_of(path))
    texts, verdicts, events, ends = (bag.story(topic, what) for topic, what in (
        ('/run/scenario', lambda m: _text(m.data)), ('/run/verdict', _verdict),
        ('/run/events', _event), ('/run/end', lambda m: _step(m.data))))
    text = texts[-1] if texts else ''
    scenario, trouble = scenario_of(text)
    bag.latest = LARGEST_STEP if scenario is None else scenario.run.last_step + BEYOND
    ends = [step for step in ends if step <= bag.latest]
    noted = bag.notes.get('rvd_missing')
    owed = _owed(scenario, noted)
    steps = {topic: bag.steps(topic, scenario) for topic in (owed or bag.stored)}
    last_step = ends[-1] if ends else max(
        (int(s.max()) for s in steps.values() if len(s)), default=-1)
    lost = _counts(bag.notes.get('rvd_lost', {}))
    notes = bag.notes.get('rvd_recording', {})
    noted_step = notes.get('last_step', '')     # which the recorder knows, and has not heard
    flown = max(last_step, int(noted_step) if noted_step.isdecimal() else -1)
    return Recording(
        path=path, scenario_text=text, scenario=scenario, scenario_trouble=trouble,
        series=_Decoded(bag), kinds=bag.kinds,
        verdict=verdicts[-1][0] if verdicts else None,
        judged=bool(verdicts and verdicts[-1][1]),
        events=tuple(event for event in events if event.step <= bag.latest),
        last_step=last_step, ended=bool(ends), complete=bag.complete,
        closed=bag.complete and notes.get('closed') != 'false',
        trouble=notes.get('trouble', ''), counts=bag.counts,
        missing={topic: _missing(steps[topic], period, flown)
                 for topic, period in owed.items()} if scenario is not None else
        {topic: n + lost.get(topic, 0) for topic, n in _counts(noted or {}).items()},
        lost=lost, damage=tuple(bag.said()))


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


def _counts(noted: Mapping[str, str]) -> dict[str, int]:
    """Return counts that a bag notes by topic; what is no number counts as none."""
    return {topic: int(n) for topic, n in noted.items()
            if n.isascii() and n.isdecimal() and len(n) < 16}


# -- what a message of the story says; of made-up ones one of NO_MESSAGE ---------------------------

def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError('no text')
    return value


def _step(value: Any) -> int:
    if not isinstance(value, int) or not 0 <= value <= LARGEST_STEP:
        raise ValueError(f'{value} is no step')
    return value


def _event(m: Any) -> Event:
    return Event(_step(m.step), stamp_ns(m.header.stamp) / NS_PER_S, _text(m.node), _text(m.code),
                 _text(m.text))


def _verdict(m: Any) -> tuple[Judgement, bool]:
    """Return a verdict, and whether it is final."""
    judged = from_message(m)
    return judged._replace(
        success=bool(judged.success), reason=_text(judged.reason), words=_text(judged.words),
        duration=float(judged.duration),
        measures=tuple(Judged(_text(j.name), _text(j.words), _text(j.unit), float(j.value),
                              float(j.low), float(j.high), bool(j.ok), int(j.digits))
                       for j in judged.measures)), bool(m.final)


class _Bag:
    """Messages by topic, in file order and serialised: few of them are ever looked at."""

    def __init__(self, files: list[Path]) -> None:
        self.stored: dict[str, list[Stored]] = {}
        self.kinds: dict[str, str] = {}
        self.counts: dict[str, int] = {}
        self.notes: dict[str, dict[str, str]] = {}
        self.complete = True
        self.latest = LARGEST_STEP              # step that a message may be of
        self._damage: list[str] = []
        self._held = 0                          # [B] of messages in memory
        self._left_out: dict[str, tuple[int, str]] = {}     # topic -> how many, and why the first
        for file in files:
            try:
                self._take(MessageFile(file))
            except (BadInput, OSError) as error:
                why = error if isinstance(error, BadInput) else (
                    f'cannot read {file}: {error.strerror or error}')
                if len(files) == 1:
                    raise BadInput(str(why)) from None
                self._damage.append(str(why))   # the other files of the bag may be whole
                self.complete = False

    def _take(self, content: MessageFile) -> None:
        try:
            for stored in content:
                kind = stored.source.kind
                if kind in SERIES or kind in STAMP_FIRST or stored.topic in STORY:
                    self._held += len(stored.data) + OVERHEAD
                    if self._held > MAX_HELD:
                        content.damaged(f'more than {MAX_HELD >> 30} GiB of messages')
                        break
                    self.stored.setdefault(stored.topic, []).append(stored)
        finally:
            for source in content.sources:
                self.kinds[source.topic] = source.kind
                self.counts[source.topic] = self.counts.get(source.topic, 0) + source.count
            self.notes.update(content.notes)
            self.complete = self.complete and content.complete
            self._damage += in_words(content)

    def story(self, topic: str, what: Callable[[Any], Any]) -> list[Any]:
        """Return what the messages of one of STORY say; those that are none are left out."""
        kind = self.kinds.get(topic, STORY[topic])
        if kind != STORY[topic]:
            self._damage.append(f'{topic} is of type {kind or "none"}, not {STORY[topic]}')
            return []
        return self._each(topic, lambda stored: what(stored.message))

    def decoded(self, topic: str) -> list[Any]:
        """Return the messages of a topic that can be decoded and are of a step of the run."""
        steps = self.kinds[topic] in CARRY_A_STEP

        def one(stored: Stored) -> Any:
            message = stored.message
            if steps and not 0 <= message.step <= self.latest:
                raise ValueError(f'message {stored.number} is of step {message.step}')
            return message
        return self._each(topic, one)

    def _each(self, topic: str, what: Callable[[Stored], Any]) -> list[Any]:
        made, left_out = [], 0
        for stored in self.stored.get(topic, ()):
            try:
                made.append(what(stored))
            except NO_MESSAGE as error:         # BadInput, too
                left_out += 1
                self._left_out[topic] = (left_out, self._left_out.get(topic, (0, str(error)))[1])
                if left_out >= HOPELESS and not made:
                    break
        return made

    def steps(self, topic: str, scenario: Scenario | None) -> NDArray[np.int64]:
        """Return the steps of the messages of a topic, as far as they can be known."""
        kind, reader = self.kinds.get(topic, ''), None
        if scenario is not None:
            reader = step_reader(kind, scenario.run.step_ns)
        elif kind in CARRY_A_STEP:
            reader = step_reader(kind, 1)
        found = []
        for message in self.stored.get(topic, ()) if reader is not None else ():
            try:
                step = reader(message.data)
            except struct.error:                # too short
                continue
            if 0 <= step <= self.latest:
                found.append(step)
        return np.array(found, dtype=np.int64)

    def said(self) -> list[str]:
        """Return what cannot be read, so far."""
        return [*self._damage, *(
            f'{topic}: {n} message{"s" if n > 1 else ""} left out ({why})'
            for topic, (n, why) in self._left_out.items())]


def in_words(content: MessageFile) -> list[str]:
    """Return the damage of a file as sentences."""
    if not content.damage:
        return []
    name, why = content.path.name, '; '.join(content.damage)
    if content.complete:
        return [f'{name} is damaged, and what cannot be read is left out: {why}']
    if content.first_ns is None:
        return [f'{name}: nothing can be read: {why}']
    read_s, last = (content.last_ns - content.first_ns) / NS_PER_S, last_time(content.path)
    of = f' of {(last - content.first_ns) / NS_PER_S:g}' if last and last > content.last_ns else ''
    return [f'{name}: the first {read_s:g}{of} s could be read; the rest is damaged: {why}']


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
            except NO_MESSAGE as error:         # BadInput, too
                raise BadInput(f'{topic}: {error}') from None
        return self._made[topic]

    def left_out(self) -> list[str]:
        """Return, as sentences, what could not be read of the series that were looked at."""
        return self._bag.said()

    def __iter__(self) -> Iterator[str]:
        return iter(self._topics)

    def __len__(self) -> int:
        return len(self._topics)
