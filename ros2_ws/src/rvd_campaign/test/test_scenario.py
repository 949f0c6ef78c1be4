"""Scenarios: what ROS would ignore or misread is refused in one line; the rest is kept."""

from pathlib import Path

import pytest
import yaml
from hypothesis import example, given
from hypothesis import strategies as st

from rvd_campaign import catalogue
from rvd_dynamics.diagram.params import leaves
from rvd_dynamics.diagram.scenario import (
    load, parse, parse_known, Scenario, ScenarioError, sections_of)

SHIPPED = sorted((catalogue.root() / 'scenarios').glob('*.yaml'))


def shared(**values) -> str:
    return yaml.dump({'/**': {'ros__parameters': values}})


def refusal(text: str) -> str:
    with pytest.raises(ScenarioError) as caught:
        parse(text, 'trial')
    line = str(caught.value)
    assert '\n' not in line
    return line


@pytest.mark.parametrize('path', SHIPPED, ids=lambda p: p.stem)
def test_shipped_scenarios_load_and_begin_with_what_they_are(path):
    assert load(path).run.step_s > 0.0
    assert path.read_text().startswith('# ')


@pytest.mark.parametrize('path', SHIPPED, ids=lambda p: p.stem)
def test_resolved_scenario_says_the_same_and_leaves_nothing_to_default(path):
    scenario = load(path)
    again = parse(scenario.dump(), scenario.name)
    assert again.resolved() == scenario.resolved()
    for section, groups in sections_of(scenario.mission).items():
        keys = {prefix + key for prefix, settings in groups for key, _ in leaves(settings)}
        keys -= {'nodes', 'bag_dir'}
        assert keys <= set(again.sections.get(section, {}))


def test_resolved_scenario_gives_ros_a_float_wherever_a_float_is_meant():
    tree = yaml.safe_load(parse(shared(step_s=1, forward_delay_s=5), 'trial').dump())
    values = tree['/**']['ros__parameters']
    assert (type(values['step_s']), type(values['forward_delay_s'])) == (float, float)
    assert all(type(v) is float for v in values['start']['position_m'])


def test_whole_numbers_and_exponents_are_taken_as_numbers():
    text = ('/**: {ros__parameters: {step_s: 1}}\n'
            'spacecraft_dynamics: {ros__parameters: {execution_noise_fraction: 1e-2}}')
    scenario = parse(text, 'trial')
    assert scenario.run.step_s == 1.0
    assert scenario.settings('spacecraft_dynamics').execution_noise_fraction == 0.01


def test_unknown_key_is_refused_with_the_nearest_known_one():
    assert 'steps_s' in refusal(shared(steps_s=0.5)) and 'step_s?' in refusal(shared(steps_s=0.5))
    text = 'command_blender: {ros__parameters: {eq25: {etta: 0.5}}}'
    assert 'did you mean eq25.eta?' in refusal(text)


def test_unknown_node_is_refused_with_the_nearest_known_one():
    assert 'did you mean command_blender?' in refusal('comand_blender: {ros__parameters: {}}')


def test_shared_key_in_a_node_section_is_refused():
    assert 'under /** only' in refusal('relative_sensor: {ros__parameters: {step_s: 0.5}}')


@pytest.mark.parametrize('values, named', [
    ({'step_s': 0.01}, '0.01'), ({'step_s': 2.0}, '2.0'), ({'step_s': 'fast'}, 'fast'),
    ({'step_s': float('nan')}, 'nan'), ({'step_s': True}, 'True'), ({'step_s': [0.5]}, '0.5'),
    ({'forward_delay_s': 5.3}, '5 and 5.5'), ({'back_delay_s': -1.0}, '-1'),
    ({'mode': 'sharde'}, 'sharde'), ({'seed': -1}, '-1'), ({'seed': 1.5}, '1.5'),
    ({'corridor': {'half_angle_deg': 90.0}}, '90'), ({'corridor': 3.0}, 'corridor'),
    ({'thrust': {'x_m_s2': [0.03, 0.02, 0.01]}}, '0.03'),
    ({'start': {'position_m': [1.0, 0.0, 0.0]}}, '1.0'),
    ({'stick': {'axis_x': 1, 'axis_y': 1}}, 'differ'),
    ({'joy_input': 'held'}, 'held'), ({'timeout_s': 1e9}, '1000000000'),
])
def test_impossible_value_is_refused_by_name(values, named):
    assert named in refusal(shared(**values))


@pytest.mark.parametrize('section, values, named', [
    ('link_forward', {'loss_fraction': 1.5}, 'link_forward: loss_fraction'),
    ('link_back', {'model': 'warp'}, 'warp'),
    ('command_blender', {'eq25': {'eta': 1.2}}, '1.2'),
    ('auto_controller', {'law': 'magic'}, 'magic'),
    ('spacecraft_dynamics', {'truth_model': 'flat'}, 'flat'),
    ('state_predictor', {'filter': 'psychic'}, 'psychic'),
])
def test_impossible_value_of_a_node_is_refused_by_name(section, values, named):
    assert named in refusal(yaml.dump({section: {'ros__parameters': values}}))


@pytest.mark.parametrize('text, said', [
    ('', 'empty'), ('[]', 'mapping'), ('just words', 'mapping'), ('{', 'not valid YAML'),
    ('/**: {}', 'ros__parameters'), ('/**: 3', 'ros__parameters'),
    ('/**: {ros__parameters: {step_s: 0.5, step_s: 0.1}}', 'given twice: step_s'),
    ('/**: {ros__parameters: {timeout_s: 1:30}}', '1:30 would be read as 90'),
    ('/**: {ros__parameters: {timeout_s: 1:30.5}}', '1:30.5 would be read as 90.5'),
    ('/**: {ros__parameters: {seed: 010}}', '010 would be read as 8'),
    ('/**: {ros__parameters: {1: 2}}', 'not text'),
    ('a: &a [x]\nb: *a', 'aliases'),
    ('/**: {ros__parameters: {? [a, b] : 2}}', 'not'),
    ('!!python/object/apply:os.system ["true"]', 'not valid YAML'),
    ('/**: {ros__parameters: ' + '{a: ' * 30 + '1' + '}' * 30 + '}', 'deeper'),
])
def test_malformed_text_is_one_clear_line(text, said):
    assert said in refusal(text)


def test_huge_and_missing_and_binary_files_are_refused(tmp_path: Path):
    huge = tmp_path / 'huge.yaml'
    huge.write_bytes(b'#' * (2 << 20))
    binary = tmp_path / 'binary.yaml'
    binary.write_bytes(b'\xff\xfe\x00')
    for path, said in ((huge, 'larger than'), (tmp_path / 'none.yaml', 'cannot read'),
                       (binary, 'not a text'), (tmp_path, 'cannot read')):
        with pytest.raises(ScenarioError, match=said):
            load(path)


@given(st.text(max_size=200))
@example('/**:\n  ros__parameters: null')
@example('\x00')
def test_any_text_is_a_scenario_or_one_refusal(text):
    try:
        assert isinstance(parse(text, 'trial'), Scenario)
    except ScenarioError as error:
        assert '\n' not in str(error)


def test_with_values_checks_what_it_sets():
    scenario = parse(shared(), 'trial')
    assert scenario.with_values('/**', corridor__half_angle_deg=4.0).part('cone').alpha > 0.06
    with pytest.raises(ScenarioError, match='modus'):
        scenario.with_values('/**', modus='auto')


# -- as other ROS parameter files are written ------------------------------------------------------

def test_a_leading_slash_names_the_same_node():
    plain = 'spacecraft_dynamics: {ros__parameters: {execution_noise_fraction: 0.25}}'
    text = f'/{plain}\n/link_back: {{ros__parameters: {{loss_fraction: 0.5}}}}'
    assert parse(text, 'trial').sections == parse(text.replace('/', ''), 'trial').sections
    assert parse_known(text, 'trial')[0].sections == parse(text, 'trial').sections


@pytest.mark.parametrize('node', ['guard', 'link_back'])
def test_a_node_that_is_given_with_and_without_slash_is_refused(node):
    line = refusal(f'{node}: {{ros__parameters: {{}}}}\n/{node}: {{ros__parameters: {{}}}}')
    assert f'{node} is given twice' in line


@pytest.mark.parametrize('name', ['/', '//link_back', '/ns/link_back', '/*', '1'])
def test_other_names_are_no_node(name):
    assert 'no node' in refusal(f'"{name}": {{ros__parameters: {{}}}}')


@pytest.mark.parametrize('value', ['true', 'false', '1'])
@pytest.mark.parametrize('section', ['/**', 'link_back', '/spacecraft_dynamics'])
def test_use_sim_time_is_refused_with_the_remedy(section, value):
    line = refusal(f'{section}: {{ros__parameters: {{use_sim_time: {value}}}}}')
    assert section.removeprefix('/s') in line or 'spacecraft' in line
    assert 'leave out use_sim_time' in line


# -- seeds: what a ROS parameter can hold ----------------------------------------------------------

@pytest.mark.parametrize('seed', [0, 7, 2**63 - 1])
def test_a_seed_that_fits_a_parameter_of_ros_is_taken(seed):
    assert parse(shared(seed=seed), 'trial').run.seed == seed


@pytest.mark.parametrize('seed', [-1, 2**63, 2**64, 10**30, 1.0, '1e3', 'seven', True, None, [1]])
def test_any_other_seed_is_refused_by_its_value(seed):
    line = refusal(shared(seed=seed))
    assert 'seed must' in line and str(seed) in line
