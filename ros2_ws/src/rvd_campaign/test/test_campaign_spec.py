"""
Campaign files: what they mean, and what is refused before anything flies.
"""

import json
from pathlib import Path

import pytest

from rvd_campaign.campaign.checked import from_dict, MAX_RUNS
from rvd_campaign.campaign.engine import identity
from rvd_campaign.campaign.spec import (
    CampaignError, load_campaign, MAX_CONDITIONS, parse_campaign)
from rvd_campaign.catalogue import entries
from rvd_groundstation.operators.pilot import PERSONS

CAMPAIGNS = Path(__file__).resolve().parents[4] / 'campaigns'
SHIPPED = sorted(file.stem for file in CAMPAIGNS.glob('*.yaml'))


def test_conditions_times_grid():
    made = parse_campaign('''
scenario: paper
seed: 4
conditions:
  by hand: {/**: {mode: manual}}
  barrier: {auto_controller: {law: barrier}}
grid:
  loop_delay_s: [0.5, 10]
  command_blender.eq25.eta: [0.5, 0.9]
''', 'x')
    assert [c.name for c in made.conditions][:3] == [
        'by hand,loop_delay_s=0.5,eta=0.5', 'by hand,loop_delay_s=0.5,eta=0.9',
        'by hand,loop_delay_s=10,eta=0.5']
    assert len(made.conditions) == 8
    last = made.conditions[-1]
    assert last.at == {'loop_delay_s': 10, 'command_blender.eq25.eta': 0.9}
    assert last.scenario.settings('command_blender').eq25.eta == 0.9
    assert last.scenario.settings('auto_controller').law == 'barrier'
    assert last.scenario.run.seed == 4
    first = made.conditions[0].scenario
    assert first.part('operation').mode == 'manual'
    legs = first.part('leg_params')
    assert (legs.forward_delay_s, legs.back_delay_s) == (0.0, 0.5)


def test_labelled_axis_changes_several_keys_at_once():
    made = parse_campaign('''
grid:
  link:
    good: {}
    bad: {link_forward: {loss_fraction: 0.1}, link_back: {loss_fraction: 0.2}}
''', 'x')
    assert [c.name for c in made.conditions] == ['link=good', 'link=bad']
    bad = made.condition('link=bad').scenario
    assert (bad.settings('link_forward').loss_fraction,
            bad.settings('link_back').loss_fraction) == (0.1, 0.2)


def test_everything_the_experiment_asks_for_can_be_varied():
    made = parse_campaign('''
conditions:
  all:
    /**: {mode: shared, forward_delay_s: 4.0, back_delay_s: 6.0}
    pilot: C
    operator_model: {display: false}
    spacecraft_dynamics: {truth_model: two_body, execution_noise_fraction: 0.02}
    relative_sensor: {multiplicative: {noise_fraction: 0.05}}
    link_forward: {model: uniform, uniform: {low_fraction: 0.5, high_fraction: 1.1}}
    auto_controller: {law: corridor_apf, corridor_apf: {lambda_1_m3_s2: 3e-4}}
    command_blender: {eq25: {eta: 0.6}}
''', 'x').conditions[0].scenario
    assert made.settings('operator_model').skill_gain == PERSONS['C'].skill_gain
    assert made.settings('operator_model').display is False
    assert made.part('law').lambda_1_m3_s2 == 3e-4


def test_short_words_come_before_sections_whatever_their_order():
    made = parse_campaign(
        'conditions: {x: {operator_model: {skill_gain: 2.5}, pilot: C}}', 'x')
    pilot = made.conditions[0].scenario.settings('operator_model')
    assert (pilot.skill_gain, pilot.skill_spread) == (2.5, PERSONS['C'].skill_spread)


def test_pilot_file_beside_the_campaign(tmp_path):
    (tmp_path / 'tired.yaml').write_text(
        'operator_model:\n  ros__parameters: {skill_gain: 4.0}\n')
    made = parse_campaign('set: {pilot: tired.yaml}', 'x', tmp_path)
    assert made.conditions[0].scenario.settings('operator_model').skill_gain == 4.0


@pytest.mark.parametrize('name', SHIPPED)
def test_shipped_campaigns_load_and_survive_being_kept(name):
    made = load_campaign(name)
    assert made.title
    kept = from_dict(json.loads(json.dumps(made.as_dict())))
    assert identity(kept) == identity(made)
    assert [c.name for c in kept.conditions] == [c.name for c in made.conditions]


def test_shipped_campaigns_are_listed():
    assert [name for name, _ in entries('campaigns')] == SHIPPED


def test_a_folder_of_the_same_name_does_not_hide_a_shipped_campaign(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'eta').mkdir()
    assert load_campaign('eta').name == 'eta'


def test_identity_hangs_on_settings_and_seed_but_not_on_runs_or_words():
    base = 'conditions: {a: {}, b: {pilot: C}}\n'
    mine = identity(parse_campaign(base, 'x'))
    for same in ('runs: 7\n', 'notes: [hello]\n', 'figures: [landing]\n'):
        assert identity(parse_campaign(base + same, 'y')) == mine
    for other in ('seed: 1\n', 'set: {pilot: B}\n', 'grid: {loop_delay_s: [8]}\n'):
        assert identity(parse_campaign(base + other, 'x')) != mine


BAD = {
    'zero runs': ('runs: 0', 'runs must be a whole number, at least 1, got 0'),
    'negative runs': ('runs: -5', 'got -5'),
    'half a run': ('runs: 1.5', 'got 1.5'),
    'too many runs': (f'runs: {MAX_RUNS + 1}', f'the limit is {MAX_RUNS:,}'),
    'negative delay': ('conditions: {a: {/**: {forward_delay_s: -5.0}}}',
                       'condition a: forward_delay_s must be between 0 and 3600, got -5.0'),
    'negative loop delay': ('grid: {loop_delay_s: [-1]}', 'loop_delay_s must be between 0'),
    'delay off the grid': ('grid: {loop_delay_s: [0.7]}', 'two nearest are 0.5 and 1'),
    'delay that is no number': ('grid: {loop_delay_s: [.nan]}', 'got nan'),
    'eta above 1': ('grid: {command_blender.eq25.eta: [0.5, 1.2]}',
                    'command_blender: eq25.eta must be between 0 and 1, got 1.2'),
    'eta below 0': ('set: {command_blender: {eq25: {eta: -0.1}}}',
                    'eq25.eta must be between 0 and 1, got -0.1'),
    'unknown law': ('set: {auto_controller: {law: magnets}}', 'law must be one of corridor_apf'),
    'unknown key': ('run: 5', 'unknown key run; did you mean runs?'),
    'unknown section': ('set: {auto_controler: {law: none}}', 'did you mean auto_controller?'),
    'unknown setting': ('set: {operator_model: {skil_gain: 1.0}}',
                        'unknown key skil_gain; did you mean skill_gain?'),
    'unknown axis': ('grid: {comand_blender.eq25.eta: [0.5]}', 'did you mean command_blender.?'),
    'unknown pilot': ('set: {pilot: Z}', "no pilot 'Z'"),
    'unknown scenario': ('scenario: papper', "no scenario 'papper'"),
    'unknown figure': ('figures: [tracs]', 'did you mean tracks?'),
    'unknown condition': ('conditions: {a: {}, b: {}}\ncompare: [[a, c]]', "no condition 'c'"),
    'own seed': ('set: {/**: {seed: 3}}', 'seed belongs to the campaign'),
    'wall clock': ('set: {/**: {operator: joy, joy_input: held, pace: realtime}}',
                   'condition all: operator joy: command_blender reads /joy from joystick, which '
                   'takes a graph and a wall clock'),
    'own mission': ('set: {/**: {mission: lunar_approach}}', 'mission belongs to the campaign'),
    'own processes': ('conditions: {a: {/**: {processes: one}}}',
                      'condition a: processes belongs to the campaign'),
    'a pilot that is a list': ('set: {pilot: [A]}', "no pilot ['A']"),
    'no tape': ('set: {/**: {operator: replay}}', 'operator replay needs a tape'),
    'empty axis': ('grid: {loop_delay_s: []}', 'must be a list of values'),
    'a million cells': ('grid: {command_blender.eq25.eta: [%s], loop_delay_s: [%s]}' % (
        ', '.join(['0.5']*1000), ', '.join(['1']*1000)),
        f'1,000,000 cells are 1,000,000 conditions; the limit is {MAX_CONDITIONS:,}'),
    'same name twice': ('grid: {command_blender.eq25.eta: [0.5, 0.5]}', 'two conditions'),
    'bad name': ('conditions: {"../a": {}}', 'cannot be named'),
    'part of a replicate': ('runs: 150\nreplicates: {operators: 10, runs: 10}',
                            'multiple of 100'),
    'replicates of other people': ('runs: 100\nreplicates: {operators: 10, runs: 10}',
                                   'runs_per_operator is 1'),
    'not a mapping': ('- 1', 'not a mapping'),
    'no YAML': ('a: [', 'not valid YAML'),
    'a bomb': ('a: &a [1]\nb: *a', 'anchors'),
}


@pytest.mark.parametrize('case', BAD)
def test_bad_input_is_one_line_that_names_the_value(case):
    text, words = BAD[case]
    with pytest.raises(ValueError) as refused:
        parse_campaign(text, 'mine')
    assert words in str(refused.value)
    assert '\n' not in str(refused.value)


def test_runs_on_the_command_line_are_checked_alike():
    with pytest.raises(CampaignError, match='got 0'):
        parse_campaign('runs: 5', 'x', runs=0)
