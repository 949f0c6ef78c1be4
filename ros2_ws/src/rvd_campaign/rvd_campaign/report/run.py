"""
`report.html`: one page that tells a run from its bag alone, and stands by itself.

No script, no request to anywhere; prints; light or dark as the reader's system is.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from math import isfinite
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rvd_campaign.report.figures import figures_of
from rvd_campaign.report.page import Drawn, render
from rvd_campaign.report.told import given_up, is_in, once, Told, told_by
from rvd_dynamics.bad_input import BadInput, one_line
from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.judge import Judged
from rvd_dynamics.diagram.roster import ENDED_EARLY, GIVEN_UP, SECOND_WRITER, SILENT
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.bag_writer import repair
from rvd_dynamics.recording.drawing import Figure, svg
from rvd_dynamics.recording.flown import ABORT, of_recording, UNKNOWN
from rvd_dynamics.recording.reader import read
from rvd_dynamics.recording.recording import Recording
from rvd_dynamics.recording.series import Commands, LinkHistory, Series, SERIES, Table
from rvd_dynamics.recording.worded import worded

MOST_EVENTS = 1000              # rows of the table of events
MOST_SILENCES = 10              # of them that stand above, too
LONG = 10                       # rows of measures that push the figures off the screen
LARGEST = 1e12                  # no quantity of a run is larger; a figure of what is may fail
YES, NO, DASH = '\u2713', '\u2717', '\u2013'
DECIDED = {codes.BY_NOBODY: 'nobody (no valid input)', codes.BY_PILOT: 'pilot alone',
           codes.BY_AUTO: 'automatic controller alone', codes.BY_BLEND: 'pilot and automatic',
           codes.BY_GUARD: 'onboard guard'}
ABORTED = 255                   # no BY code: an ABORT in force leaves nobody a choice
DECIDED[ABORTED] = 'the ABORT in force'
REFUSED = {codes.REASON_LENGTH: 'length', codes.REASON_CHECKSUM: 'checksum',
           codes.REASON_ORDER: 'order', codes.REASON_AGE: 'age', codes.REASON_RANGE: 'range'}


def write_report(run_dir: Path) -> Path:
    """
    Write the report of a run folder (or a bag folder) from its bag; return where it is.

    A bag that was cut off is repaired first, and the report says what is missing in it, or cannot
    be read.

    Raises
    ------
    ValueError
        If there is no bag or nothing in it can be read, or if the page cannot be written.
    """
    run_dir = Path(run_dir)
    folder = run_dir / 'bag' if (run_dir / 'bag').is_dir() else run_dir
    if folder.is_dir():
        try:
            repair(folder)
        except OSError:
            pass                                # read as it is
    home = run_dir.parent if run_dir.is_file() or folder == run_dir and run_dir.name == 'bag' \
        else run_dir
    target = home / 'report.html'
    told = told_by(home / 'verdict.json')
    try:
        run = read(run_dir)
        if run.damage and not any(run.counts.values()):
            raise BadInput(f'{run_dir}: no report: {"; ".join(run.damage)}')
    except BadInput as error:
        if not told.given_up:
            raise
        raise BadInput(f'{error}; the flight was given up: {told.given_up}') from None
    return whole.save(target, page(run, told.doubts, told))


def page(run: Recording, doubts: Iterable[str] = (), told: Told = Told()) -> str:
    """
    Return the report as HTML.

    Parameters
    ----------
    doubts : iterable of str
        Why the flight is not to be trusted.
    told : Told
        What the flight said beside its bag.
    """
    series = _AsFarAsReadable(run)
    run = replace(run, series=series)
    doubts = once([*doubts, *(e.text for e in run.events if e.code == SECOND_WRITER)])
    mark, kind = '?', 'open'
    if run.judged and not doubts:
        mark, kind = (YES, 'good') if run.verdict.success else (NO, 'bad')
    first, further = _measures(run.verdict.measures if run.verdict else ())
    links = {name: link.history for name, link in run.links.items()}
    drawn = [_drawn(name, figure, run) for name, figure in figures_of(run).items()]
    content = dict(
        legs=list(links), links=_link_rows(list(links.values())), decided=_decided_rows(run),
        refused=_refused(run))
    return render(
        'run.html.j2',
        title=headline(run, bool(doubts), bool(given_up(run, told)), told.ended_by),
        mark=mark, kind=kind, facts=_facts(run),
        warnings=[*(f'Not to be trusted: {doubt}.' for doubt in doubts), *_warnings(run, told),
                  *_damage(run, series), *(d for d in drawn if isinstance(d, str))],
        verdict=run.verdict, judged=run.judged,
        measures=[(m, _used(m)) for m in first], further=[(m.words, m.said) for m in further],
        figures=[d for d in drawn if isinstance(d, Drawn)],
        events=_events(run),
        topics=[(topic, n, run.missing.get(topic, ''), run.lost.get(topic, 0))
                for topic, n in run.counts.items()],
        scenario=run.scenario_text, **content)


def _measures(judged: Iterable[Judged]) -> tuple[list[Judged], list[Judged]]:
    """Return the measures of the verdict, and those for below the figures, of a long table."""
    shown = [m for m in judged if m.known or m.limited]
    limited = [m for m in shown if m.limited]
    if len(shown) <= LONG or not limited:
        return shown, []
    return limited, [m for m in shown if not m.limited]


class _AsFarAsReadable(Mapping):
    """The series of a run; one that cannot be read has no rows, and it is known why."""

    def __init__(self, run: Recording) -> None:
        self._series, self._kinds = run.series, run.kinds
        self.trouble: dict[str, str] = {}

    def __getitem__(self, topic: str) -> Series:
        try:
            return self._series[topic]
        except BadInput as error:
            self.trouble[topic] = str(error)
            return SERIES[self._kinds[topic]].of([])

    def __iter__(self) -> Iterator[str]:
        return iter(self._series)

    def __len__(self) -> int:
        return len(self._series)

    def left_out(self) -> list[str]:
        """Return, as sentences, what could not be read, so far."""
        of_series = getattr(self._series, 'left_out', list)()
        return [*of_series, *self.trouble.values()]


def _damage(run: Recording, series: _AsFarAsReadable) -> list[str]:
    """Return what of the bag cannot be read, as sentences with their full stop."""
    said = dict.fromkeys([*run.damage, *series.left_out()])
    return [f'{sentence.rstrip(".")}.' for sentence in said]


def _drawn(name: str, figure: Figure, run: Recording) -> Drawn | str:
    """Return a figure, or the sentence that says that the numbers of this bag allow of none."""
    try:
        with np.errstate(all='ignore'):
            return Drawn(figure.title, svg(name, lambda: figure.draw(run)), figure.caption)
    except Exception as error:                  # of matplotlib, of the figures of a mission
        if not _is_doubtful(run):
            raise
        return (f'The figure {figure.title!r} cannot be drawn of these numbers '
                f'({type(error).__name__}: {one_line(str(error))[:200]}).')


def _is_doubtful(run: Recording) -> bool:
    """Say whether something of a bag is damaged, or holds numbers that no run has."""
    if run.damage or run.series.left_out():
        return True
    return any(_is_beyond(column) for series in run.series.values()
               for column in vars(series).values())


def _is_beyond(column: object) -> bool:
    if isinstance(column, dict):
        return any(_is_beyond(part) for part in column.values())
    if not isinstance(column, np.ndarray) or column.dtype.kind not in 'fiu':
        return False
    known = column[~np.isnan(column)] if column.dtype.kind == 'f' else column
    return bool((np.abs(known.astype(float)) > LARGEST).any())


def _events(run: Recording) -> list[tuple[str, str, str, str]]:
    """Return the rows of the table of events, the first ones where there are too many."""
    rows = [(f'{e.t:.1f}', e.node, e.code, e.text) for e in run.events[:MOST_EVENTS]]
    more = len(run.events) - len(rows)
    return [*rows, ('', '', '', f'and {more} more')] if more else rows


def headline(run: Recording, doubtful: bool = False, gave_up: bool = False, ended_by: str = ''
             ) -> str:
    """
    Return the verdict in words.

    Parameters
    ----------
    doubtful : bool
        It is not to be trusted.
    gave_up : bool
        The flight was given up, so that there is none.
    ended_by : str
        Who ended the flight before its end, likewise; empty where nobody did.
    """
    said = run.verdict.headline if run.judged else (
        'no verdict: the flight was given up' if gave_up else
        f'no verdict: {ended_by}{_after(run)}' if ended_by else
        'no verdict: the recording ends before the run does')
    return f'not to be trusted: {said}' if doubtful else said


def _after(run: Recording) -> str:
    """Return when the recording ends, as words after others."""
    if run.scenario is None or run.last_step < 0:
        return ''
    return f' after {run.last_step * run.scenario.run.step_s:.1f} s'


def _facts(run: Recording) -> list[tuple[str, str, str]]:
    """Return what the header says below the verdict: words before, value, words after."""
    facts, scenario = [('scenario ', run.name or 'unknown', '')], run.scenario
    if scenario is None:
        return facts
    facts.append(('mission ', worded(scenario.mission.name), ''))
    if scenario.has_shared('operator'):
        operation = scenario.part('operation')
        facts += [('mode ', _modes(run, operation.mode), ''),
                  ('operator ', worded(operation.operator), '')]
    facts += [('seed ', str(scenario.run.seed), ''), ('run ', str(scenario.run.run), ''),
              ('step ', f'{scenario.run.step_s:g} s', '')]
    delays = ' + '.join(f'{link.hold_s:g}' for link in run.links.values())
    return [*facts, ('delay ', f'{delays} s', '')] if delays else facts


def _modes(run: Recording, asked: str) -> str:
    """Return the modes that were flown, with the share of each where they are several."""
    modes = {name: n for name, n in of_recording(run).modes.items() if name != ABORT}
    if set(modes) <= {asked} or set(modes) == {UNKNOWN}:
        return asked
    whole = sum(modes.values())
    return ', '.join(f'{name} {100 * n / whole:.0f} %' for name, n in modes.items())


def _warnings(run: Recording, told: Told) -> list[str]:
    """Return sentences that say what the bag does not hold; none if it holds everything."""
    said = []
    why = given_up(run, told)
    if why and not is_in(why, run.events):
        said.append(f'The flight was given up: {one_line(why).rstrip(".")}.')
    where = 'before the first step' if run.last_step < 0 else f'at step {run.last_step}'
    if run.scenario is not None and run.last_step >= 0:
        where += f' ({run.last_step * run.scenario.run.step_s:g} s)'
    if not run.closed:
        said.append(f'The bag was cut off {where}; it holds nothing that came later.')
    elif not run.ended:
        said.append(f'The recording was stopped {where}, before the run ended.')
    silences = [(e.t, e.text) for e in run.events if e.code in (SILENT, ENDED_EARLY, GIVEN_UP)]
    silences += [(t, text) for t, text in told.silences if not is_in(text, run.events)]
    said += [f'At {t:.1f} s: {one_line(text)}.' for t, text in sorted(silences)[:MOST_SILENCES]]
    if any(run.missing.values()):
        said.append(f'Steps missing from the bag: {_listed(run.missing)}.')
    if any(run.lost.values()):
        said.append(f'Received but not stored: {_listed(run.lost)}.')
    if run.trouble:
        said.append(f'The recorder reported: {run.trouble}.')
    if run.scenario is None:
        said.append(f'There are no figures: {run.scenario_trouble}.')
    elif run.scenario_trouble:
        said.append(f'Some settings were left out: {run.scenario_trouble}.')
    return said


def _listed(counts: dict[str, int]) -> str:
    """Return counts per topic, or their sum where there are many."""
    given = {topic: n for topic, n in counts.items() if n}
    if len(given) > 4:
        return f'{sum(given.values())} messages of {len(given)} topics (see Recording below)'
    return ', '.join(f'{n} of {topic}' for topic, n in given.items())


def _used(m: Judged) -> float | None:
    """Return which part of an upper limit is used, 0 to 1; None where there is none to show."""
    return min(max(m.value / m.high, 0.0), 1.0) if m.known and m.high > 0.0 else None


def _link_rows(links: list[LinkHistory]) -> list[list[str]]:
    rows = [[name.replace('_', ' '), *(str(link.last.get(name, '')) for link in links)]
            for name in LINK_COUNTS]
    rows += [[words, *(_seconds(link.last.get(name)) for link in links)]
             for name, words in (('delay_p50', 'transit time, median'),
                                 ('delay_p99', 'transit time, 99th percentile'),
                                 ('delay_max', 'transit time, largest'),
                                 ('play_out_delay', 'constant delay after the play-out buffer'))]
    return [*rows, ['balance', *map(_balance, links)]]


def _seconds(value: float | None) -> str:
    if value is None:
        return ''
    return f'{value:.3f} s' if isfinite(value) else DASH


def _balance(link: LinkHistory) -> str:
    """Return the balance of the last counts as a sum that can be checked by eye."""
    last = link.last
    if not last:
        return 'never heard'
    left = last['sent'] + last['duplicated']
    right = sum(int(last[name]) for name in LINK_COUNTS[2:9])
    return f'{left} = {right} {YES}' if left == right else f'{left} \u2260 {right} {NO}'


def _decided_rows(run: Recording) -> list[tuple[str, int, str]]:
    """Return who decided how often, of the commands of the block that obeys `/run/control`."""
    decided = [ABORTED if why == codes.REASON_ABORT else who
               for series in _commands_of_control(run)
               for who, why in zip(series.decided_by.tolist(), series.reason.tolist())]
    return [(DECIDED.get(who, str(who)), n, f'{100 * n / len(decided):.0f} %')
            for who, n in sorted(Counter(decided).items())]


def _commands_of_control(run: Recording) -> list[Commands]:
    blocks = () if run.scenario is None else run.scenario.diagram.blocks
    written = [run.of(signal) for block in blocks if block.control
               for signal in block.writes.values()]
    return [series for series in written
            if isinstance(series, Commands) and series.decided_by is not None]


def _refused(run: Recording) -> tuple[str, int] | None:
    """Return what the guard refused in words, and how many steps it had no command for."""
    thrust = None if run.scenario is None else run.of(run.scenario.diagram.thrust)
    reason = _reasons(thrust)
    if reason is None or not len(reason):
        return None
    refused = Counter(r for r in reason.tolist() if r in REFUSED)
    words = ', '.join(f'{n} for {REFUSED[r]}' for r, n in sorted(refused.items())) or 'none'
    return words, int((reason == codes.REASON_EMPTY).sum())


def _reasons(thrust: Series | None) -> NDArray | None:
    """Return why the guard commanded what it did, a code per step; None if it is not recorded."""
    if isinstance(thrust, Commands):
        return thrust.reason
    return thrust.parts.get('reason') if isinstance(thrust, Table) else None
