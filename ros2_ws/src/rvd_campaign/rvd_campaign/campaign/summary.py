"""
`summary.json`: what the runs of a campaign say, with intervals.
"""

from collections import Counter
from pathlib import Path
from textwrap import wrap
from typing import Any

import numpy as np

from rvd_campaign.campaign import beside, ensemble, results, stats
from rvd_campaign.campaign.checked import Campaign, Condition, runs_per_person
from rvd_campaign.campaign.claims import effective
from rvd_campaign.campaign.engine import condition_tables, full_disk, identity, PARTS, RESULTS
from rvd_campaign.campaign.equivalence import equivalence
from rvd_campaign.campaign.results import Table
from rvd_campaign.flight.verdict import unknown_as_none
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.in_process import judge_of
from rvd_dynamics.diagram.judge import bare_name, declared
from rvd_dynamics.given import has_shape

SUMMARY = 'summary.json'
CONFIRMED = 'confirmation'              # folder of the runs with the other seed
DURATION = 'duration_s'                 # a column of every table, though no measure of a judge
HEAD_WIDTH = 8                          # of a measure's name above its column


def finish(campaign: Campaign, folder: Path) -> dict[str, Any]:
    """
    Make `results.parquet` and return the summary of a campaign whose runs are all there.

    Raises
    ------
    ValueError
        If a run is missing or the disk is full.
    """
    conditions, success, by_replicate, kept = [], {}, {}, {}
    judge = judge_of(campaign.conditions[0].scenario)           # limits may differ, names do not
    measures = _measures(campaign, judge)
    seconds = _seconds(folder, len(campaign.conditions))
    compared, paired = {name for both in campaign.compare for name in both}, [DURATION, *measures]
    try:
        with results.result_file(folder / RESULTS, campaign.seed) as file:
            for (name, table), spent in zip(condition_tables(campaign, folder), seconds):
                file.add(name, table)
                conditions.append(of_condition(campaign.condition(name), table, spent, measures))
                success[name] = table['success']
                if name in compared:
                    kept[name] = {key: table[key] for key in paired if key in table}
    except OSError as error:
        raise full_disk(folder, error) from None
    if campaign.sample:
        sampled = ensemble.of_points(campaign, {c['name']: c for c in conditions})
        conditions = [c for c in conditions if campaign.condition(c['name']).point is None]
    summary = {
        'campaign': campaign.name, 'title': campaign.title, 'seed': campaign.seed,
        'result_hash': file.hash, 'identity': identity(campaign), 'measures': measures,
        'reasons': judge.reasons, 'conditions': conditions,
        'differences': [{**of_pair(a, b, success[a], success[b]),
                         **of_measures(success[a] & success[b], kept[a], kept[b])}
                        for a, b in campaign.compare],
        'fitted': campaign.fitted, 'notes': [*campaign.notes, *notes_of_the_mission(campaign)]}
    if campaign.sample:
        summary['ensemble'] = sampled
    beside.add(summary, campaign.beside, campaign.reference)
    if campaign.replicates:
        size = campaign.replicates[0] * campaign.replicates[1]
        by_replicate = {name: s.reshape(-1, size).mean(axis=1) for name, s in success.items()}
        summary['replicates'] = of_replicates(campaign, by_replicate)
    people = of_people(campaign, summary['conditions'])
    if people:
        summary['people'] = people
    if campaign.again:
        summary['confirmation'] = of_confirmation(campaign.again, folder / CONFIRMED)
    return unknown_as_none(summary)


def _measures(campaign: Campaign, judge: Any) -> dict[str, dict[str, Any]]:
    """Return what is measured: what the judge measures, and columns of the mission's own."""
    own = campaign.mission.column_measures
    return declared([*judge.measures, *(loaded(own) if own else ())])


REAL = (int, float)
NUMBER = (int, float, type(None))
BY_NAME = {'': NUMBER}                  # any name maps to a number
SPREAD = {'mean?': REAL, 'deviation?': REAL, 'middle95?': [REAL, 2]}
SHAPE: dict[str, Any] = {               # of what the report reads
    'title': str, 'result_hash': str, 'identity': {'': str, 'code': str}, 'fitted': {'': str},
    'notes': [str], 'reasons': {'': str},
    'measures': {'': {'words': str, 'unit': str, 'digits': int, 'of_all?': bool}},
    'conditions': [{
        'name': str, 'runs': int, 'successes': int, 'success_rate': REAL, 'runs_per_s': NUMBER,
        'wilson95': [REAL, 2], 'means': BY_NAME, 'standard_errors': BY_NAME,
        'means_of_all_runs': {'': REAL}, 'reasons': {'': int}, 'share_of_steps?': {'': REAL},
        'duration_s?': {'mean': NUMBER, 'standard_error': NUMBER}, **beside.OF_A_CONDITION}],
    'differences': [{
        'a': str, 'b': str, 'difference': REAL, 'paired95': [REAL, 2],
        'unpaired95': [REAL, 2], 'only_a': int, 'only_b': int, 'p': REAL, 'both?': int,
        'measures?': {'': {'difference': NUMBER, 'paired95': [NUMBER, 2]}}, 'band?': [REAL, 3]}],
    **beside.OF_A_SUMMARY,
    'people?': [{'reference': str, 'condition': str, 'margin': REAL, 'design_effect': REAL,
                 'difference': REAL, 'p_not_inferior': REAL, 'p_equivalent': REAL}],
    'confirmation?': {
        'seed': int, 'runs': int, 'result_hash': str,
        'conditions': [{'name': str, 'runs': int, 'successes': int, 'success_rate': REAL,
                        'wilson95': [REAL, 2]}],
        'differences': [{'a': str, 'b': str, 'difference': REAL, 'paired95': [REAL, 2],
                         'p': REAL}]},
    'ensemble?': ensemble.SHAPE,
    'replicates?': {
        'design_effect?': BY_NAME, 'count': int, 'operators': int, 'runs': int,
        'success_rate': {'': SPREAD},
        'differences': [{'a': str, 'b': str, 'same_draws': SPREAD, 'other_draws': SPREAD,
                         'a_not_better': NUMBER}]}}


def is_summary(content: Any) -> bool:
    """Say whether what was read from `summary.json` has the shape of one, and is of one piece."""
    if not has_shape(content, SHAPE) or not content['conditions']:
        return False
    conditions, repeated = content['conditions'], content.get('replicates')
    if repeated is not None and repeated['count'] >= 2 and not all(
            set(spread) == {'mean', 'deviation', 'middle95'} for spread in (
                *repeated['success_rate'].values(),
                *(d['same_draws'] for d in repeated['differences']),
                *(d['other_draws'] for d in repeated['differences']))):
        return False
    named = {reason for c in conditions for reason in c['reasons']}
    return (named <= set(content['reasons'])
            and all(set(c['means']) == set(c['standard_errors']) == set(conditions[0]['means'])
                    and set(c['means_of_all_runs']) <= set(content['measures'])
                    and 0 <= c['successes'] <= c['runs'] < 2**53 and c['runs'] > 0
                    and set(c.get('share_of_steps', {})) == set(
                        conditions[0].get('share_of_steps', {})) for c in conditions)
            and all(0 <= m['digits'] < 20 for m in content['measures'].values()))


def of_condition(condition: Condition, table: Table, seconds: float,
                 measures: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """
    Return the summary of one condition.

    Means and standard errors are over successes, of the measures that the table holds and of the
    duration; over all runs of those measures that say so (`of_all`). Those that are known in every
    run have a mean over all runs, too. Columns `steps_...` beside `steps` are counts of steps, of
    which the mean share is given.
    """
    good = table['success']
    runs, successes = len(good), int(good.sum())
    here = [name for name in measures if name in table]
    counted = {name: stats.mean(table[name] if measures[name].get('of_all') else table[name][good])
               for name in here}
    always_known = [name for name in here if not np.isnan(table[name]).any()]
    made = {
        'name': condition.name, 'at': condition.at, 'runs': runs, 'successes': successes,
        'success_rate': successes / runs, 'wilson95': list(stats.wilson(successes, runs)),
        'means': {name: value for name, (value, _) in counted.items()},
        'standard_errors': {name: error for name, (_, error) in counted.items()},
        'duration_s': dict(zip(('mean', 'standard_error'), stats.mean(table[DURATION][good]))),
        'reasons': dict(sorted(Counter(table['reason'].tolist()).items())),
        'means_of_all_runs': {name: stats.mean(table[name])[0] for name in always_known},
        'runs_per_s': runs / seconds if seconds > 0 else float('nan'),
        **_of_people(good, max(runs_per_person(condition.scenario), default=0))}
    if 'steps' in table:
        steps = np.maximum(table['steps'], 1)
        made['share_of_steps'] = {
            name.removeprefix('steps_'): float((counts / steps).mean())
            for name, counts in table.items() if name.startswith('steps_')}
    return made


def _of_people(good: np.ndarray, each: int) -> dict[str, Any]:
    """Return the interval over people who fly `each` runs in a row; nothing if nobody flies."""
    if not each:
        return {}
    firsts = np.arange(0, len(good), each)
    interval = stats.clustered(list(zip(
        np.add.reduceat(good.astype(int), firsts).tolist(),
        np.diff(firsts, append=len(good)).tolist())))
    return {'runs_per_person': each} if interval is None else {
        'runs_per_person': each, 'clustered95': list(interval)}


def of_pair(a: str, b: str, success_a: np.ndarray, success_b: np.ndarray) -> dict[str, Any]:
    """Return how the success rates of two conditions differ, run by run."""
    table = stats.pair(success_a, success_b)
    return {'a': a, 'b': b, 'difference': table.difference,
            'paired95': list(stats.newcombe_paired(table)),
            'unpaired95': list(stats.newcombe(int(success_a.sum()), table.runs,
                                              int(success_b.sum()), table.runs)),
            'only_a': table.only_a, 'only_b': table.only_b, 'p': stats.sign_test(table)}


def of_measures(both: np.ndarray, a: Table, b: Table) -> dict[str, Any]:
    """Return how the measures of two conditions differ in the runs in which both succeed."""
    found = {name: stats.mean_difference(a[name][both], b[name][both]) for name in a}
    return {'both': int(both.sum()), 'measures': {
        name: {'difference': middle, 'paired95': list(interval)}
        for name, (middle, interval) in found.items()}}


def of_replicates(campaign: Campaign, rates: dict[str, np.ndarray]) -> dict[str, Any]:
    """
    Return how experiments of the paper's size scatter.

    Differences twice: with the same draws in both conditions, as they were flown, and against
    the next replicate, other people and other draws. A real experiment has the same people
    and other draws, so its scatter lies between the two.
    """
    def spread(values: np.ndarray) -> dict[str, Any]:
        low, high = np.quantile(values, [0.025, 0.975])
        return {'mean': float(values.mean()), 'deviation': float(values.std(ddof=1)),
                'middle95': [float(low), float(high)]} if len(values) > 1 else {}

    operators, runs = campaign.replicates
    return {
        'design_effect': {name: stats.design_effect(values, operators*runs)
                          for name, values in rates.items() if len(values) > 1},
        'operators': operators, 'runs': runs, 'count': len(next(iter(rates.values()))),
        'success_rate': {name: spread(values) for name, values in rates.items()},
        'differences': [
            {'a': a, 'b': b, 'same_draws': spread(rates[a] - rates[b]),
             'other_draws': spread(rates[a] - np.roll(rates[b], 1)),
             'a_not_better': float((rates[a] <= np.roll(rates[b], 1)).mean())}
            for a, b in campaign.compare]}


def of_people(campaign: Campaign, conditions: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return how conditions stand to people's data, within the margins that are stated."""
    rows = {c['name']: c for c in conditions}
    return [
        {'reference': label, 'condition': row['condition'],
         'design_effect': float(row.get('design_effect', 1.0)),
         **equivalence(rows[row['condition']]['successes'], rows[row['condition']]['runs'],
                       *effective(row), row['margin'])._asdict()}
        for label, row in campaign.reference.items() if 'margin' in row]


def of_confirmation(again: Campaign, folder: Path) -> dict[str, Any]:
    """Return what the same conditions say with another seed."""
    whole = finish(again, folder)

    def picked(rows: list[dict[str, Any]], *keys: str) -> list[dict[str, Any]]:
        return [{key: row[key] for key in keys} for row in rows]
    return {'seed': again.seed, 'runs': again.runs, 'result_hash': whole['result_hash'],
            'conditions': picked(whole['conditions'], 'name', 'runs', 'successes', 'success_rate',
                                 'wilson95'),
            'differences': picked(whole['differences'], 'a', 'b', 'difference', 'paired95', 'p')}


def notes_of_the_mission(campaign: Campaign) -> list[str]:
    """Return what no reader of a table of this mission may overlook."""
    name = campaign.mission.campaign_notes
    return list(loaded(name)([c.scenario for c in campaign.conditions])) if name else []


def _seconds(folder: Path, conditions: int) -> list[float]:
    """Return the core time that each condition took [s]."""
    spent = [0.0] * conditions
    for stretch, seconds in results.finished(folder / PARTS).items():
        if stretch.condition < conditions:
            spent[stretch.condition] += seconds
    return spent


def in_words(summary: dict[str, Any]) -> str:
    """Return the table of conditions and differences as text."""
    measures = {name: m for name, m in summary['measures'].items()
                if name in summary['conditions'][0]['means']}
    heads = {name: [*wrap(bare_name(name, m['unit']), HEAD_WIDTH, break_long_words=False),
                    m['unit']] for name, m in measures.items()}
    digits = {name: m['digits'] for name, m in measures.items()}
    cells = [{name: _cell(c['means'][name], digits[name]) for name in measures}
             for c in summary['conditions']]
    widths = {name: max(map(len, [*heads[name], *(row[name] for row in cells)])) for name in heads}
    height = max(map(len, heads.values()), default=1)
    width = max(len(c['name']) for c in summary['conditions'])
    lines = []
    for at in range(-height, 0):
        left = f'{"condition":<{width}}  {"runs":>7}  success  95 %            ' if at == -1 \
            else ' '*(width + 36)
        heading = [f'{words[at] if at >= -len(words) else "":>{widths[name]}}'
                   for name, words in heads.items()]
        lines.append('  '.join([left, *heading]).rstrip())
    for c, row in zip(summary['conditions'], cells):
        low, high = c['wilson95']
        mark = ' *' if c['name'] in summary['fitted'] else ''
        left = (f'{c["name"]:<{width}}  {c["runs"]:>7}  {c["success_rate"]:.4f}   '
                f'[{low:.4f}, {high:.4f}]')
        lines.append('  '.join([left, *(f'{row[name]:>{widths[name]}}' for name in row)]) + mark)
    lines += [f'* {name}: {words}' for name, words in summary['fitted'].items()]
    lines += [*_compared(summary['differences']), *beside.in_words(summary)]
    lines += [f'{name}: design effect {effect:.2f}' for name, effect in
              summary.get('replicates', {}).get('design_effect', {}).items() if effect is not None]
    lines += [f'{p["condition"]} against {p["reference"]}, margin {p["margin"]:g}: '
              f'{p["difference"]:+.4f}, p {p["p_not_inferior"]:.2g} not inferior, '
              f'{p["p_equivalent"]:.2g} equivalent' for p in summary.get('people', ())]
    again = summary.get('confirmation')
    if again:
        lines.append(f'again, seed {again["seed"]}, {again["runs"]} runs:')
        lines += [f'{c["name"]:<{width}}  {c["runs"]:>7}  {c["success_rate"]:.4f}   '
                  f'[{c["wilson95"][0]:.4f}, {c["wilson95"][1]:.4f}]' for c in again['conditions']]
        lines += [*_compared(again['differences']),
                  f'again: result hash {again["result_hash"]}']
    lines += ensemble.in_words(summary['ensemble']) if 'ensemble' in summary else []
    return '\n'.join(lines)


def _compared(differences: list[dict[str, Any]]) -> list[str]:
    return [f'{d["a"]} - {d["b"]}: {d["difference"]:+.4f} '
            f'[{d["paired95"][0]:+.4f}, {d["paired95"][1]:+.4f}]' for d in differences[:20]]


def _cell(value: float | None, digits: int) -> str:
    return '-' if value is None else f'{value:.{digits}f}'
