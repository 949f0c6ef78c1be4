"""
The judge asked again, after a flight: over the truth that the bag holds, in this process.

A verdict that was forged, or a bag that somebody else has written into, does not agree with it.
"""

from collections.abc import Callable, Iterable
from contextlib import suppress
import math
from pathlib import Path
import traceback
from typing import Any

import numpy as np

from rvd_campaign.flight import verdict

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.aborts import Aborts
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.in_process import judge_of
from rvd_dynamics.diagram.judge import aborted, from_message, Judgement, judgement
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.recording.messages import files_of, MessageFile, Stored

EVENTS = '/run/events'
SAME = 1e-9                     # of two values that are the same number, relatively


def asked(run_dir: Path, scenario: Scenario, told: Any, strangers: Iterable[str]
          ) -> tuple[list[str], dict[str, Any]]:
    """
    Return why a flight is not to be trusted, and what `verdict.json` says about that.

    Parameters
    ----------
    told : Verdict or None
        What the judge told during the flight; it is compared once it is final.
    strangers : iterable of str
        Sentences that say who wrote on topics of the run and is none of it.
    """
    found = list(strangers)
    agrees, why = None, 'the run has no final verdict'
    if told is not None and told.final:
        try:
            why = difference(from_message(told), over_the_bag(run_dir, scenario))
            agrees = not why
        except BadInput as error:
            why = str(error)
        except Exception as error:              # noqa: B902 - the verdict is kept all the same
            log = run_dir / 'logs' / 'second_opinion.log'
            why = f'{type(error).__name__} (traceback in {log})'
            with suppress(OSError):
                log.write_text(traceback.format_exc(), encoding='utf-8')
    if agrees is False:
        found.append(why)
    return found, verdict.trust(found, agrees, why)


def prepare(scenario: Scenario) -> None:
    """
    Let the judge load, compile and plan what it does at its first steps and at the end of a run.

    It takes up to a second, in which the nodes of a run end. What fails here fails again where the
    verdict waits for it, and is told there.
    """
    with suppress(Exception):
        start, judge = scenario.diagram.truth.initial(()), judge_of(scenario)
        judge.follow(0, start)
        judge.follow(1, start._replace(final=np.True_))
        judge.verdict(True)


def over_the_bag(run_dir: Path, scenario: Scenario) -> Judgement:
    """
    Return what the judge says to the truth in a bag.

    Raises
    ------
    BadInput
        If the bag does not hold the truth of every step, once, to the end of the run.
    """
    truth = scenario.diagram.truth
    decoded, aborts = _decoder(scenario, truth), _AbortsIn(scenario)
    judge, last, final = judge_of(scenario), -1, False
    for file in files_of(run_dir):
        for stored in MessageFile(file, {truth.name, *aborts.topics}):
            if stored.topic != truth.name:
                aborts.take(stored)
                continue
            message, value = decoded(stored.data)
            if message.step != last + 1 or final:
                raise BadInput(f'the truth in the bag goes from step {last} to step '
                               f'{message.step}')
            last = message.step
            judge.follow(last, value)
            final = bool(value.final)
    if not final:
        raise BadInput(f'the truth in the bag ends at step {last}, before the run does')
    return judgement(judge, aborted(judge.verdict(True), aborts.found.since(last)))


def was_aborted(run_dir: Path, scenario: Scenario) -> bool:
    """Say whether an ABORT was in force in a run that somebody ended, by its bag if it has one."""
    aborts = _AbortsIn(scenario)
    with suppress(BadInput):
        for file in files_of(run_dir):
            for stored in MessageFile(file, set(aborts.topics)):
                aborts.take(stored)
    return not math.isnan(aborts.found.since(scenario.run.last_step))


class _AbortsIn:
    """What a bag says of an ABORT; what was on board is decoded once one has been asked for."""

    def __init__(self, scenario: Scenario) -> None:
        self._shown, self.found = scenario.diagram.abort_shown, Aborts(scenario.run.step_s)
        self.topics: tuple[str, ...] = (EVENTS,)
        if self._shown is not None:
            signal = scenario.diagram.signals[self._shown.signal]
            self.topics, self._decoded = (EVENTS, signal.name), _decoder(scenario, signal)

    def take(self, stored: Stored) -> None:
        """Take a message of one of `topics`."""
        if stored.topic == EVENTS:
            event = stored.message
            self.found.event(event.step, event.code)
        elif self.found.awaited:
            message, value = self._decoded(stored.data)
            self.found.board(message.step,
                             getattr(value, self._shown.part) == self._shown.value)


def _decoder(scenario: Scenario, signal: Signal) -> Callable[[bytes], tuple[Any, Any]]:
    """Return a function of a serialised message, which returns it and the value in it."""
    from rclpy.serialization import deserialize_message
    from rvd_dynamics.diagram.ros.host import message_type
    own = {'signal': signal, 'run': scenario.run, 'event': lambda code, text: None}
    kind = message_type(signal.message)
    codec = made(signal.codec, lambda name: own.get(name) or scenario.part(name),
                 f'signal {signal.name}')

    def decoded(data: bytes) -> tuple[Any, Any]:
        message = deserialize_message(data, kind)
        return message, codec.decode(message.step, message)
    return decoded


def difference(told: Judgement, again: Judgement) -> str:
    """Return in words how two verdicts on one run differ; empty where they do not."""
    if (told.success, told.reason) != (again.success, again.reason):
        return f'{told.headline!r} was told, {again.headline!r} is what the truth in the bag says'
    mine, theirs = ({'duration': j.duration, **{m.name: m.value for m in j.measures}}
                    for j in (told, again))
    different = [name for name in {**mine, **theirs} if not _same(
        mine.get(name, math.inf), theirs.get(name, math.inf))]
    return different and f'{", ".join(different)} of the verdict is not what the truth in the ' \
                         'bag says' or ''


def _same(a: float, b: float) -> bool:
    return a == b or math.isnan(a) and math.isnan(b) or math.isclose(a, b, rel_tol=SAME)
