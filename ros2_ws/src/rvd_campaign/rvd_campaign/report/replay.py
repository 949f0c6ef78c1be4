"""
A finished run for the console's review: what the pilot saw, again, and beside it the truth.

    python -m rvd_campaign.report.replay RUNS NAME

prints the run RUNS/NAME as JSON. The bag is put through the same `Feed` that fills the live
page, so a review shows what was shown. The console runs this as a process of its own: the
truth, which the ground must not know, is read outside of it. Exit codes: 0 done, 1 no such
finished run, 2 nothing to show, with one line that says why.
"""

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from rvd_dynamics.diagram.judge import for_page, from_message
from rvd_dynamics.diagram.params import build, dotted, leaves
from rvd_dynamics.mission import Mission
from rvd_dynamics.link.frame import Downlink, unpack_downlink
from rvd_dynamics.recording.messages import MessageFile, stamp_ns
from rvd_dynamics.commands.levels import stick_levels
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.protocol import encode

MOST_FRAMES = 900
TOPICS = ('/run/scenario', '/truth/relative_state', '/ground/telemetry', '/ground/estimate',
          '/ground/prediction', '/ground/prediction_score', '/ground/auto_command',
          '/ground/command', '/joy', '/link/back/status', '/run/events', '/run/verdict')
LINK = ('sent', 'delivered', 'late', 'lost', 'outage', 'corrupted', 'in_flight', 'queued',
        'delay_p50', 'delay_p99', 'delay_max')


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
    files = sorted((folder / 'bag').glob('*.mcap'))
    if not files:
        raise ValueError('this run has no bag')
    replay = Replay(name)
    for file in files:
        for stored in MessageFile(file, TOPICS):
            replay.take(stored.topic, stored.message)
    return encode(replay.content())


def mission_of(scenario: str) -> Mission:
    """Return the shared settings of a scenario text, ignoring keys unknown to this version."""
    try:
        tree = yaml.safe_load(scenario)
        given = dotted(tree['/**']['ros__parameters'])
        known = {key for key, _ in leaves(Mission)}
        return build(Mission, {key: value for key, value in given.items() if key in known})
    except (yaml.YAMLError, ValueError, KeyError, TypeError, AttributeError):
        return Mission()


class Replay:
    """Fills a feed from a bag and keeps its frames."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._feed: Feed | None = None
        self._every = 1
        self._truth: dict[int, list[float]] = {}
        self._frames: list[dict] = []
        self._events: list[dict] = []
        self._verdict: dict | None = None
        self._takers: dict[str, Callable] = {
            '/ground/telemetry': self._telemetry, '/ground/estimate': self._estimate,
            '/ground/prediction': self._prediction, '/ground/prediction_score': self._score,
            '/ground/auto_command': self._auto, '/ground/command': self._command,
            '/joy': self._joy, '/link/back/status': self._link,
            '/truth/relative_state': self._on_truth,
            '/run/events': self._event, '/run/verdict': self._on_verdict}

    def take(self, topic: str, message: Any) -> None:
        """Take one message."""
        if topic == '/run/scenario':
            mission = mission_of(message.data)
            self._feed = Feed(mission)
            self._every = max(1, -(-mission.last_step // MOST_FRAMES))
        elif self._feed is not None:
            self._takers[topic](message)

    def content(self) -> dict[str, Any]:
        """Return all of it."""
        if self._feed is None or not self._frames:
            raise ValueError('the bag of this run holds nothing that can be shown')
        for frame in self._frames:
            frame['truth'] = self._truth.get(frame['k'])
        return {**self._feed.run_message(self._name), 'type': 'review', 'frames': self._frames,
                'ladder': self._feed.ladder.changes(), 'events': self._events,
                'verdict': self._verdict}

    def _telemetry(self, m: Any) -> None:
        if m.empty:
            return
        content = unpack_downlink(bytes(m.payload))
        if isinstance(content, Downlink) and np.isfinite(content.state).all():
            self._feed.telemetry(m.step, m.sent, m.arrived, content.generated_ns, content.state,
                                 content.accepted_sequence, content.refusal)
        else:
            self._feed.telemetry_lost(m.step, getattr(content, 'name', 'NAN'))

    def _state(self, name: str, m: Any) -> None:
        covariance = np.array(m.covariance).reshape(6, 6)
        sigma = None if np.isnan(covariance[0, 0]) else np.sqrt(
            np.maximum(covariance.diagonal(), 0.0))
        self._feed.state(name, m.step, stamp_ns(m.header.stamp), np.array(_state(m)), sigma,
                         m.valid)

    def _estimate(self, m: Any) -> None:
        self._state('est', m)

    def _prediction(self, m: Any) -> None:
        self._state('pred', m)

    def _score(self, m: Any) -> None:
        if m.valid:
            e, v = m.position_error, m.velocity_error
            self._feed.score(m.step, stamp_ns(m.header.stamp), [e.x, e.y, e.z, v.x, v.y, v.z],
                             list(m.sigma), list(m.rms), m.scored)

    def _auto(self, m: Any) -> None:
        self._feed.automatic(list(m.levels), m.valid)

    def _joy(self, m: Any) -> None:
        levels, valid = stick_levels(m.axes, m.buttons, self._feed.mission.stick)
        self._feed.pilot(levels.tolist(), valid)

    def _link(self, m: Any) -> None:
        self._feed.link({name: getattr(m, name) for name in LINK})

    def _command(self, m: Any) -> None:
        self._feed.command(m.step, m.sequence, m.kind, list(m.levels), m.decided_by,
                           m.pilot_weight, m.reason)
        if m.step % self._every == 0:
            frame = self._feed.frame(self._feed.ladder.version)
            del frame['type'], frame['ladder']
            self._frames.append(frame)

    def _on_truth(self, m: Any) -> None:
        if m.step % self._every == 0 or m.final:
            self._truth[m.step] = _state(m)

    def _event(self, m: Any) -> None:
        self._events.append({'t': m.step * self._feed.mission.step_s, 'node': m.node,
                             'code': m.code, 'text': m.text})

    def _on_verdict(self, m: Any) -> None:
        if m.final:
            self._verdict = for_page(from_message(m))


def _state(message: Any) -> list[float]:
    p, v = message.position, message.velocity
    return [p.x, p.y, p.z, v.x, v.y, v.z]


def main(runs: str, name: str) -> int:
    """Print a run; return the exit code."""
    os.nice(10)                                 # somebody may be flying
    try:
        print(load(Path(runs), name))
    except FileNotFoundError:
        print('no such run', file=sys.stderr)
        return 1
    except ValueError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
