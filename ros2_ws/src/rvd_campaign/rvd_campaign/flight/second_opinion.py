"""
The judge asked again, after a flight: over the truth that the bag holds, in this process.

A verdict that was forged, or a bag that somebody else has written into, does not agree with it.
"""

from collections.abc import Iterable
from contextlib import suppress
import math
from pathlib import Path
import traceback
from typing import Any

import numpy as np

from rvd_campaign.flight import verdict

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.in_process import judge_of
from rvd_dynamics.diagram.judge import from_message, Judgement, judgement
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording.messages import files_of, MessageFile

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
    from rclpy.serialization import deserialize_message
    from rvd_dynamics.diagram.ros.host import message_type
    truth, run = scenario.diagram.truth, scenario.run
    codec = made(truth.codec, lambda name: {'signal': truth, 'run': run}.get(name)
                 or scenario.part(name), f'signal {truth.name}')
    judge, kind, last, final = judge_of(scenario), message_type(truth.message), -1, False
    for file in files_of(run_dir):
        for stored in MessageFile(file, {truth.name}):
            message = deserialize_message(stored.data, kind)
            if message.step != last + 1 or final:
                raise BadInput(f'the truth in the bag goes from step {last} to step '
                               f'{message.step}')
            last, value = message.step, codec.decode(message.step, message)
            judge.follow(last, value)
            final = bool(value.final)
    if not final:
        raise BadInput(f'the truth in the bag ends at step {last}, before the run does')
    return judgement(judge, judge.verdict(True))


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
