"""
A run of an in-process flight as a `Recording`, equal to that of its bag.

The values of the history go through the codecs of the graph, so that a figure gets what it would
get of a bag. What came out of the link is told by the channel, as in the graph: the loop itself
only knows what got through. Nothing is said on `/run/*`; there are no events.
"""

from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

from mcap.records import Schema
from mcap_ros2.decoder import DecoderFactory
import numpy as np

from rvd_dynamics.diagram.block import Leg
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.in_process import Batch
from rvd_dynamics.diagram.judge import judgement
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.play_out import Frame
from rvd_dynamics.recording.definitions import schema_text
from rvd_dynamics.recording.recording import LINK_STATUS, Recording
from rvd_dynamics.recording.series import Frames, LinkHistory, Series, SERIES

NOTHING = SimpleNamespace(sequence=0, sent=-1, arrived=-1, released=-1, expedited=False)


def everything(scenario: Scenario) -> list[str]:
    """Return what `in_process.fly` must record for a recording as whole as that of a bag."""
    found = []
    for name, signal in scenario.diagram.signals.items():
        found += [name, *(f'{name}.{part.name}' for part in signal.parts if part.optional)]
    return found


def of_history(scenario: Scenario, batch: Batch, row: int = 0) -> Recording:
    """
    Return one run of a flight as a recording.

    Parameters
    ----------
    scenario : Scenario
        As flown.
    batch : Batch
        What `in_process.fly` returned, with a history.
    row : int
        Which of its runs.

    Returns
    -------
    Recording
        With a series for each recorded signal whose messages have one. Parts that nobody asked
        to record are NaN there, or the column is None. A leg has its frames and counts if the
        signal that it hands over was recorded, and also the one that it carries if that one
        says which frames are expedited.

    Raises
    ------
    ValueError
        If there is no history.
    """
    if batch.history is None:
        raise ValueError('a recording needs a history: fly with record=True')
    scenario = scenario.with_values('/**', run=int(batch.runs[row]))
    flown = _Flown(scenario, batch.history, row, int(batch.end_step[row]))
    series = dict(flown.series())
    judge = made(scenario.mission.judge, flown.available({'batch': ()}), 'judge')
    kinds = {topic: _kind(scenario, topic) for topic in series}
    return Recording(
        path=None, scenario_text=scenario.dump(), scenario=scenario, scenario_trouble='',
        series=series, kinds=kinds, verdict=judgement(judge, batch.verdict, row), judged=True,
        events=(), last_step=flown.end, ended=True, complete=True, closed=True, trouble='',
        counts={topic: len(s) for topic, s in series.items()},
        missing=dict.fromkeys(series, 0))


def _kind(scenario: Scenario, topic: str) -> str:
    signal = scenario.diagram.signals.get(topic)
    return LINK_STATUS if signal is None else signal.message


def decoder_of(kind: str) -> Any:
    """Return what decodes serialised messages of an installed type, as the reader of bags does."""
    schema = Schema(id=1, name=kind, encoding='ros2msg', data=schema_text(kind).encode())
    return DecoderFactory().decoder_for('cdr', schema)


class _Flown:
    """One run of a history."""

    def __init__(self, scenario: Scenario, history: dict[str, Any], row: int, end: int) -> None:
        self.scenario, self.diagram, self.end = scenario, scenario.diagram, end
        self._history, self._row = history, row

    def available(self, own: dict[str, Any]) -> Any:
        """Return where constructors find what they ask for."""
        return lambda name: own[name] if name in own else self.scenario.part(name)

    def series(self) -> Iterator[tuple[str, Series]]:
        """Yield topics with what they carried."""
        for name in self._history:
            signal, writer = self.diagram.signals[name], self.diagram.writer_of[name]
            if isinstance(writer, Leg):
                yield from self._link(writer)
            elif signal.message in SERIES:
                yield name, self._encoded(signal, self.end + 1 if signal.still else writer.period)

    def _encoded(self, signal: Signal, period: int) -> Series:
        """Return the series of the messages that a graph would have published."""
        own = {'signal': signal, 'run': self.scenario.run, 'event': lambda code, text: None}
        codec = made(signal.codec, self.available(own), f'signal {signal.name}')
        value = self._history[signal.name]
        columns = [self._column(part, getattr(value, part.name)) for part in signal.parts]
        encoded = [codec.encode(k, signal.type(*(column(k) for column in columns)))
                   for k in range(0, self.end + 1, period)]
        decode = decoder_of(signal.message)
        series = SERIES[signal.message].of(
            [decode(message) if isinstance(message, bytes) else message for message in encoded])
        return series.without(                  # numbers that cannot say that they are unknown
            part.name for part in signal.parts
            if getattr(value, part.name) is None and part.dtype[0] not in 'fO')

    def _column(self, part: Any, values: Any) -> Any:
        """Return what gives a part of a step; one that nobody recorded is unknown in all."""
        if part.dtype == 'O':                   # the same in all rows
            return lambda k: None if values is None else values[k]
        if values is None:
            filled = part.filled(())
            return lambda k: filled
        mine = values[:, self._row]
        return lambda k: mine[k]

    # -- the link ----------------------------------------------------------------------------

    def _link(self, leg: Leg) -> Iterator[tuple[str, Series]]:
        """Yield what a leg released and counted, where it is known which frames it was given."""
        content = leg.reads['content'].signal
        expedited = np.zeros(self.end + 1, dtype=bool)
        if any(part.name == 'expedited' for part in content.parts):
            if content.name not in self._history:
                return
            expedited = self._history[content.name].expedited[:, self._row]
        frames, counted = self._played(leg, expedited)
        yield leg.writes['arrival'].name, Frames.of(frames)
        if leg.status is not None:
            yield leg.status.name, LinkHistory.of(counted)

    def _played(self, leg: Leg, expedited: Any) -> tuple[list[Any], list[Any]]:
        """Return what a leg released and what it counted, step by step, as messages say it."""
        run, drawn = self.scenario.run, leg.draws['chance']
        plan = drawn.of_run(run.seed, run.run, run.last_step + 1)
        channel = Channel(plan, drawn.hold_steps, run.step_ns)
        frames, counted = [], []
        for k in range(self.end + 1):
            due = channel.advance(k, Frame(sequence=k + 1, sent_ns=k * run.step_ns,
                                           expedited=bool(expedited[k])))
            told = vars(NOTHING) if due is None else {
                'sequence': due.sequence, 'sent': due.sent_ns, 'arrived': due.arrived_ns,
                'released': due.released_ns, 'expedited': due.expedited}
            frames.append(SimpleNamespace(step=k, empty=due is None, **told))
            counted.append(SimpleNamespace(
                step=k, play_out_delay=drawn.hold_steps * run.step_s,
                delay_p50=channel.delay_s(50), delay_p99=channel.delay_s(99),
                delay_max=channel.delay_s(100), **vars(channel.counts)))
        return frames, counted
