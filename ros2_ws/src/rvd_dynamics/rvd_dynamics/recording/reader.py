"""
A recorded run as arrays, read from its bag alone; no ROS needed.

A bag that was cut off (kill -9, full disk, broken copy) is read as far as it goes; `Recording`
then says so, and how many messages of which topic are missing.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
import yaml

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.judge import from_message, Judgement
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import build, dotted, leaves
from rvd_dynamics.recording.messages import files_of, MessageFile, stamp_ns, Stored
from rvd_dynamics.recording.steps import step_reader
from rvd_dynamics.diagram.ros import graph

LINK_DELAYS = ('play_out_delay', 'delay_p50', 'delay_p99', 'delay_max')
Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class States:
    """One RelativeState topic, a row per message."""

    step: Ints                                  # (N,)   step it was emitted in
    t: Floats                                   # (N,)   [s] instant the state is valid for
    valid: NDArray[np.bool_]                    # (N,)
    state: Floats                               # (N, 6) [m, m/s], NaN when unknown
    accel: Floats                               # (N, 3) [m/s^2] truth only, else NaN
    covariance: Floats                          # (N, 6, 6), NaN when not estimated


@dataclass(frozen=True)
class Commands:
    """One ThrustCommand topic, a row per message; numbers as in ThrustCommand.msg."""

    step: Ints                                  # (N,)
    t: Floats                                   # (N,) [s] instant from which it is meant to act
    levels: NDArray[np.int8]                    # (N, 3)
    valid: NDArray[np.bool_]                    # (N,)
    kind: Ints                                  # (N,)
    decided_by: Ints                            # (N,)
    pilot_weight: Floats                        # (N,) NaN when nothing was blended
    reason: Ints                                # (N,)


@dataclass(frozen=True)
class Frames:
    """One LinkFrame topic, a row per message; instants [s], NaN when they have not happened."""

    step: Ints                                  # (N,)
    sequence: Ints                              # (N,)
    empty: NDArray[np.bool_]                    # (N,) nothing was due
    sent: Floats                                # (N,)
    arrived: Floats                             # (N,)
    released: Floats                            # (N,)


@dataclass(frozen=True)
class LinkHistory:
    """What one link counted: columns over the run."""

    step: Ints                                  # (N,)
    counts: dict[str, Ints]                     # name in LinkStatus.msg -> (N,)
    delays: dict[str, Floats]                   # name in LinkStatus.msg -> (N,) [s]

    @property
    def last(self) -> dict[str, float]:
        """The last counts and delays; empty if the link reported none."""
        if not len(self.step):
            return {}
        return ({name: int(column[-1]) for name, column in self.counts.items()}
                | {name: float(column[-1]) for name, column in self.delays.items()})


@dataclass(frozen=True)
class Scores:
    """Predictions compared with what came down the link later."""

    step: Ints                                  # (N,)
    t: Floats                                   # (N,)   [s] instant the prediction was made for
    valid: NDArray[np.bool_]                    # (N,)
    error: Floats                               # (N, 6) [m, m/s] predicted minus received
    sigma: Floats                               # (N, 6) [m, m/s] what the prediction claimed
    rms: Floats                                 # (N, 6) [m, m/s] so far


@dataclass(frozen=True)
class Sticks:
    """The stick, a row per message."""

    t: Floats                                   # (N,) [s]
    axes: Floats                                # (N, most axes), NaN where a message had fewer
    buttons: NDArray[np.int64]                  # (N, most buttons), 0 likewise


@dataclass(frozen=True)
class Event:
    """One event of the run."""

    step: int
    t: float                                    # [s]
    node: str
    code: str
    text: str


@dataclass(frozen=True)
class Recording:
    """One run. Arrays have no rows where the bag has no messages."""

    path: Path
    scenario_text: str                          # as flown; empty if the bag has none
    truth: States
    measurement: States
    estimate: States
    prediction: States
    score: Scores
    joy: Sticks
    auto: Commands
    ground: Commands
    onboard: Commands
    telemetry: Frames
    uplink: Frames
    command_frames: Frames
    forward: LinkHistory
    back: LinkHistory
    verdict: Judgement | None                   # the last one in the bag
    judged: bool                                # and it is the final one
    events: tuple[Event, ...]
    last_step: int                              # last step in the bag, -1 if none
    ended: bool                                 # the run came to its end within the bag
    complete: bool                              # the file has its end
    closed: bool                                # the recorder closed it, too
    trouble: str                                # what went wrong for the recorder first
    counts: dict[str, int]                      # topic -> messages in the bag
    missing: dict[str, int]                     # topic -> steps 0 .. last_step not in the bag
    lost: dict[str, int] = field(default_factory=dict)  # topic -> received, but not stored

    @cached_property
    def mission(self) -> Mission:
        """The shared settings; the defaults where the bag's scenario does not say."""
        return mission_of(self.scenario_text)


def mission_of(scenario: str) -> Mission:
    """Return the shared settings of a scenario text, ignoring keys unknown to this version."""
    try:
        tree = yaml.safe_load(scenario)
        given = dotted(tree['/**']['ros__parameters'])
        known = {key for key, _ in leaves(Mission)}
        return build(Mission, {key: value for key, value in given.items() if key in known})
    except (yaml.YAMLError, ValueError, KeyError, TypeError, AttributeError):
        return Mission()


STATES = {'truth': '/truth/relative_state', 'measurement': '/onboard/measurement',
          'estimate': '/ground/estimate', 'prediction': '/ground/prediction'}
COMMANDS = {'auto': '/ground/auto_command', 'ground': '/ground/command',
            'onboard': '/onboard/thruster_command'}
FRAMES = {'telemetry': '/ground/telemetry', 'uplink': '/ground/uplink',
          'command_frames': '/onboard/command'}
LINKS = {'forward': '/link/forward/status', 'back': '/link/back/status'}
OTHERS = ('/run/scenario', '/run/verdict', '/run/events', '/run/end', '/joy',
          '/ground/prediction_score')
OWED = tuple(dict.fromkeys(t for spec in graph.NODES.values() for t in spec.emits))
WANTED = frozenset((*STATES.values(), *COMMANDS.values(), *FRAMES.values(), *LINKS.values(),
                    *OTHERS))


def read(path: Path) -> Recording:
    """
    Read a run from its bag: a run folder, a bag folder or an MCAP file.

    Raises
    ------
    ValueError
        If there is no bag, or a message cannot be decoded. A bag that was cut off is no error.
    """
    raw = _Raw()
    for file in files_of(path):
        raw.take(file)
    of = raw.messages
    ended = bool(of['/run/end'])
    scenario = of['/run/scenario'][-1].data if of['/run/scenario'] else ''
    steps = raw.steps(mission_of(scenario).step_ns)
    last_step = int(of['/run/end'][-1].data) if ended else max(
        (int(s.max()) for s in steps.values() if len(s)), default=-1)
    notes, verdicts = raw.notes.get('rvd_recording', {}), of['/run/verdict']
    return Recording(
        path=path,
        scenario_text=scenario,
        **{name: _states(of[topic]) for name, topic in STATES.items()},
        **{name: _commands(of[topic]) for name, topic in COMMANDS.items()},
        **{name: _frames(of[topic]) for name, topic in FRAMES.items()},
        **{name: _link(of[topic]) for name, topic in LINKS.items()},
        score=_scores(of['/ground/prediction_score']), joy=_sticks(of['/joy']),
        verdict=from_message(verdicts[-1]) if verdicts else None,
        judged=bool(verdicts and verdicts[-1].final),
        events=tuple(Event(m.step, _seconds(m.header.stamp), m.node, m.code, m.text)
                     for m in of['/run/events']),
        last_step=last_step, ended=ended, complete=raw.complete,
        closed=raw.complete and notes.get('closed') != 'false',
        trouble=notes.get('trouble', ''), counts=raw.counts,
        missing={topic: last_step + 1 - len(np.unique(s[s <= last_step]))
                 for topic, s in steps.items()},
        lost={topic: int(n) for topic, n in raw.notes.get('rvd_lost', {}).items()})


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


class _Raw:
    """Decoded messages by topic, in file order."""

    def __init__(self) -> None:
        self.messages: dict[str, list] = {topic: [] for topic in WANTED}
        self.owed: dict[str, list[bytes]] = {topic: [] for topic in OWED}
        self.counts: dict[str, int] = {}
        self.notes: dict[str, dict[str, str]] = {}
        self.complete = True

    def take(self, file: Path) -> None:
        content = MessageFile(file)
        for stored in content:
            if stored.topic in self.messages:
                self.messages[stored.topic].append(stored.message)
            if stored.topic in self.owed:
                self.owed[stored.topic].append(stored.data)
        for source in content.sources:
            self.counts[source.topic] = self.counts.get(source.topic, 0) + source.count
        self.notes.update(content.notes)
        self.complete = self.complete and content.complete

    def steps(self, step_ns: int) -> dict[str, Ints]:
        """Return the recorded steps of each topic that this run should write once per step."""
        promised = self.notes.get('rvd_missing') or {
            topic: '' for topic in OWED if self.counts.get(topic)}
        readers = {t: step_reader(graph.TOPICS[t], step_ns) for t in OWED if t in promised}
        return {topic: _column(reader, self.owed[topic], np.int64)
                for topic, reader in readers.items()}


def _column(of: Callable, messages: list, dtype: Any) -> NDArray:
    return np.array([of(m) for m in messages], dtype=dtype)


def _table(of: Callable, messages: list, width: int, dtype: Any = np.float64) -> NDArray:
    return np.array([of(m) for m in messages], dtype=dtype).reshape(len(messages), width)


def _seconds(stamp: Any) -> float:
    return stamp_ns(stamp) / NS_PER_S


def _instants(name: str, messages: list) -> Floats:
    ns = _column(lambda m: getattr(m, name), messages, np.float64)
    return np.where(ns < 0, np.nan, ns / NS_PER_S)


def _xyz(vector: Any) -> tuple[float, float, float]:
    return vector.x, vector.y, vector.z


def _stamps(messages: list) -> Floats:
    return _column(lambda m: _seconds(m.header.stamp), messages, np.float64)


def _steps(messages: list) -> Ints:
    return _column(lambda m: m.step, messages, np.int64)


def _states(messages: list) -> States:
    covariance = _table(lambda m: m.covariance, messages, 36)
    covariance[np.isnan(covariance[:, 0])] = np.nan     # element 0 says that all is unknown
    return States(
        step=_steps(messages), t=_stamps(messages),
        valid=_column(lambda m: m.valid, messages, bool),
        state=_table(lambda m: (*_xyz(m.position), *_xyz(m.velocity)), messages, 6),
        accel=_table(lambda m: _xyz(m.acceleration), messages, 3),
        covariance=covariance.reshape(-1, 6, 6))


def _commands(messages: list) -> Commands:
    return Commands(
        step=_steps(messages), t=_stamps(messages),
        levels=_table(lambda m: m.levels, messages, 3, np.int8),
        valid=_column(lambda m: m.valid, messages, bool),
        kind=_column(lambda m: m.kind, messages, np.int64),
        decided_by=_column(lambda m: m.decided_by, messages, np.int64),
        pilot_weight=_column(lambda m: m.pilot_weight, messages, np.float64),
        reason=_column(lambda m: m.reason, messages, np.int64))


def _frames(messages: list) -> Frames:
    return Frames(
        step=_steps(messages), sequence=_column(lambda m: m.sequence, messages, np.int64),
        empty=_column(lambda m: m.empty, messages, bool), sent=_instants('sent', messages),
        arrived=_instants('arrived', messages), released=_instants('released', messages))


def _link(messages: list) -> LinkHistory:
    return LinkHistory(
        step=_steps(messages),
        counts={n: _column(lambda m: getattr(m, n), messages, np.int64) for n in LINK_COUNTS},
        delays={n: _column(lambda m: getattr(m, n), messages, np.float64) for n in LINK_DELAYS})


def _scores(messages: list) -> Scores:
    return Scores(
        step=_steps(messages), t=_stamps(messages),
        valid=_column(lambda m: m.valid, messages, bool),
        error=_table(lambda m: (*_xyz(m.position_error), *_xyz(m.velocity_error)), messages, 6),
        sigma=_table(lambda m: m.sigma, messages, 6), rms=_table(lambda m: m.rms, messages, 6))


def _sticks(messages: list) -> Sticks:
    axes = np.full((len(messages), max((len(m.axes) for m in messages), default=0)), np.nan)
    buttons = np.zeros((len(messages), max((len(m.buttons) for m in messages), default=0)), int)
    for i, m in enumerate(messages):
        axes[i, :len(m.axes)] = m.axes
        buttons[i, :len(m.buttons)] = m.buttons
    return Sticks(t=_stamps(messages), axes=axes, buttons=buttons)
