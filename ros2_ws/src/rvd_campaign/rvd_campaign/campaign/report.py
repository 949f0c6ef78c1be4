"""
`report.html` of a campaign: one page that stands by itself and prints.
"""

import shlex
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import TemplateError
import pyarrow

from rvd_campaign.campaign import beside, results, stats
from rvd_campaign.campaign.checked import CampaignError
from rvd_campaign.campaign.engine import open_folder, RESULTS
from rvd_campaign.campaign.figures import needed, Results, shown_by
from rvd_campaign.campaign.summary import DURATION, is_summary, SUMMARY
from rvd_campaign.report.page import Drawn, render
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.given import object_of
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.drawing import CampaignFigure, svg
from rvd_dynamics.recording.worded import worded

NO_SUMMARY = (LookupError, TypeError, ValueError, AttributeError, TemplateError)
LONGEST = 60                            # rows of a table that a page shows
SHORT = 8                               # conditions whose table may come before the figures
DASH = '\u2013'
TIME = {'words': 'time', 'unit': 's', 'digits': 1}
BY = {'pilot': 'pilot alone', 'auto': 'automatic controller alone', 'blend': 'both, blended',
      'nobody': 'nobody', 'changed': 'command differs from the stick'}
Cell = str | tuple[str, str]            # text, or two lines of it


class Table(NamedTuple):
    """A table of the page."""

    heads: list[Cell]
    rows: list[tuple[str, list[Cell]]]  # class of the row, its cells


def write_campaign_report(folder: Path) -> Path:
    """
    Write the report of a campaign folder from its results; return where it is.

    Raises
    ------
    CampaignError
        If the folder has no results yet, or those of another version.
    """
    made = read(folder)
    try:
        text = page(made)
    except NO_SUMMARY as error:
        if is_summary(made.summary):
            raise                               # a fault of ours
        raise CampaignError(f'{folder / SUMMARY} is damaged ({type(error).__name__}: {error})'
                            f'{_make_again(folder)}') from None
    return whole.save(folder / 'report.html', text)


def read(folder: Path) -> Results:
    """Return what a campaign folder says; errors as `write_campaign_report`."""
    campaign, _ = open_folder(folder)
    try:
        if not (folder / SUMMARY).exists():
            raise FileNotFoundError
        summary = object_of(folder / SUMMARY, 'summary of a campaign')
        if not {'measures', 'reasons'} <= set(summary):
            raise CampaignError(f'{folder / SUMMARY} is of another version of this software, '
                                'which alone can report on it')
        return Results(campaign, summary, {
            name: table for name, table in results.tables(folder / RESULTS, needed(campaign))
            if campaign.condition(name).point is None})
    except FileNotFoundError:
        raise CampaignError(f'{folder} has no results yet: finish it with ./rvd campaign '
                            f'--resume {shlex.quote(str(folder))}') from None
    except OSError as error:
        raise CampaignError(f'cannot read the results in {folder}: {error}') from None
    except CampaignError:
        raise
    except (BadInput, pyarrow.ArrowException, KeyError, IndexError) as error:
        raise CampaignError(f'the results in {folder} are damaged: {error}'
                            f'{_make_again(folder)}') from None


def _make_again(folder: Path) -> str:
    return f': make them again with ./rvd campaign --resume {shlex.quote(str(folder))}'


def page(made: Results) -> str:
    """Return the report as HTML."""
    campaign, summary = made.campaign, made.summary
    averaged = _known_in_every_run(summary)
    rates = [c['runs_per_s'] for c in summary['conditions'] if c['runs_per_s']]
    return render(
        'campaign.html.j2', title=campaign.title or f'Campaign {campaign.name}',
        longest=LONGEST, short=SHORT, notes=summary['notes'],
        fitted={worded(name): why for name, why in summary['fitted'].items()},
        facts=[('campaign ', campaign.name, ''), ('', len(campaign.conditions), ' conditions'),
               ('', f'{campaign.runs:,}', ' runs each'), ('seed ', campaign.seed, '')],
        conditions=_conditions(summary, campaign.reference), differences=_differences(summary),
        of_all=[m['words'] for m in _tabled(summary).values() if m.get('of_all')],
        measured=_measured(summary), sources=beside.sources(summary),
        over_people=beside.in_clusters(summary),
        replicates=_replicates(summary), ensemble=_ensemble(summary),
        people=_people(summary), again=_again(summary),
        figures=[_figure(name, figure, made) for name, figure in shown_by(campaign).items()],
        endings=_endings(summary, averaged), averaged=bool(averaged), decided=_decided(summary),
        name=campaign.name, runs=campaign.runs, first=campaign.conditions[0].name,
        named=_named(summary),
        result_hash=summary['result_hash'], source=summary['identity']['code'][:12],
        packages=', '.join(f'{name} {version}' for name, version in summary['identity'].items()
                           if name not in ('settings', 'code')),
        rates=f'{min(rates):,.0f} to {max(rates):,.0f}' if rates else '', text=campaign.text)


def _conditions(summary: dict[str, Any], reference: dict[str, dict]) -> Table:
    measures = _tabled(summary)
    over_people = beside.in_clusters(summary)
    banded = any('band' in c for c in summary['conditions'])
    people = summary.get('reference', {})

    def more(r: dict[str, Any]) -> list[Cell]:
        return ([_interval(r.get('clustered95'))] if over_people else []) + (
            [_interval(r.get('band'))] if banded else [])

    def row(name: str, r: dict[str, Any]) -> list[Cell]:
        low, high = stats.wilson(r['successes'], r['runs'])
        means, errors = r.get('means', {}), r.get('standard_errors', {})
        flown = r.get('duration_s', {})
        return [name, f'{r["runs"]:,}', f'{r["successes"] / r["runs"]:.4f}',
                f'{low:.4f} {DASH} {high:.4f}', *more({**people.get(name, {}), **r}),
                _mean(flown.get('mean'), flown.get('standard_error'), TIME['digits']),
                *(_mean(means.get(key), errors.get(key), m['digits'])
                  for key, m in measures.items())]

    rows = [('', row(worded(c['name']) + (' \u2020' if c['name'] in summary['fitted'] else ''), c))
            for c in summary['conditions']]
    rows += [('reference', row(label, r)) for label, r in reference.items()]
    return Table(['condition', 'runs', 'success', '95 % (Wilson)',
                  *(['95 % (over people)'] if over_people else []), *(['band'] if banded else []),
                  *_heads({DURATION: TIME, **measures})], rows)


def _tabled(summary: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the measures that the result table holds."""
    return {name: m for name, m in summary['measures'].items()
            if name in summary['conditions'][0]['means']}


def _known_in_every_run(summary: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the measures that have a mean over all runs in every condition."""
    return {name: m for name, m in _tabled(summary).items()
            if all(name in c['means_of_all_runs'] for c in summary['conditions'])}


def _heads(measures: dict[str, dict[str, Any]]) -> list[tuple[str, str]]:
    return [(m['words'], m['unit']) for m in measures.values()]


def _mean(value: float | None, error: float | None, digits: int) -> Cell:
    if value is None:
        return DASH
    return f'{value:.{digits}f}', '' if error is None else f'\u00b1 {error:.{digits}f}'


def _interval(values: list[float] | None, sign: str = '') -> Cell:
    return DASH if values is None else f'{values[0]:{sign}.4f} \u2026 {values[-1]:{sign}.4f}'


def _differences(summary: dict[str, Any]) -> Table:
    banded = any('band' in d for d in summary['differences'])
    rows = [('', [_minus(d), f'{d["difference"]:+.4f}',
                  f'{d["paired95"][0]:+.4f} \u2026 {d["paired95"][1]:+.4f}',
                  f'{d["unpaired95"][0]:+.4f} \u2026 {d["unpaired95"][1]:+.4f}',
                  *([_interval(d.get('band'), '+')] if banded else []),
                  f'{d["only_a"]:,} : {d["only_b"]:,}', _p(d['p'])])
            for d in summary['differences']]
    return Table(['success rates', 'difference', '95 %, paired', '95 %, unpaired',
                  *(['band'] if banded else []), 'only the first : only the second', 'p'], rows)


def _people(summary: dict[str, Any]) -> Table:
    """Return how conditions stand to people's data; no rows where no margin is stated."""
    rows = [('', [f'{worded(p["condition"])} minus {p["reference"]}', f'{p["difference"]:+.4f}',
                  f'{p["margin"]:g}', f'{p["design_effect"]:g}', _p(p['p_not_inferior']),
                  _p(p['p_equivalent'])]) for p in summary.get('people', ())]
    return Table(['success rates', 'difference', 'margin', 'design effect', 'p, not inferior',
                  'p, equivalent'], rows)


def _again(summary: dict[str, Any]) -> dict[str, Any] | None:
    """Return what was flown with another seed, beside the first."""
    made = summary.get('confirmation')
    if made is None:
        return None

    def both(value: float, interval: list[float], sign: str) -> Cell:
        return f'{value:{sign}.4f}', f'{interval[0]:{sign}.4f} \u2026 {interval[1]:{sign}.4f}'
    first = {(d['a'], d['b']): d for d in summary['differences']}
    rates = {c['name']: c for c in summary['conditions']}
    rows = [('', [_minus(d), *(both(of['difference'], of['paired95'], '+')
                               for of in (first[d['a'], d['b']], d)), _p(d['p'])])
            for d in made['differences'] if (d['a'], d['b']) in first]
    rows += [('', [worded(c['name']), *(both(of['success_rate'], of['wilson95'], '')
                                        for of in (rates[c['name']], c)), ''])
             for c in made['conditions'] if c['name'] in rates]
    return {'heads': ['', f'seed {summary["seed"]}', f'seed {made["seed"]}', 'p'], 'rows': rows,
            'seed': made['seed'], 'runs': made['runs'], 'result_hash': made['result_hash']}


def _measured(summary: dict[str, Any]) -> Table:
    """Return the paired differences of measures; no rows where a folder is older than they are."""
    measures = {DURATION: TIME, **_tabled(summary)}

    def cell(found: dict[str, Any] | None, digits: int) -> Cell:
        if found is None or found['difference'] is None:
            return DASH
        low, high = found['paired95']
        interval = '' if low is None else f'{low:+.{digits}f} \u2026 {high:+.{digits}f}'
        return f'{found["difference"]:+.{digits}f}', interval
    rows = [('', [_minus(d), f'{d["both"]:,}',
                  *(cell(d['measures'].get(name), m['digits'] + 1)
                    for name, m in measures.items())])
            for d in summary['differences'] if 'measures' in d]
    return Table(['means, run by run', 'runs', *_heads(measures)], rows)


def _minus(pair: dict[str, Any]) -> str:
    return f'{worded(pair["a"])} minus {worded(pair["b"])}'


def _named(summary: dict[str, Any]) -> list[tuple[str, str]]:
    """Return the conditions in words with their names, where these are others."""
    names = [c['name'] for c in summary['conditions']][:LONGEST]
    return [(worded(name), name) for name in names] if any(
        worded(name) != name for name in names) else []


def _p(value: float) -> str:
    return '< 1e-6' if value < 1e-6 else f'{value:.2g}'


def _replicates(summary: dict[str, Any]) -> dict[str, Any] | None:
    made = summary.get('replicates')
    if not made or made['count'] < 2:
        return None
    rows = [('', [worded(name), f'{s["mean"]:.3f}', f'{s["deviation"]:.3f}',
                  f'{s["middle95"][0]:.2f} {DASH} {s["middle95"][1]:.2f}',
                  _rounded(made.get('design_effect', {}).get(name))])
            for name, s in made['success_rate'].items()]
    for d in made['differences']:
        for kind, words in (('same_draws', 'same draws'), ('other_draws', 'other draws')):
            s = d[kind]
            rows.append(('', [f'{_minus(d)}, {words}', f'{s["mean"]:+.3f}',
                              f'{s["deviation"]:.3f}',
                              f'{s["middle95"][0]:+.2f} {DASH} {s["middle95"][1]:+.2f}', '']))
    return {'title': f'{made["count"]:,} experiments with {made["operators"]} pilots and '
                     f'{made["runs"]} runs each',
            'heads': ['', 'mean', 'standard deviation', 'middle 95 %', 'design effect'],
            'rows': rows,
            'differences': [{**d, 'a': worded(d['a']), 'b': worded(d['b'])}
                            for d in made['differences']]}


def _rounded(value: float | None) -> str:
    return DASH if value is None else f'{value:.2f}'


def _ensemble(summary: dict[str, Any]) -> dict[str, Any] | None:
    """Return the tables of a sample."""
    made = summary.get('ensemble')
    if not made:
        return None

    def extent(values: list[float] | None) -> Cell:
        return DASH if values is None else (f'{values[0]:.3f} {DASH} {values[2]:.3f}',
                                            f'median {values[1]:.3f}')

    def index(row: dict[str, Any], which: str) -> Cell:
        return DASH if row[which] is None else (f'{row[which]:.2f}',
                                                f'\u00b1 {row[which + "95"]:.2f}')
    chosen = made['accepted']
    return {
        'bands': Table(['', 'as it is', f'{made["latin_hypercube"]} points', 'those that agree'], [
            ('', [worded(b['output']), f'{b["fit"]:.3f}', extent(b['all']),
                  extent(b['accepted'])]) for b in made['bands']]),
        'indices': Table(['', 'numbers', 'first order', 'total'], [
            ('', [worded(i['output']), i['group'], index(i, 'first'), index(i, 'total')])
            for i in made['indices']]),
        'agree': '' if chosen is None else (
            f'{len(chosen["points"])} of the {made["latin_hypercube"]} points agree with '
            f'{chosen["reference"]} within {chosen["standard_errors"]:g} standard errors.'),
        'ranges': [(f'{n["section"]}.{n["key"]}', n['group'], f'{n["low"]:g} to {n["high"]:g}')
                   for n in made['numbers']]}


def _endings(summary: dict[str, Any], averaged: dict[str, dict[str, Any]]) -> Table:
    words = summary['reasons']
    found = sorted({reason for c in summary['conditions'] for reason in c['reasons']},
                   key=list(words).index)
    rows = [('', [worded(c['name']), *(f'{c["reasons"].get(reason, 0):,}' for reason in found),
                  *(f'{c["means_of_all_runs"][name]:.{m["digits"]}f}'
                    for name, m in averaged.items())])
            for c in summary['conditions']]
    return Table(['condition', *(words[reason] for reason in found), *_heads(averaged)], rows)


def _decided(summary: dict[str, Any]) -> Table:
    shares = {c['name']: c.get('share_of_steps', {}) for c in summary['conditions']}
    by = next(iter(shares.values()))
    rows = [('', [worded(name), *(f'{100*share[who]:.1f} %' for who in by)])
            for name, share in shares.items() if share]
    return Table(['share of steps', *(BY.get(who, who) for who in by)], rows)


def _figure(name: str, figure: CampaignFigure, made: Results) -> Drawn:
    said = []

    def drawing() -> Any:
        drawn, caption = figure.draw(made)
        said.append(caption)
        return drawn
    return Drawn(figure.title, svg(name, drawing), said[0], figure.tall)
