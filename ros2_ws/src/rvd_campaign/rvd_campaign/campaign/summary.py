"""
`summary.json`: what the runs of a campaign say, with intervals.
"""

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from rvd_campaign.campaign import results, stats
from rvd_campaign.campaign.engine import condition_tables, full_disk, identity, PARTS, RESULTS
from rvd_campaign.campaign.results import Table
from rvd_campaign.campaign.spec import Campaign, Condition
from rvd_campaign.flight.verdict import unknown_as_none

SUMMARY = 'summary.json'
MEANS = {'x_rate_m_s': 'closing rate', 'offset_m': 'offset', 'lateral_rate_m_s': 'lateral rate'}
EFFORT = ('delta_v_m_s', 'min_corridor_margin_m')


def finish(campaign: Campaign, folder: Path) -> dict[str, Any]:
    """
    Make `results.parquet` and return the summary of a campaign whose runs are all there.

    Raises
    ------
    ValueError
        If a run is missing or the disk is full.
    """
    conditions, success, by_replicate = [], {}, {}
    seconds = _seconds(folder, len(campaign.conditions))
    try:
        with results.result_file(folder / RESULTS, campaign.seed) as file:
            for (name, table), spent in zip(condition_tables(campaign, folder), seconds):
                file.add(name, table)
                conditions.append(of_condition(campaign.condition(name), table, spent))
                success[name] = table['success']
    except OSError as error:
        raise full_disk(folder, error) from None
    summary = {
        'campaign': campaign.name, 'title': campaign.title, 'seed': campaign.seed,
        'result_hash': file.hash, 'identity': identity(campaign), 'conditions': conditions,
        'differences': [of_pair(a, b, success[a], success[b]) for a, b in campaign.compare],
        'fitted': campaign.fitted, 'notes': [*campaign.notes, *pilot_notes(campaign)]}
    if campaign.replicates:
        size = campaign.replicates[0] * campaign.replicates[1]
        by_replicate = {name: s.reshape(-1, size).mean(axis=1) for name, s in success.items()}
        summary['replicates'] = of_replicates(campaign, by_replicate)
    return unknown_as_none(summary)


def of_condition(condition: Condition, table: Table, seconds: float) -> dict[str, Any]:
    """Return the summary of one condition."""
    good = table['success']
    runs, successes = len(good), int(good.sum())
    over_successes = {name: stats.mean(table[name][good]) for name in MEANS}
    over_all = {name: stats.mean(table[name]) for name in EFFORT}
    steps = np.maximum(table['steps'], 1)
    return {
        'name': condition.name, 'at': condition.at, 'runs': runs, 'successes': successes,
        'success_rate': successes / runs, 'wilson95': list(stats.wilson(successes, runs)),
        'means': {name: value for name, (value, _) in over_successes.items()},
        'standard_errors': {name: error for name, (_, error) in over_successes.items()},
        'reasons': dict(sorted(Counter(table['reason'].tolist()).items())),
        'means_of_all_runs': {name: value for name, (value, _) in over_all.items()},
        'share_of_steps': {
            **{by: float((table[f'steps_{by}'] / steps).mean())
               for by in ('nobody', 'pilot', 'auto', 'blend')},
            'changed': float((table['steps_changed'] / steps).mean())},
        'upper_half': float((table['y_m'][good] > 0.0).mean()) if successes else float('nan'),
        'runs_per_s': runs / seconds if seconds > 0 else float('nan')}


def of_pair(a: str, b: str, success_a: np.ndarray, success_b: np.ndarray) -> dict[str, Any]:
    """Return how the success rates of two conditions differ, run by run."""
    table = stats.pair(success_a, success_b)
    return {'a': a, 'b': b, 'difference': table.difference,
            'paired95': list(stats.newcombe_paired(table)),
            'unpaired95': list(stats.newcombe(int(success_a.sum()), table.runs,
                                              int(success_b.sum()), table.runs)),
            'only_a': table.only_a, 'only_b': table.only_b, 'p': stats.sign_test(table)}


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
        'operators': operators, 'runs': runs, 'count': len(next(iter(rates.values()))),
        'success_rate': {name: spread(values) for name, values in rates.items()},
        'differences': [
            {'a': a, 'b': b, 'same_draws': spread(rates[a] - rates[b]),
             'other_draws': spread(rates[a] - np.roll(rates[b], 1)),
             'a_not_better': float((rates[a] <= np.roll(rates[b], 1)).mean())}
            for a, b in campaign.compare]}


def pilot_notes(campaign: Campaign) -> list[str]:
    """Say what no reader of a table may overlook."""
    flown = [c.scenario for c in campaign.conditions if c.scenario.mission.operator == 'model']
    if not flown:
        return []
    return ['The pilot is a model with 28 numbers. What was fitted of them was fitted to '
            'three statistics of the paper\u2019s condition 1 (manual) and to nothing else; '
            'agreement elsewhere supports the paper, it does not prove it.']


def _seconds(folder: Path, conditions: int) -> list[float]:
    """Return the core time that each condition took [s]."""
    spent = [0.0] * conditions
    for stretch, seconds in results.finished(folder / PARTS).items():
        if stretch.condition < conditions:
            spent[stretch.condition] += seconds
    return spent


def in_words(summary: dict[str, Any]) -> str:
    """Return the table of conditions and differences as text."""
    width = max(len(c['name']) for c in summary['conditions'])
    lines = [f'{"condition":<{width}}  {"runs":>7}  success  95 %              '
             'x-rate   offset   rate']
    for c in summary['conditions']:
        low, high = c['wilson95']
        mark = ' *' if c['name'] in summary['fitted'] else ''
        lines.append(f'{c["name"]:<{width}}  {c["runs"]:>7}  {c["success_rate"]:.4f}   '
                     f'[{low:.4f}, {high:.4f}]  {_cell(c, "x_rate_m_s")}  '
                     f'{_cell(c, "offset_m")}  {_cell(c, "lateral_rate_m_s")}{mark}')
    lines += [f'* {name}: {words}' for name, words in summary['fitted'].items()]
    for d in summary['differences'][:20]:
        low, high = d['paired95']
        lines.append(f'{d["a"]} - {d["b"]}: {d["difference"]:+.4f} [{low:+.4f}, {high:+.4f}]')
    return '\n'.join(lines)


def _cell(condition: dict[str, Any], name: str) -> str:
    value = condition['means'][name]
    return '   -   ' if value is None else f'{value:.4f} '
