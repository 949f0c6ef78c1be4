"""
Disks that are full and places that nobody can write to: one line, and the flight is what it was.

A small disk is a tmpfs, for which a test must be root; where nobody, root included, can write is
/sys.
"""

from contextlib import contextmanager
import json
import os
from pathlib import Path
import resource
import subprocess
import sys

import pytest

from runs import environment, rvd
from rvd_campaign import cli
from rvd_campaign.catalogue import root
from rvd_campaign.exits import CannotRun, check_file, check_open_files
from rvd_campaign.flight import room, verdict
from rvd_dynamics.recording.reader import read

SHORT = '/**: {ros__parameters: {timeout_s: 15.0}}\n'
FLY = ('--pace', 'lockstep', '--processes', 'one', '--headless', '--seed', '3')
NOWHERE = Path('/sys')                  # cannot be written to, not even by root


@pytest.fixture
def disk(tmp_path):
    """Return what mounts a disk of so many KiB."""
    made = []

    @contextmanager
    def of(size: int):
        folder = tmp_path / f'disk{size}'
        folder.mkdir()
        done = subprocess.run(['mount', '-t', 'tmpfs', '-o', f'size={size}k', 'none', str(folder)],
                              capture_output=True)
        if done.returncode != 0:
            pytest.skip('no right to mount a small disk')
        made.append(folder)
        yield folder
    yield of
    for folder in made:
        subprocess.run(['umount', '-l', str(folder)], check=True)


def fill(folder: Path) -> None:
    """Leave nothing of a disk."""
    with (folder / 'filling').open('wb', buffering=0) as file:
        try:
            while True:
                file.write(bytes(4096))
        except OSError:
            pass


@pytest.mark.slow
def test_a_flight_on_a_small_disk_is_what_it_was(disk, tmp_path):
    (tmp_path / 'short.yaml').write_text(SHORT)
    whole = rvd('fly', str(tmp_path / 'short.yaml'), *FLY, '--out', str(tmp_path / 'whole'),
                cwd=tmp_path)
    told = json.loads((tmp_path / 'whole' / 'verdict.json').read_text())
    for size in (80, 200):
        with disk(size) as folder:
            done = rvd('fly', str(tmp_path / 'short.yaml'), *FLY, '--out', str(folder / 'run'),
                       cwd=tmp_path)
            assert done.returncode == whole.returncode == 1, done.stderr
            assert 'Traceback' not in done.stderr
            fits = (folder / 'run' / 'report.html').exists()
            assert fits or 'no report: cannot write' in done.stderr
            kept = json.loads((folder / 'run' / 'verdict.json').read_text())
            assert {k: kept[k] for k in ('success', 'reason', 'measures')} == {
                k: told[k] for k in ('success', 'reason', 'measures')}
            assert read(folder / 'run').judged      # the story goes on longest
            assert not (folder / 'run' / room.NAME).exists()


def test_a_disk_with_no_room_at_all_is_refused_before_anything_starts(disk, tmp_path):
    (tmp_path / 'short.yaml').write_text(SHORT)
    with disk(48) as folder:
        done = rvd('fly', str(tmp_path / 'short.yaml'), *FLY, '--out', str(folder / 'run'),
                   cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr.count('\n') == 1 and 'is full: make room' in done.stderr


@pytest.mark.parametrize('kept', [True, False])
def test_the_verdict_has_room_whatever_else_took_the_disk(disk, kept, capsys):
    """And the negative twin: without it the verdict does not fit."""
    with disk(200) as folder:
        if kept:
            room.keep(folder)
        fill(folder)
        verdict.write(folder / 'verdict.json', {'reason': 'docked' * 1000})
        said = capsys.readouterr().err
        if not kept:
            assert said == f'rvd fly: no {folder}/verdict.json: No space left on device\n'
            assert not list(folder.glob('verdict*'))
            return
        assert not said and verdict.read(folder / 'verdict.json')['reason'].startswith('docked')


PLACES = {
    'a run folder': ('fly', '--out', '/sys/run'),
    'a campaign': ('campaign', 'table3', '--runs', '4', '--out', '/sys/campaign'),
    'a pilot file': ('calibrate', '--out', '/sys/pilot.yaml'),
    'figures of the benchmark': ('bench', 'loop', '--quick', '--out', '/sys/bench.json'),
    'the console': ('fly', 'hand', '--operator', 'console', '--port', '0', '--out', '/sys/a/b')}


@pytest.mark.parametrize('place', PLACES)
def test_where_nobody_can_write_is_one_line_at_once(place, tmp_path):
    done = rvd(*PLACES[place], cwd=tmp_path, timeout=60)
    assert done.returncode == 2
    assert done.stderr.count('\n') == 1 and '/sys' in done.stderr, done.stderr


def test_no_home_and_no_cache_say_nothing():
    code = 'from rvd_dynamics.recording.drawing import load; load()'
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, env={
        **os.environ, 'HOME': '/sys', 'XDG_CACHE_HOME': '/sys', 'XDG_CONFIG_HOME': '/sys'})
    assert (done.returncode, done.stderr) == (0, '')


def test_a_file_is_tried_before_the_work_for_it(tmp_path):
    check_file('--out', str(tmp_path / 'new'))
    assert not list(tmp_path.iterdir())
    with pytest.raises(CannotRun, match='/sys is no folder that can be written to'):
        check_file('--out', '/sys/new')


@pytest.mark.parametrize('error, code, said', [
    (OSError(28, 'No space left', 'x\x1b'), 2, 'rvd list: x\\x1b: No space left\n'),
    (OSError(24, 'Too many open files'), 2, 'rvd list: Too many open files\n'),
    (OSError(5, 'Input/output error'), 3, 'fault of this software')])
def test_what_the_disk_says_is_no_fault_of_ours(error, code, said, monkeypatch, capsys):
    def fails(args):
        raise error
    monkeypatch.setattr(cli, '_list', fails)
    assert cli.main(['list', 'laws']) == code
    stderr = capsys.readouterr().err
    assert stderr == said if code == 2 else said in stderr and 'Traceback' in stderr


def test_too_few_open_files_are_raised_or_refused(monkeypatch):
    limits = {'now': (16, 4096)}
    monkeypatch.setattr(resource, 'getrlimit', lambda what: limits['now'])
    monkeypatch.setattr(resource, 'setrlimit', lambda what, now: limits.update(now=now))
    check_open_files()
    assert limits['now'] == (256, 4096)
    limits['now'] = (16, 64)
    with pytest.raises(CannotRun, match='only 64 files may be open at once, 256 are needed'):
        check_open_files()


READ_ONLY = 'mount --bind {0} {0} && mount -o remount,bind,ro {0} && '


@pytest.mark.parametrize('places, command, line', [
    (['PROJECT'], 'setup', 'rvd: cannot write to PROJECT/.rvd'),
    ([], 'setup', ''),
    (['/tmp', '/var/tmp'], 'fly paper --headless',
     'rvd fly: no folder for temporary files can be written: set TMPDIR to one that can'),
    (['/var/tmp'], 'fly paper --headless',
     'rvd fly: cannot make the run folder runs')])
def test_what_nobody_can_write_to_is_one_line(places, command, line):
    """The set-up, and all folders for temporary files; with fewer of them it comes further."""
    project = str(root())
    mounts = ''.join(READ_ONLY.format(place.replace('PROJECT', project)) for place in places)
    done = subprocess.run(
        ['unshare', '--mount', '--propagation', 'private', 'sh', '-c',
         f'{mounts} cd {NOWHERE} && echo ready && exec {project}/rvd {command}'],
        env={name: value for name, value in environment().items()
             if name not in ('TMPDIR', 'TEMP', 'TMP')}, capture_output=True, text=True,
             timeout=60.0)
    if 'ready' not in done.stdout:
        pytest.skip('no right to mount')
    said = done.stderr.splitlines()
    assert len(said) <= 1 and ''.join(said).startswith(line.replace('PROJECT', project)), said
    assert done.returncode == (2 if line else 0)
