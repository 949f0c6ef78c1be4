"""Samples of a campaign: designs keep to their ranges, indices are known ones, points are flown."""

from dataclasses import replace
from math import pi
import json

import matplotlib
import numpy as np
import pytest

from rvd_campaign.campaign import ensemble, report, sample as sampling
from rvd_campaign.campaign.checked import CampaignError, from_dict
from rvd_campaign.campaign.engine import identity
from rvd_campaign.campaign.figures import FIGURES, Results
from rvd_campaign.campaign.sample import Number, Sample
from rvd_campaign.campaign.spec import parse_campaign
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.recording.drawing import STYLE

TEXT = '''
seed: 5
runs: 20
set: {pilot: A}
conditions:
  manual: {/**: {mode: manual}}
  shared: {/**: {mode: shared}}
compare: [[shared, manual]]
sample:
  latin_hypercube: 6
  sobol: 2
  numbers:
    skill: {operator_model.skill_gain: 0.3, operator_model.skill_spread: [0.1, 0.5]}
    operator_model.reaction_s: [0.5, 2.0]
accept: {reference: paper, standard_errors: 2}
reference:
  paper: {condition: manual, runs: 100, successes: 76, means: {offset_m: 0.1444}}
'''


@pytest.fixture(scope='module')
def campaign():
    return parse_campaign(TEXT, 'x')


def numbers(count):
    return tuple(Number('s', f'x{i}', float(i), i + 2.0, f'x{i}') for i in range(count))


def test_every_condition_is_flown_as_it_is_and_at_every_point(campaign):
    assert [c.name for c in campaign.conditions[:3]] == ['manual', 'shared', 'manual,sample=0']
    assert campaign.sample.count == 6 + 2*(2 + 2)
    assert len(campaign.conditions) == 2*(1 + campaign.sample.count)
    by_point = [(c.point, c.base) for c in campaign.conditions[2:]]
    assert by_point == [(k, name) for k in range(14) for name in ('manual', 'shared')]


def test_a_point_changes_its_numbers_and_nothing_else(campaign):
    plain = campaign.condition('shared').scenario
    at = campaign.condition('shared,sample=3')
    values = at.changes['operator_model']
    assert set(values) == {'skill_gain', 'skill_spread', 'reaction_s'}
    assert at.scenario.with_values('operator_model', **{
        key: getattr(plain.settings('operator_model'), key) for key in values}
        ).resolved() == plain.resolved()
    for key, value in values.items():
        assert getattr(at.scenario.settings('operator_model'), key) == value


@pytest.mark.parametrize('seed', [0, 7])
def test_a_latin_hypercube_has_one_point_in_each_slice_of_each_range(seed):
    points = Sample(numbers(4), latin_hypercube=50).points(seed)
    for i, column in enumerate(points.T):
        assert sorted(np.floor((column - i)/2.0*50).astype(int)) == list(range(50))


def test_designs_are_keyed_by_the_seed_and_do_not_disturb_each_other():
    both, alone = Sample(numbers(3), 10, 4), Sample(numbers(3), 10)
    np.testing.assert_array_equal(both.points(3)[:10], alone.points(3))
    np.testing.assert_array_equal(both.points(3), both.points(3))
    assert not np.array_equal(both.points(3)[:10], both.points(4)[:10])


def test_numbers_of_a_group_move_together_in_the_design_for_indices():
    three = numbers(3)
    grouped = Sample((replace(three[0], group='g'), replace(three[1], group='g'), three[2]),
                     sobol=8)
    points = grouped.points(1).reshape(8, 4, 3)         # A, g of B, x2 of B, B
    a, first, second, b = points.transpose(1, 0, 2)
    np.testing.assert_array_equal(first[:, :2], b[:, :2])
    np.testing.assert_array_equal(first[:, 2], a[:, 2])
    np.testing.assert_array_equal(second[:, 2], b[:, 2])
    np.testing.assert_array_equal(second[:, :2], a[:, :2])


def test_indices_are_those_of_the_ishigami_function(campaign):
    # T. Ishigami, T. Homma, 1990: S = .314, .442, 0 and T = .558, .442, .244 for a = 7, b = .1.
    known = Sample(tuple(Number('s', f'x{i}', -pi, pi, f'x{i}') for i in range(3)), sobol=1024)
    x, y, z = known.points(2).T
    found = np.sin(x) + 7.0*np.sin(y)**2 + 0.1*z**4*np.sin(x)
    made = ensemble.indices(replace(campaign, sample=known), 'f', found)
    for index, first, total in zip(made, (0.314, 0.442, 0.0), (0.558, 0.442, 0.244)):
        assert index['first'] == pytest.approx(first, abs=0.03)
        assert index['total'] == pytest.approx(total, abs=0.03)
        assert abs(index['first'] - first) < 2.0*index['first95']


def test_what_does_not_vary_has_no_indices(campaign):
    made = ensemble.indices(campaign, 'f', np.full(campaign.sample.sobol_points, 0.5))
    assert [i['group'] for i in made] == list(campaign.sample.groups)
    assert all(i['first'] is None and i['total'] is None for i in made)


def row(rate, offset=0.1444, runs=400):
    """Return the summary of a condition whose offset has a deviation of 0.07 m."""
    successes = round(rate*runs)
    return {'success_rate': successes/runs, 'successes': successes,
            'means': {'offset_m': offset},
            'standard_errors': {'offset_m': 0.07/successes**0.5 if successes else float('nan')}}


@pytest.mark.parametrize('made, errors', [
    (row(0.76), 0.0), (row(0.80), 0.04/(0.76*0.24/100)**0.5),
    (row(0.76, 0.1444 + 0.07/76**0.5), 1.0), (row(0.76, 0.1444 - 3.0*0.07/76**0.5), 3.0),
    (row(0.0, float('nan')), float('inf'))])
def test_misfit_is_counted_in_standard_errors_of_the_reference(campaign, made, errors):
    if errors == float('inf'):
        assert ensemble.misfit(made, campaign.reference['paper']) > 17.0
    else:
        assert ensemble.misfit(made, campaign.reference['paper']) == pytest.approx(errors)


def test_bands_are_those_of_the_points_and_of_the_ones_accepted(campaign):
    rows, rng = {}, np.random.default_rng(1)
    for c in campaign.conditions:
        rows[c.name] = row(0.76 if c.point in (None, 1, 4) else rng.uniform(0.2, 0.5))
        if c.base == 'shared' or c.name == 'shared':
            rows[c.name] = row(0.9 if c.point in (None, 1) else 0.8)
    made = ensemble.of_points(campaign, rows)
    assert made['accepted']['points'] == [1, 4]
    bands = {b['output']: b for b in made['bands']}
    assert bands['shared']['accepted'] == pytest.approx([0.8, 0.85, 0.9])
    assert bands['shared minus manual']['accepted'] == pytest.approx([0.04, 0.09, 0.14])
    assert bands['manual']['fit'] == 0.76 and bands['manual']['all'][0] < 0.5
    assert len(made['points']) == campaign.sample.count
    assert len(made['indices']) == 3*2
    json.dumps(made)
    assert any('2 of them agree with paper' in line for line in ensemble.in_words(made))


def test_a_folder_gives_the_same_campaign_back(campaign):
    kept = json.loads(json.dumps(campaign.as_dict()))
    again = from_dict(kept)
    assert identity(again) == identity(campaign)
    assert again.sample == campaign.sample and again.accept == campaign.accept
    for mine, its in zip(campaign.conditions, again.conditions):
        assert (mine.name, mine.point, mine.scenario.resolved()) == (
            its.name, its.point, its.scenario.resolved())
    other = parse_campaign(TEXT.replace('[0.1, 0.5]', '[0.1, 0.6]'), 'x')
    assert identity(other)['settings'] != identity(campaign)['settings']


def test_a_point_flies_as_its_scenario_does(campaign):
    at = campaign.condition('manual,sample=2')
    by_hand = campaign.condition('manual').scenario.with_values(
        'operator_model', **at.changes['operator_model'])
    mine, its = (fly(s, range(6)).verdict for s in (at.scenario, by_hand))
    np.testing.assert_array_equal(mine.success, its.success)
    np.testing.assert_array_equal(mine.duration, its.duration)


BAD = {
    'no numbers': ('sample: {latin_hypercube: 3}', 'sample must have designs and numbers'),
    'unknown design': ('sample: {latin: 3, numbers: {operator_model.skill_gain: 0.1}}',
                       'unknown key latin; did you mean latin_hypercube'),
    'no design': ('sample: {numbers: {operator_model.skill_gain: 0.1}}', 'have 0 points'),
    'not a power': ('sample: {sobol: 3, numbers: {operator_model.skill_gain: 0.1}}',
                    'sobol must be a power of two, got 3'),
    'too many': ('sample: {latin_hypercube: 6000, numbers: {operator_model.skill_gain: 0.1}}',
                 'from 0 to 5000, got 6000'),
    'strange section': ('sample: {latin_hypercube: 3, numbers: {operator.skill_gain: 0.1}}',
                        'must begin with a section'),
    'strange number': ('sample: {latin_hypercube: 3, numbers: {operator_model.skil_gain: 0.1}}',
                       'no number of the scenario; did you mean skill_gain'),
    'a word': ('sample: {latin_hypercube: 3, numbers: {operator_model.display: 0.1}}',
               'operator_model.display is no number'),
    'wide': ('sample: {latin_hypercube: 3, numbers: {operator_model.skill_gain: 1.5}}',
             'must be a fraction between 0 and 1 or'),
    'empty range': ('sample: {latin_hypercube: 3, numbers: {operator_model.skill_gain: [2, 1]}}',
                    'has no range: 2 to 1'),
    'out of bounds': ('sample: {latin_hypercube: 3, numbers: '
                      '{operator_model.skill_gain: [-2, -1]}}',
                      'skill_gain must be positive'),
    'twice': ('sample: {latin_hypercube: 3, numbers: {a: {operator_model.skill_gain: 0.1}, '
              'operator_model.skill_gain: 0.2}}', 'skill_gain is given twice'),
    'accept alone': ('accept: {reference: x, standard_errors: 2}', 'accept needs a sample'),
    'accept what': ('sample: {latin_hypercube: 3, numbers: {operator_model.skill_gain: 0.1}}\n'
                    'accept: {reference: x, standard_errors: 2}', "accept: no reference 'x'"),
    'runs': ('runs: 1000000\nsample: {latin_hypercube: 30, numbers: '
             '{operator_model.skill_gain: 0.1}}', 'the limit is 10,000,000'),
}


@pytest.mark.parametrize('text, words', BAD.values(), ids=BAD)
def test_impossible_samples_are_refused_in_one_line(text, words):
    with pytest.raises(CampaignError, match=words) as refusal:
        parse_campaign(text, 'x')
    assert '\n' not in str(refusal.value)


def test_figure_and_page_hold_the_bands_and_indices(campaign):
    rows = {c.name: row(0.76 if c.point in (None, 1, 4) else 0.5) for c in campaign.conditions}
    made = ensemble.of_points(campaign, rows)
    results = Results(campaign, {'ensemble': made}, {})
    with matplotlib.rc_context(STYLE):
        figure, caption = FIGURES['ensemble'].draw(results)
    assert 'the 2 points that agree with paper within 2 standard errors' in caption
    assert len(figure.axes) == 1 + 3                    # the bands, and indices of each output
    shown = {line.get_marker(): line.get_xdata() for line in figure.axes[0].lines}
    np.testing.assert_allclose(shown['D'], made['bands'][-1]['fit'])
    tables = report._ensemble({'ensemble': made})
    assert [cells[0] for _, cells in tables['bands'].rows] == ['manual', 'shared',
                                                               'shared minus manual']
    assert len(tables['indices'].rows) == 6 and len(tables['ranges']) == 3
    assert report._ensemble({}) is None


def test_limits_of_a_number_stand_in_the_ranges():
    made = parse_campaign(TEXT, 'x').sample
    gain, spread, reaction = made.numbers
    assert (gain.low, gain.high) == pytest.approx((1.635*0.7, 1.635*1.3))
    assert (spread.low, spread.high, reaction.group) == (0.1, 0.5, 'operator_model.reaction_s')
    assert made.groups == ('skill', 'operator_model.reaction_s')
    assert sampling.from_dict(json.loads(json.dumps(made.as_dict()))) == made
