"""
The set-up on copies of the project: from nothing, killed, changed, moved, and what it refuses.

The slow ones build a copy for real from the package index, once, and go on with it in the order
of this file. Everything runs as in a shell that has nothing of this project loaded.
"""

import fcntl
import os
from pathlib import Path
import platform
import re
import shutil
import signal
import subprocess
import sys
import time

from packaging.requirements import Requirement
import pytest
from rvd_campaign import cli

ROOT = Path(__file__).resolve().parents[1]
TOOLS = ('awk bash cat comm cp cut date dirname env find flock grep kill ls mkdir mv readlink rm '
         'sed sha256sum sh sleep sort tail tr true uname').split()
PYTHONS = ['3.10', '3.11', '3.12', '3.13']


def for_real(test):
    """Mark a test that sets a copy up: minutes on a busy machine, and only where wheels exist."""
    wheels = pytest.mark.skipif(platform.machine() != 'x86_64', reason='wheels are for x86_64')
    return pytest.mark.slow(pytest.mark.patient(pytest.mark.timeout(1800)(wheels(test))))


def outside():
    """Return the environment of a user who has not loaded the project, without a ROS 2."""
    names = re.compile(r'VIRTUAL_ENV|PYTHON.*|LD_LIBRARY_PATH|(AMENT|CMAKE|COLCON)_PREFIX_PATH|'
                       r'ROS_.*|RVD_.*|_ROS_WHEELS_BOOTSTRAP_COMPLETE|CI|'
                       r'FASTRTPS_.*|FASTDDS_.*|SKIP_DEFAULT_XML_FILE')
    ours = {name: value for name, value in os.environ.items() if not names.fullmatch(name)}
    path = [entry for entry in ours['PATH'].split(':') if '/.rvd/' not in entry]
    return {**ours, 'PATH': ':'.join(path), 'RVD_ROS_PREFIX': 'none'}


def rvd(project, *arguments, cwd=None, **variables):
    """Run ./rvd of a project in a clean environment, and return what it did."""
    return subprocess.run([project / 'rvd', *arguments], cwd=cwd or project, text=True,
                          env={**outside(), **variables}, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def copy_of_the_project(place):
    """Copy what the repository would hold if everything here were committed."""
    listed = subprocess.run(['git', 'ls-files', '-z', '--cached', '--others', '--exclude-standard'],
                            cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split('\0')):
        if (ROOT / name).exists():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, place / name, follow_symlinks=False)
    return place


def folder_of_tools(place, without=()):
    """Make a folder to use as PATH: what the scripts call, a Python and a compiler."""
    place.mkdir()
    for name in [*TOOLS, 'g++', 'make']:
        found = shutil.which(name, path=outside()['PATH'])
        if found and name not in without:
            (place / name).symlink_to(found)
    if 'python3' not in without:
        (place / 'python3').symlink_to(os.path.realpath(sys.executable))
    return place


def stand_in(folder, name, script):
    """Put a shell script into a folder of tools in the place of a command."""
    (folder / name).unlink(missing_ok=True)
    (folder / name).write_text('#!/bin/sh\n' + script)
    (folder / name).chmod(0o755)


def refusal(done):
    """Return the one line with which a command that could not run ended."""
    assert (done.returncode, done.stdout) == (2, ''), done
    assert done.stderr.count('\n') == 1 and done.stderr.startswith('rvd: '), done.stderr
    return done.stderr


@pytest.fixture
def project(tmp_path):
    """Return a copy of the project in which nothing is set up."""
    place = tmp_path / 'project'
    place.mkdir()
    return copy_of_the_project(place)


# ------------------------------------------------------------------------- without setting up

def test_help_lists_the_commands_without_setting_up(project):
    for arguments in [('help',), ('--help',), (), ('setup', '--help'), ('node', '-h')]:
        done = rvd(project, *arguments)
        assert done.returncode == 0
        assert re.findall(r'^  ([\w-]+) ', done.stdout, re.MULTILINE) == [
            'fly', 'report', 'campaign', 'calibrate', 'list', 'stick', 'limit-cycles', 'bench',
            'node', 'shell', 'test', 'setup', 'help']
    assert not (project / '.rvd').exists()


def test_every_command_in_python_is_passed_on():
    commands = next(action.choices for action in cli.parser()._actions if action.dest == 'command')
    listed = re.search(r'^    ([a-z| -]+)\)\n +load\n(?:.*\n){1,3}'
                       r' +exec .*python -m rvd_campaign.cli',
                       (ROOT / 'rvd').read_text(), re.MULTILINE).group(1)
    assert set(listed.split(' | ')) == set(commands)


def test_unknown_command_is_refused_without_setting_up(project):
    assert "'flie'" in refusal(rvd(project, 'flie'))
    assert not (project / '.rvd').exists()


@pytest.mark.parametrize('shell', ['sh', 'dash', 'bash'])
@pytest.mark.parametrize('posix', [{}, {'POSIXLY_CORRECT': '1'}], ids=['', 'posixly correct'])
def test_it_may_be_started_by_the_name_of_a_shell(project, shell, posix):
    if shutil.which(shell) is None:
        pytest.skip(f'no {shell} here')
    done = subprocess.run([shell, 'rvd', 'help'], cwd=project, env={**outside(), **posix},
                          capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, '') and done.stdout.startswith('rvd: ')
    for script in ('setup.sh', 'bringup.sh'):
        done = subprocess.run([shell, f'scripts/{script}', '--help'], cwd=project, text=True,
                              env={**outside(), **posix}, capture_output=True)
        assert 'Bad substitution' not in done.stderr and 'Illegal option' not in done.stderr
        assert script in done.stdout or 'setup takes' in done.stderr


def test_basilisk_is_set_up_by_a_python_that_is_named(project):
    for arguments in ((), ('/no/such/python',)):
        done = subprocess.run(['scripts/setup.sh', '--basilisk', *arguments], cwd=project,
                              env=outside(), capture_output=True, text=True)
        assert refusal(done) == 'rvd: --basilisk takes a Python that has uv\n'
    assert not (project / '.rvd').exists()


def test_what_an_installed_ros_brings_is_not_built(project, tmp_path):
    """tf2_msgs of ROS is not hidden, and one that comes later makes the set-up build again."""
    def asked(ros, **variables):
        done = subprocess.run(
            ['bash', '-c', 'set -euo pipefail; root=$PWD ros=$1; source scripts/state.sh; '
             'find_sources; printf "%s\\n" "${sources[@]#$root/}"; build_inputs | tail -n 1',
             'bash', str(ros)], cwd=project, env={**outside(), **variables},
            capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, ''), done
        *sources, newest = done.stdout.splitlines()
        assert newest.endswith('TFMessage.msg') == ('ros2_extra/tf2_msgs' in sources)
        return sources

    bare, full = tmp_path / 'bare', tmp_path / 'full'
    (full / 'share' / 'tf2_msgs').mkdir(parents=True)
    (full / 'share' / 'tf2_msgs' / 'package.xml').touch()
    bare.mkdir()
    ours = ['ros2_ws/src', 'ros2_extra/tf2_msgs']
    assert asked('wheels') == asked(bare) == ours and asked(full) == ours[:1]
    assert asked('wheels', AMENT_PREFIX_PATH=str(full)) == ours
    assert asked('sourced', AMENT_PREFIX_PATH=f'{bare}:{full}') == ours[:1]
    # what an earlier set-up of this project built and the shell has loaded is not ROS
    own = tmp_path / '.rvd' / 'install'
    shutil.copytree(full, own)
    assert asked('sourced', AMENT_PREFIX_PATH=f'{own}:{bare}') == ours


@pytest.mark.parametrize('where', ['.', 'elsewhere'])
def test_a_search_path_of_cd_leads_no_script_astray(project, where):
    (project / 'elsewhere' / 'scripts').mkdir(parents=True)
    (project / 'rvd').write_text('#!/bin/sh\necho "called: $*"\n')        # bringup.sh asks it
    done = subprocess.run(['bash', 'scripts/bringup.sh', 'paper.yaml', 'run'], cwd=project,
                          env={**outside(), 'CDPATH': str(project / where)},
                          capture_output=True, text=True)
    assert (done.stdout, done.stderr) == (
        'called: shell scripts/bringup.sh paper.yaml run\n', '')
    (project / 'overlay' / 'share/ament_index/resource_index/packages/mine').mkdir(parents=True)
    (project / 'overlay' / 'local_setup.bash').touch()
    done = subprocess.run(
        ['bash', '-c', 'source scripts/overlay.sh; load_overlay; echo "$RVD_OVERLAY"'],
        cwd=project, env={**outside(), 'CDPATH': str(project / where), 'RVD_OVERLAY': 'overlay'},
        capture_output=True, text=True)
    assert (done.stdout, done.stderr) == (f'{project}/overlay\n', '')


@pytest.mark.parametrize('missing', [['g++'], ['make'], ['g++', 'make']])
def test_missing_tools_are_named_as_packages_to_install(project, tmp_path, missing):
    tools = folder_of_tools(tmp_path / 'tools', without=missing)
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert line.endswith('apt-get install ' + ' '.join(missing) + '\n')


def as_root(tools, uid=0):
    """Let the scripts believe that they run as root, or as another user."""
    stand_in(tools, 'id', f'echo {uid}\n')


def imitate_apt_get(tools, place, brings, update_first=False):
    """Put an apt-get into a folder of tools that notes what it is told and brings some tools."""
    bring = ''.join(f'ln -sf {shutil.which(name, path=outside()["PATH"])} {tools}/{name}\n'
                    for name in brings)
    (tools / 'ln').symlink_to(shutil.which('ln'))
    lists = f'{place}/lists'
    stand_in(tools, 'apt-get', f'echo "$@" >> {place}/told\n'
             + (f'[ "$1" = update ] && touch {lists} && exit\n'
                f'[ -e {lists} ] || {{ echo "E: Unable to locate package" >&2; exit 100; }}\n'
                if update_first else '') + (f'(touch {lists})\n') + bring)
    (tools / 'touch').symlink_to(shutil.which('touch'))


def test_root_gets_what_is_missing_installed_and_the_set_up_goes_on(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['g++', 'make'])
    as_root(tools)
    imitate_apt_get(tools, tmp_path, ['g++', 'make'])
    done = rvd(project, 'fly', PATH=str(tools), PIP_NO_INDEX='1', PIP_CONFIG_FILE='/dev/null')
    assert done.returncode == 2                 # without an index that is as far as it gets
    assert 'installing g++ make on this machine, with apt-get' in done.stderr
    assert 'installing' in done.stderr.partition('making the environment')[2]


@pytest.mark.parametrize('fresh', [False, True], ids=['', 'without package lists'])
def test_what_apt_get_does_not_bring_is_named(project, tmp_path, fresh):
    tools = folder_of_tools(tmp_path / 'tools', without=['g++', 'make'])
    as_root(tools)
    imitate_apt_get(tools, tmp_path, ['g++'], update_first=fresh)
    done = rvd(project, 'fly', PATH=str(tools))
    assert done.returncode == 2
    assert done.stderr.endswith('rvd: missing on this machine: sudo apt-get install make\n')
    ask = 'install -y --no-install-recommends g++ make'
    assert (tmp_path / 'told').read_text().splitlines() == (
        [ask, 'update', ask] if fresh else [ask])


def test_an_apt_get_that_fails_shows_its_last_words(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    as_root(tools)
    stand_in(tools, 'apt-get', 'echo "E: Could not get lock" >&2\nexit 100\n')
    done = rvd(project, 'fly', PATH=str(tools))
    assert done.returncode == 2 and 'E: Could not get lock' in done.stderr
    assert '.rvd/log/system.log' in done.stderr


def test_who_is_not_root_gets_the_line_to_type(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    as_root(tools, uid=1000)
    imitate_apt_get(tools, tmp_path, ['make'])
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert line.endswith('sudo apt-get install make\n') and not (tmp_path / 'told').exists()


def test_cmake_is_among_the_packages():
    assert 'cmake' in {requirement.name for requirement, _ in entries()}


def test_missing_python_is_named(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['python3'])
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert line.endswith('apt-get install python3 python3-venv python3-dev\n')


@pytest.mark.parametrize('patch, package', [
    ('import sysconfig; sysconfig.get_path = lambda name: "/nowhere"', 'python3-dev'),
    ('import sys; sys.modules["ensurepip"] = None; import importlib.util; '
     'find = importlib.util.find_spec; '
     'importlib.util.find_spec = lambda n: None if n == "ensurepip" else find(n)', 'python3-venv'),
])
def test_python_without_headers_or_venv_is_named(project, tmp_path, patch, package):
    tools = folder_of_tools(tmp_path / 'tools')
    real = os.path.realpath(sys.executable)
    stand_in(tools, 'python3', f"(echo '{patch}'; cat) | exec {real} -I -\n")
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert re.search(rf'apt-get install python3\S*-{package[8:]}\n', line), line


def test_the_next_python_is_taken_where_the_first_is_incomplete(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    real = os.path.realpath(sys.executable)
    stand_in(tools, 'python3', f"(echo 'import sysconfig; sysconfig.get_path = lambda name: \"/x\"'"
                               f'; cat) | exec {real} -I -\n')
    (tools / 'python3.11').symlink_to(real)
    assert refusal(rvd(project, 'fly', PATH=str(tools))).endswith('apt-get install make\n')


def test_a_python_without_wheels_is_refused_with_its_version(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools')
    stand_in(tools, 'python3', '[ "$1" = -V ] && echo Python 3.9.2\nexit 1\n')
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert '3.9.2' in line and '3.10 to 3.13' in line


def test_a_shim_that_points_nowhere_is_passed_over(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    stand_in(tools, 'python3', 'echo "no version is set" >&2\nexit 127\n')
    (tools / 'python3.12').symlink_to(os.path.realpath(sys.executable))
    assert refusal(rvd(project, 'fly', PATH=str(tools))).endswith('apt-get install make\n')


def test_the_python_asked_for_must_exist(project):
    assert '/no/python' in refusal(rvd(project, 'fly', RVD_PYTHON='/no/python'))


@pytest.mark.parametrize('system, machine', [('Linux', 'aarch64'), ('Darwin', 'arm64')])
def test_other_machines_are_refused_by_name(project, tmp_path, system, machine):
    tools = folder_of_tools(tmp_path / 'tools')
    stand_in(tools, 'uname', f'[ "$1" = -s ] && echo {system} || echo {machine}\n')
    line = refusal(rvd(project, 'fly', PATH=str(tools)))
    assert (machine if system == 'Linux' else system) in line


def test_a_path_that_the_build_tools_cannot_take_is_refused(tmp_path):
    place = tmp_path / 'with space'
    place.mkdir()
    assert 'with space' in refusal(rvd(copy_of_the_project(place), 'fly'))


def test_a_prefix_without_ros_is_refused(project, tmp_path):
    assert 'setup.bash' in refusal(rvd(project, 'fly', RVD_ROS_PREFIX=str(tmp_path)))


def test_a_second_set_up_waits_for_the_first(project, tmp_path):
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    (project / '.rvd').mkdir()
    with open(project / '.rvd' / 'lock', 'w') as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        second = subprocess.Popen([project / 'rvd', 'setup'], stderr=subprocess.PIPE, text=True,
                                  env={**outside(), 'PATH': str(tools)})
        assert 'waiting' in second.stderr.readline()
        with pytest.raises(subprocess.TimeoutExpired):
            second.wait(0.5)
    assert second.wait(20) == 2                  # went on, to find that make is missing
    second.stderr.close()


# ------------------------------------------------------------------------------- the lock file

def entries():
    """Return (requirement, hashes) of each entry of the lock file."""
    blocks = re.split(r'^(?=[A-Za-z])', (ROOT / 'requirements.lock').read_text(), flags=re.M)[1:]
    return [(Requirement(block.split('\\\n')[0]), re.findall(r'--hash=sha256:[0-9a-f]{64}', block))
            for block in blocks]


def test_every_entry_of_the_lock_is_pinned_and_hashed():
    for requirement, hashes in entries():
        assert re.fullmatch(r'==[^*,]+', str(requirement.specifier)), requirement
        assert hashes, requirement


def test_the_lock_names_no_host():
    text = (ROOT / 'requirements.lock').read_text()
    assert '://' not in text and not re.search(r'^\s*-(?!-hash)', text, re.MULTILINE)


@pytest.mark.parametrize('version', PYTHONS)
def test_the_lock_gives_each_python_one_version_of_all_that_is_asked_for(version):
    machine = {'python_version': version, 'python_full_version': version + '.0',
               'sys_platform': 'linux', 'platform_system': 'Linux', 'os_name': 'posix',
               'platform_machine': 'x86_64', 'implementation_name': 'cpython',
               'platform_python_implementation': 'CPython'}
    chosen = [requirement.name for requirement, _ in entries()
              if not requirement.marker or requirement.marker.evaluate(machine)]
    assert len(chosen) == len(set(chosen))
    asked = [Requirement(line.split('#')[0].strip())
             for line in (ROOT / 'requirements.in').read_text().splitlines()
             if line.split('#')[0].strip()]
    missing = {requirement.name.lower() for requirement in asked} - set(chosen)
    assert not missing


def test_ros_is_asked_for_by_the_names_of_jazzy_only():
    direct = [line for line in (ROOT / 'requirements.in').read_text().splitlines()
              if line.startswith('ros-')]
    assert direct and all(line.startswith('ros-jazzy-') for line in direct)
    pins = {requirement.name: str(requirement.specifier) for requirement, _ in entries()}
    for name, version in pins.items():
        if name.startswith('ros-jazzy-') and 'ros-' + name[10:] in pins:
            assert pins['ros-' + name[10:]] == version, name


def test_what_ros_brings_is_not_installed_beside_it(tmp_path):
    for name in ['numpy', 'PyYAML', 'catkin_pkg', 'colcon-ros', 'empy', 'lark', 'setuptools']:
        info = tmp_path / f'{name}-1.dist-info'
        info.mkdir()
        (info / 'METADATA').write_text(f'Metadata-Version: 2.1\nName: {name}\nVersion: 1\n')
    code = (f'import sys; sys.path[1:] = [p for p in sys.path if "site-packages" not in p]; '
            f'sys.path.append({str(tmp_path)!r}); sys.argv[1:] = ["requirements.lock"]; '
            f'import runpy; runpy.run_path("scripts/lock_beside_ros.py", run_name="__main__")')
    text = subprocess.run([sys.executable, '-S', '-c', code], cwd=ROOT, capture_output=True,
                          text=True, check=True).stdout
    kept = set(re.findall(r'^([A-Za-z0-9-]+)==', text, re.MULTILINE))
    everything = {requirement.name for requirement, _ in entries()}
    gone = {name for name in everything - kept if not name.startswith(('ros-', 'colcon-'))}
    assert gone == {'numpy', 'pyyaml', 'catkin-pkg', 'empy', 'lark-parser', 'setuptools'}
    assert not any(name.startswith(('ros-', 'colcon-')) for name in kept)
    assert {'scipy', 'filterpy', 'mcap', 'pytest', 'uv'} <= kept


# ------------------------------------------------------------------------------- for real, slow

def start(project, *arguments, **variables):
    """Start ./rvd in a process group of its own."""
    return subprocess.Popen([project / 'rvd', *arguments], env={**outside(), **variables},
                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, text=True, start_new_session=True)


def kill_in_stage(project, stage, delay_s, group=True):
    """
    Start a set-up and kill -9 it, or its shell alone, some time after a stage began.

    Return what it had said.
    """
    process = start(project, 'setup')
    said = ''
    for line in process.stderr:
        said += line
        if stage in line:
            break
    else:
        pytest.fail(f'the set-up ended before {stage!r}')
    time.sleep(delay_s)
    if group:
        os.killpg(process.pid, signal.SIGKILL)
    else:
        os.kill(process.pid, signal.SIGKILL)
    process.wait()
    process.stderr.close()
    assert not (project / '.rvd' / 'done').exists()
    return said


def tree(project):
    """Return every file outside of .rvd, caches left out."""
    return {str(path.relative_to(project)) for path in project.rglob('*')
            if not {'.rvd', '__pycache__'} & set(path.relative_to(project).parts)}


@pytest.fixture(scope='module')
def ready(tmp_path_factory):
    """
    Set a copy up, after two attempts that were killed.

    Return (project, what the command that did it said).
    """
    project = copy_of_the_project(tmp_path_factory.mktemp('ready'))
    before = tree(project)
    # The shell alone first: what it had started lives on, and must not meet the next set-up.
    kill_in_stage(project, 'making the environment', 0.2, group=False)
    assert 'waiting' in kill_in_stage(project, 'installing', 2.0)
    done = rvd(project, 'shell', 'python', '-c',
               'import rclpy, rvd_interfaces.msg; print("loaded")')
    assert done.returncode == 0, done.stderr
    assert tree(project) == before
    return project, done


@for_real
def test_the_first_command_sets_everything_up_and_says_what_it_does(ready):
    _, done = ready
    assert done.stdout == 'loaded\n'
    assert 'the last set-up was interrupted' in done.stderr
    for stage in ['making the environment', 'installing', 'building', 'checking', 'ready after']:
        assert stage in done.stderr


@for_real
def test_a_second_call_has_nothing_to_do_and_starts_no_python(ready, tmp_path):
    project, *_ = ready
    record = (project / '.rvd' / 'done').stat()
    python = project / '.rvd' / 'venv' / 'bin' / 'python'
    kept = python.rename(python.with_name('python.kept'))
    try:
        python.write_text(f'#!/bin/sh\ntouch {tmp_path}/called\nexec {kept} "$@"\n')
        python.chmod(0o755)
        done = rvd(project, 'shell', 'true')
    finally:
        kept.replace(python)
    assert not (tmp_path / 'called').exists()   # that would take longer than all the rest
    assert (done.returncode, done.stdout, done.stderr) == (0, '', '')
    assert 'up to date' in rvd(project, 'setup').stderr
    assert (project / '.rvd' / 'done').stat().st_mtime_ns == record.st_mtime_ns


@for_real
def test_the_environment_is_complete_and_its_own(ready):
    project, *_ = ready
    line = ('echo "$ROS_AUTOMATIC_DISCOVERY_RANGE $FASTRTPS_DEFAULT_PROFILES_FILE $OMP_NUM_THREADS '
            '$RVD_ROOT"; command -v python; '
            'printf "%s\\n" ${AMENT_PREFIX_PATH//:/ } ${PYTHONPATH//:/ } ${LD_LIBRARY_PATH//:/ }')
    other = {'PYTHONPATH': '/opt/other', 'AMENT_PREFIX_PATH': '/opt/ros/humble',
             'ROS_DISTRO': 'humble'}
    defaults, python, *paths = rvd(project, 'shell', '-c', line, **other).stdout.splitlines()
    assert defaults == \
        f'SYSTEM_DEFAULT {project}/config/fastdds_loopback.xml 1 {project}'
    assert python == f'{project}/.rvd/venv/bin/python'
    assert paths and all(path.startswith(f'{project}/.rvd/') for path in paths)
    asked = ('echo $ROS_AUTOMATIC_DISCOVERY_RANGE ${FASTRTPS_DEFAULT_PROFILES_FILE-none} '
             '$FASTDDS_BUILTIN_TRANSPORTS')
    assert rvd(project, 'shell', '-c', asked,
               ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNET').stdout == 'SUBNET none UDPv4\n'


@for_real
def test_no_home_is_needed(ready):
    project, *_ = ready
    made = (project / '.rvd' / 'env.sh').read_text()
    for name in ('env.sh', 'done'):
        (project / '.rvd' / name).unlink()
    done = subprocess.run(['env', '-u', 'HOME', project / 'rvd', 'list', 'laws'], env=outside(),
                          text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    assert (project / '.rvd' / 'env.sh').read_text() == made


@for_real
def test_node_finds_executables_as_ros2_run_does(ready):
    project, *_ = ready
    folder = project / '.rvd' / 'install' / 'rvd_dynamics' / 'lib' / 'rvd_dynamics'
    stand_in(folder, 'says', 'printf "%s|" "$@"\nexit 7\n')
    done = rvd(project, 'node', 'rvd_dynamics', 'says', '--ros-args', '-p', 'a:=b c')
    assert (done.returncode, done.stdout) == (7, '--ros-args|-p|a:=b c|')
    (folder / 'says').unlink()
    listed = refusal(rvd(project, 'node', 'rvd_dynamics', 'says'))
    assert 'spacecraft_dynamics' in listed and 'link_emulator' in listed
    assert 'no_package' in refusal(rvd(project, 'node', 'no_package', 'x'))
    assert 'usage' in refusal(rvd(project, 'node', 'rvd_dynamics'))


@for_real
def test_an_edited_source_acts_at_once(ready):
    project, *_ = ready
    module = project / 'ros2_ws' / 'src' / 'rvd_dynamics' / 'rvd_dynamics' / 'constants.py'
    module.write_text(module.read_text() + '\nEDITED = 41 + 1\n')
    done = rvd(project, 'shell', 'python', '-c',
               'from rvd_dynamics.constants import EDITED; print(EDITED)', cwd='/')
    assert (done.stdout, done.stderr) == ('42\n', '')


CHANGES = {
    'lock file': 'requirements.lock',
    'message': 'ros2_ws/src/rvd_interfaces/msg/Verdict.msg',
    'package.xml': 'ros2_ws/src/rvd_campaign/package.xml',
    'setup.py': 'ros2_ws/src/rvd_dynamics/setup.py',
    'CMakeLists.txt': 'ros2_ws/src/rvd_interfaces/CMakeLists.txt',
}


@for_real
@pytest.mark.parametrize('name', CHANGES.values(), ids=CHANGES.keys())
def test_a_change_is_noticed_and_its_undoing_too(ready, tmp_path, name):
    project, *_ = ready
    # Without make a set-up that has work to do refuses at once, so that this takes no time.
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    text = (project / name).read_text()
    (project / name).write_text(text + '\n')
    assert 'make' in refusal(rvd(project, 'shell', 'true', PATH=str(tools)))
    (project / name).write_text(text)
    assert rvd(project, 'shell', 'true', PATH=str(tools)).returncode == 0


@for_real
def test_another_python_is_noticed(ready, tmp_path):
    project, *_ = ready
    tools = folder_of_tools(tmp_path / 'tools', without=['make'])
    base = (project / '.rvd' / 'python').read_text().splitlines()[1]
    assert rvd(project, 'shell', 'true', PATH=str(tools), RVD_PYTHON=base).returncode == 0
    asked = {'PATH': str(tools), 'RVD_PYTHON': str(tools / 'python3')}
    assert 'make' in refusal(rvd(project, 'shell', 'true', **asked))
    link = project / '.rvd' / 'venv' / 'bin' / 'python'
    target = os.readlink(link)
    link.unlink()
    link.symlink_to('/no/longer/there')
    assert 'make' in refusal(rvd(project, 'shell', 'true', PATH=str(tools)))
    link.unlink()
    link.symlink_to(target)


@for_real
def test_a_build_killed_half_way_is_repaired_with_the_change_that_caused_it(ready):
    project, *_ = ready
    message = project / 'ros2_ws' / 'src' / 'rvd_interfaces' / 'msg' / 'Verdict.msg'
    message.write_text(message.read_text() + 'uint8 added_by_test\n')
    kill_in_stage(project, 'building', 4.0)
    both = [start(project, 'shell', 'python', '-c',
                  'from rvd_interfaces.msg import Verdict; Verdict().added_by_test')
            for _ in range(2)]
    said = [process.communicate()[1] for process in both]
    assert [process.returncode for process in both] == [0, 0], said
    assert 'waiting' in said[0] + said[1]
    assert (said[0] + said[1]).count('ready after') == 1


ROS_SETUP = """
export ROS_DISTRO=jazzy ROS_VERSION=2 ROS_PYTHON_VERSION=3
export AMENT_PREFIX_PATH={prefix}/ros${{AMENT_PREFIX_PATH:+:$AMENT_PREFIX_PATH}}
export CMAKE_PREFIX_PATH={prefix}/ros${{CMAKE_PREFIX_PATH:+:$CMAKE_PREFIX_PATH}}
export PYTHONPATH={prefix}/python${{PYTHONPATH:+:$PYTHONPATH}}
export LD_LIBRARY_PATH={libraries}${{LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}}
export PATH={prefix}/bin:$PATH
"""


def imitate_installed_ros(prefix, venv):
    """
    Make a prefix that acts like /opt/ros/jazzy out of the ROS packages of a Python environment.

    setup.bash exports what that of an installation does; PYTHONPATH holds the packages of ROS and
    no others; there is a ros2 command, which prints its arguments.
    """
    site = next((venv / 'lib').glob('python3*/site-packages'))
    (prefix / 'python').mkdir(parents=True)
    names = {line.split('/')[0] for info in site.glob('ros_*.dist-info')
             for line in (info / 'RECORD').read_text().splitlines() if not line.startswith('.')}
    for name in names:
        if not name.startswith(('ros_', '__pycache__')) and not name.endswith('.pth'):
            (prefix / 'python' / name.split(',')[0]).symlink_to(site / name.split(',')[0])
    (prefix / 'ros').symlink_to(venv)
    (prefix / 'bin').mkdir()
    stand_in(prefix / 'bin', 'ros2', 'echo "ros2 $*"\n')
    libraries = [prefix / 'ros' / folder.relative_to(venv)
                 for folder in [venv / 'lib', *site.glob('ros_*.libs')]]
    (prefix / 'setup.bash').write_text(
        ROS_SETUP.format(prefix=prefix, libraries=':'.join(map(str, libraries))))


@for_real
def test_an_installed_ros_is_built_on_and_left_as_it_is(ready, project, tmp_path):
    venv = ready[0] / '.rvd' / 'venv'
    prefix = tmp_path / 'jazzy'
    imitate_installed_ros(prefix, venv)
    ros = {'RVD_ROS_PREFIX': str(prefix),
           'RVD_PYTHON': (ready[0] / '.rvd' / 'python').read_text().splitlines()[1]}

    line = ('echo $ROS_DISTRO; python -c "import rclpy, rvd_interfaces.msg, filterpy as f; '
            'print(rclpy.__file__); print(f.__file__)"')
    done = rvd(project, 'shell', '-c', line, **ros)
    assert done.returncode == 0, done.stderr
    own = project / '.rvd' / 'venv'
    distro, rclpy, filterpy = done.stdout.splitlines()
    assert distro == 'jazzy' and rclpy.startswith(str(prefix)) and filterpy.startswith(str(own))
    assert not list(own.glob('lib/python3*/site-packages/ros_*'))
    assert 'include-system-site-packages = true' in (own / 'pyvenv.cfg').read_text()

    assert rvd(project, 'node', 'rvd_dynamics', 'markers', '-x', **ros).stdout == (
        'ros2 run rvd_dynamics markers -x\n')
    script = project / '.rvd/install/rvd_dynamics/lib/rvd_dynamics/markers'
    assert script.read_text().startswith(f'#!{own}/bin/python')

    # An overlay of the user that is loaded already keeps its place before ROS.
    loaded = {'ROS_DISTRO': 'jazzy', 'AMENT_PREFIX_PATH': f'/home/user/ws:{prefix}/ros'}
    path = rvd(project, 'shell', '-c', 'echo $AMENT_PREFIX_PATH', **ros, **loaded).stdout
    entries = path.strip().split(':')
    assert entries[-2:] == ['/home/user/ws', f'{prefix}/ros']
    packages = len([*(project / 'ros2_ws' / 'src').iterdir(), *(project / 'ros2_extra').iterdir()])
    assert f'{prefix}/ros' not in entries[:-2] and len(entries) == packages + 2


@for_real
def test_a_moved_project_sets_itself_up_in_its_new_place(ready, tmp_path):
    project, *_ = ready
    moved = tmp_path / 'moved'
    shutil.move(project, moved)                  # the last test here: nothing goes on with it
    done = rvd(moved, 'shell', 'pytest', '--version')
    assert done.returncode == 0 and 'the location of the project changed' in done.stderr
    for folder in ['venv/bin', 'install/rvd_dynamics/lib/rvd_dynamics']:
        for path in (moved / '.rvd' / folder).iterdir():
            assert not path.is_file() or str(project).encode() not in path.read_bytes()[:300]
