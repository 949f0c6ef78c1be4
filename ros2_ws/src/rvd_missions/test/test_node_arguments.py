"""What a node makes of its command line: files, overrides, its name, the parameters it serves."""

from pathlib import Path

import pytest
import rclpy
from rclpy.parameter import Parameter

from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.main import make, wanted
from rvd_dynamics.diagram.ros.process import run

ROS = ['/install/lib/rvd_dynamics/relative_sensor', '--ros-args']


def told(*words):
    """Return what the sensor makes of words on its command line."""
    return parsed([*ROS, *words])


@pytest.fixture
def file(tmp_path):
    """Return a function that writes a parameter file."""
    def write(text, name='given'):
        path = tmp_path / f'{name}.yaml'
        path.write_text(text)
        return str(path)
    return write


# -- files and overrides -------------------------------------------------------------------------

def test_the_name_is_that_of_the_executable_unless_it_is_remapped():
    assert (told().executable, told().name) == ('relative_sensor', 'relative_sensor')
    moved = told('-r', '__node:=other')
    assert (moved.executable, moved.name) == ('relative_sensor', 'other')
    assert told('--remap', 'relative_sensor:__node:=other').name == 'other'
    assert told('-r', '/joy:=/stick').name == 'relative_sensor'


def test_without_a_word_everything_has_its_default():
    scenario = told().scenario
    assert scenario.mission.name == 'lunar_approach' and scenario.run.seed == 0
    assert scenario.settings('relative_sensor').selected.noise_fraction == 0.01


def test_a_file_is_read_and_a_later_one_wins_key_by_key(file):
    first = file('/**: {ros__parameters: {seed: 4, step_s: 1}}\n'
                 'relative_sensor: {ros__parameters: {multiplicative: {noise_fraction: 0.02}}}')
    second = file('/**: {ros__parameters: {seed: 5}}\n'
                  '/relative_sensor: {ros__parameters: {multiplicative.noise_fraction: 0.03}}', 'b')
    scenario = told('--params-file', first, '--params-file', second).scenario
    assert (scenario.run.seed, scenario.run.step_s) == (5, 1.0)
    assert scenario.settings('relative_sensor').selected.noise_fraction == 0.03
    assert told('--params-file', first).text() == Path(first).read_text()


@pytest.mark.parametrize('word, seed', [('seed:=7', 7), ('/**:seed:=8', 8)])
def test_an_override_beats_every_file_wherever_it_stands(word, seed, file):
    path = file('/**: {ros__parameters: {seed: 4}}')
    for words in (['-p', word, '--params-file', path], ['--params-file', path, '--param', word]):
        assert told(*words).scenario.run.seed == seed


def test_an_override_without_a_node_means_the_own_section_first():
    scenario = told('-p', 'multiplicative.noise_fraction:=0.05').scenario
    assert scenario.settings('relative_sensor').selected.noise_fraction == 0.05


def test_an_override_may_name_another_node_of_the_same_process():
    scenario = told('-p', 'bag_recorder:bag_dir:=/tmp/x:y', '-p',
                    'relative_sensor:multiplicative.noise_fraction:=0.06').scenario
    assert scenario.settings('bag_recorder').bag_dir == '/tmp/x:y'
    assert scenario.settings('relative_sensor').selected.noise_fraction == 0.06


def test_values_are_read_as_ros_reads_them():
    scenario = told('-p', 'nodes:=[relative_sensor, markers]', '-p', 'start.position_m:=[-9, 0, 1]',
                    '-p', 'timeout_s:=9', '-p', 'frame_id:=lvlh').scenario
    assert scenario.run.nodes == ('relative_sensor', 'markers')
    assert scenario.part('start').position_m == (-9.0, 0.0, 1.0)
    assert (scenario.run.timeout_s, scenario.run.frame_id) == (9.0, 'lvlh')


def test_what_belongs_to_the_process_is_not_part_of_the_scenario():
    arguments = told('-p', 'group:=one', '-p', 'processes:=one')
    assert arguments.process == {'group': 'one'} and arguments.scenario.run.processes == 'one'


def test_sections_of_nodes_that_this_mission_has_not_are_left_alone(file):
    path = file('rviz: {ros__parameters: {speed: 1}}\nother: 3\n'
                'state_predictor: {ros__parameters: {nonsense: 1}}\n'
                '/**: {ros__parameters: {seed: 6}}')
    assert told('--params-file', path).scenario.run.seed == 6


# -- refusals: one line --------------------------------------------------------------------------

FILES = {
    'unknown shared key': ('/**: {ros__parameters: {stepp_s: 1}}', 'did you mean step_s?'),
    'unknown key of its own': ('relative_sensor: {ros__parameters: {sensr: x}}',
                               'relative_sensor: unknown key sensr; did you mean sensor?'),
    'unknown key, leading slash': ('/relative_sensor: {ros__parameters: {sensr: x}}',
                                   'did you mean sensor?'),
    'shared key in its section': ('relative_sensor: {ros__parameters: {seed: 1}}',
                                  'seed is shared by all nodes and stands under /** only'),
    'no parameters': ('/**: {seed: 1}', '/** must hold ros__parameters: and nothing else'),
    'a number': ('/**: 3', '/** must hold ros__parameters: and nothing else'),
    'a list': ('relative_sensor: {ros__parameters: [1]}', 'relative_sensor must hold'),
    'not yaml': ('{', 'not valid YAML'),
    'empty': ('', 'is empty or not a mapping'),
    'bad value': ('/**: {ros__parameters: {seed: many}}',
                  "seed must be a whole number, got 'many'"),
    'another mission': ('/**: {ros__parameters: {mission: mars}}', "no mission 'mars'"),
    'does not fit together': ('/**: {ros__parameters: {joy_input: held}}',
                              'joy_input held needs pace realtime'),
    'off the grid': ('/**: {ros__parameters: {forward_delay_s: 5.2}}', '5 and 5.5'),
}


@pytest.mark.parametrize('text, words', FILES.values(), ids=FILES)
def test_a_bad_file_is_refused_in_one_line(text, words, file):
    with pytest.raises(ValueError) as caught:
        told('--params-file', file(text)).scenario
    assert words in str(caught.value) and '\n' not in str(caught.value)


OVERRIDES = {
    'a number that YAML reads otherwise': ('timeout_s:=1:30', '1:30 would be read as 90'),
    'no value': ('seed', "-p must be followed by NAME:=VALUE, got 'seed'"),
    'not yaml': ('seed:=[1', '-p seed:=[1: the value is not valid YAML'),
    'unknown key': ('sead:=1', '/**: unknown key sead; did you mean seed?'),
    'unknown key of a node': ('relative_sensor:seed_s:=1', 'relative_sensor: unknown key seed_s'),
    'unknown node': ('relative_senser:sensor:=x', 'did you mean relative_sensor?'),
    'bad value': ('step_s:=7.0', 'step_s must be between 0.05 and 1, got 7.0'),
    'bad mission': ('mission:=mars', "no mission 'mars' is installed"),
}


@pytest.mark.parametrize('word, words', OVERRIDES.values(), ids=OVERRIDES)
def test_a_bad_override_is_refused_in_one_line(word, words):
    with pytest.raises(ValueError) as caught:
        told('-p', word).scenario
    assert words in str(caught.value) and '\n' not in str(caught.value)


@pytest.mark.parametrize('words', [['-p', 'seed:=7'], ['--bogus'],
                                   ['--ros-args', '-p', 'seed:=7', '--', 'left']])
def test_what_ros_would_leave_unread_is_refused(words):
    with pytest.raises(ValueError, match='unknown argument .* after --ros-args, such as'):
        parsed([ROS[0], *words])


@pytest.fixture
def ros(monkeypatch):
    monkeypatch.setenv('ROS_AUTOMATIC_DISCOVERY_RANGE', 'OFF')
    yield
    rclpy.try_shutdown()


NODES = {
    'unknown node': (['relative_sensor', '-r', '__node:=sensor'],
                     "sensor: mission lunar_approach has no node 'sensor'"),
    'a link without a name': (['link_emulator'], 'a link must be named link_back or link_forward'),
    'a group where there are none': (['block_group', '-p', 'group:=one'],
                                     'a group needs processes segments or one, got blocks'),
    'a group of another grouping': (
        ['block_group', '-p', 'group:=one', '-p', 'processes:=segments'],
        "group must be one of world, onboard, link, ground with processes segments, got 'one'"),
    'a group without a name': (['block_group', '-p', 'processes:=one'],
                               "group must be one of one with processes one, got ''"),
    'no place for a bag': (['bag_recorder'], 'bag_recorder: bag_dir must name a directory'),
    'arguments that are none of ROS': (['relative_sensor', '--warp'],
                                       "ROS does not start: ['--warp']"),
    'no such file': (['relative_sensor', '--params-file', '/nowhere.yaml'],
                     'cannot read parameter file /nowhere.yaml: No such file'),
}


@pytest.mark.parametrize('words, said', NODES.values(), ids=NODES)
def test_a_process_that_cannot_run_says_so_in_one_line_and_ends_with_code_2(
        words, said, ros, capfd, monkeypatch):
    monkeypatch.setenv('RVD_LEAN', '1')
    arguments = parsed([words[0], '--ros-args', *words[1:]])
    with pytest.raises(SystemExit) as ended:
        run(lambda host: make(host, wanted(host, arguments)), arguments,
            [words[0], '--ros-args', *words[1:]])
    assert ended.value.code == 2
    lines = [line for line in capfd.readouterr().err.splitlines() if '[rcl]' not in line]
    assert len(lines) == 1 and said in lines[0], lines


@pytest.mark.parametrize('domain, said', [('999', 'ROS_DOMAIN_ID=999 must be from 0 to 232'),
                                          ('abc', 'ROS_DOMAIN_ID is not an integral number')])
def test_a_domain_that_dds_does_not_have_is_refused(domain, said, ros, capfd, monkeypatch):
    monkeypatch.setenv('ROS_DOMAIN_ID', domain)
    with pytest.raises(SystemExit, match='2'):
        run(lambda host: make(host, ('relative_sensor',)), parsed(ROS), ROS)
    assert said in capfd.readouterr().err


# -- parameters that are served ------------------------------------------------------------------

@pytest.fixture
def sensor(ros, monkeypatch):
    """Return a sensor as somebody starts it by hand."""
    monkeypatch.delenv('RVD_LEAN', raising=False)
    words = [*ROS, '-p', 'multiplicative.noise_fraction:=0.02', '-p', 'seed:=9', '-p', 'step_s:=1']
    rclpy.init(args=words)
    host = Host(parsed(words))
    make(host, ('relative_sensor',))
    yield host.nodes['relative_sensor']
    host.nodes['relative_sensor'].destroy_node()


def test_a_node_started_by_hand_serves_its_parameters_with_meaning_and_range(sensor):
    noise, seed, pace = map(sensor.describe_parameter, (
        'multiplicative.noise_fraction', 'seed', 'pace'))
    assert noise.description.endswith('.') and noise.read_only
    assert noise.additional_constraints == 'at least 0 and below 1'
    assert seed.description == 'Seed of every random stream.'
    assert 'lockstep' in pace.additional_constraints and 'realtime' in pace.additional_constraints
    step = sensor.describe_parameter('step_s').floating_point_range[0]
    assert (step.from_value, step.to_value) == (0.001, 10.0)
    assert sensor.describe_parameter('run').integer_range[0].to_value == 2**32 - 1


def test_what_it_serves_is_what_it_flies_with(sensor):
    assert sensor.get_parameter('multiplicative.noise_fraction').value == 0.02
    assert sensor.get_parameter('seed').value == sensor.run.seed == 9
    assert sensor.get_parameter('step_s').value == sensor.run.step_s == 1.0
    assert not sensor.has_parameter('bag_dir') and not sensor.has_parameter('eq25.eta')


def test_a_parameter_cannot_be_changed_under_way(sensor):
    done, = sensor.set_parameters([Parameter('seed', value=3)])
    assert not done.successful and sensor.get_parameter('seed').value == 9


def test_a_lean_node_serves_none(ros, monkeypatch):
    monkeypatch.setenv('RVD_LEAN', '1')
    rclpy.init(args=[])
    host = Host(told())
    make(host, ('relative_sensor',))
    assert not host.nodes['relative_sensor'].has_parameter('seed')
    assert not [name for name, _ in host.nodes['relative_sensor'].get_service_names_and_types()
                if 'parameter' in name]
    host.nodes['relative_sensor'].destroy_node()
