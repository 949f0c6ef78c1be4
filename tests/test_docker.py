"""
The container files name only what exists: they cannot be built in every place that runs the tests.

What no test here sees: the base image itself, and whether apt finds the packages in it.
"""

from pathlib import Path
import re
import shlex
import subprocess

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[1]
DOCKER = ROOT / 'docker'


def instructions():
    """Return the Dockerfile as (INSTRUCTION, arguments), continued lines joined."""
    text = re.sub(r'^\s*#.*\n', '', (DOCKER / 'Dockerfile').read_text(), flags=re.MULTILINE)
    lines = text.replace('\\\n', ' ').splitlines()
    return [tuple(line.split(maxsplit=1)) for line in lines if line.strip()]


def arguments(instruction):
    """Return the arguments of every line of this instruction."""
    return [rest for name, rest in instructions() if name == instruction]


def commands():
    """Return every shell command of the RUN lines as a list of words."""
    return [shlex.split(part) for rest in arguments('RUN') for part in rest.split('&&')]


def words(text):
    """Return the words of an instruction in exec form."""
    return yaml.safe_load(text)


def rvd_commands():
    """Return the commands that `./rvd help` lists."""
    text = subprocess.run([ROOT / 'rvd', 'help'], capture_output=True, text=True, check=True).stdout
    return re.findall(r'^  ([a-z]+) ', text, flags=re.MULTILINE)


def compose():
    """Return compose.yaml."""
    return yaml.safe_load((DOCKER / 'compose.yaml').read_text())


def test_the_image_is_the_official_one_of_jazzy():
    assert arguments('FROM') == ['ros:jazzy-ros-base']


def test_only_instructions_whose_names_are_checked_here_are_used():
    known = {'FROM', 'RUN', 'WORKDIR', 'COPY', 'ENTRYPOINT', 'CMD'}
    assert {name for name, _ in instructions()} <= known


@pytest.mark.parametrize('sources', arguments('COPY'))
def test_every_copied_path_is_in_the_repository(sources):
    for source in shlex.split(sources)[:-1]:
        assert (ROOT / source).exists(), f'{source} does not exist'
        tracked = subprocess.run(['git', 'ls-files', source], cwd=ROOT, capture_output=True,
                                 text=True, check=True).stdout
        assert tracked, f'{source} is not in the repository'


def test_what_the_set_up_reads_is_copied_before_it_runs():
    before = []
    for name, rest in instructions():
        if name == 'RUN' and './rvd' in rest:
            break
        before += shlex.split(rest)[:-1] if name == 'COPY' else []
    assert {'rvd', 'requirements.lock', 'scripts', 'ros2_ws', 'ros2_extra'} <= set(before)


def test_every_command_that_is_run_is_apt_or_the_set_up():
    allowed = {('apt-get', 'update'), ('apt-get', 'install'), ('./rvd', 'setup')}
    for command in commands():
        if command[:2] != ['rm', '-rf']:
            assert tuple(command[:2]) in allowed, command


def test_apt_installs_what_the_set_up_asks_for():
    installed = {word for command in commands() if command[:2] == ['apt-get', 'install']
                 for word in command[2:]}
    assert {'g++', 'make', 'python3-dev', 'python3-venv'} <= installed


def test_the_container_starts_a_command_that_exists():
    (entry,), (default,) = arguments('ENTRYPOINT'), arguments('CMD')
    assert (ROOT / words(entry)[0]).stat().st_mode & 0o111
    assert words(default)[0] in rvd_commands()


def test_compose_builds_this_dockerfile_and_flies_headless():
    service = compose()['services']['fly']
    context = (DOCKER / service['build']['context']).resolve()
    assert context == ROOT
    assert (context / service['build']['dockerfile']).samefile(DOCKER / 'Dockerfile')
    assert service['command'][0] in rvd_commands()
    assert '--headless' in service['command']


def test_runs_are_written_to_the_mounted_folder():
    (workdir,) = arguments('WORKDIR')
    (volume,) = compose()['services']['fly']['volumes']
    host, inside = volume.split(':')
    assert (DOCKER / host).resolve() == ROOT / 'runs'
    assert inside == f'{workdir}/runs'


def test_the_comments_name_commands_and_files_that_exist():
    text = (DOCKER / 'Dockerfile').read_text() + (DOCKER / 'compose.yaml').read_text()
    for path in re.findall(r'(?:docker|scenarios)/[\w.]+', text):
        assert (ROOT / path).exists(), path
    for service in re.findall(r'run --rm (\w+)', text):
        assert service in compose()['services']


def test_nothing_built_on_the_host_gets_into_the_image():
    ignored = (ROOT / '.dockerignore').read_text().split()
    assert {'.git', '.rvd', 'runs', 'ros2_ws/build', 'ros2_ws/install'} <= set(ignored)
