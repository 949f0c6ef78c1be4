"""A campaign flown again with another seed, and conditions held against people's data."""

import io
import json

import numpy as np
import pytest

from rvd_campaign.campaign.checked import from_dict
from rvd_campaign.campaign.claims import Confirmation
from rvd_campaign.campaign.command import _beside
from rvd_campaign.campaign.engine import fly_campaign, start, Workers
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.report import page, read
from rvd_campaign.campaign.spec import CampaignError, parse_campaign
from rvd_campaign.campaign.stats import design_effect
from rvd_campaign.campaign.summary import finish, in_words, is_summary, SUMMARY

TEXT = '''
seed: 2
runs: 30
confirm: {seed: 7, runs: 20}
set: {pilot: A}
conditions:
  manual: {/**: {mode: manual}}
  shared: {}
compare: [[shared, manual]]
reference:
  people: {condition: manual, runs: 100, successes: 76, margin: 0.1, design_effect: 3.6}
'''
ALONE = TEXT.replace('confirm: {seed: 7, runs: 20}\n', '').replace('seed: 2', 'seed: 7').replace(
    'runs: 30', 'runs: 20', 1)


def flown(campaign, folder):
    start(campaign, folder)
    fly_campaign(campaign, folder, Workers(), Progress(io.StringIO()))
    if campaign.again:
        fly_campaign(campaign.again, _beside(campaign.again, folder), Workers(),
                     Progress(io.StringIO()))
    made = finish(campaign, folder)
    (folder / SUMMARY).write_text(json.dumps(made))
    return made


@pytest.fixture(scope='module')
def confirmed(tmp_path_factory):
    folder = tmp_path_factory.mktemp('confirmed')
    return folder, flown(parse_campaign(TEXT, 'x'), folder)


def test_the_confirmation_is_the_campaign_of_its_seed(confirmed, tmp_path):
    again = confirmed[1]['confirmation']
    alone = flown(parse_campaign(ALONE, 'x'), tmp_path)
    assert (again['seed'], again['runs']) == (7, 20)
    assert again['result_hash'] == alone['result_hash'] != confirmed[1]['result_hash']
    assert [c['success_rate'] for c in again['conditions']] == [
        c['success_rate'] for c in alone['conditions']]
    assert again['differences'][0]['paired95'] == alone['differences'][0]['paired95']


def test_both_seeds_stand_in_console_and_report(confirmed):
    folder, made = confirmed
    assert is_summary(json.loads(json.dumps(made)))
    said, html = in_words(made), page(read(folder))
    first, second = made['differences'][0], made['confirmation']['differences'][0]
    for d in (first, second):
        assert f'shared - manual: {d["difference"]:+.4f}' in said
        assert f'{d["difference"]:+.4f}<' in html
    assert 'again, seed 7, 20 runs' in said and 'Flown again with another seed' in html
    assert made['people'][0]['condition'] == 'manual' and 'margin' in html


def test_a_second_visit_to_the_folder_flies_nothing_anew(confirmed):
    folder, _ = confirmed
    campaign = parse_campaign(TEXT, 'x')
    progress = Progress(io.StringIO())
    fly_campaign(campaign.again, _beside(campaign.again, folder), Workers(), progress)
    assert progress.flown == 0 and progress.done == 40


def test_what_is_kept_holds_the_confirmation():
    campaign = parse_campaign(TEXT, 'x')
    kept = from_dict(json.loads(json.dumps(campaign.as_dict())))
    assert kept.confirm == campaign.confirm == Confirmation(7, 20)
    assert kept.again.conditions[0].scenario.run.seed == 7
    assert campaign.again.again is None


def test_fewer_runs_are_fewer_of_both():
    campaign = parse_campaign(TEXT, 'x', runs=5)
    assert (campaign.runs, campaign.confirm.runs) == (5, 5)


def test_the_confirmation_may_have_more_runs_than_the_campaign():
    more = parse_campaign(TEXT.replace('seed: 7, runs: 20', 'seed: 7, runs: 300'), 'x')
    same = parse_campaign(TEXT.replace('seed: 7, runs: 20', 'seed: 7'), 'x')
    assert (more.runs, more.confirm.runs, same.confirm.runs) == (30, 300, 30)


@pytest.mark.parametrize('words, said', [
    ('confirm: {seed: 2}', 'another than the campaign.s, got 2'),
    ('confirm: {runs: 5}', 'confirm must be .*got'),
    ('confirm: {seed: 3, runs: 0}', 'at least 1, got 0'),
    ('confirm: {seed: -1}', 'from 0 to 2.63 - 1, got -1'),
    ('confirm: {seed: true}', 'confirm must be'),
    ('confirm: yes', 'confirm must be')])
def test_an_impossible_confirmation_is_refused_in_a_line(words, said):
    with pytest.raises(CampaignError, match=said) as refused:
        parse_campaign(TEXT.replace('confirm: {seed: 7, runs: 20}', words), 'x')
    assert '\n' not in str(refused.value) and str(refused.value).startswith('campaign x: ')


@pytest.mark.parametrize('change, said', [
    (('margin: 0.1', 'margin: 0'), 'margin must be above 0 and below 1, got 0'),
    (('margin: 0.1', 'margin: wide'), 'margin must be .* got .wide'),
    (('design_effect: 3.6', 'design_effect: 0.5'), 'design_effect must be .* got 0.5'),
    (('successes: 76', 'successes: 176'), 'whole numbers.*got 100 and 176'),
    (('runs: 100', 'runs: many'), 'whole numbers.*got .many. and 76'),
    (('condition: manual, ', ''), 'margin needs condition')])
def test_an_impossible_margin_is_refused_in_a_line(change, said):
    with pytest.raises(CampaignError, match=said):
        parse_campaign(TEXT.replace(*change), 'x')


def test_people_who_differ_have_the_design_effect_of_their_correlation():
    """
    Runs of one person correlate: the effect is 1 + (runs of a person - 1) times the correlation.

    That of a beta distribution with parameters a and b is 1/(1 + a + b). Kish, 1965, eq. 5.4.1.
    """
    rng, experiments, people, runs = np.random.default_rng(11), 20_000, 10, 10
    for a, b in ((3.0, 1.0), (30.0, 3.0)):
        skill = rng.beta(a, b, (experiments, people))
        rates = rng.binomial(runs, skill).mean(axis=1)/runs
        # a variance of 20,000 values: 4 standard errors are 4 %
        assert design_effect(rates, people*runs) == pytest.approx(
            1 + (runs - 1)/(1 + a + b), rel=0.04)
    alike = rng.binomial(people*runs, 0.8, experiments)/(people*runs)
    assert design_effect(alike, people*runs) == pytest.approx(1.0, rel=0.04)
    assert np.isnan(design_effect(np.ones(5), 10))


def test_the_design_effect_stands_in_summary_console_and_report(tmp_path):
    made = flown(parse_campaign('''
runs: 60
set: {pilot: A, operator_model: {runs_per_operator: 5}}
conditions: {manual: {/**: {mode: manual}}}
replicates: {operators: 2, runs: 5}
''', 'x'), tmp_path)
    effect = made['replicates']['design_effect']['manual']
    assert effect > 0.0 and is_summary(json.loads(json.dumps(made)))
    assert f'manual: design effect {effect:.2f}' in in_words(made)
    assert f'<td>{effect:.2f}</td>' in page(read(tmp_path))
