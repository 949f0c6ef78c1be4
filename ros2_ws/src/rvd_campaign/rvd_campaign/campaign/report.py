"""
`report.html` of a campaign: one page that stands by itself and prints.
"""

import json
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

import matplotlib

from rvd_campaign.campaign import results, stats
from rvd_campaign.campaign.engine import open_folder, RESULTS
from rvd_campaign.campaign.figures import FIGURES, NEEDED, Results
from rvd_campaign.campaign.spec import CampaignError
from rvd_campaign.campaign.summary import SUMMARY
from rvd_dynamics.recording.drawing import STYLE as LOOK
from rvd_dynamics.recording.drawing import svg
from rvd_campaign.report.page import STYLE
from rvd_dynamics.recording import whole

LONG = 60                               # rows of a table that a page shows
BY = {'pilot': 'pilot alone', 'auto': 'automatic alone', 'blend': 'both, blended',
      'nobody': 'nobody', 'changed': 'command differs from the stick'}
DASH, DOT = '\u2013', ' \u00b7 '
MORE_STYLE = '''
td.mark{color:var(--vermillion)}tr.reference td{color:var(--muted);font-style:italic}
td{vertical-align:top}table.numbers td+td{white-space:nowrap}
table.numbers td+td,table.numbers th+th{padding-left:.6rem}th,td{padding-right:.7rem}
code{font-size:.85rem;overflow-wrap:anywhere}
.scroll{overflow-x:auto}
@media print{table{font-size:8.5pt}th,td{padding-right:.5rem}
table.numbers td+td,table.numbers th+th{padding-left:.5rem}figure.tall{break-inside:auto}}
'''


def write_campaign_report(folder: Path) -> Path:
    """
    Write the report of a campaign folder from its results; return where it is.

    Raises
    ------
    CampaignError
        If the folder has no results yet, or those of another version.
    """
    target = folder / 'report.html'
    whole.write_text(target, page(read(folder)))
    return target


def read(folder: Path) -> Results:
    """Return what a campaign folder says; errors as `write_campaign_report`."""
    campaign, _ = open_folder(folder)
    try:
        summary = json.loads((folder / SUMMARY).read_text(encoding='utf-8'))
        if not {'measures', 'reasons'} <= set(summary):
            raise CampaignError(f'{folder / SUMMARY} is of another version of this software, '
                                'which alone can report on it')
        return Results(campaign, summary, dict(results.tables(folder / RESULTS, NEEDED)))
    except OSError:
        raise CampaignError(f'{folder} has no results yet: finish it with ./rvd campaign '
                            f'--resume {folder}') from None


def picture(folder: Path, name: str, path: Path) -> None:
    """Write a figure of `FIGURES` as a PNG on white, for pages that cannot hold a drawing."""
    with matplotlib.rc_context({**LOOK, 'savefig.facecolor': 'white'}):
        FIGURES[name][1](read(folder))[0].savefig(path, dpi=110, format='png')


def page(made: Results) -> str:
    """Return the report as HTML."""
    campaign, summary = made.campaign, made.summary
    title = campaign.title or f'Campaign {campaign.name}'
    sections = [
        *(f'<p class="warning">{escape(note)}</p>' for note in summary['notes']),
        _section('Conditions', _conditions(summary, campaign.reference) + _fitted(summary)),
        _section('Differences', _differences(summary)),
        _replicates(summary),
        *(_figure(name, made) for name in campaign.figures or ('success',)),
        _section('How runs ended', _reasons(summary)),
        _section('Who decided', _decided(summary)),
        _section('To repeat', _repeat(made)),
        '<section><details><summary><h2>Campaign file</h2></summary>'
        f'<pre>{escape(campaign.text)}</pre></details></section>']
    facts = [f'campaign <b>{escape(campaign.name)}</b>',
             f'<b>{len(campaign.conditions)}</b> conditions',
             f'<b>{campaign.runs:,}</b> runs each', f'seed <b>{campaign.seed}</b>']
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<title>{escape(title)}</title><style>{STYLE}{MORE_STYLE}</style></head><body>'
        f'<header><h1>{escape(title)}</h1><p>{DOT.join(facts)}</p></header>'
        f'<main>{"".join(sections)}</main></body></html>\n')


def _section(title: str, body: str) -> str:
    return f'<section><h2>{title}</h2>{body}</section>' if body else ''


def _table(head: Iterable[str], rows: Iterable[tuple[str, Iterable[str]]]) -> str:
    cells = ''.join(f'<th>{h}</th>' for h in head)
    lines = [f'<tr class="{kind}">' + ''.join(f'<td>{c}</td>' for c in row) + '</tr>'
             for kind, row in rows]
    cut = f'<p>The first {LONG} of {len(lines)}; all are in summary.json.</p>' \
        if len(lines) > LONG else ''
    return ('<div class="scroll"><table class="wide numbers"><thead><tr>'
            f'{cells}</tr></thead><tbody>{"".join(lines[:LONG])}</tbody></table></div>{cut}')


def _conditions(summary: dict[str, Any], reference: dict[str, dict]) -> str:
    measures = _tabled(summary)

    def row(name: str, r: dict[str, Any], mark: str) -> list[str]:
        low, high = stats.wilson(r['successes'], r['runs'])
        means, errors = r.get('means', {}), r.get('standard_errors', {})
        return [escape(name) + mark, f'{r["runs"]:,}', f'{r["successes"] / r["runs"]:.4f}',
                f'{low:.4f} {DASH} {high:.4f}',
                *(_mean(means.get(key), errors.get(key), m['digits'])
                  for key, m in measures.items())]

    rows = [('', row(c['name'], c, ' \u2020' if c['name'] in summary['fitted'] else ''))
            for c in summary['conditions']]
    rows += [('reference', row(label, r, '')) for label, r in reference.items()]
    head = ('condition', 'runs', 'success', '95 % (Wilson)', *_heads(measures.values()))
    return _table(head, rows) + '<p>Means are over successes, \u00b1 one standard error.</p>'


def _tabled(summary: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the measures that the result table holds."""
    return {name: m for name, m in summary['measures'].items()
            if name in summary['conditions'][0]['means']}


def _heads(measures: Iterable[dict[str, Any]]) -> list[str]:
    return [f'{escape(m["words"])}<br>{escape(m["unit"])}' for m in measures]


def _mean(value: float | None, error: float | None, digits: int) -> str:
    if value is None:
        return DASH
    return f'{value:.{digits}f}' + (f' \u00b1 {error:.{digits}f}' if error is not None else '')


def _fitted(summary: dict[str, Any]) -> str:
    if not summary['fitted']:
        return ''
    said = ''.join(f'<li>{escape(name)}: {escape(words)}.</li>'
                   for name, words in summary['fitted'].items())
    return f'<p>\u2020 Fitted, not predicted:</p><ul>{said}</ul>'


def _differences(summary: dict[str, Any]) -> str:
    if not summary['differences']:
        return ''
    rows = [('', [f'{escape(d["a"])} minus {escape(d["b"])}', f'{d["difference"]:+.4f}',
                  f'{d["paired95"][0]:+.4f} \u2026 {d["paired95"][1]:+.4f}',
                  f'{d["unpaired95"][0]:+.4f} \u2026 {d["unpaired95"][1]:+.4f}',
                  f'{d["only_a"]:,} : {d["only_b"]:,}', _p(d['p'])])
            for d in summary['differences']]
    return _table(('success rates', 'difference', '95 %, paired', '95 %, unpaired',
                   'only the one : only the other', 'p'), rows) + (
        '<p>Conditions share their random draws run by run, so they are paired. Intervals: '
        'Newcombe\u2019s method 10 for paired and for independent proportions; p: exact sign test '
        'on the runs that differ. Intervals and p are for one comparison each; of twenty '
        'comparisons without any effect one is expected to exclude 0.</p>')


def _p(value: float) -> str:
    return '< 1e-6' if value < 1e-6 else f'{value:.2g}'


def _replicates(summary: dict[str, Any]) -> str:
    made = summary.get('replicates')
    if not made or made['count'] < 2:
        return ''
    rows = [('', [escape(name), f'{s["mean"]:.3f}', f'{s["deviation"]:.3f}',
                  f'{s["middle95"][0]:.2f} {DASH} {s["middle95"][1]:.2f}'])
            for name, s in made['success_rate'].items()]
    for d in made['differences']:
        for kind, words in (('same_draws', 'same draws'), ('other_draws', 'other draws')):
            s = d[kind]
            rows.append(('', [f'{escape(d["a"])} minus {escape(d["b"])}, {words}',
                              f'{s["mean"]:+.3f}', f'{s["deviation"]:.3f}',
                              f'{s["middle95"][0]:+.2f} {DASH} {s["middle95"][1]:+.2f}']))
    said = ''.join(f'<p>{escape(d["a"])} was not better than {escape(d["b"])} in '
                   f'{100*d["a_not_better"]:.1f} % of the experiments with other draws.</p>'
                   for d in made['differences'])
    title = (f'{made["count"]:,} experiments of {made["operators"]} pilots and {made["runs"]} '
             'runs each')
    return _section(title, _table(('', 'mean', 'deviation', 'middle 95 %'), rows) + said)


def _reasons(summary: dict[str, Any]) -> str:
    words = summary['reasons']
    found = sorted({reason for c in summary['conditions'] for reason in c['reasons']},
                   key=list(words).index)
    always = [{name: m for name, m in _tabled(summary).items() if name in c['means_of_all_runs']}
              for c in summary['conditions']]
    measures = {name: m for name, m in always[0].items() if all(name in a for a in always)}
    rows = [('', [escape(c['name']), *(f'{c["reasons"].get(r, 0):,}' for r in found),
                  *(f'{c["means_of_all_runs"][name]:.{m["digits"]}f}'
                    for name, m in measures.items())])
            for c in summary['conditions']]
    return _table(('condition', *(escape(words[r]) for r in found), *_heads(measures.values())),
                  rows) + ('<p>Measures are means over all runs.</p>' if measures else '')


def _decided(summary: dict[str, Any]) -> str:
    shares = [c.get('share_of_steps', {}) for c in summary['conditions']]
    if not shares[0]:
        return ''
    rows = [('', [escape(c['name']), *(f'{100*share[by]:.1f} %' for by in shares[0])])
            for c, share in zip(summary['conditions'], shares)]
    return _table(('share of steps', *(BY.get(by, by) for by in shares[0])), rows)


def _figure(name: str, made: Results) -> str:
    title, draw = FIGURES[name]
    said = []

    def drawing() -> Any:
        figure, caption = draw(made)
        said.append(caption)
        return figure
    picture = svg(name, drawing)
    tall = ' class="tall"' if name in ('tracks', 'landing') else ''
    return (f'<figure{tall}><h2>{title}</h2>{picture}'
            f'<figcaption>{escape(said[0])}</figcaption></figure>')


def _repeat(made: Results) -> str:
    summary, campaign = made.summary, made.campaign
    packages = ', '.join(f'{name} {version}' for name, version in summary['identity'].items()
                         if name not in ('settings', 'code'))
    rates = [c['runs_per_s'] for c in summary['conditions'] if c['runs_per_s']]
    rate = f', {min(rates):,.0f} to {max(rates):,.0f} runs per core and second' if rates else ''
    first = campaign.conditions[0].name
    return (
        f'<p><code>./rvd campaign {escape(campaign.name)} --runs {campaign.runs}</code> gives '
        f'result hash <code>{summary["result_hash"]}</code> with {escape(packages)} and these '
        f'sources ({summary["identity"]["code"][:12]}){rate}.</p>'
        '<p>Any run again, over DDS, with the same verdict: <code>./rvd fly --from DIR '
        f'--condition "{escape(first)}" --run 0</code></p>')
