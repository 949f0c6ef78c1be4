"""The command does its work whatever surrounds it: the working folder, the home, the output."""

import subprocess
from pathlib import Path

import pytest
from runs import environment, verdict_of

ROOT = Path(__file__).resolve().parents[1]
SHORT = """/**:
  ros__parameters:
    mission: lunar_approach
    pace: lockstep
    processes: one
    timeout_s: 0.5
"""


@pytest.fixture
def short(tmp_path):
    """A scenario of one step."""
    path = tmp_path / 'short.yaml'
    path.write_text(SHORT)
    return str(path)


def run(line: str, cwd: Path, **more: str) -> subprocess.CompletedProcess:
    """Run a line of bash in which `rvd` is the command; the environment is a user's."""
    return subprocess.run(['bash', '-c', f'rvd() {{ "{ROOT}/rvd" "$@"; }}; {line}'],
                          cwd=cwd, env={**environment(), **more}, capture_output=True, text=True,
                          timeout=120.0)


@pytest.mark.parametrize('module', ['random', 'numpy'])
def test_a_file_of_the_working_folder_is_no_module_of_ours(short, tmp_path, module):
    (tmp_path / f'{module}.py').write_text('raise SystemExit("the wrong module")\n')
    done = run(f'rvd fly {short} --out run', tmp_path)
    assert done.returncode == 1 and 'the wrong module' not in done.stdout + done.stderr
    assert verdict_of(tmp_path / 'run')['reason'] == 'timeout'


@pytest.mark.slow
def test_nor_is_it_in_a_campaign_or_a_bring_up_by_hand(short, tmp_path):
    (tmp_path / 'random.py').write_text('raise SystemExit("the wrong module")\n')
    done = run('rvd campaign table3 --runs 2 --workers 2 --out table3', tmp_path)
    assert done.returncode == 0, done.stderr
    done = run(f'"{ROOT}/scripts/bringup.sh" {short} run', tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize('home', ['unset HOME', 'export HOME=/nonexistent/home'])
def test_no_home_is_needed_and_none_is_written_to(short, tmp_path, home):
    done = run(f'{home}; rvd fly {short} --out run', tmp_path)
    assert done.returncode == 1 and not done.stderr, done.stderr
    assert (tmp_path / 'run' / 'report.html').is_file()


def test_logs_belong_to_the_run_folder(short, tmp_path):
    home = tmp_path / 'home'
    home.mkdir()
    done = run(f'rvd fly {short} --out run', tmp_path, HOME=str(home))
    assert done.returncode == 1
    assert not (home / '.ros').exists()


@pytest.mark.parametrize('name, value', [('PYTHONWARNINGS', 'error'), ('PYTHONHASHSEED', 'x'),
                                         ('PYTHONINSPECT', '1'), ('PYTHONPLATLIBDIR', 'x')])
def test_settings_of_python_of_the_user_act_on_nothing(tmp_path, name, value):
    done = run('rvd fly no-such', tmp_path, **{name: value})
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done.stderr


@pytest.mark.slow
@pytest.mark.parametrize('name', ['d\u00e9j\u00e0', 'two\nlines\n', '-dash'])
def test_a_run_folder_may_have_any_name_in_any_locale(short, tmp_path, name):
    done = run(f'rvd fly {short} --out="$NAME"', tmp_path, NAME=name, LC_ALL='C',
               PYTHONCOERCECLOCALE='0', PYTHONUTF8='0', PYTHONWARNINGS='error')
    assert done.returncode == 1 and not done.stderr, done.stderr
    assert (tmp_path / name / 'bag').is_dir()


def test_text_that_the_terminal_cannot_show_is_spelled_out(tmp_path):
    done = run('PYTHONIOENCODING=ascii python -m rvd_campaign.cli fly d\u00e9j\u00e0', tmp_path)
    assert done.returncode == 2 and "no scenario 'd\\xe9j\\xe0'" in done.stderr


@pytest.mark.parametrize('line, code', [
    ('rvd fly {short} --out run | head -1', 1),
    ('rvd fly {short} --out run > /dev/full', 1),
    ('rvd fly {short} --out run >&-', 1),
    ('rvd fly {short} --out run 2>&1 > /dev/null | true', 1)])
def test_output_that_cannot_be_written_does_not_stop_the_flight(short, tmp_path, line, code):
    done = run('set -o pipefail; ' + line.format(short=short), tmp_path)
    assert done.returncode == code
    assert 'Traceback' not in done.stderr
    assert (tmp_path / 'run' / 'report.html').is_file()


@pytest.mark.parametrize('line', ['rvd list scenarios | true', 'rvd list scenarios > /dev/full',
                                  'rvd fly --help | head -1', 'rvd report no-such-run 2>&1 | true'])
def test_other_commands_do_not_mind_either(tmp_path, line):
    done = run(line, tmp_path)
    assert 'Traceback' not in done.stderr and 'Exception' not in done.stderr


def test_a_full_disk_at_the_output_is_said(tmp_path):
    assert run('rvd list scenarios > /dev/full', tmp_path).stderr == \
        'rvd: output cannot be written: No space left on device\n'


@pytest.mark.parametrize('operator', ['"none"', 'none   # nobody', "'none'"])
def test_the_bring_up_reads_yaml_as_yaml(tmp_path, operator):
    """The processes come from the parsed scenario, however the operator is written."""
    path = tmp_path / 's.yaml'
    path.write_text(SHORT + f'    operator: {operator}\n')
    done = run(f'rvd shell python3 -m rvd_dynamics.diagram.roster {path} run', tmp_path)
    assert done.returncode == 0, done.stderr
    assert 'operator_model' not in done.stdout


def test_the_bring_up_reads_a_flow_mapping(tmp_path):
    path = tmp_path / 's.yaml'
    path.write_text('{"/**": {ros__parameters: {operator: none, processes: blocks}}}\n')
    done = run(f'rvd shell python3 -m rvd_dynamics.diagram.roster {path} run', tmp_path)
    assert done.returncode == 0 and 'operator_model' not in done.stdout
    assert len(done.stdout.splitlines()) > 8
