"""
What was really flown: the mode of each step, who decided, and what broke into the run.

Read from the commands that the ground sent, not from what a run was meant to be. A command says
who decided and why (`commands.codes`), and of each pair only one mode makes it (`sharing.decide`).
A mission with modes of its own says on `/run/events` when another one came into force.
"""

from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.aborts import ABORT_EVENT
from rvd_dynamics.diagram.control import MODE_EVENT, MODE_WORDS
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording.messages import files_of, MessageFile
from rvd_dynamics.recording.recording import Recording
from rvd_dynamics.recording.series import Commands

EVENTS = '/run/events'
THRUST_COMMAND = 'rvd_interfaces/msg/ThrustCommand'
PAUSE_EVENT = 'PAUSE'
ABORT, UNKNOWN = 'abort', 'unknown'     # beside the modes: an ABORT was sent; none makes it
DECIDERS = {codes.BY_NOBODY: 'nobody', codes.BY_PILOT: 'pilot', codes.BY_AUTO: 'automatic',
            codes.BY_BLEND: 'both', codes.BY_GUARD: 'guard'}


class Flown(NamedTuple):
    """What a run was, by its record; steps under an ABORT are nobody's and of no mode."""

    steps: int                          # whose commands are known
    modes: dict[str, int]               # steps in each mode; empty where the mission has none
    decided: dict[str, int]             # steps by who decided; empty where commands do not say
    aborted: bool                       # an ABORT was asked for
    pauses: int                         # how often simulation time was stopped

    def as_dict(self) -> dict[str, Any]:
        """Return what `verdict.json` says of it: shares of the steps."""
        def shares(counts: dict[str, int]) -> dict[str, float]:
            return {name: n / self.steps for name, n in counts.items() if n}
        return {'steps': self.steps, 'modes': shares(self.modes),
                'decided': shares(self.decided), 'aborted': self.aborted, 'pauses': self.pauses}


def mode_of(decided_by: int, reason: int) -> str:
    """Return the mode that makes a command which says so; UNKNOWN where none does."""
    if reason == codes.REASON_ABORT:
        return ABORT
    return _MODES.get((decided_by, reason), UNKNOWN)


_BOTH = (codes.BY_BLEND, codes.BY_PILOT, codes.BY_AUTO)     # what a sharing may say
_MODES = {
    (codes.BY_PILOT, codes.REASON_MODE): 'manual',
    (codes.BY_NOBODY, codes.REASON_PILOT_INVALID): 'manual',
    (codes.BY_AUTO, codes.REASON_MODE): 'auto',
    (codes.BY_NOBODY, codes.REASON_AUTO_INVALID): 'auto',
    (codes.BY_AUTO, codes.REASON_PILOT_INVALID): 'shared',
    (codes.BY_NOBODY, codes.REASON_BOTH_INVALID): 'shared',
    **{(by, reason): 'shared' for by in _BOTH
       for reason in (codes.REASON_NONE, codes.REASON_AUTO_INVALID)}}


def of_recording(run: Recording) -> Flown:
    """Return what a recorded run was; nothing is known where the bag holds no scenario."""
    events = [(e.step, e.code, e.text) for e in run.events]
    if run.scenario is None:
        return _flown('', events, -1)
    sent = _sent(run.scenario)
    series = run.of(sent) if sent else None
    if isinstance(series, Commands) and series.decided_by is not None and len(series):
        return _flown('', events, -1, (series.decided_by, series.reason))
    return _flown(_first_mode(run.scenario), events, run.last_step)


def of_bag(run_dir: Path, scenario: Scenario, last_step: int) -> Flown:
    """
    Return what a run was, from the few topics of its bag that say so.

    Raises
    ------
    ValueError
        If there is no bag, or what is in it cannot be read.
    """
    sent, events, decided = _sent(scenario), [], []
    for file in files_of(run_dir):
        for stored in MessageFile(file, {EVENTS, sent} if sent else {EVENTS}):
            m = stored.message
            if stored.topic == EVENTS:
                events.append((m.step, m.code, m.text))
            else:
                decided.append((m.decided_by, m.reason))
    if decided:
        return _flown('', events, -1, np.array(decided).T)
    return _flown(_first_mode(scenario), events, last_step)


def _sent(scenario: Scenario) -> str:
    """Return the topic of the commands that say who decided; empty where none do."""
    return next((signal.name for block in scenario.diagram.blocks if block.control
                 for signal in block.writes.values()
                 if signal.message == THRUST_COMMAND
                 and {'decided_by', 'reason'} <= {part.name for part in signal.parts}), '')


def _first_mode(scenario: Scenario) -> str:
    return scenario.part('operation').mode if scenario.has_shared('mode') else ''


def _flown(mode: str, events: Iterable[tuple[int, str, str]], last_step: int,
           decided: tuple[ArrayLike, ArrayLike] | None = None) -> Flown:
    """
    Return what a run was.

    Parameters
    ----------
    mode : str
        With which it began, where commands do not say; empty: no mission's modes.
    events : iterable of (step, code, text)
    last_step : int
        Of the run, likewise; a new mode is in force from the step after its event.
    decided : (by, reason), arrays (n,) of codes, optional
        Of each command that was sent.
    """
    events = list(events)
    aborted = any(code == ABORT_EVENT for _, code, _ in events)
    pauses = sum(code == PAUSE_EVENT for _, code, _ in events)
    if decided is not None:
        pairs = Counter(zip(np.asarray(decided[0]).tolist(), np.asarray(decided[1]).tolist()))
        modes, who = Counter(), Counter()
        for (by, reason), n in pairs.items():
            modes[mode_of(by, reason)] += n
            who[ABORT if reason == codes.REASON_ABORT else DECIDERS.get(by, UNKNOWN)] += n
        return Flown(pairs.total(), dict(modes), dict(who), aborted or ABORT in modes, pauses)
    steps, modes, since = last_step + 1, Counter(), 0
    if mode:
        for step, code, text in sorted(events):
            if code == MODE_EVENT and step < last_step:
                modes[mode] += step + 1 - since
                mode, since = text.removeprefix(MODE_WORDS), step + 1
        modes[mode] += steps - since
    return Flown(steps, {name: n for name, n in modes.items() if n > 0}, {}, aborted, pauses)
