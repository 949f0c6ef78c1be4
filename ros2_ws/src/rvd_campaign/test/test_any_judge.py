"""A judge with two measures of its own: table, summary, report and verdict file take them."""

import io
import math
from dataclasses import replace
from unittest.mock import patch

from matplotlib.figure import Figure
import numpy as np
import pytest
import small_run

from rvd_campaign.campaign import figures, report, results, summary
from rvd_campaign.campaign.spec import parse_campaign
from rvd_campaign.flight import verdict as flight_verdict
from rvd_campaign.report import run as run_report
from rvd_dynamics.diagram.judge import declared, judgement, Measure, Verdict
from rvd_dynamics.diagram.in_process import Batch
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.drawing import CampaignFigure
from rvd_dynamics.recording.reader import read

MEASURES = (Measure('miss_rad', 'rad', 'pointing <miss>', high=0.1, digits=2),
            Measure('fuel_kg', 'kg', 'fuel burnt', digits=1))
REASONS = {'pointed': 'pointed & held', 'missed': 'pointed elsewhere'}
MISS = np.array([0.05, 0.2, np.nan, 0.07])
FUEL = np.array([1.0, 2.0, 3.0, 4.0])


class Judge:
    measures, reasons = MEASURES, REASONS


def flight(**columns):
    """Return four runs that this judge has judged, with columns of the mission."""
    good = MEASURES[0].ok(MISS)
    verdict = Verdict(good, np.where(good, 'pointed', 'missed'), np.full(4, 9.0),
                      {'miss_rad': MISS, 'fuel_kg': FUEL})
    return Batch(np.arange(4), np.full(4, 18), verdict, columns, None)


def test_the_table_is_the_verdict_the_measures_and_what_the_mission_adds():
    assert list(results.rows(flight())) == [
        'run', 'success', 'reason', 'duration_s', 'miss_rad', 'fuel_kg']
    assert list(results.rows(flight(steps=np.full(4, 18))))[-2:] == ['fuel_kg', 'steps']
    table = results.rows(flight(steps=np.full(4, 18)), ('run', 'steps', 'success', 'miss_rad'))
    assert list(table) == ['run', 'steps', 'success', 'miss_rad']
    np.testing.assert_array_equal(table['miss_rad'], MISS)


def test_an_order_of_what_there_is_not_is_refused():
    with pytest.raises(ValueError, match='no column fule_kg: there are run, success, reason'):
        results.rows(flight(), ('run', 'fule_kg'))


def test_a_column_that_no_table_can_hold_is_refused():
    with pytest.raises(ValueError, match='column z must be text, bool, int or float, got compl'):
        results.rows(flight(z=np.zeros(4, dtype=complex)))


@pytest.fixture
def made(tmp_path):
    """The summary of one condition, read back from a result file."""
    file = results.ResultFile(tmp_path / 'r.parquet', seed=3)
    file.add('all', results.rows(flight()))
    file.close()
    (name, table), = results.tables(tmp_path / 'r.parquet')
    again = results.ResultFile(io.BytesIO(), seed=3)
    again.add(name, table)
    assert again.hash == file.hash
    condition = replace(parse_campaign('runs: 4', 'x').conditions[0], name=name)
    measures = declared(MEASURES)
    return {'measures': measures, 'reasons': REASONS, 'fitted': {}, 'differences': [],
            'conditions': [summary.of_condition(condition, table, 1.0, measures)]}


def test_the_summary_has_means_of_its_measures(made):
    condition, = made['conditions']
    assert condition['means'] == pytest.approx({'miss_rad': 0.06, 'fuel_kg': 2.5})
    assert condition['means_of_all_runs'] == {'fuel_kg': 2.5}       # one miss is unknown
    assert 'share_of_steps' not in condition
    head, row = summary.in_words(made).splitlines()[-2:]
    assert head.split()[-2:] == ['rad', 'kg'] and row.split()[-2:] == ['0.06', '2.5']


def test_a_measure_that_says_so_has_its_mean_over_all_runs():
    condition = parse_campaign('runs: 4', 'x').conditions[0]
    table = {'success': np.array([True, False, False, True]), 'reason': np.array(['a']*4),
             'duration_s': np.ones(4), 'fuel_kg': np.array([1.0, 2.0, 3.0, 8.0])}
    for of_all, mean in ((False, 4.5), (True, 3.5)):
        measures = declared([replace(MEASURES[1], of_all=of_all)])
        made = summary.of_condition(condition, table, 1.0, measures)
        assert made['means'] == {'fuel_kg': mean}


def test_the_page_has_a_column_for_each_measure_and_reason(made):
    campaign = replace(parse_campaign('runs: 4', 'x'), reference={
        'paper': {'runs': 10, 'successes': 5, 'means': {'fuel_kg': 7.0}}})
    made.update(notes=[], result_hash='h', identity={'code': 'c'})
    drawn = {'success': CampaignFigure(lambda results: (Figure(), 'none'), 'Success')}
    with patch.object(figures, 'FIGURES', drawn):
        html = report.page(report.Results(campaign, made, {}))
    table = html[html.index('<h2>Conditions'):html.index('<h2>Success')]
    assert '<th>pointing &lt;miss&gt;<br>rad</th><th>fuel burnt<br>kg</th>' in table
    assert '<td>0.06<br>\u00b1 0.01</td><td>2.5<br>\u00b1 1.5</td>' in table
    assert '<td>\u2013</td><td>7.0</td>' in table                   # the reference has no miss
    ends = html[html.index('<h2>How runs ended'):html.index('<h2>How to reproduce')]
    assert '<th>pointed &amp; held</th><th>pointed elsewhere</th><th>fuel burnt<br>kg</th>' in ends
    assert '<td>2</td><td>2</td><td>2.5</td>' in ends
    assert 'Who decided' not in html                # nobody counts its steps


def test_the_page_of_a_run_has_a_row_for_each_measure(tmp_path):
    bag = read(small_run.write_run(tmp_path))
    html = run_report.page(replace(bag, verdict=judgement(Judge, flight().verdict, 1)))
    assert 'Failed: pointed elsewhere; the run ended after 9.0 s' in html
    assert ('<td>pointing &lt;miss&gt;</td><td>0.20 rad</td><td>below 0.1 rad</td>'
            '<td><span class="meter"><span style="width:100%" class="bad"></span></span></td>'
            '<td>\u2717</td>') in html
    assert '<td>fuel burnt</td><td>2.0 kg</td><td></td><td></td><td></td>' in html


def as_message(row, final=True):
    judged = judgement(Judge, flight().verdict, row)
    return type('Message', (), {**judged._asdict(), 'final': final})()


def test_verdict_json_has_the_promised_form():
    outcome = flight_verdict.outcome(as_message(2))
    scenario = parse('/**: {ros__parameters: {seed: 5}}', 'mine')
    made = flight_verdict.as_dict(outcome, {'forward': None}, scenario)
    assert made == {
        'success': False, 'reason': 'missed', 'mission': 'lunar_approach', 'scenario': 'mine',
        'mode': 'shared', 'operator': 'model', 'seed': 5, 'run': 0, 'duration_s': 9.0,
        'measures': {'miss_rad': {'value': None, 'unit': 'rad', 'limit': 0.1, 'ok': False},
                     'fuel_kg': {'value': 3.0, 'unit': 'kg', 'limit': None, 'ok': True}},
        'link': {'forward': {}}}


def test_a_flight_that_was_stopped_has_not_failed_and_not_succeeded():
    stopped = flight_verdict.outcome(as_message(0, final=False), interrupted=True)
    assert (stopped.success, stopped.reason) == (False, 'interrupted')
    assert flight_verdict.in_words(stopped).splitlines()[0] == 'interrupted after 9.0 s'
    unseen = flight_verdict.outcome(None, interrupted=True)
    assert flight_verdict.in_words(unseen) == 'interrupted' and math.isnan(unseen.duration)
    made = flight_verdict.as_dict(unseen, {}, parse('/**: {ros__parameters: {}}', 'mine'))
    assert (made['duration_s'], made['measures']) == (None, {})
