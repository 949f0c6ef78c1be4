"""The user's settings of matplotlib change no figure, and a report that fails takes no flight."""

import os
from pathlib import Path
import subprocess
import sys

import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_campaign.report.attempt import attempt

DRAW = """
from pathlib import Path
import sys
{before}
from rvd_dynamics.recording.drawing import canvas, png, svg
def draw():
    figure = canvas(2.0)
    figure.subplots().set(title='Range [m]', xlabel='t')
    return figure
sys.stdout.write(svg('x', draw))
png(Path(sys.argv[1]) / 'x.png', draw)
"""
RC = {'latex': b'text.usetex: True\nsvg.fonttype: path\nlines.linewidth: 9\n',
      'nonsense': b'nonsense\nlines.linewidth: thick\nbackend: nonsense\n', 'binary': b'\xff\xfe\0'}


def drawn(folder, before='', **environment):
    env = {k: v for k, v in os.environ.items() if not k.startswith('MPL') and k != 'MATPLOTLIBRC'}
    done = subprocess.run([sys.executable, '-c', DRAW.format(before=before), str(folder)],
                          cwd=folder, env={**env, **environment}, capture_output=True)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout, (folder / 'x.png').read_bytes(), done.stderr


@pytest.fixture(scope='module')
def plain(tmp_path_factory):
    return drawn(tmp_path_factory.mktemp('plain'))


@pytest.mark.parametrize('backend', ['module://matplotlib_inline.backend_inline', 'nonsense'])
def test_backend_of_a_notebook_changes_nothing(backend, tmp_path, plain):
    assert drawn(tmp_path, MPLBACKEND=backend) == plain


@pytest.mark.parametrize('content', RC.values(), ids=RC.keys())
@pytest.mark.parametrize('place', ['here', 'named', 'config'])
def test_settings_files_change_nothing(content, place, tmp_path, plain):
    config = tmp_path / 'config'
    config.mkdir()
    file = {'here': tmp_path, 'named': tmp_path / 'x', 'config': config}[place] / 'matplotlibrc'
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(content)
    environment = {'named': {'MATPLOTLIBRC': str(file)}, 'here': {},
                   'config': {'MPLCONFIGDIR': str(config)}}[place]
    *figures, said = drawn(tmp_path, **environment)
    assert figures == list(plain[:2])
    assert b'matplotlibrc' not in said


def test_settings_of_who_imported_matplotlib_before_change_nothing(tmp_path, plain):
    before = ('import matplotlib\n'
              'matplotlib.rc("text", usetex=True); matplotlib.rc("savefig", bbox="tight")')
    assert drawn(tmp_path, before) == plain


def test_own_settings_leave_environment_and_lookups_as_they_were(tmp_path):
    code = ('import os; from rvd_dynamics.recording.drawing import load; e, x = dict(os.environ), '
            'os.path.exists; load(); assert dict(os.environ) == e and os.path.exists is x')
    subprocess.run([sys.executable, '-c', code], check=True,
                   env={**os.environ, 'MPLBACKEND': 'nonsense'})


def failing(error):
    def write(folder):
        raise error
    return write


def test_report_that_cannot_be_made_says_how_to_make_it_again(tmp_path, capsys):
    run, log = tmp_path / 'a run', tmp_path / 'report.log'
    attempt(failing(BadInput('cannot write x')), run, log)
    assert capsys.readouterr().err.splitlines() == [
        'rvd: no report: cannot write x', f"rvd: make it again with ./rvd report '{run}'"]
    assert not log.exists()


def test_traceback_of_a_programming_error_is_kept(tmp_path, capsys):
    log = tmp_path / 'report.log'
    attempt(failing(KeyError('x')), tmp_path, log)
    assert f"KeyError: 'x' (traceback in {log})" in capsys.readouterr().err
    assert 'Traceback' in log.read_text() and 'in write' in log.read_text()
    attempt(failing(KeyError('x')), tmp_path, tmp_path / 'no' / 'folder')
    assert 'Traceback' in capsys.readouterr().err


def test_report_that_is_made_is_named(tmp_path, capsys):
    attempt(lambda folder: folder / 'report.html', tmp_path, tmp_path / 'log')
    assert capsys.readouterr() == (f'{Path(tmp_path) / "report.html"}\n', '')
