"""
What `fly` said of a flight beside its bag: in `verdict.json`.

A recorder that was killed, or never started, has stored nothing of why the flight ended.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from rvd_dynamics.bad_input import BadInput, one_line
from rvd_dynamics.diagram.judge import ABORTED, ABORTED_WORDS
from rvd_dynamics.diagram.roster import GIVEN_UP, NAMELESS
from rvd_dynamics.given import object_of
from rvd_dynamics.recording.recording import Recording

LATEST_S = 1e12                 # [s] no run is longer


class Told(NamedTuple):
    """
    What the flight itself said.

    Attributes
    ----------
    doubts : sequence of str
        Why it is not to be trusted.
    given_up : str
        Why it could not be flown to its end; empty if it could.
    silences : sequence of tuple
        What was said of its processes: simulation time [s], sentence.
    ended_by : str
        Who ended it before its end, and how, in words; empty where nobody did.
    """

    doubts: Sequence[str] = ()
    given_up: str = ''
    silences: Sequence[tuple[float, str]] = ()
    ended_by: str = ''


def told_by(verdict: Path) -> Told:
    """Return what a `verdict.json` says; nothing where there is none, or one that is not ours."""
    try:
        content = object_of(verdict, 'verdict')
    except (BadInput, OSError):
        return Told()
    given_up = content.get('given_up', '')
    return Told([str(doubt) for doubt in _list(content.get('doubts'))],
                given_up if isinstance(given_up, str) else '',
                [(float(s['t_s']), s['said']) for s in _list(content.get('silences'))
                 if isinstance(s, dict) and isinstance(s.get('said'), str)
                 and isinstance(s.get('t_s'), int | float) and abs(s['t_s']) < LATEST_S],
                _ended_by(content))


def _ended_by(content: dict[str, Any]) -> str:
    """Return what `ended_by` says; of a flight that was aborted, that as well."""
    words = content.get('ended_by', '')
    if not isinstance(words, str) or not words:
        return ''
    return f'{ABORTED_WORDS}, and {words}' if content.get('reason') == ABORTED else words


def given_up(run: Recording, told: Told) -> str:
    """Return why a flight was given up, from its bag or from beside it; empty if it was not."""
    return told.given_up or next((e.text for e in run.events if e.code == GIVEN_UP), '')


def is_in(sentence: str, events: Sequence[Any]) -> bool:
    """Say whether one of the events has these words, however they are spaced."""
    words = one_line(sentence).split()
    return any(one_line(e.text).split() == words for e in events)


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def once(doubts: Sequence[str]) -> list[str]:
    """Return each doubt once; of a writer without a name only what nobody has named."""
    return [doubt for doubt in dict.fromkeys(doubts) if not doubt.endswith(NAMELESS) or not any(
        other != doubt and other.startswith(doubt.removesuffix(NAMELESS)) for other in doubts)]
