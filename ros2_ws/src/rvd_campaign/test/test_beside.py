"""What other campaigns say: kept with its hash, shown beside Wilson's, refused where it is none."""

from pathlib import Path
import json

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.stats import binom, binomtest
import yaml

from rvd_campaign.campaign import beside, report, stats
from rvd_campaign.campaign.checked import CampaignError, from_dict
from rvd_campaign.campaign.spec import load_campaign, parse_campaign
from rvd_campaign.campaign.summary import _of_people

ROOT = Path(__file__).resolve().parents[4]
SAMPLED = {
    'campaign': 'other', 'result_hash': 'c0ffee', 'ensemble': {
        'latin_hypercube': 9, 'accepted': {'reference': 'people', 'standard_errors': 2,
                                           'points': [1, 4]},
        'bands': [{'output': 'by hand', 'all': [0.1, 0.5, 0.9], 'accepted': [0.6, 0.7, 0.8]},
                  {'output': 'helped', 'all': [0.1, 0.5, 0.9], 'accepted': [0.7, 0.8, 0.9]},
                  {'output': 'helped minus by hand', 'all': [0.0, 0.1, 0.2],
                   'accepted': [0.1, 0.11, 0.12]}]}}
REPEATED = {'campaign': 'many', 'result_hash': 'beef', 'replicates': {
    'count': 50, 'operators': 10, 'runs': 10, 'design_effect': {'by hand': 4.0}}}
TEXT = '''
set: {pilot: A}
conditions: {manual: {/**: {mode: manual}}, shared: {}, other: {pilot: C}}
compare: [[shared, manual], [other, manual]]
beside: {bands.yaml: {manual: by hand, shared: helped}, many.yaml: {manual: by hand}}
reference:
  people: {condition: manual, runs: 100, successes: 76}
  known: {condition: manual, runs: 100, successes: 76, design_effect: 2.0}
  others: {condition: other, runs: 100, successes: 91}
'''


@pytest.fixture(scope='module')
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp('beside')
    for name, summary in (('bands', SAMPLED), ('many', REPEATED)):
        (made / f'{name}.yaml').write_text(yaml.safe_dump(beside.of_summary(summary)))
    return made


@pytest.fixture(scope='module')
def campaign(folder):
    return parse_campaign(TEXT, 'x', folder)


def summary_of(campaign):
    rows = [{'name': c.name, 'runs': 40, 'successes': 30, 'success_rate': 0.75, 'means': {},
             'wilson95': [0.6, 0.86]} for c in campaign.conditions]
    pairs = [{'a': a, 'b': b, 'difference': 0.0, 'paired95': [-0.1, 0.1],
              'unpaired95': [-0.1, 0.1], 'only_a': 2, 'only_b': 2, 'p': 1.0}
             for a, b in campaign.compare]
    made = {'conditions': rows, 'differences': pairs, 'measures': {}, 'fitted': {}}
    beside.add(made, campaign.beside, campaign.reference)
    return made


# -- intervals ---------------------------------------------------------------------------------

def test_flights_that_are_worth_one_each_have_the_exact_interval():
    assert_allclose(stats.of_design_effect(76, 100, 1.0),
                    binomtest(76, 100).proportion_ci(0.95, 'exact'), rtol=1e-9)
    assert stats.of_design_effect(100, 100, 4.0).high == 1.0
    assert stats.of_design_effect(0, 100, 4.0).low == 0.0


def test_flights_of_which_four_are_worth_one_have_the_ends_of_a_quarter_of_them():
    low, high = stats.of_design_effect(76, 100, 4.0)        # 19 of 25 independent ones
    assert_allclose((binom.sf(18, 25, low), binom.cdf(19, 25, high)), 0.025, rtol=1e-6)


def test_it_covers_the_rate_of_the_population_where_wilson_does_not():
    rng, people, flights, rate = np.random.default_rng(3), 10, 10, 0.76
    likeness = 0.3                                          # intraclass correlation
    size = 1.0/likeness - 1.0
    own = rng.beta(size*rate, size*(1.0 - rate), (3000, people))
    totals = rng.binomial(flights, own).sum(axis=1)
    effect = 1.0 + (flights - 1)*likeness                   # Kish 1965, of equal clusters

    def covered(interval):
        return np.mean([low <= rate <= high for low, high in map(interval, totals.tolist())])
    assert covered(lambda k: stats.of_design_effect(k, people*flights, effect)) > 0.94
    assert covered(lambda k: stats.wilson(k, people*flights)) < 0.80


def test_runs_in_a_row_are_one_persons():
    good = np.array([1, 1, 0, 0, 0, 1, 1], dtype=bool)      # the third has flown once so far
    assert _of_people(good, 3) == {
        'runs_per_person': 3, 'clustered95': list(stats.clustered([(2, 3), (1, 3), (1, 1)]))}
    assert _of_people(good, 0) == {} and _of_people(good, 7) == {'runs_per_person': 7}


# -- kept files --------------------------------------------------------------------------------

def test_bands_stand_beside_the_conditions_and_differences_that_they_are_of(campaign):
    made = summary_of(campaign)
    assert [c.get('band') for c in made['conditions']] == [
        [0.6, 0.7, 0.8], [0.7, 0.8, 0.9], None]
    assert [d.get('band') for d in made['differences']] == [[0.1, 0.11, 0.12], None]
    assert [(b['campaign'], b['result_hash'], b['bands']) for b in made['beside']] == [
        ('other', 'c0ffee', True), ('many', 'beef', False)]


def test_peoples_data_take_the_design_effect_of_their_condition_unless_they_have_one(campaign):
    made = summary_of(campaign)['reference']
    assert [row.get('design_effect') for row in made.values()] == [4.0, 2.0, None]
    assert made['people']['clustered95'] == list(stats.of_design_effect(76, 100, 4.0))
    assert 'clustered95' not in made['others']


def test_words_and_page_show_them_with_the_hash(campaign):
    made = summary_of(campaign)
    words = '\n'.join(beside.in_words(made))
    for said in ('0.6000 to 0.8000', 'c0ffee', '2 of 9 points', '50 experiments of 10 people'):
        assert said in words
    table = report._conditions(made, campaign.reference)
    assert table.heads[3:6] == ['95 % (Wilson)', '95 % (over people)', 'band']
    assert table.rows[0][1][4:6] == ['\u2013', '0.6000 \u2026 0.8000']
    low, high = made['reference']['people']['clustered95']
    assert table.rows[3][1][4:6] == [f'{low:.4f} \u2026 {high:.4f}', '\u2013']
    assert report._differences(made).rows[0][1][4] == '+0.1000 \u2026 +0.1200'


def test_a_campaign_without_them_shows_nothing_of_them():
    made = summary_of(parse_campaign('conditions: {a: {}, b: {}}', 'x'))
    assert beside.in_words(made) == [] and 'beside' not in made and 'reference' not in made
    assert report._conditions(made, {}).heads[3:5] == ['95 % (Wilson)', ('time', 's')]


def test_a_folder_keeps_them(campaign):
    again = from_dict(json.loads(json.dumps(campaign.as_dict())))
    assert again.beside == campaign.beside and again.reference == campaign.reference


def test_without_a_choice_bands_are_those_of_all_points():
    made = beside.of_summary({**SAMPLED, 'ensemble': {**SAMPLED['ensemble'], 'accepted': None}})
    assert made['bands']['by hand'] == [0.1, 0.5, 0.9]


BAD = {
    'no file': ('{no.yaml: {manual: by hand}}', 'no.yaml'),
    'no names': ('{bands.yaml: manual}', 'beside must map files to'),
    'here': ('{bands.yaml: {manuel: by hand}}', "no condition 'manuel'; did you mean manual"),
    'there': ('{bands.yaml: {manual: by hands}}', "has no 'by hands'; did you mean by hand"),
    'strange': ('{strange.yaml: {manual: by hand}}', 'strange.yaml holds no results'),
}


@pytest.mark.parametrize('given, words', BAD.values(), ids=BAD)
def test_files_of_something_else_are_refused_in_one_line(given, words, folder):
    (folder / 'strange.yaml').write_text('campaign: x\n')
    line = next(line for line in TEXT.splitlines() if line.startswith('beside'))
    with pytest.raises(CampaignError, match=words) as refusal:
        parse_campaign(TEXT.replace(line, f'beside: {given}'), 'x', folder)
    assert '\n' not in str(refusal.value)


def test_the_command_refuses_what_has_nothing_to_keep(tmp_path, capsys):
    assert beside.main([str(tmp_path), '--out', str(tmp_path / 'x.yaml')]) == 2
    (tmp_path / 'summary.json').write_text('{"campaign": 3}')
    assert beside.main([str(tmp_path), '--out', str(tmp_path / 'x.yaml')]) == 2
    assert capsys.readouterr().err.count('\n') == 2
    with pytest.raises(ValueError, match='neither a sample'):
        beside.of_summary({'campaign': 'plain', 'result_hash': ''})


def test_what_table3_shows_is_of_the_campaigns_whose_results_are_printed():
    printed = (ROOT / 'docs' / 'results.md').read_text()
    made = load_campaign('table3').beside
    assert {one['campaign'] for one in made} == {'pilots', 'replicates'}
    for one in made:
        assert one['result_hash'] in printed
    low, _, high = beside.band(made, 'A shared')
    assert f'| the paper\'s law | .913 | .610 to 1.000 | {low:.3f} to {high:.3f} |'.replace(
        ' 0.', ' .') in printed
