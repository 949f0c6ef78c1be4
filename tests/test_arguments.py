"""Bad arguments: one clear line on stderr, exit code 2, no traceback, nothing started or made."""

import os
import subprocess

import pytest
from runs import ROOT, rvd

BAD = {
    'unknown command': (['soar'], 'soar'),
    'no command': ([], 'COMMAND'),
    'unknown scenario': (['fly', 'papre'], 'paper'),
    'unknown mode': (['fly', '--mode', 'psychic'], 'psychic'),
    'unknown operator': (['fly', '--operator', 'dog'], 'dog'),
    'unknown option': (['fly', '--warp'], '--warp'),
    'pace in words': (['fly', '--pace', 'brisk'], 'brisk'),
    'pace not positive': (['fly', '--pace', '0'], 'pace_factor must be between'),
    'pace not a number': (['fly', '--pace', 'nan'], 'pace_factor must be between'),
    'negative seed': (['fly', '--seed', '-1'],
                      'seed must be between 0 and 9223372036854775807, got -1'),
    'seed not whole': (['fly', '--seed', '1.5'], '1.5'),
    'replay without tape': (['fly', '--operator', 'replay'], '--tape'),
    'tape without replay': (['fly', '--operator', 'model', '--tape', 'x'], '--operator replay'),
    'empty scenario': (['fly', ''], 'argument SCENARIO: is empty'),
    'empty tape': (['fly', '--tape', ''], 'argument --tape: is empty'),
    'folder that is no text': (['fly', '--out', '\udcff'], 'argument --out'),
    'scenario in two lines': (['fly', 'a\nb'], "no scenario 'a\\nb'"),
    'tape in two lines': (['fly', '--tape', '.', '--tape-topic', 'a\nb'], 'no bag'),
    'option in two lines': (['fly', '--warp\n9'], '--warp\\n9'),
    'missing tape': (['fly', '--tape', 'nosuch'], 'nosuch'),
    'stick in lock step': (['fly', '--operator', 'joy', '--pace', 'lockstep'], 'realtime'),
    'figures into nowhere': (['bench', 'loop', '--out', 'no/such.json'], 'no is no folder'),
    'pilot into nowhere': (['calibrate', '--out', 'no/such.yaml'], 'no is no folder'),
    'stick into nowhere': (['stick', '--write', 'no/such.yaml'], 'no is no folder'),
    'session without a console': (['fly', '--session', 'x'],
                                  '--session goes with --operator console'),
    'certificate without a console': (['fly', '--tls-cert', 'x'], '--tls-cert goes with'),
    'report of nothing': (['report', 'nowhere'], 'nowhere'),
    'list of nothing': (['list', 'moons'], 'moons'),
}


@pytest.mark.parametrize('args, said', BAD.values(), ids=BAD.keys())
def test_bad_argument_is_one_line_and_exit_code_2(args, said, tmp_path):
    refused(rvd(*args, cwd=tmp_path), said)
    assert not list(tmp_path.iterdir())


SCENARIOS = {
    'unknown key': ('/**: {ros__parameters: {step: 0.5}}', 'did you mean step_s?'),
    'half a step': ('/**: {ros__parameters: {forward_delay_s: 5.2}}', '5 and 5.5'),
    'not yaml': ('{', 'not valid YAML'),
    'empty': ('', 'empty'),
    'nan': ('/**: {ros__parameters: {timeout_s: .nan}}', 'timeout_s must be'),
    'line feed': ('"/**": {ros__parameters: {"mode": "a\\nb"}}', 'got a\\nb'),
    'key with a colour': ('"/**": {ros__parameters: {"\\e[31m": 1}}', 'unknown key \\x1b[31m'),
    'no truth value': ('"/**": {ros__parameters: {mode: !!bool x}}', 'not valid YAML'),
    'dotted and nested': ('"/**": {ros__parameters: {stick.layout: ps4, stick: {layout: ps5}}}',
                          'stick.layout is given twice'),
    'empty mapping': ('"/**": {ros__parameters: {seed: {}}}', 'seed holds nothing'),
    'bomb': ('a: &a [1]\nb: [*a, *a]', 'aliases'),
    'gain of the wrong sign': ('auto_controller: {ros__parameters: '
                               '{law: odrrca, odrrca: {k: 0.5}}}',
                               'odrrca.k must be negative: the range follows exp(k n t)'),
    'attraction that repels': ('auto_controller: {ros__parameters: {safe_apf: {attraction: -1.0}}}',
                               'safe_apf.attraction must be above 0 and at most 100, got -1.0'),
    'aim before the plane': ('auto_controller: {ros__parameters: '
                             '{safe_apf: {aim: {beyond_m: -1}}}}',
                             'safe_apf.aim.beyond_m must be between 0 and 1000, got -1'),
    'bad link file': ('link_back: {ros__parameters: {model: empirical, empirical: {file: nil}}}',
                      'nil cannot be read'),
}


@pytest.mark.parametrize('text, said', SCENARIOS.values(), ids=SCENARIOS.keys())
def test_bad_scenario_is_one_line_and_exit_code_2(text, said, tmp_path):
    path = tmp_path / 'bad.yaml'
    path.write_text(text)
    refused(rvd('fly', str(path), cwd=tmp_path), said)
    assert list(tmp_path.iterdir()) == [path]


TAPES = {
    'empty': ('', 'no header'), 'no header': ('0,0,0,0\n', 'line 1'),
    'time runs back': ('t_s,axis_0,axis_1\n1,0,0\n0.5,0,0\n', 'line 3'),
    'not a number': ('t_s,axis_0\n0,zero\n', 'line 2'),
    'short row': ('t_s,axis_0,axis_1\n0,0\n', 'line 2'),
}


@pytest.mark.parametrize('text, said', TAPES.values(), ids=TAPES.keys())
def test_bad_tape_is_one_line_and_exit_code_2(text, said, tmp_path):
    path = tmp_path / 'bad.csv'
    path.write_text(text)
    done = rvd('fly', '--tape', str(path), cwd=tmp_path)
    refused(done, said)
    assert 'bad.csv' in done.stderr


@pytest.mark.parametrize('suffix', ['csv', 'mcap'])
def test_a_pipe_is_no_tape(suffix, tmp_path):
    path = tmp_path / f'pipe.{suffix}'
    os.mkfifo(path)
    refused(rvd('fly', '--tape', str(path), cwd=tmp_path, timeout=20.0), 'write it to a file first')


def test_a_device_is_no_parameter_file():
    done = subprocess.run(
        [str(ROOT / 'rvd'), 'node', 'rvd_dynamics', 'relative_sensor', '--ros-args',
         '--params-file', '/dev/zero'], capture_output=True, text=True, timeout=20)
    refused(done, '/dev/zero is a pipe or a device: give the parameter file as a file')


def test_nothing_is_overwritten(tmp_path):
    taken = tmp_path / 'taken'
    taken.mkdir()
    (taken / 'thesis.txt').write_text('years of work')
    refused(rvd('fly', '--out', str(taken), cwd=tmp_path), 'nothing is overwritten')
    assert (taken / 'thesis.txt').read_text() == 'years of work'


def test_bad_domain_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr('runs.environment', lambda: {**os.environ, 'ROS_DOMAIN_ID': '999'})
    done = rvd('fly', '--out', str(tmp_path / 'run'), cwd=tmp_path)
    refused(done, 'ROS_DOMAIN_ID must be')


@pytest.mark.parametrize('name, value', [('ROS_DOMAIN_ID', '999'), ('ROS_DOMAIN_ID', '9'*5000),
                                         ('RMW_IMPLEMENTATION', 'rmw_nil')])
def test_a_stick_of_a_topic_is_looked_for_in_a_sound_environment(
        name, value, tmp_path, monkeypatch):
    monkeypatch.setattr('runs.environment', lambda: {**os.environ, name: value})
    refused(rvd('stick', '--topic', '/joy', '--once', cwd=tmp_path), name)


def test_a_stick_of_a_topic_needs_no_home(tmp_path, monkeypatch):
    monkeypatch.setattr('runs.environment', lambda: {
        key: value for key, value in os.environ.items() if key not in ('HOME', 'ROS_LOG_DIR')})
    refused(rvd('stick', '--topic', '/no_such_stick', '--once', cwd=tmp_path), 'nobody publishes')


@pytest.mark.parametrize('what, some', [('laws', 'corridor_apf'), ('scenarios', 'paper'),
                                        ('tapes', 'docking')])
def test_list_names_what_can_be_chosen(what, some, tmp_path):
    done = rvd('list', what, cwd=tmp_path)
    assert done.returncode == 0
    line = next(line for line in done.stdout.splitlines() if line.startswith(some))
    assert len(line.split()) > 3                # and says what it is


@pytest.mark.parametrize('command', ['', 'fly', 'report', 'list', 'limit-cycles', 'bench'])
def test_help_explains_every_command(command, tmp_path):
    done = rvd(*command.split(), '--help', cwd=tmp_path)
    assert done.returncode == 0 and 'usage: rvd' in done.stdout


def test_node_with_a_bad_parameter_says_so_in_one_line():
    done = subprocess.run(
        [str(ROOT / 'rvd'), 'node', 'rvd_dynamics', 'relative_sensor', '--ros-args',
         '-p', 'step_s:=7.0'], capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert done.stderr.strip() == 'relative_sensor: step_s must be between 0.05 and 1, got 7.0'


def refused(done, said):
    assert done.returncode == 2, (done.returncode, done.stdout, done.stderr)
    lines = done.stderr.strip().splitlines()
    assert len(lines) == 1 and said in lines[0], done.stderr
    assert done.stdout == ''
