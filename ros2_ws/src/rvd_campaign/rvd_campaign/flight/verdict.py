"""
The verdict of a run as people read it and as `verdict.json` keeps it.
"""

import json
import math
import sys
from pathlib import Path
from typing import Any

from rvd_campaign.flight import room
from rvd_campaign.flight.kept import Kept
from rvd_dynamics.bad_input import one_line
from rvd_dynamics.diagram import judge
from rvd_dynamics.diagram.judge import from_message, Judgement
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.given import object_of
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.recording import whole

INTERRUPTED = 'interrupted'             # reason of a flight that was stopped, and its words
UNTRUSTED = 'untrusted'                 # reason of a flight whose verdict is not to be believed
STOPPED = 'ended from the console'      # words of one that a page has ended
STOPPED_ABORTED = f'aborted, and {STOPPED}'
GIVEN_UP = 'given_up'                   # reason of a flight that could not be flown to its end
LINK_DELAYS = ('delay_p50', 'delay_p99', 'delay_max')


def outcome(verdict: Any, interrupted: bool = False, problem: str = '',
            stopped: bool = False) -> Judgement:
    """
    Return how a flight went.

    Parameters
    ----------
    verdict : Verdict or None
        The last message on /run/verdict.
    interrupted : bool
        Somebody stopped the flight, whatever the verdict was by then.
    problem : str
        Why the flight was given up, whatever the verdict was by then; empty: it was not.
    stopped : bool
        Who interrupted it did so from a page of the console.
    """
    words = STOPPED if stopped else INTERRUPTED
    if verdict is None:
        why = GIVEN_UP if problem else INTERRUPTED
        return Judgement(False, why, problem or words, math.nan, ())
    judged = from_message(verdict)
    if problem:
        return judged._replace(success=False, reason=GIVEN_UP, words=problem)
    judged = judged._replace(success=bool(verdict.final and judged.success))
    return judged._replace(reason=INTERRUPTED, words=words) if interrupted else judged


def as_dict(judged: Judgement, links: dict[str, Any], scenario: Scenario,
            kept: Kept | None = None) -> dict[str, Any]:
    """
    Return the content of `verdict.json`.

    Parameters
    ----------
    judged : Judgement
        How the flight went, from `outcome`.
    links : dict
        The last LinkStatus of each leg by its name; one that never came is None.
    scenario : Scenario
        Where the mission has no modes and no operator, these are None.
    kept : Kept, optional
        What the bag holds of a run that came to its end. Where steps are missing from it, the
        counts of a link that are not of the last step are unknown.
    """
    said = judge.as_dict(judged)
    operation = scenario.part('operation') if scenario.has_shared('operator') else None
    return unknown_as_none({
        'success': said['success'], 'reason': said['reason'], 'mission': scenario.mission.name,
        'scenario': scenario.name, 'mode': getattr(operation, 'mode', None),
        'operator': getattr(operation, 'operator', None), 'seed': scenario.run.seed,
        'run': scenario.run.run, 'duration_s': said['duration_s'],
        'measures': said['measures'],
        'link': {name: link_dict(status, None if kept is None or kept.complete else
                                 kept.flown - 1) for name, status in links.items()},
        **({} if kept is None else {'recording': kept.as_dict()})})


def trust(doubts: list[str], bag_agrees: bool | None, why: str) -> dict[str, Any]:
    """
    Return what `verdict.json` says about whether it is to be believed.

    Parameters
    ----------
    doubts : list of str
        Sentences that say why it is not; then it is no success, whatever was told.
    bag_agrees : bool or None
        Whether the judge says the same over the truth in the bag; None: it could not be asked.
    why : str
        Why it does not agree, or could not be asked.
    """
    made: dict[str, Any] = {'trusted': not doubts, 'doubts': doubts, 'bag_agrees': bag_agrees,
                            'bag_says': why}
    return {'success': False, 'reason': UNTRUSTED, **made} if doubts else made


def link_dict(status: Any, last_step: int | None = None) -> dict[str, Any]:
    """Return the counts and delays of one LinkStatus; unknown if it is not of `last_step`."""
    if last_step is not None and getattr(status, 'step', None) != last_step:
        return dict.fromkeys((*LINK_COUNTS, *(f'{name}_s' for name in LINK_DELAYS)))
    if status is None:
        return {}
    made = {name: getattr(status, name) for name in LINK_COUNTS}
    made.update({f'{name}_s': getattr(status, name) for name in LINK_DELAYS})
    return made


def unknown_as_none(value: Any) -> Any:
    """Return nested data with NaN, which JSON does not know, as null."""
    if isinstance(value, dict):
        return {key: unknown_as_none(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [unknown_as_none(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write(path: Path, content: dict[str, Any]) -> None:
    """
    Write `verdict.json` whole or not at all, into the room that was kept for it.

    A disk that does not take it is said: the flight is what it was.
    """
    room.give(path.parent)
    try:
        whole.write_text(path, json.dumps(content, indent=2) + '\n')
    except OSError as error:
        print(f'rvd fly: no {path}: {error.strerror or error}', file=sys.stderr)


def read(path: Path) -> dict[str, Any]:
    """Read `verdict.json`."""
    return object_of(path, 'verdict')


def in_words(judged: Judgement) -> str:
    """Return how a flight went in a few lines."""
    if judged.reason != INTERRUPTED and judged.words != STOPPED_ABORTED:
        said = judge.in_words(judged)
    elif math.isnan(judged.duration):
        said = judged.words
    else:
        said = judge.in_words(judged._replace(success=True))    # nobody failed
    return '\n'.join(map(one_line, said.split('\n')))          # words come from messages
