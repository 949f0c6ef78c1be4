"""
What the pilot's page is shown, made from what the ground knows.

Clocks  every shown signal carries the instant it is valid for, and where it came down the link
        also when it was received [s of simulation time].
Truth   never enters here: the feed is filled from what is on the ground, and from `/run/*`.
"""

from collections import deque
from dataclasses import replace
from typing import Any

from rvd_dynamics.diagram.control import MODE_EVENT, MODE_WORDS
from rvd_dynamics.diagram.display import as_data, DERIVED, Trail
from rvd_groundstation.console.decode import EMPTY, Heard, Lost, Sample
from rvd_groundstation.console.ladder import Ladder
from rvd_groundstation.console.provider import MissionDisplay, PILOT

AFTER_STEPS = 50                # predictions kept beyond the forward delay: steps after the end
TRAIL_S = 0.5                   # [s] between two points of the trails that late pages get


class Feed:
    """The newest of everything, and the ladder; `frame` makes one message of it."""

    def __init__(self, provider: MissionDisplay) -> None:
        self.provider = provider
        self.facts, self.display = provider.facts, provider.display
        self.ladder = Ladder(self.facts.forward_steps, self.facts.step_s)
        self.step = -1
        self.paused = False
        self.mode = self.facts.mode
        self.trails: dict[str, list[list[float | None]]] = {
            trail.name: [] for trail in self.display.trails()}
        self._parts = self.display.parts()
        self._newest: dict[str, Sample] = {}
        self._gap: dict[str, Any] | None = None
        self._link: dict[str, Any] | None = None
        self._derived: dict[str, Any] | None = None     # None: to be derived anew
        self._predicted: deque[Sample] = deque(maxlen=self.facts.forward_steps + AFTER_STEPS)
        self._ended = False                     # what is predicted for later is not shown

    # -- what comes in --------------------------------------------------------------------

    def signal(self, name: str, sample: Sample) -> None:
        """Take in the newest of a signal."""
        if name == self.display.predicted:
            if self._ended:
                return
            self._predicted.append(sample)
        self._newest[name] = sample
        self._derived = None

    def settle(self, t: float) -> None:
        """
        Let the run have ended at instant `t` [s]: what was predicted for then is what stays.

        The newest prediction is for later, when the craft has docked or is past the plane.
        """
        self._ended = True
        before = [sample for sample in self._predicted if sample.ok and sample.t <= t]
        after = [sample for sample in self._predicted if sample.ok and sample.t > t]
        if not before:
            return
        shown = between(before[-1], after[0], t) if after else before[-1]
        self._newest[self.display.predicted], self._derived = shown, None
        for trail in self.display.trails():
            if trail.place.signal == self.display.predicted:
                self.trails[trail.name] = [
                    row for row in self.trails[trail.name] if row[1] <= shown.t]

    def telemetry(self, content: Heard | Lost) -> None:
        """Take in what came down in a step: the signal that is shown as measured, or nothing."""
        if isinstance(content, Heard):
            sample = content.sample
            self.signal(self.display.measured, sample)
            if not self.display.link:
                return
            self.ladder.heard(sample.step, content.generated_ns // self.facts.step_ns,
                              content.accepted if self.facts.acknowledged else None,
                              content.refusal)
        elif content.why != EMPTY or content.step > self.facts.back_steps:
            self._gap = {'k': content.step, 'why': content.why}    # before, nothing can have come

    def pilot(self, value: list[float], valid: bool) -> None:
        """Take in the command that the stick means now."""
        self.signal(PILOT, Sample(self.step, self.step * self.facts.step_s, valid,
                                   {'value': value}))

    def no_pilot(self) -> None:
        """Note that nobody has the stick."""
        self.pilot([0.0] * len(self.display.commands.axes), False)

    def command(self, sample: Sample) -> None:
        """Take in the command that was sent: with it a step of the ground is over."""
        self.signal(self.display.commands.sent, sample)
        self.step = max(self.step, sample.step)
        self.provider.sent(sample)
        parts = sample.parts
        if self.display.link:
            self.ladder.sent(sample.step, parts['sequence'], tuple(parts['value']), parts['kind'])
            self.ladder.tick(sample.step)
        self._extend_trails(sample.step * self.facts.step_s)

    def event(self, code: str, text: str) -> None:
        """Take in an event: a new mode counts whoever asked for it."""
        if code == MODE_EVENT:
            self.mode = text.removeprefix(MODE_WORDS)

    def link(self, status: dict[str, Any]) -> None:
        """Take in the counts of the back link."""
        self._link = status

    def _extend_trails(self, t: float) -> None:
        for trail in self.display.trails():
            rows = self.trails[trail.name]
            if not rows or t - rows[-1][0] >= TRAIL_S:
                row = self._trail_row(trail, t)
                if row is not None:
                    rows.append(row)

    def _trail_row(self, trail: Trail, t: float) -> list[float | None] | None:
        sample = self._newest.get(trail.place.signal)
        place = sample.parts.get(trail.place.part) if sample is not None and sample.ok else None
        if place is None:
            return None
        spread = None
        if trail.spread is not None:
            spread = self._shown(trail.spread.signal).get(trail.spread.part)
        return [t, sample.t, *(place if isinstance(place, (list, tuple)) else [place]), spread]

    # -- what goes out --------------------------------------------------------------------

    def frame(self, since: int = 0) -> dict[str, Any]:
        """Return one frame: signals, what is derived, ladder changes after version `since`."""
        made: dict[str, Any] = {
            'type': 'frame', 'k': self.step, 't': max(self.step, 0) * self.facts.step_s,
            'mode': self.mode, 'paused': self.paused,
            'signals': {name: self._sample(name, sample)
                        for name, sample in self._newest.items() if name in self._parts},
            'ladder': self.ladder.changes(since)}
        made['signals'][DERIVED] = {'ok': True, 't': made['t'], 'parts': self.derived()}
        if self._link is not None:
            made['link'] = self._link
        if self._gap is not None:
            made['gap'] = self._gap
        if self.ladder.round_trip_steps is not None:
            made['round_trip'] = self.ladder.round_trip_steps * self.facts.step_s
        return made

    def _sample(self, name: str, sample: Sample) -> dict[str, Any]:
        made: dict[str, Any] = {
            'k': sample.step, 't': sample.t, 'ok': sample.ok,
            'parts': {part: value for part, value in sample.parts.items()
                      if part in self._parts[name]}}
        if sample.received is not None:
            made['received'] = sample.received
        if sample.transit is not None:
            made['transit'] = sample.transit
        return made

    def derived(self) -> dict[str, Any]:
        """Return what the mission derives from the newest of all signals."""
        if self._derived is None:
            self._derived = self.provider.derive(self._newest)
        return self._derived

    def _shown(self, name: str) -> dict[str, Any]:
        if name == DERIVED:
            return self.derived()
        sample = self._newest.get(name)
        return sample.parts if sample is not None and sample.ok else {}

    def run_message(self, name: str) -> dict[str, Any]:
        """Return what a page needs once per run: grid, delays, display."""
        f = self.facts
        return {
            'type': 'run', 'name': name, 'step_s': f.step_s, 'timeout_s': f.timeout_s,
            'forward_s': f.forward_s, 'back_s': f.back_s, 'mode': f.mode,
            'operator': f.operator, 'seed': f.seed, 'pace': f.pace,
            'acknowledged': f.acknowledged,
            'display': as_data(self.display)}


def between(a: Sample, b: Sample, t: float) -> Sample:
    """Return what lies between two samples at instant `t` [s], in a straight line."""
    share = (t - a.t) / (b.t - a.t)
    parts = {name: [x + share * (y - x) for x, y in zip(value, b.parts[name])]
             if isinstance(value, list) and len(value) == len(b.parts.get(name, ())) else value
             for name, value in a.parts.items()}
    return replace(a, t=t, parts=parts)
