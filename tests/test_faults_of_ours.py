"""A fault of the software is not told as bad input, and a process that cannot end is ended."""

import signal
import subprocess
import sys
import time

import pytest
from runs import environment

from rvd_campaign import catalogue, cli
from rvd_dynamics.bad_input import BadInput

NODE = """
import sys
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.ros import main
def parsed(argv):
    raise {error}('two shapes do not fit')
main.parsed = parsed
main.main()
"""


@pytest.mark.parametrize('error, code', [(ValueError, 3), (KeyError, 3), (BadInput, 2)])
def test_a_command_tells_bad_input_from_its_own_fault(error, code, monkeypatch, capsys):
    def entries(what):
        raise error('two shapes do not fit')
    monkeypatch.setattr(catalogue, 'entries', entries)
    assert cli.main(['list', 'laws']) == code
    said = capsys.readouterr().err
    assert ('Traceback' in said) == (code == 3)
    assert 'two shapes do not fit' in said


def test_numpy_is_never_bad_input(monkeypatch, capsys):
    def entries(what):
        import numpy
        return numpy.zeros(3) + numpy.zeros(4)
    monkeypatch.setattr(catalogue, 'entries', entries)
    assert cli.main(['list', 'laws']) == 3
    assert 'could not be broadcast' in capsys.readouterr().err


def test_what_a_library_says_when_ctrl_c_cuts_it_short_is_no_fault(monkeypatch, capsys):
    def entries(what):
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:               # as numpy does while it is imported
            raise ImportError('the C extensions failed') from None
    monkeypatch.setattr(catalogue, 'entries', entries)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        assert cli.main(['list', 'laws']) == 130
    finally:
        signal.signal(signal.SIGINT, before)
    assert capsys.readouterr() == ('', '')


def test_a_ctrl_c_that_came_while_python_started_is_heard():
    told = python('import os, signal, sys\nfrom rvd_campaign import cli\n'
                  'signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})\n'
                  'signal.signal(signal.SIGINT, signal.default_int_handler)\n'
                  'os.kill(os.getpid(), signal.SIGINT)\n'
                  'sys.exit(cli.main(["list", "laws"]))')[0]
    assert (told.returncode, told.stdout, told.stderr) == (130, '', '')


@pytest.mark.parametrize('error, code', [('ValueError', 1), ('BadInput', 2)])
def test_a_node_tells_them_apart_too(error, code):
    done = subprocess.run([sys.executable, '-c', NODE.format(error=error)], capture_output=True,
                          text=True, env=environment())
    assert done.returncode == code
    assert ('Traceback' in done.stderr) == (code == 1)


def python(text: str, **more: str) -> tuple[subprocess.CompletedProcess, float]:
    begun = time.monotonic()
    done = subprocess.run([sys.executable, '-c', text], capture_output=True, text=True,
                          env={**environment(), **more}, timeout=60.0)
    return done, time.monotonic() - begun


STUCK = """
import ctypes
from rvd_dynamics.lifeline import leaving
try:
    {before}
finally:
    with leaving(0.3):
        ctypes.PyDLL(None).sleep(50)
"""


@pytest.mark.parametrize('before, code', [('pass', 0), ('raise SystemExit(2)', 2),
                                          ('raise SystemExit("told in words")', 1), ('1 / 0', 1)])
def test_a_process_stuck_outside_python_is_ended_with_its_code_and_says_where(before, code):
    done, took_s = python(STUCK.format(before=before))
    assert done.returncode == code and took_s < 20.0
    assert 'Timeout' in done.stderr and 'line 8' in done.stderr


def test_one_that_leaves_in_time_is_let_be():
    done, _ = python('import time\nfrom rvd_dynamics.lifeline import leaving\n'
                     'with leaving(0.3):\n    pass\ntime.sleep(1.5)\n')
    assert done.returncode == 0 and not done.stderr


def test_a_node_whose_parent_has_gone_does_not_start():
    done, _ = python('from rvd_dynamics.lifeline import hold\nhold()\nprint("flies")\n',
                     RVD_PARENT='4194303')
    assert done.returncode == 1 and 'flies' not in done.stdout
    assert 'process 4194303, which started this one, has gone' in done.stderr
