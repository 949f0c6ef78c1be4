"""
The page of a campaign: well formed, by itself, and saying what was fitted.
"""

import copy
from dataclasses import replace
import io
import json
from random import Random
import re
import shutil
from unittest import mock
import xml.etree.ElementTree

import matplotlib
import numpy as np
import pytest
from scipy.stats import ttest_rel

from rvd_campaign.campaign import report, results, stats
from rvd_campaign.campaign.engine import fly_campaign, KEPT, RESULTS, start, Workers
from rvd_campaign.campaign.figures import figures_of, needed, Results
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.report import page, write_campaign_report
from rvd_campaign.campaign.spec import CampaignError, parse_campaign
from rvd_campaign.campaign.summary import finish, in_words, SUMMARY
from rvd_dynamics.diagram.mission import find
from rvd_dynamics.recording.drawing import STYLE, svg
from rvd_missions.lunar_approach.campaign_figures import flown_again

FIGURES = figures_of(find('lunar_approach'))

TEXT = '''
# Two <conditions> & a grid
seed: 2
runs: 20
set: {pilot: A, operator_model: {runs_per_operator: 5}}
conditions:
  manual: {/**: {mode: manual}}
  shared: {}
grid: {loop_delay_s: [4, 10]}
replicates: {operators: 2, runs: 5}
compare: [['shared,loop_delay_s=10', 'manual,loop_delay_s=10']]
fitted: {'manual,loop_delay_s=10': it was fitted to <this>}
reference:
  paper: {condition: 'manual,loop_delay_s=10', at: 10, runs: 100, successes: 76,
          means: {offset_m: 0.1444}}
figures: [success, curve, landing, tracks, failures, comparison, replicates]
notes: [a note & more]
'''


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    """A finished campaign with every figure."""
    where = tmp_path_factory.mktemp('campaign')
    campaign = parse_campaign(TEXT.lstrip(), 'pages')
    start(campaign, where)
    fly_campaign(campaign, where, Workers(), Progress(io.StringIO()))
    (where / SUMMARY).write_text(json.dumps(finish(campaign, where)))
    return where


@pytest.fixture(scope='module')
def made(folder):
    summary = json.loads((folder / SUMMARY).read_text())
    campaign = parse_campaign(TEXT.lstrip(), 'pages')
    tables = dict(results.tables(folder / RESULTS, needed(campaign)))
    return Results(campaign, summary, tables)


@pytest.fixture(scope='module')
def whole(folder):
    """The result table with all its columns, by condition."""
    return dict(results.tables(folder / RESULTS))


@pytest.fixture(scope='module')
def html(folder):
    return write_campaign_report(folder).read_text()


def test_page_is_whole_and_asks_nobody_for_anything(html):
    body = html.removeprefix('<!DOCTYPE html>\n')
    for name in ('meta charset="utf-8"', 'meta name="viewport" content="width=device-width, '
                 'initial-scale=1"'):
        body = body.replace(f'<{name}>', '')
    body = body.replace('<br>', '').replace('<html ', '<html xmlns:xlink="x" ', 1)
    xml.etree.ElementTree.fromstring(body)
    assert '<script' not in html
    assert not re.findall(r'(?:src|href)="(?!#)[^"]*"', html)
    assert len(html) < 3_000_000


def test_ids_of_figures_do_not_meet(html):
    ids = re.findall(r'\bid="([^"]*)"', html)
    assert ids and len(set(ids)) == len(ids)


def test_page_shows_every_figure_and_table(html):
    assert html.count('<svg') == 7
    assert list(FIGURES) == ['success', 'curve', 'differences', 'ensemble', 'replicates', 'landing',
                             'tracks', 'failures', 'comparison', 'consistency', 'cluttered']
    left_out = ('differences', 'ensemble', 'consistency', 'cluttered')
    for name, figure in FIGURES.items():        # those that the campaign asks for
        assert (figure.title in html) == (name not in left_out)
    for words in ('Differences', 'How runs ended', 'Who decided', 'How to reproduce',
                  'Campaign file', 'paper', '0.1444'):
        assert words in html


def test_what_was_fitted_is_said_beside_the_table(html):
    table = html[html.index('<h2>Conditions'):html.index('<h2>Differences')]
    assert table.count('\u2020') == 2
    assert 'Fitted, not predicted' in table and 'it was fitted to &lt;this&gt;.' in table
    assert 'does not prove it' in html and 'a note &amp; more' in html


def test_conditions_are_named_in_words_and_their_names_stand_once(html):
    shown, names = html.split('<summary>Names of the conditions', 1)
    assert 'manual, loop delay 10 s' in shown and 'shared, loop delay 4 s' in shown
    first = '--condition "manual,loop_delay_s=4"'
    assert first in shown and 'loop_delay_s=' not in shown.replace(first, '')
    assert '<td>manual, loop delay 10 s</td><td>manual,loop_delay_s=10</td>' in names


@pytest.mark.parametrize('rows, first', [(report.SHORT - 1, '<table'), (report.SHORT, '<svg')])
def test_figures_come_before_a_long_table(made, rows, first):
    one = made.summary['conditions'][0]         # and a reference makes one row more
    summary = {**made.summary, 'conditions': [{**one, 'name': f'c {i}'} for i in range(rows)],
               'differences': [], 'fitted': {}, 'replicates': None}
    figure = {'success': FIGURES['success']}
    with mock.patch.object(report, 'shown_by', lambda campaign: figure):
        html = page(Results(made.campaign, summary, made.tables))
    assert html.count('<table') > 1
    assert min(('<table', '<svg'), key=html.index) == first


def test_every_figure_has_a_text_for_those_who_do_not_see_it(html):
    texts = re.findall(r'<svg [^>]*aria-label="([^"]{40,})"', html)
    assert len(texts) == html.count('<svg')
    assert any('manual, loop delay 10 s' in text for text in texts)


def test_what_is_seen_along_the_flight_has_z_to_the_right_and_y_up_as_the_console(made):
    figure, _ = FIGURES['landing'].draw(made)
    assert [figure.axes[0].get_xlabel()[0], figure.axes[0].get_ylabel()[0]] == ['z', 'y']
    table = made.tables[made.shown[0].name]
    good = table['success']
    dots = figure.axes[0].lines[0].get_xydata()
    np.testing.assert_array_equal(dots, np.stack([table['z_m'][good], table['y_m'][good]], axis=1))
    figure, _ = FIGURES['tracks'].draw(made)
    side, top = (axes.get_ylim() for axes in figure.axes[:2])
    assert side[0] < side[1] and top[0] > top[1]


def test_words_of_people_are_escaped(html):
    assert 'Two &lt;conditions&gt; &amp; a grid' in html


def test_intervals_of_the_page_are_those_of_the_summary(html, made):
    for c in made.summary['conditions']:
        low, high = c['wilson95']
        assert f'{low:.4f} \u2013 {high:.4f}' in html


def test_paired_differences_of_measures_are_over_the_runs_that_succeed_in_both(html, made, whole):
    d, = made.summary['differences']
    a, b = (whole[d[key]] for key in 'ab')
    both = a['success'] & b['success']
    assert d['both'] == both.sum() > 2
    for name in ('delta_v_m_s', 'duration_s', 'min_corridor_margin_m'):
        found = d['measures'][name]
        expected = ttest_rel(a[name][both], b[name][both])
        np.testing.assert_allclose(found['difference'], (a[name] - b[name])[both].mean())
        np.testing.assert_allclose(found['paired95'], expected.confidence_interval(0.95))
    low, high = d['measures']['delta_v_m_s']['paired95']
    assert f'{low:+.4f} \u2026 {high:+.4f}' in html and 'the runs in which both succeed' in html


def test_the_mean_time_of_a_condition_is_over_its_successes(html, made, whole):
    for c in made.summary['conditions']:
        table = whole[c['name']]
        mean = table['duration_s'][table['success']].mean()
        np.testing.assert_allclose(c['duration_s']['mean'], mean)
        assert f'<td>{mean:.1f}<br>' in html


def test_terminal_table_marks_what_was_fitted(made):
    lines = in_words(made.summary).splitlines()
    marked = [line for line in lines if line.endswith('*')]
    assert len(marked) == 1 and marked[0].startswith('manual,loop_delay_s=10')
    assert any('it was fitted' in line for line in lines)


def test_tracks_are_those_of_the_table(made):
    condition = made.campaign.conditions[-1]
    table = made.tables[condition.name]
    states = flown_again(condition.scenario, table)
    assert states.shape[1] == min(table['success'].sum(), 40)
    for run, track in enumerate(states.transpose(1, 0, 2)):
        last = track[np.isfinite(track[:, 0])][-1]
        row = np.flatnonzero(table['success'])[run]
        assert last[0] >= 0.0                   # at most one step past the plane
        np.testing.assert_allclose(last[1:3], (table['y_m'][row], table['z_m'][row]), atol=0.02)


def test_figures_hold_the_runs_they_say(made):
    with matplotlib.rc_context(STYLE):
        figure, _ = FIGURES['landing'].draw(made)
        axes = figure.axes[0]
        shown = axes.lines[0].get_xydata()
        table = made.tables[made.campaign.conditions[0].name]
        good = table['success']
        np.testing.assert_array_equal(shown, np.column_stack([table['z_m'], table['y_m']])[good])
        assert (np.hypot(*shown.T) < 0.3).all()
        figure, _ = FIGURES['curve'].draw(made)
        np.testing.assert_allclose(
            figure.axes[0].lines[0].get_ydata(),
            [made.rows[f'manual,loop_delay_s={d}']['success_rate'] for d in (4, 10)])


@pytest.mark.parametrize('successes, runs', [(950, 1000), (1000, 1000)])
def test_failures_are_shown_beside_successes_where_these_crowd(made, successes, runs):
    """The rate and its interval mirrored; where nothing failed its upper end alone."""
    rows = [{**row, 'runs': runs, 'successes': successes, 'success_rate': successes/runs}
            for row in made.summary['conditions']]
    crowded = replace(made, summary={**made.summary, 'conditions': rows})
    low, high = stats.wilson(successes, runs)
    with matplotlib.rc_context(STYLE):
        figure, caption = FIGURES['success'].draw(crowded)
        assert 'logarithmic' in caption and len(figure.axes) == 2
        bar, dot = figure.axes[1].lines[:2]
        assert figure.axes[1].get_xscale() == 'log' and bar.get_xdata()[1] == 1.0 - low
        assert bar.get_xdata()[0] == pytest.approx(1.0 - high if successes < runs else 0.1/runs)
        assert dot.get_xdata()[0] == pytest.approx(1.0 - (successes/runs if successes < runs
                                                          else low))
        figure, _ = FIGURES['success'].draw(made)
        assert len(figure.axes) == 1 + (max(r['success_rate'] for r in made.rows.values()) > 0.9)


def test_the_figure_of_differences_holds_those_of_the_summary(made):
    with matplotlib.rc_context(STYLE):
        figure, caption = FIGURES['differences'].draw(made)
    pairs = made.summary['differences']
    drawn = [line.get_xdata() for panel in figure.axes for line in panel.lines]
    for pair in pairs:
        assert any(list(x) == pair['paired95'] for x in drawn)
        assert any(list(x) == [pair['difference']] for x in drawn)
    assert 'one is expected to exclude 0' in caption


def test_replicates_are_groups_of_runs_in_their_order(made):
    table = made.tables['manual,loop_delay_s=10']
    rates = [table['success'][:10].mean(), table['success'][10:].mean()]
    kept = made.summary['replicates']
    assert kept['count'] == 2
    assert kept['success_rate']['manual,loop_delay_s=10']['mean'] == pytest.approx(np.mean(rates))


def test_a_campaign_where_nobody_succeeds_has_a_page(tmp_path):
    campaign = parse_campaign(
        'runs: 5\nset: {/**: {mode: manual, operator: none}}\n'
        'figures: [success, curve, landing, tracks, failures]\n', 'lost')
    start(campaign, tmp_path)
    fly_campaign(campaign, tmp_path, Workers(), Progress(io.StringIO()))
    summary = finish(campaign, tmp_path)
    assert summary['conditions'][0]['means']['offset_m'] is None
    assert 'not a prediction' in page(Results(
        campaign, summary, dict(results.tables(tmp_path / RESULTS, needed(campaign)))))


def test_no_results_no_page(tmp_path):
    start(parse_campaign('runs: 5', 'x'), tmp_path)
    with pytest.raises(CampaignError, match='has no results yet: finish it with'):
        write_campaign_report(tmp_path)


@pytest.mark.parametrize('name, data', [
    (SUMMARY, b'{"a'), (SUMMARY, b'\xff'), (SUMMARY, b'[]'), (RESULTS, b''),
    (RESULTS, b'PAR1 and no more')])
def test_damaged_results_are_refused_with_the_way_to_make_them_again(folder, tmp_path, name, data):
    shutil.copytree(folder, tmp_path / 'a copy')
    (tmp_path / 'a copy' / name).write_bytes(data)
    with pytest.raises(CampaignError, match="--resume '.*/a copy'|another version"):
        write_campaign_report(tmp_path / 'a copy')


def changed(rng, tree):
    """Change one thing in a tree of JSON: what it is, or that it is there."""
    while True:
        key = rng.choice(list(tree) if isinstance(tree, dict) else range(len(tree)))
        if isinstance(tree[key], (dict, list)) and tree[key] and rng.random() < 0.7:
            tree = tree[key]
            continue
        if rng.random() < 0.3:
            del tree[key]
        else:
            tree[key] = rng.choice((None, 'x', -1, 1e308, [], {}, [[1]], {'a': 1}, True, 10**30))
        return


@pytest.mark.parametrize('name', [SUMMARY, KEPT])
def test_files_of_another_shape_are_a_page_or_one_line(folder, tmp_path, monkeypatch, name):
    monkeypatch.setattr(report, 'shown_by', lambda campaign: {})        # they take a second each
    shutil.copytree(folder, tmp_path / 'copy')
    content, refused = json.loads((folder / name).read_text()), 0
    for seed in range(50):
        rng, tree = Random(seed), copy.deepcopy(content)
        for _ in range(rng.choice((1, 1, 3))):
            changed(rng, tree)
        (tmp_path / 'copy' / name).write_text(json.dumps(tree))
        try:
            write_campaign_report(tmp_path / 'copy')
        except CampaignError as error:
            assert str(error).isprintable()
            refused += 1
    assert 5 < refused < 50                    # the shape is told from what it holds


def test_a_fault_of_the_report_is_not_blamed_on_the_file(folder, monkeypatch):
    """The negative twin."""
    monkeypatch.setattr(report, 'render', lambda *args, **content: {}['figures'])
    with pytest.raises(KeyError):
        write_campaign_report(folder)


def test_drawing_twice_gives_the_same_bytes(made):
    def once():
        return svg('success', lambda: FIGURES['success'].draw(made)[0])
    assert once() == once()
