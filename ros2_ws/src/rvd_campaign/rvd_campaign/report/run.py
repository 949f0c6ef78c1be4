"""
`report.html`: one page that tells a run from its bag alone, and stands by itself.

No script, no request to anywhere; prints; light or dark as the reader's system is.
"""

from collections import Counter
from math import isfinite
from pathlib import Path
import re

from rvd_dynamics.recording.reader import LINK_COUNTS, LinkHistory, read, Recording
from rvd_campaign.report.figures import svg
from rvd_campaign.report.page import CAPTIONS, Drawn, render
from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.judge import Judged
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.bag_writer import repair

YES, NO, DASH = '\u2713', '\u2717', '\u2013'
DECIDED = {codes.BY_NOBODY: 'nobody (no valid input)', codes.BY_PILOT: 'pilot alone',
           codes.BY_AUTO: 'automatic controller alone', codes.BY_BLEND: 'pilot and automatic',
           codes.BY_GUARD: 'onboard guard'}
REFUSED = {codes.REASON_LENGTH: 'length', codes.REASON_CHECKSUM: 'checksum',
           codes.REASON_ORDER: 'order', codes.REASON_AGE: 'age', codes.REASON_RANGE: 'range'}


def write_report(run_dir: Path) -> Path:
    """
    Write the report of a run folder (or a bag folder) from its bag; return where it is.

    A bag that was cut off is repaired first, and the report says what is missing in it.

    Raises
    ------
    ValueError
        If there is no bag, or the page cannot be written.
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
    text = page(read(run_dir))
    try:
        whole.write_text(target, text)
    except OSError as error:
        raise ValueError(f'cannot write {target}: {error.strerror}') from None
    return target


def page(run: Recording) -> str:
    """Return the report as HTML."""
    mark, kind = '?', 'open'
    if run.judged:
        mark, kind = (YES, 'good') if run.verdict.success else (NO, 'bad')
    shown = run.verdict.measures if run.verdict else ()
    return render(
        'run.html.j2', title=headline(run), mark=mark, kind=kind, facts=_facts(run),
        warnings=_warnings(run), verdict=run.verdict, judged=run.judged,
        measures=[(m, _used(m)) for m in shown if m.known or m.limited],
        figures=[Drawn(title, svg(name, run), caption)
                 for name, (title, caption) in CAPTIONS.items() if run.last_step >= 0],
        links=_link_rows(run), decided=_decided_rows(run), refused=_refused(run),
        empty=int((run.onboard.reason == codes.REASON_EMPTY).sum()),
        events=[(f'{e.t:.1f}', e.node, e.code, e.text) for e in run.events],
        topics=[(topic, n, run.missing.get(topic, ''), run.lost.get(topic, 0))
                for topic, n in run.counts.items()],
        scenario=run.scenario_text)


def headline(run: Recording) -> str:
    """Return the verdict in words."""
    return run.verdict.headline if run.judged else (
        'no verdict: the recording ends before the run does')


def _facts(run: Recording) -> list[tuple[str, str, str]]:
    """Return what the header says below the verdict: words before, value, words after."""
    mission = run.mission
    name = re.match(r'# Scenario (\S+)', run.scenario_text)
    return [('scenario ', name[1] if name else 'unknown', ''), ('mode ', mission.mode, ''),
            ('operator ', mission.operator, ''), ('seed ', str(mission.seed), ''),
            ('run ', str(mission.run), ''), ('step ', f'{mission.step_s:g} s', ''),
            ('delay ', f'{mission.forward_delay_s:g} + {mission.back_delay_s:g} s', '')]


def _warnings(run: Recording) -> list[str]:
    """Return sentences that say what the bag does not hold; none if it holds everything."""
    said = []
    where = (f'at step {run.last_step} ({run.last_step * run.mission.step_s:g} s)'
             if run.last_step >= 0 else 'before the first step')
    if not run.closed:
        said.append(f'The bag was cut off {where}; it holds nothing that came later.')
    elif not run.ended:
        said.append(f'The recording was stopped {where}, before the run ended.')
    if any(run.missing.values()):
        said.append(f'Steps missing from the bag: {_listed(run.missing)}.')
    if any(run.lost.values()):
        said.append(f'Received but not stored: {_listed(run.lost)}.')
    if run.trouble:
        said.append(f'The recorder reported: {run.trouble}.')
    if not run.scenario_text:
        said.append('The bag holds no scenario: default settings are assumed below.')
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


def _link_rows(run: Recording) -> list[list[str]]:
    links = (run.forward, run.back)
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
    by = Counter(run.ground.decided_by.tolist())
    total = max(len(run.ground.step), 1)
    return [(DECIDED.get(who, str(who)), n, f'{100 * n / total:.0f} %')
            for who, n in sorted(by.items())]


def _refused(run: Recording) -> str:
    refused = Counter(r for r in run.onboard.reason.tolist() if r in REFUSED)
    return ', '.join(f'{n} for {REFUSED[r]}' for r, n in sorted(refused.items())) or 'none'
