"""
`report.html`: one page that tells a run from its bag alone, and stands by itself.

No script, no request to anywhere; prints; light or dark as the reader's system is.
"""

from collections import Counter
from html import escape
import math
from pathlib import Path
from typing import Iterable

from rvd_campaign.report.figures import figures_of
from rvd_campaign.report.page import STYLE
from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.judge import Judged
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.bag_writer import repair
from rvd_dynamics.recording.drawing import Figure, svg
from rvd_dynamics.recording.reader import read
from rvd_dynamics.recording.recording import Recording
from rvd_dynamics.recording.series import Commands, LinkHistory

YES, NO, DASH, DOT = '\u2713', '\u2717', '\u2013', ' \u00b7 '
DECIDED = {codes.BY_NOBODY: 'nobody (no valid input)', codes.BY_PILOT: 'pilot alone',
           codes.BY_AUTO: 'automatic alone', codes.BY_BLEND: 'pilot and automatic',
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
    words = headline(run)
    sections = [
        _banner(run),
        f'<section><h2>Verdict</h2>{_verdict_table(run)}</section>',
        *(_figure(name, figure, run) for name, figure in figures_of(run).items()),
        f'<section><h2>Link counts</h2>{_link_table(run)}</section>' if run.links else '',
        _commands(run),
        f'<section><h2>Events</h2>{_events(run)}</section>',
        f'<section><h2>Recording</h2>{_recording_table(run)}</section>',
        _scenario(run)]
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<title>{escape(words)}</title><style>{STYLE}</style></head><body>'
        f'{_header(run, words)}<main>{"".join(sections)}</main></body></html>\n')


def headline(run: Recording) -> str:
    """Return the verdict in words."""
    return run.verdict.headline if run.judged else (
        'no verdict: the recording ends before the run does')


def _header(run: Recording, words: str) -> str:
    mark, kind = '?', 'open'
    if run.judged:
        mark, kind = (YES, 'good') if run.verdict.success else (NO, 'bad')
    facts = [f'{escape(name)} <b>{escape(value)}</b>' for name, value in facts_of(run)]
    return (f'<header class="{kind}"><h1><span class="mark">{mark}</span> '
            f'{escape(words[0].upper() + words[1:])}</h1><p>{DOT.join(facts)}</p></header>')


def facts_of(run: Recording) -> list[tuple[str, str]]:
    """Return what there is to say about a run before it began: names and values."""
    facts = [('scenario', run.name or 'unknown')]
    scenario = run.scenario
    if scenario is None:
        return facts
    facts.append(('mission', scenario.mission.name))
    if scenario.has_shared('operator'):
        operation = scenario.part('operation')
        facts += [('mode', operation.mode), ('operator', operation.operator)]
    facts += [('seed', str(scenario.run.seed)), ('run', str(scenario.run.run)),
              ('step', f'{scenario.run.step_s:g} s')]
    delays = ' + '.join(f'{link.hold_s:g}' for link in run.links.values())
    return [*facts, ('delay', f'{delays} s')] if delays else facts


def _banner(run: Recording) -> str:
    """Say plainly what the bag does not hold; nothing if it holds everything."""
    said = []
    where = 'before the first step' if run.last_step < 0 else f'at step {run.last_step}'
    if run.scenario is not None and run.last_step >= 0:
        where += f' ({run.last_step * run.scenario.run.step_s:g} s)'
    if not run.closed:
        said.append(f'The bag was cut off {where}; what came after that is not in it.')
    elif not run.ended:
        said.append(f'The recording was stopped {where}, before the run ended.')
    if any(run.missing.values()):
        said.append(f'Steps that are not in the bag: {_listed(run.missing)}.')
    if any(run.lost.values()):
        said.append(f'Received but not stored: {_listed(run.lost)}.')
    if run.trouble:
        said.append(f'The recorder said: {escape(run.trouble)}.')
    if run.scenario is None:
        said.append(f'There are no figures: {escape(run.scenario_trouble)}.')
    elif run.scenario_trouble:
        said.append(f'Settings were left out: {escape(run.scenario_trouble)}.')
    return f'<p class="warning">{" ".join(said)}</p>' if said else ''


def _listed(counts: dict[str, int]) -> str:
    """Return counts per topic, or their sum where there are many."""
    given = {topic: n for topic, n in counts.items() if n}
    if len(given) > 4:
        return f'{sum(given.values())} messages of {len(given)} topics (see Recording below)'
    return ', '.join(f'{n} of {escape(topic)}' for topic, n in given.items())


def _table(head: Iterable[str], rows: Iterable[Iterable[str]], kind: str = '') -> str:
    cells = ''.join(f'<th>{h}</th>' for h in head)
    body = ''.join('<tr>' + ''.join(f'<td>{c}</td>' for c in row) + '</tr>' for row in rows)
    return f'<table class="{kind}"><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table>'


def _verdict_table(run: Recording) -> str:
    if run.verdict is None:
        return '<p>The bag holds no verdict.</p>'
    shown = [m for m in run.verdict.measures if m.known or m.limited]
    rows = [(escape(m.words), escape(m.said), escape(m.limits), _meter(m),
             (YES if m.ok else NO) if m.limited and m.known else '') for m in shown]
    end = 'end' if run.judged else 'the last judgement in the bag'
    return (_table(('measure', 'value', 'limit', 'used', ''), rows, 'wide')
            + f'<p>{run.verdict.duration:.2f} s from start to {end}.</p>')


def _meter(m: Judged) -> str:
    """Return a bar that says how much of an upper limit is used; nothing if there is none."""
    if not (m.known and m.high > 0.0):
        return ''
    share = min(max(m.value / m.high, 0.0), 1.0)
    return (f'<span class="meter"><span style="width:{100 * share:.0f}%" '
            f'class="{"good" if m.ok else "bad"}"></span></span>')


def _figure(name: str, figure: Figure, run: Recording) -> str:
    return (f'<figure><h2>{escape(figure.title)}</h2>{svg(name, lambda: figure.draw(run))}'
            f'<figcaption>{escape(figure.caption)}</figcaption></figure>')


def _link_table(run: Recording) -> str:
    links = {name: link.history for name, link in run.links.items()}
    rows = [[name.replace('_', ' ')] + [str(link.last.get(name, '')) for link in links.values()]
            for name in LINK_COUNTS]
    for name, text in (('delay_p50', 'measured transit, median'), ('delay_p99', '99th percentile'),
                       ('delay_max', 'largest'), ('play_out_delay', 'constant delay made of it')):
        rows.append([text] + [_seconds(link.last.get(name)) for link in links.values()])
    rows.append(['balance'] + [_balance(link) for link in links.values()])
    return _table(('frames', *links), rows, 'numbers')


def _seconds(value: float | None) -> str:
    if value is None:
        return ''
    return f'{value:.3f} s' if math.isfinite(value) else DASH


def _balance(link: LinkHistory) -> str:
    """Return the balance of the last counts as a sum that can be checked by eye."""
    last = link.last
    if not last:
        return 'never heard'
    left = last['sent'] + last['duplicated']
    right = sum(int(last[name]) for name in LINK_COUNTS[2:9])
    return f'{left} = {right} {YES}' if left == right else f'{left} \u2260 {right} {NO}'


def _commands(run: Recording) -> str:
    """Return who decided, and what the guard refused, where commands are of our message type."""
    tables = ''.join(map(_decided, decisions(run)))
    thrust = None if run.scenario is None else run.of(run.scenario.diagram.thrust)
    refused = _refused(thrust) if isinstance(thrust, Commands) and len(thrust) else ''
    return f'<section><h2>Commands</h2>{tables}{refused}</section>' if tables + refused else ''


def decisions(run: Recording) -> list[Commands]:
    """Return the commands of the blocks that take orders from `/run/control`."""
    if run.scenario is None:
        return []
    made = [run.of(signal) for block in run.scenario.diagram.blocks if block.control
            for signal in block.writes.values()]
    return [series for series in made if isinstance(series, Commands) and len(series)]


def _decided(commands: Commands) -> str:
    by, total = Counter(commands.decided_by.tolist()), len(commands)
    rows = [(DECIDED.get(who, str(who)), str(n), f'{100 * n / total:.0f} %')
            for who, n in sorted(by.items())]
    return _table(('decided by', 'steps', 'share'), rows, 'numbers')


def _refused(thrust: Commands) -> str:
    refused = Counter(r for r in thrust.reason.tolist() if r in REFUSED)
    text = ', '.join(f'{n} for {REFUSED[r]}' for r, n in sorted(refused.items())) or 'none'
    empty = int((thrust.reason == codes.REASON_EMPTY).sum())
    return (f'<p>Commands the onboard guard refused: {text}. '
            f'Steps without a command on board: {empty}.</p>')


def _events(run: Recording) -> str:
    if not run.events:
        return '<p>None.</p>'
    return _table(('time [s]', 'node', 'code', ''),
                  ((f'{e.t:.1f}', escape(e.node), escape(e.code), escape(e.text))
                   for e in run.events), 'wide')


def _recording_table(run: Recording) -> str:
    rows = [(escape(topic), str(n), str(run.missing.get(topic, '')), str(run.lost.get(topic, 0)))
            for topic, n in run.counts.items()]
    return _table(('topic', 'messages', 'steps missing', 'not stored'), rows, 'numbers')


def _scenario(run: Recording) -> str:
    if not run.scenario_text:
        return ''
    return ('<section><details><summary><h2>Scenario as flown</h2></summary>'
            f'<pre>{escape(run.scenario_text)}</pre></details></section>')
