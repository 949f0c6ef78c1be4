"""
A finished run for the console's review: what the pilot saw, again, and beside it the truth.

    python -m rvd_campaign.report.replay RUNS NAME

prints the run RUNS/NAME as JSON. The bag is put through the same `Feed` that fills the live
page, so a review shows what was shown. The console runs this as a process of its own: the
truth, which the ground must not know, is read outside of it. Exit codes: 0 done, 1 no such
finished run, 2 nothing to show, with one line that says why, 3 a fault of this software. What of a
damaged bag can be shown is shown; an event at its end says what cannot.
"""

from functools import partial
import os
import resource
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import TRUTH
from rvd_dynamics.diagram.judge import for_page, from_message
from rvd_dynamics.recording.messages import files_of, MessageFile, Stored
from rvd_dynamics.recording.reader import BEYOND, in_words, NO_MESSAGE
from rvd_dynamics.recording.recording import scenario_of
from rvd_dynamics.link.signals import FRAME
from rvd_groundstation.console.decode import COMMANDS, link_of, SAMPLES, telemetry_of
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.protocol import encode
from rvd_groundstation.console.provider import display_of, on_ground

MOST_FRAMES = 900
MOST_EVENTS = 1000
NO_SAMPLE = (*NO_MESSAGE, ArithmeticError)      # what a message of made-up numbers leads to
CPU_S, MEMORY = 120, 8 << 30    # [s], [B] that a review may take; a long flight takes some seconds
SCENARIO, LINK, EVENTS, VERDICT = ('/run/scenario', '/link/back/status', '/run/events',
                                  '/run/verdict')


def load(runs: Path, name: str) -> str:
    """
    Return a finished run as JSON text: run message, frames with truth, events, verdict.

    Raises
    ------
    FileNotFoundError
        If there is no such finished run below `runs`.
    ValueError
        If its bag holds nothing that can be shown.
    """
    root = runs.resolve()
    folder = (root / name).resolve()
    if root not in folder.parents or not (folder / 'verdict.json').is_file():
        raise FileNotFoundError(name)           # also whatever points out of the runs folder
    try:
        files = files_of(folder)
    except ValueError:
        raise BadInput('this run has no bag') from None
    replay = Replay(name)
    for file in files:
        content = MessageFile(file)
        try:
            with np.errstate(all='ignore'):     # as below
                for stored in content:
                    replay.take(stored)
        except OSError as error:
            replay.damaged(f'{file.name} cannot be read: {error.strerror or error}')
        for sentence in in_words(content):
            replay.damaged(sentence)
    with np.errstate(all='ignore'):             # a damaged bag holds numbers that no run has
        return encode(replay.content())


class _NoScenario(BadInput):
    """The scenario of a run cannot be read, so that nothing can be shown."""


class Replay:
    """Fills a feed from a bag and keeps its frames."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._feed: Feed | None = None
        self._every = 1
        self._truth: dict[int, dict[str, Any]] = {}
        self._newest: tuple[int, dict[str, Any]] | None = None      # of the truth
        self._frames: list[dict] = []
        self._events: list[dict] = []
        self._damage: list[str] = []
        self._left_out = 0
        self._verdict: dict | None = None
        self._takers: dict[str, Callable] = {}
        self._shown: frozenset[str] = frozenset()

    def damaged(self, sentence: str) -> None:
        """Note what cannot be shown."""
        self._damage.append(sentence)

    def take(self, stored: Stored) -> None:
        """Take one message, which is decoded only if it is shown; what is none is left out."""
        try:
            self._take(stored)
        except _NoScenario:
            raise
        except NO_SAMPLE as error:
            self._left_out += 1
            if self._left_out == 1:
                self._first = f'{stored.topic} message {stored.number}: {error}'

    def _take(self, stored: Stored) -> None:
        topic, kind = stored.topic, stored.source.kind
        if topic == SCENARIO:
            self._begin(stored.message.data)
        elif topic in self._takers:
            self._takers[topic](stored.message)
        elif topic in self._shown and kind in SAMPLES:
            sample = SAMPLES[kind](stored.message)
            if sample is not None:
                self._feed.signal(topic, sample)

    def _begin(self, text: str) -> None:
        scenario, note = scenario_of(text)
        if scenario is None:
            raise _NoScenario(note)
        feed = self._feed = Feed(display_of(scenario))
        feed.ladder.archive = []                # a review shows all of it
        display, signals = feed.display, on_ground(scenario.diagram)
        measured = signals[display.measured]
        self._width = measured.parts[0].shape[0] if measured.message == FRAME else 0
        self._command_of = COMMANDS[signals[display.commands.sent].message]
        self._truth_of = SAMPLES[scenario.diagram.truth.message]
        self._shown = frozenset(display.parts()) | frozenset(feed.provider.derives_from)
        self._every = max(1, -(-feed.facts.last_step // MOST_FRAMES))
        self._takers = {
            display.commands.sent: self._command, LINK: self._link,
            **{topic: partial(self._joy, topic) for topic in feed.provider.sticks},
            scenario.diagram.truth.name: self._on_truth,
            EVENTS: self._event, VERDICT: self._on_verdict}
        if measured.message == FRAME:
            self._takers[display.measured] = self._telemetry

    def content(self) -> dict[str, Any]:
        """Return all of it."""
        if self._frames:
            self._keep_last()
        if self._newest is not None:
            self._truth.setdefault(*self._newest)
        if self._left_out:
            self.damaged(f'{self._left_out} messages left out, the first: {self._first}')
        if self._feed is None or not self._frames:
            raise BadInput(': '.join(['the bag of this run holds nothing that can be shown',
                                      *self._damage[:1]]))
        if self._damage:
            self._events.append({'t': self._frames[-1]['t'], 'node': 'bag', 'code': 'DAMAGED',
                                 'text': '; '.join(self._damage)})
        for frame in self._frames:
            if frame['k'] in self._truth:
                truth = frame['signals'][TRUTH] = self._truth[frame['k']]
                shown = {name: signal['parts'] for name, signal in frame['signals'].items()
                         if signal['ok']}
                truth['parts'].update(self._feed.provider.beside(shown, truth['parts']))
        return {**self._feed.run_message(self._name), 'type': 'review', 'frames': self._frames,
                'ladder': self._feed.ladder.whole(), 'events': self._events,
                'verdict': self._verdict}

    def _telemetry(self, m: Any) -> None:
        self._check_step(m)
        self._feed.telemetry(telemetry_of(m, self._feed.facts.step_s, self._width,
                                          self._feed.provider.measured))

    def _joy(self, topic: str, m: Any) -> None:
        self._feed.pilot(*self._feed.provider.heard_joy(topic, m.axes, m.buttons))

    def _link(self, m: Any) -> None:
        self._feed.link(link_of(m))

    def _check_step(self, m: Any) -> None:
        if not 0 <= m.step <= self._feed.facts.last_step + BEYOND:
            raise ValueError(f'step {m.step} is none of the run')

    def _command(self, m: Any) -> None:
        self._check_step(m)
        self._feed.command(self._command_of(m))
        if m.step % self._every == 0:
            self._keep_frame()

    def _keep_frame(self) -> None:
        frame = self._feed.frame(self._feed.ladder.version)
        del frame['type'], frame['ladder']
        self._frames.append(frame)

    def _keep_last(self) -> None:
        """Keep how it ended, as a page of the flight shows it, whatever pictures were left out."""
        if self._verdict is not None:
            self._feed.settle(self._verdict['duration'])
        if self._frames[-1]['k'] == self._feed.step:
            self._frames.pop()
        self._keep_frame()

    def _on_truth(self, m: Any) -> None:
        self._check_step(m)
        sample = self._truth_of(m)
        made = {'k': sample.step, 't': sample.t, 'ok': sample.ok, 'parts': sample.parts}
        if m.step % self._every == 0 or sample.parts['final']:
            self._truth[m.step] = made
        self._newest = m.step, made

    def _event(self, m: Any) -> None:
        self._check_step(m)
        if len(self._events) >= MOST_EVENTS:
            return
        self._feed.event(m.code, m.text)
        self._events.append({'t': m.step * self._feed.facts.step_s, 'node': m.node,
                             'code': m.code, 'text': m.text})

    def _on_verdict(self, m: Any) -> None:
        if m.final:
            self._verdict = for_page(from_message(m))


def main(runs: str, name: str) -> int:
    """Print a run; return the exit code."""
    os.nice(10)                                 # somebody may be flying
    for what, most in ((resource.RLIMIT_CPU, CPU_S), (resource.RLIMIT_AS, MEMORY)):
        _, hard = resource.getrlimit(what)
        resource.setrlimit(what, (most if hard < 0 else min(most, hard), hard))
    try:
        print(load(Path(runs), name))
    except FileNotFoundError:
        print('no such run', file=sys.stderr)
        return 1
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    except Exception:                           # noqa: B902 - a fault of ours keeps its traceback
        traceback.print_exc()
        return 3
    return 0


if __name__ == '__main__':
    lifeline.hold()                             # nobody reads on when the console has gone
    sys.exit(main(*sys.argv[1:]))
